"""From a data file to g: files and arrays of measurements, their fit with friction, and g from one period.

Examples
--------
>>> import numpy as np
>>> import libration
>>> t = np.linspace(0.0, 24.0, 600)
>>> friction = libration.Friction(linear=0.02)
>>> theta = libration.DampedPendulum(1.0, length=0.8, friction=friction).theta(t)
>>> theta += np.random.default_rng(1).normal(0.0, 0.01, t.size)
>>> print(libration.fit(t, theta, length=(0.8, 0.001)).g)
9.807 ± 0.012
"""

from ._estimate import Estimate
from ._fit import fit
from ._fit_together import fit_together
from ._gravity import gravity_of_period, gravity_of_pivots, normal_gravity
from ._result import Fit
from ._together import Together

__all__ = [
    "Estimate",
    "Fit",
    "Together",
    "fit",
    "fit_together",
    "gravity_of_period",
    "gravity_of_pivots",
    "normal_gravity",
]
