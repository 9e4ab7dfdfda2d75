"""How angle and velocity change with the start and the force: the exact derivatives, of arrays of states."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _core
from .._dispatch import apply, tensor, unindexed
from ._motion import _one_orbit
from ._results import SENSITIVITIES
from ._signatures import told
from ._states import INITIAL, orbit, plain_state

if TYPE_CHECKING:
    from ._signatures import MatricesOfTime

BY = ("theta0", "velocity0", "omega0")
FIRST = {"of": ("theta", "velocity"), "by": BY}
SECOND = {**FIRST, "and_by": BY}
# Where each of a symmetric matrix's nine elements stands among its six different ones.
SYMMETRIC = (0, 1, 2, 1, 3, 4, 2, 4, 5)


def _of_matrices(function: Any) -> MatricesOfTime:
    """Declare a function of a time and an initial state that gives a matrix."""
    return told(function)  # type: ignore[no-any-return]


@_of_matrices
def sensitivities(
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
    """Derivatives of the state a time `t` after (theta0, velocity0), by theta0, velocity0 and omega0.

    What `Pendulum.sensitivities` is, element by element. ``sensitivities(dt, theta, velocity, omega0)[..., :2]`` is the
    Jacobian matrix of `advance`; its determinant is 1.

    Parameters
    ----------
    t : scalar or array
        Time in s; not finite, and more than 2**53 half periods away, gives NaN.
    <start>

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
    others = theta0_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta0, velocity0, omega0, direction, *others):
        if not _one_orbit(*state):
            found = apply(_core.state_sensitivities, *map(unindexed, (t, *state)), results=6 * (SENSITIVITIES,))
            return tensor(found, FIRST)
        given: Any = (*state[:2], 1.0, 0.0, *apply(_core.factors, state[2]))
        return tensor(apply(_core.orbit_sensitivities, unindexed(t), *given, results=6 * (SENSITIVITIES,)), FIRST)
    angles, motions = (theta0, theta0_from_top), (velocity0, energy_ratio, energy_ratio_c, energy)
    given = map(unindexed, orbit(INITIAL, angles, motions, direction, omega0, omega2, length, gravity))
    return tensor(apply(_core.orbit_sensitivities, unindexed(t), *given, results=6 * (SENSITIVITIES,)), FIRST)
