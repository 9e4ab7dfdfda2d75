"""Another method for vectors/approx_angle.csv: the parts of the formulas, computed by other formulas.

Amplitudes of the series by the trapezoidal rule from the exact motion; the motions of polynomial sines by their equation and
start; Taylor coefficients by numerical differentiation of the exact angle; the formula of small m by numerical
differentiation of the exact one by m. Only for rows where this converges; the tests check the others.
"""

from collections import Counter
from fractions import Fraction

import approx_angle
import mpmath as mp
from approx_angle import Motion, Released
from exact import mpf, real

SAMPLES = 128
AGREE = mpf(10) ** -25


def amplitudes(motion, order, value):
    """Of sin(j phase), j = 1, 3, ..., from `value` of the angle over one period."""
    sums = [mpf(0)] * order
    for i in range(SAMPLES):
        phase = 2 * mp.pi * (i + mpf(1) / 3) / SAMPLES
        t = (phase * 2 * motion.K / mp.pi - motion.start) / motion.omega
        wave = value(motion.theta(t) - motion.base)
        for n in range(order):
            sums[n] += 2 * wave * mp.sin((2 * n + 1) * phase) / SAMPLES
    return sums


def twice_arcsine(sine):
    return None if abs(sine) > 1 else 2 * mp.asin(sine)


def series(motion, t, order, value, back):
    phase = mp.pi * motion.argument(t) / (2 * motion.K)
    found = amplitudes(motion, order, value)
    total = back(sum(a * mp.sin((2 * n + 1) * phase) for n, a in enumerate(found)))
    return mp.nan if total is None else motion.base + total


def oscillator(motion, t, gamma):
    """The angle, if it obeys its equation there and starts as it should; else a number far away."""
    released = Released(motion, gamma)
    if released.escapes:
        return mp.nan
    with mp.extradps(30):
        u, acceleration = released.theta(t), mp.diff(released.theta, t, 2, h=mpf(2) ** -60)
        residual = acceleration + motion.omega**2 * (u + released.beta * u**3 + gamma * u**5)
        start = [released.theta(mpf(0)) - motion.theta0, mp.diff(released.theta, 0, h=mpf(2) ** -60) - motion.velocity0]
    return u if all(abs(rest) < AGREE * (1 + motion.omega**2) for rest in [residual, *start]) else mpf(10) ** 6


def small(motion, t):
    """To first order in the parameter of sn, cn, dn, by differences about 0."""
    s, c, x, u = motion.s, motion.c, motion.x, motion.omega * t

    def tangent(m):
        sn, cn, dn = (mp.ellipfun(name, u, m=m).real for name in ("sn", "cn", "dn"))
        return (s * c * cn + x * dn * sn) / (c * c - x * x * sn * sn)

    with mp.extradps(60):
        slope = mp.diff(tangent, 0, h=mpf(2) ** -110)
        return motion.base + 2 * mp.atan(tangent(mpf(0)) + motion.m * slope)


def measured(row):
    """The angle of a row by the second route, None where that would not converge."""
    name, _, order = row["formula"].partition(":")
    theta0, velocity0, omega2, time = (Fraction(float.fromhex(row[column])) for column in approx_angle.INPUTS[3:])
    motion, t, order = Motion(theta0, velocity0, omega2), real(time), int(order or 0)
    if name in ("cubic", "cubic-quintic") and abs(t) * motion.omega < 100:
        return oscillator(motion, t, mpf(0) if name == "cubic" else mpf(1) / 131)
    if name == "taylor" and order <= 4 and row["stratum"] != "small":
        return sum(a * t**k for k, a in enumerate(mp.taylor(motion.theta, 0, order)))
    if name == "small-m" and motion.regime == "libration" and abs(t) * motion.omega < 20:
        return small(motion, t)
    if name.startswith("fourier") and motion.regime == "libration" and 1e-4 < motion.m < 0.9:
        if name == "fourier-theta":
            return series(motion, t, order, lambda angle: angle, lambda total: total)
        return series(motion, t, order, lambda angle: mp.sin(angle / 2), twice_arcsine)
    return None


def wrong(row):
    """Whether the second route contradicts a row; None where there is none."""
    with mp.workdps(70):
        value = measured(row)
        if value is None:
            return None
        stored = mpf(float.fromhex(row["theta_hi"])) + mpf(float.fromhex(row["theta_lo"]))
        if mp.isnan(value) or mp.isnan(stored):
            return not (mp.isnan(value) and mp.isnan(stored))
        return abs(value - stored) > AGREE * (mpf(row["scale"]) + mpf(row["cond_theta"]))


KINDS = ("fourier", "fourier-theta", "small-m", "cubic", "cubic-quintic", "taylor")
EACH = 2


def main(fail, rows, everything):
    """Fails at the first contradiction; every kind of formula must have been seen, and a mutated row must fail."""
    seen = Counter()
    for row in rows:
        kind = row["formula"].partition(":")[0]
        if kind not in KINDS or (seen[kind] == EACH and not everything):
            continue
        found = wrong(row)
        if found:
            fail("approx_angle.csv: the second route contradicts", row)
        if found is None or row["theta_lo"] == "0x0.0p+0":
            continue
        moved = float.fromhex(row["theta_hi"]) * (1 + 2.0**-45)
        if not seen[kind] and not wrong({**row, "theta_hi": moved.hex()}):
            fail("approx_angle.csv: a mutated row passes", row)
        seen[kind] += 1
    if any(seen[kind] < EACH for kind in KINDS):
        fail("approx_angle.csv: too few rows for the second route", dict(seen))
