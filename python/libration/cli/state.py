"""What the commands of a pendulum share: the options of its initial state and frequency, and the Pendulum they give."""

import math
import re
from typing import TYPE_CHECKING

from libration.cli.help import Topic
from libration.cli.offers import units
from libration.cli.parser import Options, Refusal, Value, refusal
from libration.cli.quantities import ANGLE, FREQUENCY, GRAVITY, LENGTH, TIME, VELOCITY, Dimension, has_unit, quantity

if TYPE_CHECKING:
    from libration import Pendulum


def unit_list(dimension: Dimension) -> str:
    """The units of a dimension, the first of which is that of a number without one."""
    return ", ".join(dimension.units)


UNITS = Topic(
    "units",
    (
        ("angle", unit_list(ANGLE)),
        ("velocity", unit_list(VELOCITY)),
        ("time", unit_list(TIME)),
        ("length", unit_list(LENGTH)),
        ("gravity", unit_list(GRAVITY)),
        ("omega0", f"{unit_list(FREQUENCY)} (Hz times 2 pi)"),
    ),
    """\
A number without a unit is in the first: 3 is 3 rad. Write 25cm, "25 cm" or 2.5e-1m, with a decimal point. The value is
rounded to a double only once: 180deg is the double nearest to pi.""",
)

# The parameters that a message of Pendulum may name; each is an option after `--`.
NAMES = re.compile(r"(?<![\w-])(theta0|velocity0|omega0|length|gravity)\b")


class StateOptions(Options):
    """The options of the initial state and the frequency, as typed."""

    theta0: str | None
    velocity0: str | None
    length: str | None
    gravity: str | None
    omega0: str | None


def state_options(frequency: str) -> list[Value]:
    """The options of the state and the frequency; `frequency` says what happens without one."""
    group = "the pendulum"
    return [
        Value("--theta0", "ANGLE", "initial angle from the lowest point (required)", group, offered=units(ANGLE)),
        Value("--velocity0", "VELOCITY", "initial angular velocity (default 0)", group, offered=units(VELOCITY)),
        Value("--length", "LENGTH", f"length of the pendulum, positive {frequency}", group, offered=units(LENGTH)),
        Value(
            "--gravity",
            "GRAVITY",
            "acceleration of gravity, positive, with --length (default 9.80665 m/s2)",
            group,
            offered=units(GRAVITY),
        ),
        Value(
            "--omega0",
            "OMEGA0",
            "angular frequency of small swings, positive, instead of --length",
            group,
            offered=units(FREQUENCY),
        ),
    ]


def state(options: StateOptions) -> dict[str, float]:
    """The keyword arguments of Pendulum that the options give, as doubles in SI units."""
    if options.theta0 is None:
        raise Refusal("missing --theta0, the initial angle, such as --theta0 170deg")
    if options.length is not None and options.omega0 is not None:
        raise Refusal(f"--length = {options.length} and --omega0 = {options.omega0}: give one of the two")
    if options.gravity is not None and options.length is None:
        raise refusal("--gravity", options.gravity, "needs --length beside it; omega0 is sqrt(gravity / length)")
    given = {"theta0": quantity("--theta0", options.theta0, ANGLE), "velocity0": 0.0}
    if options.velocity0 is not None:
        given["velocity0"] = quantity("--velocity0", options.velocity0, VELOCITY)
    if options.length is not None:
        given["length"] = quantity("--length", options.length, LENGTH, above=0)
        given["gravity"] = 9.80665
    if options.gravity is not None:
        given["gravity"] = quantity("--gravity", options.gravity, GRAVITY, above=0)
    if options.omega0 is not None:
        given["omega0"] = quantity("--omega0", options.omega0, FREQUENCY, above=0)
    if options.velocity0 is not None and has_unit(options.velocity0) and not has_frequency(given):
        reason = "has a unit, but no frequency is given; add --length or --omega0, or give a multiple of omega0"
        raise refusal("--velocity0", options.velocity0, reason)
    return given


def has_frequency(given: dict[str, float]) -> bool:
    """Whether the options give a frequency; without one, times are in units of 1/omega0."""
    return "omega0" in given or "length" in given


def pendulum(given: dict[str, float]) -> "Pendulum":
    """The Pendulum, or a Refusal that names the option."""
    from libration import Pendulum

    try:
        motion = Pendulum(**given)
    except ValueError as error:
        raise Refusal(NAMES.sub(r"--\1", str(error))) from error
    if not math.isfinite(motion.omega0):
        reason = f"with --gravity = {given['gravity']:g} gives an infinite omega0"
        raise refusal("--length", f"{given['length']:g}", reason)
    return motion


def upright(motion: "Pendulum") -> bool:
    """Whether it starts at rest at the double nearest to an odd multiple of pi: upright, but for the rounding of pi."""
    halves = round(motion.theta0 / math.pi)
    return (
        motion.velocity0 == 0 and halves % 2 == 1 and abs(motion.theta0 - halves * math.pi) <= math.ulp(motion.theta0)
    )


def small_swing_period(given: dict[str, float]) -> float:
    """The period of small swings: that of the same pendulum at rest."""
    return pendulum(given | {"theta0": 0.0, "velocity0": 0.0}).period


def period_phase(given: dict[str, float], motion: "Pendulum") -> float:
    """The period times omega0; from rest it depends on the angle alone and is the period for omega0 = 1."""
    if given["velocity0"] == 0:
        return pendulum({"theta0": given["theta0"]}).period
    return motion.period * motion.omega0
