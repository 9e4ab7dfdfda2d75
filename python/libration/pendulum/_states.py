"""The operands by which a ufunc knows starts of orbits and frequencies: four of a start, three exact factors of omega0**2.

What is given is passed on as it is. The numbers of the kinds are those of `OrbitStart` in the core.
"""

from typing import Any

from .. import _core
from .._dispatch import apply

KNOWN = (
    "velocity",
    "energy_ratio",
    "energy_ratio_c",
    "energy",
    "theta_max",
    "theta_max_from_top",
    "period",
    "rotation",
)
NOTHING = {type(None)}
COUNTED = ("theta", "from_top", "bottom")
# Angle and velocity of a state, and of the start of a motion.
NOW = ("theta", "velocity")
INITIAL = ("theta0", "velocity0")


def kind(counted: str, known: str) -> float:
    """The number of a way to count the angle and of what is known beside it."""
    return 3.0 * KNOWN.index(known) + COUNTED.index(counted)


def only(given: dict[str, Any]) -> dict[str, Any]:
    """What is not None; a `ValueError` for more than one."""
    found = {name: value for name, value in given.items() if value is not None}
    if len(found) > 1:
        *others, last = given
        raise ValueError(f"at most one of {', '.join(others)} and {last} must be given, not {' and '.join(found)}")
    return found


def start(angles: dict[str, Any], motions: dict[str, Any], direction: Any) -> tuple[Any, Any, Any, float]:
    """The four operands of a start, of which at most one angle and one of velocity and energies is given."""
    known, value = next(iter(only(motions).items()), ("velocity", 0.0))
    known = known.removesuffix("0")
    place = only(angles)
    if not place and known == "velocity":
        angle, from_top = angles
        raise ValueError(f"{angle} must be given, or {from_top}; only beside an energy the bottom is meant")
    name, at = next(iter(place.items()), ("bottom", 0.0))
    counted = name if name == "bottom" else "from_top" if name.endswith("from_top") else "theta"
    return at, value, direction, kind(counted, known)


def plain(direction: Any, *others: Any) -> bool:
    """Whether a state is given by its angle, its velocity and omega0 alone."""
    return type(direction) is float and direction == 1.0 and NOTHING.issuperset(map(type, others))


def factors(omega0: Any, omega2: Any, length: Any, gravity: Any) -> Any:
    """The three factors of omega0**2."""
    only({"omega0": omega0, "omega2": omega2, "length": length})
    if length is not None:
        return apply(_core.factors_length, length, 9.80665 if gravity is None else gravity)
    if gravity is not None:
        raise ValueError("gravity must be given with a length")
    if omega2 is not None:
        return apply(_core.factors_omega2, omega2)
    return apply(_core.factors, 1.0 if omega0 is None else omega0)


def plain_state(theta: Any, velocity: Any, omega0: Any, direction: Any, *others: Any) -> tuple[Any, Any, Any] | None:
    """Angle, velocity and omega0, if a state is given by these alone."""
    if theta is None or not plain(direction, *others):
        return None
    return theta, 0.0 if velocity is None else velocity, 1.0 if omega0 is None else omega0


def orbit(
    names: tuple[str, str], angles: tuple[Any, Any], motions: tuple[Any, ...], direction: Any, *force: Any
) -> Any:
    """The seven operands of an orbit: four of its start, three of the force.

    `names` are those of angle and velocity. `angles` are the one from the bottom and the one from the top, `motions` the velocity and
    the three energies, `force` what is given of omega0, omega2, length and gravity.
    """
    theta, velocity = names
    places = dict(zip((theta, f"{theta}_from_top"), angles, strict=True))
    known = dict(zip((velocity, *KNOWN[1:4]), motions, strict=True))
    return *start(places, known, direction), *factors(*force)
