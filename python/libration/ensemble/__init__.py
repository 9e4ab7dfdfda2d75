"""Ensembles: bunches of many pendulums.

Examples
--------
>>> from libration import ensemble
>>> theta, velocity = ensemble.bunch(100_000, distribution="thermal", temperature=0.1, seed=1)
>>> f"{theta.std():.2f}"
'0.32'
"""

from ._bucket import Bucket
from ._bunch import bunch
from ._track import track

__all__ = ["Bucket", "bunch", "track"]


def __dir__() -> list[str]:
    return __all__
