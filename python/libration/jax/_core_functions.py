"""The core's own functions within JAX, by the foreign functions of XLA: on CPUs, in float64, with the core's bits.

Here is what has no derivative of its own; the derivatives by the start are functions of the core as well.
Source: https://docs.jax.dev/en/latest/ffi.html.
"""

from functools import cache
from importlib.metadata import version
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.extend.core import Primitive
from jax.interpreters import batching, mlir

from .. import _core

# jax states no types of it.
Shape: Any = jax.ShapeDtypeStruct
# Of how many columns the results are.
RESULTS = {"motion": 2, "advance": 2, "sensitivities": 6, "period": 1}
for name in RESULTS:
    jax.ffi.register_ffi_target(f"libration_{name}", getattr(_core, f"xla_{name}"), platform="cpu")


def _called(name: str, *given: Any) -> Any:
    """The columns of a function, of arrays of one shape."""

    def columns(*given: Any) -> Any:
        results = (Shape(given[0].shape, np.float64),) * RESULTS[name]
        return jax.ffi.ffi_call(f"libration_{name}", results, vmap_method="broadcast_all")(*given)

    def elsewhere(*given: Any) -> Any:
        return (_refused.bind(given[0]),) * RESULTS[name]

    return jax.lax.platform_dependent(*given, cpu=columns, default=elsewhere)


def motion(t: Any, theta0: Any, velocity0: Any, omega0: Any) -> Any:
    """Angle and velocity."""
    return _called("motion", t, theta0, velocity0, omega0)


def advance(dt: Any, theta: Any, velocity: Any, omega0: Any) -> Any:
    """Angle and velocity."""
    return _called("advance", theta, velocity, dt, omega0)


def period(theta: Any, velocity: Any, omega0: Any) -> Any:
    """Period of states."""
    return _called("period", theta, velocity, omega0)[0]


def slopes(state: tuple[Any, Any], given: tuple[Any, ...]) -> Any:
    """Of angle and velocity the derivatives by t, theta0, velocity0 and omega0."""
    theta, velocity = state
    columns = _called("sensitivities", *given)
    return (velocity, *columns[:3]), (-given[3] * given[3] * jnp.sin(theta), *columns[3:])


@cache
def ready() -> None:
    """Asks XLA for a small program once: RuntimeError of one line where it does not take the core's functions."""
    try:
        place = jax.sharding.SingleDeviceSharding(jax.devices("cpu")[0])
        number = Shape((1,), np.float64, sharding=place)
        jax.jit(period).lower(number, number, number).compile()
    except Exception as error:
        why = str(error).partition("\n")[0]
        raise RuntimeError(
            f'digits="core" does not run on this jaxlib, {version("jaxlib")}: pass digits="full" (XLA: {why})'
        ) from error


# A value where the core does not run: no program is made of it.
_refused: Any = Primitive("libration_core_elsewhere")
_refused.def_abstract_eval(lambda like: like)
batching.primitive_batchers[_refused] = lambda given, axes: (_refused.bind(*given), *axes)


def _refuse(context: Any, *_: Any) -> Any:
    platforms = ", ".join(context.module_context.platforms)
    raise NotImplementedError(f'digits="core" runs on CPUs and not on {platforms}: pass digits="full" there')


mlir.register_lowering(_refused, _refuse)
