"""Functions of arrays of times and states, each element exact: ``theta``, ``velocity``, ``motion``, ``advance``.

Two paths, decided by the call and never by memory layout: orbit arguments without dimensions take the path of one
orbit, set up once; orbit arguments with dimensions take the path of rows with states of their own. Rows that are stated
otherwise than by angle, velocity and omega0 are set up one by one.
Source: DLMF 22.19(i).
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from .. import _core
from .._arrays import Floats, Labelled, Mask, Real, Scalar
from .._dispatch import apply
from ._results import MOTION, THETA, VELOCITY
from ._signatures import OtherFrequency, of_time, told
from ._states import INITIAL, factors, orbit, plain, plain_state

if TYPE_CHECKING:
    from typing import Unpack

    from ._signatures import MotionOfTime


def _of_motion(function: Any) -> MotionOfTime:
    """Declare a function of a time and an initial state that gives angle and velocity."""
    return told(function)  # type: ignore[no-any-return]


@of_time
def theta(
    t: Any,
    theta0: Any = None,
    velocity0: Any = None,
    omega0: Any = None,
    *,
    theta0_from_top: Any = None,
    energy_ratio: Any = None,
    energy_ratio_c: Any = None,
    energy: Any = None,
    direction: Any = 1.0,
    omega2: Any = None,
    length: Any = None,
    gravity: Any = None,
    out: Any = None,
    where: Any = True,
) -> Any:
    """Angle of pendulums at the times `t`, continuous through whole turns.

    The solution of theta'' + omega0**2 sin(theta) = 0 from the state (theta0, velocity0) at t = 0.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN, and more than 2**53 half periods, give NaN; rest, the separatrix and free rotation have no such
        limit.
    <start>
    out : ndarray, optional
        Where to put the result, as for every NumPy ufunc.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape
        Angle in rad. A bad element gives NaN there and nowhere else; nothing raises for it.

    Notes
    -----
    Error promised: with scalar orbit arguments that of `Pendulum`, the same digits as its method; with arrays of
    them 8 ulp of the largest angle of the orbit. Within each of the two, a value does not depend on shape, order,
    strides or chunks. Dask and xarray arrays give their like, and stay lazy. Source: DLMF 22.19(i).

    Examples
    --------
    >>> import numpy as np
    >>> import libration
    >>> libration.theta(np.array([[0.0], [2.0]]), np.array([1.0, 3.0])).round(6)
    array([[ 1.      ,  3.      ],
           [-0.306201,  2.613057]])
    """
    others = theta0_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta0, velocity0, omega0, direction, *others):
        if not _one_orbit(*state):
            return apply(_core.state_theta, t, *state, results=(THETA,), out=out, where=where)
        given: Any = (*state[:2], 1.0, 0.0, *apply(_core.factors, state[2]))
    else:
        angles, motions = (theta0, theta0_from_top), (velocity0, energy_ratio, energy_ratio_c, energy)
        given = orbit(INITIAL, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_theta, t, *given, results=(THETA,), out=out, where=where)


@of_time
def velocity(
    t: Any,
    theta0: Any = None,
    velocity0: Any = None,
    omega0: Any = None,
    *,
    theta0_from_top: Any = None,
    energy_ratio: Any = None,
    energy_ratio_c: Any = None,
    energy: Any = None,
    direction: Any = 1.0,
    omega2: Any = None,
    length: Any = None,
    gravity: Any = None,
    out: Any = None,
    where: Any = True,
) -> Any:
    """Angular velocity of pendulums at the times `t`.

    The derivative of `theta`, for theta'' + omega0**2 sin(theta) = 0 from the state (theta0, velocity0) at t = 0.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN, and more than 2**53 half periods, give NaN; rest, the separatrix and free rotation have no such
        limit.
    <start>
    out : ndarray, optional
        Where to put the result, as for every NumPy ufunc.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape
        Angular velocity in rad/s. A bad element gives NaN there and nowhere else; nothing raises for it.

    Notes
    -----
    Error promised: with scalar orbit arguments that of `Pendulum`, the same digits as its method; with arrays of
    them 8 ulp of the largest velocity of the orbit. Source: DLMF 22.19(i).

    Examples
    --------
    >>> import libration
    >>> libration.velocity([0.0, 1.0], 0.0, 1.0).round(6)
    array([1.      , 0.568569])
    """
    others = theta0_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta0, velocity0, omega0, direction, *others):
        if not _one_orbit(*state):
            return apply(_core.state_velocity, t, *state, results=(VELOCITY,), out=out, where=where)
        given: Any = (*state[:2], 1.0, 0.0, *apply(_core.factors, state[2]))
    else:
        angles, motions = (theta0, theta0_from_top), (velocity0, energy_ratio, energy_ratio_c, energy)
        given = orbit(INITIAL, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_velocity, t, *given, results=(VELOCITY,), out=out, where=where)


@_of_motion
def motion(
    t: Any,
    theta0: Any = None,
    velocity0: Any = None,
    omega0: Any = None,
    *,
    theta0_from_top: Any = None,
    energy_ratio: Any = None,
    energy_ratio_c: Any = None,
    energy: Any = None,
    direction: Any = 1.0,
    omega2: Any = None,
    length: Any = None,
    gravity: Any = None,
    out: Any = None,
    where: Any = True,
) -> Any:
    """Angle and angular velocity of pendulums at the times `t`, together: ``(theta, velocity)``.

    The same digits as `theta` and `velocity`, for little more than the price of one.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN, and more than 2**53 half periods, give NaN; rest, the separatrix and free rotation have no such
        limit.
    <start>
    out : pair of ndarray, optional
        Where to put the results; an input may be among them.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        Angle in rad and angular velocity in rad/s. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: that of `theta` and of `velocity`. Source: DLMF 22.19(i).

    Examples
    --------
    >>> import libration
    >>> theta, velocity = libration.motion(2.0, 1.0)
    >>> print(f"{theta:.6f} {velocity:.6f}")
    -0.306201 -0.909047
    """
    others = theta0_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta0, velocity0, omega0, direction, *others):
        if not _one_orbit(*state):
            return apply(_core.state_motion, t, *state, results=MOTION, out=out, where=where)
        given: Any = (*state[:2], 1.0, 0.0, *apply(_core.factors, state[2]))
    else:
        angles, motions = (theta0, theta0_from_top), (velocity0, energy_ratio, energy_ratio_c, energy)
        given = orbit(INITIAL, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_motion, t, *given, results=MOTION, out=out, where=where)


@overload
def advance(
    theta: Scalar,
    velocity: Scalar,
    dt: Scalar,
    omega0: Scalar | None = None,
    *,
    out: None = None,
    where: bool = True,
    **other: Unpack[OtherFrequency[Scalar]],
) -> tuple[np.float64, np.float64]: ...
@overload
def advance(
    theta: Real,
    velocity: Real,
    dt: Real,
    omega0: Real | None = None,
    *,
    out: tuple[Floats, Floats] | None = None,
    where: Mask = True,
    **other: Unpack[OtherFrequency[Real]],
) -> tuple[Floats, Floats]: ...
@overload
def advance(
    theta: Real | Labelled,
    velocity: Real | Labelled,
    dt: Real | Labelled,
    omega0: Real | Labelled | None = None,
    *,
    out: tuple[Labelled, Labelled] | None = None,
    where: Mask = True,
    **other: Unpack[OtherFrequency[Real | Labelled]],
) -> tuple[Labelled, Labelled]: ...
@told
def advance(
    theta: Any,
    velocity: Any,
    dt: Any,
    omega0: Any = None,
    *,
    omega2: Any = None,
    length: Any = None,
    gravity: Any = None,
    out: Any = None,
    where: Any = True,
) -> Any:
    """State of pendulums a time `dt` later: ``(theta, velocity)``.

    The exact flow of theta'' + omega0**2 sin(theta) = 0, by the addition theorem, without inverse functions: no
    step is too long, and many in a row keep the energy. The angle goes on continuously from `theta`.

    Parameters
    ----------
    theta : scalar or array
        Angle in rad, finite.
    velocity : scalar or array
        Angular velocity in rad/s, finite.
    dt : scalar or array
        Time to go in s, of any sign. NaN, and more than 2**53 half periods, give NaN; rest, the separatrix and free
        rotation have no such limit.
    <frequency>
    out : pair of ndarray, optional
        Where to put the results; ``out=(theta, velocity)`` advances the states in place.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        Angle in rad and angular velocity in rad/s. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 8 ulp of the largest angle and velocity of the orbit; a million calls in a row keep the energy
    ratio to 1e-12 if the caller wraps the angle of a rotation. Its Jacobian matrix is
    ``sensitivities(dt, theta, velocity, omega0)[..., :2]``. Source: DLMF 22.8(i), 22.19(i).

    Examples
    --------
    >>> import libration
    >>> theta, velocity = libration.advance(1.0, 0.0, 2.0)
    >>> print(f"{theta:.6f} {velocity:.6f}")
    -0.306201 -0.909047
    """
    if plain(1.0, omega2, length, gravity):
        step = theta, velocity, dt, 1.0 if omega0 is None else omega0
        return apply(_core.advance, *step, results=MOTION, out=out, where=where)
    force = factors(omega0, omega2, length, gravity)
    return apply(_core.orbit_advance, theta, velocity, dt, *force, results=MOTION, out=out, where=where)


def _one_orbit(theta0: Any, velocity0: Any, omega0: Any) -> bool:
    """Whether no orbit argument has dimensions."""
    if type(theta0) is type(velocity0) is type(omega0) is float:
        return True
    return not (np.ndim(theta0) or np.ndim(velocity0) or np.ndim(omega0))
