"""Pictures of approximations: the angle over time above their errors, as Lima draws them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .._scalars import shown
from ._axes import given_or_new, named, once
from ._language import ENGLISH, Language
from ._style import (
    BLACK,
    DASHED,
    DOTTED,
    EXACT,
    GREEN,
    OCHRE,
    PURPLE,
    SEPARATRIX,
    SKY,
    head,
    legend,
    logarithmic,
    look,
    quiet,
    save_figure,
    sizes,
    spans_decades,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Colour and dash: told apart in grey too; the first two are those of the papers' figures.
STYLES = (
    (SEPARATRIX, DOTTED),
    (EXACT, DASHED),
    (GREEN, (0, (6, 2, 1, 2))),
    (PURPLE, (0, (3, 1))),
    (OCHRE, (0, (8, 2))),
    (SKY, (0, (2, 2))),
)
INSTANTS = 2000
# The dots of a longer series are small.
MANY_DOTS = 150
# More periods than this would be a solid band: the first are drawn.
SHOWN_PERIODS = 12


def plot_comparison(
    pendulum: Any,
    solutions: Any,
    path: Any,
    *,
    periods: float = 1.0,
    form: str | None = None,
    title: str | None = None,
    dpi: float = 100,
    lang: str = "en",
) -> None:
    """Draw approximations beside the exact angle, and below their errors in percent of the turning angle.

    Where the largest errors span decades, their size is drawn on a logarithmic axis. Into axes of your own:
    `libration.approx.compare`.

    Parameters
    ----------
    pendulum : Pendulum
        The motion; it repeats.
    solutions : sequence of (str, AngleApproximation or NumericalSolution)
        What is compared, with its name.
    path : str, path or binary file
        Where to save.
    periods : float, default 1
        How many periods; of more than twelve the first twelve.
    form : str, optional
        `png` or `svg`; by default the ending of `path`. The text of an SVG is text.
    title : str, optional
        The line above the picture; by default it says the state, the regime and the period. An empty one leaves it out.
    dpi : scalar, default 100
        Dots per inch of a PNG of 9 by 6.5 inches, from 20 to 1200.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If `dpi` or `lang` is none of those.

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration import Pendulum, approx
    >>> from libration.plot import plot_comparison
    >>> pendulum, picture = Pendulum(2.0), BytesIO()
    >>> plot_comparison(pendulum, [("harmonic", approx.angle("harmonic").of(pendulum))], picture, form="png")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    say = Language(lang)
    if not all(isinstance(each, tuple | list) and len(each) == 2 for each in solutions):
        raise ValueError(
            f"solutions = {shown(solutions)}: must be pairs of name and solution; approx.compare takes names"
        )

    def draw(figure: Any) -> None:
        draw_comparison(figure, pendulum, solutions, periods, say)
        head(figure, headline(pendulum, say) if title is None else title)

    save_figure({form: path}, (9, 6.5), draw, dpi=dpi)


def headline(pendulum: Any, say: Language = ENGLISH) -> str:
    """State, regime and period in one line."""
    start = rf"$\theta_0$ = {say.number(math.degrees(pendulum.theta0), 7)}°"
    if pendulum.velocity0:
        start += rf", $\dot\theta_0$ = {say.number(pendulum.velocity0)} rad/s"
    words = "{start}: rotation, T = {period} s"
    if pendulum.regime == "libration":
        words = "{start}: libration, T = {period} s"
    return say.word(words, start=start, period=say.number(pendulum.period))


def comparison_axes(pendulum: Any, solutions: Any, periods: float, ax: Any, lang: str) -> Axes:
    """Draw the angles into axes of the user, or both panels into a new figure; return those of the angles."""
    say = Language(lang)
    upper, new = given_or_new(ax, (7.5, 5.6))
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        if new:
            figure = upper.figure
            upper.remove()
            draw_comparison(figure, pendulum, solutions, periods, say)
            return figure.axes[0]
        draw_angles(upper, pendulum, solutions, periods, say)
    upper.set_xlabel(abscissa(pendulum, solutions, periods, say))
    say.ticks(upper)
    named(upper, new)
    return upper


def error_axes(pendulum: Any, solutions: Any, periods: float, ax: Any, lang: str) -> Axes:
    """Draw the errors into axes of the user or new ones, and return them."""
    say = Language(lang)
    axes, new = given_or_new(ax, (7.5, 4.2))
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        draw_errors(axes, pendulum, solutions, periods, say)
    axes.set_xlabel(abscissa(pendulum, solutions, periods, say))
    say.ticks(axes)
    named(axes, new)
    return axes


def draw_comparison(figure: Any, pendulum: Any, solutions: Any, periods: float, say: Language = ENGLISH) -> None:
    """Both panels, over time in periods."""
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(1.5, 1.1))
    for axes in (upper, lower):
        quiet(axes)
    draw_angles(upper, pendulum, solutions, periods, say)
    draw_errors(lower, pendulum, solutions, periods, say)
    lower.set_xlabel(abscissa(pendulum, solutions, periods, say))
    say.ticks(upper, lower)
    legend(upper)


def grid(pendulum: Any, periods: float) -> tuple[np.ndarray, np.ndarray]:
    """Instants in periods and in s."""
    part = np.linspace(0.0, min(periods, SHOWN_PERIODS), INSTANTS + 1)
    return part, part * pendulum.period


def places(solution: Any, pendulum: Any, periods: float, dash: Any) -> tuple[np.ndarray, np.ndarray, dict[str, Any]]:
    """Where a solution is drawn, in periods and in s, and how: a formula as a line, a series of the user as its dots."""
    part, t = grid(pendulum, periods)
    if not hasattr(solution, "instants"):
        return part, t, {"ls": dash, "lw": 1.6}
    own = solution.instants[(solution.instants >= 0) & (solution.instants <= t[-1])]
    return own / pendulum.period, own, {"ls": "none", "marker": "o", "ms": 3.5 if own.size <= MANY_DOTS else 1.5}


def difference(solution: Any, pendulum: Any, t: np.ndarray) -> np.ndarray:
    """A solution minus the exact angle; the approximations know it beyond the rounding of the angle."""
    if hasattr(solution, "difference"):
        found: np.ndarray = solution.difference(t)
        return found
    found = solution.theta(t) - pendulum.theta(t)
    return found


def draw_angles(axes: Any, pendulum: Any, solutions: Any, periods: float, say: Language) -> None:
    """The exact angle and those of the approximations; hatched where one is undefined."""
    part, t = grid(pendulum, periods)
    exact = pendulum.theta(t)
    axes.plot(part, exact, color=BLACK, lw=1.8, label=once(axes, say.word("exact")))
    gaps = 0
    for number_of, (name, solution) in enumerate(solutions):
        color, dash = look(STYLES, number_of)
        x, instants, style = places(solution, pendulum, periods, dash)
        theta = solution.theta(instants)
        axes.plot(x, theta, color=color, label=name, **style)
        if x is part and np.isnan(theta).any():
            hatch(axes, part, np.isnan(theta), color, gaps)
            gaps += 1
    # What runs away leaves the picture, so that the others can be told apart.
    room = 0.5 * np.ptp(exact)
    within(axes, exact.min() - room, exact.max() + room)
    axes.set_xlim(0.0, part[-1])
    axes.set_ylabel(r"$\theta$ [rad]")


def draw_errors(axes: Any, pendulum: Any, solutions: Any, periods: float, say: Language) -> None:
    """The errors; their size on a logarithmic axis where they span decades."""
    part, t = grid(pendulum, periods)
    swings = math.isfinite(pendulum.theta_max)
    unit = 100 / pendulum.theta_max if swings else 1.0
    drawn = [
        places(solution, pendulum, periods, look(STYLES, number_of)[1])
        for number_of, (_, solution) in enumerate(solutions)
    ]
    errors = [
        unit * difference(solution, pendulum, at) for (_, solution), (_, at, _) in zip(solutions, drawn, strict=True)
    ]
    room = 0.5 * unit * np.ptp(pendulum.theta(t))
    decades = spans_decades(errors, 2 * room)
    for number_of, ((name, _), (x, _, style), error) in enumerate(zip(solutions, drawn, errors, strict=True)):
        color, _ = look(STYLES, number_of)
        axes.plot(x, sizes(error) if decades else error, color=color, label=name, **style)
    percent = "error [% of θmax]" if swings else "error [rad]"
    if decades:
        logarithmic(axes, errors, 2 * room)
        percent = "|error| [% of θmax]" if swings else "|error| [rad]"
    else:
        within(axes, -room, room)
        axes.axhline(0.0, color=BLACK, lw=0.8)
    axes.set_ylabel(say.word(percent).replace("θmax", r"$\theta_\mathrm{max}$"))
    axes.set_xlim(0.0, part[-1])


def abscissa(pendulum: Any, solutions: Any, periods: float, say: Language) -> str:
    """What the axis of time says."""
    part, t = grid(pendulum, periods)
    text = "t / T"
    if part[-1] < periods:
        words = "{axis}, the first {shown} of {all} periods"
        text = say.word(words, axis=text, shown=say.number(part[-1]), all=say.number(periods))
    if any(np.isnan(solution.theta(t)).any() for _, solution in solutions if not hasattr(solution, "instants")):
        text = say.word("{axis}; hatched: undefined", axis=text)
    return text


def within(axes: Any, low: float, high: float) -> None:
    """Keeps the limits that the curves ask for within others."""
    bottom, top = axes.get_ylim()
    axes.set_ylim(max(bottom, low), min(top, high))


def hatch(axes: Any, part: np.ndarray, gap: np.ndarray, color: str, row: int) -> None:
    """Where an approximation is undefined, in a strip of its own."""
    low = 0.02 + 0.06 * row
    strip = {"facecolor": "none", "edgecolor": color, "hatch": "//////", "lw": 0.6}
    axes.fill_between(part, low, low + 0.045, where=gap, transform=axes.get_xaxis_transform(), **strip)
