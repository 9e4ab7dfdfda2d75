"""The numerical claims of Lima 2019. His relative error is the largest deviation over a period, divided by theta0."""

import functools
import math
from collections.abc import Callable

import numpy as np

from ... import approx
from ...elliptic import complete_k, nome
from ...pendulum import Pendulum
from .._claim import Claim, Interval, rounded
from ._errata import highest, share_of_largest

LIMA = functools.partial(Claim, "Lima 2019")


def percent(name: str, theta0: float, periods: float = 1) -> Callable[[], float]:
    """The largest deviation over some periods, in % of theta0."""
    return lambda: 100 * approx.angle(name).of(Pendulum(theta0)).error(periods).relative


def figure_row(
    place: str,
    theta0: float,
    text: str,
    name: str,
    printed: str,
    allows: Interval,
    corrected: Interval | None = None,
    reason: str = "",
) -> Claim:
    """A row for a percentage of figures 2 to 4 or of the text around them."""
    order = name.partition(":")[2]
    which = f"Fourier-based approximation (22) with N = {order}" if order else "harmonic approximation (17)"
    claim = f"largest error of the {which} at θ₀ = {text}"
    return LIMA(place, claim, printed, allows, percent(name, theta0), "{:.4g} %", corrected, reason)


def small_swing_error() -> float:
    """The relative error of the period of small swings at 10 degrees, %."""
    return -100 * (math.tau / Pendulum(math.radians(10)).period - 1)


def sum_error() -> float:
    """The relative difference of the sum below (23) from kK/(2 pi), k = 0.9."""
    q, odd = nome(k=0.9), np.arange(1, 121, 2)
    total = np.sum((-1.0) ** ((odd - 1) // 2) * q ** (odd / 2) / (1 - q**odd))
    return abs(total / (0.9 * complete_k(k=0.9) / math.tau) - 1)


def period_error() -> float:
    """The largest relative difference of (10) from the periods of pendulums."""
    angles = (0.1, 1.0, 3.0)
    return max(abs(4 * complete_k(k=math.sin(each / 2)) / Pendulum(each).period - 1) for each in angles)


def long_times() -> float:
    """The ratio of the largest errors over 1000 periods and over one, N = 4 at 7 pi/8."""
    return percent("fourier:4", 7 * math.pi / 8, 1000)() / percent("fourier:4", 7 * math.pi / 8)()


def order_at_60() -> float:
    """The ratio of the largest errors of (17) and of (22) with N = 1, at pi/3."""
    return percent("harmonic", math.pi / 3)() / percent("fourier:1", math.pi / 3)()


CLAIMS = (
    LIMA(
        "section 2",
        "error of the period of small swings for amplitudes below 10°",
        "less than 0.5 %",
        (0.0, 0.5),
        small_swing_error,
        "{:.4g} % at 10°",
    ),
    LIMA("(10)", "the period is 4K(k)/ω: relative difference", "0", (0.0, 1e-13), period_error, "{:.0e}"),
    figure_row("section 3", math.pi / 4, "π/4", "harmonic", "practically indistinguishable", (0.0, 1.0)),
    figure_row("section 4, fig. 2", math.pi / 3, "π/3", "harmonic", "less than 1 %", (0.0, 1.0)),
    figure_row("section 4, fig. 2", math.pi / 3, "π/3", "fourier:1", "2 %", rounded("2")),
    LIMA(
        "section 4, fig. 2",
        "at π/3 the harmonic one is better than one Fourier term: ratio of the largest errors",
        "below 1",
        (0.0, 1.0),
        order_at_60,
    ),
    figure_row(
        "section 4, fig. 2",
        math.pi / 3,
        "π/3",
        "fourier:2",
        "0.04 %",
        rounded("0.04"),
        rounded("0.03"),
        "rounds to 0.03 %; the printed value is rounded up",
    ),
    figure_row("section 4, fig. 3", math.pi / 2, "π/2", "harmonic", "2.3 %", rounded("2.3")),
    figure_row("section 4, fig. 3", math.pi / 2, "π/2", "fourier:2", "0.2 %", rounded("0.2")),
    figure_row("section 4", 4 * math.pi / 5, "4π/5", "harmonic", "highly inaccurate", (5.0, 100.0)),
    figure_row("section 4", 4 * math.pi / 5, "4π/5", "fourier:3", "0.6 %", rounded("0.6")),
    figure_row("section 4, fig. 4", 7 * math.pi / 8, "7π/8", "fourier:4", "0.4 %", rounded("0.4")),
    figure_row("section 5", 7 * math.pi / 8, "7π/8", "fourier:4", "less than 0.4 %", (0.0, 0.4)),
    figure_row("section 5, fig. 4", 7 * math.pi / 8, "7π/8", "harmonic", "departs much", (5.0, 100.0)),
    figure_row("section 4", 0.95 * math.pi, "0.95π", "fourier:6", "0.3 %", rounded("0.3")),
    LIMA(
        "section 4",
        "the largest error of (22) is always at t = 0 and T: t/T for N = 2 at 0.9π",
        "0",
        (0.0, 1e-6),
        lambda: share_of_largest(2, 0.9 * math.pi),
        "{:.4f}",
        (0.0920, 0.0930),
        "inside the swing for even N and large θ₀; else at T/2 as well",
    ),
    LIMA(
        "section 4, (23)",
        "(22) has a value at t = 0 for any N and any θ₀ below π: end of the range for N = 1",
        "180°",
        (179.999, 180.001),
        lambda: math.degrees(highest(1)),
        "{:.2f}°",
        (131.54, 131.56),
        f"{math.degrees(highest(3)):.2f}° for N = 3; beyond, the argument of the arcsine exceeds 1",
    ),
    LIMA(
        "section 4, below (23)",
        "the sum tends to kK/2π: relative difference for k = 0.9",
        "0",
        (0.0, 1e-13),
        sum_error,
        "{:.0e}",
    ),
    LIMA(
        "abstract, section 5",
        "accurate for arbitrarily long times: largest error over 1000 periods over that of one, N = 4 at 7π/8",
        "1",
        (1 - 1e-6, 1 + 1e-6),
        long_times,
        "{:.6f}",
    ),
)
