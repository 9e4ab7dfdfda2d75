"""Numbers of the package `uncertainties` through the exact derivatives: the motion and the period with what is not known of start and force.

To first order, f(x) + sum_j df/dx_j (x_j - mean): correlations stay, because a deviation is that very variable less its mean. Source: GUM 5.1
and 5.2; the derivatives are those of `Pendulum.sensitivities`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .._advice import advice
from .._scalars import shown
from ._pendulum import Pendulum

Numbers = tuple[Any, Any]


def uncertain_motion(
    t: Any, theta0: Any, velocity0: Any = 0.0, *, omega0: Any = None, length: Any = None, gravity: Any = None
) -> Numbers:
    """Angle and angular velocity at the times `t`, with the uncertainties of start, force and time.

    Parameters
    ----------
    t : scalar, number with an uncertainty, or array of them
        Time in s.
    theta0 : scalar or number with an uncertainty
        Initial angle in rad.
    velocity0 : scalar or number with an uncertainty, default 0.0
        Initial angular velocity in rad/s.
    omega0 : scalar or number with an uncertainty, optional
        Angular frequency of small swings in rad/s, above 0; without it and without `length` it is 1.
    length, gravity : scalar or number with an uncertainty, optional
        As for `Pendulum`: in m and m/s**2; gravity is 9.80665 if only the length is given.

    Returns
    -------
    pair of numbers with uncertainties, or of arrays of them of the shape of `t`
        Angle in rad and angular velocity in rad/s, correlated with each other and with what is given. The mean is that of
        `Pendulum.motion`, digit for digit. Plain numbers where nothing that is given has an uncertainty.

    Raises
    ------
    ValueError
        As for `Pendulum`.

    Notes
    -----
    First order: right while the derivatives change little within an uncertainty, which near the separatrix and after many swings
    is soon not so. Error promised of each derivative: as for `Pendulum.sensitivities`. Source: GUM (JCGM 100:2008) 5.1.2, 5.2.2.

    Examples
    --------
    >>> from uncertainties import ufloat
    >>> from libration import uncertain_motion
    >>> theta, velocity = uncertain_motion(10.0, ufloat(1.0, 0.01), length=ufloat(0.65, 0.001))
    >>> print(f"{theta:.1u}")
    0.30+/-0.05
    """
    orbit, deviations = _orbit(theta0, velocity0, omega0, length, gravity)
    times = _times(t)
    results = np.empty((2, *times.shape), dtype=object)
    for place in np.ndindex(times.shape):
        time = times[place]
        at, late = _mean(time), _deviation(time)
        theta, velocity = orbit.motion(at)
        slopes = orbit.sensitivities(at)
        pull = -orbit.omega2 * math.sin(orbit.turns(at)[1])
        for of, (value, rate) in enumerate(((theta, velocity), (velocity, pull))):
            parts = [
                float(slope) * each for slope, each in zip(slopes[of], deviations, strict=True) if each is not None
            ]
            results[(of, *place)] = float(value) + sum(parts) + (0 if late is None else float(rate) * late)
    return results[0], results[1]


def uncertain_period(
    theta0: Any, velocity0: Any = 0.0, *, omega0: Any = None, length: Any = None, gravity: Any = None
) -> Any:
    """The period, of a rotation the time of one turn, with the uncertainties of start and force.

    After a period the state is the initial one: of theta(T, x) = theta0, or of the same for the velocity, the derivative gives dT/dx.

    Parameters
    ----------
    theta0, velocity0, omega0, length, gravity : scalar or number with an uncertainty
        As for `uncertain_motion`.

    Returns
    -------
    number with an uncertainty
        In s, correlated with what is given. The mean is `Pendulum.period`, digit for digit.

    Raises
    ------
    ValueError
        As for `Pendulum`; at rest and on the separatrix, where a period has no derivative.

    Notes
    -----
    First order, as for `uncertain_motion`. Source: GUM (JCGM 100:2008) 5.1.2, 5.2.2.

    Examples
    --------
    >>> from uncertainties import ufloat
    >>> from libration import uncertain_period
    >>> period = uncertain_period(ufloat(2.618, 0.002), length=ufloat(0.65, 0.001))
    >>> print(f"{period:.1u}")
    2.851+/-0.004
    """
    orbit, deviations = _orbit(theta0, velocity0, omega0, length, gravity)
    if orbit.regime in ("rest", "separatrix"):
        raise ValueError(f"{orbit!r}: {orbit.regime} has no derivative of the period")
    slopes = orbit.sensitivities(orbit.period)
    pull = -orbit.omega2 * math.sin(orbit.turns(0.0)[1])
    # The one of the two equations whose factor of dT is larger, in the units of omega0.
    of = 0 if abs(orbit.velocity0) * orbit.omega0 >= abs(pull) else 1
    rate = orbit.velocity0 if of == 0 else pull
    parts = [
        (float(by == of) - float(slopes[of][by])) / rate * each
        for by, each in enumerate(deviations)
        if each is not None
    ]
    return float(orbit.period) + sum(parts)


def _times(t: Any) -> Any:
    """The times as an array of objects, each a number or one with an uncertainty."""
    times = np.array(t, dtype=object)
    try:
        for each in times.ravel():
            float(_mean(each))
    except (TypeError, ValueError, OverflowError):
        allowed = "must be real numbers, each with an uncertainty or without"
        raise TypeError(f"t = {shown(t)}: {allowed}{advice('t', t)}") from None
    return times


def _mean(value: Any) -> Any:
    """The number itself, or the mean of one with an uncertainty."""
    return getattr(value, "nominal_value", value)


def _deviation(value: Any) -> Any:
    """A number less its mean; None if it has no uncertainty."""
    return value - value.nominal_value if hasattr(value, "nominal_value") else None


def _orbit(
    theta0: Any, velocity0: Any, omega0: Any, length: Any, gravity: Any
) -> tuple[Pendulum, tuple[Any, Any, Any]]:
    """The pendulum of the means, and the deviations of theta0, velocity0 and omega0."""
    stated = {"omega0": omega0, "length": length, "gravity": gravity}
    given = {name: _mean(value) for name, value in stated.items() if value is not None}
    orbit = Pendulum(_mean(theta0), _mean(velocity0), **given)
    force = _deviation(omega0)
    if length is not None:
        # omega0 = sqrt(gravity/length).
        halves = (_deviation(gravity), 0.5), (_deviation(length), -0.5)
        shares = [
            power * orbit.omega0 / given[name] * each
            for name, (each, power) in zip(("gravity", "length"), halves, strict=True)
            if each is not None
        ]
        force = sum(shares) if shares else None
    return orbit, (_deviation(theta0), _deviation(velocity0), force)
