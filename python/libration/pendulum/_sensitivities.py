"""How angle and velocity change with the start and the force: the exact derivatives, of arrays of states."""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import Any, overload

from .. import _core
from .._arrays import Floats, Indexed, Real, Stacked
from .._dispatch import apply, tensor, unindexed
from .._messages import explained
from ._results import SENSITIVITIES

BY = ("theta0", "velocity0", "omega0")
FIRST = {"of": ("theta", "velocity"), "by": BY}
SECOND = {**FIRST, "and_by": BY}
# Where each of a symmetric matrix's nine elements stands among its six different ones.
SYMMETRIC = (0, 1, 2, 1, 3, 4, 2, 4, 5)


@overload
def sensitivities(t: Real, theta0: Real, velocity0: Real = 0.0, omega0: Real = 1.0) -> Floats: ...
@overload
def sensitivities(
    t: Real | Stacked, theta0: Real | Stacked, velocity0: Real | Stacked = 0.0, omega0: Real | Stacked = 1.0
) -> Stacked: ...
@overload
def sensitivities(
    t: Real | Indexed, theta0: Real | Indexed, velocity0: Real | Indexed = 0.0, omega0: Real | Indexed = 1.0
) -> Floats: ...
@explained
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
    given = map(unindexed, (t, theta0, velocity0, omega0))
    return tensor(apply(_core.state_sensitivities, *given, results=6 * (SENSITIVITIES,)), FIRST)
