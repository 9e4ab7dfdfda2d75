"""The pendulum as functions of JAX: exact motions with exact derivatives, for fits, networks and accelerators.

Examples
--------
>>> from libration.jax import period
>>> print(f"{period(3.0):.4f}")
16.1555
"""

from ._motion import advance, motion, period

__all__ = ["advance", "motion", "period"]


def __dir__() -> list[str]:
    return __all__
