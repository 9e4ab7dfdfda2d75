"""The displacement of a nonlinear spring over time, as far as it is in a picture."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._axes import given_or_new
from ._language import Language
from ._potential import FAR, reach, scaled
from ._style import EXACT, finite, first_swings

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def motion_axes(oscillator: Any, t: Any, ax: Axes | None, lang: str) -> Axes:
    """u(t) in axes: two periods from t = 0, or what there is of the motion, if no instants are given."""
    say = Language(lang)
    axes, new = given_or_new(ax)
    if t is None:
        swings = (
            2 * oscillator.period if math.isfinite(oscillator.period) else 10 / scaled(oscillator, reach(oscillator))[1]
        )
        start = 0.0 if math.isfinite(oscillator.period) else max(oscillator.escape_time_backward, -swings)
        t = np.array([start, min(oscillator.escape_time, swings)])
    fine, u = seen(oscillator, *extremes(finite(t)))
    axes.plot(fine, u, color=EXACT if new else None, lw=2)
    axes.set_xlabel("t [s]")
    axes.set_ylabel("u")
    say.ticks(axes)
    return axes


def extremes(t: np.ndarray) -> tuple[float, float]:
    """The first and the last instant; from 0 where there is one only."""
    first, last = float(t.min()), float(t.max())
    return (first, last) if first < last else (min(0.0, first), max(0.0, first))


def seen(oscillator: Any, first: float, last: float) -> tuple[np.ndarray, np.ndarray]:
    """Instants and displacements to draw: of many swings the first, of a motion that runs away what is not too far."""
    if math.isfinite(oscillator.period):
        last = first_swings(first, last, oscillator.period)
    far = FAR * reach(oscillator) / 2
    while True:
        fine = np.linspace(first, last, 4000)
        if first < 0 < last:
            fine = np.sort(np.append(fine, 0.0))
        u = oscillator.u(fine)
        u = np.where(np.abs(u) < far, u, np.nan)
        inside = np.flatnonzero(np.isfinite(u))
        if not inside.size or np.ptp(inside) > fine.size / 5:
            return fine, u
        # Some room on both sides of what is seen, for the escape that ends it.
        room = 2 + np.ptp(inside) // 4
        closer = fine[max(inside[0] - room, 0)], fine[min(inside[-1] + room, fine.size - 1)]
        if closer == (first, last):
            return fine, u
        first, last = closer
