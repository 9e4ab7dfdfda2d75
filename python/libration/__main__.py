"""`python -m libration` is the command `libration`."""

import sys

from libration.cli import main

if __name__ == "__main__":
    sys.exit(main())
