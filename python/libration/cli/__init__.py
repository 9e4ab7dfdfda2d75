# argparse: in the standard library, maintained, and fast to start; its errors are re-worded in parser.py.
"""The command `libration`: the exact motion and period of a pendulum, from the shell.

One function, `main`. Every refusal is one line on the standard error and exit code 2; nothing is left half
written. NumPy and matplotlib are loaded by the commands that need them, so that `--help` is quick.
"""

import contextlib
import os
import sys

from libration.cli.parser import Refusal, top_parser

COMMANDS = ("solve", "period")


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : list of str, optional
        The words after `libration`; by default those of the shell.

    Returns
    -------
    int
        The exit code: 0 done, 2 refused (one line on the standard error says why), 130 interrupted,
        141 when the reader of the standard output has gone.

    Examples
    --------
    >>> from libration.cli import main
    >>> main(["period", "--theta0", "150deg"])  # doctest: +ELLIPSIS
    regime ...
    0
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    prog = "libration"
    try:
        # argparse leaves after --help by SystemExit.
        with contextlib.suppress(SystemExit):
            if words and words[0] in COMMANDS:
                prog = f"libration {words[0]}"
                command(words[0])(words[1:])
            else:
                top_parser(COMMANDS).refuse_or_print(words)
        sys.stdout.flush()
        return 0
    except Refusal as refusal:
        return refused(prog, str(refusal))
    except KeyboardInterrupt:
        return 130
    except MemoryError:
        return refused(prog, "not enough memory; ask for fewer samples")
    except BrokenPipeError:
        drop_stdout()
        return 141
    except OSError as error:
        drop_stdout()
        return refused(prog, f"standard output: {error.strerror or error}")


def command(name):
    """The function that runs one command, loaded only now."""
    if name == "solve":
        from libration.cli.solve import run
    else:
        from libration.cli.period import run
    return run


def refused(prog, reason):
    """One line on the standard error, and the exit code."""
    print(f"{prog}: {' '.join(reason.split())}", file=sys.stderr)
    return 2


def drop_stdout():
    """Let the interpreter's last flush go nowhere: the reader is gone, or the disk is full."""
    try:
        with open(os.devnull, "w") as nowhere:
            os.dup2(nowhere.fileno(), sys.stdout.fileno())
    except (OSError, ValueError, AttributeError):
        pass
