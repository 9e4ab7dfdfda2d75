"""Polynomials in place of the sine of the force: Salas's two, Taylor's, and the best one of a degree on a range."""

from __future__ import annotations

from math import pi
from typing import Any, NamedTuple, Self, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Intervals, Labelled, Scalar
from .._dispatch import Elementwise, apply
from .._labels import Result
from .._messages import explained
from .._scalars import real
from ._named import Named
from ._registry import Registry

VALUE = Result("value", "1", "polynomial in place of the sine")


class SineError(NamedTuple):
    """The largest distance of a polynomial from the sine on a range.

    Examples
    --------
    >>> from math import radians
    >>> from libration import approx
    >>> error = approx.sine("salas-3").error(radians(120.0))
    >>> f"{error.absolute:.5f} {error.relative:.3%}"
    '0.02372 2.739%'
    """

    absolute: float
    """Largest size of polynomial minus sine."""
    at: float
    """Where, in rad: the last place if several are as large."""
    relative: float
    """Largest size of polynomial over sine minus 1; infinite beyond pi."""
    relative_at: float
    """Where, in rad; 0 if it is the limit there."""


class SineFormula(Named):
    """An odd polynomial for the sine, by its name: an entry of `libration.approx.sine`.

    Parameters
    ----------
    name : str
        `salas-2`, `salas-3`, `taylor:N` or `best:N`, of the odd degree N.
    phi_max : scalar, optional
        Of `best:N` and of no other: the range, above 0 and at most 2 pi, on which the polynomial is best, that is, has
        the least largest distance from the sine.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed, the nearest names first.

    Examples
    --------
    >>> from math import radians
    >>> from libration import approx
    >>> best = approx.sine("best:3", phi_max=radians(70.0))
    >>> for formula in approx.sine("salas-2"), best:
    ...     print(formula.name, formula.coefficients.round(5), f"{formula.error(radians(70.0)).absolute:.5f}")
    salas-2 [ 1.      -0.16461] 0.01814
    best:3 [ 0.99451 -0.15171] 0.00133
    """

    __slots__ = ()

    _formula: _core.SineFormula

    @explained
    def __new__(cls, name: str, phi_max: float | None = None) -> Self:
        self = super().__new__(cls)
        given = None if phi_max is None else real("phi_max", phi_max)
        object.__setattr__(self, "_formula", _core.SineFormula(str(name), given))
        return self

    @property
    def phi_max(self) -> float | None:
        """The range that a `best:N` is best on, in rad."""
        return self._formula.phi_max

    @property
    def coefficients(self) -> Floats:
        """Coefficients of phi, phi**3, phi**5 and so on. Error promised: 1 ulp of each. Source: `SineFormula.source`."""
        return self._formula.coefficients()

    @overload
    def value(self, phi: Scalar) -> np.float64: ...
    @overload
    def value(self, phi: Array) -> Floats: ...
    @overload
    def value(self, phi: Labelled) -> Labelled: ...
    @explained
    def value(self, phi: Any) -> Any:
        """Polynomial at angles `phi`.

        Parameters
        ----------
        phi : scalar or array
            Angle in rad, any real number.

        Returns
        -------
        float64 or array of the shape of `phi`
            NaN where it leaves the range of the doubles. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: 1 ulp, plus 2**-140 of its largest term. Source: `SineFormula.source`.

        Examples
        --------
        >>> from libration import approx
        >>> approx.sine("taylor:3").value([0.5, 1.0]).round(6)
        array([0.479167, 0.833333])
        """
        return apply(Elementwise(self._value, argument="phi"), phi, results=(VALUE,))

    @explained
    def error(self, phi_max: float) -> SineError:
        """The largest distance from the sine for angles of a size up to `phi_max`, absolute and relative.

        Parameters
        ----------
        phi_max : scalar
            In rad, above 0 and at most 2 pi.

        Returns
        -------
        SineError

        Raises
        ------
        ValueError
            If `phi_max` is out of range.

        Notes
        -----
        Error promised: 2 ulp, of errors as small as the doubles go; 1e-14 of the places. They are those of the
        polynomial before its coefficients are rounded to doubles, which alone costs about 1e-16 of the sine. Source: the
        zeros of the derivative of the difference.

        Examples
        --------
        >>> from math import radians
        >>> from libration import approx
        >>> f"{approx.sine('salas-2').error(radians(70.0)).absolute:.5f}"
        '0.01814'
        """
        return SineError(*self._formula.largest_error(real("phi_max", phi_max)))

    @explained
    def ranges(self, bound: float) -> Intervals:
        """The angles up to which the polynomial stays within a bound of the sine: one interval from 0.

        Parameters
        ----------
        bound : scalar
            Largest size of polynomial minus sine, at least 1e-30.

        Returns
        -------
        tuple of pairs of float
            Intervals in rad, within [0, 2 pi].

        Raises
        ------
        ValueError
            If the bound is out of range.

        Notes
        -----
        Error promised: that of `error`. Source: bisection of `error`.

        Examples
        --------
        >>> import numpy as np
        >>> from libration import approx
        >>> np.degrees(approx.sine("salas-3").ranges(0.01)).round(2)
        array([[  0. , 102.3]])
        """
        return tuple(self._formula.ranges(real("bound", bound)))

    def _value(self, phi: np.ndarray) -> np.ndarray:
        return self._formula.value(phi)

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.name,), {} if self.phi_max is None else {"phi_max": self.phi_max}


sine: Registry[SineFormula] = Registry(
    SineFormula, _core.SineFormula.patterns(), {"taylor": 5, "best": (5, {"phi_max": 2 * pi / 3})}
)
