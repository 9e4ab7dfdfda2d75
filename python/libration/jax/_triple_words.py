"""Numbers of three floats, in JAX, for 1 - kappa^2 in float32: next to the separatrix cosine and quotient cancel.

Sums are right to the third power of a rounding, whatever cancels among their first terms: two passes of exact sums, then a
plain sum of what they leave. Source: Ogita, Rump & Oishi 2005, SumK; for the rest as in `_double_words`.
"""

from fractions import Fraction
from math import factorial
from typing import Any, TypeAlias

import jax
import jax.numpy as jnp
import numpy as np

from ._double_words import TWO_PI, Words, add, multiply, parts, quick_sum, rounded, two_product, two_sum

Three: TypeAlias = tuple[Any, Any, Any]
# Terms of sine and cosine, up to pi/4: first in three words, then in floats, which suffice below 1e-15.
CAREFUL, TERMS = 9, 12


def total(*terms: Any) -> Three:
    """A sum; terms that cancel come first."""
    left = list(terms)
    words = []
    for _ in range(2):
        for place in range(1, len(left)):
            left[place], left[place - 1] = two_sum(left[place], left[place - 1])
        words.append(left.pop())
    return words[0], words[1], rounded(sum(left))


def product(a: Three, b: Three, *more: Any) -> Three:
    """a b and more terms."""
    low = rounded(rounded(a[0] * b[2] + a[1] * b[1]) + a[2] * b[0])
    across, other = two_product(a[0], b[1]), two_product(a[1], b[0])
    return total(*more, *two_product(a[0], b[0]), *across, *other, low)


def quotient(a: Any, b: Any) -> Three:
    """a/b of two floats; a remainder is a float."""
    words = []
    for _ in range(3):
        words.append(rounded(a / b))
        hi, lo = two_product(words[-1], b)
        a = rounded(rounded(a - hi) - lo)
    return words[0], words[1], words[2]


def where(condition: Any, a: Three, b: Three) -> Three:
    return jnp.where(condition, a[0], b[0]), jnp.where(condition, a[1], b[1]), jnp.where(condition, a[2], b[2])


def cosine_of_half(angle: Any) -> Three:
    """Cosine of half an angle but for its sign, by Taylor's series of the smaller of the half and its complement."""
    turns = [jnp.full_like(angle, part) for part in parts(TWO_PI, angle.dtype, 4)]
    turn = -jnp.round(angle / turns[0])
    rest = total(angle, *(word for part in turns for word in two_product(turn, part)))
    half = jnp.where(rest[0] < 0, -0.5, 0.5).astype(angle.dtype)
    a, b, c = (half * word for word in rest)
    first, *others = (part / 4 for part in turns)
    beyond = a > float(TWO_PI / 8)
    near = where(beyond, total(first, -a, others[0], -b, others[1], -c, others[2]), (a, b, c))
    square = product(near, tuple(-word for word in near))
    # Of the cosine and of sine over angle.
    y = square[0]
    orders = range(CAREFUL, TERMS)
    even, odd = (sum(y ** (k - CAREFUL) * (1 / factorial(2 * k + one)) for k in orders) for one in (0, 1))
    downwards = reversed(range(CAREFUL))
    table = [[parts(Fraction(1, factorial(2 * k + one)), y.dtype, 3) for one in (0, 1)] for k in downwards]
    terms = jnp.asarray(np.array(table, y.dtype))

    def step(index: Any, series: Three) -> Three:
        even, odd = terms[index]
        return product(square, series, *(jnp.where(beyond, odd[word], even[word]) for word in range(3)))

    nothing = jnp.zeros_like(y)
    series = jax.lax.fori_loop(0, CAREFUL, step, (jnp.where(beyond, odd, even), nothing, nothing))
    return where(beyond, product(near, series), series)


def complement(theta0: Any, velocity0: Any, omega0: Any) -> Words:
    """1 - kappa^2 of a state as hi + lo."""
    c, x = cosine_of_half(theta0), quotient(abs(velocity0), abs(2 * omega0))
    hi, lo, rest = total(c[0], -x[0], c[1], -x[1], c[2], -x[2])
    hi, lo = two_sum(hi, lo)
    return multiply(quick_sum(hi, rounded(lo + rest)), add(c[:2], x[:2]))
