"""How angle and velocity change with the start and the force: the exact derivatives, of one orbit and of arrays of states."""

from typing import Any

from . import _core
from .dispatch import apply, tensor, unindexed
from .orbit import Orbit

_BY = ("theta0", "velocity0", "omega0")
_FIRST = {"of": ("theta", "velocity"), "by": _BY}
_SECOND = {**_FIRST, "and_by": _BY}
# Where each of a symmetric matrix's nine elements stands among its six different ones.
_SYMMETRIC = (0, 1, 2, 1, 3, 4, 2, 4, 5)


class Derivatives(Orbit):
    """The derivatives of one orbit."""

    __slots__ = ()

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
        return tensor(apply(_core.orbit_sensitivities, unindexed(t), *self._operands), _FIRST)

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
        twelve = apply(_core.orbit_second_sensitivities, unindexed(t), *self._operands)
        return tensor(tuple(twelve[6 * of + i] for of in range(2) for i in _SYMMETRIC), _SECOND)


def sensitivities(t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0) -> Any:
    """Derivatives of the state a time `t` after (theta0, velocity0), by theta0, velocity0 and omega0.

    What `Pendulum.sensitivities` is, element by element. ``sensitivities(dt, theta, velocity, omega0)[..., :2]`` is the
    Jacobian matrix of `advance`; its determinant is 1.

    Parameters
    ----------
    t : scalar or array
        Time in s; not finite, and more than 2**53 half periods away, gives NaN.
    theta0 : scalar or array
        Initial angle in rad, finite.
    velocity0 : scalar or array, default 0.0
        Initial angular velocity in rad/s, finite.
    omega0 : scalar or array, default 1.0
        Angular frequency of small swings in rad/s, finite and >= 0.

    Returns
    -------
    array of the broadcast shape + (2, 3)
        ``[..., i, j]`` is the derivative of (theta, velocity)[i] by (theta0, velocity0, omega0)[j]. A bad element gives NaN
        there and nowhere else.

    Notes
    -----
    Error promised, in each row: 1e-12 of the largest change, as for `Pendulum.sensitivities`. Source: DLMF 22.13(i),
    22.16(ii), 19.25(i).

    Examples
    --------
    >>> import numpy as np
    >>> import libration
    >>> slopes = libration.sensitivities(2.0, np.array([0.1, 1.0, 3.0]))
    >>> slopes.shape
    (3, 2, 3)
    >>> np.linalg.det(slopes[..., :2]).round(6)
    array([1., 1., 1.])
    """
    return tensor(apply(_core.state_sensitivities, *map(unindexed, (t, theta0, velocity0, omega0))), _FIRST)
