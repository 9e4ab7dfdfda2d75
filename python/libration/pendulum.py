"""The class ``Pendulum``: one orbit of theta'' + omega0**2 sin(theta) = 0, set up once, exact in every regime.

The motion stands here, the rest by topic in the classes it is made of. Single instants are answered without NumPy's
machinery, arrays through the one-orbit ufuncs. Source: Landau & Lifshitz, Mechanics, section 11; DLMF 22.19(i).
"""

from enum import StrEnum
from typing import Any

import numpy as np

from . import _core
from .action_angle import ActionAngle
from .derivatives import Derivatives
from .dispatch import apply
from .passages import Passages
from .series import Series


class Regime(StrEnum):
    """The four kinds of motion; a member compares equal to its string.

    Examples
    --------
    >>> Regime.LIBRATION == "libration"
    True
    """

    REST = "rest"
    LIBRATION = "libration"
    SEPARATRIX = "separatrix"
    ROTATION = "rotation"


class Pendulum(Passages, ActionAngle, Derivatives, Series):
    """One orbit of the pendulum theta'' + omega0**2 sin(theta) = 0, exact in every regime.

    The angle is zero at the bottom and counts on continuously through whole turns. With the energy ratio
    kappa**2 = sin(theta0/2)**2 + (velocity0/(2 omega0))**2, the motion is a libration below 1, the separatrix at 1
    and a rotation above. The regime is that of the doubles passed: ``Pendulum(math.pi)`` swings, with a long period,
    because ``math.pi`` is less than pi. For omega2 < 0 the bottom is the stable equilibrium theta = pi: energy,
    energy ratio and theta_max are those of theta0 - pi with abs(omega2).

    Parameters
    ----------
    theta0 : scalar
        Initial angle in rad, finite.
    velocity0 : scalar, default 0.0
        Initial angular velocity in rad/s, finite.
    omega0 : scalar, optional
        Angular frequency of small swings in rad/s, finite and >= 0; 0 is free rotation.
    omega2 : scalar, optional
        Its square in 1/s**2, finite and of any sign: below 0 the pendulum hangs from the other side.
    length : scalar, optional
        Length in m, finite and > 0; then omega0**2 = gravity/length, taken exactly.
    gravity : scalar, optional
        Acceleration of gravity in m/s**2, finite and of any sign; only with `length`, where it means 9.80665 if not
        given.

    At most one of `omega0`, `omega2` and `length` is given; none of them means ``omega0=1``.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed. Booleans, complex numbers, strings and arrays
        with dimensions are refused like numbers out of range.

    Notes
    -----
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
        if type(t) is np.ndarray:
            return _core.orbit_theta(t, *self._operands, out)
        return apply(_core.orbit_theta, t, *self._operands, out=out)

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
        if type(t) is np.ndarray:
            return _core.orbit_velocity(t, *self._operands, out)
        return apply(_core.orbit_velocity, t, *self._operands, out=out)

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
        return apply(_core.orbit_motion, t, *self._operands)

    def turns(self, t: Any) -> Any:
        """Whole turns and the rest of the angle at the times `t`: ``(n, angle)``.

        theta = 2 pi n + angle with -pi <= angle < pi and the true pi: after many turns the angle keeps the digits
        that theta itself has no room for.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. Where `theta` is NaN, `n` is 0 and `angle` NaN; a number of turns
            beyond int64 is given as the int64 nearest to it.

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
        return apply(_core.turns, t, *self._operands)

    @property
    def theta0(self) -> float:
        """Initial angle in rad, as given, without error."""
        return self._orbit.theta0

    @property
    def velocity0(self) -> float:
        """Initial angular velocity in rad/s, as given, without error."""
        return self._orbit.velocity0

    @property
    def regime(self) -> Regime:
        """Kind of motion: rest, libration, separatrix or rotation, decided without error for the doubles passed."""
        return Regime(self._orbit.regime)

    @property
    def period(self) -> float:
        """Period in s: 2 pi/omega0 at rest, infinite on the separatrix, the time of one turn in rotation.

        In libration 4 K(kappa**2)/omega0, in rotation 2 K(1/kappa**2)/(kappa omega0). Error promised: 4 ulp, half of
        all values 0.5 ulp, plus 2**-100 of its condition. Source: DLMF 22.19(i), 19.8.5.
        """
        return self._orbit.period

    @property
    def theta_max(self) -> float:
        """Turning angle in rad, 2 asin(kappa), counted from the stable equilibrium.

        Pi on the separatrix, NaN in rotation, which does not turn back. Error promised: 4 ulp. Source: 2 atan2 of
        kappa and sqrt(1 - kappa**2).
        """
        return self._orbit.theta_max

    @property
    def energy_ratio(self) -> float:
        """Energy over the energy at the top, kappa**2 = sin(theta0/2)**2 + (velocity0/(2 omega0))**2.

        Infinite in free rotation. Error promised: 4 ulp. Source: Salas (23), where it is m.
        """
        return self._orbit.energy_ratio

    @property
    def energy_ratio_c(self) -> float:
        """Complement 1 - kappa**2, computed directly: it has all its digits next to the separatrix too.

        Minus infinity in free rotation. Error promised: 4 ulp plus 2**-150 of its condition. Source:
        (c - x)(c + x), c = cos(theta0/2), x = velocity0/(2 omega0).
        """
        return self._orbit.energy_ratio_c

    @property
    def energy(self) -> float:
        """Energy per unit inertia in rad**2/s**2, velocity**2/2 + omega0**2 (1 - cos(theta)).

        Zero at the stable equilibrium. Error promised: 4 ulp. Source: Lima (4), divided by the inertia.
        """
        return self._orbit.energy

    @property
    def omega0(self) -> float:
        """Angular frequency of small swings in rad/s, the square root of the absolute value of `omega2`.

        Error promised: 1 ulp. Source: Salas (1).
        """
        return self._orbit.omega0

    @property
    def omega2(self) -> float:
        """Square of the angular frequency of small swings in 1/s**2; below 0 when hanging from the other side.

        Error promised: 1 ulp. Source: Salas (1).
        """
        return self._orbit.omega2
