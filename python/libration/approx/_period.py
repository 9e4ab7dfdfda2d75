"""Formulas for the period of a swing: from the two terms of Bernoulli to the arithmetic-geometric mean.

Each gives the ratio to the period of small swings, and its error, right to the error's own last digits.
"""

from __future__ import annotations

from functools import partial
from typing import Any, Self, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Intervals, Labelled, Scalar
from .._dispatch import Elementwise, apply
from .._labels import Result
from .._messages import explained
from .._scalars import real
from ..pendulum import Pendulum
from ._named import Named, moving
from ._registry import Registry

RATIO = Result("ratio", "1", "period over the period of small swings")
ERROR = Result("error", "1", "relative error of the period")


class PeriodFormula(Named):
    """A formula for the period of a swing, by its name: an entry of `libration.approx.period`.

    Parameters
    ----------
    name : str
        One of `libration.approx.period.names`, with a whole number for N: an even one from 2 to 200 for `series`, one from 1
        to 8 for `agm`.

    Raises
    ------
    ValueError
        In one line: the name, and what is allowed, the nearest first.

    Notes
    -----
    A formula of the angle is undefined for m < 0; a formula of m = sin(theta_max/2)**2 or of sqrt(1 - m) goes on to
    negative m. Salas prints his four for a quarter of the period: `quarter_period`.

    Examples
    --------
    >>> from math import radians
    >>> from libration import approx
    >>> for name in ("bernoulli", "lima-arun", "agm:3"):
    ...     print(f"{name:10} {approx.period(name).error(radians(150.0)):+.1e}")
    bernoulli  -1.9e-01
    lima-arun  +3.5e-02
    agm:3      -2.0e-06
    """

    __slots__ = ()

    _formula: _core.PeriodFormula

    @explained
    def __new__(cls, name: str) -> Self:
        self = super().__new__(cls)
        object.__setattr__(self, "_formula", _core.PeriodFormula(str(name)))
        return self

    @overload
    def ratio(
        self, theta_max: Scalar | None = None, *, m: Scalar | None = None, mc: Scalar | None = None
    ) -> np.float64: ...
    @overload
    def ratio(self, theta_max: Array | None = None, *, m: Array | None = None, mc: Array | None = None) -> Floats: ...
    @overload
    def ratio(
        self, theta_max: Labelled | None = None, *, m: Labelled | None = None, mc: Labelled | None = None
    ) -> Labelled: ...
    @explained
    def ratio(self, theta_max: Any = None, *, m: Any = None, mc: Any = None) -> Any:
        """Period over the period of small swings, for a release from rest.

        Parameters
        ----------
        theta_max : scalar or array
            Turning angle in rad, from 0 to pi; else NaN.
        m : scalar or array
            Instead of it the parameter sin(theta_max/2)**2, up to 1, also negative; else NaN.
        mc : scalar or array
            Or its complement 1 - m, at least 0, which keeps its digits next to the top; else NaN.

        Returns
        -------
        float64 or array of the shape of the argument

        Raises
        ------
        ValueError
            Unless exactly one of the three is given.

        Notes
        -----
        Error promised: 1 ulp. `math.pi` is a little less than pi: there the exact ratio is 24.6, not infinite; m = 1
        is the top. Source: `PeriodFormula.source`; the series by the recurrence of Legendre's equation.

        Examples
        --------
        >>> from libration import approx
        >>> approx.period("kidd-fogg").ratio([0.5, 1.0, 2.0]).round(6)
        array([1.015916, 1.067471, 1.360447])
        >>> f"{approx.period('exact').ratio(m=-1.0):.6f}"
        '0.834627'
        """
        return self._answered("ratio", RATIO, theta_max=theta_max, m=m, mc=mc)

    @overload
    def error(
        self, theta_max: Scalar | None = None, *, m: Scalar | None = None, mc: Scalar | None = None
    ) -> np.float64: ...
    @overload
    def error(self, theta_max: Array | None = None, *, m: Array | None = None, mc: Array | None = None) -> Floats: ...
    @overload
    def error(
        self, theta_max: Labelled | None = None, *, m: Labelled | None = None, mc: Labelled | None = None
    ) -> Labelled: ...
    @explained
    def error(self, theta_max: Any = None, *, m: Any = None, mc: Any = None) -> Any:
        """Relative error of the formula: its ratio over the exact one, minus 1.

        Parameters
        ----------
        theta_max : scalar or array
            Turning angle in rad, from 0 to pi; else NaN.
        m : scalar or array
            Instead of it the parameter sin(theta_max/2)**2, up to 1, also negative; else NaN.
        mc : scalar or array
            Or its complement 1 - m, at least 0, which keeps its digits next to the top; else NaN.

        Returns
        -------
        float64 or array of the shape of the argument
            At m = 1, where the exact period is infinite, -1 for a formula that stays finite and NaN for one that does
            not.

        Raises
        ------
        ValueError
            Unless exactly one of the three is given.

        Notes
        -----
        Error promised: 1 ulp of the error itself, plus 1e-45; below 1e-44 it is given as 0. Source: 2K(m)/pi by the
        arithmetic-geometric mean in triple-double.

        Examples
        --------
        >>> from math import radians
        >>> from libration import approx
        >>> f"{approx.period('agm:3').error(radians(30.0)):.4e}"
        '-4.9740e-19'
        """
        return self._answered("error", ERROR, theta_max=theta_max, m=m, mc=mc)

    @explained
    def period(self, pendulum: Pendulum) -> float:
        """The period in s that the formula gives a pendulum; NaN in rotation.

        Its swing counts, however it was started.

        Parameters
        ----------
        pendulum : Pendulum
            The motion.

        Returns
        -------
        float

        Notes
        -----
        Error promised: 4 ulp. Source: that of `ratio`, times 2 pi/omega0.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> pendulum = Pendulum(1.5, length=1.0)
        >>> f"{approx.period('salas-28').period(pendulum):.6f} {pendulum.period:.6f}"
        '2.331379 2.331385'
        """
        return self._formula.period(moving(pendulum)._orbit)

    @explained
    def quarter_period(self, pendulum: Pendulum) -> float:
        """A quarter of `period`: the time from the bottom to the turning point, which Salas calls T.

        Parameters
        ----------
        pendulum : Pendulum
            The motion.

        Returns
        -------
        float
            In s; NaN in rotation.

        Notes
        -----
        Error promised: 4 ulp. Source: Salas 2019 (25) to (28).

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> f"{approx.period('salas-26').quarter_period(Pendulum(1.0)):.6f}"
        '1.674460'
        """
        return self._formula.quarter_period(moving(pendulum)._orbit)

    @explained
    def ranges(self, bound: float) -> Intervals:
        """The turning angles for which the size of the error stays within a bound.

        Parameters
        ----------
        bound : scalar
            Largest size of the relative error, at least 1e-30.

        Returns
        -------
        tuple of pairs of float
            Intervals in rad, within [0, pi], whose ends are the last doubles that keep the bound.

        Raises
        ------
        ValueError
            If the bound is out of range.

        Notes
        -----
        Error promised: none; the ends are the last doubles that keep the bound. Source: bisection between the zeros and
        extremes of the error.

        Examples
        --------
        >>> import numpy as np
        >>> from libration import approx
        >>> np.degrees(approx.period("denman").ranges(0.001)).round(1)
        array([[  0. ,  77.8],
               [138.9, 142.9]])
        """
        return tuple(self._formula.ranges(real("bound", bound)))

    def _answered(self, quantity: str, result: Result, **given: Any) -> Any:
        """A quantity by the one argument that is given."""
        found = [name for name, value in given.items() if value is not None]
        if len(found) != 1:
            raise ValueError(f"exactly one of {', '.join(given)} must be given, not {' and '.join(found) or 'none'}")
        [name] = found
        method = quantity if name == "theta_max" else f"{quantity}_of_{name}"
        return apply(Elementwise(partial(self._values, method), argument=name), given[name], results=(result,))

    def _values(self, method: str, argument: np.ndarray) -> Any:
        return getattr(self._formula, method)(argument)


period: Registry[PeriodFormula] = Registry(PeriodFormula, _core.PeriodFormula.patterns(), {"series": 4, "agm": 3})

# Of formulas with an order, those that tables and pictures show.
ORDERS = {"series": (4, 8), "agm": (1, 2, 3, 4)}


def listed() -> list[PeriodFormula]:
    """The formulas of the period that tables and pictures show: every name, those with an order at some.

    Examples
    --------
    >>> from libration.approx._period import listed
    >>> [formula.name for formula in listed()][:4]
    ['linear', 'bernoulli', 'series:4', 'series:8']
    """
    shown: list[PeriodFormula] = []
    for pattern in period.names:
        base, colon, _ = pattern.partition(":")
        shown += [period(f"{base}:{order}") for order in ORDERS[base]] if colon else [period(base)]
    return [formula for formula in shown if formula.name != "exact"]
