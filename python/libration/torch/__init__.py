"""The pendulum as functions of PyTorch: the core's motions on CPUs, with exact derivatives, for fits and networks.

It needs `pip install 'libration[torch]'`.

Examples
--------
>>> from libration.torch import period
>>> print(f"{period(3.0):.4f}")
16.1555
"""

from importlib.util import find_spec

if find_spec("torch") is None:
    raise ImportError("libration.torch: needs PyTorch: pip install 'libration[torch]'")

from ._motion import advance, motion, period

__all__ = ["advance", "motion", "period"]


def __dir__() -> list[str]:
    return __all__
