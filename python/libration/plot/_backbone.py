"""The backbone curve of a Duffing oscillator: how its frequency changes with the displacement that it is released from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..oscillator import duffing_frequency
from ._axes import given_or_new
from ._language import Language
from ._style import EXACT, head, quiet, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes


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


def save_backbone(
    u0: np.ndarray, frequency: np.ndarray, unit: str, path: Any, *, form: str, title: str | None, dpi: float, lang: str
) -> None:
    """Save the picture of displacements over frequencies in Hz."""
    say = Language(lang)

    def draw(figure: Any) -> None:
        axes = figure.subplots()
        axes.plot(frequency, u0, color=EXACT, lw=2)
        axes.set_xlabel(r"$\Omega/2\pi$ [Hz]")
        axes.set_ylabel(f"u(0) [{unit}]" if unit else "u(0)")
        quiet(axes)
        say.ticks(axes)
        head(figure, title or "")

    save_figure({form: path}, (7, 5), draw, dpi=dpi)
