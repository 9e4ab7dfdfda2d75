"""The potential of a nonlinear spring, its equilibria, and the part of it that a picture shows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

# Displacements of an escape are drawn up to this multiple of where it starts or turns.
FAR = 4.0


def coefficients(oscillator: Any) -> list[tuple[str, float]]:
    """The coefficients of the force by their letters; even powers only where they are there."""
    given = oscillator._arguments()[1]
    return [(name, given[name]) for name in oscillator._names if name in given]


def reach(oscillator: Any) -> float:
    """Half the width of the picture: the orbit if it is bounded, else some way on its way out."""
    marks = [abs(oscillator.u0), *(abs(end) for end in oscillator.range if math.isfinite(end))]
    marks += [abs(each) for each in equilibria(oscillator)]
    widest = max(marks, default=0.0) or 1.0
    bounded = all(math.isfinite(end) for end in oscillator.range)
    return (1.25 if bounded else FAR / 2) * widest


def polynomial(oscillator: Any) -> list[float]:
    """Coefficients of the powers of u, from that of 1, in u'' + them = 0."""
    powers = {"c": (0, -1.0), "p": (1, 1.0), "r": (2, 1.0), "q": (3, 1.0), "s": (5, 1.0)}
    found = [0.0] * 6
    for name in oscillator._names:
        power, sign = powers[name]
        found[power] = sign * getattr(oscillator, name)
    while len(found) > 2 and not found[-1]:
        found.pop()
    return found


def equilibria(oscillator: Any) -> list[float]:
    """Displacements other than 0 at which the force is 0."""
    force = polynomial(oscillator)
    if not any(force[2:]) and not force[0]:
        return []
    places = np.roots(force[::-1])
    return [u.real for u in places if abs(u.imag) < 1e-9 * abs(u) and u.real != 0.0]


def potential(force: list[float], x: Any) -> Any:
    """Energy at rest at x."""
    return sum((c * x ** (k + 1) / (k + 1) for k, c in enumerate(force) if c), 0.0 * x)


def barriers(force: list[float], resting: list[float]) -> list[float]:
    """Energies at rest on the unstable equilibria, rising: those of the separatrices."""
    least = 1e-9 * max(map(abs, force))
    tops = [
        x
        for x in resting
        if abs(sum(c * x**k for k, c in enumerate(force))) <= least
        and sum(k * c * x ** (k - 1) for k, c in enumerate(force) if k) < 0
    ]
    return sorted({float(potential(force, x)) for x in tops})


def scaled(oscillator: Any, width: float) -> tuple[list[float], float]:
    """Coefficients of the force where u counts in half widths and the largest of them is 1, and the rate that it stands for."""
    force = [c * width ** (k - 1) for k, c in enumerate(polynomial(oscillator))]
    pull = max(map(abs, force))
    if not pull:
        return force, abs(oscillator.velocity0) / width or 1.0
    return [c / pull for c in force], math.sqrt(pull)
