"""Approximations of the pendulum by name, with their sources, domains and measured errors.

`angle` holds formulas for theta(t): ask it for one by name, or go through all of them.

Examples
--------
>>> from libration import Pendulum, approx
>>> series = approx.angle("fourier:2").of(Pendulum(1.0))
>>> f"{series.theta(2.0):.6f} {series.difference(2.0):.1e}"
'-0.305939 2.6e-04'
"""

from .angle import AngleApproximation, AngleError, AngleFormula, angle
from .registry import Registry

__all__ = ["AngleApproximation", "AngleError", "AngleFormula", "Registry", "angle"]
