"""`libration at`: the angle and the velocity at one instant, or at a few."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from libration.cli.damped import NOT_REACHED, undamped, version
from libration.cli.files import STANDARD_OUTPUT, Column, Parameter, staged_table, strict, write_table
from libration.cli.friction import FORCES, ForceOptions, damped, force_options, forces
from libration.cli.help import Topic
from libration.cli.language import say
from libration.cli.offers import units
from libration.cli.parameters import given_parameters, keyed, table_parameters
from libration.cli.parser import Refusal, Value, Word, command, refusal, shown
from libration.cli.quantities import ANGLE, TIME, quantities, quantity
from libration.cli.results import OutOptions, check_printed, out_options, written
from libration.cli.sampling import nans
from libration.cli.state import UNITS, State, StateOptions, pendulum, state, state_options
from libration.cli.style import NumberStyle, StyleOptions, number_style, style_options
from libration.cli.summary import print_lines, print_table

if TYPE_CHECKING:
    from libration import DampedPendulum, Pendulum
    from libration._arrays import Floats

DESCRIPTION = """\
The exact angle and angular velocity of a pendulum at one instant after the start, or at several, in radians and in
degrees. Where it turns over the top, the whole turns follow with the rest of the angle."""
TOPICS = (
    UNITS,
    FORCES,
    Topic(
        "results",
        text="""\
Several instants are a table, as is --out. The angle grows beyond a turn; "turns" and "angle" are the whole turns and
the rest, between -180 and 180 deg. With --json: one object, with an object for each instant in "instants"; null stands
for a value that is not known, more than 2^53 half periods away. With friction or a torque "undamped_regime" is that
without them.""",
    ),
)
EXAMPLES = (
    "libration at 7.3s --theta0 150deg --length 1m",
    "libration at 1s,2s,1min --theta0 0 --velocity0 400deg/s --omega0 0.5Hz --digits 5",
    "libration at 1min --theta0 150deg --length 1m --linear 0.02/s --quadratic 0.01",
    "libration at --crossing 90deg --theta0 1e-17 --from-top --omega2 73.5 --digits 17",
)
DIGITS = 10
TOO_LARGE = "the angle is too large"
TOO_FAR = "it is more than 2^53 half periods away"


class AtOptions(StateOptions, ForceOptions, StyleOptions, OutOptions):
    """The options of `libration at`."""

    times: str | None
    crossing: str | None


def run(options: AtOptions) -> None:
    """Print the angle and the velocity at the instants that the words give."""
    if options.times is None and options.crossing is None:
        raise Refusal("missing TIME, the instant, such as libration at 7.3s --theta0 150deg --length 1m")
    if options.times is not None and options.crossing is not None:
        raise Refusal(f"TIME = {shown(options.times)} and --crossing = {shown(options.crossing)}: give one of the two")
    given = state(options)
    if not given.has_frequency:
        raise Refusal("missing --length or --omega0, such as --length 1m")
    check_printed(options)
    style, acting = number_style(options), forces(options)
    if options.times is not None:
        instants = quantities("TIME", options.times, TIME)
    elif acting is not None:
        raise refusal("--crossing", options.crossing, "is for a motion without friction and torque; give TIME")
    motion = pendulum(given) if acting is None else damped(given, acting, options)
    if options.crossing is not None and isinstance(motion, exact_kind()):
        instants = [first_crossing(motion, options.crossing)]
    known = [] if acting is None else [*acting.parameters, *undamped(given)]
    if options.out is not None:
        with staged_table(options.out, keep=[] if acting is None else acting.kept) as file:
            columns = motion_columns(motion, instants)
            write_table(file, options.out, parameters(given, motion, known), columns, style)
    else:
        columns = motion_columns(motion, instants)
    if options.json:
        answer = keyed([*given_parameters(given, motion), *known])
        if isinstance(motion, exact_kind()):
            answer["regime"] = str(motion.regime)
        answer["instants"] = [keyed(row) for row in instants_of(columns)]
        answer["files"] = written(options.out)
        print(strict(answer))
    elif options.out != STANDARD_OUTPUT:
        why = TOO_FAR if acting is None else NOT_REACHED
        print_one(columns, style, why) if len(instants) == 1 else print_several(columns, style, why)
        print_lines([("written", path) for path in written(options.out)])


def first_crossing(motion: "Pendulum", text: str) -> float:
    """The first instant at which the angle is passed, or a Refusal."""
    from libration import _core

    instant = float(_core.orbit_next_crossing(quantity("--crossing", text, ANGLE), 0.0, *motion._operands))
    if math.isnan(instant):
        raise refusal("--crossing", text, "is an angle that the motion does not pass from t = 0 on")
    return instant


def exact_kind() -> "type[Pendulum]":
    """The class of a motion without friction and torque."""
    from libration import Pendulum

    return Pendulum


def parameters(given: State, motion: "Pendulum | DampedPendulum", known: list[Parameter]) -> list[Parameter]:
    """The parameters written in a table."""
    if isinstance(motion, exact_kind()):
        return table_parameters(given, motion)
    return [("libration", version(), ""), *given_parameters(given, motion), *known]


def motion_columns(motion: "Pendulum | DampedPendulum", instants: Sequence[float]) -> list[Column]:
    """The time, the angle and the velocity, each in radians and degrees; beyond the top also the turns and the rest."""
    import numpy as np

    t = np.array(instants)
    theta, velocity = motion.motion(t)
    found: list[Column] = [
        ("t", "s", t),
        ("theta", "rad", theta),
        ("theta", "deg", degrees(theta)),
        ("velocity", "rad/s", velocity),
        ("velocity", "deg/s", degrees(velocity)),
    ]
    if isinstance(motion, exact_kind()):
        turns_over = motion.regime == "rotation"
    else:
        turns_over = bool(
            np.abs(theta - (math.pi if motion.omega2 < 0 else 0.0)).max(initial=0.0, where=theta == theta) > math.pi
        )
    if turns_over:
        turns, angle = motion.turns(t)
        whole = np.where(np.isnan(angle), np.nan, turns)
        found += [("turns", "", whole), ("angle", "rad", angle), ("angle", "deg", degrees(angle))]
    return found


def degrees(radians: "Floats") -> "Floats":
    """The same in degrees."""
    import numpy as np

    with np.errstate(over="ignore"):
        turned: Floats = np.degrees(radians)
    return turned


def instants_of(columns: Sequence[Column]) -> list[list[tuple[str, float, str]]]:
    """The rows of the columns, with names and units."""
    count = len(columns[0][2])
    return [[(name, float(values[row]), unit) for name, unit, values in columns] for row in range(count)]


def print_one(columns: Sequence[Column], style: NumberStyle, why: str) -> None:
    """One instant in aligned lines; `why` says why it may not be known."""
    if nans(columns[1][2]):
        print_lines([("t", f"{style.shown(float(columns[0][2][0]), DIGITS)} s"), ("theta", f"not known, {why}")])
        return
    shown: dict[str, list[str]] = {}
    for name, unit, values in columns:
        shown.setdefault(name, []).append(f"{style.shown(float(values[0]), DIGITS)} {unit}".rstrip())
    if "turns" in shown:
        angle = " = ".join(shown.pop("angle"))
        unknown = nans(columns[5][2])
        shown["turns"] = [f"not known, {TOO_LARGE}" if unknown else f"{shown['turns'][0]} whole turns and {angle}"]
    print_lines([(name, " = ".join(texts)) for name, texts in shown.items()])


def print_several(columns: Sequence[Column], style: NumberStyle, why: str) -> None:
    """A row for each instant; `why` says why one may not be known."""
    heads = [f"{name} [{unit}]" if unit else name for name, unit, _ in columns]
    plain = ("t", "turns")
    rows = [
        [
            style.shown(value, DIGITS) if name in plain and not math.isnan(value) else style.aligned(value, DIGITS)
            for name, value, _ in row
        ]
        for row in instants_of(columns)
    ]
    print_table(heads, rows)
    if nans(columns[1][2]):
        say(f"\n-: not known, {why}")
    elif any(nans(values) for _, _, values in columns):
        say(f"\n-: not known, {TOO_LARGE}")


COMMAND = command(
    "at",
    DESCRIPTION,
    run,
    AtOptions,
    short="angle and velocity at one instant, or at a few",
    parameters=[
        Word(
            "times",
            "TIME",
            "the instant, or several, separated by commas (required)",
            "the instants",
            offered=units(TIME),
        ),
        Value(
            "--crossing",
            "ANGLE",
            "instead of TIME: the first instant at which it passes this angle",
            "the instants",
            offered=units(ANGLE),
        ),
        *state_options("(this, --omega0 or --omega2 is required)"),
        *force_options(),
        *out_options("a table", "it"),
        *style_options(str(DIGITS)),
    ],
    usage=["libration at TIME[,TIME...]", "--theta0 ANGLE", "(--length LENGTH | --omega0 OMEGA0)", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
