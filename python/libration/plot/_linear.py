"""The linear solution of a pendulum, with the phase of the exact frequency."""

from __future__ import annotations

from typing import Any, overload

import numpy as np

from .._arrays import Array, Floats, Labelled, Scalar
from ..approx import angle
from ..pendulum import Pendulum


@overload
def linear_theta(pendulum: Pendulum, t: Scalar) -> np.float64: ...
@overload
def linear_theta(pendulum: Pendulum, t: Array) -> Floats: ...
@overload
def linear_theta(pendulum: Pendulum, t: Labelled) -> Labelled: ...
def linear_theta(pendulum: Pendulum, t: Any) -> Any:
    """The linear solution theta0 cos(omega0 t) + velocity0 / omega0 sin(omega0 t).

    With the exact frequency: the phase has all its digits after any number of swings.

    Parameters
    ----------
    pendulum : Pendulum
        Initial state and frequency; without a force the solution is theta0 + velocity0 t.
    t : array_like
        Instants, s. More than 2**53 half swings give NaN, as in `Pendulum.theta`.

    Returns
    -------
    ndarray
        Angle, rad.

    Raises
    ------
    ValueError
        If omega2 < 0: there the linear solution about theta = 0 grows and is no swing.

    Examples
    --------
    >>> from libration import Pendulum
    >>> from libration.plot import linear_theta
    >>> f"{linear_theta(Pendulum(3.0, omega0=2.0), 1e6):.6f}"
    '2.265027'
    """
    if pendulum.omega2 < 0:
        raise ValueError(f"omega2 = {pendulum.omega2!r}: must not be negative for a linear solution that swings")
    return angle("linear").of(pendulum).theta(t)
