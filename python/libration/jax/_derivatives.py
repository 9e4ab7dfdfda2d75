"""Values and derivatives of any order, forward and reverse: each order is a function with a rule of its own.

A rule gives the columns of the derivatives at once; what is transposed in reverse are sums and products with these. So the
functions themselves may have loops. By t and omega0 the derivatives of a motion are closed forms in those by the start,
because theta(t; theta0, velocity0, omega0) = theta(omega0 t; theta0, velocity0/omega0, 1).
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from . import _core_functions as core
from ._double_words import apart
from ._flow import jacobi, state
from ._set_up import Known, MotionParts, assembled, fully, nearly

KNOWN = {"full": fully, "short": nearly}


def _allowed(found: MotionParts, *given: Any) -> Any:
    """Whether all is finite, there is a force, and turns and half periods are so few that the floats can tell them."""
    kind = np.finfo(given[0].dtype)
    most, largest = 2.0 ** (kind.nmant - 3), float(kind.max) ** 0.5 / 4
    usual = (abs(found.turn) < most) & (abs(found.count) < most) & (abs(found.x) < largest) & (given[-1] != 0)
    return usual & jnp.isfinite(sum(0 * each for each in given))


def _evaluated(known: Known, slopes: bool, given: tuple[Any, ...], halves: bool = False) -> Any:
    """Angle, velocity and acceleration, and the derivatives' factor: 1, or NaN where they are beyond the floats."""
    found = assembled(known, slopes, *given, halves=halves)
    functions = jacobi(found, halves)
    values = apart(lambda: state(found, functions, given[3], halves), given[0])
    allowed = _allowed(found, *given)
    steep = (found.complement == 0) & (abs(found.argument) > np.log(float(np.finfo(given[0].dtype).max)) / 2)
    return tuple(jnp.where(allowed, value, jnp.nan) for value in values), jnp.where(allowed & ~steep, 1.0, jnp.nan)


def _state(digits: str, *given: Any) -> Any:
    return _evaluated(KNOWN[digits](*given), False, given)[0][:2]


def _state_and_slopes(digits: str, *given: Any, halves: bool = False) -> Any:
    """Angle and velocity, and of each the derivatives by t, theta0, velocity0 and omega0.

    With `halves` by two steps of half the time, for derivatives of these: next to the separatrix the functions of the whole time have
    second derivatives beyond those of the motion.
    """
    t, theta0, velocity0, omega0 = given
    known = KNOWN[digits](*given)

    def of_start(theta0: Any, velocity0: Any) -> Any:
        return _evaluated(known, True, (t, theta0, velocity0, omega0), halves)

    (values, sure), (columns, _) = _columns(of_start, (theta0, velocity0))
    sure = jax.lax.stop_gradient(sure).astype(t.dtype)
    slopes = []
    for now, by_t, power, (first, second) in zip(values[:2], values[1:], (0, 1), columns[:2], strict=True):
        by_omega0 = (power * now + t * by_t - velocity0 * second) / omega0
        slopes.append(tuple(sure * each for each in (by_t, first, second, by_omega0)))
    return values[:2], tuple(slopes)


def _period(digits: str, slopes: bool, theta: Any, velocity: Any, omega0: Any) -> Any:
    t = jnp.zeros_like(theta)
    given = (t, theta, velocity, omega0)
    known = KNOWN[digits](*given)
    found = assembled(known, slopes, *given)
    # Of one turn, or of a swing there and back.
    whole = jnp.where(found.rotation, 1 / found.kappa, 2) * found.half_period / abs(omega0)
    value = jnp.where(found.complement == 0, jnp.inf, whole)
    return jnp.where(_allowed(found, *given), value, jnp.nan)


def _period_and_slopes(digits: str, *given: Any) -> Any:
    return _columns(partial(_period, digits, True), given)


def _columns(function: Callable[..., Any], given: tuple[Any, ...]) -> tuple[Any, Any]:
    """The results, and their derivatives by each argument, which are the last level; all directions in one pass."""
    count, shape, dtype = len(given), given[0].shape, given[0].dtype
    units = jnp.eye(count, dtype=dtype).reshape(count, count, *(1 for _ in shape))
    directions = [jnp.broadcast_to(unit, (count, *shape)) for unit in units]
    along = partial(jax.jvp, function, given)
    # The values do not depend on the direction.
    values, columns = jax.vmap(lambda *unit: along(unit), out_axes=(None, 0))(*directions)
    return values, jax.tree.map(tuple, columns)


def _contracted(slopes: Any, changes: tuple[Any, ...]) -> Any:
    together = isinstance(slopes, tuple) and not isinstance(slopes[0], tuple)
    if together:
        return sum(slope * change for slope, change in zip(slopes, changes, strict=True))
    return tuple(_contracted(each, changes) for each in slopes)


def with_slopes(
    function: Callable[..., Any],
    value_and_slopes: Callable[..., Any],
    formulas: Callable[..., Any] | None = None,
) -> Callable[..., Any]:
    """A function of arrays of one shape, element by element, and the function that gives it with its derivatives.

    Where JAX cannot derive `value_and_slopes`, or loses digits, `formulas` are the same by other means, and the higher orders are theirs.
    """
    value = jax.custom_jvp(function)

    @value.defjvp
    def rule(given: tuple[Any, ...], changes: tuple[Any, ...]) -> tuple[Any, Any]:
        def derived(*given: Any) -> Any:
            return _columns(formulas or value_and_slopes, given)

        def next_order(*given: Any) -> Any:
            values, columns = derived(*given)
            return value_and_slopes(*given) if formulas else values, columns

        found, slopes = with_slopes(value_and_slopes, next_order, derived if formulas else None)(*given)
        return found, _contracted(slopes, changes)

    return value


def _of_core(function: Callable[..., Any]) -> Callable[..., Any]:
    def value_and_slopes(*given: Any) -> Any:
        values = function(*given)
        return values, core.slopes(values, given)

    return with_slopes(function, value_and_slopes, partial(_state_and_slopes, "full", halves=True))


def _core_period_and_slopes(*given: Any) -> Any:
    return core.period(*given), _period_and_slopes("full", *given)[1]


MOTIONS = {
    digits: with_slopes(
        partial(_state, digits), partial(_state_and_slopes, digits), partial(_state_and_slopes, digits, halves=True)
    )
    for digits in KNOWN
}
STEPS = MOTIONS | {"core": _of_core(core.advance)}
MOTIONS |= {"core": _of_core(core.motion)}
PERIODS = {
    digits: with_slopes(partial(_period, digits, False), partial(_period_and_slopes, digits)) for digits in KNOWN
} | {"core": with_slopes(core.period, _core_period_and_slopes, partial(_period_and_slopes, "full"))}
