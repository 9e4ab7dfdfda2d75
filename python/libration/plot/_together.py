"""Several records together: omega0 of each beside their mean, the line of the lengths, or that of a reversible pendulum."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .._scalars import shown
from ._axes import given_or_new, named
from ._language import ENGLISH, Language
from ._style import BLACK, EXACT, SEPARATRIX, head, legend, quiet, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plot_together(
    found: Any, path: Any, *, form: str | None = None, title: str | None = None, dpi: float = 100, lang: str = "en"
) -> None:
    """Draw what records share and save the picture. Into axes of your own: `Together.plot`.

    Parameters
    ----------
    found : Together
        What `libration.fit_together` has found.
    path : str, path or binary file
        Where to save.
    form : str, optional
        `png` or `svg`; by default the ending of `path`.
    title : str, optional
        The line above the picture; by default it says the result. An empty one leaves it out.
    dpi : scalar, default 100
        Dots per inch of a PNG of 9 by 6.5 inches, from 20 to 1200.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If `found` is no Together, or `dpi`, `form` or `lang` is none of those.

    Examples
    --------
    >>> from io import BytesIO
    >>> import libration
    >>> from libration.plot import plot_together
    >>> first = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
    >>> second = [0.3, 0.7, 1.1, 1.5], [2.0181, 2.0683, 2.1684, 2.3321]
    >>> found = libration.fit_together([first, second], quantity="swings")
    >>> picture = BytesIO()
    >>> plot_together(found, picture, form="png", lang="es")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    if not hasattr(found, "chi_squared"):
        raise ValueError(f"found = {shown(found)}: must be a Together, which libration.fit_together makes")
    say = Language(lang)

    def draw(figure: Any) -> None:
        draw_together(figure, found, say)
        head(figure, headline(found, say) if title is None else title)

    save_figure({form: path}, (9, 6.5), draw, dpi=dpi)


def headline(found: Any, say: Language = ENGLISH) -> str:
    """The result in one line."""
    if not found.stands:
        return say.word("Not a result: a verdict speaks against it")
    parts = [] if found.omega0 is None else [f"$\\omega_0$ = {found.omega0} rad/s"]
    parts += [] if found.g is None else [f"$g$ = {found.g} m/s²"]
    return say.decimal("; ".join(parts))


def together_axes(found: Any, ax: Any, lang: str) -> Axes:
    """Draw into axes of the user, or into a new figure; return them."""
    say = Language(lang)
    axes, new = given_or_new(ax, (7.5, 4.6))
    draw_shared(axes, found, say)
    say.ticks(axes)
    named(axes, new)
    return axes


def draw_together(figure: Any, found: Any, say: Language) -> None:
    """What is shared; below it what the lengths leave."""
    if found.kind == "lengths":
        upper, lower = figure.subplots(2, 1, height_ratios=(1.7, 1), sharex=True)
    else:
        upper, lower = figure.subplots(), None
    for axes in filter(None, (upper, lower)):
        quiet(axes)
    draw_shared(upper, found, say)
    if lower is not None:
        upper.set_xlabel("")
        draw_length_residuals(lower, found, say)
        say.ticks(lower)
    say.ticks(upper)
    legend(upper)


def draw_shared(axes: Any, found: Any, say: Language) -> None:
    """The records as dots with their uncertainties, and what they share."""
    {"runs": draw_runs, "lengths": draw_lengths, "reversible": draw_reversible}[found.kind](axes, found, say)


def dots(axes: Any, x: Any, y: Any, xu: Any, yu: Any, label: str) -> None:
    """Values with their standard uncertainties."""
    axes.errorbar(
        x, y, xerr=xu, yerr=yu, fmt="o", ms=5, mew=0, color=SEPARATRIX, elinewidth=1.2, capsize=2.5, label=label, zorder=3
    )  # fmt: skip


def draw_runs(axes: Any, found: Any, say: Language) -> None:
    """omega0 of each record, and their mean with its uncertainty."""
    from matplotlib.ticker import MaxNLocator

    numbers = np.arange(1, len(found.fits) + 1)
    values = np.array([each.omega0.value for each in found.fits])
    dots(axes, numbers, values, None, [each.omega0.u for each in found.fits], say.word("measured"))
    mean = found.omega0
    axes.axhline(mean.value, color=EXACT, lw=1.4, label=say.word("together"))
    axes.axhspan(mean.value - mean.u, mean.value + mean.u, color=EXACT, alpha=0.15, lw=0)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_xlim(0.5, len(found.fits) + 0.5)
    axes.ticklabel_format(axis="y", useOffset=False)
    axes.set_xlabel(say.word("record"))
    axes.set_ylabel("$\\omega_0$ [rad/s]")


def lengths_of(found: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Lengths and 1/omega0**2 with their uncertainties."""
    lengths, u = np.array(found._apart.lengths).T
    squares = np.array([each.omega0.value**-2 for each in found.fits])
    return lengths, u, squares, 2 * squares * np.array([each.omega0.u / each.omega0.value for each in found.fits])


def missing(found: Any) -> float:
    """What is missing in each length, in m."""
    return 0.0 if found.length_offset is None else float(found.length_offset.value)


def draw_lengths(axes: Any, found: Any, say: Language) -> None:
    """1/omega0**2 against the length, with the line whose slope is 1/g."""
    lengths, u, squares, v = lengths_of(found)
    dots(axes, lengths, squares, u, v, say.word("measured"))
    ends = np.array([min(0.0, -missing(found)), 1.05 * lengths.max()])
    axes.plot(ends, (ends + missing(found)) / found.g.value, color=EXACT, lw=1.4, label=say.word("fitted"), zorder=2)
    axes.set_xlabel(say.word("length ℓ [m]"))
    axes.set_ylabel("1/$\\omega_0^2$ [s²]")


def draw_length_residuals(axes: Any, found: Any, say: Language) -> None:
    """The length that each omega0 asks for, less the stated one, in mm."""
    lengths, u, squares, v = lengths_of(found)
    left = 1e3 * (found.g.value * squares - missing(found) - lengths)
    dots(axes, lengths, left, None, 1e3 * np.hypot(u, found.g.value * v), say.word("measured"))
    axes.axhline(0.0, color=BLACK, lw=0.8)
    axes.set_xlabel(say.word("length ℓ [m]"))
    axes.set_ylabel(say.word("residual [{unit}]", unit="mm"))


def draw_reversible(axes: Any, found: Any, say: Language) -> None:
    """T**2 d against d**2, d the distance from the centre of mass: a line whose slope is 4 pi**2/g."""
    apart = found._apart
    first = apart.pivots[0][0]
    second = apart.between[0] - first if apart.between is not None else apart.pivots[1][0]
    distances = np.array([first, second])
    periods = np.array([2 * math.pi / each.omega0.value for each in found.fits])
    dots(axes, distances**2, periods**2 * distances, None, None, say.word("measured"))
    slope = 4 * math.pi**2 / found.g.value
    ends = np.array([0.0, 1.1 * float((distances**2).max())])
    left = periods[0] ** 2 * first - slope * first**2
    axes.plot(ends, left + slope * ends, color=EXACT, lw=1.4, label=say.word("slope 4π²/g"), zorder=2)
    axes.set_xlabel("$d^2$ [m²]")
    axes.set_ylabel("$T^2 d$ [s² m]")
