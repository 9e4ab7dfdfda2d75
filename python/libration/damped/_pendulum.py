"""The class ``DampedPendulum``: a pendulum with friction and torque, integrated as far as it is asked for.

Source: Taylor series after Jorba & Zou, Exp. Math. 14 (2005) 99, with the turns and stops of dry friction as events.
"""

from __future__ import annotations

from typing import Any, overload

import numpy as np

from .._arrays import Array, Floats, Indexed, Labelled, NDArray, Scalar, Stacked
from .._dispatch import Elementwise, apply, tensor, unindexed
from .._labels import Result
from .._tables import Tabled
from ..pendulum._results import MOTION, THETA, TURNS, VELOCITY
from ._plots import Plots

ENERGY = Result("energy", "rad**2/s**2", "energy per unit inertia")
# The units differ from element to element.
SENSITIVITIES = Result("sensitivities", None, "derivatives of the state by start and constants")
BY = (
    *("theta0", "velocity0", "omega2", "linear", "quadratic", "dry", "presliding"),
    *("constant", "amplitude", "frequency", "phase"),
)
AXES = {"of": ("theta", "velocity"), "by": BY}


class DampedPendulum(Tabled, Plots):
    """A pendulum with friction and torque, from its state at t = 0.

    theta'' + friction(theta') + omega0**2 sin(theta) = torque(t), with the terms that `Friction` and `Torque` say. Dry friction
    stops the pendulum where it turns and the pull is not larger than it, and lets it go when the torque has grown. At
    t = 0 presliding has settled (z = sgn velocity0); a pendulum at rest has z = 0.

    Parameters
    ----------
    theta0 : scalar
        Initial angle in rad, finite.
    velocity0 : scalar, default 0.0
        Initial angular velocity in rad/s, finite.
    omega0, omega2, length, gravity : scalar, optional
        As for `Pendulum`: at most one of the first three; none of them means ``omega0=1``.
    friction : Friction, optional
        None without it.
    torque : Torque, optional
        None without it.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Without friction and torque it answers as `Pendulum` does, bit for bit. Otherwise the motion is integrated when it is asked
    for, up to a million steps (some fifteen in a period) from t = 0; answers do not depend on what was asked before.
    Times that are not reached give NaN: beyond that many steps, beyond a motion without bound, outside of the samples of the
    torque, and before 0 with presliding.

    A pendulum does not change; it is hashable, and a pickle rebuilds it bit for bit. Error promised: angle and velocity within 2
    ulp of the largest up to the time, plus 2**-57 of the condition. Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

    Examples
    --------
    >>> import libration
    >>> friction = libration.Friction(linear=0.02, dry=0.1)
    >>> pendulum = libration.DampedPendulum(1.5, friction=friction, length=1.0)
    >>> theta, velocity = pendulum.motion(10.0)
    >>> print(f"{theta:.9f} {velocity:.9f}")
    -0.988442668 0.140024459
    """

    __slots__ = ()

    _columns = (*Tabled._columns, ("energy", ENERGY.units))

    @overload
    def theta(self, t: Scalar) -> np.float64: ...
    @overload
    def theta(self, t: Array) -> Floats: ...
    @overload
    def theta(self, t: Labelled) -> Labelled: ...
    def theta(self, t: Any) -> Any:
        """Angle at the times `t`, continuous through whole turns.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. NaN where the motion does not get: see `DampedPendulum`.

        Returns
        -------
        float64 or array of the shape of `t`
            Angle in rad. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: 2 ulp of the largest angle up to the time, plus 2**-57 of the condition. Source: Jorba & Zou, Exp. Math.
        14 (2005) 99.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.DampedPendulum(1.0, friction=libration.Friction(quadratic=0.1))
        >>> pendulum.theta([0.0, 10.0]).round(6)
        array([ 1.     , -0.69862])
        """
        if type(t) is float:
            return self._damped.state(t)[0]
        return apply(Elementwise(lambda times: self._damped.motion(times)[0]), t, results=(THETA,))

    @overload
    def velocity(self, t: Scalar) -> np.float64: ...
    @overload
    def velocity(self, t: Array) -> Floats: ...
    @overload
    def velocity(self, t: Labelled) -> Labelled: ...
    def velocity(self, t: Any) -> Any:
        """Angular velocity at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `theta`.

        Returns
        -------
        float64 or array of the shape of `t`
            Angular velocity in rad/s, 0 where dry friction holds. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: 2 ulp of the largest velocity up to the time, plus 2**-57 of the condition. Source: Jorba & Zou, Exp.
        Math. 14 (2005) 99.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.DampedPendulum(1.0, friction=libration.Friction(quadratic=0.1))
        >>> f"{pendulum.velocity(10.0):.6f}"
        '0.082274'
        """
        if type(t) is float:
            return self._damped.state(t)[1]
        return apply(Elementwise(lambda times: self._damped.motion(times)[1]), t, results=(VELOCITY,))

    @overload
    def motion(self, t: Scalar) -> tuple[np.float64, np.float64]: ...
    @overload
    def motion(self, t: Array) -> tuple[Floats, Floats]: ...
    @overload
    def motion(self, t: Labelled) -> tuple[Labelled, Labelled]: ...
    def motion(self, t: Any) -> Any:
        """Angle and angular velocity at the times `t`, together: ``(theta, velocity)``.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `theta`.

        Returns
        -------
        pair of float64 or of arrays of the shape of `t`
            The same digits as `theta` and `velocity`. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: that of `theta` and of `velocity`. Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

        Examples
        --------
        >>> import libration
        >>> theta, velocity = libration.DampedPendulum(1.0, torque=libration.Torque(constant=0.5)).motion(2.0)
        >>> print(f"{theta:.6f} {velocity:.6f}")
        0.450237 -0.412699

        """
        if type(t) is float:
            return self._damped.state(t)
        return apply(Elementwise(self._damped.motion, 2), t, results=MOTION)

    @overload
    def turns(self, t: Scalar) -> tuple[np.int64, np.float64]: ...
    @overload
    def turns(self, t: Array) -> tuple[NDArray[np.int64], Floats]: ...
    @overload
    def turns(self, t: Labelled) -> tuple[Labelled, Labelled]: ...
    def turns(self, t: Any) -> Any:
        """Whole turns and the rest of the angle at the times `t`: ``(n, angle)``.

        theta = 2 pi n + angle with -pi <= angle < pi and the true pi. An angle that rounds to pi is -pi of the next turn.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign. Where `theta` is NaN, `n` is 0 and `angle` NaN.

        Returns
        -------
        pair of int64 and float64, or of arrays of the shape of `t`
            Number of turns, and angle in rad in [-pi, pi). Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error promised: that of `theta`. Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

        Examples
        --------
        >>> import libration
        >>> n, angle = libration.DampedPendulum(0.0, 9.0, friction=libration.Friction(linear=0.1)).turns(20.0)
        >>> print(n, f"{angle:.6f}")
        6 0.333318

        """
        return apply(_Turns(self._damped.turns, 2), t, results=TURNS)

    @overload
    def energy(self, t: Scalar) -> np.float64: ...
    @overload
    def energy(self, t: Array) -> Floats: ...
    @overload
    def energy(self, t: Labelled) -> Labelled: ...
    def energy(self, t: Any) -> Any:
        """Energy per unit inertia at the times `t`, velocity**2/2 + omega0**2 (1 - cos(theta)).

        Zero at rest in the stable equilibrium. The work of a torque is not counted in.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `theta`.

        Returns
        -------
        float64 or array of the shape of `t`
            Energy in rad**2/s**2. Dask, xarray and pandas arrays give their like.

        Notes
        -----
        Error: what that of angle and velocity makes of it. Source: Landau & Lifshitz, Mechanics, section 11.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.DampedPendulum(1.0, friction=libration.Friction(linear=0.01))
        >>> pendulum.energy([0.0, 10.0, 20.0]).round(6)
        array([0.459698, 0.378684, 0.312254])
        """
        return apply(Elementwise(self._damped.energy), t, results=(ENERGY,))

    @overload
    def sensitivities(self, t: Scalar | Array) -> Floats: ...
    @overload
    def sensitivities(self, t: Stacked) -> Stacked: ...
    @overload
    def sensitivities(self, t: Indexed) -> Floats: ...
    def sensitivities(self, t: Any) -> Any:
        """Derivatives of angle and velocity by the start and by every constant, at the times `t`.

        ``[..., i, j]`` is the derivative of (theta, velocity)[i] by the j-th of theta0, velocity0, omega2, linear, quadratic,
        dry, presliding, constant, amplitude, frequency, phase. They include the jumps of derivatives where dry friction turns
        or stops the pendulum.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; outside as for `theta`.

        Returns
        -------
        array of shape ``t.shape + (2, 11)``
            In SI units, angles in rad; NaN by a presliding that is not there. By a velocity0 of 0 under dry friction, and by a dry
            friction of 0, they are one-sided: along the motion, towards friction. Dask and xarray arrays give their like;
            xarray's new dimensions are `of` and `by`.

        Raises
        ------
        ValueError
            If the motion has neither friction nor torque and takes more than a million steps.

        Notes
        -----
        Error promised, in each row: 1e-12 of the largest change, that is of each derivative times the size of its parameter.
        Source: the variational equations, integrated by the same series.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.DampedPendulum(1.0, friction=libration.Friction(linear=0.01))
        >>> pendulum.sensitivities(10.0)[0, :4].round(6)
        array([-8.920760e-01, -1.283300e-02,  6.963000e-03,  9.405914e+00])
        """
        found = apply(Elementwise(self._derivatives, 22), unindexed(t), results=22 * (SENSITIVITIES,))
        return tensor(found, AXES)

    def _derivatives(self, times: np.ndarray) -> tuple[np.ndarray, ...]:
        return tuple(self._damped.sensitivities(times))


class _Turns(Elementwise):
    """Counts are integers."""

    def __init__(self, function: Any, nout: int) -> None:
        super().__init__(function, nout)
        self.types = ("d->ld",)
