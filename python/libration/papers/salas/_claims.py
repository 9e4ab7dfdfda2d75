"""The numerical claims of Salas 2019."""

import functools
import math

import numpy as np

from ... import approx
from ...pendulum import Pendulum, theta
from .._claim import Claim, Interval, rounded
from .._exact import salas_22, salas_23, salas_24
from ._errata import TWELVE, forms_missing
from ._errata_periods import measured_period

SALAS = functools.partial(Claim, "Salas 2019")
NO_DATA = "its data are not in the text at hand; the figure is drawn for chosen ones"


def sine_row(place: str, name: str, degrees: float, printed: str) -> Claim:
    """A row for the range of (2) or (3)."""
    return SALAS(
        place,
        f"the polynomial stands for the sine up to {degrees}°: largest error, in % of the sine (read: at most 3 %)",
        printed,
        (0.0, 3.0),
        lambda: 100 * approx.sine(name).error(math.radians(degrees)).relative,
        "{:.3f} %",
    )


def prefactor_row(number: int, bound: float, text: str) -> Claim:
    """A row for the factor of (26), (27), (28), found from the motion at the end of a range."""
    return SALAS(
        f"({number})",
        f"factor in front of √(l/g) and the rational function, found from the motion at m = {text}",
        "π/2 = 1.571",
        (1.5, 1.65),
        lambda: measured_period(at(bound)) / approx.period(f"salas-{number}").ratio(m=bound),
        "{:.4f}",
        (6.25, 6.32),
        "2π; π/2 gives a quarter of the period",
    )


def range_row(
    number: int, bound: float, printed: str, shown: str, corrected: Interval | None = None, reason: str = ""
) -> Claim:
    """A row for the range of (26), (27), (28): the largest error of the period in it, %; read: at most 1 %."""
    return SALAS(
        f"({number})",
        f"largest error of the period, as a whole one, for {printed} (read: at most 1 %)",
        printed,
        (0.0, 1.0),
        lambda: 100 * largest_error(number, bound),
        shown,
        corrected,
        reason,
    )


def at(m: float) -> Pendulum:
    """The pendulum released at rest with this parameter, omega0 = 1."""
    return Pendulum(2 * math.asin(math.sqrt(m)))


def largest_error(number: int, bound: float) -> float:
    """The largest relative error of (26), (27) or (28) for |m| <= bound."""
    m = np.linspace(-bound, bound, 401)
    return float(np.max(np.abs(approx.period(f"salas-{number}").error(m=m))))


def trigonometric(theta0: float, periods: float = 1) -> float:
    """The largest error of (35) over some periods, in % of theta0."""
    return 100 * approx.angle("trigonometric").of(Pendulum(theta0)).error(periods).relative


def small_m(m: float, periods: float = 1) -> float:
    """The largest error of the formula before fig. 6, released at rest, in % of theta0."""
    return 100 * approx.angle("small-m").of(at(m)).error(periods).relative


def exact_forms(theta0: float, velocity0: float, until: float) -> float:
    """The largest difference of (22), (23) and (24) from the motion, rad."""
    t = np.linspace(0, until, 161)
    truth = theta(t, theta0, velocity0)
    return max(float(np.max(np.abs(form(t, theta0, velocity0) - truth))) for form in (salas_22, salas_23, salas_24))


def order_of_small_m() -> float:
    """The power of m in the error of the formula before fig. 6 over theta0, found from m = 0.001 and 0.002."""
    return math.log2(small_m(0.002) / small_m(0.001))


def system_33() -> float:
    """The largest residual of (33) for the k and lambda of (34), over its largest coefficient; phi0 = pi/2."""
    square = (math.pi / 2) ** 2
    square_of_k = (81 / 262 * square**2 - 10 * square + 81) / 81
    stretch = 1 + 262 * (20 * square - 243) / (243 * square**2 - 7860 * square + 63666)
    first = 31833 * square_of_k * (stretch + 1) - 31833 - 243 * square**2 + 5240 * square
    second = 95499 * square_of_k * stretch + 10611 * square_of_k - 10611 - 405 * square**2 + 5240 * square
    return max(abs(first), abs(second)) / 95499


CLAIMS = (
    sine_row("(2)", "salas-2", 70, "|φ| < 70°"),
    sine_row("(3)", "salas-3", 120, "|φ| ≤ 120°"),
    SALAS(
        "general solution",
        "number of Jacobi's functions with which the text solves the Duffing equation",
        "12",
        rounded("12"),
        lambda: len(TWELVE) - forms_missing(("cd", "cn", "dc", "dn", "nc", "nd", "sc", "sd", "sn")),
        "{:.0f}",
        rounded("9"),
        "ns, cs and ds are missing",
    ),
    SALAS(
        "(22), (23), (24)",
        "exact: largest difference from the motion, libration φ₀ = 1, φ̇₀ = 1.2 ω, two periods, rad",
        "0",
        (0.0, 1e-12),
        lambda: exact_forms(1.0, 1.2, 16.0),
        "{:.0e}",
    ),
    SALAS(
        "(22), (23), (24)",
        "the same for the rotation φ₀ = 1, φ̇₀ = 3 ω, up to ωt = 7, in turns",
        "0",
        (0.0, 1e-12),
        lambda: exact_forms(1.0, 3.0, 7.0) / math.tau,
        "{:.4f}",
        (3 - 1e-9, 3 + 1e-9),
        "right modulo 2π: arctan knows one turn",
    ),
    SALAS(
        "(25)",
        "T ω/K(m), found from the motion at m = 1/2",
        "1",
        rounded("1"),
        lambda: measured_period(at(0.5)) / (approx.period("exact").ratio(m=0.5) * math.pi / 2),
        "{:.6f}",
        (4 - 1e-9, 4 + 1e-9),
        "K(m)/ω is a quarter of the period",
    ),
    prefactor_row(26, 1 / 3, "1/3"),
    range_row(26, 1 / 3, "|m| ≤ 1/3", "{:.4f} %"),
    prefactor_row(27, 0.75, "3/4"),
    range_row(27, 0.75, "|m| ≤ 3/4", "{:.4f} %"),
    prefactor_row(28, 0.75, "3/4"),
    range_row(
        28,
        1 - 1e-9,
        "|m| < 1",
        "{:.1f} % at |m| = 1 − 10⁻⁹",
        (72.0, 73.0),
        "1 % up to |m| = 0.90; K grows beyond every bound at 1",
    ),
    SALAS("example 1, fig. 3", "exact and numerical solution agree", "", reason=NO_DATA),
    SALAS("example 2, fig. 4", "exact and numerical solution agree", "", reason=NO_DATA),
    SALAS(
        "(33), (34)",
        "k and λ solve the system (33): largest residual at φ₀ = π/2, over its largest coefficient",
        "0",
        (0.0, 1e-14),
        system_33,
        "{:.0e}",
    ),
    SALAS(
        "(35)",
        "serves up to 120°: largest error over one period, in % of φ₀ (read: at most 2 %)",
        "|φ| ≤ 120°",
        (0.0, 2.0),
        lambda: trigonometric(2 * math.pi / 3),
        "{:.2f} %",
        None,
        "the error grows with time",
    ),
    SALAS(
        "example 3, fig. 5",
        "(35) beside the exact solution from π/2: largest error over one period, in % of φ₀",
        "close",
        (0.0, 1.0),
        lambda: trigonometric(math.pi / 2),
        "{:.2f} %",
    ),
    SALAS(
        "example 3, fig. 6", "trigonometric and exact solution", "", reason="which formula and which span is not said"
    ),
    SALAS(
        "formula before fig. 6",
        "right to first order in m: power of m in its error after one period",
        "2",
        (1.95, 2.05),
        order_of_small_m,
        "{:.3f}",
    ),
    SALAS("example 4, fig. 7", "trigonometric and exact solution agree", "", reason=NO_DATA),
    SALAS(
        "conclusions",
        "good for |m| < 0.2: largest error after one period at m = 0.2, in % of φ₀ (read: at most 1 %)",
        "good",
        (0.0, 1.0),
        lambda: small_m(0.2),
        "{:.2f} %",
        (5.9, 6.1),
        "1 % up to m = 0.08",
    ),
    SALAS(
        "conclusions",
        "the same over ten periods",
        "good",
        (0.0, 1.0),
        lambda: small_m(0.2, 10),
        "{:.0f} %",
        (290.0, 300.0),
        "its terms grow with time",
    ),
)
