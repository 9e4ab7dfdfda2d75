"""The picture that a command draws: its file, its title, its resolution and its language."""

import contextlib
import importlib
import re
import textwrap
import warnings
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, BinaryIO, Protocol, TypedDict, TypeVar

import click

from libration._languages import LANGUAGES, known_language
from libration.cli.language import CURRENT
from libration.cli.offers import files
from libration.cli.parser import Options, Refusal, Value, refusal, shown
from libration.cli.quantities import plain
from libration.cli.streams import note

if TYPE_CHECKING:
    from libration._arrays import Floats

PICTURES = (".png", ".svg")
# What matplotlib says of numbers near the largest double, and of a letter that its font lacks.
TOO_LARGE = ("NaN or Inf", "zero-size", "Singular matrix")
GLYPH = re.compile(r"Glyph ([0-9]+) .* missing from font")
Motion = TypeVar("Motion", contravariant=True)


class PictureOptions(Options):
    """The options of a picture, as typed."""

    plot: str | None
    title: str | None
    dpi: str | None
    lang: str | None


class Look(TypedDict):
    """How a picture looks, as the functions of `libration.plot` take it."""

    title: str | None
    dpi: float
    lang: str


class Plot(Protocol[Motion]):
    """A function of `libration.plot` that draws a motion at many instants."""

    def __call__(
        self,
        motion: Motion,
        t: "Floats",
        path: BinaryIO,
        /,
        *,
        form: str | None,
        title: str | None,
        dpi: float,
        lang: str,
    ) -> None: ...


def picture_options(shows: str) -> list[click.Option]:
    """The options of a picture; `shows` says what is drawn."""
    group = "the picture"
    title = "the line above it, instead of the one that states the motion; '' for none, '$\\theta_0$' for symbols"
    return [
        Value("--plot", "FILE", f"draw {shows} to a .png or .svg file", group, offered=files),
        Value("--title", "TEXT", title, group),
        Value("--dpi", "N", "dots per inch of a .png, 20 to 1200 (default 100)", group),
    ]


def picture_look(options: PictureOptions, path: str | None) -> Look:
    """How the picture looks, or a Refusal; `path` is its file."""
    typed = {"--title": options.title, "--dpi": options.dpi}
    for option, given in typed.items():
        if given is not None and path is None:
            raise refusal(option, given, "needs --plot FILE beside it")
    dpi = 100.0 if options.dpi is None else plain("--dpi", options.dpi)
    if options.dpi is not None and not 20 <= dpi <= 1200:
        raise refusal("--dpi", options.dpi, "must be from 20 to 1200")
    return {"title": options.title, "dpi": dpi, "lang": language(options.lang)}


def language(text: str | None) -> str:
    """The language, or a Refusal."""
    found = CURRENT.get() if text is None else known_language(text)
    if found is None:
        raise refusal("--lang", text, f"must be {', '.join(LANGUAGES[:-1])} or {LANGUAGES[-1]}")
    return found


def check_plot(options: PictureOptions) -> None:
    """Refuse to draw, before anything is computed, if matplotlib is missing or does not start."""
    if options.plot is not None:
        check_matplotlib("--plot", options.plot, "plot")


def check_matplotlib(option: str, path: str, extra: str) -> None:
    """Refuse to draw if matplotlib is missing or does not start; `extra` of libration installs it."""
    check_package("matplotlib", ("matplotlib.backends.backend_agg", "matplotlib.figure"), option, path, extra)


def check_package(package: str, modules: Sequence[str], option: str, path: str, extra: str) -> None:
    """Refuse an option whose package is missing or does not start."""
    try:
        for module in modules:
            importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise refusal(option, path, f"needs {package}: pip install 'libration[{extra}]'") from error
    except Exception as error:
        # The import reads the settings of the user, and a bad one may raise any exception.
        reason = textwrap.shorten(str(error) or type(error).__name__, 160, placeholder=" ...")
        raise refusal(option, path, f"{package} does not start: {reason}") from error


def form(path: str) -> str:
    """The format of a plot by the ending of its name."""
    return path.rpartition(".")[2].lower()


def draw(plot: Plot[Motion], motion: Motion, times: "Floats", file: BinaryIO, path: str, look: Look) -> None:
    """Draw a motion into the staged file, or a Refusal."""
    with drawing("--plot", path):
        plot(motion, times, file, form=form(path), **look)


@contextlib.contextmanager
def drawing(option: str, path: str) -> Iterator[None]:
    """Refuse what cannot be drawn, as numbers near the largest double; say which letters the font of a .png lacks."""
    try:
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            yield
    except (ArithmeticError, RuntimeError, ValueError) as error:
        if str(error).startswith("title = "):
            raise Refusal(f"--{error}") from error
        large = isinstance(error, OverflowError) or any(words in str(error) for words in TOO_LARGE)
        reason = "the motion is too large for an axis" if large else str(error)
        raise refusal(option, path, f"cannot be drawn: {reason}") from error
    codes = [GLYPH.match(str(each.message)) for each in said]
    lacking = dict.fromkeys(chr(int(code[1])) for code in codes if code)
    if lacking and form(path) == "png":
        note(
            f"{option} = {shown(path)}: the font has no {' '.join(lacking)}; an .svg takes the fonts of who looks at it"
        )
