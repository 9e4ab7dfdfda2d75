"""Pictures of approximations: the angle over time above their errors, as Lima draws them."""

import math
from typing import Any

import numpy as np

from ..pendulum import Pendulum
from ._style import BLACK, DASHED, DOTTED, EXACT, SEPARATRIX, head, legend, number, quiet, save_figure

# Colour and dash: told apart in grey too; the first two are those of the papers' figures.
STYLES = (
    (SEPARATRIX, DOTTED),
    (EXACT, DASHED),
    ("#2e7d32", (0, (6, 2, 1, 2))),
    ("#8e44ad", (0, (3, 1))),
    ("#b9770e", (0, (8, 2))),
    ("#0e7c7b", (0, (2, 2))),
)
INSTANTS = 2000
# More periods than this would be a solid band: the first are drawn.
SHOWN_PERIODS = 12


def plot_comparison(
    pendulum: Pendulum, solutions: Any, path: Any, *, periods: float = 1.0, form: str | None = None
) -> None:
    """Draw approximations beside the exact angle, and below their errors in percent of the turning angle.

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
        `png` or `svg`; by default the ending of `path`.

    Raises
    ------
    ImportError
        If matplotlib is missing.

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
    save_figure({form: path}, (9, 6.5), lambda figure: draw_comparison(figure, pendulum, solutions, periods))


def draw_comparison(figure: Any, pendulum: Pendulum, solutions: Any, periods: float) -> None:
    """Both panels, over time in periods."""
    shown = min(periods, SHOWN_PERIODS)
    part = np.linspace(0.0, shown, INSTANTS + 1)
    t = part * pendulum.period
    exact = pendulum.theta(t)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(1.5, 1))
    upper.plot(part, exact, color=BLACK, lw=1.8, label="exact")
    swings = math.isfinite(pendulum.theta_max)
    gaps = 0
    for number_of, (name, solution) in enumerate(solutions):
        color, dash = style(number_of)
        theta = solution.theta(t)
        gap = np.isnan(theta)
        upper.plot(part, theta, color=color, ls=dash, lw=1.6, label=name)
        # The approximations know their error beyond the rounding of the angle.
        error = solution.difference(t) if hasattr(solution, "difference") else theta - exact
        lower.plot(part, 100 * error / pendulum.theta_max if swings else error, color=color, ls=dash, lw=1.6)
        if gap.any():
            hatch(upper, part, gap, color, gaps)
            gaps += 1
    # What runs away leaves the picture, so that the others can be told apart.
    room = 0.5 * np.ptp(exact)
    within(upper, exact.min() - room, exact.max() + room)
    within(lower, *((-100 * room / pendulum.theta_max, 100 * room / pendulum.theta_max) if swings else (-room, room)))
    upper.set_ylabel(r"$\theta$ [rad]")
    lower.set_ylabel(r"error [% of $\theta_{max}$]" if swings else "error [rad]")
    lower.axhline(0.0, color=BLACK, lw=0.8)
    lower.set_xlim(0.0, shown)
    span = "" if shown == periods else f", the first {shown} of {periods:.6g} periods"
    lower.set_xlabel(f"t / T{span}{'; hatched: undefined' if gaps else ''}")
    for axes in (upper, lower):
        quiet(axes)
    legend(upper)
    state = rf"$\theta_0$ = {number(math.degrees(pendulum.theta0), 7)}°"
    if pendulum.velocity0:
        state += rf", $\dot\theta_0$ = {number(pendulum.velocity0)} rad/s"
    head(figure, f"{state}: {pendulum.regime}, T = {number(pendulum.period)} s")


def within(axes: Any, low: float, high: float) -> None:
    """Keeps the limits that the curves ask for within others."""
    bottom, top = axes.get_ylim()
    axes.set_ylim(max(bottom, low), min(top, high))


def style(number_of: int) -> tuple[str, Any]:
    """Colour and dash of a curve: the first six are told apart in grey too, and no two of thirty-six are alike."""
    color, _ = STYLES[number_of % len(STYLES)]
    _, dash = STYLES[(number_of + number_of // len(STYLES)) % len(STYLES)]
    return color, dash


def hatch(axes: Any, part: np.ndarray, gap: np.ndarray, color: str, row: int) -> None:
    """Where an approximation is undefined, in a strip of its own."""
    low = 0.02 + 0.06 * row
    strip = {"facecolor": "none", "edgecolor": color, "hatch": "//////", "lw": 0.6}
    axes.fill_between(part, low, low + 0.045, where=gap, transform=axes.get_xaxis_transform(), **strip)
