"""The parameters of a motion as (name, value, unit): the `#` lines of a table and the keys of a JSON object."""

from libration.cli.files import key

UNIT = {
    "theta0": "rad",
    "velocity0": "rad/s",
    "length": "m",
    "gravity": "m/s^2",
    "omega0": "rad/s",
    "period": "s",
    "theta_max": "rad",
    "energy": "rad^2/s^2",
}


def given_parameters(given, motion):
    """What was given, and the frequency that follows from it."""
    names = [name for name in UNIT if name in given]
    values = [(name, given[name], UNIT[name]) for name in names]
    return values + [("omega0", float(motion.omega0), UNIT["omega0"])] * ("omega0" not in given)


def found_parameters(motion):
    """What the motion is: regime, period, turning angle, energy per unit inertia, energy ratio and its complement."""
    names = ("period", "theta_max", "energy", "energy_ratio", "energy_ratio_c")
    return [("regime", str(motion.regime), "")] + [
        (name, float(getattr(motion, name)), UNIT.get(name, "")) for name in names
    ]


def table_parameters(given, motion):
    """The parameters that a table carries."""
    from libration import __version__

    return [("libration", __version__, ""), *given_parameters(given, motion), *found_parameters(motion)]


def keyed(parameters):
    """The parameters as a dictionary whose keys end in the unit."""
    return {key(name, unit): value for name, value, unit in parameters}
