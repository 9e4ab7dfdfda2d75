"""Errata of Lima 2019."""

import functools
from collections.abc import Callable

import numpy as np

from ... import approx
from ..._arrays import Floats
from ...elliptic import complete_k, jacobi, sn
from ...pendulum import Pendulum, theta
from .._erratum import (
    Erratum,
    Kind,
    Motion,
    duffing_force,
    largest,
    motion_residual,
    pendulum_residual,
    second_derivative,
)

INSTANTS = np.linspace(0.1, 3.0, 30)
RELEASES = ((0.3, 0.0), (1.0, 0.0), (2.5, 0.0))
# Bisections of a threshold: 40 halvings of pi leave 3e-12 rad.
HALVINGS = 40


def balance_residual(balance: Callable[[Floats, Floats], Floats]) -> float:
    """Lima (1): the largest difference of its two sides along a motion."""

    def motion(t: Floats) -> Floats:
        return theta(t, 1.0)

    return largest(balance(motion(INSTANTS), second_derivative(motion, INSTANTS)))


def solution_residual(solution: Callable[[float], tuple[Motion, float]]) -> float:
    """Lima (14): the largest residual of z(t), k = solution(constant) for several values of the free constant."""
    found = []
    for constant in (0.3, 0.5, 0.9):
        z, k = solution(constant)
        found.append(motion_residual(z, duffing_force(1 + k**2, -2 * k**2), INSTANTS))
    return largest(found)


def released(function: Callable[[Floats, float], Floats], t: Floats, theta0: float, velocity0: float) -> Floats:
    """Lima (16) with a sine or with sn."""
    k = np.sin(theta0 / 2)
    angle: Floats = 2 * np.arcsin(k * function(t + complete_k(k=k), k))
    return angle


def fourier(order: int, theta0: float) -> approx.AngleApproximation:
    """Lima (22) for a release from rest."""
    return approx.angle(f"fourier:{order}").of(Pendulum(theta0))


def finite_at_0(order: int, theta0: float) -> bool:
    """Whether Lima (22) has a value at t = 0."""
    return bool(np.isfinite(fourier(order, theta0).theta(0.0)))


@functools.cache
def highest(order: int) -> float:
    """The turning angle up to which Lima (22) with an odd number of terms has a value at t = 0, rad."""
    low, high = 0.0, np.pi
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if finite_at_0(order, middle) else (low, middle)
    return low


def range_residual(upper: Callable[[int], float]) -> float:
    """The number of N among 1, 3, 5, 7 for which Lima (22) has no value at t = 0 just below theta0 = upper(N)."""
    return sum(not finite_at_0(order, 0.999 * upper(order)) for order in (1, 3, 5, 7))


def largest_residual(error: Callable[[int, float], float]) -> float:
    """The largest difference of error(N, theta0) from the largest deviation on a fine grid, rad."""
    found = []
    for order, theta0 in ((1, np.pi / 3), (2, 0.9 * np.pi), (4, 0.945 * np.pi)):
        approximation = fourier(order, theta0)
        t = np.linspace(0.0, Pendulum(theta0).period, 4001)
        found.append(np.max(np.abs(approximation.difference(t))) - error(order, theta0))
    return largest(found)


def share_of_largest(order: int, theta0: float) -> float:
    """The first time of the largest deviation of Lima (22), over the period."""
    return fourier(order, theta0).error(1).t / Pendulum(theta0).period


def percent(order: int, theta0: float) -> float:
    """The largest deviation of Lima (22) over a period, in % of theta0."""
    return 100 * fourier(order, theta0).error(1).relative


LIMA = functools.partial(Erratum, "Lima 2019")
LIMA_RANGE = functools.partial(Erratum[Callable[[int], float]], "Lima 2019")
ERRATA = (
    LIMA(
        "(1)",
        "−m g ℓ sin θ = I θ",
        "−m g ℓ sin θ = I θ̈",
        "The two dots are lost; (2), which follows from it, has them.",
        Kind.TEXT,
        "largest difference of the two sides, m = g = ℓ = 1",
        1e-9,
        balance_residual,
        lambda theta, acceleration: -np.sin(theta) - theta,
        lambda theta, acceleration: -np.sin(theta) - acceleration,
    ),
    LIMA(
        "(15)",
        "z(t) = C sn(ωt + φ₀; k), C and φ₀ free",
        "z(t) = sn(ωt + φ₀; k), k and φ₀ free",
        "With k fixed only C = 0 and C = ±1 solve (14); the second free constant is k itself.",
        Kind.PAPER,
        "largest |z″ + (1 + k²)z − 2k²z³|",
        1e-9,
        solution_residual,
        lambda constant: ((lambda t: constant * sn(t, k=0.8)), 0.8),
        lambda constant: ((lambda t: sn(t, k=constant)), constant),
    ),
    LIMA(
        "(16)",
        "θ = 2 arcsin[k sin(ωt + K; k)]",
        "θ = 2 arcsin[k sn(ωt + K; k)]",
        "Jacobi's sn has become a sine.",
        Kind.OPEN,
        "largest |θ″ + sin θ|, or miss of the initial state",
        1e-8,
        lambda form: pendulum_residual(form, RELEASES),
        functools.partial(released, lambda u, k: np.sin(u)),
        functools.partial(released, lambda u, k: jacobi(u, k=k).sn),
    ),
    LIMA_RANGE(
        "(23)",
        "θ̂(0) for any N ≥ 1 and 0 < θ₀ < π",
        "for odd N only up to " + ", ".join(f"{highest(n) / np.pi:.4f}π (N = {n})" for n in (1, 3, 5, 7)),
        "Beyond, the argument of the arcsine exceeds 1. Even N leave the range too, inside the swing.",
        Kind.PAPER,
        "how many of N = 1, 3, 5, 7 have no value at 0.999 of the end of the range",
        0,
        range_residual,
        lambda order: np.pi,
        highest,
    ),
    LIMA(
        "section 4",
        "the largest error is always at t = 0 and t = T",
        "for even N and large θ₀ it is inside the swing; else it is at t = T/2 as well",
        f"For θ₀ = 0.9π and N = 2 it is at t = {share_of_largest(2, 0.9 * np.pi):.4f} T.",
        Kind.PAPER,
        "largest miss of the largest error, for N = 1, 2, 4 at π/3, 0.9π, 0.945π, rad",
        1e-5,
        largest_residual,
        lambda order, theta0: abs(fourier(order, theta0).difference(0.0)),
        lambda order, theta0: fourier(order, theta0).error(1).difference,
    ),
    LIMA(
        "section 4",
        "N = 2 at π/3: 0.04 %",
        "0.03 %",
        f"It is {percent(2, np.pi / 3):.5f} %: rounded up.",
        Kind.PAPER,
        "difference from the measured largest deviation, in % of θ₀; two decimals allow 0.005",
        0.005,
        lambda form: abs(form - percent(2, np.pi / 3)),
        0.04,
        0.03,
    ),
)
