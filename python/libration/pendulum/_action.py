"""Action and angle: what an orbit keeps, and the phase that grows evenly with time, of arrays of states.

The action J is the closed integral of velocity dtheta over 2 pi, per unit inertia: of one full swing, or of one turn. At the
separatrix its limits differ: 8 omega0/pi of librations, which pass both ways, 4 omega0/pi of rotations, which pass
one way. The separatrix itself is given that of librations. dJ/dE = 1/abs(frequency).
Source: Landau & Lifshitz, Mechanics, sections 11 and 49.
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from .. import _core
from .._arrays import Floats, Labelled, Mask, Real, Scalar
from .._dispatch import apply
from ._results import ACTION, FREQUENCY, MOTION, PHASE
from ._signatures import OtherFrequency, of_state, told
from ._states import NOW, factors, orbit, plain, plain_state

if TYPE_CHECKING:
    from typing import Unpack


@of_state
def action(
    theta: Any = None,
    velocity: Any = None,
    omega0: Any = None,
    *,
    theta_from_top: Any = None,
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
    """Action of pendulums in the states (theta, velocity).

    What `Pendulum.action` is, element by element.

    Parameters
    ----------
    <state>
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape
        Action in rad**2/s. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: Landau & Lifshitz, Mechanics, section 49.

    Examples
    --------
    >>> import libration
    >>> libration.action([0.0, 0.0], [1.0, 3.0]).round(6)
    array([0.517316, 2.631985])
    """
    others = theta_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta, velocity, omega0, direction, *others):
        return apply(_core.action, *state, results=(ACTION,), out=out, where=where)
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_action, *given, results=(ACTION,), out=out, where=where)


@of_state
def frequency(
    theta: Any = None,
    velocity: Any = None,
    omega0: Any = None,
    *,
    theta_from_top: Any = None,
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
    """Mean angular frequency of pendulums in the states (theta, velocity), negative in rotation downwards.

    What `Pendulum.frequency` is, element by element.

    Parameters
    ----------
    <state>
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape
        Frequency in rad/s. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 22.19(i).

    Examples
    --------
    >>> import libration
    >>> libration.frequency(0.0, [1.0, 2.0, -3.0]).round(6)
    array([ 0.931808,  0.      , -2.604008])
    """
    others = theta_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta, velocity, omega0, direction, *others):
        return apply(_core.frequency, *state, results=(FREQUENCY,), out=out, where=where)
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_frequency, *given, results=(FREQUENCY,), out=out, where=where)


@of_state
def phase(
    theta: Any = None,
    velocity: Any = None,
    omega0: Any = None,
    *,
    theta_from_top: Any = None,
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
    """Phase of pendulums in the states (theta, velocity).

    What ``Pendulum(theta, velocity).phase(0)`` is, element by element: in (-pi, pi] in libration, along with the angle in
    rotation.

    Parameters
    ----------
    <state>
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape
        Phase in rad; NaN on the separatrix. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp of the larger of the phase and pi. Source: DLMF 22.19(i).

    Examples
    --------
    >>> import libration
    >>> libration.phase([1.0, -1.0, 7.0], [0.0, 0.0, 3.0]).round(6)
    array([ 1.570796, -1.570796,  6.916943])
    """
    others = theta_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta, velocity, omega0, direction, *others):
        return apply(_core.phase, *state, results=(PHASE,), out=out, where=where)
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_phase, 0.0, *given, results=(PHASE,), out=out, where=where)


@overload
def from_action_phase(
    action: Scalar,
    phase: Scalar,
    omega0: Scalar | None = None,
    *,
    direction: Scalar = 0.0,
    out: None = None,
    where: bool = True,
    **other: Unpack[OtherFrequency[Scalar]],
) -> tuple[np.float64, np.float64]: ...
@overload
def from_action_phase(
    action: Real,
    phase: Real,
    omega0: Real | None = None,
    *,
    direction: Real = 0.0,
    out: tuple[Floats, Floats] | None = None,
    where: Mask = True,
    **other: Unpack[OtherFrequency[Real]],
) -> tuple[Floats, Floats]: ...
@overload
def from_action_phase(
    action: Real | Labelled,
    phase: Real | Labelled,
    omega0: Real | Labelled | None = None,
    *,
    direction: Real | Labelled = 0.0,
    out: tuple[Labelled, Labelled] | None = None,
    where: Mask = True,
    **other: Unpack[OtherFrequency[Real | Labelled]],
) -> tuple[Labelled, Labelled]: ...
@told
def from_action_phase(
    action: Any,
    phase: Any,
    omega0: Any = None,
    *,
    direction: Any = 0.0,
    omega2: Any = None,
    length: Any = None,
    gravity: Any = None,
    out: Any = None,
    where: Any = True,
) -> Any:
    """States of pendulums with these actions and phases: ``(theta, velocity)``.

    The inverse of `action` and `phase`, element by element: librations within one turn of the bottom, rotations in the
    turn of their phase.

    Parameters
    ----------
    action : scalar or array
        In rad**2/s: from 0 and below 8 omega0/pi in libration, above 4 omega0/pi in rotation; else NaN.
    phase : scalar or array
        In rad, finite.
    <frequency>
    direction : scalar or array, default 0.0
        0 for a libration, 1 and -1 for a rotation upwards and downwards; else NaN.
    out : pair of ndarray, optional
        Where to put the results.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        Angle in rad and angular velocity in rad/s.

    Notes
    -----
    Error promised: 4 ulp of the largest angle and velocity, plus what an ulp of the action makes of them.
    Source: Newton's method on the action's integrals, DLMF 19.4.1, 19.4.2.

    Examples
    --------
    >>> import libration
    >>> theta, velocity = libration.from_action_phase(2.0, [0.0, 1.0], direction=[0, 1])
    >>> print(theta.round(6), velocity.round(6))
    [0.       1.228194] [1.844231 2.190769]
    """
    if plain(1.0, omega2, length, gravity):
        given = action, phase, direction, 1.0 if omega0 is None else omega0
        return apply(_core.from_action_phase, *given, results=MOTION, out=out, where=where)
    force = factors(omega0, omega2, length, gravity)
    return apply(_core.orbit_from_action_phase, action, phase, direction, *force, results=MOTION, out=out, where=where)
