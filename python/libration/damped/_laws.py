"""What friction makes of a swing without an integration: the exact half swing, and the averaged laws.

Source: Mungan & Lipscombe, Eur. J. Phys. 34 (2013) 1243; Landau & Lifshitz, Mechanics, section 49; Squire, Am. J. Phys. 54
(1986) 984.
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import Any, TypedDict, Unpack, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Labelled, Scalar
from .._dispatch import Elementwise, apply
from .._labels import Result
from .._messages import explained
from .._scalars import real, shown
from ..pendulum._orbit import frequency_given
from ..pendulum._results import THETA
from ._friction import Friction

LOSS = Result("energy_loss", "rad**2/s**2", "energy per unit inertia lost in a period")
RATE = Result("turning_rate", "rad/s", "rate of change of the turning angle")
TURNING_ANGLE = Result("theta_max", "rad", "turning angle")


class Force(TypedDict, total=False):
    """The numbers that state a frequency."""

    omega0: float | None
    omega2: float | None
    length: float | None
    gravity: float | None


@overload
def half_swing(theta: Scalar, friction: Friction, **frequency: Unpack[Force]) -> np.float64: ...
@overload
def half_swing(theta: Array, friction: Friction, **frequency: Unpack[Force]) -> Floats: ...
@overload
def half_swing(theta: Labelled, friction: Friction, **frequency: Unpack[Force]) -> Labelled: ...
@explained
def half_swing(
    theta: Any,
    friction: Friction,
    *,
    omega0: float | None = None,
    omega2: float | None = None,
    length: float | None = None,
    gravity: float | None = None,
) -> Any:
    """Angle of the next turn after a turn at `theta`, under quadratic and dry friction, exactly.

    The square of the velocity obeys a linear equation over the angle, so no integration is needed. Called on its own result it gives
    all turning angles, one after the other.

    Parameters
    ----------
    theta : scalar or array
        Angle of a turn in rad, in (-pi, pi), of any shape. NaN outside.
    friction : Friction
        With a quadratic term that is not negative, a dry one, or both; without linear friction and presliding.
    omega0, omega2, length, gravity : scalar, optional
        As for `Pendulum`, with omega2 > 0: at most one of the first three; none of them means ``omega0=1``.

    Returns
    -------
    float64 or array of the shape of `theta`
        Angle of the next turn in rad; `theta` itself where dry friction holds the pendulum there. Dask, xarray and pandas arrays give
        their like.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Error promised: 2 ulp of `theta`. Source: Mungan & Lipscombe, Eur. J. Phys. 34 (2013) 1243, with dry friction added, which leaves
    their equation linear.

    Examples
    --------
    >>> from libration import Friction
    >>> from libration.damped import half_swing
    >>> theta = 2.0
    >>> for _ in range(3):
    ...     theta = half_swing(theta, Friction(quadratic=0.1, dry=0.02))
    ...     print(f"{theta:.6f}")
    -1.438239
    1.136551
    -0.934667
    """
    held = friction.linear or (friction.presliding and friction.dry) if isinstance(friction, Friction) else True
    if held or friction.quadratic < 0:
        what = "a Friction without a linear term and without presliding, its quadratic term not negative"
        raise ValueError(f"friction = {shown(friction)}: must be {what}")
    return law("half_swing", theta, THETA, friction, pulling(omega0, omega2, length, gravity))


@overload
def averaged_energy_loss(theta_max: Scalar, friction: Friction, **frequency: Unpack[Force]) -> np.float64: ...
@overload
def averaged_energy_loss(theta_max: Array, friction: Friction, **frequency: Unpack[Force]) -> Floats: ...
@overload
def averaged_energy_loss(theta_max: Labelled, friction: Friction, **frequency: Unpack[Force]) -> Labelled: ...
@explained
def averaged_energy_loss(
    theta_max: Any,
    friction: Friction,
    *,
    omega0: float | None = None,
    omega2: float | None = None,
    length: float | None = None,
    gravity: float | None = None,
) -> Any:
    """Energy that friction takes from a libration in a period, in the mean.

    4 pi linear J + 8 quadratic omega0**2 (sin(a) - a cos(a)) + 4 dry (a - presliding tanh(a/presliding)), a being the turning angle and
    J the action: the integral of friction over the angle along the undamped orbit. The action falls by 1/(2 pi) of it in a period.

    Parameters
    ----------
    theta_max : scalar or array
        Turning angle in rad, in [0, pi), of any shape. NaN outside.
    friction : Friction
        Any.
    omega0, omega2, length, gravity : scalar, optional
        As for `half_swing`.

    Returns
    -------
    float64 or array of the shape of `theta_max`
        Energy per unit inertia in rad**2/s**2. Dask, xarray and pandas arrays give their like.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Error promised: 1e-15 of the result, as a formula of first order in friction over omega0. What the formula leaves out is of second
    order, and grows next to the separatrix. Source: Landau & Lifshitz, Mechanics, section 49; Squire, Am. J. Phys. 54 (1986) 984.

    Examples
    --------
    >>> from libration import Friction
    >>> from libration.damped import averaged_energy_loss
    >>> averaged_energy_loss([0.5, 1.0, 2.0], Friction(dry=0.01))
    array([0.02, 0.04, 0.08])
    """
    return law("averaged_energy_loss", theta_max, LOSS, friction, pulling(omega0, omega2, length, gravity))


@overload
def averaged_turning_rate(theta_max: Scalar, friction: Friction, **frequency: Unpack[Force]) -> np.float64: ...
@overload
def averaged_turning_rate(theta_max: Array, friction: Friction, **frequency: Unpack[Force]) -> Floats: ...
@overload
def averaged_turning_rate(theta_max: Labelled, friction: Friction, **frequency: Unpack[Force]) -> Labelled: ...
@explained
def averaged_turning_rate(
    theta_max: Any,
    friction: Friction,
    *,
    omega0: float | None = None,
    omega2: float | None = None,
    length: float | None = None,
    gravity: float | None = None,
) -> Any:
    """How fast the turning angle of a libration changes under friction, in the mean.

    Minus the energy lost in a period over T omega0**2 sin(theta_max).

    Parameters
    ----------
    theta_max : scalar or array
        Turning angle in rad, in (0, pi), of any shape. NaN outside, and at rest.
    friction : Friction
        Any.
    omega0, omega2, length, gravity : scalar, optional
        As for `half_swing`.

    Returns
    -------
    float64 or array of the shape of `theta_max`
        Rate in rad/s, below 0 where friction takes. Dask, xarray and pandas arrays give their like.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Error promised: 2e-15 of the result; of the formula, as for `averaged_energy_loss`. Source: the same.

    Examples
    --------
    >>> from libration import Friction
    >>> from libration.damped import averaged_turning_rate
    >>> averaged_turning_rate([0.1, 1.0, 2.0, 3.0], Friction(linear=0.01)).round(6)
    array([-0.001001, -0.01057 , -0.026446, -0.138766])
    """
    return law("averaged_turning_rate", theta_max, RATE, friction, pulling(omega0, omega2, length, gravity))


@overload
def averaged_turning_angle(
    theta_max: float, t: Scalar, friction: Friction, **frequency: Unpack[Force]
) -> np.float64: ...
@overload
def averaged_turning_angle(theta_max: float, t: Array, friction: Friction, **frequency: Unpack[Force]) -> Floats: ...
@overload
def averaged_turning_angle(
    theta_max: float, t: Labelled, friction: Friction, **frequency: Unpack[Force]
) -> Labelled: ...
@explained
def averaged_turning_angle(
    theta_max: float,
    t: Any,
    friction: Friction,
    *,
    omega0: float | None = None,
    omega2: float | None = None,
    length: float | None = None,
    gravity: float | None = None,
) -> Any:
    """Turning angle at the times `t` after it was `theta_max`, under friction, in the mean: the envelope of a decay.

    Linear friction alone leaves the action J(0) exp(-2 linear t); of small swings the angle then falls as exp(-linear t), quadratic
    friction makes it 1/(1/a + 4 quadratic omega0 t/(3 pi)), and dry friction takes 2 dry t/(pi omega0) of it.

    Parameters
    ----------
    theta_max : scalar
        Turning angle at t = 0 in rad, in [0, pi).
    t : scalar or array
        Time in s, of any shape and sign.
    friction : Friction
        No term below 0, or the linear one alone, of any sign.
    omega0, omega2, length, gravity : scalar, optional
        As for `half_swing`.

    Returns
    -------
    float64 or array of the shape of `t`
        Turning angle in rad. 0 where dry friction has stopped the pendulum; NaN where it would be beyond pi. Dask, xarray and pandas
        arrays give their like.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Error promised: 16 ulp, plus 2**-52 of t times the rate there; of the formula, as for `averaged_energy_loss`. Source: the integral
    of `averaged_turning_rate`, by Gauss's rule.

    Examples
    --------
    >>> from libration import DampedPendulum, Friction
    >>> from libration.damped import averaged_turning_angle
    >>> friction = Friction(linear=0.004, quadratic=0.01, dry=0.002)
    >>> pendulum = DampedPendulum(2.0, friction=friction)
    >>> turns = pendulum.turning_times(0.0, 40.0)[::3]
    >>> abs(pendulum.theta(turns)).round(4)
    array([2.    , 1.6869, 1.4659, 1.2953])
    >>> averaged_turning_angle(2.0, turns, friction).round(4)
    array([2.    , 1.6868, 1.4657, 1.2951])
    """
    start = real("theta_max", theta_max)
    if not 0 <= start < np.pi:
        raise ValueError(f"theta_max = {start!r}: must be in [0, pi)")
    known = isinstance(friction, Friction)
    if known and (friction.quadratic or friction.dry) and min(friction.linear, friction.quadratic) < 0:
        raise ValueError(f"friction = {shown(friction)}: must have no term below 0, or the linear one alone")
    frequency = pulling(omega0, omega2, length, gravity)
    return law("averaged_turning_angle", t, TURNING_ANGLE, friction, frequency, start)


def law(
    name: str, values: Any, result: Result, friction: Friction, frequency: dict[str, float], start: float = 0.0
) -> Any:
    """What the core's law of this name gives at each value."""
    if not isinstance(friction, Friction):
        raise ValueError(f"friction = {shown(friction)}: must be a Friction")
    terms = friction._terms
    of = "t" if name == "averaged_turning_angle" else "theta_max"
    at = Elementwise(lambda array: _core.friction_law(name, array, terms, start, **frequency), argument=of)
    return apply(at, values, results=(result,))


def pulling(omega0: Any, omega2: Any, length: Any, gravity: Any) -> dict[str, float]:
    """The numbers that state a frequency whose force pulls down."""
    frequency = frequency_given(omega0, omega2, length, gravity)
    for name, value in frequency.items():
        if name != "length" and value <= 0:
            raise ValueError(f"{name} = {value!r}: must be positive, so that the pendulum swings about theta = 0")
    return frequency
