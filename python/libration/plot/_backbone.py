"""The backbone curve of a Duffing oscillator: how its frequency changes with the displacement that it is released from."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ..oscillator import duffing_frequency
from ._axes import given_or_new
from ._language import Language
from ._style import EXACT, head, quiet, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: As many starts or fewer have a dot each.
FEW = 60


def plot_backbone(
    u0: Any, *, p: float, q: float, r: float = 0.0, c: float = 0.0, ax: Axes | None = None, lang: str = "en"
) -> Axes:
    """Draw the displacement `u0` of a release from rest over the frequency of its motion.

    Parameters
    ----------
    u0 : array_like
        Displacements; those whose motion does not stay have a gap.
    p, q, r, c : scalar
        As for `libration.Duffing`.
    ax : Axes, optional
        Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language, with its decimal sign.

    Returns
    -------
    Axes
        Those drawn into; the frequency is in rad/s.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If `ax` or `lang` is none of those.

    Examples
    --------
    >>> import numpy as np
    >>> from matplotlib.figure import Figure
    >>> from libration.plot import plot_backbone
    >>> ax = plot_backbone(np.linspace(0.0, 2.0, 10000), p=1.0, q=0.2, r=0.5, ax=Figure().subplots())
    >>> len(ax.lines[0].get_xdata())
    10000
    """
    say = Language(lang)
    axes, new = given_or_new(ax)
    amplitudes = np.asarray(u0, dtype=float)
    frequency = duffing_frequency(amplitudes, p=p, q=q, r=r, c=c)
    axes.plot(frequency, amplitudes, color=EXACT if new else None, lw=2)
    axes.set_xlabel(r"$\Omega$ [rad/s]")
    axes.set_ylabel("u(0)")
    say.ticks(axes)
    return axes


PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}


def scaled(unit: str, values: np.ndarray) -> tuple[float, str]:
    """What to divide values by, and the unit with its prefix, so that the largest is from 1 to 1000; a number keeps its size."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    if not unit or not 0.0 < largest < math.inf:
        return 1.0, unit
    power = min(max(3 * math.floor(math.log10(largest) / 3), min(PREFIXES)), max(PREFIXES))
    return 10.0**power, PREFIXES[power] + unit


def save_backbone(
    curve: tuple[np.ndarray, np.ndarray],
    starts: tuple[np.ndarray, np.ndarray],
    unit: str,
    path: Any,
    *,
    form: str,
    title: str | None,
    dpi: float,
    lang: str,
) -> None:
    """Save the picture of a curve of frequencies in Hz and displacements, with dots at the starts where these are few."""
    say = Language(lang)
    across, hertz = scaled("Hz", curve[0]) if unit else (1.0, "Hz")
    up, length = scaled(unit, curve[1])

    def draw(figure: Any) -> None:
        axes = figure.subplots()
        axes.plot(curve[0] / across, curve[1] / up, color=EXACT, lw=2)
        if starts[0].size <= FEW:
            axes.plot(starts[0] / across, starts[1] / up, "o", color=EXACT, ms=4)
        axes.set_xlabel(rf"$\Omega/2\pi$ [{hertz}]")
        axes.set_ylabel(f"u(0) [{length}]" if length else "u(0)")
        quiet(axes)
        say.ticks(axes)
        head(figure, title or "")

    save_figure({form: path}, (7, 5), draw, dpi=dpi)
