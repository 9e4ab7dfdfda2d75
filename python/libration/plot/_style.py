"""How every picture looks: colours, frame, legend, ticks, and the way it is saved.

matplotlib is needed only here (`pip install 'libration[plot]'`) and only its Figure is used: no pyplot, no global
state, no window. The colours are those of Okabe & Ito, which the colour-blind tell apart, darkened where a thin line or
a word of that colour would be pale on white; no two lines of a panel differ by colour alone.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from typing import Any

import numpy as np

from .._advice import advice, element_kind
from .._scalars import real, shown
from ._language import ENGLISH, Language

BLACK = "#1a1a1a"
DOTTED, DASHED = (0, (1, 1.4)), (0, (4.5, 3.2))
EXACT, SEPARATRIX = "#0072b2", "#c44601"
GREEN, PURPLE, OCHRE, SKY = "#00805e", "#a8447c", "#946c00", "#3a8fc4"
LINEAR = "#8a8a8a"
FAINT = "#d9d9d9"
# The text of an SVG is text; where the first font is missing, one of nearly its widths is taken.
FONTS = ("DejaVu Sans", "Verdana", "Segoe UI", "Roboto", "Helvetica Neue", "Arial", "Liberation Sans", "sans-serif")
# The largest errors of a panel differ by more than this factor: its axis is logarithmic, and ends so many decades below
# the smallest of them.
WIDE, DECADES = 50.0, 2.0
# In points: the first of them in which the title fits into a line.
TITLE_SIZES = (13, 12, 11, 10)
# Of the height of a picture.
MOST_TITLE = 0.25
FORMS = ("png", "svg")
LEAST_DPI, MOST_DPI = 20, 1200
MISSING = "a picture needs matplotlib: pip install 'libration[plot]'"
# Of more than MANY swings or turns, only the first SHOWN are drawn over t.
MANY, SHOWN = 60, 20
# Of a legend.
COLUMNS = 4
# Instants are drawn as dots up to this number.
FEW = 60


def finite(t: Any) -> np.ndarray:
    """The finite instants among those given, at least one."""
    if hasattr(t, "transAxes"):
        raise TypeError(f"t = {shown(t)}: must be instants; axes are given by ax=")
    try:
        if element_kind(t) in ("M", "m", "c"):
            raise TypeError
        given = np.asarray(t, dtype=float).ravel()
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"t = {shown(t)}: must be real numbers{advice('t', t)}") from None
    instants: np.ndarray = given[np.isfinite(given)]
    if not instants.size:
        raise ValueError(f"t = {shown(t)}: at least one finite instant is needed for a picture")
    return instants


def save(path: Any, form: str | None, title: str, left: Any, right: Any, *, dpi: float = 100) -> None:
    """Draw a panel over time beside a phase portrait, under one line, and save the picture."""

    def draw(figure: Any) -> None:
        panels = figure.subplots(1, 2, width_ratios=(1.35, 1))
        left(panels[0])
        right(panels[1])
        head(figure, title)

    save_figure({form: path}, (12, 5), draw, dpi=dpi)


def head(figure: Any, title: str) -> None:
    """The line above a picture; a title too long for one line is smaller, then broken."""
    if not isinstance(title, str) or not title.replace("\n", " ").isprintable():
        raise ValueError(f"title = {shown(title)}: must be text that can be printed")
    if not title:
        return
    room = 0.976 * figure.bbox.width
    text = figure.suptitle(title, x=0.012, ha="left")
    try:
        for size in TITLE_SIZES:
            text.set_fontsize(size)
            wide = text.get_window_extent().width
            if wide <= room:
                break
    except ValueError as error:
        # matplotlib repeats the title above its reason.
        raise ValueError(
            f"title = {shown(title)}: has a formula that is wrong: {str(error).splitlines()[-1]}"
        ) from None
    # A formula is not broken.
    if wide > room and "$" not in title:
        characters = int(0.95 * room / wide * max(map(len, title.splitlines())))
        text.set_text("\n".join(textwrap.fill(line, characters) for line in title.splitlines()))
    if text.get_window_extent().height > MOST_TITLE * figure.bbox.height:
        raise ValueError(f"title = {shown(title)}: is too long for the picture")


def save_figure(
    files: dict[Any, Any], size: tuple[float, float], draw: Any, *, dpi: float = 100, told: dict[str, str] | None = None
) -> None:
    """Draw a figure of a size in inches once, in the settings of the house, and save it in every form.

    `files` are paths or binary files by form; without one (None) the ending of the path says it. `told` is what a file
    says of itself.
    """
    if not LEAST_DPI <= real("dpi", dpi) <= MOST_DPI:
        raise ValueError(f"dpi = {dpi!r}: must be from {LEAST_DPI} to {MOST_DPI}")
    for form, file in files.items():
        check_form(file, form)
    with house():
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        figure = Figure(figsize=size, dpi=dpi, layout="constrained")
        FigureCanvasAgg(figure)
        engine: Any = figure.get_layout_engine()
        engine.set(w_pad=0.08, h_pad=0.05)
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            draw(figure)
            for form, file in files.items():
                save_as(figure, file, form, told or {})


@contextmanager
def house() -> Iterator[None]:
    """The settings of every picture that is saved, in place of the user's."""
    try:
        from matplotlib import rc_context, rcParamsDefault
    except ModuleNotFoundError as error:
        raise ImportError(MISSING) from error
    # Not those of a matplotlibrc, which may ask for LaTeX or hide a line; the salt makes the same file of the same picture.
    settings: Any = {name: value for name, value in rcParamsDefault.items() if name != "backend"}
    own = {"svg.hashsalt": "libration", "svg.fonttype": "none", "font.sans-serif": list(FONTS[:-1])}
    with rc_context(settings | own):
        yield


def check_form(file: Any, form: str | None) -> None:
    """Refuse what is neither PNG nor SVG; a binary file without a form is PNG."""
    if form is not None:
        if form not in FORMS:
            raise ValueError(f"form = {form!r}: must be png or svg")
    elif not hasattr(file, "write") and not str(file).lower().endswith(tuple(f".{each}" for each in FORMS)):
        raise ValueError(f"path = {shown(file)}: must end in .png or .svg, or form= must be one of them")


def save_as(figure: Any, file: Any, form: str | None, told: dict[str, str]) -> None:
    """One file of a figure."""
    if not is_svg(file, form):
        figure.savefig(file, format=form, metadata=told | {"Software": "libration"})
        return
    made = BytesIO()
    # A date would make another file of the same picture.
    figure.savefig(made, format="svg", metadata=told | {"Date": None})
    content = with_fonts(made.getvalue().decode()).encode()
    if hasattr(file, "write"):
        file.write(content)
    else:
        with open(file, "wb") as target:
            target.write(content)


def with_fonts(svg: str) -> str:
    """An SVG whose formulas name the fonts to fall back on too; matplotlib gives them one font alone."""
    others = ", ".join(f"'{each}'" if " " in each else each for each in FONTS)
    return re.sub(r"(font(?:-family)?: [^;\"]*?)'DejaVu Sans'(?=[;\"])", lambda found: found[1] + others, svg)


def is_svg(path: Any, form: str | None) -> bool:
    """Whether the picture is SVG."""
    return form == "svg" or (form is None and str(path).lower().endswith(".svg"))


def first_swings(first: float, last: float, scale: float) -> float:
    """Where the picture ends: more swings than it has room for would be a solid band."""
    return first + SHOWN * scale if last - first > MANY * scale else last


def part_of(
    unit: str, first: float, last: float, start: float, stop: float, say: Language = ENGLISH, digits: int = 6
) -> str:
    """What an axis from `first` to `last` shows of `start` to `stop`, whose length has so many digits."""
    if last - first == stop - start:
        return unit
    text = "{axis}, the first {shown} of {all} s" if first == start else "{axis}, {shown} of {all} s"
    return say.word(text, axis=unit, shown=say.number(last - first, 3), all=say.number(stop - start, digits))


def look(styles: tuple[tuple[str, Any], ...], number_of: int) -> tuple[str, Any]:
    """Colour and dash of a curve: the first six are told apart in grey too, and no two of thirty-six are alike."""
    color, _ = styles[number_of % len(styles)]
    _, dash = styles[(number_of + number_of // len(styles)) % len(styles)]
    return color, dash


def spans_decades(errors: list[np.ndarray], room: float = np.inf) -> bool:
    """Whether the largest errors, cut at `room`, are too different for one linear axis."""
    largest = [min(float(np.nanmax(np.abs(error), initial=0.0)), room) for error in errors]
    seen = [each for each in largest if each > 0]
    return bool(seen) and max(seen) > WIDE * min(seen)


def logarithmic(axes: Any, errors: list[np.ndarray], room: float = np.inf) -> None:
    """A logarithmic axis for the sizes of errors, with room below for where they cross zero."""
    largest = [min(float(np.nanmax(np.abs(error), initial=0.0)), room) for error in errors]
    seen = [each for each in largest if each > 0]
    axes.set_yscale("log")
    axes.set_ylim(min(seen) / 10**DECADES, 2 * max(seen))


def sizes(error: np.ndarray) -> np.ndarray:
    """Sizes of errors; the zeros, which have no logarithm, are left out."""
    found: np.ndarray = np.where(error == 0, np.nan, np.abs(error))
    return found


def quiet(axes: Any) -> None:
    """Thin grey frame on two sides, a light grid."""
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color("#777777")
    axes.tick_params(color="#777777")
    axes.grid(color="#f0f0f0", lw=0.8)
    axes.set_axisbelow(True)


def legend(axes: Any) -> None:
    """One line above the panel, clear of every curve; of more than four names the others stand below the first."""
    handles, labels = axes.get_legend_handles_labels()
    # matplotlib fills the columns one after the other.
    order = [place for column in range(COLUMNS) for place in range(column, len(labels), COLUMNS)]
    axes.legend(
        [handles[place] for place in order],
        [labels[place] for place in order],
        loc="lower right",
        bbox_to_anchor=(1.01, 1.0),
        ncols=COLUMNS,
        frameon=False,
        fontsize=9.5,
        handlelength=1.6,
        handletextpad=0.5,
        columnspacing=1.0,
    )


def angle_ticks(axis: Any, low: float, high: float) -> None:
    """Ticks at multiples of pi if the range spans some; else decimal radians."""
    from matplotlib.ticker import FuncFormatter, MultipleLocator

    steps = [0.25, 0.5] + [digit * 10.0**power for power in range(9) for digit in (1, 2, 5)]
    step = next((each for each in steps if (high - low) / np.pi <= 7 * each), None)
    if high - low < 2 or step is None:
        return
    axis.set_major_locator(MultipleLocator(step * np.pi))
    axis.set_major_formatter(FuncFormatter(pi_text))


def pi_text(value: float, _position: object = None) -> str:
    """`-π/2`, `0`, `3π`: a multiple of pi/4 in words."""
    quarters = round(4 * value / np.pi)
    whole, below = quarters, 4
    while below > 1 and whole % 2 == 0:
        whole, below = whole // 2, below // 2
    if whole == 0:
        return "0"
    front = {1: "", -1: "−"}.get(whole, f"{whole}".replace("-", "−"))
    return f"{front}π" + (f"/{below}" if below > 1 else "")
