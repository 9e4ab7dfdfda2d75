"""From the records of bench/results/ to the pages and pictures of docs/. Nothing here measures."""
