"""The twelve forms c1 pq(Omega t + c2 | m) of solutions of u'' + p u + q u**3 = 0."""

from __future__ import annotations

from typing import Any, Self, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Labelled, Scalar
from .._dispatch import Elementwise, apply
from .._immutable import Immutable
from .._messages import explained
from .._scalars import real, shown
from ._oscillator import MOTION, VELOCITY, OscillatorRegime, U


class DuffingForm(Immutable):
    """One of the twelve forms u = c1 pq(Omega t + c2 | m) of solutions of u'' + p u + q u**3 = 0.

    Omega and m follow from p and q c1**2; where they are not real the form is refused, with its domain.

    Parameters
    ----------
    form : str
        Two letters of s, c, d, n: one of sn cn dn ns nc nd sc cs sd ds cd dc.
    c1 : scalar
        Factor of the function, finite.
    c2 : scalar, default 0.0
        Argument at t = 0, finite.
    p, q : scalar
        Coefficients of the linear and the cubic force per unit mass, finite.

    Raises
    ------
    ValueError
        In one line: the form with its numbers, and where it is real.

    Notes
    -----
    Beyond a pole the form goes on as pq does; the motion of an oscillator ends there. Source: Salas 2019 gives nine of
    them; ns, cs and ds are ours. DLMF 22.13(iii).

    Examples
    --------
    >>> import libration
    >>> form = libration.DuffingForm("cn", 1.0, p=1.0, q=1.0)
    >>> f"{form.rate:.6f} {form.m:.6f} {form.u(1.0):.6f}"
    '1.414214 0.250000 0.233692'
    """

    __slots__ = ("_form", "_given")

    _form: _core.DuffingForm
    _given: tuple[Any, ...]

    @explained
    def __new__(cls, form: str, c1: float, c2: float = 0.0, *, p: float, q: float) -> Self:
        numbers = real("p", p), real("q", q), real("c1", c1), real("c2", c2)
        form = str(form) if isinstance(form, str) else shown(form)
        self = super().__new__(cls)
        object.__setattr__(self, "_form", _core.DuffingForm(form, *numbers))
        object.__setattr__(self, "_given", (form, *numbers))
        return self

    @overload
    def u(self, t: Scalar) -> np.float64: ...
    @overload
    def u(self, t: Array) -> Floats: ...
    @overload
    def u(self, t: Labelled) -> Labelled: ...
    @explained
    def u(self, t: Any) -> Any:
        """Displacement at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN and infinite times give NaN.

        Returns
        -------
        float64 or array of the shape of `t`
            Displacement; beyond a pole the form goes on. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: 4 ulp, plus 2**-100 of the condition. Source: DLMF 22.2.10.

        Examples
        --------
        >>> import libration
        >>> form = libration.DuffingForm("cn", 1.0, p=1.0, q=1.0)
        >>> form.u([0.0, 1.0]).round(6)
        array([1.      , 0.233692])
        """
        return apply(Elementwise(self._u), t, results=(U,))

    @overload
    def velocity(self, t: Scalar) -> np.float64: ...
    @overload
    def velocity(self, t: Array) -> Floats: ...
    @overload
    def velocity(self, t: Labelled) -> Labelled: ...
    @explained
    def velocity(self, t: Any) -> Any:
        """Velocity at the times `t`, the derivative of `u`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN and infinite times give NaN.

        Returns
        -------
        float64 or array of the shape of `t`
            Velocity, in units of u per s. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: 4 ulp, plus 2**-100 of the condition. Source: DLMF 22.13(i).

        Examples
        --------
        >>> import libration
        >>> form = libration.DuffingForm("cn", 1.0, p=1.0, q=1.0)
        >>> f"{form.velocity(1.0):.6f}"
        '-1.201623'
        """
        return apply(Elementwise(self._velocity), t, results=(VELOCITY,))

    @overload
    def motion(self, t: Scalar) -> tuple[np.float64, np.float64]: ...
    @overload
    def motion(self, t: Array) -> tuple[Floats, Floats]: ...
    @overload
    def motion(self, t: Labelled) -> tuple[Labelled, Labelled]: ...
    @explained
    def motion(self, t: Any) -> Any:
        """Displacement and velocity at the times `t`, together: ``(u, velocity)``.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN and infinite times give NaN.

        Returns
        -------
        pair of float64 or of arrays of the shape of `t`
            The same digits as `u` and `velocity`. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: that of `u` and of `velocity`. Source: DLMF 22.13(i).

        Examples
        --------
        >>> import libration
        >>> form = libration.DuffingForm("cn", 1.0, p=1.0, q=1.0)
        >>> u, velocity = form.motion(1.0)
        >>> print(f"{u:.6f} {velocity:.6f}")
        0.233692 -1.201623
        """
        return apply(Elementwise(self._motion, 2), t, results=MOTION)

    @property
    def rate(self) -> float:
        """Omega, in 1/s. Error promised: 2 ulp. Source: the differential equations of DLMF 22.13(iii)."""
        return self._form.rate

    @property
    def m(self) -> float:
        """Parameter of the elliptic function. Error promised: 2 ulp. Source: the differential equations of DLMF 22.13(iii)."""
        return self._form.parameter[0]

    @property
    def mc(self) -> float:
        """Complement 1 - m, computed directly. Error promised: 2 ulp. Source: the differential equations of DLMF 22.13(iii)."""
        return self._form.parameter[1]

    @staticmethod
    def table() -> dict[str, list[OscillatorRegime]]:
        """Which form serves which regimes, found by trying every form over a grid of p and q c1**2.

        Returns
        -------
        dict of str to list of OscillatorRegime
            The regimes of each form.

        Examples
        --------
        >>> import libration
        >>> print(*libration.DuffingForm.table()["dn"])
        rest well homoclinic
        """
        return {name: [OscillatorRegime(each) for each in regimes] for name, regimes in _core.DuffingForm.table()}

    def _u(self, t: np.ndarray) -> np.ndarray:
        return self._form.motion(t)[0]

    def _velocity(self, t: np.ndarray) -> np.ndarray:
        return self._form.motion(t)[1]

    def _motion(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self._form.motion(t)

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        form, p, q, c1, c2 = self._given
        return (form, c1, c2), {"p": p, "q": q}
