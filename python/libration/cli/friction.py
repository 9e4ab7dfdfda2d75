"""Friction and torque as typed: their options, units, and the DampedPendulum that they give with a state."""

import re
from dataclasses import dataclass
from decimal import Decimal
from typing import TYPE_CHECKING, Any

import click

from libration.cli.files import Parameter
from libration.cli.help import Topic
from libration.cli.offers import files, units
from libration.cli.parser import Options, Refusal, Value, refusal, shown
from libration.cli.quantities import ANGLE, DEGREE, FREQUENCY, LONG, ONE, Dimension, names, quantity
from libration.cli.state import State, pendulum, unit_list
from libration.cli.times import INSTANTS, ColumnKind, TextFile, file_column

if TYPE_CHECKING:
    from libration import DampedPendulum, Friction, Torque

MINUTE = LONG.divide(ONE, Decimal(60))
DECAY = Dimension(
    "rates",
    {"/s": ONE, "/min": MINUTE},
    names(ONE, "1/s", "s-1") | names(MINUTE, "1/min", "min-1") | names(LONG.divide(ONE, Decimal(3600)), "1/h", "/h"),
)
PER_DEGREE = LONG.divide(ONE, DEGREE)
QUADRATIC = Dimension(
    "quadratic frictions",
    {"/rad": ONE, "/deg": PER_DEGREE},
    names(ONE, "1/rad", "rad-1") | names(PER_DEGREE, "1/deg", "/°"),
)
TORQUE = Dimension(
    "torques over inertia", {"rad/s2": ONE, "deg/s2": DEGREE}, names(ONE, "1/s2", "/s2", "s-2") | names(DEGREE, "°/s2")
)
TORQUES = ColumnKind("torques", ("torque", "tau", "\N{GREEK SMALL LETTER TAU}"), 1, TORQUE)
# The arguments of Friction and Torque, each with its option and its unit.
FRICTION = {"linear": "1/s", "quadratic": "1/rad", "dry": "rad/s^2", "presliding": "rad"}
DRIVE = {
    "constant": ("torque", "rad/s^2"),
    "amplitude": ("torque-amplitude", "rad/s^2"),
    "frequency": ("torque-frequency", "rad/s"),
    "phase": ("torque-phase", "rad"),
}

FORCES = Topic(
    "friction and torque",
    (
        ("linear", unit_list(DECAY)),
        ("quadratic", unit_list(QUADRATIC)),
        ("dry, torque", unit_list(TORQUE)),
    ),
    """\
theta'' + 2 linear theta' + quadratic |theta'| theta' + dry sgn(theta') + omega0^2 sin(theta) = torque(t), all per unit
inertia. Small swings decay as e^(-linear t). With --presliding dry friction changes sign over that angle after a turn, not
at once. The torque is --torque + amplitude cos(frequency t + phase), plus that of --torque-file: straight lines between its
rows, outside of which there is no motion.
""",
)


class ForceOptions(Options):
    """The options of friction and torque, as typed."""

    linear: str | None
    quadratic: str | None
    dry: str | None
    presliding: str | None
    torque: str | None
    torque_amplitude: str | None
    torque_frequency: str | None
    torque_phase: str | None
    torque_file: str | None


def force_options() -> list[click.Option]:
    """The options of friction and torque."""
    group = "friction and torque, over the inertia"
    return [
        Value("--linear", "RATE", "linear friction: 0.02/s", group, offered=units(DECAY)),
        Value("--quadratic", "BETA", "friction with the square of the velocity", group, offered=units(QUADRATIC)),
        Value("--dry", "TORQUE", "dry friction, which stops the pendulum", group, offered=units(TORQUE)),
        Value("--presliding", "ANGLE", "angle over which dry friction changes sign", group, offered=units(ANGLE)),
        Value("--torque", "TORQUE", "constant torque", group, offered=units(TORQUE)),
        Value("--torque-amplitude", "TORQUE", "that of a sinusoidal torque", group, offered=units(TORQUE)),
        Value("--torque-frequency", "FREQUENCY", "its angular frequency, or in Hz", group, offered=units(FREQUENCY)),
        Value("--torque-phase", "ANGLE", "its phase at t = 0 (default 0: a cosine)", group, offered=units(ANGLE)),
        Value("--torque-file", "FILE", "a torque over time from the columns t and torque", group, offered=files),
    ]


@dataclass(frozen=True)
class Forces:
    """Friction and torque as given, and the file that a torque is read from."""

    friction: "Friction"
    torque: "Torque"
    parameters: list[Parameter]
    file: str | None

    @property
    def kept(self) -> list[str]:
        """The files that are read."""
        return [] if self.file is None else [self.file]


def forces(options: ForceOptions) -> Forces | None:
    """Friction and torque, None where no option asks for one, or a Refusal."""
    typed = {name: getattr(options, name) for name in ForceOptions.__annotations__}
    given = {name: text for name, text in typed.items() if text is not None}
    if not given:
        return None
    check_together(options)
    dimensions = {"linear": DECAY, "quadratic": QUADRATIC, "dry": TORQUE, "presliding": ANGLE}
    friction = {name: quantity(f"--{name}", given[name], dimensions[name]) for name in FRICTION if name in given}
    drive: dict[str, Any] = {}
    kinds = {"constant": TORQUE, "amplitude": TORQUE, "frequency": FREQUENCY, "phase": ANGLE}
    for name, (option, _) in DRIVE.items():
        if (text := given.get(option.replace("-", "_"))) is not None:
            drive[name] = quantity(f"--{option}", text, kinds[name])
    parameters: list[Parameter] = [(name, value, FRICTION[name]) for name, value in friction.items()]
    parameters += [(DRIVE[name][0].replace("-", "_"), value, DRIVE[name][1]) for name, value in drive.items()]
    from libration import Friction, Torque

    samples = None
    if options.torque_file is not None:
        file = TextFile("--torque-file", options.torque_file)
        samples = file_column(file, None, INSTANTS)[0], file_column(file, None, TORQUES)[0]
        parameters.append(("torque_file", options.torque_file, ""))
    try:
        return Forces(Friction(**friction), Torque(**drive, samples=samples), parameters, options.torque_file)
    except ValueError as error:
        raise named(error, options) from error


def check_together(options: ForceOptions) -> None:
    """Refuse an option whose companion is missing."""
    if options.presliding is not None and options.dry is None:
        raise refusal("--presliding", options.presliding, "needs --dry beside it, the friction that it belongs to")
    if options.torque_amplitude is not None and options.torque_frequency is None:
        reason = "needs --torque-frequency beside it, such as 0.5Hz; a constant torque is --torque"
        raise refusal("--torque-amplitude", options.torque_amplitude, reason)
    for option, text in (("--torque-frequency", options.torque_frequency), ("--torque-phase", options.torque_phase)):
        if text is not None and options.torque_amplitude is None:
            raise refusal(option, text, "needs --torque-amplitude beside it")


def named(error: ValueError, options: ForceOptions) -> Refusal:
    """What the package refuses, with the name of the option."""
    text = str(error)
    option = {name: option for name, (option, _) in DRIVE.items()} | dict(zip(FRICTION, FRICTION, strict=True))
    if found := re.match(rf"({'|'.join(option)})\b", text):
        return Refusal(f"--{option[found[1]]}{text[found.end() :]}")
    return Refusal(f"--torque-file = {shown(options.torque_file)}: {text}")


def start(given: State) -> dict[str, float]:
    """The keyword arguments of DampedPendulum; an energy is that at the start, and its velocity is rounded."""
    if not given.known:
        return given.arguments
    motion = pendulum(given)
    return {**given.arguments, "theta0": motion.theta0, "velocity0": motion.velocity0}


def damped(given: State, acting: Forces, options: ForceOptions) -> "DampedPendulum":
    """The pendulum with friction and torque, or a Refusal that names the option."""
    from libration import DampedPendulum

    # Refuses what no pendulum has.
    pendulum(given)
    try:
        return DampedPendulum(**start(given), friction=acting.friction, torque=acting.torque)
    except ValueError as error:
        raise named(error, options) from error
