"""Approximations of the pendulum by name, with their sources, domains and measured errors.

`angle` holds formulas for theta(t), `period` formulas for the period of a swing, `sine` polynomials for the sine of the
force, and `numerical` the schemes that march through theta(t): ask each for one by name, or go through all of them. `compare` puts
some of them beside the exact motion.

Examples
--------
>>> from libration import Pendulum, approx
>>> series = approx.angle("fourier:2").of(Pendulum(1.0))
>>> f"{series.theta(2.0):.6f} {series.difference(2.0):.1e}"
'-0.305939 2.6e-04'
>>> f"{approx.period('lima-arun').error(1.0):.1e}"
'3.5e-04'
"""

from ._angle import AngleApproximation, AngleError, AngleFormula, angle
from ._compare import Comparison, compare
from ._numerical import NumericalFormula, NumericalSolution, numerical
from ._period import PeriodFormula, period
from ._registry import Registry
from ._sine import SineError, SineFormula, sine

__all__ = [
    "AngleApproximation",
    "AngleError",
    "AngleFormula",
    "Comparison",
    "NumericalFormula",
    "NumericalSolution",
    "PeriodFormula",
    "Registry",
    "SineError",
    "SineFormula",
    "angle",
    "compare",
    "numerical",
    "period",
    "sine",
]


def __dir__() -> list[str]:
    return __all__
