"""What the commands of a pendulum share: the options of its initial state and frequency, and the Pendulum they give."""

import math
import re
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import click

from libration.cli.help import Topic
from libration.cli.offers import units
from libration.cli.parser import Flag, Options, Refusal, Value, refusal, shown
from libration.cli.quantities import (
    ANGLE,
    FREQUENCY,
    GRAVITY,
    LENGTH,
    ONE,
    TIME,
    VELOCITY,
    Dimension,
    has_unit,
    quantity,
)

if TYPE_CHECKING:
    from libration import Pendulum

OMEGA2 = Dimension("squares of angular frequencies", {"1/s2": ONE, "rad2/s2": ONE}, {})
# The parameters that a message of Pendulum may name; each is an option after `--`.
NAMES = re.compile(r"(?<![\w-])(theta0|velocity0|omega0|omega2|length|gravity)\b")
FREQUENCIES = ("length", "omega0", "omega2")


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
        ("omega2", unit_list(OMEGA2)),
    ),
    """\
A number without a unit is in the first: 3 is 3 rad. Write 25cm, "25 cm", 2.5e-1m or 0,25m, and 150deg or 150°. The
value is rounded to a double only once: 180deg is the double nearest to pi.""",
)


class StateOptions(Options):
    """The options of the initial state and the frequency, as typed."""

    theta0: str | None
    velocity0: str | None
    length: str | None
    gravity: str | None
    omega0: str | None
    omega2: str | None
    from_top: bool


def state_options(frequency: str, angle: str = "initial angle from the lowest point (required)") -> list[click.Option]:
    """The options of the state and the frequency; `frequency` says what happens without one."""
    group = "the pendulum"
    gravity = "acceleration of gravity, positive, with --length (default 9.80665 m/s2)"
    omega2 = "its square instead, of any sign; below 0 the angle is from the top, at 0 there is no force"
    return [
        Value("--theta0", "ANGLE", angle, group, offered=units(ANGLE)),
        Value("--velocity0", "VELOCITY", "initial angular velocity (default 0)", group, offered=units(VELOCITY)),
        Flag("--from-top", "count all angles from the upright position", group),
        Value("--length", "LENGTH", f"length of the pendulum, positive {frequency}", group, offered=units(LENGTH)),
        Value("--gravity", "GRAVITY", gravity, group, offered=units(GRAVITY)),
        Value(
            "--omega0",
            "OMEGA0",
            "angular frequency of small swings, positive, instead of --length",
            group,
            offered=units(FREQUENCY),
        ),
        Value("--omega2", "OMEGA2", omega2, group, offered=units(OMEGA2)),
    ]


@dataclass(frozen=True)
class State:
    """The initial state and the frequency as given, as doubles in SI units, by the names of the options."""

    values: dict[str, float]
    from_top: bool

    @property
    def has_frequency(self) -> bool:
        """Whether a frequency is given; without one, times are in units of 1/omega0."""
        return any(name in self.values for name in FREQUENCIES)

    @property
    def arguments(self) -> dict[str, float]:
        """The keyword arguments of Pendulum; from the top, the pendulum is one whose omega2 is below 0."""
        if not self.from_top:
            return self.values
        square = self.squared
        named = next((name for name in ("length", "omega0") if name in self.values), None)
        if named and not sys.float_info.min <= square <= sys.float_info.max:
            reason = "with --from-top gives a square of omega0 that is beyond the doubles"
            raise refusal(f"--{named}", f"{self.values[named]:g}", reason)
        kept = {name: self.values[name] for name in ("theta0", "velocity0")}
        return kept | {"omega2": -square}

    @property
    def squared(self) -> float:
        """The square of the angular frequency of small swings; 1 if none is given."""
        if "length" in self.values:
            return self.values["gravity"] / self.values["length"]
        omega0 = self.values.get("omega0", 1.0)
        return self.values.get("omega2", omega0 * omega0)

    def at(self, theta0: float) -> "State":
        """The same with another initial angle."""
        return State(self.values | {"theta0": theta0}, self.from_top)

    def with_frequency(self, omega0: float) -> "State":
        """The same with a frequency, if none is given."""
        return self if self.has_frequency else State(self.values | {"omega0": omega0}, self.from_top)


def state(options: StateOptions) -> State:
    """The state that the options give, or a Refusal."""
    if options.theta0 is None:
        raise missing_angle()
    return State({"theta0": quantity("--theta0", options.theta0, ANGLE), **others(options)}, options.from_top)


def missing_angle() -> Refusal:
    """The refusal of a state without an angle."""
    return Refusal("missing --theta0, the initial angle, such as --theta0 170deg")


def others(options: StateOptions) -> dict[str, float]:
    """The velocity and the frequency that the options give, or a Refusal."""
    typed = {name: getattr(options, name) for name in FREQUENCIES if getattr(options, name) is not None}
    if len(typed) > 1:
        (first, a), (second, b) = list(typed.items())[:2]
        raise Refusal(f"--{first} = {shown(a)} and --{second} = {shown(b)}: give one of the two")
    if options.gravity is not None and options.length is None:
        raise refusal("--gravity", options.gravity, "needs --length beside it; omega0 is sqrt(gravity / length)")
    given = {"velocity0": 0.0}
    if options.velocity0 is not None:
        given["velocity0"] = quantity("--velocity0", options.velocity0, VELOCITY)
    if options.length is not None:
        given["length"] = quantity("--length", options.length, LENGTH, above=0)
        given["gravity"] = 9.80665
    if options.gravity is not None:
        given["gravity"] = quantity("--gravity", options.gravity, GRAVITY, above=0)
    if options.omega0 is not None:
        given["omega0"] = quantity("--omega0", options.omega0, FREQUENCY, above=0)
    if options.omega2 is not None:
        given["omega2"] = quantity("--omega2", options.omega2, OMEGA2)
        if options.from_top and given["omega2"] < 0:
            reason = "below 0 counts the angle from the top already; leave out --from-top, or the sign"
            raise refusal("--omega2", options.omega2, reason)
    if options.velocity0 is not None and has_unit(options.velocity0) and not typed:
        reason = "has a unit, but no frequency is given; add --length or --omega0, or give a multiple of omega0"
        raise refusal("--velocity0", options.velocity0, reason)
    return given


def pendulum(given: State) -> "Pendulum":
    """The Pendulum, or a Refusal that names the option."""
    return made(given.arguments, given.values)


def made(arguments: dict[str, float], values: dict[str, float]) -> "Pendulum":
    """The Pendulum of these arguments, or a Refusal that names the option; `values` are those given."""
    from libration import Pendulum

    try:
        motion = Pendulum(**arguments)
    except ValueError as error:
        raise Refusal(NAMES.sub(r"--\1", str(error))) from error
    if not math.isfinite(motion.omega0):
        reason = f"with --gravity = {values['gravity']:g} gives an infinite omega0"
        raise refusal("--length", f"{values['length']:g}", reason)
    return motion


def upright(motion: "Pendulum") -> bool:
    """Whether it starts at rest at the double nearest to the top, but for the rounding of pi."""
    halves = round(motion.theta0 / math.pi)
    at_top = halves % 2 == (1 if motion.omega2 > 0 else 0)
    return motion.velocity0 == 0 and at_top and abs(motion.theta0 - halves * math.pi) <= math.ulp(motion.theta0)


def small_swing_period(given: State) -> float:
    """The period of small swings: that of the same pendulum at rest; infinite without a force."""
    frequency = {name: given.values[name] for name in (*FREQUENCIES, "gravity") if name in given.values}
    if "omega2" in frequency:
        frequency["omega2"] = abs(frequency["omega2"])
    return made({"theta0": 0.0, **frequency}, given.values).period


def period_phase(given: State, motion: "Pendulum") -> float:
    """The period times omega0; from rest it depends on the angle alone and is the period for omega0 = 1."""
    if given.values["velocity0"] == 0 and motion.omega2 != 0:
        return made({"theta0": given.values["theta0"], "omega2": math.copysign(1.0, motion.omega2)}, {}).period
    return motion.period * motion.omega0
