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
from ._reduce import reduce
from ._sweep import sweep
from ._track import track

__all__ = ["Bucket", "bunch", "reduce", "sweep", "track"]


def __dir__() -> list[str]:
    return __all__
