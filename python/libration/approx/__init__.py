"""Approximations of the pendulum by name, with their sources, domains and measured errors.

`angle` holds formulas for theta(t) and `numerical` the schemes that march through it: ask for one by name, or go through
all of them.

Examples
--------
>>> from libration import Pendulum, approx
>>> series = approx.angle("fourier:2").of(Pendulum(1.0))
>>> f"{series.theta(2.0):.6f} {series.difference(2.0):.1e}"
'-0.306096 1.0e-04'
"""

from .angle import AngleApproximation, AngleError, AngleFormula, angle
from .registry import Registry
from .solvers import NumericalFormula, NumericalSolution, numerical

__all__ = [
    "AngleApproximation",
    "AngleError",
    "AngleFormula",
    "NumericalFormula",
    "NumericalSolution",
    "Registry",
    "angle",
    "numerical",
]
