"""Numbers of two floats, hi + lo, in JAX: sums, products, quotients, roots, sine and cosine, and Gauss's mean.

XLA joins a product and the next sum into one rounding, and folds (a + b) - a to b; both leave nothing of an error-free
step. `rounded` stands after each product and sum of such a step: a clamp to the finite floats, through which it does not
see. Valid where products and squares stay in the range of the floats. Source: Dekker 1971; Joldes, Muller & Popescu 2017.
"""

from collections.abc import Callable
from fractions import Fraction
from math import factorial
from typing import Any, TypeAlias

import jax
import jax.numpy as jnp
import numpy as np

# A number as hi + lo.
Words: TypeAlias = tuple[Any, Any]
# 2 pi to 160 bits.
TWO_PI = Fraction(0x6487ED5110B4611A62633145C06E0E68948127044, 2**160)
# Steps of the mean after which its two numbers agree to half the digits, for ratios down to 1e-20, and 1e-10 in float32.
STEPS = {np.dtype(np.float32): 6, np.dtype(np.float64): 8}
# Terms of sine and cosine, up to pi/4.
TERMS = {np.dtype(np.float32): 9, np.dtype(np.float64): 15}


def parts(value: Fraction, dtype: Any, count: int) -> list[Any]:
    """A number as a sum of floats, each the one nearest to what is left."""
    found = []
    for _ in range(count):
        found.append(np.dtype(dtype).type(float(value)))
        value -= Fraction(float(found[-1]))
    return found


def rounded(value: Any) -> Any:
    """The value, rounded to a float before it is used again."""
    largest = np.finfo(value.dtype).max
    return jnp.minimum(jnp.maximum(value, -largest), largest)


def apart(function: Callable[[], Any], like: Any) -> Any:
    """What a function gives, as a step of its own; `like` is any of the numbers it works on.

    XLA repeats a chain of operations for each of its users, many times over. It does not over the ends of a loop; that
    this one has one trip it must not know. Two trips, if all is NaN, give the same.
    """
    nothing = jax.tree.map(lambda shape: jnp.zeros(shape.shape, shape.dtype), jax.eval_shape(function))
    trips = 1 + jnp.isnan(like).all().astype(int)
    return jax.lax.fori_loop(0, trips, lambda _, __: function(), nothing)


def two_sum(a: Any, b: Any) -> Words:
    """a + b without error."""
    hi = rounded(a + b)
    other = rounded(hi - a)
    return hi, rounded(rounded(a - rounded(hi - other)) + rounded(b - other))


def quick_sum(a: Any, b: Any) -> Words:
    """a + b without error, for |a| not below |b|."""
    hi = rounded(a + b)
    return hi, rounded(b - rounded(hi - a))


def halves(a: Any) -> Words:
    """A float as a sum of two, of half the bits each."""
    kind, mask = (jnp.uint64, 0xFFFFFFFFF8000000) if a.dtype == jnp.float64 else (jnp.uint32, 0xFFFFF000)
    hi = jax.lax.bitcast_convert_type(jax.lax.bitcast_convert_type(a, kind) & kind(mask), a.dtype)
    return hi, rounded(a - hi)


def two_product(a: Any, b: Any) -> Words:
    """a b without error; the products of halves are exact, so that it does not matter what they are joined with."""
    hi = rounded(a * b)
    (a1, a2), (b1, b2) = halves(a), halves(b)
    return hi, rounded(rounded(rounded(rounded(a1 * b1 - hi) + a1 * b2) + a2 * b1) + a2 * b2)


def add(a: Words, b: Words) -> Words:
    """a + b, to the last bits of the result where a and b cancel as well."""
    hi, error = two_sum(a[0], b[0])
    low, lower = two_sum(a[1], b[1])
    hi, error = quick_sum(hi, rounded(error + low))
    return quick_sum(hi, rounded(error + lower))


def minus(a: Words) -> Words:
    return -a[0], -a[1]


def scaled(a: Words, power: float) -> Words:
    """A number times a power of two."""
    return a[0] * power, a[1] * power


def multiply(a: Words, b: Words) -> Words:
    hi, lo = two_product(a[0], b[0])
    return quick_sum(hi, rounded(lo + rounded(a[0] * b[1] + a[1] * b[0])))


def divide(a: Words, b: Words) -> Words:
    first = a[0] / b[0]
    hi, lo = two_product(first, b[0])
    left = rounded(rounded(rounded(a[0] - hi) - lo) + a[1])
    return quick_sum(rounded(first), rounded(left - first * b[1]) / b[0])


def root(a: Words) -> Words:
    """The square root; 0 of 0."""
    hi = rounded(jnp.sqrt(a[0]))
    square, low = two_product(hi, hi)
    left = rounded(rounded(rounded(a[0] - square) - low) + a[1])
    return quick_sum(hi, left / (2 * jnp.where(hi > 0, hi, 1)))


def where(condition: Any, a: Words, b: Words) -> Words:
    return jnp.where(condition, a[0], b[0]), jnp.where(condition, a[1], b[1])


def constant(value: Fraction, like: Any) -> Words:
    hi, lo = parts(value, like.dtype, 2)
    return jnp.full_like(like, hi), jnp.full_like(like, lo)


def turned(angle: Any) -> tuple[Any, Words]:
    """The turn of an angle, and the angle less this many times 2 pi."""
    first, second, third = parts(TWO_PI, angle.dtype, 3)
    turn = jnp.round(angle / first)
    rest: Words = (angle, jnp.zeros_like(angle))
    for part in (first, second, third):
        rest = add(rest, minus(two_product(turn, jnp.full_like(turn, part))))
    return turn, rest


def from_top(size: Words) -> Words:
    """pi/2 less an angle; next to the top this is small, and the third word gives it all its digits."""
    first, second, third = (jnp.full_like(size[0], part) for part in parts(TWO_PI / 4, size[0].dtype, 3))
    return add(add((first, second), minus(size)), (third, jnp.zeros_like(third)))


def cosine(angle: Words) -> Words:
    """Cosine of an angle up to pi/2, to half as many digits again as a float has: three terms are in double words."""
    sign = jnp.where(angle[0] < 0, -1, 1).astype(angle[0].dtype)
    size = (sign * angle[0], sign * angle[1])
    beyond = size[0] > float(TWO_PI / 8)
    near = where(beyond, from_top(size), size)
    square = minus(multiply(near, near))
    y = square[0]
    orders = range(3, TERMS[np.dtype(y.dtype)] - 2)
    even, odd = (sum(y ** (k - 3) * (1 / factorial(2 * k + one)) for k in orders) for one in (0, 1))
    table = [[parts(Fraction(1, factorial(2 * k + one)), y.dtype, 2) for one in (0, 1)] for k in range(3)]
    terms = jnp.asarray(np.array(table, y.dtype))

    def step(index: Any, total: Words) -> Words:
        even, odd = terms[2 - index]
        term = jnp.where(beyond, odd[0], even[0]), jnp.where(beyond, odd[1], even[1])
        return add(term, multiply(square, total))

    total = jax.lax.fori_loop(0, 3, step, (jnp.where(beyond, odd, even), jnp.zeros_like(y)))
    return where(beyond, multiply(near, total), total)


def sine_cosine(angle: Words) -> tuple[Words, Words]:
    """Sine and cosine of an angle up to pi/2, by Taylor's series of the smaller of it and its complement."""
    hi = angle[0]
    sign = jnp.where(hi < 0, -1, 1).astype(hi.dtype)
    size = (sign * angle[0], sign * angle[1])
    beyond = size[0] > float(TWO_PI / 8)
    near = where(beyond, from_top(size), size)
    square = minus(multiply(near, near))
    count = TERMS[np.dtype(hi.dtype)]
    table = [[parts(Fraction(1, factorial(2 * k + odd)), hi.dtype, 2) for odd in (0, 1)] for k in range(count)]
    terms = jnp.asarray(np.array(table, hi.dtype))

    def step(index: Any, sums: tuple[Words, Words]) -> tuple[Words, Words]:
        even, odd = terms[count - 1 - index]
        first, second = (multiply(square, each) for each in sums)
        full = jnp.full_like
        return add(first, (full(hi, even[0]), full(hi, even[1]))), add(second, (full(hi, odd[0]), full(hi, odd[1])))

    nothing = (jnp.zeros_like(hi), jnp.zeros_like(hi))
    cosine, quotient = jax.lax.fori_loop(0, count, step, (nothing, nothing))
    sine = multiply(near, quotient)
    larger, smaller = where(beyond, cosine, sine), where(beyond, sine, cosine)
    return (sign * larger[0], sign * larger[1]), smaller


def mean_with_one(a: Words) -> Words:
    """The arithmetic-geometric mean of 1 and a number from 0 to 1; a fixed number of steps and the next term of its tail."""

    def step(_: Any, pair: tuple[Words, Words]) -> tuple[Words, Words]:
        return scaled(add(*pair), 0.5), root(multiply(*pair))

    first, second = jax.lax.fori_loop(0, STEPS[np.dtype(a[0].dtype)], step, (constant(Fraction(1), a[0]), a))
    middle = scaled(add(first, second), 0.5)
    gap = first[0] - second[0]
    # agm = middle - gap^2/(16 middle) - ..., the next term is of fourth order in the gap.
    return add(middle, (-gap * gap / (16 * middle[0]), jnp.zeros_like(gap)))
