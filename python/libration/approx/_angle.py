"""Formulas for the angle over time: linear, harmonic, Fourier, trigonometric, small m, polynomial sines, Taylor.

Each is set up for one pendulum, answers at any time, and knows how far it is from the exact angle.
"""

from __future__ import annotations

import math
from functools import partial
from typing import Any, NamedTuple, Self, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Intervals, Labelled, Scalar
from .._dispatch import Elementwise, apply
from .._immutable import Immutable
from .._labels import Result
from .._messages import explained
from .._scalars import real
from ..pendulum import Pendulum
from ._named import Named, moving
from ._registry import Registry

THETA = Result("theta", "rad", "approximate angle")
DIFFERENCE = Result("difference", "rad", "approximate minus exact angle")
ERROR = Result("error", "1", "largest error over the turning angle")


class AngleError(NamedTuple):
    """The largest error of an approximation over some periods.

    Examples
    --------
    >>> from libration import Pendulum, approx
    >>> error = approx.angle("harmonic").of(Pendulum(1.0)).error()
    >>> f"{error.difference:.6f} {error.relative:.3%} {error.t:.6f}"
    '0.008530 0.853% 1.025253'
    """

    difference: float
    """Largest size of approximate minus exact, rad; infinite where the approximation escapes to infinity."""
    relative: float
    """The same over the turning angle; NaN in rotation, which has none."""
    t: float
    """The first time at which it is as large, s."""
    undefined_from: float
    """The first time at which the approximation is undefined, s; NaN if it is always defined."""


class AngleFormula(Named):
    """A formula for the angle over time, by its name: an entry of `libration.approx.angle`.

    Parameters
    ----------
    name : str
        One of `libration.approx.angle.names`, with a whole number for N: from 1 to 500 for a series, to 200 for `taylor`.

    Raises
    ------
    ValueError
        In one line: the name, and what is allowed, the nearest first.

    Examples
    --------
    >>> from libration import approx
    >>> formula = approx.angle("cubic")
    >>> print(formula.formula, "|", formula.source, "|", formula.stated)
    the exact motion with sin θ ≈ θ − 40θ³/243 | Salas 2019 (2) | up to 70 deg
    """

    __slots__ = ()

    _formula: _core.AngleFormula

    @explained
    def __new__(cls, name: str) -> Self:
        self = super().__new__(cls)
        object.__setattr__(self, "_formula", _core.AngleFormula(str(name)))
        return self

    @explained
    def of(self, pendulum: Pendulum) -> AngleApproximation:
        """The formula for one pendulum.

        A formula for a release from rest runs on the exact phase, from the last turning point on. `harmonic`, `fourier:N`,
        `trigonometric` and `small-m-bounded` are for librations, `fourier-theta:N` for librations and rotations, the others
        for every motion. All but `harmonic`, both series and `taylor:N` swing about theta = 0 and need omega2 >= 0.

        Parameters
        ----------
        pendulum : Pendulum
            The motion to approximate.

        Returns
        -------
        AngleApproximation

        Raises
        ------
        ValueError
            If the formula is not written for the regime of the pendulum, or only for omega2 >= 0.

        Notes
        -----
        Error promised: that of what is asked of it. Source: `AngleFormula.source`.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> f"{approx.angle('trigonometric').of(Pendulum(1.5)).theta(2.0):.6f}"
        '-0.238115'
        """
        return AngleApproximation(self, pendulum)

    @overload
    def error(self, theta_max: Scalar, periods: float = 1) -> np.float64: ...
    @overload
    def error(self, theta_max: Array, periods: float = 1) -> Floats: ...
    @overload
    def error(self, theta_max: Labelled, periods: float = 1) -> Labelled: ...
    @explained
    def error(self, theta_max: Any, periods: float = 1) -> Any:
        """Largest error of releases from rest, as a share of their turning angles.

        Parameters
        ----------
        theta_max : scalar or array
            Turning angles in rad, between 0 and pi; else NaN.
        periods : scalar, default 1
            For so many exact periods, above 0 and at most 10 000.

        Returns
        -------
        float64 or array of the shape of `theta_max`
            NaN where the approximation is undefined at some time.

        Notes
        -----
        Error promised: that of `AngleApproximation.error`. Source: Lima 2019, section 4, counts like this.

        Examples
        --------
        >>> import numpy as np
        >>> from libration import approx
        >>> (100 * approx.angle("fourier:2").error(np.radians([60, 90, 170]))).round(4)
        array([0.035 , 0.2269,    nan])
        """
        errors = partial(self._errors, periods=real("periods", periods))
        return apply(Elementwise(errors, argument="theta_max"), theta_max, results=(ERROR,))

    @explained
    def ranges(self, bound: float, periods: float = 1) -> Intervals:
        """The turning angles for which the largest error stays within a share of them.

        Of releases from rest. Undefined counts as beyond.

        Parameters
        ----------
        bound : scalar
            Largest error over the turning angle, above 0.
        periods : scalar, default 1
            For so many exact periods, above 0 and at most 10 000.

        Returns
        -------
        tuple of pairs of float
            Intervals in rad, within (0, pi).

        Notes
        -----
        Error promised: none of its own; the ends are found by bisection of `error`, from a grid of degrees that is finer at
        both ends. Source: Lima 2019, section 4.

        Examples
        --------
        >>> import numpy as np
        >>> from libration import approx
        >>> np.degrees(approx.angle("harmonic").ranges(0.01)).round(2)
        array([[ 0.  , 61.71]])
        """
        return tuple(self._formula.ranges(real("bound", bound), real("periods", periods)))

    def _errors(self, theta_max: np.ndarray, periods: float) -> np.ndarray:
        """Those of `error`, one by one."""
        return np.array([self._released(angle, periods) for angle in theta_max.tolist()])

    def _released(self, theta_max: float, periods: float) -> float:
        if not 0 < theta_max < math.pi:
            return math.nan
        found = self.of(Pendulum(theta_max)).error(periods)
        return found.relative if math.isnan(found.undefined_from) else math.nan


class AngleApproximation(Immutable):
    """A formula for the angle set up for one pendulum.

    Parameters
    ----------
    formula : AngleFormula
        The formula.
    pendulum : Pendulum
        The motion to approximate.

    Raises
    ------
    ValueError
        If the formula is not written for the regime of the pendulum, or only for omega2 >= 0.

    Examples
    --------
    >>> from libration import Pendulum, approx
    >>> series = approx.angle("fourier-theta:4").of(Pendulum(3.0))
    >>> print(series.theta([0.0, 1.0]).round(6), series.difference([0.0, 1.0]).round(6))
    [2.997083 2.926421] [-0.002917  0.002983]
    """

    __slots__ = ("_approximation", "formula", "pendulum")

    _approximation: _core.AngleApproximation
    formula: AngleFormula
    pendulum: Pendulum

    @explained
    def __new__(cls, formula: AngleFormula, pendulum: Pendulum) -> Self:
        self = super().__new__(cls)
        object.__setattr__(self, "_approximation", formula._formula.of(moving(pendulum)._orbit))
        object.__setattr__(self, "formula", formula)
        object.__setattr__(self, "pendulum", pendulum)
        return self

    @overload
    def theta(self, t: Scalar) -> np.float64: ...
    @overload
    def theta(self, t: Array) -> Floats: ...
    @overload
    def theta(self, t: Labelled) -> Labelled: ...
    @explained
    def theta(self, t: Any) -> Any:
        """Approximate angle at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN, infinite times and more than 2**53 half periods give NaN.

        Returns
        -------
        float64 or array of the shape of `t`
            Angle in rad. NaN where the formula has no value: where `fourier:N` leaves the range of its
            arcsine, and after an escape of `cubic`. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: 8 ulp of its scale (its size, the turning angle, the largest term of a polynomial), plus 2**-100 of
        the condition; for `cubic` and `cubic-quintic`, whose coefficients are rounded, 2**-53 of it. Source: that of the
        formula.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> series = approx.angle("fourier:2").of(Pendulum(1.0))
        >>> f"{series.theta(2.0):.6f}"
        '-0.305939'
        """
        return apply(Elementwise(self._theta), t, results=(THETA,))

    @overload
    def difference(self, t: Scalar) -> np.float64: ...
    @overload
    def difference(self, t: Array) -> Floats: ...
    @overload
    def difference(self, t: Labelled) -> Labelled: ...
    @explained
    def difference(self, t: Any) -> Any:
        """Approximate minus exact angle at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN, infinite times and more than 2**53 half periods give NaN.

        Returns
        -------
        float64 or array of the shape of `t`
            Difference in rad, NaN where `theta` is. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: for `harmonic` and both Fourier series 1e-10 of the difference itself, however small, plus 2**-100 of
        the condition; for the others that of the two angles. Source: the terms that the series leave out.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> series = approx.angle("fourier:2").of(Pendulum(1.0))
        >>> f"{series.difference(2.0):.2e}"
        '2.61e-04'
        """
        return apply(Elementwise(self._difference), t, results=(DIFFERENCE,))

    @property
    def period(self) -> float:
        """Period in s of the approximation itself; NaN where it does not repeat.

        `linear`: 2 pi/omega0; `trigonometric`: that of its rate; `cubic` and `cubic-quintic`: that of their libration; both
        Fourier series, `harmonic` and `small-m-bounded`: the exact one. Error promised: 4 ulp, plus 2**-100 of the condition
        (2**-53 of it for `cubic` and `cubic-quintic`). Source: Salas 2019 (34).
        """
        return self._approximation.period

    def error(self, periods: float = 1) -> AngleError:
        """The largest error from t = 0 on.

        Parameters
        ----------
        periods : scalar, default 1
            For so many exact periods (turns of a rotation), above 0 and at most 10 000.

        Returns
        -------
        AngleError

        Raises
        ------
        ValueError
            If the number of periods is out of range; on the separatrix, which has no period.

        Notes
        -----
        Error promised: 1e-9 of the largest difference, plus the rounding of `difference`; more where a sine model swings over
        1000 times as fast as the pendulum, and of `small-m` where m omega0 t is beyond some 1000. Source: Lima 2019,
        section 4.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> f"{approx.angle('fourier:2').of(Pendulum(1.0)).error().relative:.2e}"
        '2.86e-04'
        """
        difference, t, undefined_from = self._approximation.largest_error(real("periods", periods))
        theta_max = self.pendulum.theta_max
        relative = difference / theta_max if theta_max else 0.0
        return AngleError(difference, relative, t, undefined_from)

    def _theta(self, t: np.ndarray) -> np.ndarray:
        return self._approximation.theta(t)

    def _difference(self, t: np.ndarray) -> np.ndarray:
        return self._approximation.difference(t)

    def __repr__(self) -> str:
        return f"{self.formula!r}.of({self.pendulum!r})"

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.formula, self.pendulum), {}


angle: Registry[AngleFormula] = Registry(
    AngleFormula, _core.AngleFormula.patterns(), {"fourier": 4, "fourier-theta": 4, "taylor": 8}
)
