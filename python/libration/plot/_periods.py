"""Pictures of the period against the turning angle: chosen formulas in one panel, all of them family by family."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from .._scalars import real
from ..approx import PeriodFormula, period
from ..approx._period import listed
from ._axes import given_or_new, named
from ._language import ENGLISH, Language
from ._style import (
    BLACK,
    DASHED,
    DOTTED,
    EXACT,
    FAINT,
    GREEN,
    LINEAR,
    OCHRE,
    PURPLE,
    SEPARATRIX,
    SKY,
    head,
    look,
    quiet,
    save_figure,
    sizes,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.axes import Axes

# What `plot_period` draws if nobody says: one formula of each kind.
CHOSEN = ("linear", "bernoulli", "kidd-fogg", "lima-arun", "agm:2", "cromer")
# One curve under two names is drawn once.
SAME = {"agm:2": "agm:2 = belendez"}
# Each family has a panel; what is in none has the last.
FAMILIES = {
    "powers of the angle": ("linear", "bernoulli", "series:4", "series:8"),
    "sine and cosine of the angle": ("kidd-fogg", "molina", "ganley-parwani", "denman"),
    "logarithms": ("lima-arun", "cromer", "chachiyo"),
    "arithmetic-geometric mean": ("agm:1", "agm:2", "agm:3", "agm:4"),
    "rational in m": ("salas-26", "salas-27", "salas-28"),
}
OTHERS = "other formulas"
STYLES = (
    (EXACT, "solid"),
    (SEPARATRIX, DASHED),
    (GREEN, DOTTED),
    (PURPLE, (0, (6, 2, 1, 2))),
    (OCHRE, (0, (8, 2))),
    (SKY, (0, (3, 1))),
)
ANGLES = 1200
# A double shows no smaller error of a ratio.
LEAST = 1e-16
HIGHEST = 4.0
# Degrees between two marks whose names stand in a line, and from where on a name is left of its mark.
APART, HALF = 24, 90
# Degrees that a letter of a name takes on the axis of a panel.
WIDTH = 4.4
TURNING, RATIO = r"$\theta_\mathrm{max}$", r"$T / T_0$"


def plot_period(
    ax: Axes | None = None,
    *,
    formulas: Iterable[str] = CHOSEN,
    error: bool = False,
    theta_max: float | Iterable[float] | None = None,
    lang: str = "en",
) -> Axes:
    """Draw the period over that of small swings against the turning angle, exact and by chosen formulas.

    Parameters
    ----------
    ax : Axes, optional
        Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
    formulas : iterable of str
        Names of `libration.approx.period`; by default one formula of each kind.
    error : bool, default False
        Whether to draw the size of the relative error instead, on a logarithmic axis.
    theta_max : float or iterable of float, optional
        A turning angle in rad to be marked, or several.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Returns
    -------
    Axes
        Those drawn into; the turning angle is in degrees.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If a formula is not known, a turning angle is not from 0 to pi, or `ax` or `lang` is none of those.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from libration.plot import plot_period
    >>> ax = plot_period(Figure().subplots(), formulas=["bernoulli", "agm:2"])
    >>> [text.get_text() for text in ax.get_legend().get_texts()]
    ['exact', 'bernoulli', 'agm:2']
    """
    say = Language(lang)
    if isinstance(formulas, str):
        raise ValueError(f"formulas = {formulas!r}: must be a list of names, as [{formulas!r}]")
    made = [period(name) for name in formulas]
    axes, new = given_or_new(ax)
    draw = draw_errors if error else draw_ratios
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        draw(axes, made, say)
    axes.set_xlabel(say.word("turning angle θmax [degrees]").replace("θmax", TURNING))
    mark(axes, theta_max, say)
    say.ticks(axes)
    named(axes, new)
    return axes


def plot_periods(
    path: Any,
    *,
    theta_max: float | Iterable[float] | None = None,
    form: str | None = None,
    title: str | None = None,
    dpi: float = 100,
    lang: str = "en",
) -> None:
    """Draw T/T0 against the turning angle, and the size of the relative error of every formula, family by family.

    Where an author states a range, the curve of the formula is broad over it. Into axes of your own: `plot_period`.

    Parameters
    ----------
    path : str, path or binary file
        Where to save.
    theta_max : float or iterable of float, optional
        A turning angle in rad to be marked, or several.
    form : str, optional
        `png` or `svg`; by default the ending of `path`. The text of an SVG is text.
    title : str, optional
        The line above the picture; an empty one leaves it out.
    dpi : scalar, default 100
        Dots per inch of a PNG of 12 by 7.4 inches, from 20 to 1200.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If a turning angle is not from 0 to pi, `title` is too long, or `dpi` or `lang` is none of those.

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration.plot import plot_periods
    >>> picture = BytesIO()
    >>> plot_periods(picture, theta_max=2.6, form="png")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    say = Language(lang)

    def draw(figure: Any) -> None:
        draw_periods(figure, theta_max, say)
        head(figure, say.word("Period of a pendulum against its turning angle") if title is None else title)

    save_figure({form: path}, (12, 7.4), draw, dpi=dpi)


def families() -> dict[str, list[PeriodFormula]]:
    """Every formula once, by its family."""
    shown = {formula.name: formula for formula in listed() if formula.name != "belendez"}
    found = {family: [shown.pop(name) for name in names if name in shown] for family, names in FAMILIES.items()}
    return found | ({OTHERS: list(shown.values())} if shown else {})


def draw_periods(figure: Any, theta_max: Any, say: Language = ENGLISH) -> None:
    """The ratios, and a panel of errors for each family over the others in grey."""
    groups = families()
    panels = figure.subplots(math.ceil((1 + len(groups)) / 3), 3, sharex=True).flatten()
    first, *rest = panels[: 1 + len(groups)]
    for spare in panels[1 + len(groups) :]:
        spare.remove()
    every = [formula for group in groups.values() for formula in group]
    for axes in (first, *rest):
        quiet(axes)
    first.set_title(say.word("T/T₀, exact and every formula"), fontsize=11, loc="left")
    draw_ratios(first, [], say, every)
    exact = float(period("exact").ratio(math.radians(120)))
    first.annotate(say.word("exact"), (120, exact), (-6, 6), textcoords="offset points", ha="right", color=BLACK)
    for axes, (family, group) in zip(rest, groups.items(), strict=True):
        axes.set_title(say.word(family), fontsize=11, loc="left")
        draw_errors(axes, group, say, [formula for formula in every if formula not in group])
        label_curves(axes)
    for number_of, axes in enumerate((first, *rest)):
        mark(axes, theta_max, say if axes is first else None)
        say.ticks(axes)
        if number_of > 1 and number_of % 3:
            axes.set_ylabel("")
    first.set_xticks(range(0, 181, 30))
    broad = say.word("turning angle θmax [degrees]; broad: the range that its author states")
    figure.supxlabel(broad.replace("θmax", TURNING), fontsize=10)


def angles() -> tuple[np.ndarray, np.ndarray]:
    """Turning angles in degrees and rad, denser towards the top, where the period runs away."""
    degrees = 180 * np.sin(np.linspace(0, math.pi / 2, ANGLES + 2)[1:-1])
    return degrees, np.radians(degrees)


def draw_ratios(axes: Any, formulas: list[PeriodFormula], say: Language, faint: Any = ()) -> None:
    """T/T0, exact and by formulas; those that are faint are the background."""
    degrees, _ = angles()
    for formula in faint:
        axes.plot(degrees, curve(formula.name, error=False), color=FAINT, lw=0.9, zorder=1.5)
    exact = say.word("exact")
    axes.plot(degrees, curve("exact", error=False), color=BLACK, lw=2.2, label=exact, zorder=3)
    for number_of, formula in enumerate(formulas):
        color, dash = look(STYLES, number_of)
        axes.plot(degrees, curve(formula.name, error=False), color=color, ls=dash, lw=1.5, label=formula.name)
    axes.set(xlim=(0, 180), ylim=(0.8, HIGHEST), ylabel=RATIO)


def draw_errors(axes: Any, formulas: list[PeriodFormula], say: Language, faint: Any = ()) -> None:
    """The size of the relative errors on a logarithmic axis."""
    degrees, _ = angles()
    for formula in faint:
        axes.plot(degrees, curve(formula.name, error=True), color=FAINT, lw=0.9, zorder=1.5)
    for number_of, formula in enumerate(formulas):
        color, dash = look(STYLES, number_of)
        error = curve(formula.name, error=True)
        axes.plot(degrees, error, color=color, ls=dash, lw=1.6, label=SAME.get(formula.name, formula.name))
        if formula.stated_range:
            low, high = np.degrees(formula.stated_range)
            inside = np.where((low <= degrees) & (degrees <= high), error, np.nan)
            axes.plot(degrees, inside, color=color, lw=7, alpha=0.2, solid_capstyle="butt", zorder=1.8)
    axes.set(yscale="log", ylim=(LEAST, 10.0), xlim=(0, 180), ylabel=say.word("|relative error|"))


@lru_cache(maxsize=64)
def curve(name: str, *, error: bool) -> np.ndarray:
    """The ratio of a formula, or the size of its error, over the angles: every panel shows every formula."""
    formula = period(name)
    found: np.ndarray = sizes(formula.error(angles()[1])) if error else formula.ratio(angles()[1])
    return found


def mark(axes: Any, theta_max: Any, say: Language | None = None) -> None:
    """Turning angles, marked; with a language, each with its degrees at the top."""
    near = {"textcoords": "offset points", "va": "top", "fontsize": "small", "color": "#555555", "zorder": 4}
    last, row = -math.inf, 0
    for degrees in turning_degrees(theta_max):
        axes.axvline(degrees, color=LINEAR, lw=1, ls=(0, (2, 2)), zorder=1.7)
        if say:
            # A line below where the angle before is too near.
            row, last = (row + 1 if degrees - last < APART else 0), degrees
            side, offset = ("left", 3) if degrees < HALF else ("right", -3)
            axes.annotate(
                f"{say.number(degrees, 4)}°",
                (degrees, 1.0),
                (offset, -2 - 12 * row),
                xycoords=axes.get_xaxis_transform(),
                ha=side,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.85},
                **near,
            )


def turning_degrees(theta_max: Any) -> list[float]:
    """Turning angles in rad, one or several, as rising degrees."""
    given = [] if theta_max is None else theta_max if np.ndim(theta_max) else [theta_max]
    angles = [real("theta_max", each) for each in given]
    for angle in angles:
        if not 0 <= angle <= math.pi:
            raise ValueError(f"theta_max = {angle!r}: must be from 0 to pi")
    return sorted({math.degrees(angle) for angle in angles})


def label_curves(axes: Any) -> None:
    """A name on every curve of a panel of errors, where it covers no other curve and no other name."""
    curves = [line for line in axes.lines if not line.get_label().startswith("_")]
    grid = np.arange(4.0, 177.0)
    heights = [heights_at(grid, line) for line in curves]
    taken: list[tuple[float, float, float]] = []
    for line, height in zip(curves, heights, strict=True):
        half = WIDTH * len(line.get_label()) / 2
        others = [other for other in heights if other is not height]
        where = [place for place in range(grid.size) if 5 + half <= grid[place] <= 172 - half]
        best = max(where, key=lambda place: clear(place, half, grid, height, others, taken))
        taken.append((grid[best], height[best], half))
        axes.annotate(
            line.get_label(),
            (grid[best], 10 ** height[best]),
            ha="center",
            va="center",
            fontsize=9,
            color=line.get_color(),
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.85},
            zorder=4,
        )


def clear(
    place: int,
    half: float,
    grid: np.ndarray,
    height: np.ndarray,
    others: list[np.ndarray],
    taken: list[tuple[float, float, float]],
) -> float:
    """How far a name at a place is from the other curves and names, in decades; below 0 outside of the panel."""
    x, y = grid[place], height[place]
    if not math.log10(LEAST) + 1 < y < 0.3:
        return -1.0
    beside = np.abs(grid - x) <= half + 2
    room = min((float(np.min(np.abs(other[beside] - y))) for other in others), default=9.0)
    for other_x, other_y, other_half in taken:
        if abs(x - other_x) < half + other_half + 4:
            room = min(room, abs(y - other_y) - 1.0)
    # Of places with room enough, one where the curve is flat: a name across a steep curve hides more of it.
    steep = float(np.ptp(height[beside]))
    return min(room, 1.6) - 0.25 * min(steep, 4.0)


def heights_at(places: np.ndarray, line: Any) -> np.ndarray:
    """The logarithm of a curve at some places."""
    x, y = (np.asarray(data, dtype=float) for data in line.get_data())
    height: np.ndarray = np.log10(np.interp(places, x, y))
    return height
