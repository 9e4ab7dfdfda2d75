"""Reference values for the formulas of the period; writes vectors/approx_period.csv. Run: python approx_period.py (ten seconds).

T/T0 by each formula as its source prints it, and its relative error against 2K(m)/pi, with mpmath's K at 120 digits.
The series in theta_max are the hypergeometric series of K in m with the powers of m = sin^2(theta_max/2) put in.
Columns: the formula, what is given (`theta_max`, `m` or its complement `mc`), the argument, ratio and error as hi + lo.
"""

import math
import random
from fractions import Fraction
from functools import cache

import exact
import mpmath as mp
from exact import mpf, real

NAME = "approx_period.csv"
HEADER = "formula given argument ratio_hi ratio_lo error_hi error_lo".split()
DIGITS = 120
NAN = mp.nan


@cache
def coefficients(power):
    """Of T/T0 in theta_max^2, up to theta_max^power: exact enough for the cancellation of the composition."""
    count = power // 2 + 1
    with mp.workdps(DIGITS + 2 * power):
        m = [mpf(0)] + [(-1) ** (k + 1) / (2 * mp.factorial(2 * k)) for k in range(1, count)]
        total, term, weight = [mpf(0)] * count, [mpf(1)] + [mpf(0)] * (count - 1), mpf(1)
        for j in range(count):
            total = [a + weight * b for a, b in zip(total, term, strict=True)]
            weight *= (mpf(2 * j + 1) / (2 * j + 2)) ** 2
            term = [mp.fsum(term[i] * m[k - i] for i in range(j, k)) for k in range(count)]
        return total


def agm(a, steps):
    mean, b = mpf(1), a
    for _ in range(steps):
        mean, b = (mean + b) / 2, mp.sqrt(mean * b)
    return 1 / mean


def chachiyo(a):
    n = mp.log(4 / mp.pi) / (mp.pi / 2 - mp.log(4))
    b = mp.exp(n * mp.pi / 2) - mpf(4) ** n
    return mp.log((4 / a) ** n + b) * 2 / (n * mp.pi)


def root(x):
    return 1 / mp.sqrt(x)


OF_ANGLE = {
    "linear": lambda x: mpf(1),
    "bernoulli": lambda x: 1 + x**2 / 16,
    "denman": lambda x: 1 / (1 - x**2 / 16),
    "molina": lambda x: (mp.sin(x) / x) ** (-mpf(3) / 8),
    "ganley-parwani": lambda x: root(mp.sin(mp.sqrt(3) * x / 2) / (mp.sqrt(3) * x / 2)),
}
SERIES = (2, 4, 6, 8, 20, 60, 200)
OF_A = {
    "kidd-fogg": root,
    "lima-arun": lambda a: -mp.log(a) / (1 - a),
    **{f"agm:{n}": lambda a, n=n: agm(a, n) for n in range(1, 9)},
    "belendez": lambda a: 4 / (1 + mp.sqrt(a)) ** 2,
    "cromer": lambda a: 2 / mp.pi * mp.log(4 / a),
    "chachiyo": chachiyo,
}
OF_M = {
    "salas-26": lambda m: (5 * m - 16) / (9 * m - 16),
    "salas-27": lambda m: (409 * m**2 - 3984 * m + 4864) / (1025 * m**2 - 5200 * m + 4864),
    "salas-28": lambda m: (
        (540191 * m**3 - 10617024 * m**2 + 32584960 * m - 24653824)
        / (1708091 * m**3 - 16837184 * m**2 + 38748416 * m - 24653824)
    ),
    "exact": lambda m: 2 * mp.ellipk(m) / mp.pi,
}
FORMULAS = [*OF_ANGLE, *(f"series:{n}" for n in SERIES), *OF_A, *OF_M]


def ratio(formula, given, argument):
    """T/T0 and m; the working precision must cover what is lost next to the ends."""
    x = real(argument)
    m = {"theta_max": lambda: mp.sin(x / 2) ** 2, "m": lambda: x, "mc": lambda: 1 - x}[given]()
    if m == 1 and formula not in OF_M:
        growing = {"kidd-fogg", "lima-arun", "cromer", "chachiyo", "molina"}
        if formula in growing:
            return mp.inf, m
    angle = x if given == "theta_max" else 2 * mp.asin(mp.sqrt(m)) if m >= 0 else NAN
    if formula == "linear":
        return mpf(1), m
    if formula in OF_ANGLE:
        return (OF_ANGLE[formula](angle) if m >= 0 else NAN), m
    if formula.startswith("series:"):
        power = int(formula.partition(":")[2])
        return (mp.polyval(coefficients(power)[::-1], angle**2) if m >= 0 else NAN), m
    if formula in OF_A:
        return OF_A[formula](mp.cos(x / 2) if given == "theta_max" else mp.sqrt(x if given == "mc" else 1 - m)), m
    return OF_M[formula](m), m


def both(formula, given, argument):
    value, m = ratio(formula, given, argument)
    if m == 1:
        return value, (mpf(-1) if mp.isfinite(value) else NAN)
    if m == 0:
        return (value, value - 1)
    return value, (mpf(0) if formula == "exact" else value / OF_M["exact"](m) - 1)


def row(inputs):
    formula, given = inputs["formula"], inputs["given"]
    argument = Fraction(float.fromhex(inputs["argument"]))
    values = []
    # Next to rest m is the square of the angle, and 1 - a half of that again; a complement is small next to the top.
    near = [abs(x) for x in ((argument, 1 - argument) if given == "mc" else (argument,)) if x]
    lost = 5 * max(0, -math.floor(min(mp.log10(real(x)) for x in near))) if near else 0
    rest = argument == (1 if given == "mc" else 0)
    for digits in (DIGITS + lost, DIGITS + lost + 60):
        with mp.workdps(digits):
            if rest and formula in ("molina", "ganley-parwani", "lima-arun"):
                values.append((mpf(1), mpf(0)))
            else:
                values.append(both(formula, given, argument))
    with mp.workdps(60):
        for a, b in zip(*values, strict=True):
            assert a == b or (mp.isnan(a) and mp.isnan(b)) or abs(a - b) < mpf(10) ** -75 * (1 + abs(b)), inputs
        ratio_, error = values[1]
        return [formula, given, inputs["argument"], *exact.hi_lo(ratio_), *exact.hi_lo(error)]


def inputs():
    """Round angles and parameters, both ends, and some of no preference."""
    drawn = random.Random(6)
    degrees = (0.1, 1, 10, 30, 45, 60, 70, 90, 100, 120, 135, 150, 160, 170, 175, 179, 179.9)
    angles = [0.0, 1e-200, 1e-8, 1e-5, *(math.radians(x) for x in degrees), 3.14159265, math.pi]
    angles += [drawn.uniform(0, 3.14) for _ in range(8)]
    parameters = [0.0, 1e-300, -1e-300, 1e-20, -1e-9, 1 / 3, -1 / 3, 0.5, 0.75, -0.75, 0.999, 1 - 2.0**-53, 1.0]
    parameters += [-1.0, -40.0, -1e12, -1e300, *(drawn.uniform(-1, 1) for _ in range(6))]
    complements = [0.0, 1e-300, 1e-200, 1e-100, 1e-50, 1e-30, 1e-16, 1e-9, 1e-3, 0.25, 1 - 2.0**-53, 1.0, 1 + 2.0**-52]
    complements += [1.5, 2.0, 41.0, 1e12, 1e300, *(10 ** drawn.uniform(-30, 0) for _ in range(3))]
    for formula in FORMULAS:
        for given, values in (("theta_max", angles), ("m", parameters), ("mc", complements)):
            for value in values:
                yield {"formula": formula, "given": given, "argument": value.hex()}


if __name__ == "__main__":
    exact.write(NAME, HEADER, (row(given) for given in inputs()))
