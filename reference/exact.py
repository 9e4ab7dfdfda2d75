"""Exact conversions between doubles, rationals, mpmath numbers and text, and values accepted at two precisions.

Inputs are doubles taken as exact rationals. Outputs are written as hi + lo: hi is the double nearest
to the value, lo the double nearest to the value minus hi, so the pair carries about 106 bits.
A value is accepted when evaluations at P and at P + 30 digits agree to 50 digits.
"""

import csv
import math
from fractions import Fraction
from pathlib import Path

import mpmath as mp

mpf = mp.mpf
ROOM = Path(__file__).parent
VECTORS = ROOM / "vectors"


def real(fraction):
    """The rational as an mpf at the working precision."""
    return mpf(fraction.numerator) / fraction.denominator


def rational(x):
    """The exact rational value of a finite mpf."""
    sign, mantissa, exponent, _ = x._mpf_
    value = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -value if sign else value


def nearest(fraction):
    """The double nearest to a rational: int / int is correctly rounded in CPython, subnormals too."""
    try:
        return fraction.numerator / fraction.denominator
    except OverflowError:
        return math.inf if fraction > 0 else -math.inf


def hi_lo(x):
    """Two hex floats whose sum is x to about 106 bits; infinities and NaN have lo = 0."""
    if isinstance(x, float):
        return [x.hex(), (0.0).hex()]
    if mp.isnan(x) or mp.isinf(x):
        return [float(x).hex(), (0.0).hex()]
    if x == 0 or mp.mag(x) < -1200:
        return [(-0.0 if x < 0 else 0.0).hex(), (0.0).hex()]
    value = rational(x)
    hi = nearest(value)
    if math.isinf(hi):
        return [hi.hex(), (0.0).hex()]
    return [hi.hex(), (nearest(value - Fraction(hi)) + 0.0).hex()]


def decimal(x, digits):
    """Decimal text with this many significant digits, also outside the range of doubles."""
    if x == 0:
        return "0"
    return mp.nstr(x, digits, min_fixed=1, max_fixed=0, strip_zeros=False)


def agreement(a, b):
    """Relative difference; 0 for equal values, infinities and NaN alike."""
    if a == b or (mp.isnan(a) and mp.isnan(b)):
        return mpf(0)
    if not (mp.isfinite(a) and mp.isfinite(b)):
        return mpf(1)
    return abs(a - b) / max(abs(a), abs(b))


def agreed(evaluate, digits):
    """The (label, leads, others) of evaluate(), accepted when two working precisions agree.

    The label must be the same, leads agree to 50 digits, others (derivatives, condition numbers) to 30."""
    for _ in range(12):
        with mp.workdps(digits):
            label, leads, others = evaluate()
        with mp.workdps(digits + 30):
            label2, leads2, others2 = evaluate()
        with mp.workdps(60):
            same = label == label2
            same &= all(agreement(a, b) < mpf(10) ** -50 for a, b in zip(leads, leads2, strict=True))
            same &= all(agreement(a, b) < mpf(10) ** -30 for a, b in zip(others, others2, strict=True))
        if same:
            return label2, leads2, others2
        digits += 60
    raise ArithmeticError("two precisions do not agree")


def write(name, header, rows):
    """Write vectors/name; returns the number of rows."""
    rows = list(rows)
    with open(VECTORS / name, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
    print(f"{name}: {len(rows)} rows")
    return len(rows)


def read(path):
    """The rows of a CSV file as dictionaries."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))
