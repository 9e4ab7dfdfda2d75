"""What an orbit keeps, of arrays of states: period, turning angle, energy and its ratio to that of the top, regime.

The functions of a state and no time that need no phase; action, frequency and phase are in _action.py.
Source: DLMF 22.19(i); Landau & Lifshitz, Mechanics, section 11.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _core
from .._dispatch import Words, apply
from ._constants import Regime
from ._results import ENERGY, ENERGY_RATIO, ENERGY_RATIO_C, PERIOD, REGIME, THETA_MAX
from ._signatures import of_state, told
from ._states import NOW, orbit, plain_state

if TYPE_CHECKING:
    from ._signatures import RegimeOfState


@of_state
def period(
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
    """Period of pendulums in the states (theta, velocity).

    What `Pendulum.period` is, element by element: 2 pi/omega0 at rest, infinite on the separatrix, the time of one turn in rotation.

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
        Period in s. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 22.19(i), 19.8.5.

    Examples
    --------
    >>> import libration
    >>> libration.period(energy_ratio_c=[1e-17, -1e-17, 1e-20, -1e-20]).round(6)
    array([83.833071, 41.916535, 97.648581, 48.824291])
    """
    others = theta_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta, velocity, omega0, direction, *others):
        return apply(_core.period, *state, results=(PERIOD,), out=out, where=where)
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_period, *given, results=(PERIOD,), out=out, where=where)


@of_state
def theta_max(
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
    """Turning angle of pendulums in the states (theta, velocity), from the stable equilibrium.

    What `Pendulum.theta_max` is, element by element: pi on the separatrix, NaN in rotation.

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
        Turning angle in rad. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp. Source: 2 atan2 of kappa and sqrt(1 - kappa**2).

    Examples
    --------
    >>> import libration
    >>> libration.theta_max(0.0, [1.0, 2.0, 3.0]).round(6)
    array([1.047198, 3.141593,      nan])
    """
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_theta_max, *given, results=(THETA_MAX,), out=out, where=where)


@of_state
def energy_ratio(
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
    """Energy of pendulums over that at the top, kappa**2 = sin(theta/2)**2 + (velocity/(2 omega0))**2.

    What `Pendulum.energy_ratio` is, element by element; infinite in free rotation.

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
        kappa**2. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp. Source: Salas (23), where it is m.

    Examples
    --------
    >>> import libration
    >>> libration.energy_ratio(0.0, [0.0, 1.0, 3.0])
    array([0.  , 0.25, 2.25])
    """
    others = theta_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta, velocity, omega0, direction, *others):
        return apply(_core.energy_ratio, *state, results=(ENERGY_RATIO,), out=out, where=where)
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_energy_ratio, *given, results=(ENERGY_RATIO,), out=out, where=where)


@of_state
def energy_ratio_c(
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
    """Complement 1 - kappa**2 of the energy ratio, with all its digits next to the separatrix too.

    What `Pendulum.energy_ratio_c` is, element by element; minus infinity in free rotation.

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
        1 - kappa**2. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp plus 2**-150 of its condition. Source: (c - x)(c + x), c = cos(theta/2), x = velocity/(2 omega0).

    Examples
    --------
    >>> import libration
    >>> f"{libration.energy_ratio_c(theta_from_top=1e-17):.6e}"
    '2.500000e-35'
    """
    others = theta_from_top, energy_ratio, energy_ratio_c, energy, omega2, length, gravity
    if state := plain_state(theta, velocity, omega0, direction, *others):
        return apply(_core.energy_ratio_c, *state, results=(ENERGY_RATIO_C,), out=out, where=where)
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_energy_ratio_c, *given, results=(ENERGY_RATIO_C,), out=out, where=where)


@of_state
def energy(
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
    """Energy per unit inertia of pendulums in the states (theta, velocity), 0 at the stable equilibrium.

    What `Pendulum.energy` is, element by element: velocity**2/2 + omega0**2 (1 - cos(theta)).

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
        Energy in rad**2/s**2. A bad element gives NaN there and nowhere else.

    Notes
    -----
    Error promised: 4 ulp. Source: Lima (4), divided by the inertia.

    Examples
    --------
    >>> import libration
    >>> libration.energy([0.0, 1.0], [2.0, 0.0], length=9.80665).round(6)
    array([2.      , 0.459698])
    """
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_core.orbit_energy, *given, results=(ENERGY,), out=out, where=where)


_WORDS = Words(_core.orbit_regime, [regime.value for regime in Regime])


def _of_regime(function: Any) -> RegimeOfState:
    """Declare a function of a state whose values are words."""
    return told(function)  # type: ignore[no-any-return]


@_of_regime
def regime(
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
) -> Any:
    """Kind of motion of pendulums in the states (theta, velocity), as words.

    What `Pendulum.regime` is, element by element: ``"rest"``, ``"libration"``, ``"separatrix"`` or ``"rotation"``, decided
    without error for the doubles passed.

    Parameters
    ----------
    <state>

    Returns
    -------
    str or array of the broadcast shape
        The word; empty where an element is bad.

    Examples
    --------
    >>> import libration
    >>> print(*libration.regime(energy_ratio_c=[1.0, 1e-20, 0.0, -1e-20]))
    rest libration separatrix rotation
    """
    angles, motions = (theta, theta_from_top), (velocity, energy_ratio, energy_ratio_c, energy)
    given = orbit(NOW, angles, motions, direction, omega0, omega2, length, gravity)
    return apply(_WORDS, *given, results=(REGIME,))
