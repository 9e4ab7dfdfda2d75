"""Picture of the period against the turning angle: every formula beside the exact one, and its error."""

import math
from typing import Any

import numpy as np

from ..approx import period
from ..approx._period import listed
from ._style import BLACK, head, quiet, save_figure

# One curve under two names is drawn once.
SAME = {"belendez": " = agm:2"}
# Two hues for every family, told apart by dashes.
COLOURS = ("#1f5fa8", "#c0392b", "#2e7d32", "#8e44ad", "#b9770e", "#0e7c7b", "#6d4c41", "#546e7a")
DASHES = ("solid", (0, (5, 2)), (0, (1, 1.2)))
ANGLES = 1200
# A double shows no smaller error of a ratio.
LEAST = 1e-16
# A curve is shaded to this factor on both sides.
WIDE = 2.5


def plot_periods(path: Any, *, theta_max: float | None = None, form: str | None = None) -> None:
    """Draw T/T0 against the turning angle by every formula, and below the size of its relative error.

    Where an author states a range, the error of the formula is shaded over it.

    Parameters
    ----------
    path : str, path or binary file
        Where to save.
    theta_max : float, optional
        A turning angle in rad to be marked.
    form : str, optional
        `png` or `svg`; by default the ending of `path`.

    Raises
    ------
    ImportError
        If matplotlib is missing.

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration.plot import plot_periods
    >>> picture = BytesIO()
    >>> plot_periods(picture, theta_max=2.6, form="png")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    save_figure({form: path}, (11, 8), lambda figure: draw_periods(figure, theta_max))


def draw_periods(figure: Any, theta_max: float | None) -> None:
    """Both panels and the legend beside them."""
    # Denser towards the top, where the period runs away.
    degrees = 180 * np.sin(np.linspace(0, math.pi / 2, ANGLES + 2)[1:-1])
    angles = np.radians(degrees)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(1, 1.6))
    upper.plot(degrees, period("exact").ratio(angles), color=BLACK, lw=2.2, label="exact", zorder=5)
    for number, formula in enumerate(formula for formula in listed() if formula.name != "agm:2"):
        color, dash = COLOURS[number % len(COLOURS)], DASHES[number // len(COLOURS) % len(DASHES)]
        label = formula.name + SAME.get(formula.name, "")
        upper.plot(degrees, formula.ratio(angles), color=color, ls=dash, lw=1.2, label=label)
        error = np.abs(formula.error(angles))
        lower.plot(degrees, error, color=color, ls=dash, lw=1.4)
        if formula.stated_range:
            low, high = np.degrees(formula.stated_range)
            inside = (low <= degrees) & (degrees <= high)
            lower.fill_between(degrees, error / WIDE, error * WIDE, where=inside, color=color, alpha=0.2, lw=0)
    for axes in (upper, lower):
        if theta_max is not None:
            axes.axvline(math.degrees(theta_max), color="#777777", lw=1, ls=(0, (2, 2)))
        quiet(axes)
    upper.set(ylim=(0.9, 4.0), ylabel=r"$T / T_0$")
    lower.set(yscale="log", ylim=(LEAST, 3.0), xlim=(0, 180), ylabel="|relative error|")
    lower.set_xlabel(r"$\theta_{max}$ [degrees]; shaded: the range that the author states")
    lower.set_xticks(range(0, 181, 15))
    figure.legend(*upper.get_legend_handles_labels(), loc="outside right center", frameon=False, fontsize=9.5)
    head(figure, "Period of a pendulum against its turning angle")
