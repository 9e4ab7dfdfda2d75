"""What every nonlinear spring answers: its motion, regime, period, reach, passages and escapes."""

from __future__ import annotations

from enum import StrEnum
from typing import TYPE_CHECKING, Any, ClassVar, Self, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Labelled, Scalar
from .._dispatch import apply
from .._immutable import Elsewhere, Immutable
from .._labels import Result
from .._messages import REFUSALS, explained, refuse
from .._scalars import real
from .._tables import Tabled

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Displacements are in the user's units.
U = Result("u", None, "displacement")
VELOCITY = Result("velocity", None, "velocity")
MOTION = U, VELOCITY


class OscillatorRegime(StrEnum):
    """The seven kinds of motion of a nonlinear spring; a member compares equal to its string.

    ``rest``: at an equilibrium. ``linear``: no force but the linear one. ``libration``: swings about u = 0. ``well``: swings on
    one side of it. ``homoclinic``: leaves an unstable equilibrium and comes back to it, both in infinite time. ``heteroclinic``: from one unstable
    equilibrium to another. ``escape``: reaches infinity in finite time, forward, backward or both.

    Examples
    --------
    >>> OscillatorRegime.WELL == "well"
    True
    """

    REST = "rest"
    LINEAR = "linear"
    LIBRATION = "libration"
    WELL = "well"
    HOMOCLINIC = "homoclinic"
    HETEROCLINIC = "heteroclinic"
    ESCAPE = "escape"


class Oscillator(Tabled, Immutable):
    """A nonlinear spring: the motion, its kind, its reach and its ends."""

    __slots__ = ("_given", "_operands", "_oscillator")

    # In the user's units.
    _columns = (("u", None), ("velocity", None))

    _names: ClassVar[tuple[str, ...]]
    _kernels: ClassVar[tuple[np.ufunc, np.ufunc, np.ufunc]]
    _given: tuple[float, ...]
    _operands: tuple[np.ndarray, ...]
    _oscillator: _core.Duffing | _core.CubicQuintic

    # Hidden from type checkers, so that they are errors there too.
    if not TYPE_CHECKING:
        amplitude = Elsewhere("range")
        T = Elsewhere("period")
        x = Elsewhere("u")
        x0 = Elsewhere("u0")
        solve = Elsewhere("motion")

    @classmethod
    def _made(cls, made: Any) -> Self:
        self = super().__new__(cls)
        object.__setattr__(self, "_oscillator", made)
        given = made.operands
        object.__setattr__(self, "_given", tuple(given))
        object.__setattr__(self, "_operands", tuple(map(np.asarray, given)))
        return self

    @overload
    def u(self, t: Scalar, out: None = None) -> np.float64: ...
    @overload
    def u(self, t: Array, out: Floats | None = None) -> Floats: ...
    @overload
    def u(self, t: Scalar, out: Floats) -> Floats: ...
    @overload
    def u(self, t: Labelled, out: Labelled | None = None) -> Labelled: ...
    def u(self, t: Any, out: Any = None) -> Any:
        """Displacement at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN beyond an escape, and more than 2**53 half periods away.
        out : ndarray, optional
            Where to put the result, as for every NumPy ufunc.

        Returns
        -------
        float64 or array of the shape of `t`
            Displacement. Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: 4 ulp of the largest displacement of a bounded orbit, of the value itself (or of the start) where it
        escapes, plus 2**-100 of the condition. Source: DLMF 22.13(iii).

        Examples
        --------
        >>> import libration
        >>> f"{libration.Duffing(1.0, p=1.0, q=1.0).u(2.0):.6f}"
        '-0.859349'
        """
        if out is None and type(t) is float:
            return self._oscillator.u(t)
        try:
            return apply(self._kernels[0], t, *self._operands, results=(U,), out=out)
        except REFUSALS as error:
            return refuse(error, Oscillator.u, (self, t, out))

    @overload
    def velocity(self, t: Scalar, out: None = None) -> np.float64: ...
    @overload
    def velocity(self, t: Array, out: Floats | None = None) -> Floats: ...
    @overload
    def velocity(self, t: Scalar, out: Floats) -> Floats: ...
    @overload
    def velocity(self, t: Labelled, out: Labelled | None = None) -> Labelled: ...
    def velocity(self, t: Any, out: Any = None) -> Any:
        """Velocity at the times `t`, the derivative of `u`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `u`.
        out : ndarray, optional
            Where to put the result, as for every NumPy ufunc.

        Returns
        -------
        float64 or array of the shape of `t`
            Velocity, in units of u per s. Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: 4 ulp of the largest velocity of a bounded orbit, of the value itself (or of the start) where it
        escapes, plus 2**-100 of the condition. Source: DLMF 22.13(i).

        Examples
        --------
        >>> import libration
        >>> f"{libration.Duffing(1.0, p=1.0, q=1.0).velocity(2.0):.6f}"
        '-0.699172'
        """
        if out is None and type(t) is float:
            return self._oscillator.velocity(t)
        try:
            return apply(self._kernels[1], t, *self._operands, results=(VELOCITY,), out=out)
        except REFUSALS as error:
            return refuse(error, Oscillator.velocity, (self, t, out))

    @overload
    def motion(self, t: Scalar) -> tuple[np.float64, np.float64]: ...
    @overload
    def motion(self, t: Array) -> tuple[Floats, Floats]: ...
    @overload
    def motion(self, t: Labelled) -> tuple[Labelled, Labelled]: ...
    def motion(self, t: Any) -> Any:
        """Displacement and velocity at the times `t`, together: ``(u, velocity)``.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `u`.

        Returns
        -------
        pair of float64 or of arrays of the shape of `t`
            The same digits as `u` and `velocity`. Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: that of `u` and of `velocity`. Source: DLMF 22.13(i), 22.13(iii).

        Examples
        --------
        >>> import libration
        >>> u, velocity = libration.Duffing(1.0, p=1.0, q=1.0).motion(2.0)
        >>> print(f"{u:.6f} {velocity:.6f}")
        -0.859349 -0.699172
        """
        if type(t) is float:
            return self._oscillator.motion(t)
        try:
            return apply(self._kernels[2], t, *self._operands, results=MOTION)
        except REFUSALS as error:
            return refuse(error, Oscillator.motion, (self, t))

    @explained
    def times(self, u: float, start: float, stop: float) -> Floats:
        """All times from `start` to `stop`, both included, at which the displacement is `u`.

        Parameters
        ----------
        u : scalar
            Displacement, finite. A turning point, also as `range` rounds it, is passed once a swing.
        start, stop : scalar
            Ends of the interval in s, start <= stop.

        Returns
        -------
        ndarray of float64
            The times in s, rising; empty at rest, and where the motion does not get.

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed; for more than 10 million passages, how many.

        Notes
        -----
        Error promised: the motion at each time is at `u` within 4 ulp of the largest displacement plus what an ulp of the
        time makes of it. Source: DLMF 19.25(v).

        Examples
        --------
        >>> import libration
        >>> libration.Duffing(1.0, p=1.0, q=1.0).times(0.5, 0.0, 6.0).round(6)
        array([0.770429, 3.997593, 5.538451])
        """
        return self._oscillator.times(real("u", u), real("start", start), real("stop", stop))

    def plot(self, t: Any = None, *, ax: Axes | None = None, lang: str = "en") -> Axes:
        """Draw u(t).

        Parameters
        ----------
        t : array_like, optional
            Instants in s: the curve runs from the first to the last. By default two periods from t = 0, or what there is of a
            motion that does not repeat.
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language, with its decimal sign.

        Returns
        -------
        Axes
            Those drawn into.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        ValueError
            If no instant is finite, or `ax` or `lang` is none of those.

        Examples
        --------
        >>> from matplotlib.figure import Figure
        >>> import libration
        >>> ax = libration.Duffing(1.0, p=1.0, q=0.2, r=0.5).plot(ax=Figure().subplots())
        >>> ax.get_xlabel()
        't [s]'
        """
        from ..plot._displacement import motion_axes

        return motion_axes(self, t, ax, lang)

    @property
    def u0(self) -> float:
        """Initial displacement, as given, without error."""
        return self._oscillator.u0

    @property
    def velocity0(self) -> float:
        """Initial velocity, as given, without error."""
        return self._oscillator.velocity0

    @property
    def regime(self) -> OscillatorRegime:
        """Kind of motion, decided without error for the doubles passed."""
        return OscillatorRegime(self._oscillator.regime)

    @property
    def period(self) -> float:
        """Period in s of a libration, in a well, of the linear swing; at rest that of small swings; else infinite.

        Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 22.4(i), 19.8.5.
        """
        return self._oscillator.period

    @property
    def range(self) -> tuple[float, float]:
        """Lowest and highest displacement of the whole motion, limits included; infinite where it escapes.

        Error promised: 4 ulp. Source: roots of the energy's polynomial.
        """
        return self._oscillator.range

    @property
    def energy(self) -> float:
        """Energy per unit mass, half the square of the velocity plus the potential, which is zero at u = 0.

        Error promised: 4 ulp of the larger of the two parts. Source: the first integral of the equation.
        """
        return self._oscillator.energy

    @property
    def escape_time(self) -> float:
        """Time in s, above 0, at which the displacement is infinite; inf if it never is.

        Error promised: 1e-14 relative, plus 2**-100 of its condition. Source: a pole of the motion, DLMF 22.4(i).
        """
        return self._oscillator.escape_time

    @property
    def escape_time_backward(self) -> float:
        """Time in s, below 0, at which the displacement was infinite; -inf if it never was.

        Error promised: 1e-14 relative, plus 2**-100 of its condition. Source: a pole of the motion, DLMF 22.4(i).
        """
        return self._oscillator.escape_time_backward

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (), dict(zip(("u0", "velocity0", *self._names), self._given, strict=True))

    def _repr_html_(self) -> str:
        """What a notebook shows: the potential with the energy, equation, regime and period or escape."""
        from ..plot._oscillator_card import oscillator_card

        return oscillator_card(self)
