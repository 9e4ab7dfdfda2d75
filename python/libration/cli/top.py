"""`libration` itself: its commands, and its own two options."""

import click

from libration.cli import (
    at,
    cite,
    compare,
    completion,
    cubic_quintic,
    duffing,
    ensemble,
    fit,
    gravity,
    lab,
    papers,
    period,
    solve,
)
from libration.cli.help import Topic
from libration.cli.language import asked
from libration.cli.parser import Command, Refusal, nearest, quoted, unknown

MODULES = (solve, at, period, compare, duffing, cubic_quintic, fit, gravity, ensemble, papers, lab, cite, completion)
COMMANDS: dict[str, click.Command] = {str(each.COMMAND.name): each.COMMAND for each in MODULES}

TEXT = """\
The exact motion of a pendulum, theta'' + omega0^2 sin(theta) = 0, from any start and in every regime: swinging, turning
over the top, at rest, or on the separatrix between them. With friction and torque too."""

EXAMPLES = (
    "libration period --theta0 150deg",
    "libration solve --theta0 170deg --length 1m --out motion.csv --plot motion.png",
)


class Commands(Command, click.Group):
    """The commands by name; a word that is none is refused with the nearest."""

    def __init__(self) -> None:
        topics = [
            Topic(
                "commands",
                tuple((name, str(each.short_help)) for name, each in COMMANDS.items()),
                "`libration COMMAND --help` lists its options.",
            )
        ]
        text = "show the version and exit"
        version = click.Option(
            ["--version"], is_flag=True, is_eager=True, expose_value=False, callback=print_version, help=text
        )
        usage = ["libration", "COMMAND", "[options]"]
        super().__init__("libration", TEXT, usage=usage, parameters=[version], topics=topics, examples=EXAMPLES)
        self.commands = COMMANDS

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Split the words into those before the command, the command and its words."""
        other = [word for word in args if not word.startswith("--lang") and word != asked(args)]
        if not other and not ctx.resilient_parsing:
            raise Refusal(f"missing command: one of {', '.join(COMMANDS)}; see libration --help")
        return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command that a word names, or a Refusal."""
        word = args[0]
        found = self.commands.get(word)
        if found is None and not ctx.resilient_parsing:
            if word.startswith("-"):
                raise Refusal(self.misplaced(ctx, word))
            asked = word.lower() in ("help", "version")
            hint = f"did you mean --{word.lower()}?" if asked else nearest(word, COMMANDS, "see libration --help")
            raise Refusal(f"unknown command {quoted(word)}: commands are {', '.join(COMMANDS)}; {hint}")
        return word if found else None, found, args[1:]

    def misplaced(self, ctx: click.Context, word: str) -> str:
        """The refusal of an option that stands before the command, or is none."""
        name = word.split("=", 1)[0]
        having = [each for each, made in self.commands.items() if any(name in option.opts for option in made.params)]
        if not having:
            return unknown(ctx, word)
        return f"option {quoted(name)} stands after a command, one of {', '.join(having)}; see libration --help"


def print_version(ctx: click.Context, _parameter: click.Parameter, wanted: bool) -> None:
    """Print the version, if it is asked for, and end."""
    if wanted and not ctx.resilient_parsing:
        from libration import __version__

        print(f"libration {__version__}")
        ctx.exit()


TOP = Commands()
