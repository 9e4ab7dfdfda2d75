"""Checks the vectors of the approximations: a sample derived again, errors by the mean of Arb.

Mutated rows must fail. Called by check.py.
"""

import math
from fractions import Fraction

import approx_period
import approx_sine
import exact
from flint import arb, ctx, fmpq
from table import fail

FILES = {"approx_period.csv": (approx_period, 150), "approx_sine.csv": (approx_sine, 10)}


def ball(row, name):
    hi, lo = (Fraction(float.fromhex(row[f"{name}_{word}"])) for word in ("hi", "lo"))
    return arb(fmpq((hi + lo).numerator, (hi + lo).denominator))


def contradicts(row):
    """Whether error is not ratio agm(1, cos(theta_max/2)) - 1 to what both columns hold."""
    values = [float.fromhex(row[name]) for name in ("ratio_hi", "error_hi")]
    argument = Fraction(float.fromhex(row["argument"]))
    # At the top the error is -1 by convention.
    top = argument == {"m": 1, "mc": 0}.get(row["given"])
    if not all(map(math.isfinite, values)) or top:
        return False
    ctx.prec = 2400
    x = arb(fmpq(argument.numerator, argument.denominator))
    a = {"theta_max": lambda: (x / 2).cos(), "m": lambda: (1 - x).sqrt(), "mc": x.sqrt}[row["given"]]()
    apart = abs(ball(row, "ratio") * a.agm(arb(1)) - 1 - ball(row, "error"))
    return not apart < arb(2) ** -104 * (1 + abs(ball(row, "error")))


def check(name, every, rng):
    """Fails at the first row of a file that is not what it should be; says how many are."""
    generator, count = FILES[name]
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != generator.HEADER:
        fail(name, "columns differ from the generator's")
    count_of = f"{len(rows) // len(generator.FORMULAS)} a formula" if name == "approx_period.csv" else len(rows)
    if f"| `{name}` | {count_of} |" not in (exact.ROOM / "README.md").read_text():
        fail("README.md lacks the count of", name, count_of)
    given = list(generator.inputs())
    if [{key: row[key] for key in given[0]} for row in rows] != given:
        fail(name, "inputs are not what the generator draws")
    sample = rows if every else rng.sample(rows, count)
    for row in sample:
        if generator.row(row) != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    if name == "approx_period.csv":
        hold_errors(rows)
    return f"{len(rows)} rows, {len(sample)} derived again"


def hold_errors(rows):
    """Every error by the mean of Arb; two mutated columns must fail."""
    for row in rows:
        if contradicts(row):
            fail("approx_period.csv: Arb's mean contradicts", row)
    steady = next(row for row in rows if 1e-3 < abs(float.fromhex(row["error_hi"])) < 0.9)
    for column in ("ratio_lo", "error_lo"):
        moved = float.fromhex(steady[column]) + float.fromhex(steady["ratio_hi"]) * 2.0**-98
        if not contradicts({**steady, column: moved.hex()}):
            fail("approx_period.csv: a mutated", column, "passes")
