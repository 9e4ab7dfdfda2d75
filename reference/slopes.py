"""Checks of the derivative and condition columns: central differences of the ball formulas (balls.py).

The step is 2^-1600 of the input, so the truncation error is below every digit of the columns. The balls have 6000 bits and
more, which is enough for the cancellation. Columns of 25 digits must agree to 1e-23, of 6 digits to 1e-5.
"""

from fractions import Fraction

import balls
from flint import arb

STEP = Fraction(1, 2**1600)
FIRST = 6000


def by(formula, inputs, i, outputs, relative=True):
    """d output / d input i as balls; with relative the derivative times the input."""
    scale = abs(inputs[i]) if relative or inputs[i] else Fraction(1)
    if scale == 0:
        return {name: arb(0) for name in outputs}

    def difference():
        sides = []
        for sign in (1, -1):
            moved = list(inputs)
            moved[i] += sign * STEP * scale
            sides.append(formula(*moved))
        return {
            name: (sides[0][name] - sides[1][name]) / balls.ball(2 * STEP * (1 if relative else scale))
            for name in outputs
            if name in sides[0]
        }

    return balls.narrowed(difference, FIRST)


def differs(text, value, tolerance):
    """The decimal text is not the ball value to this relative tolerance."""
    if text == "0":
        return not value.contains(0)
    return not abs(arb(text) - value) <= abs(value) * arb(tolerance) + arb(2) ** -3000


def pendulum(name, row):
    inputs, formula = balls.arguments(name, row), balls.pendulum_values
    found, conditions = [], {"theta": arb(0), "velocity": arb(0), "period": arb(0)}
    for i, field in enumerate(("theta0", "velocity0", "omega2", "t")):
        slopes = by(formula, inputs, i, ("theta", "velocity"), relative=False)
        for output, slope in slopes.items():
            if field != "t" and differs(row[f"d{output}_d{field}"], slope, "1e-23"):
                found.append(f"d{output}_d{field}")
            conditions[output] += abs(slope * balls.ball(inputs[i]))
        if field != "t" and row["period_hi"] != "inf" and row["regime"] != "rest":
            conditions["period"] += abs(by(formula, inputs, i, ("period",))["period"])
    if row["regime"] == "rest" and row["period_hi"] != "inf":
        conditions["period"] = balls.ball(float.fromhex(row["period_hi"])) / 2
    return found + [
        f"cond_{output}" for output, value in conditions.items() if differs(row[f"cond_{output}"], value, "1e-5")
    ]


def elliptic(name, row):
    inputs, formula = balls.arguments(name, row), balls.VALUES[name]
    if inputs is None:
        return []
    m = balls.parameters(row["given"], inputs[1])[0]
    values = balls.narrowed(lambda: formula(*inputs))
    moved = {"jacobi.csv": [2], "complete.csv": [1] if m != 1 else [], "incomplete.csv": [2] if m == 1 else [1, 2]}[
        name
    ]
    if name == "incomplete.csv" and m == 1 and "incomplete_f" in values and row["given"] != "mc":
        moved = [1, 2]
    found = []
    for output in values:
        total = sum((abs(by(formula, inputs, i, (output,))[output]) for i in moved), arb(0))
        if differs(row[f"cond_{output}"], total, "1e-5"):
            found.append(f"cond_{output}")
    return found


def wrong(name, row):
    """The derivative and condition columns of a row that the differences contradict."""
    return (pendulum if name.startswith("pendulum") else elliptic)(name, row)
