"""click with one-line errors: what is wrong, with which option, and the nearest known option.

Options are not abbreviated and may be given once; a negative quantity (`--theta0 -170deg`) is a value, not an
option. Required options are checked by the commands, after unknown ones, so that `--theta 3` is answered with
"did you mean --theta0", not with "missing --theta0".
"""

import difflib
import os
import re
from collections.abc import Callable, Iterable, Sequence
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

import click

from libration._languages import LANGUAGES, known_language
from libration.cli.help import Context, Example, Formatter, Topic, together
from libration.cli.language import Told, told

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

# What begins with a minus sign and is no option.
NEGATIVE = re.compile(r"-(\.?[0-9]|inf|nan)", re.IGNORECASE)
# Unknown words are collected, and the first is refused with what may have been meant.
SETTINGS = {"ignore_unknown_options": True, "allow_extra_args": True, "help_option_names": ["--help"]}
# Other names of options, beside those of the arguments in Python.
ALSO = {
    "t": ("until",),
    "time": ("until",),
    "o": ("out",),
    "output": ("out",),
    "csv": ("out",),
    "file": ("out", "times"),
    "language": ("lang",),
    "n": ("samples",),
    "steps": ("samples",),
    "precision": ("digits",),
    "formula": ("only", "with"),
    "formulas": ("only", "with"),
    "methods": ("with",),
    "x0": ("u0",),
    "png": ("plot",),
    "gamma": ("linear",),
    "damping": ("linear",),
    "friction": ("linear",),
    "beta": ("quadratic",),
    "drag": ("quadratic",),
    "mu": ("dry",),
    "coulomb": ("dry",),
    "delta": ("presliding",),
    "tau": ("torque",),
    "drive": ("torque-amplitude",),
}
# No word of so few letters is anything else.
LONGEST_UNIT = 4
# The values that a shell offers for the beginning of one.
Offered: TypeAlias = "Callable[[click.Context, click.Parameter, str], list[CompletionItem[str]] | list[str]]"


class Refusal(Exception):
    """Bad input: the text is the one line that the user reads."""


class Finding(Exception):
    """A check that failed: the text is the one line that the user reads."""


def refusal(option: str, value: object, reason: str) -> Refusal:
    """A Refusal that names the option, its value and what is allowed."""
    return Refusal(Told(f"{option} = {shown(value)}: {told(reason)}"))


def shown(value: object) -> str:
    """The value as typed, made printable and short."""
    text = str(value)
    if not text.isprintable():
        text = repr(text)[1:-1]
    if not text.strip():
        return repr(text)
    return text if len(text) <= 80 else f"{text[:60]}... {told(f'({len(text)} characters)')}"


def quoted(value: object) -> str:
    """The value as `shown`, in quotes."""
    text = shown(value)
    return f"'{text}'" if str(value).strip() else text


def nearest(word: str, known: Iterable[str], otherwise: str) -> str:
    """The nearest known word as a question, or what to do if none is near."""
    small = {each.lower(): each for each in known}
    near = difflib.get_close_matches(word.lower(), list(small), n=1, cutoff=0.6)
    return f"did you mean {small[near[0]]}?" if near else otherwise


class Options(SimpleNamespace):
    """The options of a command, as typed; a subclass says which."""


Made = TypeVar("Made", bound=Options)


class Value(click.Option):
    """An option that takes one value, kept as the text typed; a second one is refused."""

    def __init__(
        self,
        option: str,
        metavar: str,
        text: str,
        group: str,
        *,
        name: str = "",
        offered: "Offered | None" = None,
        hidden: bool = False,
    ) -> None:
        names = [option, name] if name else [option]
        # `multiple` keeps every value, so that `once` sees a second one.
        super().__init__(
            names,
            metavar=metavar,
            help=text,
            multiple=True,
            type=click.UNPROCESSED,
            callback=self.once,
            shell_complete=offered,
            hidden=hidden,
        )
        self.group = group

    def once(self, ctx: click.Context, _parameter: click.Parameter, values: tuple[str, ...]) -> str | None:
        """The value, None without one, or a Refusal of two; the name of an option is no value."""
        option = self.opts[0]
        if any(value.startswith("--") for value in values):
            raise Refusal(needs_value(ctx.command_path, self))
        if len(values) > 1:
            raise Refusal(f"{option} = {shown(values[0])} and {option} = {shown(values[1])}: give it once")
        return values[0] if values else None


class Values(Value):
    """An option that may be given several times; every value is kept as typed."""

    def once(self, ctx: click.Context, _parameter: click.Parameter, values: tuple[str, ...]) -> Any:
        """The values; the name of an option is no value."""
        if any(value.startswith("--") for value in values):
            raise Refusal(needs_value(ctx.command_path, self))
        return values


class Spoken(Value):
    """The option of the language; it is read before all others, so that what they say is in it."""

    def __init__(self, group: str) -> None:
        text = "en, pt-BR or es: language and decimal sign of what is printed and drawn (default that of the system)"
        super().__init__("--lang", "LANGUAGE", text, group, offered=languages)

    def once(self, ctx: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> str | None:
        """The language, or a Refusal of one that is not known."""
        value = super().once(ctx, parameter, values)
        if value is not None and known_language(value) is None:
            raise refusal("--lang", value, f"must be {', '.join(LANGUAGES[:-1])} or {LANGUAGES[-1]}")
        return value


def languages(_ctx: click.Context, _parameter: click.Parameter, typed: str) -> list[str]:
    """The languages that begin as typed."""
    return [each for each in LANGUAGES if each.lower().startswith(typed.lower())]


class Flag(click.Option):
    """An option without a value."""

    def __init__(self, option: str, text: str, group: str) -> None:
        super().__init__([option], is_flag=True, help=text)
        self.group = group


class Word(click.Argument):
    """A word that is no option, kept as typed; negative quantities are such words."""

    def __init__(self, name: str, metavar: str, text: str, group: str, *, offered: "Offered | None" = None) -> None:
        super().__init__(
            [name], metavar=metavar, required=False, type=click.UNPROCESSED, callback=self.known, shell_complete=offered
        )
        self.row, self.group = (metavar, text), group

    def known(self, ctx: click.Context, _parameter: click.Parameter, value: str | None) -> str | None:
        """The word, or a Refusal of what begins like an option."""
        if value is not None and value.startswith("-") and not NEGATIVE.match(value):
            raise Refusal(unknown(ctx, value))
        return value


class Words(click.Argument):
    """Any number of words that are no options, kept as typed."""

    def __init__(self, name: str, metavar: str, text: str, group: str, *, offered: "Offered | None" = None) -> None:
        super().__init__(
            [name],
            metavar=metavar,
            required=False,
            nargs=-1,
            type=click.UNPROCESSED,
            callback=self.known,
            shell_complete=offered,
        )
        self.row, self.group = (metavar, text), group

    def known(self, ctx: click.Context, _parameter: click.Parameter, values: tuple[str, ...]) -> tuple[str, ...]:
        """The words, or a Refusal of the first that begins like an option."""
        for value in values:
            if value.startswith("-"):
                raise Refusal(unknown(ctx, value))
        return values


class Command(click.Command):
    """A command whose errors are Refusals, with the help of `libration.cli.help`."""

    context_class = Context

    def __init__(
        self,
        name: str,
        text: str,
        *,
        usage: Sequence[str],
        short: str = "",
        parameters: Sequence[click.Parameter] = (),
        topics: Sequence[Topic] = (),
        examples: Sequence[Example] = (),
        callback: Callable[..., Any] | None = None,
    ) -> None:
        super().__init__(
            name,
            params=[*parameters, Spoken(getattr(parameters[-1], "group", "options"))],
            help=text,
            short_help=short,
            callback=callback,
            context_settings=dict(SETTINGS),
        )
        self.usage, self.topics, self.examples = usage, topics, examples

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Set the options that the words give, or refuse the first bad word."""
        # As an option `-h` would be found in `-3h`, three hours before.
        words = ["--help" if word == "-h" else word for word in args]
        try:
            rest = super().parse_args(ctx, words)
        except click.BadOptionUsage as error:
            option = next(each for each in self.get_params(ctx) if error.option_name in each.opts)
            if isinstance(option, Value):
                raise Refusal(needs_value(ctx.command_path, option)) from error
            raise Refusal(f"{error.option_name}: takes no value") from error
        if ctx.args and not ctx.resilient_parsing and not isinstance(self, click.Group):
            raise Refusal(unknown(ctx, ctx.args[0]))
        return rest

    def shell_complete(self, ctx: click.Context, incomplete: str) -> "list[CompletionItem[str]]":
        """What may follow: of the options those that are not given yet."""
        given = {option for each in self.params if ctx.params.get(str(each.name)) for option in each.opts}
        typed = incomplete if isinstance(self, click.Group) else incomplete or "--"
        return [each for each in super().shell_complete(ctx, typed) if each.value not in given]

    def format_usage(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """How to call it."""
        head = told("usage: ")
        pieces = [told(piece) if piece == "[options]" else piece for piece in self.usage]
        room = formatter.width - len(head)
        formatter.write_usage("", " ".join(together(piece, room) for piece in pieces), head)

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """What it does."""
        formatter.write_paragraph()
        formatter.write_text(self.help or "")

    def format_arguments(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Words stand in the groups of the options."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The words and options by groups, in the order given."""
        records = [
            (
                getattr(each, "group", "options"),
                each.row if isinstance(each, Word | Words) else each.get_help_record(ctx),
            )
            for each in self.params
        ]
        rows = [(group, record) for group, record in records if record]
        rows.append((rows[-1][0], ("-h, --help", "show this help and exit")))
        widest = max(len(term) for _, (term, _) in rows)
        for group in dict.fromkeys(group for group, _ in rows):
            with formatter.section(told(group)):
                formatter.write_dl([(f"{term:{widest}}", meaning) for each, (term, meaning) in rows if each == group])

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Topics and examples."""
        assert isinstance(formatter, Formatter)
        formatter.write_topics(self.topics)
        formatter.write_examples(self.examples)


def command(name: str, text: str, run: Callable[[Made], None], options: type[Made], **parts: Any) -> Command:
    """The command that gives its options to `run`; the parts are those of `Command`."""

    def callback(**values: object) -> None:
        run(options(**values))

    return Command(name, text, callback=callback, **parts)


def needs_value(path: str, option: Value) -> str:
    """The refusal of an option whose value is missing."""
    return f"{option.opts[0]}: needs a value, {option.opts[0]} {option.metavar}; see {path} --help"


def unknown(ctx: click.Context, word: str) -> str:
    """The refusal of an unknown word, with the option or the form that may be meant."""
    name = word.split("=", 1)[0]
    known = [option for each in ctx.command.get_params(ctx) for option in each.opts if option.startswith("--")]
    help_page = f"see {ctx.command_path} --help"
    if word.startswith("-"):
        hint = "options stand before --" if name in known else meant(name.lstrip("-"), known, help_page)
        if os.path.isfile(word):
            hint = f"a file of this name is written {quoted(os.path.join(os.curdir, word))}"
        return f"unknown option {quoted(name)}; {hint}"
    hint = help_page
    if word.endswith("'"):
        # cmd of Windows passes them on.
        hint = f'this shell takes double quotes, "like this"; {help_page}'
    elif word[:1].isdigit():
        # PowerShell parts what is joined by commas.
        hint = f"a value follows its option, and several are joined by commas, in PowerShell in quotes; {help_page}"
    elif "--theta0" in known and word.strip() and len(word) <= LONGEST_UNIT:
        hint = f"a unit stands with its number, as in 150deg; {help_page}"
    return f"unknown word {quoted(word)}; {hint}"


def meant(name: str, known: Sequence[str], otherwise: str) -> str:
    """The option that an unknown name may mean, as a question: by another name of it, its beginning, or its letters."""
    from libration._messages import ARGUMENTS

    others = [f"--{each}" for each in (*ARGUMENTS.get(name, ()), *ALSO.get(name.lower(), ()))]
    near = [each for each in others if each in known][:1]
    near = near or [each for each in known if name and each.lower().startswith(f"--{name.lower()}")][:3]
    if near:
        return f"did you mean {' or '.join(near)}?"
    near = difflib.get_close_matches(name.lower(), [each[2:] for each in known], n=1, cutoff=0.6)
    return f"did you mean --{near[0]}?" if near else otherwise
