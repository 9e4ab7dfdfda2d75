"""Starts and coefficients with double roots of u'^2 = P(u), exactly: short numbers, so that every product is a double.

An orbit is (u0, velocity0, p, r, q, c). Used by helmholtz_duffing_inputs.py.
"""

import math
from fractions import Fraction

from general_oscillator import regime
from oscillator_inputs import first


def letters(orbit):
    return dict(zip("prqc", orbit[2:], strict=True))


def regime_of(orbit):
    return regime(*orbit[:2], letters(orbit))


def exact_double(x):
    value = float(x)
    if Fraction(value) != x:
        raise ArithmeticError("not a double")
    return value


def double(draw, q=None, kind=None):
    """P = (u - d)^2 R(u) with R(u0) = rho^2, all short: double roots of every kind, or triple ones."""
    while True:
        d, rho = draw.sign() * draw.short(2), draw.short(2)
        u0 = d + draw.sign() * draw.short(2)
        a = -(draw.sign() * draw.short(1) if q is None else q) / 2
        if kind == "triple":
            # R(d) = 0
            step = Fraction(u0) - Fraction(d)
            b = (Fraction(rho) ** 2 - Fraction(a) * (Fraction(u0) ** 2 - Fraction(d) ** 2)) / step
            g = -Fraction(a) * Fraction(d) ** 2 - b * Fraction(d)
        else:
            b = Fraction(draw.sign() * draw.short(2))
            g = Fraction(rho) ** 2 - Fraction(a) * Fraction(u0) ** 2 - b * Fraction(u0)
        a, D = Fraction(a), Fraction(d)
        P = [g * D**2, b * D**2 - 2 * g * D, a * D**2 - 2 * b * D + g, b - 2 * a * D, a]
        try:
            # r = -3/2 of a cubic coefficient
            force = exact_double(-P[2]), exact_double(-3 * P[3] / 2), exact_double(-2 * P[4]), exact_double(P[1] / 2)
            yield u0, draw.sign() * exact_double((Fraction(u0) - D) * Fraction(rho)), *force
        except ArithmeticError:
            continue


def chosen(draw, source, regimes, count):
    """The first orbits of a generator in one of the regimes."""
    found = []
    for orbit in source:
        if regime_of(orbit) in regimes.split():
            found.append(orbit)
            if len(found) == count:
                return found
    return found


def homoclinic(draw):
    yield from chosen(draw, double(draw, 1.0), "homoclinic", 5)
    yield from chosen(draw, double(draw), "homoclinic", 7)


def double_elsewhere(draw):
    """A double root that the bounded motion does not reach: trigonometric motions."""
    yield from chosen(draw, double(draw, 1.0), "libration well", 5)
    yield from chosen(draw, double(draw, 0.5), "libration well", 3)


def double_escape(draw):
    """Escapes from or beside a double root: hyperbolic and trigonometric ones."""
    yield from chosen(draw, double(draw, -1.0), "escape", 6)
    yield from chosen(draw, double(draw, -0.5), "escape", 6)


def triple(draw):
    yield from chosen(draw, double(draw, 1.0, "triple"), "homoclinic", 4)
    yield from chosen(draw, double(draw, -1.0, "triple"), "homoclinic escape", 4)


def two_double(draw):
    """P = s^2 ((u - m)^2 - w)^2: heteroclinic between, coth outside, w < 0 tan, w = 0 a quadruple root."""
    while True:
        s, m, u0 = draw.short(1), draw.sign() * draw.short(2), draw.sign() * draw.short(2)
        w = draw.short(2) * draw.short(2) if draw.getrandbits(2) else 0.0
        w *= draw.sign()
        S, M, W, x = (*map(Fraction, (s, m, w)), Fraction(u0) - Fraction(m))
        square = [(M * M - W) ** 2, -4 * M * (M * M - W), 6 * M * M - 2 * W, -4 * M, Fraction(1)]
        P = [S * S * g for g in square]
        v0 = S * (x * x - W)
        if v0:
            force = exact_double(-P[2]), exact_double(-3 * P[3] / 2), exact_double(-2 * P[4]), exact_double(P[1] / 2)
            yield u0, draw.sign() * exact_double(v0), *force, w


def heteroclinic(draw):
    source = (orbit[:-1] for orbit in two_double(draw) if orbit[-1] > 0)
    yield from chosen(draw, source, "heteroclinic", 8)


def coth(draw):
    source = (orbit[:-1] for orbit in two_double(draw) if orbit[-1] > 0)
    yield from chosen(draw, source, "escape", 6)


def tangent(draw):
    yield from first((orbit[:-1] for orbit in two_double(draw) if orbit[-1] < 0), 5)


def quadruple(draw):
    yield from first((orbit[:-1] for orbit in two_double(draw) if orbit[-1] == 0), 4)


def last_double(draw):
    """Exact double roots with one input moved to the next double, either way."""
    for source in (
        homoclinic,
        heteroclinic,
        triple,
        double_elsewhere,
        double_escape,
        coth,
        tangent,
        quadratic_separatrix,
    ):
        for orbit in list(source(draw))[:5]:
            for side in (-math.inf, math.inf):
                places = [k for k, x in enumerate(orbit) if x and (k != 4 or source is not quadratic_separatrix)]
                k = places[draw.getrandbits(16) % len(places)]
                moved = list(orbit)
                moved[k] = math.nextafter(orbit[k], side)
                yield tuple(moved)


def quadratic_separatrix(draw):
    """q = 0 and P = a (u - d)^2 (u - b), exactly: sech^2, csch^2, sec^2, or 1/t^2."""
    for k in range(12):
        d, rho, step = draw.sign() * draw.short(2), draw.short(2), draw.sign() * draw.short(2)
        u0, a = d + step, draw.sign() * draw.short(1)
        A, D, U, rho2 = Fraction(a), Fraction(d), Fraction(u0), Fraction(rho) ** 2
        # R(u) = A u + g with R(u0) = rho^2; a triple root where R(d) = 0
        if k % 4 == 3:
            A = rho2 / (U - D)
        g = rho2 - A * U
        P = [g * D * D, A * D * D - 2 * g * D, g - 2 * A * D, A]
        try:
            force = exact_double(-P[2]), exact_double(-3 * P[3] / 2), 0.0, exact_double(P[1] / 2)
        except ArithmeticError:
            continue
        yield u0, draw.sign() * exact_double((U - D) * Fraction(rho)), *force
