"""Errata of Horsley 2025, Juchem Neto's formula included."""

import ast
import functools
from collections.abc import Callable

import numpy as np

from ..._arrays import Floats
from ...elliptic import carlson_rf, incomplete_e, incomplete_f, jacobi
from .._erratum import Erratum, Kind, StateFormula, duffing_force, largest, motion_residual, pendulum_residual
from .._exact import juchem_neto

INSTANTS = np.linspace(0.1, 3.0, 30)
BELOW = ((-1.0, 0.0), (-0.6, 0.9), (-2.0, -0.3))
THROWN = ((0.0, 1.0), (0.0, -0.5))
OVER = ((1.0, 3.0), (np.pi, 1.0))
BEYOND = ((4.0, 0.3), (5.5, -0.2))


def written(t: Floats, theta0: float, velocity0: float, *, divided: bool = False, sine: bool = False) -> Floats:
    """Horsley (3), with gamma0 divided by the root of k, or a sine in place of sn, if asked for."""
    half, rate = theta0 / 2, velocity0 / 2
    k = np.abs(np.sin(half))
    gamma0 = np.sqrt(1 + (rate / k) ** 2)
    m = (gamma0 * k) ** 2
    u = incomplete_f(np.arcsin(1 / gamma0), m=m) + (1 if velocity0 > 0 else -1) * t
    inner = np.sin(u) if sine else jacobi(u, m=m).sn
    angle: Floats = 2 * np.arcsin((gamma0 / k if divided else gamma0 * k) * inner)
    return angle


def mirrored(t: Floats, theta0: float, velocity0: float) -> Floats:
    """Juchem Neto's formula for theta0 < 0 too, by the mirror image of the motion from -theta0."""
    sign = np.sign(theta0)
    angle: Floats = sign * juchem_neto(t, abs(theta0), sign * velocity0)
    return angle


def without_gamma0(t: Floats, theta0: float, velocity0: float) -> Floats:
    """The same with m = sin(theta0/2)**2 + (velocity0/(2 omega0))**2 and the sign of theta0 in its sine."""
    sine, cosine, rate = np.sin(theta0 / 2), np.cos(theta0 / 2), velocity0 / 2
    m = sine**2 + rate**2
    start = sine / np.sqrt(m) * carlson_rf(rate**2 / m, cosine**2, 1.0)
    angle: Floats = 2 * np.arcsin(np.sqrt(m) * jacobi(start + (1 if velocity0 > 0 else -1) * t, m=m).sn)
    return angle


def turning(t: Floats, theta0: float, velocity0: float) -> Floats:
    """Rotation with positive velocity: twice am of the reciprocal parameter."""
    sine, cosine, rate = np.sin(theta0 / 2), np.cos(theta0 / 2), velocity0 / 2
    m = sine**2 + rate**2
    start = sine * carlson_rf(rate**2, m * cosine**2, m)
    angle: Floats = 2 * jacobi(np.sqrt(m) * (start + t), m=1 / m).am
    return angle


def reduced(t: Floats, theta0: float, velocity0: float) -> Floats:
    """The whole turns of theta0 are subtracted first and added to the angle."""
    turns = 2 * np.pi * np.round(theta0 / (2 * np.pi))
    angle: Floats = turns + mirrored(t, theta0 - turns, velocity0)
    return angle


def cosine(rate: float, t: Floats) -> Floats:
    """The solution of the linear equation from rest at 1."""
    swing: Floats = np.cos(rate * t)
    return swing


def frequency_residual(omega0: Callable[[float, float], float]) -> float:
    """The largest |theta'' + (g/l) theta| of cos(omega0 t) for two lengths."""
    found = []
    for gravity, length in ((9.8, 1.0), (9.8, 2.0)):
        form = functools.partial(cosine, omega0(gravity, length))
        found.append(motion_residual(form, duffing_force(gravity / length, 0.0), INSTANTS))
    return largest(found)


def arc_residual(arc: Callable[[float, float, float], float]) -> float:
    """The relative error of an arc of the ellipse (3 sin phi, 2 cos phi); the reference is a polygon of 20,000 sides."""
    phi = np.linspace(0.0, 1.2, 20_001)
    polygon = np.hypot(np.diff(3 * np.sin(phi)), np.diff(2 * np.cos(phi))).sum()
    return abs(arc(1.2, 3.0, 2.0) / float(polygon) - 1)


def syntax_residual(code: str) -> float:
    """0 if Python can read the line, 1 if not."""
    try:
        ast.parse(code)
    except SyntaxError:
        return 1.0
    return 0.0


SWING = "largest |θ″ + sin θ|, or miss of the initial state"
HORSLEY = functools.partial(Erratum, "Horsley 2025")
HORSLEY_ANGLE = functools.partial(Erratum[StateFormula], "Horsley 2025")
ERRATA = (
    HORSLEY_ANGLE(
        "(3), factor",
        "2 arcsin[(γ₀/√k) sn(…)]",
        "2 arcsin[γ₀√k sn(…)]",
        "z = γ₀ sn and y = √k z: the root multiplies. Printed so twice.",
        Kind.OPEN,
        SWING,
        1e-8,
        pendulum_residual,
        functools.partial(written, divided=True),
        written,
    ),
    HORSLEY_ANGLE(
        "(3), function",
        "sin(F(arcsin(1/γ₀), γ₀²k) + Hω₀t, γ₀²k)",
        "sn(F(arcsin(1/γ₀), γ₀²k) + Hω₀t, γ₀²k)",
        "Jacobi's sn has become a sine of two arguments. Printed so twice.",
        Kind.OPEN,
        SWING,
        1e-8,
        pendulum_residual,
        functools.partial(written, sine=True),
        written,
    ),
    HORSLEY_ANGLE(
        "(3), H",
        "H = −1 for φ₀ ≤ 0, 1 for φ₀ > 0",
        "for θ₀ < 0: H = sign(θ₀φ₀), and an overall factor sign(θ₀)",
        "√k is |sin(θ₀/2)|, so the formula does not see the sign of θ₀.",
        Kind.PAPER,
        SWING + ", θ₀ < 0",
        1e-8,
        lambda form: pendulum_residual(form, BELOW),
        juchem_neto,
        mirrored,
    ),
    HORSLEY_ANGLE(
        "(3), γ₀",
        "γ₀² = 1 + φ₀²/(4ω₀²k)",
        "γ₀²k = m = sin²(θ₀/2) + φ₀²/(4ω₀²), and sin(θ₀/2)/√m for 1/γ₀",
        "γ₀ is infinite at θ₀ = 0, where k = 0; their product is not.",
        Kind.PAPER,
        SWING + ", θ₀ = 0",
        1e-8,
        lambda form: pendulum_residual(form, THROWN),
        juchem_neto,
        without_gamma0,
    ),
    HORSLEY_ANGLE(
        "(3), rotation and θ₀ = π",
        "2 arcsin[γ₀√k sn(…)], silent about γ₀²k > 1",
        "2 am(√m (τ₀ + ω₀t) | 1/m) for γ₀²k = m > 1",
        "arcsin folds the angle back at the top, which is wrong modulo 2π too.",
        Kind.PAPER,
        SWING + ", rotation",
        1e-7,
        lambda form: pendulum_residual(form, OVER),
        juchem_neto,
        turning,
    ),
    HORSLEY_ANGLE(
        "(3), |θ₀| > π",
        "θ₀ as it is",
        "θ₀ less its whole turns, which are given back at the end",
        "arcsin starts the motion between −π and π, between π and 2π at the mirror image.",
        Kind.PAPER,
        SWING + ", π < θ₀ < 2π",
        1e-8,
        lambda form: pendulum_residual(form, BEYOND),
        juchem_neto,
        reduced,
    ),
    HORSLEY(
        "definitions restated after (3)",
        "ω₀² := √(g/l)",
        "ω₀² := g/l",
        "Contradicts the earlier ω₀ := √(g/l).",
        Kind.OPEN,
        "largest |θ″ + (g/l)θ| of cos ω₀t, g = 9.8, l = 1 and 2",
        1e-7,
        frequency_residual,
        lambda gravity, length: np.sqrt(np.sqrt(gravity / length)),
        lambda gravity, length: np.sqrt(gravity / length),
    ),
    HORSLEY(
        "benefit of the special functions",
        "the integral of the first kind gives the arc length of an ellipse",
        "the integral of the second kind does",
        "The first kind gives that of a lemniscate, and the time of a pendulum.",
        Kind.PAPER,
        "relative error of an arc of an ellipse beside a polygon",
        1e-8,
        arc_residual,
        lambda phi, a, b: a * incomplete_f(phi, m=1 - b**2 / a**2),
        lambda phi, a, b: a * incomplete_e(phi, m=1 - b**2 / a**2),
    ),
    HORSLEY(
        "historical development",
        "Newton's laws 13 years after Huygens' analysis",
        "14 years",
        "Horologium oscillatorium 1673, Principia 1687.",
        Kind.PAPER,
        "difference, years",
        0,
        lambda years: abs(1687 - 1673 - years),
        13,
        14,
    ),
    HORSLEY(
        "code, ω₀",
        "`omega_0 = (g / 1)**0.5`",
        "`omega_0 = (g / l)**0.5`",
        "A one for an l: the length is not used. The figures have l = 1 and are not touched.",
        Kind.OPEN,
        "largest |θ″ + (g/l)θ| of cos ω₀t, g = 9.8, l = 1 and 2",
        1e-7,
        frequency_residual,
        lambda gravity, length: (gravity / 1) ** 0.5,
        lambda gravity, length: (gravity / length) ** 0.5,
    ),
    HORSLEY(
        "code, comment",
        "120 evenly spaced samples",
        "500 evenly spaced samples",
        "The line below it makes 500.",
        Kind.PAPER,
        "difference, samples",
        0,
        lambda samples: abs(len(np.linspace(0, 10, 500)) - samples),
        120,
        500,
    ),
    HORSLEY(
        "code, last lines",
        '`title = "Solutions at initial angular")` ⏎ `displacement …")`',
        '`title = "Solutions at initial angular displacement …")`',
        "Both titles are broken over lines behind a stray parenthesis; the indentation of some lines is lost as well.",
        Kind.TEXT,
        "1 if Python cannot read the line",
        0,
        syntax_residual,
        'nl_vs_l(title = "Solutions at initial angular")\ndisplacement and velocity")',
        'nl_vs_l(title = "Solutions at initial angular displacement and velocity")',
    ),
)
