"""The picture that a command draws: its file, its title, its resolution and its language."""

import importlib
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, BinaryIO, Protocol, TypedDict, TypeVar

import click

from libration.cli.offers import LANGUAGES, files, words
from libration.cli.parser import Options, Value, refusal
from libration.cli.quantities import plain

if TYPE_CHECKING:
    from libration._arrays import Floats

PICTURES = (".png", ".svg")
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
    title = "the line above it, instead of the one that states the motion; '' for none"
    return [
        Value("--plot", "FILE", f"draw {shows} to a .png or .svg file", group, offered=files),
        Value("--title", "TEXT", title, group),
        Value("--dpi", "N", "dots per inch of a .png, 20 to 1200 (default 100)", group),
        Value("--lang", "LANGUAGE", "en, pt-BR or es: its words and decimal sign", group, offered=words(*LANGUAGES)),
    ]


def picture_look(options: PictureOptions, path: str | None) -> Look:
    """How the picture looks, or a Refusal; `path` is its file."""
    typed = {"--title": options.title, "--dpi": options.dpi, "--lang": options.lang}
    for option, given in typed.items():
        if given is not None and path is None:
            raise refusal(option, given, "needs --plot FILE beside it")
    dpi = 100.0 if options.dpi is None else plain("--dpi", options.dpi)
    if options.dpi is not None and not 20 <= dpi <= 1200:
        raise refusal("--dpi", options.dpi, "must be from 20 to 1200")
    return {"title": options.title, "dpi": dpi, "lang": language(options.lang)}


def language(text: str | None) -> str:
    """The language, however its letters are typed, or a Refusal."""
    if text is None:
        return "en"
    code = text.lower().replace("_", "-")
    for known in LANGUAGES:
        if code in (known.lower(), known.lower().partition("-")[0]):
            return known
    raise refusal("--lang", text, f"must be {', '.join(LANGUAGES[:-1])} or {LANGUAGES[-1]}")


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
    """Draw into the staged file; numbers near the largest double do not fit on an axis."""
    try:
        plot(motion, times, file, form=form(path), **look)
    except (ArithmeticError, RuntimeError, ValueError) as error:
        large = isinstance(error, OverflowError) or any(words in str(error) for words in ("NaN or Inf", "zero-size"))
        reason = "the motion is too large for an axis" if large else str(error)
        raise refusal("--plot", path, f"cannot be drawn: {reason}") from error
