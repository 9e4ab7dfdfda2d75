"""Errata of Salas 2019, up to the exact solution: the Duffing equation, its forms, and the angle."""

import functools
from collections.abc import Callable, Iterable, Sequence
from decimal import Decimal, localcontext
from typing import Literal, Protocol, TypeAlias

import numpy as np

from ... import elliptic
from ..._arrays import Floats
from ...elliptic import cn, dn, jacobi, nc, sn
from ...oscillator import Duffing, DuffingForm
from ...pendulum import Pendulum, theta
from .._erratum import STATES, Erratum, Kind, StateFormula, duffing_force, largest, motion_residual, pendulum_residual
from .._exact import salas_23

# Duffing oscillators with real solutions: c1, c2, p, q.
Constants: TypeAlias = tuple[float, float, float, float]
OSCILLATORS: tuple[Constants, ...] = ((1.0, 0.3, 1.0, 0.8), (0.7, -0.6, 0.4, 1.5))
INSTANTS = np.linspace(0.1, 1.2, 12)


def tangents(theta0: float, velocity0: float) -> tuple[float, float]:
    """u and its derivative for u = tan(theta/2), Salas (5) and (11)."""
    return np.tan(theta0 / 2), velocity0 / 2 / np.cos(theta0 / 2) ** 2


def system_residual(line: Callable[[float, float, float, float, float], float]) -> float:
    """Salas (9), first line: its value for the p and q of `Duffing.of_pendulum`."""
    found = []
    for state in STATES:
        duffing = Duffing.of_pendulum(Pendulum(*state))
        found.append(line(*tangents(*state), duffing.p, duffing.q, 1.0))
    return largest(found)


def coefficients_residual(coefficients: Callable[[float, float, float], tuple[float, float]]) -> float:
    """Salas (10): |u'' + p u + q u**3| for u = tan(theta/2) along the pendulum's motion."""
    found = []
    for state in STATES:
        p, q = coefficients(*tangents(*state), 1.0)
        swing = Pendulum(*state)

        def u(t: Floats, swing: Pendulum = swing) -> Floats:
            return np.tan(swing.theta(t) / 2)

        found.append(motion_residual(u, duffing_force(p, q), INSTANTS))
    return largest(found)


class DuffingSolution(Protocol):
    """A solution of the Duffing equation with two constants."""

    def __call__(self, t: Floats, c1: float, c2: float, p: float, q: float) -> Floats: ...


def duffing_residual(form: DuffingSolution, oscillators: Sequence[Constants] = OSCILLATORS) -> float:
    """The largest |u'' + p u + q u**3| of form(t, c1, c2, p, q)."""
    found = [
        motion_residual(functools.partial(form, c1=c1, c2=c2, p=p, q=q), duffing_force(p, q), INSTANTS)
        for c1, c2, p, q in oscillators
    ]
    return largest(found)


def cn_form(slipped: bool, t: Floats, c1: float, c2: float, p: float, q: float) -> Floats:
    """c1 cn(rate t + c2 | m); if slipped, with t under the root."""
    m = q * c1**2 / (2 * (q * c1**2 + p))
    return c1 * cn((np.sqrt(q * c1**2 + p * t) if slipped else np.sqrt(q * c1**2 + p) * t) + c2, m=m)


def nc_form(slipped: bool, t: Floats, c1: float, c2: float, p: float, q: float) -> Floats:
    """c1 nc(rate t + c2 | m); if slipped, with t under the root."""
    m = (q * c1**2 + 2 * p) / (2 * (q * c1**2 + p))
    return c1 * nc((np.sqrt(-q * c1**2 - p * t) if slipped else np.sqrt(-q * c1**2 - p) * t) + c2, m=m)


def addition(
    t: Floats,
    c1: float,
    c2: float,
    p: float,
    q: float,
    *,
    factor: bool = True,
    time: bool = True,
    c: float | None = None,
) -> Floats:
    """Salas (14), with or without c1 on the second term and t in its dn; c is m sn(c2)**2 if not given."""
    m, rate = q * c1**2 / (2 * (q * c1**2 + p)), np.sqrt(q * c1**2 + p)
    z = rate * t
    second = sn(z, m=m) * dn(z if time else rate, m=m) * sn(c2, m=m) * dn(c2, m=m)
    c = m * sn(c2, m=m) ** 2 if c is None else c
    u: Floats = c1 * (cn(z, m=m) * cn(c2, m=m) - (1 if factor else 1 / c1) * second) / (1 - c * sn(z, m=m) ** 2)
    return u


def constants_residual(constants: Callable[[float, float, float], tuple[float, float]]) -> float:
    """Salas (15) in (18): the equation of motion for a, b = constants(c1, c2, m)."""

    def form(t: Floats, c1: float, c2: float, p: float, q: float) -> Floats:
        m, z = q * c1**2 / (2 * (q * c1**2 + p)), np.sqrt(q * c1**2 + p) * t
        a, b = constants(c1, c2, m)
        above = a * cn(z, m=m) - b * sn(z, m=m) * dn(z, m=m)
        u: Floats = above / (1 - m * sn(c2, m=m) ** 2 * sn(z, m=m) ** 2)
        return u

    return duffing_residual(form)


def relation_residual(relation: Callable[[float, float, float, float, float], float]) -> float:
    """Salas (17) for the a and b that (18) needs: the value of what should be 0."""
    found = []
    for c1, c2, p, q in OSCILLATORS:
        m = q * c1**2 / (2 * (q * c1**2 + p))
        found.append(relation(c1 * cn(c2, m=m), c1 * sn(c2, m=m) * dn(c2, m=m), c1, p, q))
    return largest(found)


def signed(sign: float, t: Floats, theta0: float, velocity0: float) -> Floats:
    """Salas (18) with the constants that solve (21); sign is that of b and c."""
    a, b = np.tan(theta0 / 2), velocity0 / 2 / np.cos(theta0 / 2) ** 2
    c = -((velocity0 / 2 / np.cos(theta0 / 2)) ** 2)
    z = jacobi(t, m=np.sin(theta0 / 2) ** 2 + velocity0**2 / 4)
    angle: Floats = 2 * np.arctan((a * z.cn + sign * b * z.sn * z.dn) / (1 + sign * c * z.sn**2))
    return angle


# A p and q for which each of the twelve forms with c1 = 1 is real.
TWELVE = {
    **dict.fromkeys(("sn", "cd"), (1.0, -0.5)),
    **dict.fromkeys(("dc", "ns"), (0.75, -1.0)),
    "cn": (1.0, 1.0),
    "dn": (-0.75, 1.0),
    "nc": (0.3, -1.0),
    "nd": (-1.0, 0.5),
    "sc": (-1.0, -0.5),
    "sd": (0.5, 1.0),
    "cs": (-0.75, -1.0),
    "ds": (0.2, -1.0),
}


def forms_missing(names: Iterable[str]) -> int:
    """The number of Jacobi's twelve functions that solve the Duffing equation and are not among the names."""
    near = np.linspace(0.5, 0.8, 4)
    solving = []
    for name, (p, q) in TWELVE.items():
        form = DuffingForm(name, 1.0, 0.3, p=p, q=q)
        if motion_residual(form.u, duffing_force(p, q), near) < 1e-7:
            solving.append(name)
    return len(set(solving) - set(names))


def parameter_residual(parameter: Callable[[float, float], float]) -> float:
    """The parameter of the sd form for small p; the reference has 60 digits."""
    found = []
    for p in (1e-9, 1e-17):
        with localcontext() as context:
            context.prec = 60
            exact = (1 - Decimal(p) / (1 + (1 + Decimal(p) ** 2).sqrt())) / 2
        found.append(parameter(p, 1.0) / float(exact) - 1)
    return largest(found)


def largest_step(form: StateFormula) -> float:
    """The largest change of the angle within a millisecond of a rotation, rad."""
    return largest(np.diff(form(np.linspace(0.0, 7.0, 7001), 1.0, 3.0)))


def in_modulus(name: Literal["k", "m"], t: Floats, theta0: float, velocity0: float) -> Floats:
    """Salas (23) with its m passed as the parameter or as the modulus."""
    half, rate = theta0 / 2, velocity0 / 2
    z = jacobi(t, **{name: np.sin(half) ** 2 + rate**2})
    above = np.tan(half) * z.cn + rate / np.cos(half) ** 2 * z.dn * z.sn
    angle: Floats = 2 * np.arctan(above / (1 - (rate / np.cos(half)) ** 2 * z.sn**2))
    return angle


MOTION = "largest |u″ + p u + q u³|"
SWING = "largest |φ″ + sin φ|"
SALAS = functools.partial(Erratum, "Salas 2019")
SALAS_ANGLE = functools.partial(Erratum[StateFormula], "Salas 2019")
SALAS_DUFFING = functools.partial(Erratum[DuffingSolution], "Salas 2019")
ERRATA = (
    SALAS(
        "(9), first line",
        "2p u̇₀² + p + q u₀⁴ + 2u₀² − ω² = 0",
        "2p u₀² + p + q u₀⁴ + 2u̇₀² − ω² = 0",
        "The dots stand on the wrong letters; (8), which it comes from, has them right.",
        Kind.OPEN,
        "largest value of what should be 0",
        1e-12,
        system_residual,
        lambda u, du, p, q, w: 2 * p * du**2 + p + q * u**4 + 2 * u**2 - w**2,
        lambda u, du, p, q, w: 2 * p * u**2 + p + q * u**4 + 2 * du**2 - w**2,
    ),
    SALAS(
        "(10)",
        "p = −[(u̇₀⁴ − 1)ω² + 2u₀²]/(u̇₀² + 1)², q = 2[(u̇₀² + 1)ω² − u₀²]/(u̇₀² + 1)²",
        "p = −[(u₀⁴ − 1)ω² + 2u̇₀²]/(u₀² + 1)², q = 2[(u₀² + 1)ω² − u̇₀²]/(u₀² + 1)²",
        "u₀ and u̇₀ are exchanged throughout. Both are simply p = ω²(1 − 2m), q = 2ω²(1 − m) with the m of (23).",
        Kind.OPEN,
        MOTION + " along the pendulum's motion",
        1e-8,
        coefficients_residual,
        lambda u, du, w: (
            -((du**4 - 1) * w**2 + 2 * u**2) / (du**2 + 1) ** 2,
            2 * ((du**2 + 1) * w**2 - u**2) / (du**2 + 1) ** 2,
        ),
        lambda u, du, w: (
            -((u**4 - 1) * w**2 + 2 * du**2) / (u**2 + 1) ** 2,
            2 * ((u**2 + 1) * w**2 - du**2) / (u**2 + 1) ** 2,
        ),
    ),
    SALAS(
        "general solution",
        "twelve functions announced, nine given",
        "with ns, cs and ds",
        "The three that are missing solve the equation too, where q < 0.",
        Kind.PAPER,
        "functions that solve the equation and are not given",
        0,
        forms_missing,
        ("cd", "cn", "dc", "dn", "nc", "nd", "sc", "sd", "sn"),
        tuple(name for name in elliptic.__all__ if name in TWELVE),
    ),
    SALAS(
        "cn form, (13), (14), (18)",
        "c₁ cn(√(qc₁² + pt) + c₂, m)",
        "c₁ cn(√(qc₁² + p) t + c₂, m)",
        "The root has swallowed the t.",
        Kind.TEXT,
        MOTION,
        1e-8,
        duffing_residual,
        functools.partial(cn_form, True),
        functools.partial(cn_form, False),
    ),
    SALAS(
        "nc form",
        "c₁ nc(√(−qc₁² − pt) + c₂, m)",
        "c₁ nc(√(−qc₁² − p) t + c₂, m)",
        "The root has swallowed the t.",
        Kind.TEXT,
        MOTION,
        1e-7,
        lambda form: duffing_residual(form, ((1.0, 0.1, 0.3, -1.0),)),
        functools.partial(nc_form, True),
        functools.partial(nc_form, False),
    ),
    SALAS(
        "sd form",
        "m = (qc₁² + p − √(q²c₁⁴ + p²))/(2p)",
        "m = (1 − p/(qc₁² + √(q²c₁⁴ + p²)))/2",
        "The same number, but the printed form cancels for small p and is 0/0 at p = 0.",
        Kind.PAPER,
        "relative error in double at p = 10⁻⁹ and 10⁻¹⁷",
        1e-15,
        parameter_residual,
        lambda p, qc2: (qc2 + p - np.sqrt(qc2**2 + p**2)) / (2 * p),
        lambda p, qc2: (1 - p / (qc2 + np.sqrt(qc2**2 + p**2))) / 2,
    ),
    SALAS_DUFFING(
        "(14), second term",
        "… − sn z dn z sn c₂ dn c₂",
        "… − c₁ sn z dn z sn c₂ dn c₂",
        "c₁ is a factor of both terms.",
        Kind.PAPER,
        MOTION,
        1e-8,
        duffing_residual,
        functools.partial(addition, factor=False),
        addition,
    ),
    SALAS_DUFFING(
        "(14), (18), dn",
        "dn(√(qc₁² + p), m)",
        "dn(√(qc₁² + p) t, m)",
        "dn lacks the t that its neighbours have.",
        Kind.PAPER,
        MOTION,
        1e-8,
        duffing_residual,
        functools.partial(addition, time=False),
        addition,
    ),
    SALAS_DUFFING(
        "(14), denominator",
        "1 − csn²(√(qc₁² + p) t, m), c not defined",
        "1 − c sn²(√(qc₁² + p) t, m) with c = m sn²(c₂, m)",
        "Not a function csn: a constant c times sn², which the text defines nowhere.",
        Kind.PAPER,
        MOTION,
        1e-8,
        duffing_residual,
        functools.partial(addition, c=np.nan),
        addition,
    ),
    SALAS(
        "(15)",
        "b = sn(c₂) dn(c₂)",
        "b = c₁ sn(c₂) dn(c₂)",
        "(18) needs the factor c₁ that (14) has lost.",
        Kind.PAPER,
        MOTION + " of (18)",
        1e-8,
        constants_residual,
        lambda c1, c2, m: (c1 * cn(c2, m=m), sn(c2, m=m) * dn(c2, m=m)),
        lambda c1, c2, m: (c1 * cn(c2, m=m), c1 * sn(c2, m=m) * dn(c2, m=m)),
    ),
    SALAS(
        "(17)",
        "a⁴q + 2a²p + c₁²(2b²p − 2p) + c₁⁴(2b²q − q) = 0",
        "a⁴q + 2a²p + 2b²(p + qc₁²) − 2pc₁² − qc₁⁴ = 0",
        "True with the b of (15) as printed; with the b that (18) needs, b² already holds the c₁².",
        Kind.PAPER,
        "largest value of what should be 0",
        1e-12,
        relation_residual,
        lambda a, b, c1, p, q: a**4 * q + 2 * a**2 * p + c1**2 * (2 * b**2 * p - 2 * p) + c1**4 * (2 * b**2 * q - q),
        lambda a, b, c1, p, q: a**4 * q + 2 * a**2 * p + 2 * b**2 * (p + q * c1**2) - 2 * p * c1**2 - q * c1**4,
    ),
    SALAS(
        "(18) with (21)",
        "u = (a cn z − b sn z dn z)/(1 − c sn² z)",
        "u = (a cn z + b sn z dn z)/(1 + c sn² z)",
        "The system (21), and (22) to (24) after it, take b and c with the other sign. "
        "w in (21) is the square of the rate.",
        Kind.PAPER,
        SWING + " with a, b, c, w from (21)",
        1e-8,
        pendulum_residual,
        functools.partial(signed, -1.0),
        functools.partial(signed, 1.0),
    ),
    SALAS_ANGLE(
        "(5), (22), (23), (24)",
        "φ = 2 arctan u",
        "φ = 2 arctan u + 2πn, the turns counted on",
        "arctan knows one turn: in rotation, and from |φ₀| > π, whole turns are lost. Right modulo 2π.",
        Kind.PAPER,
        "largest change of φ within a millisecond of the rotation φ₀ = 1, φ̇₀ = 3, rad",
        0.01,
        largest_step,
        salas_23,
        theta,
    ),
    SALAS(
        "sections 3 and 4, “the modulus m”",
        "m is the modulus k",
        "m is the parameter k²",
        "(22) to (28) take m for the parameter; passed as a modulus it gives another motion.",
        Kind.PAPER,
        SWING + " of (23)",
        1e-8,
        pendulum_residual,
        functools.partial(in_modulus, "k"),
        functools.partial(in_modulus, "m"),
    ),
)
