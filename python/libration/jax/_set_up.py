"""What a motion is made of: half angles, the parameters of the elliptic functions, and the argument within a half period.

With s, c = sin, cos(theta0/2), x = velocity0/(2 omega0): kappa^2 = m = s^2 + x^2 and 1 - m = (c - x)(c + x). A libration has
the parameter m and the argument omega0 t, a rotation 1/m and kappa omega0 t; half periods 2K are taken off. `traced` is in
floats; `full` has the same in double words where digits are lost. Source: DLMF 22.17(i), 22.19(i), 19.8.5, 19.5.5.
"""

from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

import jax.numpy as jnp
from jax.lax import stop_gradient

from . import _double_words as dw
from . import _triple_words as tw


class Nome(NamedTuple):
    """The nome of the smaller one of parameter and complement, at most exp(-pi)."""

    # Whether it is that of the complement: then the functions are hyperbolic.
    hyperbolic: Any
    q: Any
    # -ln q, where hyperbolic; infinite on the separatrix, there 0 stands for it.
    decay: Any
    # theta3(0, q)^2.
    scale: Any

    @property
    def half_period(self) -> Any:
        """2K; of no use on the separatrix."""
        return jnp.where(self.hyperbolic, self.decay, float(dw.TWO_PI / 2)) * self.scale


# Parts of a motion, by their names, that are known to more digits.
Known: TypeAlias = dict[str, Any]


class MotionParts(NamedTuple):
    """State and parameters of motions, the argument less half periods as hi + lo, and how many these are."""

    turn: Any
    angle: Any
    s: Any
    c: Any
    x: Any
    rotation: Any
    kappa: Any
    parameter: Any
    complement: Any
    nome: Nome
    half_period: Any
    half_period_low: Any
    count: Any
    argument: Any
    argument_low: Any


def nome(parameter: Any, complement: Any) -> Nome:
    """By 2 e = (1 - r)/(1 + r), r = sqrt of the modulus, without a difference; the next term of q is below 1e-23."""
    hyperbolic = complement < 0.5
    small, large = jnp.where(hyperbolic, complement, parameter), jnp.where(hyperbolic, parameter, complement)
    modulus = jnp.sqrt(large)
    e = 0.5 * small / ((1 + modulus) * (1 + jnp.sqrt(modulus)) ** 2)
    e4 = e**4
    q = e * (1 + e4 * (2 + e4 * (15 + e4 * (150 + e4 * 1707))))
    decay = -jnp.log(jnp.where(hyperbolic & (q > 0), q, 1))
    return Nome(hyperbolic, q, decay, (1 + 2 * q * (1 + q**3 * (1 + q**5))) ** 2)


def within(turn: Any, angle: Any, s: tuple[Any, ...], c: tuple[Any, ...]) -> tuple[Any, Any, Any, Any]:
    """The same a turn on, if the angle is beyond the top by less than its rounding; s and c have any number of words."""
    beyond = c[0] < 0
    sign = jnp.where(beyond, -1, 1).astype(angle.dtype)
    on = jnp.where(beyond, jnp.where(s[0] < 0, -1, 1), 0).astype(angle.dtype)
    turned = tuple(sign * word for word in s), tuple(sign * word for word in c)
    return turn + on, angle - on * float(dw.TWO_PI), *turned


def assembled(
    known: Known, slopes: bool, t: Any, theta0: Any, velocity0: Any, omega0: Any, *, halves: bool = False
) -> MotionParts:
    """The parts in floats, of which some are known better.

    With `slopes` these have the derivatives of the formulas here, at the known values. No formula has a kink, so that the
    derivatives hold at the separatrix: both parameters move there. With `halves` only the half periods that have passed are taken
    off: next to the separatrix their slopes are far larger than those of a motion that has passed none, and would cancel.
    """

    def part(name: str, formula: Any) -> Any:
        if name not in known:
            return formula
        return known[name] + (formula - stop_gradient(formula)) if slopes else known[name]

    def shape() -> Any:
        angle = part("angle", theta0)
        s, c = part("s", jnp.sin(angle / 2)), part("c", jnp.cos(angle / 2))
        turn, angle, (s,), (c,) = within(known["turn"], angle, (s,), (c,))
        x = part("x", velocity0 / (2 * omega0))
        m, mc = s * s + x * x, part("mc", (c - x) * (c + x))
        rotation = mc < 0
        turning = jnp.where(rotation, m, 1)
        kappa = part("kappa", jnp.sqrt(turning))
        parameter = part("parameter", jnp.where(rotation, 1 / turning, m))
        complement = part("complement", jnp.where(rotation, -mc / turning, mc))
        return turn, angle, s, c, x, rotation, kappa, parameter, complement

    def phase() -> Any:
        half_period = part("half_period", q.half_period)
        u = kappa * omega0 * t
        bound = complement > 0
        count = jnp.where(bound, jnp.round(u / jnp.where(bound, half_period, 1)), 0)
        count = known.get("count", stop_gradient(count))
        argument = part("argument", u - jnp.where(count == 0, 0, half_period * count))
        if halves:
            passed = jnp.where(count * argument < 0, count - jnp.sign(count), count)
            left = stop_gradient(argument + jnp.where(passed == count, 0, half_period * (count - passed)))
            formula = u - jnp.where(passed == 0, 0, half_period * passed)
            count, argument = passed, left + (formula - stop_gradient(formula))
        none = jnp.zeros_like(argument)
        return half_period, known.get("half_period_low", none), count, argument, known.get("argument_low", none)

    ratios: Any = dw.apart(shape, t)
    kappa, parameter, complement = ratios[-3:]
    q = dw.apart(lambda: nome(parameter, complement), t)
    return MotionParts._make((*ratios, q, *dw.apart(phase, t)))


def nearly(t: Any, theta0: Any, velocity0: Any, omega0: Any) -> Known:
    """The angle within a turn, and 1 - kappa^2 with half as many digits again as a float has: its difference loses some."""
    theta0, velocity0, omega0 = map(stop_gradient, (theta0, velocity0, omega0))
    zero = jnp.zeros_like(theta0)
    turn, angle = dw.apart(lambda: dw.turned(theta0), theta0)
    cosine = dw.cosine(dw.scaled(angle, 0.5))

    def complement() -> Any:
        x = dw.divide((velocity0, zero), (2 * omega0, zero))
        return dw.multiply(dw.add(cosine, dw.minus(x)), dw.add(cosine, x))[0]

    return {"turn": turn, "angle": angle[0], "mc": dw.apart(complement, theta0)}


def fully(t: Any, theta0: Any, velocity0: Any, omega0: Any) -> Known:
    """All parts, from double words."""
    t, theta0, velocity0, omega0 = map(stop_gradient, (t, theta0, velocity0, omega0))
    zero = jnp.zeros_like(t)
    one = dw.constant(Fraction(1), zero)
    omega = (omega0, zero)
    turn, angle = dw.apart(lambda: dw.turned(theta0), theta0)
    turn, angle, s, c = within(turn, angle[0], *dw.sine_cosine(dw.scaled(angle, 0.5)))

    def shape() -> Any:
        x = dw.divide((velocity0, zero), dw.scaled(omega, 2.0))
        m = dw.add(dw.multiply(s, s), dw.multiply(x, x))
        if zero.dtype == jnp.float32:
            return x, m, tw.complement(theta0, velocity0, omega0)
        return x, m, dw.multiply(dw.add(c, dw.minus(x)), dw.add(c, x))

    def parameters() -> Any:
        rotation = mc[0] < 0
        turning = dw.where(rotation, m, one)
        parameter = dw.where(rotation, dw.divide(one, turning), m)
        complement = dw.where(rotation, dw.minus(dw.divide(mc, turning)), mc)
        return dw.root(turning), parameter, complement

    def phase() -> Any:
        half_period = dw.divide(dw.constant(dw.TWO_PI / 2, zero), mean)
        u = dw.multiply(kappa, dw.multiply(omega, (t, zero)))
        count = jnp.where(complement[0] > 0, jnp.round(u[0] / half_period[0]), 0)
        return half_period, count, dw.add(u, dw.minus(dw.multiply(half_period, (count, zero))))

    x, m, mc = dw.apart(shape, t)
    kappa, parameter, complement = dw.apart(parameters, t)
    mean = dw.mean_with_one(dw.root(complement))
    half_period, count, argument = dw.apart(phase, t)
    words = {"s": s, "c": c, "x": x, "mc": mc, "kappa": kappa, "parameter": parameter, "complement": complement}
    known = {name: value[0] for name, value in words.items()}
    known |= {"half_period": half_period[0], "half_period_low": half_period[1]}
    return known | {"turn": turn, "angle": angle, "count": count, "argument": argument[0], "argument_low": argument[1]}
