"""What the commands of a pendulum share: the options of its initial state and frequency, and the Pendulum they give."""

import math
import re
import sys
from dataclasses import dataclass, replace
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
    NUMBERS,
    ONE,
    TIME,
    VELOCITY,
    Dimension,
    has_unit,
    plain,
    quantity,
)

if TYPE_CHECKING:
    from libration import Pendulum

OMEGA2 = Dimension("squares of angular frequencies", {"1/s2": ONE, "rad2/s2": ONE}, {})
# The parameters that a message of Pendulum may name; each is an option after `--`.
NAMES = re.compile(r"(?<![\w-])(theta0|velocity0|omega0|omega2|length|gravity)\b")
FREQUENCIES = ("length", "omega0", "omega2")
ENERGY = Dimension("energies per unit inertia", {"rad2/s2": ONE, "1/s2": ONE}, {})
# The options that say the energy, each instead of a velocity, with their dimensions.
ENERGIES = {
    "energy_ratio": NUMBERS,
    "energy_ratio_c": NUMBERS,
    "energy": ENERGY,
    "turning_angle": ANGLE,
    "period": TIME,
}
# What Pendulum's methods call them, at the start of a refusal.
REFUSED = re.compile(r"(energy_ratio_c|energy_ratio|energy|theta_max_from_top|theta_max|period)(?= = )")


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
        ("energy", unit_list(ENERGY)),
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
    energy_ratio: str | None
    energy_ratio_c: str | None
    energy: str | None
    turning_angle: str | None
    period: str | None
    rotation: bool
    downwards: bool


def state_options(
    frequency: str, angle: str = "initial angle from the lowest point (required beside a velocity)"
) -> list[click.Option]:
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
        *energy_options(),
    ]


def energy_options() -> list[click.Option]:
    """The options that say the energy instead of a velocity."""
    group = "the energy, instead of --velocity0"
    period = "time of a full swing, at least that of small ones, or with --rotation of a turn"
    return [
        Value("--energy-ratio", "NUMBER", "energy over that at the top: below 1 it swings, above it turns", group),
        Value("--energy-ratio-c", "NUMBER", "1 less that ratio, with all its digits next to the top", group),
        Value("--energy", "ENERGY", "per unit inertia, 0 at the lowest point", group, offered=units(ENERGY)),
        Value("--turning-angle", "ANGLE", "angle at which it turns back", group, offered=units(ANGLE)),
        Value("--period", "TIME", period, group, offered=units(TIME)),
        Flag("--rotation", "--period is that of a turn", group),
        Flag("--downwards", "begin downwards; without --theta0 it begins at the lowest point", group),
    ]


@dataclass(frozen=True)
class State:
    """The initial state and the frequency as given, as doubles in SI units, by the names of the options."""

    values: dict[str, float]
    from_top: bool
    # The option that says the energy, "" where the velocity is given, and what belongs to it.
    known: str = ""
    rotation: bool = False
    downwards: bool = False

    @property
    def has_frequency(self) -> bool:
        """Whether a frequency is given; without one, times are in units of 1/omega0."""
        return any(name in self.values for name in FREQUENCIES)

    @property
    def arguments(self) -> dict[str, float]:
        """The keyword arguments of Pendulum; from the top, the pendulum is one whose omega2 is below 0."""
        values = {name: value for name, value in self.values.items() if name not in ENERGIES}
        if not self.from_top:
            return values
        square = self.squared
        named = next((name for name in ("length", "omega0") if name in self.values), None)
        if named and not sys.float_info.min <= square <= sys.float_info.max:
            reason = "with --from-top gives a square of omega0 that is beyond the doubles"
            raise refusal(f"--{named}", f"{self.values[named]:g}", reason)
        kept = {name: values[name] for name in ("theta0", "velocity0") if name in values}
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
        return replace(self, values=self.values | {"theta0": theta0})

    def with_frequency(self, omega0: float) -> "State":
        """The same with a frequency, if none is given."""
        return self if self.has_frequency else replace(self, values=self.values | {"omega0": omega0})


def state(options: StateOptions) -> State:
    """The state that the options give, or a Refusal."""
    known = known_energy(options)
    if options.theta0 is None and not known:
        raise missing_angle()
    angle = {} if options.theta0 is None else {"theta0": quantity("--theta0", options.theta0, ANGLE)}
    return with_energy(options, {**angle, **others(options)}, known)


def with_energy(options: StateOptions, values: dict[str, float], known: str) -> State:
    """The state of these values and of the energy that the options say, if they do."""
    if not known:
        for flag in ("rotation", "downwards"):
            if getattr(options, flag):
                raise Refusal(
                    f"--{flag}: needs an energy beside it, such as --{'period' if flag == 'rotation' else 'energy'}"
                )
        return State(values, options.from_top)
    text = getattr(options, known)
    if options.rotation and known != "period":
        raise Refusal("--rotation: needs --period beside it, the time of a turn")
    if known == "period" and not any(name in values for name in FREQUENCIES):
        raise refusal("--period", text, "needs --length or --omega0 beside it")
    if known == "energy" and has_unit(text) and not any(name in values for name in FREQUENCIES):
        raise refusal("--energy", text, "has a unit, but no frequency is given; add --length or --omega0")
    read = plain(option(known), text) if ENERGIES[known] is NUMBERS else quantity(option(known), text, ENERGIES[known])
    values = {**values, known: read}
    del values["velocity0"]
    return State(values, options.from_top, known, options.rotation, options.downwards)


def option(name: str) -> str:
    """The option of a name."""
    return f"--{name.replace('_', '-')}"


def known_energy(options: StateOptions) -> str:
    """The name of the option that says the energy, "" for none, or a Refusal of two, or of one beside a velocity."""
    names = [name for name in (*ENERGIES, "velocity0") if getattr(options, name) is not None]
    if len(names) > 1:
        first, second = names[:2]
        a, b = (f"{option(name)} = {shown(getattr(options, name))}" for name in (first, second))
        raise Refusal(f"{a} and {b}: give one of the two")
    return names[0] if names and names[0] in ENERGIES else ""


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
    if not given.known:
        return made(given.arguments, given.values)
    from libration import Pendulum

    value, arguments = given.values[given.known], given.arguments
    sense = {"direction": -1} if given.downwards else {}
    try:
        if given.known == "turning_angle":
            name = "theta_max_from_top" if given.from_top else "theta_max"
            motion = Pendulum.from_turning_angle(**{name: value}, **arguments, **sense)
        elif given.known == "period":
            regime = "rotation" if given.rotation else "libration"
            motion = Pendulum.from_period(value, regime=regime, **arguments, **sense)
        else:
            motion = Pendulum.from_energy(**{given.known: value}, **arguments, **sense)
    except ValueError as error:
        raise Refusal(named(str(error), given.known)) from error
    return checked(motion, given.values)


def named(text: str, known: str = "") -> str:
    """A refusal of Pendulum with the options in the place of the arguments."""
    return NAMES.sub(r"--\1", REFUSED.sub(option(known), text, count=1) if REFUSED.match(text) else text)


def made(arguments: dict[str, float], values: dict[str, float]) -> "Pendulum":
    """The Pendulum of these arguments, or a Refusal that names the option; `values` are those given."""
    from libration import Pendulum

    try:
        return checked(Pendulum(**arguments), values)
    except ValueError as error:
        raise Refusal(named(str(error))) from error


def checked(motion: "Pendulum", values: dict[str, float]) -> "Pendulum":
    """The Pendulum, if its frequency is finite, else a Refusal."""
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
    if given.values.get("velocity0") == 0 and motion.omega2 != 0:
        return made({"theta0": given.values["theta0"], "omega2": math.copysign(1.0, motion.omega2)}, {}).period
    return motion.period * motion.omega0
