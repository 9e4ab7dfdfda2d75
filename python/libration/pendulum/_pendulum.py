"""The class ``Pendulum``: one orbit of theta'' + omega0**2 sin(theta) = 0, set up once, exact in every regime.

Here stands what depends on time; in _plots.py its pictures, in _crossings.py when an angle is reached, in _constants.py
what does not depend on time, in _orbit.py how an orbit is made. Single instants are answered without NumPy's machinery,
arrays through the one-orbit ufuncs. Source: Landau & Lifshitz, Mechanics, section 11; DLMF 22.19(i).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Indexed, Labelled, NDArray, Scalar, Stacked
from .._dispatch import apply, tensor, unindexed
from .._immutable import Elsewhere
from .._messages import REFUSALS, explained, refuse
from .._tables import Tabled
from ._plots import Plots
from ._results import MOTION, PHASE, SECOND_SENSITIVITIES, SENSITIVITIES, THETA, TURNS, VELOCITY
from ._sensitivities import FIRST, SECOND, SYMMETRIC


class Pendulum(Tabled, Plots):
    """One orbit of the pendulum theta'' + omega0**2 sin(theta) = 0, exact in every regime.

    The angle is zero at the bottom and counts on continuously through whole turns. With the energy ratio
    kappa**2 = sin(theta0/2)**2 + (velocity0/(2 omega0))**2, the motion is a libration below 1, the separatrix at 1
    and a rotation above. The regime is that of the doubles passed: ``Pendulum(math.pi)`` swings, with a long period,
    because ``math.pi`` is less than pi. For omega2 < 0 the bottom is the stable equilibrium theta = pi: energy,
    energy ratio and theta_max are those of theta0 - pi with abs(omega2).

    At most one of `omega0`, `omega2` and `length` is given; none of them means ``omega0=1``. By what is known instead of the
    velocity: `Pendulum.from_energy`, `Pendulum.from_turning_angle`, `Pendulum.from_period`, `Pendulum.from_action_phase`.

    Parameters
    ----------
    theta0 : scalar
        Initial angle in rad, finite; `Pendulum.degrees` takes degrees.
    velocity0 : scalar, default 0.0
        Initial angular velocity in rad/s, finite.
    theta0_from_top : scalar, optional
        Initial angle less pi in rad, finite, instead of `theta0`: 1e-17 from upright it keeps the digits that pi + 1e-17 has
        no room for. Where omega2 is below 0, `theta0` counts from the top already, and so does this.
    omega0 : scalar, optional
        Angular frequency of small swings in rad/s, finite and >= 0; 0 is free rotation.
    omega2 : scalar, optional
        Its square in 1/s**2, finite and of any sign: below 0 the pendulum hangs from the other side.
    length : scalar, optional
        Length in m, finite and > 0; then omega0**2 = gravity/length, taken exactly.
    gravity : scalar, optional
        Acceleration of gravity in m/s**2, finite and of any sign; only with `length`, where it means 9.80665 if not
        given.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed. Booleans, complex numbers, strings and arrays
        with dimensions are refused like numbers out of range.

    Notes
    -----
    A release from rest (velocity0 = 0) beyond two turns, abs(theta0) > 4 pi, is taken and gives a ``UserWarning``: degrees
    are often passed for radians. Functions of arrays of states never warn.

    A pendulum does not change. It is hashable, two are equal when their initial state and the numbers that state the
    frequency are equal (omega0=2 and omega2=4 are not), and a pickle rebuilds it bit for bit.

    Error promised: angle, velocity and period within 4 ulp, half of all values within 0.5 ulp, plus what the
    condition of the problem makes of 2**-100. Near a zero the ulp of the angle is that of 2**-30 of its largest.

    Source: Landau & Lifshitz, Mechanics, section 11; DLMF 22.19(i).

    Examples
    --------
    >>> import libration
    >>> pendulum = libration.Pendulum(3.0, length=1.0, gravity=9.8)
    >>> pendulum
    Pendulum(theta0=3.0, velocity0=0.0, length=1.0, gravity=9.8)
    >>> print(pendulum.regime, f"{pendulum.period:.8f}")
    libration 5.16069775
    """

    __slots__ = ()

    # Hidden from type checkers, so that they are errors there too.
    if not TYPE_CHECKING:
        amplitude = Elsewhere("theta_max")
        T = Elsewhere("period")
        g = Elsewhere("gravity")
        L = Elsewhere("length")
        omega = Elsewhere("omega0")
        solve = Elsewhere("motion")

    @overload
    def theta(self, t: Scalar, out: None = None) -> np.float64: ...
    @overload
    def theta(self, t: Array, out: Floats | None = None) -> Floats: ...
    @overload
    def theta(self, t: Scalar, out: Floats) -> Floats: ...
    @overload
    def theta(self, t: Labelled, out: Labelled | None = None) -> Labelled: ...
    def theta(self, t: Any, out: Any = None) -> Any:
        """Angle at the times `t`, continuous through whole turns.

        In libration sin(theta/2) = k sn(omega0 t + u0 | k**2) with k = kappa; in rotation theta/2 is the amplitude
        am(kappa omega0 t + u0 | 1/kappa**2), with its sign and the turns already made.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN gives NaN, and so does a time more than 2**53 half periods away;
            rest, the separatrix and free rotation have no such limit.
        out : ndarray, optional
            Where to put the result, as for every NumPy ufunc.

        Returns
        -------
        float64 or array of the shape of `t`
            Angle in rad. Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: 4 ulp, half of all values 0.5 ulp, with the floor named in `Pendulum`. A scalar time and an
        array of any shape, order and chunking give the same digits. Source: DLMF 22.19(i).

        Examples
        --------
        >>> import numpy as np
        >>> import libration
        >>> libration.Pendulum(3.0).theta(np.array([0.0, 5.0])).round(6)
        array([ 3.     , -1.67599])
        """
        if out is None and (type(t) is float or type(t) is np.float64):
            return self._orbit.theta(t)
        try:
            if type(t) is np.ndarray:
                return _core.orbit_theta(t, *self._operands, out)
            return apply(_core.orbit_theta, t, *self._operands, results=(THETA,), out=out)
        except REFUSALS as error:
            return refuse(error, Pendulum.theta, (self, t, out))

    @overload
    def velocity(self, t: Scalar, out: None = None) -> np.float64: ...
    @overload
    def velocity(self, t: Array, out: Floats | None = None) -> Floats: ...
    @overload
    def velocity(self, t: Scalar, out: Floats) -> Floats: ...
    @overload
    def velocity(self, t: Labelled, out: Labelled | None = None) -> Labelled: ...
    def velocity(self, t: Any, out: Any = None) -> Any:
        """Angular velocity at the times `t`.

        In libration theta' = 2 kappa omega0 cn(omega0 t + u0 | kappa**2), in rotation
        theta' = 2 kappa omega0 dn(kappa omega0 t + u0 | 1/kappa**2), with its sign.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `theta`.
        out : ndarray, optional
            Where to put the result, as for every NumPy ufunc.

        Returns
        -------
        float64 or array of the shape of `t`
            Angular velocity in rad/s. Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: 4 ulp, half of all values 0.5 ulp, with the floor at 2**-30 of the largest velocity.
        Source: DLMF 22.19(i).

        Examples
        --------
        >>> import libration
        >>> f"{libration.Pendulum(0.0, 1.0).velocity(1.0):.6f}"
        '0.568569'
        """
        if out is None and (type(t) is float or type(t) is np.float64):
            return self._orbit.velocity(t)
        try:
            if type(t) is np.ndarray:
                return _core.orbit_velocity(t, *self._operands, out)
            return apply(_core.orbit_velocity, t, *self._operands, results=(VELOCITY,), out=out)
        except REFUSALS as error:
            return refuse(error, Pendulum.velocity, (self, t, out))

    @overload
    def motion(self, t: Scalar) -> tuple[np.float64, np.float64]: ...
    @overload
    def motion(self, t: Array) -> tuple[Floats, Floats]: ...
    @overload
    def motion(self, t: Labelled) -> tuple[Labelled, Labelled]: ...
    def motion(self, t: Any) -> Any:
        """Angle and angular velocity at the times `t`, together: ``(theta, velocity)``.

        The same digits as `theta` and `velocity`, for little more than the price of one.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `theta`.

        Returns
        -------
        pair of float64 or of arrays of the shape of `t`
            Angle in rad and angular velocity in rad/s. Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: that of `theta` and of `velocity`. Source: DLMF 22.19(i).

        Examples
        --------
        >>> import libration
        >>> theta, velocity = libration.Pendulum(1.0).motion(2.0)
        >>> print(f"{theta:.6f} {velocity:.6f}")
        -0.306201 -0.909047
        """
        if type(t) is float or type(t) is np.float64:
            return self._orbit.motion(t)
        try:
            return apply(_core.orbit_motion, t, *self._operands, results=MOTION)
        except REFUSALS as error:
            return refuse(error, Pendulum.motion, (self, t))

    @overload
    def turns(self, t: Scalar) -> tuple[np.int64, np.float64]: ...
    @overload
    def turns(self, t: Array) -> tuple[NDArray[np.int64], Floats]: ...
    @overload
    def turns(self, t: Labelled) -> tuple[Labelled, Labelled]: ...
    def turns(self, t: Any) -> Any:
        """Whole turns and the rest of the angle at the times `t`: ``(n, angle)``.

        theta = 2 pi n + angle with -pi <= angle < pi and the true pi: after many turns the angle keeps the digits
        that theta itself has no room for. An angle that rounds to pi is -pi of the next turn.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. Where `theta` is NaN, and where the number of turns is beyond int64
            (an angle above 5.79e19), `n` is 0 and `angle` NaN.

        Returns
        -------
        pair of int64 and float64, or of arrays of the shape of `t`
            Number of turns, and angle in rad in [-pi, pi). Dask and xarray arrays give their like, and stay lazy.

        Notes
        -----
        Error promised: the angle within 4 ulp of pi. Source: DLMF 22.19(i), 22.16(i).

        Examples
        --------
        >>> import libration
        >>> n, angle = libration.Pendulum(0.0, 3.0).turns(10.0)
        >>> print(n, f"{angle:.6f}")
        4 1.025388
        """
        if type(t) is float or type(t) is np.float64:
            return self._orbit.turns(t)
        try:
            return apply(_core.turns, t, *self._operands, results=TURNS)
        except REFUSALS as error:
            return refuse(error, Pendulum.turns, (self, t))

    @overload
    def phase(self, t: Scalar, out: None = None) -> np.float64: ...
    @overload
    def phase(self, t: Array, out: Floats | None = None) -> Floats: ...
    @overload
    def phase(self, t: Scalar, out: Floats) -> Floats: ...
    @overload
    def phase(self, t: Labelled, out: Labelled | None = None) -> Labelled: ...
    def phase(self, t: Any, out: Any = None) -> Any:
        """Phase at the times `t`, which grows evenly: ``phase(0) + frequency * t``.

        Zero where a libration goes up through the bottom, and in (-pi, pi] at t = 0. In rotation it goes along with the
        angle, which it equals at the bottom and at the top.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign.
        out : ndarray, optional
            Where to put the result, as for every NumPy ufunc.

        Returns
        -------
        float64 or array of the shape of `t`
            Phase in rad; NaN on the separatrix, which has none, and omega0 t at rest. Dask and xarray arrays give their
            like, and stay lazy.

        Notes
        -----
        Error promised: 4 ulp of the larger of the phase and pi. Source: DLMF 22.19(i).

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.Pendulum(1.0)
        >>> f"{pendulum.phase(0.0):.6f} {pendulum.phase(pendulum.period):.6f}"
        '1.570796 7.853982'
        """
        try:
            return apply(_core.orbit_phase, t, *self._operands, results=(PHASE,), out=out)
        except REFUSALS as error:
            return refuse(error, Pendulum.phase, (self, t, out))

    @overload
    def sensitivities(self, t: Scalar | Array) -> Floats: ...
    @overload
    def sensitivities(self, t: Stacked) -> Stacked: ...
    @overload
    def sensitivities(self, t: Indexed) -> Floats: ...
    @explained
    def sensitivities(self, t: Any) -> Any:
        """Derivatives of angle and velocity by the initial angle, the initial velocity and omega0, at the times `t`.

        ``[..., i, j]`` is the derivative of (theta, velocity)[i] by (theta0, velocity0, omega0)[j]. omega0 is the square
        root of abs(omega2), whatever the frequency was given by: by a length L at fixed g the derivative is that by
        omega0 times -omega0/(2 L), by g at fixed L it is that times omega0/(2 g).

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; not finite, and more than 2**53 half periods away, gives NaN.

        Returns
        -------
        array of shape ``t.shape + (2, 3)``
            In SI units, angles in rad; infinite where a derivative is beyond the doubles. Dask and xarray arrays give their
            like; xarray's new dimensions are `of` and `by`.

        Notes
        -----
        Error promised, in each row: 1e-12 of the largest change, that is of the three derivatives times the largest
        angle, the largest velocity and omega0. The determinant of the first two columns is 1. Source: DLMF 22.13(i),
        22.16(ii), 19.25(i); no step of it cancels next to the separatrix.

        Examples
        --------
        >>> import libration
        >>> libration.Pendulum(1.0).sensitivities(2.0).round(6)
        array([[-0.079122,  1.080307, -1.818094],
               [-0.899426, -0.358228, -0.30617 ]])
        """
        found = apply(_core.orbit_sensitivities, unindexed(t), *self._operands, results=6 * (SENSITIVITIES,))
        return tensor(found, FIRST)

    @overload
    def second_sensitivities(self, t: Scalar | Array) -> Floats: ...
    @overload
    def second_sensitivities(self, t: Stacked) -> Stacked: ...
    @overload
    def second_sensitivities(self, t: Indexed) -> Floats: ...
    @explained
    def second_sensitivities(self, t: Any) -> Any:
        """Second derivatives of angle and velocity by the initial angle, the initial velocity and omega0, at the times `t`.

        ``[..., i, j, k]`` is the derivative of (theta, velocity)[i] by (theta0, velocity0, omega0)[j] and [k].

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `sensitivities`.

        Returns
        -------
        array of shape ``t.shape + (2, 3, 3)``
            In SI units, angles in rad. The closed forms are differences of terms many times larger; they are given where
            kappa**2 is from 1e-10 to 1e16 and at least 1e-6 away from 1, and omega0 from 1e-100 to 1e100; NaN elsewhere.
            Dask and xarray arrays give their like; xarray's new dimensions are `of`, `by` and `and_by`.

        Notes
        -----
        Error promised, in each matrix: 1e-12 of the largest change, that is of its elements times the largest angle, the
        largest velocity and omega0, for abs(omega0 t) >= 1e-3; all vanish at t = 0, and next to it fewer digits are left. Source: DLMF 22.13(i), 22.16(ii), 19.4(ii).

        Examples
        --------
        >>> import libration
        >>> libration.Pendulum(1.0).second_sensitivities(2.0)[0].round(6)
        array([[ 0.71125 ,  0.375216, -1.798852],
               [ 0.375216,  0.331688, -1.796763],
               [-1.798852, -1.796763,  1.205754]])
        """
        given = unindexed(t), *self._operands
        twelve = apply(_core.orbit_second_sensitivities, *given, results=12 * (SECOND_SENSITIVITIES,))
        return tensor(tuple(twelve[6 * of + i] for of in range(2) for i in SYMMETRIC), SECOND)
