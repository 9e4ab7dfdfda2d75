"""The potential of a nonlinear spring, its equilibria, and the part of it that a picture shows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

# Displacements of an escape are drawn up to this multiple of where it starts or turns.
FAR = 4.0
LETTERS = {"alpha": "α", "beta": "β", "gamma": "γ"}


def coefficients(oscillator: Any) -> list[tuple[str, float]]:
    """The coefficients of the force by their letters."""
    return [(LETTERS.get(name, name), getattr(oscillator, name)) for name in oscillator._names]


def reach(oscillator: Any) -> float:
    """Half the width of the picture: the orbit if it is bounded, else some way on its way out."""
    marks = [abs(oscillator.u0), *(abs(end) for end in oscillator.range if math.isfinite(end))]
    marks += [abs(each) for each in equilibria(oscillator)]
    widest = max(marks, default=0.0) or 1.0
    bounded = all(math.isfinite(end) for end in oscillator.range)
    return (1.25 if bounded else FAR / 2) * widest


def polynomial(oscillator: Any) -> list[float]:
    """Coefficients of the force over u, rising powers of u**2."""
    return [getattr(oscillator, name) for name in oscillator._names]


def equilibria(oscillator: Any) -> list[float]:
    """Displacements other than 0 at which the force is 0."""
    squares = np.roots(polynomial(oscillator)[::-1]) if any(polynomial(oscillator)[1:]) else np.empty(0)
    return [sign * math.sqrt(s.real) for s in squares if abs(s.imag) < 1e-9 * abs(s) and s.real > 0 for sign in (-1, 1)]


def potential(stiffness: list[float], x: Any) -> Any:
    """Energy at rest at x."""
    return sum(c * x ** (2 * k + 2) / (2 * k + 2) for k, c in enumerate(stiffness))


def barriers(stiffness: list[float], resting: list[float]) -> list[float]:
    """Energies at rest on the unstable equilibria, rising: those of the separatrices."""
    tops = [x for x in resting if sum((2 * k + 1) * c * x ** (2 * k) for k, c in enumerate(stiffness)) < 0]
    return sorted({float(potential(stiffness, x)) for x in tops})


def scaled(oscillator: Any, width: float) -> tuple[list[float], float]:
    """Coefficients of the force where u counts in half widths and the largest of them is 1, and the rate that it stands for."""
    stiffness = [c * width ** (2 * k) for k, c in enumerate(polynomial(oscillator))]
    pull = max(map(abs, stiffness))
    if not pull:
        return stiffness, abs(oscillator.velocity0) / width or 1.0
    return [c / pull for c in stiffness], math.sqrt(pull)
