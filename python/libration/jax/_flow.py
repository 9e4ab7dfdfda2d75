"""The motion from its parts: Jacobi's functions by theta functions of the smaller nome, then their addition theorem.

Where the parameter is above 1/2 the theta functions are those of the complement, of an imaginary argument. Beyond a quarter
of the half period the argument is counted from its middle, so that cn has its digits at its zero; for second derivatives only next
to it, as the middle moves far more with the parameter than the functions do before. Every function is a product of sine or cosine
and a polynomial in the nome q and h = 2 q cos(2z), which is bounded by sqrt(q) + q^1.5, then by 0.31.
Source: DLMF 20.2(i), 20.7(viii), 22.2, 22.6(iv), 22.8(i), 22.17(i).
"""

import math
from typing import Any

import jax.numpy as jnp
import numpy as np
from jax.lax import stop_gradient

from ._double_words import TWO_PI, apart, parts, two_sum
from ._set_up import MotionParts, Nome

HALF_PI = float(TWO_PI / 4)
# Of the middle, for second derivatives; before it h is at most exp(-1.4), or 0.31 where the nome is large.
NEAR_MIDDLE = 0.7


def theta_quotients(q: Any, h: Any) -> tuple[Any, Any, Any, Any]:
    """theta1/(2 q^(1/4) sin z), theta2/(2 q^(1/4) cos z), theta3 and theta4; what is left out is below 1e-18."""
    q2, h2 = q * q, h * h
    q3, q6 = q2 * q, q2 * q2 * q2
    q9 = q6 * q3
    first = 1 - (q * h + q2) + q2 * q2 * h2 + q2 * q3 * h - q6 - q9 * (h2 * h + q * h2 - 2 * q2 * h - q3)
    second = 1 + (q * h - q2) + q2 * q2 * h2 - q2 * q3 * h - q6 + q9 * (h2 * h - q * h2 - 2 * q2 * h + q3)
    even, odd = 1 + q2 * (h2 - 2 * q2), h + q6 * h * (h2 - 3 * q2)
    return first, second, even + odd, even - odd


def jacobi(given: MotionParts, halves: bool = False) -> tuple[Any, Any, Any]:
    """sn, cn and dn of the argument, which is at most K; with `halves` of half of it, for second derivatives."""
    if halves:
        given = given._replace(argument=given.argument / 2, argument_low=given.argument_low / 2)
    found = given.nome

    def place() -> Any:
        sign = jnp.where(given.argument < 0, -1, 1).astype(given.argument.dtype)
        v, low = sign * given.argument, sign * given.argument_low
        rest = 0.5 * given.half_period - v
        folded = (given.complement > 0) & (v > given.half_period / 4)
        if halves:
            folded &= ~found.hyperbolic | (rest < NEAR_MIDDLE)
        error = two_sum(*map(stop_gradient, (0.5 * given.half_period, -v)))[1]
        low = jnp.where(folded, error + 0.5 * given.half_period_low - low, low)
        return sign, jnp.where(folded, rest, v), low, folded

    sign, v, low, folded = apart(place, given.argument)
    far = apart(lambda: hyperbolic_terms(found, v, low, folded), v)
    near = apart(lambda: trigonometric_terms(found, (v + low) / found.scale, folded), v)
    sn, cn, dn = (jnp.where(found.hyperbolic, a, b) for a, b in zip(far, near, strict=True))
    return sign * sn, cn, dn


def at_zero(q: Any) -> tuple[Any, Any, Any]:
    """theta2/(2 q^(1/4)), theta3 and theta4 of 0."""
    q2 = q * q
    q4 = q2 * q2
    even, odd = 1 + 2 * q4, 2 * q * (1 + q4 * q4)
    return 1 + q2 + q2 * q4, even + odd, even - odd


def trigonometric_terms(found: Nome, z: Any, folded: Any) -> tuple[Any, Any, Any]:
    z = jnp.where(found.hyperbolic, 0, z)
    sine, cosine = jnp.sin(z), jnp.cos(z)
    zero2, zero3, zero4 = at_zero(found.q)
    first, second, third, fourth = theta_quotients(found.q, 2 * found.q * (cosine - sine) * (cosine + sine))
    one, two = sine * first, cosine * second
    above, below = jnp.where(folded, fourth, third), jnp.where(folded, third, fourth)
    sn, cn = jnp.where(folded, two, one), jnp.where(folded, one, two)
    return zero3 / zero2 * sn / below, zero4 / zero2 * cn / below, zero4 / zero3 * above / below


def hyperbolic_terms(found: Nome, v: Any, low: Any, folded: Any) -> tuple[Any, Any, Any]:
    q = jnp.where(found.hyperbolic, found.q, 0)
    # v/scale as v less a part of it, so that a small nome loses no digit of a large argument.
    less = v * ((found.scale - 1) / found.scale)
    y = v - less
    low = low / found.scale
    y = jnp.where(found.hyperbolic, y, 0)
    e = jnp.exp(-y) * (1 - low)
    gone = jnp.expm1(-2 * y)
    gone = gone - 2 * low * (1 + gone)
    square = 1 + gone
    largest = math.log(float(np.finfo(v.dtype).max)) - 2
    h = q * (square + jnp.exp(jnp.minimum(2 * (y + low), largest)))
    zero2, zero3, zero4 = at_zero(q)
    first, second, third, fourth = theta_quotients(q, h)
    tanh, sech = -gone / (1 + square), 2 * e / (1 + square)
    # 4 sqrt(q) sinh(y) and cosh(y), counted from the middle.
    height = 2 * jnp.sqrt(jnp.where(folded & found.hyperbolic, q, 1)) / e
    sn = jnp.where(folded, fourth / third, tanh * first / second)
    cn = jnp.where(folded, -gone * height * first / third, sech * fourth / second)
    dn = jnp.where(folded, (1 + square) * height * second / third, sech * third / second)
    return zero3 / zero4 * sn, zero2 / zero4 * cn, zero2 / zero3 * dn


def step(s: Any, c: Any, x: Any, sn: Any, cn: Any, dn: Any) -> tuple[Any, Any, Any]:
    """s, c and x a time later, by the addition theorem."""
    # 1 - s^2 sn^2 as a sum.
    below = c * c + (s * cn) ** 2
    return (s * cn * dn + x * c * sn) / below, (c * dn - s * x * sn * cn) / below, (x * cn - s * c * sn * dn) / below


def state(given: MotionParts, functions: Any, omega0: Any, halves: bool = False) -> tuple[Any, Any, Any]:
    """Angle, velocity and acceleration, by the addition theorem with the state at the start.

    With `halves` the functions are those of half the argument, and the theorem is used twice; the angle is then right but for turns.
    """
    dtype = given.argument.dtype
    sn, cn, dn = functions
    # A rotation has the functions of a parameter above 1.
    sn, cn, dn = sn / given.kappa, jnp.where(given.rotation, dn, cn), jnp.where(given.rotation, cn, dn)
    odd = given.count - 2 * jnp.floor(given.count / 2)
    # After an odd number of half periods a libration is on the other side; a rotation a turn further.
    parity = jnp.where(given.rotation, 1, 1 - 2 * odd).astype(dtype)
    s, c, x = given.s, given.c, given.x
    if halves:
        s, c, x = step(s, c, x, sn, cn, dn)
    sine, cosine, speed = step(s, c, x, parity * sn, parity * cn, dn)
    angle = 2 * jnp.arctan2(sine, cosine)
    # A rotation goes on by at most a turn within a half period, the arc tangent knows it but for two turns.
    forward = jnp.where((given.x < 0) != (given.argument < 0), -1, 1).astype(dtype)
    behind = given.rotation & (forward * (angle - given.angle) < -2 * HALF_PI)
    downwards = jnp.where(given.x < 0, -1, 1).astype(dtype)
    turns = given.turn + jnp.where(given.rotation, downwards * given.count, 0) + jnp.where(behind, 2 * forward, 0)
    two_pi, rest = parts(TWO_PI, dtype, 2)
    return turns * two_pi + (angle + turns * rest), 2 * omega0 * speed, -2 * omega0 * omega0 * sine * cosine
