"""The parameters of a motion as (name, value, unit): the `#` lines of a table and the keys of a JSON object."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from libration.cli.files import Json, Parameter, key
from libration.cli.state import State

if TYPE_CHECKING:
    from libration import DampedPendulum, Pendulum

UNIT = {
    "theta0": "rad",
    "velocity0": "rad/s",
    "length": "m",
    "gravity": "m/s^2",
    "omega0": "rad/s",
    "omega2": "1/s^2",
    "period": "s",
    "theta_max": "rad",
    "energy": "rad^2/s^2",
}


def given_parameters(given: State, motion: "Pendulum | DampedPendulum") -> list[Parameter]:
    """What was given, and the frequency that follows from it."""
    values: list[Parameter] = [("angles", "from the top", "")] if given.from_top else []
    values += [("given", given.known, "")] if given.known else []
    # The angle and, where an energy is given, the velocity as the motion rounds it; what it found stands with the rest.
    start = {name: float(getattr(motion, name)) for name in ("theta0", "velocity0")} if given.known else {}
    numbers = {name: value for name, value in given.values.items() if name != given.known} | start
    values += [(name, numbers[name], unit) for name, unit in UNIT.items() if name in numbers]
    if "omega0" not in given.values:
        values.append(("omega0", float(motion.omega0), UNIT["omega0"]))
    return values


def found_parameters(motion: "Pendulum") -> list[Parameter]:
    """What the motion is: regime, period, turning angle, energy per unit inertia, energy ratio and its complement."""
    names = ("period", "theta_max", "energy", "energy_ratio", "energy_ratio_c")
    return [("regime", str(motion.regime), "")] + [
        (name, float(getattr(motion, name)), UNIT.get(name, "")) for name in names
    ]


def table_parameters(given: State, motion: "Pendulum") -> list[Parameter]:
    """The parameters written in a table."""
    from libration import __version__

    return [("libration", __version__, ""), *given_parameters(given, motion), *found_parameters(motion)]


def keyed(parameters: Iterable[Parameter]) -> dict[str, Json]:
    """The parameters as a dictionary whose keys end in the unit."""
    return {key(name, unit): value for name, value, unit in parameters}
