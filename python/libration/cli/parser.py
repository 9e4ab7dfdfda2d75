"""argparse with one-line errors: what is wrong, with which option, and the nearest known option.

Options are not abbreviated and may be given once; a negative quantity (`--theta0 -170deg`) is a value, not an
option. Required options are checked by the commands, after unknown ones, so that `--theta 3` is answered with
"did you mean --theta0", not with "missing --theta0".
"""

import argparse
import difflib
import re
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, NoReturn, TypeVar

from libration.cli.wrapping import Formatter

if TYPE_CHECKING:
    from _typeshed import SupportsWrite

# The options of one command, as its parser sets them.
Options = TypeVar("Options", bound=argparse.Namespace)

NEGATIVE = re.compile(r"-(\.?[0-9]|inf|nan)", re.IGNORECASE)


class Refusal(Exception):
    """Bad input: the text is the one line that the user reads."""


class Finding(Exception):
    """A check that failed: the text is the one line that the user reads."""


def refusal(option: str, value: object, reason: str) -> Refusal:
    """A Refusal that names the option, its value and what is allowed."""
    return Refusal(f"{option} = {shown(value)}: {reason}")


def shown(value: object) -> str:
    """The value as typed, made printable and short."""
    text = str(value)
    if not text.isprintable():
        text = repr(text)[1:-1]
    if not text.strip():
        return repr(text)
    return text if len(text) <= 80 else f"{text[:60]}... ({len(text)} characters)"


def quoted(value: object) -> str:
    """The value as `shown`, in quotes."""
    text = shown(value)
    return f"'{text}'" if str(value).strip() else text


class Once(argparse.Action):
    """Store a value; a second one for the same option is refused."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[object] | None,
        option_string: str | None = None,
    ) -> None:
        first = getattr(namespace, self.dest)
        if first is not None:
            raise Refusal(f"{option_string} = {shown(first)} and {option_string} = {shown(values)}: give it once")
        setattr(namespace, self.dest, values)


class Parser(argparse.ArgumentParser):
    """An ArgumentParser whose errors are Refusals."""

    def __init__(self, prog: str, description: str, epilog: str) -> None:
        super().__init__(
            prog=prog,
            description=description,
            epilog=epilog,
            allow_abbrev=False,
            formatter_class=Formatter,
        )

    def value(self, group: "argparse._ArgumentGroup", option: str, metavar: str, text: str) -> None:
        """Add an option that takes one value, stored as the text typed."""
        group.add_argument(option, action=Once, metavar=metavar, help=text)

    def error(self, message: str) -> NoReturn:
        """The message of argparse as a Refusal."""
        found = re.match(r"argument (\S+): (.*)", message, re.DOTALL)
        if found and "expected one argument" in found[2]:
            raise Refusal(f"{found[1]}: needs a value, {self.metavar(found[1])}; see {self.prog} --help")
        if found and "ignored explicit argument" in found[2]:
            raise Refusal(f"{found[1]}: takes no value")
        raise Refusal(message)

    def metavar(self, option: str) -> str:
        """What an option takes, for an error."""
        names = [a.metavar for a in self._actions if option in a.option_strings]
        return f"{option} {names[0]}" if names else option

    def print_help(self, file: "SupportsWrite[str] | None" = None) -> None:
        """Print the help; unlike that of argparse, raise the errors of writing."""
        (file or sys.stdout).write(self.format_help())

    def options(self, words: Sequence[str], options: Options) -> Options:
        """Set the options that the words of one command give, or refuse the first unknown word."""
        options, unknown = self.parse_known_args(joined(words), options)
        if unknown:
            raise Refusal(self.unknown(unknown[0]))
        return options

    def unknown(self, word: str) -> str:
        """The refusal of an unknown word, with the nearest option."""
        name = word.split("=", 1)[0]
        known = [option for action in self._actions for option in action.option_strings]
        near = difflib.get_close_matches(name, known, n=1, cutoff=0.6)
        hint = f"; did you mean {near[0]}?" if near else f"; see {self.prog} --help"
        kind = "option" if word.startswith("-") else "word"
        return f"unknown {kind} {quoted(name)}{hint}"


def joined(words: Sequence[str]) -> list[str]:
    """`--theta0 -170deg` as `--theta0=-170deg`: argparse reads a minus as the start of an option."""
    out: list[str] = []
    for word in words:
        if out and out[-1].startswith("--") and len(out[-1]) > 2 and "=" not in out[-1] and NEGATIVE.match(word):
            out[-1] += f"={word}"
        else:
            out.append(word)
    return out


TOP_DESCRIPTION = """\
The exact motion of a pendulum, theta'' + omega0^2 sin(theta) = 0, from any start and in
every regime: swinging, turning over the top, at rest, or on the separatrix between them."""

TOP_EPILOG = """\
commands:
  solve       angle and velocity at many instants, as a table and as a plot
  period      the period, and how much longer it is than that of small swings
  compare     approximations and numerical solutions beside the exact motion
  duffing     the nonlinear spring u'' + p u + q u^3 = 0, as solve
  papers      every figure of three papers about the pendulum, and a check of their numbers

examples:
  libration period --theta0 150deg
  libration solve --theta0 170deg --length 1m --out motion.csv --plot motion.png

`libration COMMAND --help` lists its options."""


class TopOptions(argparse.Namespace):
    """The options of `libration` itself."""

    version: bool


class TopParser(Parser):
    """`libration` without a command: help, version, or a refusal."""

    def __init__(self, commands: Sequence[str]) -> None:
        super().__init__("libration", TOP_DESCRIPTION, TOP_EPILOG)
        self.usage = "libration COMMAND [options]"
        self.commands = commands
        self.add_argument("--version", action="store_true", help="show the version and exit")

    def refuse_or_print(self, words: Sequence[str]) -> None:
        """Print what was asked for, or refuse."""
        from libration import __version__

        every = ", ".join(self.commands)
        if not words:
            raise Refusal(f"missing command: one of {every}; see libration --help")
        if not words[0].startswith("-"):
            near = difflib.get_close_matches(words[0], self.commands, n=1)
            hint = f"; did you mean {near[0]}?" if near else "; see libration --help"
            raise Refusal(f"unknown command {quoted(words[0])}: commands are {every}{hint}")
        if self.options(words, TopOptions()).version:
            print(f"libration {__version__}")


def top_parser(commands: Sequence[str]) -> TopParser:
    """The parser of `libration` itself."""
    return TopParser(commands)
