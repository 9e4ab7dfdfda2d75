"""The Duffing oscillator u'' + p u + q u**3 = 0, exact for any start, the forms of its solutions and its link to the pendulum.

It is set up once from its state at t = 0 and answers at any time up to an escape to infinity, which may be near.
Source: Salas 2019, (2) to (10), corrected; DLMF 22.13(iii).
"""

from enum import StrEnum
from typing import Any, ClassVar, Self

import numpy as np

from . import _core
from .dispatch import apply
from .fixed import Fixed, real
from .pendulum import Pendulum


class OscillatorRegime(StrEnum):
    """The seven kinds of motion of a nonlinear spring; a member compares equal to its string.

    ``rest``: at an equilibrium. ``linear``: no force but the linear one. ``libration``: swings about u = 0. ``well``: swings on
    one side of it. ``homoclinic``: leaves u = 0 and comes back to it, both in infinite time. ``heteroclinic``: from one unstable
    equilibrium to the other. ``escape``: reaches infinity in finite time, forward, backward or both.

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


class Oscillator(Fixed):
    """A nonlinear spring: the motion, its kind, its reach and its ends."""

    __slots__ = ("_given", "_operands", "_oscillator")

    _names: ClassVar[tuple[str, ...]]
    _kernels: ClassVar[tuple[np.ufunc, np.ufunc, np.ufunc]]
    _given: tuple[float, ...]
    _operands: tuple[np.ndarray, ...]
    _oscillator: Any

    @classmethod
    def _made(cls, made: Any) -> Self:
        self = super().__new__(cls)
        object.__setattr__(self, "_oscillator", made)
        object.__setattr__(self, "_given", tuple(made.operands))
        object.__setattr__(self, "_operands", tuple(map(np.asarray, made.operands)))
        return self

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
        return apply(self._kernels[0], t, *self._operands, out=out)

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
            Velocity per s. Dask and xarray arrays give their like, and stay lazy.

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
        return apply(self._kernels[1], t, *self._operands, out=out)

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
        return apply(self._kernels[2], t, *self._operands)

    def times(self, u: float, start: float, stop: float) -> np.ndarray:
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

        Error promised: 1e-14, plus 2**-100 of its condition. Source: a pole of the motion, DLMF 22.4(i).
        """
        return self._oscillator.escape_time

    @property
    def escape_time_backward(self) -> float:
        """Time in s, below 0, at which the displacement was infinite; -inf if it never was.

        Error promised: 1e-14, plus 2**-100 of its condition. Source: a pole of the motion, DLMF 22.4(i).
        """
        return self._oscillator.escape_time_backward

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return self._given == other._given

    def __hash__(self) -> int:
        return hash(self._given)

    def __repr__(self) -> str:
        given = zip(("u0", "velocity0", *self._names), self._given, strict=True)
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in given)})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuilt, (type(self), self._names, self._given)


def _rebuilt(kind: type[Any], names: tuple[str, ...], operands: tuple[float, ...]) -> Any:
    u0, velocity0, *coefficients = operands
    return kind(u0, velocity0, **dict(zip(names, coefficients, strict=True)))


class Duffing(Oscillator):
    """The oscillator u'' + p u + q u**3 = 0, exact for every sign, start and energy.

    Hardening (q > 0), softening (q < 0), with one well or two; released, pushed, on a separatrix or escaping to infinity in
    finite time. The regime is that of the doubles passed: which side of a separatrix they lie on is decided without rounding.

    Parameters
    ----------
    u0 : scalar
        Initial displacement, finite.
    velocity0 : scalar, default 0.0
        Initial velocity, finite.
    p, q : scalar
        Coefficients of the linear and the cubic force per unit mass, finite, of any sign.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    An oscillator does not change; it is hashable, and a pickle rebuilds it bit for bit. A pendulum is one of these: see
    `of_pendulum`. Source: Salas 2019, (2) to (10), corrected; DLMF 22.13(iii).

    Examples
    --------
    >>> import libration
    >>> spring = libration.Duffing(1.0, p=-1.0, q=1.0)
    >>> print(spring.regime, spring.range)
    rest (1.0, 1.0)
    >>> f"{libration.Duffing(2.0, p=1.0, q=-1.0).escape_time:.6f}"
    '1.001077'
    """

    __slots__ = ()

    _names = ("p", "q")
    _kernels = (_core.duffing_u, _core.duffing_velocity, _core.duffing_motion)

    def __new__(cls, u0: float, velocity0: float = 0.0, *, p: float, q: float) -> Self:
        return cls._made(_core.Duffing(real("u0", u0), real("velocity0", velocity0), real("p", p), real("q", q)))

    @classmethod
    def of_pendulum(cls, pendulum: Pendulum) -> Self:
        """Oscillator of u = tan(theta/2) for a pendulum: p = omega0**2 (1 - 2 m), q = 2 omega0**2 (1 - m), m the energy ratio.

        A libration is a hardening spring, the separatrix the linear one with p < 0, and a rotation escapes whenever the pendulum
        is at the top: there u is infinite, and one motion of u is one turn. Each of the four numbers is rounded once, so
        an orbit a rounding error from the separatrix may become its neighbour.

        Parameters
        ----------
        pendulum : Pendulum

        Returns
        -------
        Duffing

        Raises
        ------
        ValueError
            If velocity0/(2 cos(theta0/2)**2) is beyond the doubles.

        Notes
        -----
        Error promised: 1 ulp of each of the four numbers. Source: Salas 2019, (5), (8), (11).

        Examples
        --------
        >>> import math
        >>> import libration
        >>> spring = libration.Duffing.of_pendulum(libration.Pendulum(2.0))
        >>> f"{2 * math.atan(spring.u(1.0)):.6f} {libration.Pendulum(2.0).theta(1.0):.6f}"
        '1.532728 1.532728'
        """
        frequency = dict(pendulum._frequency)
        u0, velocity0, p, q = _core.duffing_of_pendulum(pendulum.theta0, pendulum.velocity0, **frequency)
        return cls(u0, velocity0, p=p, q=q)

    @property
    def pendulum(self) -> tuple[float, Pendulum] | None:
        """The pendulum that moves alike, and what u is measured in: ``u = scale * tan(theta/2)``; None where there is none.

        There is none at E = 0, in wells, for a softening spring in libration or outside of its barrier with E >= 0, for
        Delta = p**2 + 4 q E <= 0, and without a cubic force. Error promised: 1 ulp of each of its numbers. Source: Salas
        2019, (5), (8), (10) with its dots put right.
        """
        found = _core.pendulum_of_duffing(self._oscillator)
        if found is None:
            return None
        scale, theta0, velocity0, omega2 = found
        return scale, Pendulum(theta0, velocity0, omega2=omega2)

    @property
    def p(self) -> float:
        """Coefficient of the linear force, as given, without error."""
        return self._given[2]

    @property
    def q(self) -> float:
        """Coefficient of the cubic force, as given, without error."""
        return self._given[3]


class DuffingForm(Fixed):
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

    def __new__(cls, form: str, c1: float, c2: float = 0.0, *, p: float, q: float) -> Self:
        numbers = real("p", p), real("q", q), real("c1", c1), real("c2", c2)
        self = super().__new__(cls)
        object.__setattr__(self, "_form", _core.DuffingForm(str(form), *numbers))
        object.__setattr__(self, "_given", (str(form), *numbers))
        return self

    def u(self, t: Any) -> Any:
        """Displacement at the times `t`, an array of their shape or a float64.

        NaN for times that are not finite. Error promised: 4 ulp, plus 2**-100 of the condition. Source: DLMF 22.2.10.
        """
        return self.motion(t)[0]

    def velocity(self, t: Any) -> Any:
        """Velocity at the times `t`, an array of their shape or a float64.

        NaN for times that are not finite. Error promised: 4 ulp, plus 2**-100 of the condition. Source: DLMF 22.13(i).
        """
        return self.motion(t)[1]

    def motion(self, t: Any) -> Any:
        """Displacement and velocity at the times `t`, together: two arrays of their shape, or two float64.

        NaN for times that are not finite. Error promised: that of `u` and of `velocity`. Source: DLMF 22.13(i).
        """
        times = np.asarray(t, dtype=float)
        u, velocity = self._form.motion(times.ravel())
        return u.reshape(times.shape)[()], velocity.reshape(times.shape)[()]

    @property
    def rate(self) -> float:
        """Omega, in 1/s. Error promised: 2 ulp. Source: the table of docs/duffing.md."""
        return self._form.rate

    @property
    def m(self) -> float:
        """Parameter of the elliptic function. Error promised: 2 ulp. Source: the table of docs/duffing.md."""
        return self._form.parameter[0]

    @property
    def mc(self) -> float:
        """Complement 1 - m, computed directly. Error promised: 2 ulp. Source: the table of docs/duffing.md."""
        return self._form.parameter[1]

    @staticmethod
    def table() -> dict[str, list[OscillatorRegime]]:
        """Which form serves which regimes, found by trying every form over a grid of p and q c1**2.

        Examples
        --------
        >>> import libration
        >>> print(*libration.DuffingForm.table()["dn"])
        rest well homoclinic
        """
        return {name: [OscillatorRegime(each) for each in regimes] for name, regimes in _core.DuffingForm.table()}

    def __eq__(self, other: object) -> bool:
        return self._given == other._given if isinstance(other, DuffingForm) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._given)

    def __repr__(self) -> str:
        form, p, q, c1, c2 = self._given
        return f"DuffingForm({form!r}, {c1!r}, {c2!r}, p={p!r}, q={q!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        form, p, q, c1, c2 = self._given
        return _formed, (form, c1, c2, p, q)


def _formed(form: str, c1: float, c2: float, p: float, q: float) -> DuffingForm:
    return DuffingForm(form, c1, c2, p=p, q=q)


def duffing_motion(
    t: Any, u0: Any, velocity0: Any = 0.0, p: Any = 1.0, q: Any = 1.0, *, out: Any = None, where: Any = True
) -> Any:
    """Displacement and velocity of Duffing oscillators at the times `t`: ``(u, velocity)``.

    The solution of u'' + p u + q u**3 = 0 from the state (u0, velocity0) at t = 0, element by element.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN beyond an escape, and more than 2**53 half periods away.
    u0 : scalar or array
        Initial displacement, finite.
    velocity0 : scalar or array, default 0.0
        Initial velocity, finite.
    p, q : scalar or array, default 1.0
        Coefficients of the linear and the cubic force per unit mass, finite.
    out : pair of ndarray, optional
        Where to put the results.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        A bad element gives NaN there and nowhere else. Dask and xarray arrays give their like, and stay lazy.

    Notes
    -----
    Error promised: that of `Duffing.u` and `Duffing.velocity`. Source: DLMF 22.13(iii).

    Examples
    --------
    >>> import libration
    >>> u, velocity = libration.duffing_motion(1.0, [0.5, 1.0, 2.0], 0.0, 1.0, -1.0)
    >>> print(u.round(6))
    [3.17963000e-01 1.00000000e+00 1.31264107e+03]
    """
    return apply(_core.duffing_motion, t, u0, velocity0, p, q, out=out, where=where)
