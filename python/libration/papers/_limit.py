"""Where the exact solutions of the papers fail: states for which they give a wrong angle, or none.

The solutions are in _exact.py. The right angle is that of `libration.theta`.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..pendulum import theta
from ._exact import juchem_neto, salas_22, salas_23, salas_24


@dataclass(frozen=True)
class Limit:
    """One state for which an exact solution of a paper fails, and why. omega0 is 1.

    Parameters
    ----------
    form : callable
        `salas_22`, `salas_23`, `salas_24` or `juchem_neto`.
    theta0, velocity0, t : float
        The initial state in rad and rad/s, and the time in s, for which it fails.
    why : str
        The reason.

    Examples
    --------
    >>> from libration.papers import limits
    >>> print(limits()[0].name, f"{limits()[0].given:.9f}, truth {limits()[0].truth:.9f}")
    Salas (22) 1.634282841, truth 20.483838762
    """

    form: Callable[[float, float, float], np.float64]
    theta0: float
    velocity0: float
    t: float
    why: str

    @property
    def name(self) -> str:
        """The paper and the equation."""
        return NAMES[self.form.__name__]

    @property
    def given(self) -> float:
        """The angle that the solution of the paper gives, rad; NaN if it gives none."""
        return float(self.form(self.t, self.theta0, self.velocity0))

    @property
    def truth(self) -> float:
        """The right angle, rad."""
        return float(theta(self.t, self.theta0, self.velocity0))

    @property
    def modulo(self) -> bool:
        """Whether the two angles differ by whole turns only."""
        return abs(math.remainder(self.given - self.truth, math.tau)) < 1e-9


NAMES = {
    "salas_22": "Salas (22)",
    "salas_23": "Salas (23)",
    "salas_24": "Salas (24)",
    "juchem_neto": "Juchem Neto",
}
TURNS = "rotation: arctan knows one turn, and three have been made"
TOP = "thrown over the top from the double next to π: the arctan wraps"
LIMITS = (
    Limit(salas_22, 1.0, 3.0, 7.0, TURNS),
    Limit(salas_23, 1.0, 3.0, 7.0, TURNS),
    Limit(salas_24, 1.0, 3.0, 7.0, TURNS),
    Limit(salas_22, math.pi, 0.5, 1.0, TOP),
    Limit(salas_23, math.pi, 0.5, 1.0, TOP),
    Limit(salas_24, -math.pi, -0.5, 1.0, "the same from −π"),
    Limit(salas_23, 4.0, 0.0, 3.0, "θ₀ beyond π: a whole turn is lost"),
    Limit(salas_23, 0.0, 2.0, 800.0, "separatrix, late: dn and 1 − sn² are both 0 in doubles"),
    Limit(salas_24, 0.0, 2.0, 800.0, "separatrix, late: nc and sc overflow"),
    Limit(juchem_neto, -1.0, 0.0, 3.0, "θ₀ < 0: the root of k has lost its sign"),
    Limit(juchem_neto, 0.0, 1.0, 1.0, "θ₀ = 0 with a velocity: γ₀ is infinite and k is 0"),
    Limit(juchem_neto, 1.0, 3.0, 1.5, "rotation: the arcsin folds the angle back at the top"),
    Limit(juchem_neto, math.pi, 1.0, 0.5, "thrown over the top: the mirror image"),
    Limit(juchem_neto, -math.pi, 1.0, 0.5, "thrown from −π: the mirror image"),
    Limit(juchem_neto, 4.0, 0.0, 3.0, "θ₀ between π and 2π: the mirror image"),
    Limit(juchem_neto, 7.0, 0.0, 3.0, "θ₀ between 2π and 3π: a whole turn is lost"),
)


def limits() -> tuple[Limit, ...]:
    """States for which the exact solutions of the papers fail, with what they give and the right angle.

    Returns
    -------
    tuple of Limit

    Examples
    --------
    >>> from libration.papers import limits
    >>> sum(not limit.modulo for limit in limits()) > 3
    True
    """
    return LIMITS
