"""Writes vectors/pendulum_corners.csv: the pendulum at inputs where other programs fail, with omega2 = a b / c exactly.

Strata: omega0 given, gravity and length given, omega2 < 0, omega2 = 0, subnormal amplitudes, huge angles,
extreme frequencies, states tuned to the separatrix, 1e6 to 1e9 periods, starts next to n pi.
Random numbers are built from bits and IEEE operations only, so every host draws the same inputs.
Run: python corners.py (about half a minute).
"""

import math
import random
from fractions import Fraction

import exact
import mpmath as mp
import orbit
from exact import mpf, real

NAME = "pendulum_corners.csv"
INPUTS = "id stratum theta0 velocity0 omega2_a omega2_b omega2_c t".split()
HEADER = ["id", "stratum", "regime", *INPUTS[2:], *orbit.OUTPUTS[1:]]
ONE = (1.0, 1.0, 1.0)
SEED = 1


def log_uniform(rng, low, high):
    """A double with uniform binary exponent in low..high-1 and uniform mantissa."""
    return math.ldexp(1 + rng.random(), rng.randrange(low, high))


def sign(rng):
    return rng.choice((-1.0, 1.0))


def omega2_of(abc):
    a, b, c = (Fraction(x) for x in abc)
    return a * b / c


def energy(rng):
    """An energy ratio: libration, rotation, or close to the separatrix from either side."""
    kind = rng.randrange(4)
    if kind == 0:
        return mpf(rng.uniform(0.001, 0.999))
    if kind == 1:
        return 1 + mpf(log_uniform(rng, -6, 10))
    if kind == 2:
        return 1 + mpf(sign(rng) * log_uniform(rng, -48, -6))
    return mpf(log_uniform(rng, -40, 0))


def state(rng, abc, m):
    """Doubles theta0, velocity0 whose energy ratio is about m."""
    with mp.workdps(60):
        k = mp.sqrt(m)
        reach = 2 * mp.asin(k) if m < 1 else mp.pi
        offset = mpf(rng.uniform(-0.98, 0.98)) * reach
        rate = 2 * mp.sqrt(real(abs(omega2_of(abc)))) * mp.sqrt(m - mp.sin(offset / 2) ** 2)
        base = mp.pi if omega2_of(abc) < 0 else 0
        return float(base + offset), sign(rng) * float(rate)


def instant(rng, theta0, velocity0, abc, low=-1.5, high=4.0):
    """A time of low to high periods."""
    return float(orbit.rough_period(theta0, velocity0, omega2_of(abc)) * mpf(rng.uniform(low, high)))


def moving(rng, abc, m=None, low=-1.5, high=4.0):
    theta0, velocity0 = state(rng, abc, energy(rng) if m is None else m)
    return theta0, velocity0, abc, instant(rng, theta0, velocity0, abc, low, high)


def omega0(rng, i):
    w = rng.choice((2.0, 0.1, 3.7, math.pi)) if i % 3 == 0 else log_uniform(rng, -20, 20)
    if i % 15 == 14:  # exactly on the separatrix
        v = sign(rng) * 2 * w
        return 0.0, v, (w, w, 1.0), rng.uniform(-30, 30) / w
    return moving(rng, (w, w, 1.0))


def gravity_length(rng, i):
    gravity = rng.choice((9.80665, 9.8, 9.81, 1.62, 24.79)) if i % 4 else log_uniform(rng, -10, 10)
    length = rng.choice((1.0, 0.1, 0.25, 0.994, 67.0)) if i % 2 else log_uniform(rng, -12, 12)
    abc = (gravity, 1.0, length)
    if i % 5 == 0:  # released from rest
        theta0 = sign(rng) * rng.uniform(0.01, math.pi)
        return theta0, 0.0, abc, instant(rng, theta0, 0.0, abc)
    return moving(rng, abc)


def negative(rng, i):
    abc = (-9.80665, 1.0, rng.choice((1.0, 0.5, 3.0))) if i % 2 else (-log_uniform(rng, -10, 10), 1.0, 1.0)
    w = math.sqrt(-abc[0] / abc[2])
    if i < 3:  # upright and at rest: the equilibrium itself
        return 0.0, 0.0, abc, (0.0, 1.5, -40.0)[i] / w
    if i < 12:  # next to upright
        theta0 = 0.0 if i % 3 == 0 else sign(rng) * log_uniform(rng, -60, -10)
        velocity0 = sign(rng) * w * log_uniform(rng, -50, 1) if i % 2 else 0.0
        if theta0 == 0 and velocity0 == 0:
            velocity0 = w
        return theta0, velocity0, abc, instant(rng, theta0, velocity0, abc)
    if i < 20:  # next to hanging, several turns up
        theta0 = (2 * rng.randrange(-5, 5) + 1) * math.pi
        velocity0 = rng.choice((0.0, w * log_uniform(rng, -40, 0)))
        return theta0, velocity0, abc, instant(rng, theta0, velocity0, abc)
    return moving(rng, abc)


def free(rng, i):
    theta0 = sign(rng) * log_uniform(rng, -30, 10)
    velocity0 = 0.0 if i % 5 == 0 else sign(rng) * log_uniform(rng, -40, 40)
    t = 0.0 if i % 7 == 3 else sign(rng) * log_uniform(rng, -20, 20)
    return (0.0 if i % 6 == 1 else theta0), velocity0, (0.0, 1.0, 1.0), t


def subnormal(rng, i):
    abc = ONE if i % 2 else (9.80665, 1.0, log_uniform(rng, -6, 6))
    w = math.sqrt(abc[0] / abc[2])
    theta0 = 0.0 if i % 5 == 1 else sign(rng) * log_uniform(rng, -1064, -963)
    velocity0 = 0.0 if i % 5 == 2 else sign(rng) * w * log_uniform(rng, -1064, -963)
    return theta0, velocity0, abc, instant(rng, theta0, velocity0, abc, -3, 10)


def huge_angle(rng, i):
    theta0 = sign(rng) * (log_uniform(rng, 50, 1000) if i % 3 else log_uniform(rng, 50, 60))
    abc = ONE if i % 2 else (9.80665, 1.0, 0.25)
    w = math.sqrt(abc[0] / abc[2])
    velocity0 = 0.0 if i % 6 == 0 else sign(rng) * w * rng.uniform(0, 2.5)
    return theta0, velocity0, abc, instant(rng, theta0, velocity0, abc)


def extreme_omega(rng, i):
    omega2 = log_uniform(rng, *((-963, -300) if i % 2 else (300, 963)))
    return moving(rng, (omega2, 1.0, 1.0))


def tuned_pairs(rng, wanted, starts=3000, window=2**18):
    """Pairs theta0, velocity0 (omega2 = 1) with velocity0 nearest to 2 cos(theta0/2).

    Along consecutive doubles theta0 + k ulp the scaled target is beta + alpha k mod 1 up to curvature,
    so the best k in a window is a closest vector of a plane lattice (reduced by Lagrange's algorithm)."""
    found = []
    for _ in range(starts):
        theta0 = rng.uniform(0.5, 2.5)
        with mp.workdps(60):
            target = 2 * mp.cos(mpf(theta0) / 2)
            unit = math.ulp(float(target))
            beta = float(target / unit - mp.floor(target / unit))
            alpha = float(-mp.sin(mpf(theta0) / 2) * math.ulp(theta0) / unit)
        weight = 1 / window**2
        p, q = (0.0, 1.0, 0), (weight, alpha, 1)
        while True:
            if p[0] ** 2 + p[1] ** 2 < q[0] ** 2 + q[1] ** 2:
                p, q = q, p
            r = round((p[0] * q[0] + p[1] * q[1]) / (q[0] ** 2 + q[1] ** 2))
            if r == 0:
                break
            p = tuple(a - r * b for a, b in zip(p, q, strict=True))
        det = p[0] * q[1] - p[1] * q[0]
        i, j = round(beta * q[0] / det), round(-beta * p[0] / det)
        for di in (-1, 0, 1):
            for dj in (-1, 0, 1):
                k = (i + di) * p[2] + (j + dj) * q[2]
                angle = theta0 + k * math.ulp(theta0)
                with mp.workdps(60):
                    c = mp.cos(mpf(angle) / 2)
                    v = float(2 * c)
                    found.append((abs(float((c - mpf(v) / 2) * (c + mpf(v) / 2))), angle, v))
    return [(angle, v) for _, angle, v in sorted(set(found))[:wanted]]


def tuned_quotient(rng, i):
    """A state, gravity and length with velocity0^2 length / gravity nearest to 4 cos(theta0/2)^2."""
    theta0 = rng.uniform(0.5, 2.5) if i % 2 else math.pi - log_uniform(rng, -13, -3)
    with mp.workdps(80):
        c = mp.cos(mpf(theta0) / 2)
        velocity0 = float(c * mpf(rng.uniform(2.1, 4.0)))
        ratio = exact.rational(4 * c * c / mpf(velocity0) ** 2).limit_denominator(2**53)
    assert ratio.numerator <= 2**53
    scale = rng.randrange(-56, -44)
    gravity, length = math.ldexp(ratio.denominator, scale), math.ldexp(ratio.numerator, scale)
    return theta0, velocity0, (gravity, 1.0, length)


def sep_tuned(rng, i, pairs):
    if i < len(pairs):
        theta0, velocity0 = pairs[i]
        abc = ONE
    else:
        theta0, velocity0, abc = tuned_quotient(rng, i)
    theta0, velocity0 = sign(rng) * theta0, sign(rng) * velocity0
    w = math.sqrt(abc[0] / abc[2])
    if i % 3 == 0:
        return theta0, velocity0, abc, rng.uniform(-15, 15) / w
    return theta0, velocity0, abc, instant(rng, theta0, velocity0, abc)


def billion(rng, i):
    abc = rng.choice((ONE, (9.80665, 1.0, 1.0), (9.8, 1.0, 0.994)))
    m = [
        1 - mpf(2) ** -40,
        1 + mpf(2) ** -40,
        mpf(rng.uniform(0.01, 0.99)),
        mpf(rng.uniform(1.01, 9)),
        mpf(log_uniform(rng, -60, -8)),
        mpf(log_uniform(rng, 8, 40)),
    ][i % 6]
    theta0, velocity0 = state(rng, abc, m)
    count = rng.randrange(10**6, 10**9) if i % 2 else int(log_uniform(rng, 20, 29))
    quarter = rng.choice((0, 0, 0, 0.25, 0.5, 0.75))
    with mp.workdps(60):
        T = orbit.rough_period(theta0, velocity0, omega2_of(abc))
        return theta0, velocity0, abc, sign(rng) * float(T * (count + mpf(quarter)))


def near_2pi_n(rng, i):
    n = rng.choice((1, 2, 3, 10, 100, 355 * 113, 10**6, rng.randrange(1, 10**9)))
    with mp.workdps(60):
        theta0 = sign(rng) * float(mp.pi * (2 * n + (i % 2)))
    for _ in range(rng.choice((0, 0, 1))):
        theta0 = math.nextafter(theta0, rng.choice((-math.inf, math.inf)))
    exponents = rng.choice(((-60, -45), (-300, -60), (-900, -300)))
    velocity0 = 0.0 if i % 3 == 0 else sign(rng) * log_uniform(rng, *exponents)
    return theta0, velocity0, ONE, instant(rng, theta0, velocity0, ONE)


STRATA = [
    (omega0, 60),
    (gravity_length, 60),
    (negative, 60),
    (free, 30),
    (subnormal, 40),
    (huge_angle, 50),
    (extreme_omega, 50),
    (sep_tuned, 72),
    (billion, 72),
    (near_2pi_n, 60),
]
TUNED_PAIRS = 32


def inputs():
    """All input rows, as dictionaries of text like the rows of the file."""
    number = 0
    for stratum, count in STRATA:
        rng = random.Random(f"{SEED} {stratum.__name__}")
        more = (tuned_pairs(rng, TUNED_PAIRS),) if stratum is sep_tuned else ()
        for i in range(count):
            number += 1
            theta0, velocity0, abc, t = stratum(rng, i, *more)
            values = [float(x).hex() for x in (theta0, velocity0, *abc, t)]
            yield dict(zip(INPUTS, [f"corner-{number:04d}", stratum.__name__, *values], strict=True))


def row(inputs):
    """One row of the file from its input columns."""
    theta0, velocity0, *abc, t = (float.fromhex(inputs[name]) for name in INPUTS[2:])
    regime, *outputs = orbit.outputs(theta0, velocity0, omega2_of(abc), t)
    return [inputs["id"], inputs["stratum"], regime, *(inputs[name] for name in INPUTS[2:]), *outputs]


if __name__ == "__main__":
    exact.write(NAME, HEADER, map(row, inputs()))
