"""`libration period`: the period of one motion, its ratio to that of small swings, and the value of every formula."""

import contextlib
import math
from typing import TYPE_CHECKING, TypeAlias

from libration.cli.files import Json, staged
from libration.cli.help import Topic
from libration.cli.offers import files
from libration.cli.parser import Flag, Value, command
from libration.cli.sampling import PICTURES, check_matplotlib, form
from libration.cli.state import (
    UNITS,
    StateOptions,
    has_frequency,
    pendulum,
    period_phase,
    small_swing_period,
    state,
    state_options,
    upright,
)

if TYPE_CHECKING:
    from libration import Pendulum
    from libration.approx._period import PeriodFormula

# A formula, its T/T0 and its relative error.
Compared: TypeAlias = "tuple[PeriodFormula, float, float]"

DESCRIPTION = """\
The exact period of a pendulum that starts at an angle, at rest or with a velocity.
In rotation it is the time of one turn; on the separatrix it is infinite; at rest it is that
of small swings. For swings the known formulas follow, each with its error."""

TOPICS = (
    Topic(
        "without a frequency",
        text="""\
Without --length or --omega0 the answer is T/T0, the ratio to the period of small swings, and T*omega0; --velocity0 is
then a number without a unit, the multiple of omega0.""",
    ),
    UNITS,
    Topic(
        "json",
        text="""\
With --json: one object; the keys end in the unit. null stands for a value that is infinite or does not exist, depending
on "regime": on the separatrix the period is infinite, in rotation there is no turning angle. "formulas" holds T/T0 and
the relative error of each.""",
    ),
)
EXAMPLES = (
    "libration period --theta0 150deg",
    "libration period --theta0 150deg --chart period.svg",
    "libration period --theta0 20deg --length 25cm",
    "libration period --theta0 0 --velocity0 400deg/s --omega0 0.5Hz --json",
)


class PeriodOptions(StateOptions):
    """The options of `libration period`."""

    chart: str | None
    json: bool


def run(options: PeriodOptions) -> None:
    """Print the period that the words ask for."""
    given = state(options)
    motion = pendulum(given)
    regime = str(motion.regime)
    with_frequency = has_frequency(given)
    phase = period_phase(given, motion)
    ratio = phase / math.tau
    formulas = compared(motion)
    with contextlib.ExitStack() as stack:
        if options.chart is not None:
            chart = stack.enter_context(staged("--chart", options.chart, PICTURES))
            check_matplotlib("--chart", options.chart, "plot")
            from libration.plot import plot_periods

            plot_periods(chart, theta_max=motion.theta_max if formulas else None, form=form(options.chart))
    if options.json:
        print_json(given, motion, regime, with_frequency, phase, ratio, formulas)
    else:
        print_text(given, motion, regime, with_frequency, phase, ratio)
        print_formulas(motion, formulas)
        if options.chart is not None:
            print(f"\nwritten  {options.chart}")


def compared(motion: "Pendulum") -> list[Compared]:
    """Every formula with its T/T0 and its relative error, where the motion is a swing."""
    from libration.approx._period import listed

    if motion.regime != "libration" or upright(motion):
        return []
    # The smaller of m and 1 - m is the more accurate one.
    m, mc = motion.energy_ratio, motion.energy_ratio_c
    given = {"m": m} if m < mc else {"mc": mc}
    return [(formula, float(formula.ratio(**given)), float(formula.error(**given))) for formula in listed()]


def print_formulas(motion: "Pendulum", formulas: list[Compared]) -> None:
    """A table of the formulas, or why there is none."""
    from libration.cli.summary import digits

    if upright(motion):
        print("formulas       none: but for the rounding of pi this is the upright balance, whose period is infinite")
    if not formulas:
        return
    width = max(len(formula.name) for formula, *_ in formulas)
    print(f"\n{'formula':{width}}  {'T / T0':>16}  {'error':>11}  source")
    for formula, ratio, error in formulas:
        print(f"{formula.name:{width}}  {digits(ratio):>16}  {percent(error):>11}  {formula.source}")
    print("\nthe formulas themselves: --json, or docs/approximations.md")


def percent(error: float) -> str:
    """A relative error in percent, four digits."""
    return "undefined" if math.isnan(error) else f"{100 * error:+.4g} %"


def print_json(
    given: dict[str, float],
    motion: "Pendulum",
    regime: str,
    with_frequency: bool,
    phase: float,
    ratio: float,
    formulas: list[Compared],
) -> None:
    """One JSON object."""
    from libration.cli.files import strict
    from libration.cli.parameters import given_parameters, keyed

    answer: dict[str, Json] = (
        keyed(given_parameters(given, motion)) if with_frequency else {"theta0_rad": given["theta0"]}
    )
    if not with_frequency:
        answer["velocity0_per_omega0"] = given["velocity0"]
    answer["regime"] = regime
    if with_frequency:
        answer |= {"period_s": motion.period, "small_swing_period_s": small_swing_period(given)}
    answer |= {"period_ratio": ratio, "period_omega0_rad": phase, "theta_max_rad": motion.theta_max}
    answer["formulas"] = [
        {
            "name": formula.name,
            "formula": formula.formula,
            "source": formula.source,
            "period_ratio": ratio,
            "relative_error": error,
        }
        for formula, ratio, error in formulas
    ]
    print(strict(answer))


def print_text(
    given: dict[str, float], motion: "Pendulum", regime: str, with_frequency: bool, phase: float, ratio: float
) -> None:
    """Aligned lines."""
    from libration.cli.summary import angle_text, digits, period_text, print_lines

    lines = [("regime", regime)]
    if with_frequency:
        lines.append(("period T", period_text(regime, motion.period)))
        lines.append(("of small swings, T0", f"{digits(small_swing_period(given))} s"))
    lines.append(("T / T0", digits(ratio) if math.isfinite(ratio) else "infinite"))
    lines.append(("T * omega0", f"{digits(phase)} rad" if math.isfinite(phase) else "infinite"))
    lines.append(("turning angle", angle_text(regime, motion.theta_max)))
    print_lines(lines)


COMMAND = command(
    "period",
    DESCRIPTION,
    run,
    PeriodOptions,
    short="the period, and how much longer it is than that of small swings",
    parameters=[
        *state_options("(gives the period in seconds)"),
        Value(
            "--chart",
            "FILE",
            "draw the formulas against the turning angle to a .png or .svg file",
            "the results",
            offered=files,
        ),
        Flag("--json", "print one JSON object instead of lines", "the results"),
    ],
    usage=["libration period", "--theta0 ANGLE", "[--length LENGTH | --omega0 OMEGA0]", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
