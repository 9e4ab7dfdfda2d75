"""Errata of Salas 2019, from (25) on: periods that are a quarter of the period, and ranges that do not hold."""

import functools
import math
from collections.abc import Callable

import numpy as np

from ... import approx
from ...elliptic import complete_k
from ...pendulum import Pendulum
from .._erratum import Erratum, Kind, largest

# Librations: theta0 and omega0.
LIBRATIONS = ((0.4, 1.0), (1.0, 3.0), (2.5, 0.5))


def measured_period(swing: Pendulum) -> float:
    """The period as the time from a turning point to the second one after it."""
    first, _, second = swing.turning_times(0.0, 1.2 * swing.period)[:3]
    return float(second - first)


def libration_residual(period: Callable[[float, float], float]) -> float:
    """The largest relative error of period(m, omega0); the reference is the time between turning points."""
    found = []
    for theta0, omega0 in LIBRATIONS:
        swing = Pendulum(theta0, omega0=omega0)
        found.append(period(swing.energy_ratio, omega0) / measured_period(swing) - 1)
    return largest(found)


def rotation_residual(period: Callable[[float, float], float]) -> float:
    """The largest difference from one whole turn after period(m, omega0), rad."""
    found = []
    for velocity0 in (2.1, 3.0, 9.0):
        wheel = Pendulum(1.0, velocity0)
        found.append(wheel.theta(period(wheel.energy_ratio, 1.0)) - 1.0 - math.tau)
    return largest(found)


def range_residual(bound: float, period: Callable[[float], float]) -> float:
    """The largest relative error of omega0 T = period(m) for 0 < m <= bound; the reference is the motion."""
    found = []
    for m in bound * np.linspace(0.05, 1.0, 20):
        found.append(period(m) / measured_period(Pendulum(2 * math.asin(math.sqrt(m)))) - 1)
    return largest(found)


def pade_row(number: int, bound: float, percent: float, text: str) -> Erratum[Callable[[float], float]]:
    """The row of (26), (27) or (28), whose printed factor gives a quarter of the period."""
    ratio = approx.period(f"salas-{number}").ratio
    return SALAS(
        f"({number})",
        "T = (π/2) √(l/g) …",
        "T = 2π √(l/g) …",
        "The rational function is right (a Padé approximant of 2K/π); the prefactor makes it a quarter of the period.",
        Kind.PAPER,
        f"largest relative error for 0 < m ≤ {text}",
        percent / 100,
        lambda period: range_residual(bound, period),
        lambda m: np.pi / 2 * ratio(m=m),
        lambda m: 2 * np.pi * ratio(m=m),
    )


def bound_residual(bound: float) -> float:
    """The largest relative error of (28), as a whole period, for |m| < bound."""
    m = bound * (1 - np.geomspace(1e-9, 1.0, 200))
    formula = approx.period("salas-28")
    return largest([formula.error(m=m), formula.error(m=-m)])


def small_m_residual(bound: float) -> float:
    """The largest error of the formula before fig. 6 over one period, released at rest with m = bound, over theta0."""
    return approx.angle("small-m").of(Pendulum(2 * math.asin(math.sqrt(bound)))).error(1).relative


SALAS = functools.partial(Erratum, "Salas 2019")
ERRATA = (
    SALAS(
        "(25)",
        "T = K(m)/ω",
        "T = 4K(m)/ω",
        "K(m)/ω is a quarter of the period of a libration.",
        Kind.PAPER,
        "largest relative error beside the time between turning points",
        1e-14,
        libration_residual,
        lambda m, omega0: complete_k(m=m) / omega0,
        lambda m, omega0: 4 * complete_k(m=m) / omega0,
    ),
    SALAS(
        "(25), m > 1",
        "T = K(m)/ω",
        "T = 2K(1/m)/(ω√m), one turn",
        "K has no real value for m > 1, where the pendulum turns over the top.",
        Kind.PAPER,
        "miss of a whole turn after T, rad",
        1e-13,
        rotation_residual,
        lambda m, omega0: complete_k(m=m) / omega0,
        lambda m, omega0: 2 * complete_k(m=1 / m) / (omega0 * np.sqrt(m)),
    ),
    pade_row(26, 1 / 3, 0.12, "1/3"),
    pade_row(27, 0.75, 0.43, "3/4"),
    pade_row(28, 0.75, 0.05, "3/4"),
    SALAS(
        "(28), range",
        "for |m| < 1",
        "for |m| ≤ 0.90",
        "K grows beyond every bound as m goes to 1, and (28) is finite there. Below 0.90 it keeps to 1 %.",
        Kind.PAPER,
        "largest relative error of the period in the range, up to 10⁻⁹ from its end",
        0.01,
        bound_residual,
        1.0,
        0.90,
    ),
    SALAS(
        "conclusions",
        "trigonometric approximations are good for |m| < 0.2",
        "to 1 % of φ₀ over one period for |m| ≤ 0.08",
        "The error of the formula before fig. 6 grows as m² φ₀, and with time.",
        Kind.PAPER,
        "largest error over one period from rest at the end of the range, over φ₀",
        0.01,
        small_m_residual,
        0.2,
        0.08,
    ),
)
