"""What a notebook shows of a nonlinear spring: its potential with the energy of the motion, its equation, regime and ends."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .._number_text import number_text as number
from ._card import SIDE, page, svg
from ._potential import coefficients, equilibria, potential, reach, scaled

BOTTOM, MARGIN = 112.0, 12.0
EQUATIONS = {
    ("p", "q"): ("Duffing oscillator", "u″ + p u + q u³ = 0"),
    ("p", "q", "r", "c"): ("Duffing oscillator", "u″ + p u + r u² + q u³ = c"),
    ("p", "q", "s"): ("Cubic-quintic oscillator", "u″ + p u + q u³ + s u⁵ = 0"),
}


def oscillator_card(oscillator: Any) -> str:
    """The HTML of an oscillator."""
    name, equation = EQUATIONS[tuple(letter for letter, _ in coefficients(oscillator))]
    heading = f"{name}: {oscillator.regime}"
    start = f"u(0) = {number(oscillator.u0)}, u′(0) = {number(oscillator.velocity0)}"
    given = ", ".join(f"{letter} = {number(value)}" for letter, value in coefficients(oscillator))
    lines = [heading, equation, given, start, *ends(oscillator)]
    return page(drawing(oscillator, heading), lines)


def ends(oscillator: Any) -> list[str]:
    """The period and the range, or when it escapes."""
    found = []
    if math.isfinite(oscillator.period):
        period, (low, high) = number(oscillator.period), map(number, oscillator.range)
        swings = f"period {period} s, u from {low} to {high}"
        found.append(swings if low != high else f"small swings would take {period} s")
    before, after = oscillator.escape_time_backward, oscillator.escape_time
    if math.isfinite(after):
        found.append(f"escapes to infinity at t = {number(after)} s")
    if math.isfinite(before):
        found.append(f"came from infinity at t = {number(before)} s")
    return found


def drawing(oscillator: Any, heading: str) -> str:
    """The potential, the energy over the displacements that the motion reaches, and the start."""
    width = reach(oscillator)
    stiffness, rate = scaled(oscillator, width)
    grid = np.linspace(-1.0, 1.0, 121)
    with np.errstate(all="ignore"):
        depth = np.asarray(potential(stiffness, grid), dtype=float)
        start = oscillator.u0 / width
        own = (oscillator.velocity0 / width / rate) ** 2 / 2 + float(potential(stiffness, start))
        levels = [own, 0.0, *(float(potential(stiffness, u / width)) for u in equilibria(oscillator))]
    low, high = min(levels), max(levels)
    # Some room above and below the energies that matter; steep walls leave the picture.
    room = 0.5 * (high - low) or float(np.ptp(depth)) or 1.0
    low, high = max(low - room, float(depth.min())), min(high + room, max(float(depth.max()), own + 0.2 * room))
    high = high if high > low else low + 1.0

    def place(x: float, energy: float) -> tuple[float, float]:
        return SIDE / 2 + 0.46 * SIDE * x, BOTTOM - MARGIN - (BOTTOM - 2 * MARGIN) * (energy - low) / (high - low)

    inside = [(x, v) for x, v in zip(grid, depth, strict=True) if low - 0.05 * room <= v <= high]
    left, right = (max(-1.0, min(1.0, end / width)) for end in oscillator.range)
    (from_x, level), (to_x, _) = place(left, own), place(right, own)
    ball_x, ball_y = place(start, float(potential(stiffness, start)))
    parts = [
        f'<path d="{path([place(x, v) for x, v in inside])}"/>',
        f'<path d="M{from_x:.1f} {level:.1f}H{to_x:.1f}" stroke-dasharray="1 4" stroke-width="1.6"/>',
        f'<circle cx="{ball_x:.1f}" cy="{ball_y - 6:.1f}" r="6" fill="currentColor"/>',
    ]
    return svg(0.0, BOTTOM, f"{heading}: potential, energy and start", parts)


def path(points: list[tuple[float, float]]) -> str:
    """A line through points; a gap where some between them have left the picture."""
    step = 2.5 * 0.46 * SIDE / 60
    words, last = [], -math.inf
    for x, y in points:
        words.append(f"{'M' if x - last > step else 'L'}{x:.1f} {y:.1f}")
        last = x
    return "".join(words)
