"""From a formula in Arb balls to the columns of a row: hi + lo of every value, and its condition.

A formula maps exact rationals to a dictionary of balls; a float among them (inf, nan, an exact zero) is taken as it is. The
precision doubles until every radius is below 2^-140 of the value. A condition is the sum over the inputs of
|input * d value / d input|, by central differences at 2^-400 of the input: the truncation error is below every digit
of the columns, and the precision is enough for the cancellation. Used by family.py and integrals.py.
"""

import math
from fractions import Fraction

import mpmath as mp
from exact import decimal, nearest
from flint import arb, ctx

STEP = 400
LOST = arb(2) ** -1200  # below every double and every unit of error
RANGE = arb(2**1024 - 2**970)  # rounds to infinity


def narrow(x, bits):
    """A final float, or a ball this narrow, or one that is certainly lost below or beyond the doubles."""
    if isinstance(x, float):
        return True
    if not x.is_finite():
        return False
    return x.rad() <= abs(x.mid()) * arb(2) ** -bits or abs(x) < LOST


def narrowed(evaluate, bits, first):
    """The values of evaluate() as narrow balls: the precision doubles until they are."""
    ctx.prec = first
    while ctx.prec < 400_000:
        try:
            values = evaluate()
            if all(narrow(x, bits) for x in values.values()):
                return values
        except ArithmeticError:
            pass  # a ball too wide to decide a sign or an integer
        ctx.prec *= 2
    raise ArithmeticError("no precision is enough")


def fraction(x):
    """The midpoint of a ball."""
    middle = x.mid().fmpq()
    return Fraction(int(middle.p), int(middle.q))


def hi_lo(x):
    """Two hex floats whose sum is the value to about 106 bits; infinities, NaN and lost values have lo = 0."""
    if isinstance(x, float):
        return [x.hex(), (0.0).hex()]
    if abs(x) < LOST:
        return [(-0.0 if x < 0 else 0.0).hex(), (0.0).hex()]
    if abs(x) > RANGE:
        return [(math.inf if x > 0 else -math.inf).hex(), (0.0).hex()]
    value = fraction(x)
    hi = nearest(value)
    return [hi.hex(), (nearest(value - Fraction(hi)) + 0.0).hex()]


def text(condition):
    """Five digits, also outside the range of doubles; 0 where it is lost."""
    if condition < LOST:
        return "0"
    mantissa, exponent = condition.mid().man_exp()
    with mp.workdps(30):
        return decimal(mp.ldexp(mp.mpf(int(mantissa)), int(exponent)), 5)


def condition(formula, inputs, moved, values, step=STEP):
    """Of each value that is a ball. An input that is 0 counts nothing, nor does one at whose sides the value is not
    defined: there the derivative is infinite or one-sided, and the value is held to its last place alone."""
    size = Fraction(1, 2**step)
    total = {name: arb(0) for name in values}
    for i in moved:
        if inputs[i] == 0:
            continue

        def difference(i=i):
            low, high = (formula(*inputs[:i], inputs[i] * (1 + side * size), *inputs[i + 1 :]) for side in (-1, 1))
            both = [x for x in values if isinstance(low.get(x), arb) and isinstance(high.get(x), arb)]
            return {name: (high[name] - low[name]) * arb(2) ** (step - 1) for name in both}

        for name, slope in narrowed(difference, 24, 2 * step + 800).items():
            total[name] += abs(slope)
    return {name: arb(0) if isinstance(values[name], float) else total[name] for name in values}


def columns(formula, inputs, moved, names, step=STEP):
    """All hi and lo columns, then all conditions. A name that the formula does not give is NaN."""
    values = narrowed(lambda: formula(*inputs), 140, 300)
    conditions = condition(formula, inputs, moved, values, step)
    pairs = [hi_lo(values.get(name, math.nan)) for name in names]
    counted = [
        conditions[name] if math.isfinite(float.fromhex(hi)) else arb(0)
        for name, (hi, _) in zip(names, pairs, strict=True)
    ]
    return [piece for pair in pairs for piece in pair] + [text(x) for x in counted]
