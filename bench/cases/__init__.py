"""The inputs of every comparison. Nothing here knows a rival or a clock."""
