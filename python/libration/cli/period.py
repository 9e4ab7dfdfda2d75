"""`libration period`: the period of one motion with the value of every formula, or a table of several swings.

One angle is answered in lines; several, or a file, as a table with a row for each swing and a column for each formula.
"""

import contextlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from libration.cli.files import STANDARD_OUTPUT, Column, Json, Parameter, staged, staged_table, strict, write_table
from libration.cli.help import Topic
from libration.cli.language import Told, say, told
from libration.cli.offers import formulas
from libration.cli.parameters import given_parameters, keyed
from libration.cli.parser import Refusal, Value, command, refusal, shown
from libration.cli.picture import (
    PICTURES,
    Look,
    PictureOptions,
    check_matplotlib,
    drawing,
    form,
    picture_look,
    picture_options,
)
from libration.cli.quantities import ANGLE, quantities
from libration.cli.results import OutOptions, check_printed, out_options, written
from libration.cli.state import (
    UNITS,
    State,
    StateOptions,
    known_energy,
    missing_angle,
    others,
    pendulum,
    period_phase,
    small_swing_period,
    state,
    state_options,
    upright,
    with_energy,
)
from libration.cli.style import NumberStyle, StyleOptions, number_style, style_options
from libration.cli.summary import angle_text, digits, period_text, print_lines, print_table

if TYPE_CHECKING:
    from libration import Pendulum
    from libration.approx._period import PeriodFormula

# A formula, its T/T0 and its relative error.
Compared: TypeAlias = "tuple[PeriodFormula, float, float]"

DESCRIPTION = """\
The exact period of a pendulum that starts at an angle, at rest or with a velocity. In rotation it is the time of one
turn; on the separatrix it is infinite; at rest it is that of small swings. For swings the known formulas follow, each
with its error. Several angles, separated by commas, give a table: a row for each swing, a column for each formula."""
TOPICS = (
    Topic(
        "without a frequency",
        text="""\
Without --length, --omega0 or --omega2 the answer is T/T0, the ratio to the period of small swings, and T*omega0;
--velocity0 is then a number without a unit, the multiple of omega0.""",
    ),
    UNITS,
    Topic(
        "json",
        text="""\
With --json: one object; the keys end in the unit. null stands for a value that is infinite or does not exist, depending
on "regime": on the separatrix the period is infinite, in rotation there is no turning angle. "formulas" holds T/T0 and
the relative error of each; of several angles, "swings" holds the exact period and the value of each formula.""",
    ),
)
EXAMPLES = (
    "libration period --theta0 150deg",
    "libration period --theta0 20deg,60deg,150deg --length 1m --only exact,linear,bernoulli",
    "libration period --theta0 20deg,60deg --length 1m --decimal comma --out periods.csv",
    "libration period --theta0 150deg --plot period.svg",
    "libration period --theta0 0 --velocity0 400deg/s --omega0 0.5Hz --json",
    "libration period --energy-ratio-c 1e-17 --omega0 1",
    "libration period --period 2.5s --length 1m",
)
EXACT = "exact"


class PeriodOptions(StateOptions, StyleOptions, OutOptions, PictureOptions):
    """The options of `libration period`."""

    only: str | None
    chart: str | None


@dataclass(frozen=True)
class Swing:
    """One row: the angle as typed, the state, its motion, and the formulas with their values where it is a swing."""

    typed: str
    given: State
    motion: "Pendulum"
    compared: list[Compared]

    @property
    def regime(self) -> str:
        """The kind of motion."""
        return str(self.motion.regime)

    @property
    def phase(self) -> float:
        """The period times omega0."""
        return period_phase(self.given, self.motion)

    @property
    def exact(self) -> float:
        """The period in s; without a frequency T/T0."""
        return self.motion.period if self.given.has_frequency else self.phase / math.tau

    def value(self, name: str) -> float:
        """The exact value or that of a formula, in s or as T/T0; NaN where the formula has none."""
        if name == EXACT:
            return self.exact
        found = next((ratio for formula, ratio, _ in self.compared if formula.name == name), math.nan)
        return found * small_swing_period(self.given) if self.given.has_frequency else found


def run(options: PeriodOptions) -> None:
    """Print the periods that the words ask for."""
    swings = made_swings(options)
    names = [EXACT, *(formula.name for formula in chosen(options.only))]
    if options.only is not None and EXACT not in options.only.split(","):
        names.remove(EXACT)
    style, picture = number_style(options), picture_name(options)
    look = picture_look(options, picture and picture[1])
    check_printed(options)
    with contextlib.ExitStack() as stack:
        if options.out is not None:
            table = stack.enter_context(staged_table(options.out))
            write_table(table, options.out, parameters(swings), columns(swings, names), style)
        if picture is not None:
            draw(stack, *picture, swings, look)
    files = written(options.out, picture and picture[1])
    if options.json:
        print(strict(one_object(swings[0]) if len(swings) == 1 else several_objects(swings, names, files)))
    elif options.out != STANDARD_OUTPUT:
        if len(swings) == 1:
            print_one(swings[0], style)
        else:
            print_several(swings, names, style)
        if files:
            print()
            print_lines([("written", path) for path in files])


def made_swings(options: PeriodOptions) -> list[Swing]:
    """A row for each angle, or a Refusal."""
    wanted, known = chosen(options.only), known_energy(options)
    if options.theta0 is None:
        if not known:
            raise missing_angle()
        given = state(options)
        motion = pendulum(given)
        return [Swing("lowest point", given, motion, compared(motion, wanted))]
    angles = quantities("--theta0", options.theta0, ANGLE)
    typed = [each.strip() for each in options.theta0.split(";" if ";" in options.theta0 else ",")]
    values = others(options)
    states = [with_energy(options, {"theta0": angle, **values}, known) for angle in angles]
    motions = [pendulum(each) for each in states]
    rows = zip(typed, states, motions, strict=True)
    return [Swing(text, given, motion, compared(motion, wanted)) for text, given, motion in rows]


def chosen(text: str | None) -> "list[PeriodFormula]":
    """The formulas that --only names, all by default; the exact value is none of them."""
    from libration.approx._period import listed

    if text is None:
        return list(listed())
    names = [name.strip() for name in text.split(",")]
    for name in names:
        if names.count(name) > 1:
            raise refusal("--only", text, f"names {shown(name)} twice")
    return [formula(name) for name in names if name != EXACT]


def formula(name: str) -> "PeriodFormula":
    """One formula by its name, or a Refusal with the nearest names first."""
    from libration import approx

    try:
        return approx.period(name)
    except ValueError as error:
        raise refusal("--only", name, str(error).partition(": ")[2]) from error


def compared(motion: "Pendulum", wanted: "Sequence[PeriodFormula]") -> list[Compared]:
    """Every formula with its T/T0 and its relative error, where the motion is a swing."""
    if not is_swing(motion):
        return []
    # The smaller of m and 1 - m is the more accurate one.
    m, mc = motion.energy_ratio, motion.energy_ratio_c
    given = {"m": m} if m < mc else {"mc": mc}
    return [(formula, float(formula.ratio(**given)), float(formula.error(**given))) for formula in wanted]


def is_swing(motion: "Pendulum") -> bool:
    """Whether the formulas are for this motion."""
    return motion.regime == "libration" and not upright(motion)


def picture_name(options: PeriodOptions) -> tuple[str, str] | None:
    """The option that asks for a picture, and its file."""
    if options.plot is not None and options.chart is not None:
        raise Refusal(f"--plot = {shown(options.plot)} and --chart = {shown(options.chart)}: are one option; give one")
    if options.plot is not None:
        return "--plot", options.plot
    return None if options.chart is None else ("--chart", options.chart)


def draw(stack: contextlib.ExitStack, option: str, path: str, swings: Sequence[Swing], look: Look) -> None:
    """Draw the formulas; the turning angles are marked."""
    file = stack.enter_context(staged(option, path, PICTURES))
    check_matplotlib(option, path, "plot")
    from libration.plot import plot_periods

    marked = [each.motion.theta_max for each in swings if is_swing(each.motion)]
    with drawing(option, path):
        plot_periods(file, theta_max=marked, form=form(path), **look)


def parameters(swings: Sequence[Swing]) -> list[Parameter]:
    """What is the same for every row."""
    from libration import __version__

    first = swings[0]
    same = given_parameters(first.given, first.motion) if first.given.has_frequency else []
    return [("libration", __version__, ""), *(each for each in same if each[0] != "theta0")]


def columns(swings: Sequence[Swing], names: Sequence[str]) -> list[Column]:
    """The columns of the table: the angle, and each formula in s or as T/T0."""
    import numpy as np

    radians = np.array([each.given.values["theta0"] for each in swings])
    # Fifteen digits, so that 20deg is 20 and not its neighbour.
    degrees = np.array([float(f"{math.degrees(angle):.15g}") for angle in radians.tolist()])
    unit = "s" if swings[0].given.has_frequency else "T/T0"
    values = [(name, unit, np.array([each.value(name) for each in swings])) for name in names]
    return [("theta0", "rad", radians), ("theta0", "deg", degrees), *values]


def print_several(swings: Sequence[Swing], names: Sequence[str], style: NumberStyle) -> None:
    """A row for each swing, a column for each formula."""
    seconds = swings[0].given.has_frequency
    say("period in s\n" if seconds else "T / T0, the period over that of small swings\n")
    print_table(
        list(map(Told, ["theta0", *names])),
        [[each.typed, *(style.aligned(each.value(name), 6) for name in names)] for each in swings],
    )
    if any(math.isnan(each.value(name)) for each in swings for name in names):
        say("\n-: the formula has no value there, or the motion is no swing")


def print_one(swing: Swing, style: NumberStyle) -> None:
    """One motion in aligned lines, and below them its formulas."""
    motion, ratio = swing.motion, swing.phase / math.tau
    lines = [("regime", swing.regime)]
    if swing.given.has_frequency:
        small = small_swing_period(swing.given)
        lines.append(("period T", period_text(motion, style)))
        lines.append(("of small swings, T0", f"{digits(small, style)} s" if math.isfinite(small) else "infinite"))
    lines.append(("T / T0", digits(ratio, style) if math.isfinite(ratio) else "infinite"))
    lines.append(("T * omega0", f"{digits(swing.phase, style)} rad" if math.isfinite(swing.phase) else "infinite"))
    lines.append(("turning angle", angle_text(motion, style)))
    if upright(motion):
        lines.append(
            ("formulas", "none: but for the rounding of pi this is the upright balance, whose period is infinite")
        )
    print_lines(lines)
    if swing.compared:
        print()
        print_formulas(swing, style)


def print_formulas(swing: Swing, style: NumberStyle) -> None:
    """The formulas with their errors and sources."""
    seconds = ["T [s]"] if swing.given.has_frequency else []
    heads = ["formula", "T / T0", *seconds, "error", "source"]
    rows = [
        [
            formula.name,
            style.aligned(ratio, 10),
            *([style.aligned(swing.value(formula.name), 10)] if seconds else []),
            percent(error, style),
            told(formula.source),
        ]
        for formula, ratio, error in swing.compared
    ]
    print_table(heads, rows, left=(0, len(heads) - 1))
    say("\nthe formulas themselves: --json, or docs/approximations.md")


def percent(error: float, style: NumberStyle) -> str:
    """A relative error in percent, four digits."""
    return told("undefined") if math.isnan(error) else f"{style.signed(f'{100 * error:+.4g}')} %"


def one_object(swing: Swing) -> dict[str, Json]:
    """One motion as a JSON object."""
    given, motion = swing.given, swing.motion
    answer: dict[str, Json] = (
        keyed(given_parameters(given, motion)) if given.has_frequency else {"theta0_rad": motion.theta0}
    )
    if not given.has_frequency:
        answer["velocity0_per_omega0"] = motion.velocity0
    answer["regime"] = swing.regime
    if given.has_frequency:
        answer |= {"period_s": motion.period, "small_swing_period_s": small_swing_period(given)}
    answer |= {"period_ratio": swing.phase / math.tau, "period_omega0_rad": swing.phase}
    answer["theta_max_rad"] = motion.theta_max
    answer["formulas"] = [
        {
            "name": formula.name,
            "formula": formula.formula,
            "source": formula.source,
            "period_ratio": ratio,
            "relative_error": error,
        }
        for formula, ratio, error in swing.compared
    ]
    return answer


def several_objects(swings: Sequence[Swing], names: Sequence[str], files: list[str]) -> dict[str, Json]:
    """Several motions as a JSON object."""
    answer = keyed(parameters(swings)[1:])
    unit = "s" if swings[0].given.has_frequency else "ratio"
    answer["swings"] = [
        {
            "theta0_rad": each.motion.theta0,
            "regime": each.regime,
            **{f"period_{unit}": each.exact},
            "formulas": {name: each.value(name) for name in names if name != EXACT},
        }
        for each in swings
    ]
    answer["files"] = files
    return answer


COMMAND = command(
    "period",
    DESCRIPTION,
    run,
    PeriodOptions,
    short="the period, and how much longer it is than that of small swings",
    parameters=[
        *state_options(
            "(gives the period in seconds)",
            "initial angle from the lowest point, or several (required beside a velocity)",
        ),
        Value(
            "--only",
            "NAMES",
            "formulas by name, as linear,cromer; exact is the period itself (default all)",
            "the results",
            offered=formulas,
        ),
        *out_options("the table", "it"),
        *style_options("6 in a table, else 15"),
        *picture_options("the formulas against the turning angle"),
        Value("--chart", "FILE", "the same as --plot", "the picture", hidden=True),
    ],
    usage=["libration period", "--theta0 ANGLE[,ANGLE...]", "[--length LENGTH | --omega0 OMEGA0]", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
