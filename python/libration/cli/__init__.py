"""The command `libration`: pendulums, Duffing oscillators and the papers about them, from the shell.

One function, `main`. Every refusal is one line on the standard error and exit code 2; no file is left
unfinished. NumPy, matplotlib and SciPy are loaded by the commands that need them, so that `--help` is quick.
"""

import os
import sys

import click

from libration.cli.completion import VARIABLE, offer
from libration.cli.language import spoken
from libration.cli.parser import Finding, Refusal
from libration.cli.streams import Ended, drop, ending, printable, refused
from libration.cli.top import COMMANDS, TOP


def main(arguments: list[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : list of str, optional
        The words after `libration`; by default those of the command line.

    Returns
    -------
    int
        The exit code: 0 done, 1 a check failed, 2 refused (one line on the standard error says why), 129 ended by a
        hang-up, 130 interrupted, 141 when the reader of the standard output is gone, 143 terminated.

    Examples
    --------
    >>> from libration.cli import main
    >>> main(["period", "--theta0", "150deg"])  # doctest: +ELLIPSIS
    regime ...
    0
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    with printable(), spoken(words):
        return answered(words)


def answered(words: list[str]) -> int:
    """The exit code for the words of a command line."""
    prog = f"libration {words[0]}" if words and words[0] in COMMANDS else "libration"
    try:
        if sys.stdout is None:
            raise Refusal("standard output: is closed, so there is nowhere to print")
        with ending():
            run(words)
        sys.stdout.flush()
        return 0
    except Refusal as refusal:
        return refused(prog, refusal.args[0])
    except Finding as finding:
        return refused(prog, finding.args[0], 1)
    except KeyboardInterrupt:
        return 130
    except Ended as ended:
        return ended.code
    except MemoryError:
        return refused(prog, "not enough memory; ask for fewer samples")
    except BrokenPipeError:
        drop(sys.stdout)
        return 141
    except OSError as error:
        drop(sys.stdout)
        return refused(prog, f"standard output: {error.strerror or error}")


def run(words: list[str]) -> None:
    """Run one command, or say to a shell what may follow. Not by `main` of click, which prints a blank line at Ctrl-C and exits."""
    if asked := os.environ.get(VARIABLE):
        return offer(TOP, asked)
    try:
        with TOP.make_context("libration", words) as context:
            TOP.invoke(context)
    except click.exceptions.Exit:
        # After --help and --version.
        return
