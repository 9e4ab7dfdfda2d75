"""The inputs of the elliptic vectors: parameters in every range, arguments where the functions are hard to compute.

Parameters: m < 0, both sides of 1/2 and 1, mc and m down to 1e-300, m > 1, moduli of both signs.
Arguments: |u| and |phi| from 1e-300 to 1e15, signed zeros, the doubles nearest to n K and n pi/2 and their
neighbours. Random numbers are built from bits and IEEE operations only, so every host draws the same inputs.
"""

import math
import random
from fractions import Fraction

import ends_inputs
import mpmath as mp
from elliptic import outside, parameters
from exact import mpf, real

SEED = 1
HALVES = 2.0**53


def log_uniform(rng, low, high):
    """A double with uniform binary exponent in low..high-1 and uniform mantissa."""
    return math.ldexp(1 + rng.random(), rng.randrange(low, high))


def sign(rng):
    return rng.choice((-1.0, 1.0))


def neighbours(x, steps=2):
    """x and the doubles next to it on both sides."""
    low, high, found = x, x, [x]
    for _ in range(steps):
        low, high = math.nextafter(low, -math.inf), math.nextafter(high, math.inf)
        found += [low, high]
    return found


def either(rng, *pairs):
    """A log-uniform double from one of the ranges of binary exponents, chosen with equal chance."""
    return log_uniform(rng, *rng.choice(pairs))


PARAMETERS = {  # stratum: (given, fixed values, random draws)
    "m_negative": (
        "m",
        [-1.0, -0.5, -1e-300, -1e300, -1e16, -3.0],
        lambda rng: -either(rng, (-997, -60), (-60, 0), (0, 10), (10, 60), (60, 997)),
    ),
    "m_unit": (
        "m",
        [0.0, 1e-300, 2.0**-53, 0.1, *neighbours(0.5), 0.25, 0.75, 0.9, 0.99, math.nextafter(1.0, 0.0), 1 - 2.0**-40],
        lambda rng: rng.random() if rng.random() < 0.6 else either(rng, (-997, -60), (-60, -2)),
    ),
    "m_one": ("m", [1.0], lambda rng: 1.0),
    "m_above": (
        "m",
        [math.nextafter(1.0, 2.0), 1 + 2.0**-40, 2.0, 4.0, 1e16, 1e300],
        lambda rng: rng.choice((1 + log_uniform(rng, -50, 0), log_uniform(rng, 1, 60))),
    ),
    "mc_small": (
        "mc",
        [1e-300, 1e-200, 1e-100, 1e-30, 1e-16, 2.0**-53, 2.0**-54, 1e-8],
        lambda rng: either(rng, (-997, -60), (-60, -10)),
    ),
    "mc_unit": ("mc", [0.0, 0.1, *neighbours(0.5), 0.9, math.nextafter(1.0, 0.0), 1.0], lambda rng: rng.random()),
    "mc_above": (
        "mc",
        [math.nextafter(1.0, 2.0), 2.0, 1e16, 1e300],
        lambda rng: rng.choice((1 + log_uniform(rng, -50, 0), either(rng, (1, 60), (60, 997)))),
    ),
    "mc_negative": (
        "mc",
        [-1e-300, -1e-100, -1e-16, -1.0, -1e16],
        lambda rng: -either(rng, (-997, -60), (-60, -1), (-1, 60)),
    ),
    "k_unit": (
        "k",
        [1.0, -1.0, 0.5, -0.5, 0.0, -0.0, 1e-150, math.nextafter(1.0, 0.0), math.sqrt(0.5)],
        lambda rng: sign(rng) * (rng.random() if rng.random() < 0.7 else log_uniform(rng, -500, -1)),
    ),
    "k_above": (
        "k",
        [math.nextafter(1.0, 2.0), -2.0, 1e8, -1e150],
        lambda rng: sign(rng) * rng.choice((1 + log_uniform(rng, -50, 0), log_uniform(rng, 1, 50))),
    ),
}


def drawn(rng, stratum, count):
    """count parameters of a stratum: every fixed value first, then random ones."""
    given, fixed, draw = PARAMETERS[stratum]
    return given, [*fixed, *(draw(rng) for _ in range(count - len(fixed)))][:count]


def quarter(given, parameter):
    """K for m < 1, Re K = K(1/m)/sqrt(m) for m > 1, infinity at m = 1."""
    m, mc = parameters(given, parameter)
    with mp.workdps(60):
        if m == 1:
            return mp.inf
        if m < 1:
            return mp.elliprf(0, real(mc), 1)
        return mp.elliprf(0, real(-mc / m), 1) / mp.sqrt(real(m))


def item(stratum, given, parameter, **argument):
    ((name, value),) = argument.items()
    return {"stratum": stratum, "given": given, "parameter": parameter.hex(), name: value.hex()}


def jacobi():
    """One ladder of |u| per parameter stratum, then n K, signed zeros, and phases past 2^53 half periods."""
    for stratum in PARAMETERS:
        rng = random.Random(f"{SEED} jacobi {stratum}")
        given, values = drawn(rng, stratum, 180)
        for i, parameter in enumerate(values):
            K = quarter(given, parameter)
            limit = min(mpf(10) ** 15, HALVES * K) if mp.isfinite(K) else mpf(800)
            top = min(50, int(mp.mag(limit)) - 1)
            low, high = [(-997, -30), (-30, -2), (-2, 4), (0, 10), (4, 50)][i % 5]
            middle = 0 if mp.isinf(K) else max(-997, min(0, int(mp.mag(K))))
            low, high = max(-997, low + middle), min(top, high + middle)
            u = sign(rng) * log_uniform(rng, min(low, high - 1), high)
            yield item(stratum, given, parameter, u=u)
    rng = random.Random(f"{SEED} jacobi at_nk")
    for i in range(90):
        stratum = [name for name in PARAMETERS if name != "m_one"][i % 9]
        given, values = drawn(rng, stratum, 30)
        parameter = rng.choice([p for p in values if parameters(given, p)[0] != 1])
        n = (1, 2, 3, 4, 5, 6, 7, 101, rng.randrange(10, 10**6), rng.randrange(10**6, 10**10))[i % 10]
        u = sign(rng) * float(n * quarter(given, parameter))
        near = u * (1 + sign(rng) * log_uniform(rng, -50, -10))
        for value in [*neighbours(u), near, u * (1 + sign(rng) * log_uniform(rng, -50, -10))]:
            yield item("at_nk", given, parameter, u=value)
    for stratum in PARAMETERS:
        rng = random.Random(f"{SEED} jacobi zero {stratum}")
        given, values = drawn(rng, stratum, 30)
        for parameter in (values[0], rng.choice(values)):
            for u in (0.0, -0.0):
                yield item("signed_zero", given, parameter, u=u)
    rng = random.Random(f"{SEED} jacobi far")
    for i in range(60):
        stratum = ("m_negative", "m_unit", "m_above", "mc_small", "mc_above", "mc_negative")[i % 6]
        given, values = drawn(rng, stratum, 40)
        parameter = rng.choice(values)
        u = sign(rng) * float(quarter(given, parameter) * mpf(log_uniform(rng, 54, 100)))
        yield item("far", given, parameter, u=u)
    rng = random.Random(f"{SEED} jacobi across_nk")
    for _ in range(20):  # am and dn across n K at mc next to zero
        parameter = log_uniform(rng, -60, -5)
        n = 2 * rng.randrange(0, 50) + 1
        u = float(n * quarter("mc", parameter))
        for step in range(-5, 6):
            yield item("across_nk", "mc", parameter, u=u * (1 + step * 2.0**-46))


def jacobi_special():
    values = [("m", x) for x in (1.0, 0.0, 0.5, -3.0, 2.0)]
    values += [("mc", 0.0), ("mc", 0.5), ("k", 1.0), ("k", -1.0)]
    for given, parameter in values:
        for u in (math.inf, -math.inf, math.nan):
            yield item("argument", given, parameter, u=u)
    for given in ("m", "mc", "k"):
        for parameter in (math.nan, math.inf, -math.inf):
            for u in (0.0, 1.0, -2.5, math.inf, math.nan):
                yield item("parameter", given, parameter, u=u)
    for given, parameter in [*values, ("m", -0.0), ("k", -0.0)]:
        for u in (0.0, -0.0, 5e-324, -5e-324):
            yield item("zero", given, parameter, u=u)


def complete():
    for stratum in PARAMETERS:
        if stratum == "m_one":
            continue
        rng = random.Random(f"{SEED} complete {stratum}")
        given, values = drawn(rng, stratum, 20 if stratum in ("m_above", "mc_negative", "k_above") else 100)
        for parameter in values:
            yield {"stratum": stratum, "given": given, "parameter": parameter.hex()}
    for given, values in (("m", (1.0, 0.0, -0.0)), ("mc", (0.0, -0.0, 1.0)), ("k", (1.0, -1.0, 0.0, -0.0))):
        for parameter in (*values, math.nan, math.inf, -math.inf):
            yield {"stratum": "special", "given": given, "parameter": parameter.hex()}


def incomplete():
    """phi ladders for every parameter, the doubles next to n pi/2, the edge of the domain for m > 1."""
    for stratum in PARAMETERS:
        rng = random.Random(f"{SEED} incomplete {stratum}")
        given, values = drawn(rng, stratum, 100)
        for i, parameter in enumerate(values):
            m, _ = parameters(given, parameter)
            phi = log_uniform(rng, *[(-997, -30), (-30, -2), (-2, 1), (0, 10), (4, 50)][i % 5])
            if m > 1:  # inside the domain, its edge, or outside
                with mp.workdps(60):
                    edge = mp.asin(1 / mp.sqrt(real(m)))
                    share = [
                        mpf(rng.random()),
                        1 - mpf(log_uniform(rng, -50, -2)),
                        mpf(log_uniform(rng, -900, -1)),
                        mpf(rng.random()),
                    ][i % 4]
                    phi = float(edge * share)
                inside = [x for x in neighbours(float(edge)) if not outside(Fraction(x), m)]
                if i % 4 == 3:
                    phi = max(inside)
                elif i % 20 == 18:
                    phi = math.nextafter(max(inside), math.inf)
                elif i % 20 == 13:
                    phi = 2 * max(inside)
            elif m == 1 and i % 5 > 2 and i % 2:
                phi = rng.uniform(0, math.pi / 2)
            yield item(stratum, given, parameter, phi=sign(rng) * phi)
    rng = random.Random(f"{SEED} incomplete at_pi")
    for i in range(60):
        stratum = ("m_negative", "m_unit", "mc_small", "mc_unit", "mc_above", "k_unit", "m_one")[i % 7]
        given, values = drawn(rng, stratum, 30)
        parameter = rng.choice(values)
        n = (1, 2, 3, 4, 5, 6, 7, 101, rng.randrange(10, 10**6), rng.randrange(10**6, 10**14))[i % 10]
        with mp.workdps(60):
            phi = sign(rng) * float(n * mp.pi / 2)
        for value in neighbours(phi):
            yield item("at_half_pi", given, parameter, phi=value)
    for stratum in PARAMETERS:
        rng = random.Random(f"{SEED} incomplete zero {stratum}")
        given, values = drawn(rng, stratum, 30)
        for phi in (0.0, -0.0):
            yield item("signed_zero", given, rng.choice(values), phi=phi)
    values = [("m", x) for x in (0.5, 1.0, 0.0, -2.0, 2.0)] + [("mc", 0.0), ("k", -1.0)]
    for given, parameter in values:
        for phi in (math.inf, -math.inf, math.nan):
            yield item("special", given, parameter, phi=phi)
    for given in ("m", "mc", "k"):
        for parameter in (math.nan, math.inf, -math.inf):
            for phi in (0.0, 1.0, -0.5):
                yield item("special", given, parameter, phi=phi)


def rows(name):
    draw = {
        "jacobi.csv": jacobi,
        "jacobi_special.csv": jacobi_special,
        "complete.csv": complete,
        "incomplete.csv": incomplete,
    }[name]
    return [*draw(), *ends_inputs.rows(name)]
