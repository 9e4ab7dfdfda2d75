"""`python -m libration` is the command `libration`."""

import sys


def run() -> int:
    """Run the command line; Ctrl-C ends it in silence while it is still being loaded, too."""
    try:
        from libration.cli import main
    except KeyboardInterrupt:
        return 130
    return main()


if __name__ == "__main__":
    sys.exit(run())
