"""argparse with one-line errors: what is wrong, with which option, and the nearest option there is.

Options are recognised in full only and may stand once; a negative quantity (`--theta0 -170deg`) is a value,
not an option. Required options are checked by the commands, after unknown ones, so that `--theta 3` is
answered with "did you mean --theta0", not with "missing --theta0".
"""

import argparse
import difflib
import re
import sys

from libration.cli.wrapping import Formatter

NEGATIVE = re.compile(r"-(\.?[0-9]|inf|nan)", re.IGNORECASE)


class Refusal(Exception):
    """Bad input: the text is the one line that the user reads."""


class Finding(Exception):
    """A check that does not hold: the text is the one line that the user reads."""


def refusal(option, value, reason):
    """A Refusal that names the option, its value and what is allowed."""
    return Refusal(f"{option} = {shown(value)}: {reason}")


def shown(value):
    """The value as typed, kept printable and short."""
    text = str(value)
    if not text.isprintable():
        text = repr(text)[1:-1]
    if not text.strip():
        return repr(text)
    return text if len(text) <= 80 else f"{text[:60]}... ({len(text)} characters)"


def quoted(value):
    """The value as `shown`, in quotes."""
    text = shown(value)
    return f"'{text}'" if str(value).strip() else text


class Once(argparse.Action):
    """Store a value; a second one for the same option is refused, not silently taken."""

    def __call__(self, parser, namespace, value, option_string=None):
        first = getattr(namespace, self.dest)
        if first is not None:
            raise Refusal(f"{option_string} = {shown(first)} and {option_string} = {shown(value)}: give it once")
        setattr(namespace, self.dest, value)


class Parser(argparse.ArgumentParser):
    """An ArgumentParser whose errors are Refusals."""

    def __init__(self, prog, description, epilog):
        super().__init__(
            prog=prog,
            description=description,
            epilog=epilog,
            allow_abbrev=False,
            formatter_class=Formatter,
        )

    def value(self, group, option, metavar, text):
        """Add an option that takes one value, kept as the text typed."""
        (group or self).add_argument(option, action=Once, metavar=metavar, help=text)

    def error(self, message):
        """Re-word what argparse says."""
        found = re.match(r"argument (\S+): (.*)", message, re.DOTALL)
        if found and "expected one argument" in found[2]:
            raise Refusal(f"{found[1]}: needs a value, {self.metavar(found[1])}; see {self.prog} --help")
        if found and "ignored explicit argument" in found[2]:
            raise Refusal(f"{found[1]}: takes no value")
        raise Refusal(message)

    def metavar(self, option):
        """What an option takes, for an error."""
        names = [a.metavar for a in self._actions if option in a.option_strings]
        return f"{option} {names[0]}" if names else option

    def print_help(self, file=None):
        """Print the help; a full disk or a reader who left is not passed over."""
        (file or sys.stdout).write(self.format_help())

    def options(self, words):
        """Parse the words of one command, or refuse the first that it does not know."""
        options, unknown = self.parse_known_args(joined(words))
        if unknown:
            raise Refusal(self.unknown(unknown[0]))
        return options

    def unknown(self, word):
        """What to say of a word that is not ours."""
        name = word.split("=", 1)[0]
        known = [option for action in self._actions for option in action.option_strings]
        near = difflib.get_close_matches(name, known, n=1, cutoff=0.6)
        hint = f"; did you mean {near[0]}?" if near else f"; see {self.prog} --help"
        kind = "option" if word.startswith("-") else "word"
        return f"unknown {kind} {quoted(name)}{hint}"


def joined(words):
    """`--theta0 -170deg` as `--theta0=-170deg`: argparse takes a minus for the start of an option."""
    out = []
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
  papers      every figure of three papers about the pendulum, and what became of their numbers

examples:
  libration period --theta0 150deg
  libration solve --theta0 170deg --length 1m --out motion.csv --plot motion.png

`libration COMMAND --help` tells the rest."""


class TopParser(Parser):
    """`libration` without a command: help, version, or a refusal."""

    def __init__(self, commands):
        super().__init__("libration", TOP_DESCRIPTION, TOP_EPILOG)
        self.usage = "libration COMMAND [options]"
        self.commands = commands
        self.add_argument("--version", action="store_true", help="show the version and exit")

    def refuse_or_print(self, words):
        """Print what was asked for, or refuse."""
        from libration import __version__

        every = ", ".join(self.commands)
        if not words:
            raise Refusal(f"missing command: one of {every}; see libration --help")
        if not words[0].startswith("-"):
            near = difflib.get_close_matches(words[0], self.commands, n=1)
            hint = f"; did you mean {near[0]}?" if near else "; see libration --help"
            raise Refusal(f"unknown command {quoted(words[0])}: commands are {every}{hint}")
        if self.options(words).version:
            print(f"libration {__version__}")


def top_parser(commands):
    """The parser of `libration` itself."""
    return TopParser(commands)
