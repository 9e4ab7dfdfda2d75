"""The numerical claims of Horsley 2025."""

import functools
import math

import numpy as np

from ... import approx
from ...elliptic import incomplete_f, jacobi
from ...pendulum import Pendulum
from ...plot import linear_theta
from .._claim import Claim, rounded
from ._figures import swing

HORSLEY = functools.partial(Claim, "Horsley 2025")
TIMES = np.linspace(0, 10, 500)


def departure(theta0: float, until: float = 10.0) -> float:
    """The largest difference of the linear from the nonlinear solution, in % of theta0."""
    t = np.linspace(0, until, 20_001)
    return 100 * float(np.max(np.abs(linear_theta(swing(theta0), t) - swing(theta0).theta(t)))) / theta0


def numerical_error(theta0: float) -> float:
    """The largest error of odeint at its defaults at the 500 instants of the graph, rad."""
    numerical = approx.numerical("odeint").of(swing(theta0))
    return float(np.max(np.abs(numerical.theta(TIMES) - swing(theta0).theta(TIMES))))


def smallest_growth() -> float:
    """The smallest growth of the period from one amplitude to the next: above 0 if it always grows."""
    return float(min(np.diff([Pendulum(each).period for each in np.linspace(0.1, 3.1, 31)])))


def projection() -> float:
    """The largest difference of sin(theta/2) from k times the ellipse's x, released from 2 rad."""
    k, t = math.sin(1.0), np.linspace(0, 20, 801)
    z = jacobi(t, m=k * k)
    # x = r cos(phi) with r = 1/dn and phi = am comes from the point of the ellipse, not from the function cd.
    x = np.cos(z.am) / np.sqrt(1 - (k * np.sin(z.am)) ** 2)
    return float(np.max(np.abs(np.sin(Pendulum(2.0).theta(t) / 2) - k * x)))


def power_of_k() -> float:
    """The power of the root of k in front of sn in (3), found from the motion with theta0 = 1, velocity0 = 0.5."""
    swing_k, rate = math.sin(0.5), 0.25
    gamma0 = math.hypot(1, rate / swing_k)
    m = (gamma0 * swing_k) ** 2
    start = incomplete_f(math.asin(1 / gamma0), m=m)
    factor = math.sin(Pendulum(1.0, 0.5).theta(1.0) / 2) / (gamma0 * jacobi(start + 1.0, m=m).sn)
    return math.log(factor) / math.log(swing_k)


def bluntness() -> float:
    """The acceleration at the turning point 3 rad, over that of the cosine of the same amplitude and period."""
    return swing(3.0).omega2 * math.sin(3.0) / (3.0 * (math.tau / swing(3.0).period) ** 2)


CLAIMS = (
    HORSLEY(
        "historical development",
        "years from Huygens' analysis to Newton's laws",
        "13",
        rounded("13"),
        lambda: 1687 - 1673,
        "{:.0f}",
        rounded("14"),
        "1673 and 1687",
    ),
    HORSLEY(
        "historical development",
        "the period grows with the amplitude: smallest growth between 31 amplitudes, s",
        "above 0",
        (1e-300, math.inf),
        smallest_growth,
        "{:.2e}",
    ),
    HORSLEY(
        "(3)",
        "power of √k in front of sn, found from the motion",
        "−1",
        (-1.001, -0.999),
        power_of_k,
        "{:.6f}",
        (1 - 1e-9, 1 + 1e-9),
        "γ₀√k for γ₀/√k; and sn for sin",
    ),
    HORSLEY(
        "definitions restated after (3)",
        "ω₀ of g = 9.8 m/s², l = 1 m, 1/s",
        "1.7693, from ω₀² := √(g/l)",
        rounded("1.7693"),
        lambda: swing(1.0).omega0,
        "{:.4f}",
        rounded("3.1305"),
        "ω₀ := √(g/l), as defined before",
    ),
    HORSLEY(
        "summary",
        "the nonlinear motion is the x-projection of a point on an ellipse: largest difference of sin(θ/2) from k x",
        "0",
        (0.0, 1e-14),
        projection,
        "{:.0e}",
        None,
        "of the chord from the lowest point, not of the angle",
    ),
    HORSLEY(
        "appendix, graph at 0.4 rad",
        "the curves nearly overlap: largest difference in the first period, in % of 0.4 rad",
        "nearly overlaps",
        (0.0, 5.0),
        lambda: departure(0.4, swing(0.4).period),
        "{:.3g} %",
    ),
    HORSLEY(
        "appendix, graph at 0.4 rad",
        "the same over the ten seconds of the graph",
        "nearly overlaps",
        (0.0, 5.0),
        lambda: departure(0.4),
        "{:.3g} %",
        (29.0, 31.0),
        "only the first period does",
    ),
    HORSLEY(
        "appendix, graph at 3 rad",
        "the linear equation deviates significantly: largest difference, in % of 3 rad",
        "significantly",
        (50.0, 200.0),
        lambda: departure(3.0),
        "{:.4g} %",
    ),
    HORSLEY(
        "appendix, graph at 3 rad",
        "sharper turns than a sine curve: acceleration where it turns back, over that of the cosine of its period",
        "above 1",
        (1.0, math.inf),
        bluntness,
        "{:.3f}",
        (0.30, 0.32),
        "blunter there; only the bends between swing and standstill are sharper",
    ),
    HORSLEY(
        "appendix, code",
        "largest error of odeint at its default tolerances at 0.4 rad, rad",
        "not visible",
        (0.0, 1e-5),
        lambda: numerical_error(0.4),
        "{:.1e}",
    ),
    HORSLEY(
        "appendix, code",
        "the same at 3 rad",
        "not visible",
        (0.0, 1e-3),
        lambda: numerical_error(3.0),
        "{:.1e}",
    ),
    HORSLEY(
        "appendix, code",
        "number of instants between 0 and 10 s",
        "120, in a comment",
        rounded("120"),
        lambda: len(TIMES),
        "{:.0f}",
        rounded("500"),
        "the line below makes 500",
    ),
)
