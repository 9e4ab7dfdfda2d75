"""When an angle is passed next, and the whole turns of the angle, of arrays of states.

Source: DLMF 19.25.5, 22.15(ii), 22.19(i).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _core
from .._dispatch import apply
from ._results import CROSSING, TURNS
from ._signatures import of_angle, told
from ._states import INITIAL, orbit

if TYPE_CHECKING:
    from ._signatures import TurnsOfTime


def _of_turns(function: Any) -> TurnsOfTime:
    """Declare a function of a time and an initial state that gives turns and the rest."""
    return told(function)  # type: ignore[no-any-return]


@_of_turns
def turns(
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
) -> Any:
    """Whole turns of pendulums and the rest of the angle at the times `t`: ``(n, angle)``.

    What `Pendulum.turns` is, element by element: theta = 2 pi n + angle with -pi <= angle < pi.
    An angle that rounds to pi is -pi of the next turn.

    Parameters
    ----------
    t : scalar or array
        Time in s; outside as for `theta`.
    <start>

    Returns
    -------
    pair of int64 and float64, or of arrays of the broadcast shape
        Number of turns, and angle in rad. A bad element gives 0 and NaN there and nowhere else.

    Notes
    -----
    Error promised: the angle within 4 ulp of pi. Source: DLMF 22.19(i), 22.16(i).

    Examples
    --------
    >>> import libration
    >>> n, angle = libration.turns(10.0, 0.0, [1.0, 3.0])
    >>> print(n, angle.round(6))
    [0 4] [0.114252 1.025388]
    """
    angles, motions = (theta0, theta0_from_top), (velocity0, energy_ratio, energy_ratio_c, energy)
    given = orbit(INITIAL, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.turns, t, *given, results=TURNS)


@of_angle
def next_crossing(
    theta: Any,
    theta0: Any = None,
    velocity0: Any = None,
    omega0: Any = None,
    *,
    after: Any = 0.0,
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
    """First time at which pendulums pass the angle `theta`.

    What the first of ``Pendulum.times(theta, after, ...)`` is, element by element: in libration modulo 2 pi, in rotation
    and on the separatrix the unwrapped angle, which is passed once at most.

    Parameters
    ----------
    theta : scalar or array
        Angle in rad, finite.
    after : scalar or array, default 0.0
        Time in s from which on is looked, included.
    <start>
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape
        Time in s; NaN where the angle is not passed any more, at rest, and for a bad element.

    Notes
    -----
    Error promised: the motion at each time is at `theta` within 4 ulp of the largest angle plus what an ulp of the
    time makes of it. Source: DLMF 19.25.5, 22.15(ii).

    Examples
    --------
    A pencil 1e-17 rad from upright falls to a right angle:

    >>> import numpy as np
    >>> import libration
    >>> f"{libration.next_crossing(1.5 * np.pi, theta0_from_top=1e-17, omega2=73.5):.9f}"
    '4.705588134'
    """
    angles, motions = (theta0, theta0_from_top), (velocity0, energy_ratio, energy_ratio_c, energy)
    given = orbit(INITIAL, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_next_crossing, theta, after, *given, results=(CROSSING,), out=out, where=where)
