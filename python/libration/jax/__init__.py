"""The pendulum as functions of JAX: exact motions with exact derivatives, for fits, networks and accelerators.

It needs `pip install 'libration[jax]'`.

Examples
--------
>>> from libration.jax import period
>>> print(f"{period(3.0):.4f}")
16.1555
"""

from importlib.util import find_spec

if find_spec("jax") is None:
    raise ImportError("libration.jax: needs JAX: pip install 'libration[jax]'")

from ._motion import advance, motion, period

__all__ = ["advance", "motion", "period"]


def __dir__() -> list[str]:
    return __all__
