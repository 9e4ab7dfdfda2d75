"""The libraries and methods that are compared, libration among them. Nothing here measures or prints."""
