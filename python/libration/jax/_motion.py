"""Motion, step and period of pendulums as functions of JAX: what may be passed, and in which floats it is computed."""

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from . import _core_functions as core
from ._derivatives import MOTIONS, PERIODS, STEPS

FLOAT64 = 'call jax.config.update("jax_enable_x64", True) at the start'


def motion(
    t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0, *, digits: str = "full"
) -> tuple[jax.Array, jax.Array]:
    """Angle and angular velocity of pendulums at the times `t`, with exact derivatives of every order.

    `libration.motion` as a function of JAX: ``jit``, ``vmap``, ``grad``, ``jacfwd``, ``jacrev`` and ``scan`` take it, by any
    of the four arguments, on any device.

    Parameters
    ----------
    t : scalar or array
        Time in s. More than 2**49 half periods, 2**20 in float32, give NaN; for ``"core"`` more than 2**53.
    theta0 : scalar or array
        Initial angle in rad, less than 2**49 turns, 2**20 in float32.
    velocity0 : scalar or array, default 0.0
        Initial angular velocity in rad/s.
    omega0 : scalar or array, default 1.0
        Angular frequency of small swings in rad/s, not 0; positive for ``"core"``.
    digits : {"full", "short", "core"}, default "full"
        ``"full"`` computes with numbers of two floats where digits are lost, ``"short"`` mostly in plain floats; ``"core"``
        calls the core, in float64 on CPUs.

    Returns
    -------
    pair of jax.Array of the broadcast shape
        Angle in rad, continuous through whole turns, and angular velocity in rad/s. A bad element gives NaN there.

    Raises
    ------
    TypeError
        For float64 while JAX computes in float32, for complex numbers, and for ``"core"`` with other floats than float64.
    ValueError
        For other `digits`.
    NotImplementedError
        For ``"core"`` in a program for another device than a CPU.
    RuntimeError
        For ``"core"`` where this jaxlib does not take it.

    Notes
    -----
    Error promised, of the largest angle and velocity, for the floats passed: ``"full"`` 1e-14 up to 1,000 periods, in
    float32 5e-7; ``"short"`` 1e-12 and 5e-5 where abs(1 - kappa**2) is 1e-4 or more, up to 50 periods; ``"core"`` that of
    `libration.motion` for states that are arrays, with its bits. Derivatives in float64: 1e-11 of the largest change where
    abs(1 - kappa**2) is 1e-6 or more, ``"short"`` 1e-4; the first ones of ``"core"`` are those of `libration.sensitivities`,
    right next to the separatrix too, and higher ones those of ``"full"``. The last digits of ``"full"`` and ``"short"``
    depend on the shape of the arrays, as XLA's do. Source: DLMF 20.2(i), 22.8(i), 22.19(i).

    Examples
    --------
    >>> import jax
    >>> from libration.jax import motion
    >>> theta, velocity = motion(2.0, 1.0)
    >>> print(f"{theta:.4f} {velocity:.4f}")
    -0.3062 -0.9090
    >>> print(f"{jax.grad(lambda omega0: motion(2.0, 1.0, 0.0, omega0)[0])(1.0):.4f}")
    -1.8181
    """
    found: tuple[jax.Array, jax.Array] = _motion(
        *_arguments(digits, t=t, theta0=theta0, velocity0=velocity0, omega0=omega0)
    )
    return found


def advance(
    theta: Any, velocity: Any, dt: Any, omega0: Any = 1.0, *, digits: str = "full"
) -> tuple[jax.Array, jax.Array]:
    """State of pendulums a time `dt` later, ``(theta, velocity)``, with exact derivatives of every order.

    `libration.advance` as a function of JAX: the exact flow, for ``scan`` and for layers of a network.

    Parameters
    ----------
    theta : scalar or array
        Angle in rad, as for `motion`.
    velocity : scalar or array
        Angular velocity in rad/s.
    dt : scalar or array
        Time to go in s, of any sign, as for `motion`.
    omega0 : scalar or array, default 1.0
        Angular frequency of small swings in rad/s, as for `motion`.
    digits : {"full", "short", "core"}, default "full"
        As for `motion`.

    Returns
    -------
    pair of jax.Array of the broadcast shape
        Angle in rad and angular velocity in rad/s. A bad element gives NaN there and nowhere else.

    Raises
    ------
    TypeError, ValueError, NotImplementedError, RuntimeError
        As for `motion`.

    Notes
    -----
    Error promised: that of `motion`. Source: DLMF 22.8(i), 22.19(i).

    Examples
    --------
    >>> from libration.jax import advance
    >>> theta, velocity = advance(1.0, 0.0, 2.0)
    >>> print(f"{theta:.4f} {velocity:.4f}")
    -0.3062 -0.9090
    """
    found: tuple[jax.Array, jax.Array] = _step(
        *_arguments(digits, dt=dt, theta=theta, velocity=velocity, omega0=omega0)
    )
    return found


def period(theta: Any, velocity: Any = 0.0, omega0: Any = 1.0, *, digits: str = "full") -> jax.Array:
    """Period of pendulums in the states (theta, velocity), with exact derivatives of every order.

    `libration.period` as a function of JAX: 2 pi/omega0 at rest, infinite on the separatrix, the time of one turn in
    rotation.

    Parameters
    ----------
    theta : scalar or array
        Angle in rad, as for `motion`.
    velocity : scalar or array, default 0.0
        Angular velocity in rad/s.
    omega0 : scalar or array, default 1.0
        Angular frequency of small swings in rad/s, as for `motion`.
    digits : {"full", "short", "core"}, default "full"
        As for `motion`.

    Returns
    -------
    jax.Array of the broadcast shape
        Period in s. A bad element gives NaN there and nowhere else.

    Raises
    ------
    TypeError, ValueError, NotImplementedError, RuntimeError
        As for `motion`.

    Notes
    -----
    Error promised, of the period: that of `motion`, ``"core"`` that of `libration.period`. Source: DLMF 19.8.5, 22.19(i).

    Examples
    --------
    >>> from libration.jax import period
    >>> print(f"{period(3.0):.4f}")
    16.1555
    """
    found: jax.Array = _period(*_arguments(digits, theta=theta, velocity=velocity, omega0=omega0))
    return found


@partial(jax.jit, static_argnums=0)
def _motion(digits: str, *given: jax.Array) -> Any:
    return MOTIONS[digits](*jnp.broadcast_arrays(*given))


@partial(jax.jit, static_argnums=0)
def _step(digits: str, *given: jax.Array) -> Any:
    return STEPS[digits](*jnp.broadcast_arrays(*given))


@partial(jax.jit, static_argnums=0)
def _period(digits: str, *given: jax.Array) -> Any:
    return PERIODS[digits](*jnp.broadcast_arrays(*given))


def _arguments(digits: str, **given: Any) -> tuple[Any, ...]:
    """The digits, and floats of one kind, at least of 32 bits."""
    if digits not in MOTIONS:
        *others, last = map(repr, MOTIONS)
        raise ValueError(f"digits must be {', '.join(others)} or {last}, not {digits!r}")
    for name, value in given.items():
        kind = np.dtype(getattr(value, "dtype", np.float32))
        if kind == np.float64 != jnp.result_type(float):
            raise TypeError(f"{name} is float64, but JAX computes in float32: pass float32, or {FLOAT64}")
        if jnp.issubdtype(kind, jnp.complexfloating) or isinstance(value, complex):
            raise TypeError(f"{name} must be real, not complex")
        if digits == "core" and hasattr(value, "dtype") and jnp.issubdtype(kind, jnp.floating) and kind != np.float64:
            raise TypeError(f'{name} is {kind}, but digits="core" is for float64: pass float64, or digits="full"')
    kind = jnp.result_type(*given.values())
    kind = jnp.promote_types(kind, jnp.float32) if jnp.issubdtype(kind, jnp.floating) else jnp.result_type(float)
    if digits == "core":
        if jnp.result_type(float) != np.float64:
            raise TypeError(f'digits="core" is for float64, but JAX computes in float32: {FLOAT64}')
        core.ready()
    return digits, *(jnp.asarray(value, dtype=kind) for value in given.values())
