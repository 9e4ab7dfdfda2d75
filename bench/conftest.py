"""Puts bench/ on the path of its tests: pytest adds the folder of a conftest.py, as Python adds that of a script."""
