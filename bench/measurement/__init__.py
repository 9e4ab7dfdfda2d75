"""How time and error are measured, and what is measured: results as plain records. Nothing here writes a page."""
