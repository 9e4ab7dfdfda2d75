"""`libration period`: the period of one motion, its ratio to that of small swings, and what every formula makes of it."""

import contextlib
import math

from libration.cli.files import staged
from libration.cli.parser import Parser
from libration.cli.sampling import PICTURES, form, plotter
from libration.cli.state import (
    UNITS,
    has_frequency,
    pendulum,
    period_phase,
    small_swing_period,
    state,
    state_options,
    upright,
)

DESCRIPTION = """\
The exact period of a pendulum that starts at an angle, at rest or with a velocity.
In rotation it is the time of one turn; on the separatrix it is infinite; at rest it is that
of small swings. For swings the known formulas follow, each with its error."""

EPILOG = f"""\
Without --length or --omega0 the answer is T/T0, the ratio to the period of small swings,
and T*omega0; --velocity0 is then a plain number, the multiple of omega0.

{UNITS}

With --json: one object; the keys end in the unit. null stands for a value that is infinite
or does not exist; "regime" tells which: on the separatrix the period is infinite, in
rotation there is no turning angle. "formulas" holds T/T0 and the relative error of each.

examples:
  libration period --theta0 150deg
  libration period --theta0 150deg --chart period.svg
  libration period --theta0 20deg --length 25cm
  libration period --theta0 0 --velocity0 400deg/s --omega0 0.5Hz --json"""


def parser():
    """The options of `libration period`."""
    made = Parser("libration period", DESCRIPTION, EPILOG)
    made.usage = "libration period --theta0 ANGLE [--length LENGTH | --omega0 OMEGA0] [options]"
    state_options(made, "(gives the period in seconds)")
    group = made.add_argument_group("the results")
    made.value(group, "--chart", "FILE", "draw the formulas against the turning angle to a .png or .svg file")
    group.add_argument("--json", action="store_true", help="print one JSON object instead of lines")
    return made


def run(words):
    """Print the period that the words ask for."""
    options = parser().options(words)
    given = state(options)
    motion = pendulum(given)
    regime = str(motion.regime)
    with_frequency = has_frequency(given)
    phase = period_phase(given, motion)
    ratio = phase / math.tau
    formulas = compared(motion)
    with contextlib.ExitStack() as stack:
        if options.chart is not None:
            picture = stack.enter_context(staged("--chart", options.chart, PICTURES))
            plot_periods = plotter("libration.plot", "plot_periods", "--chart", options.chart)
            mark = motion.theta_max if formulas else None
            plot_periods(picture, theta_max=mark, form=form(options.chart))
    if options.json:
        print_json(given, motion, regime, with_frequency, phase, ratio, formulas)
    else:
        print_text(given, motion, regime, with_frequency, phase, ratio)
        print_formulas(motion, formulas)
        if options.chart is not None:
            print(f"\nwritten  {options.chart}")


def compared(motion):
    """Every formula with its T/T0 and its relative error, where the motion is a swing."""
    from libration.approx._period import listed

    if motion.regime != "libration" or upright(motion):
        return []
    # The smaller of m and 1 - m has the digits.
    m, mc = motion.energy_ratio, motion.energy_ratio_c
    given = {"m": m} if m < mc else {"mc": mc}
    return [(formula, float(formula.ratio(**given)), float(formula.error(**given))) for formula in listed()]


def print_formulas(motion, formulas):
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


def percent(error):
    """A relative error in percent, four digits."""
    return "undefined" if math.isnan(error) else f"{100 * error:+.4g} %"


def print_json(given, motion, regime, with_frequency, phase, ratio, formulas):
    """One JSON object."""
    from libration.cli.files import strict
    from libration.cli.parameters import given_parameters, keyed

    answer = keyed(given_parameters(given, motion)) if with_frequency else {"theta0_rad": given["theta0"]}
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


def print_text(given, motion, regime, with_frequency, phase, ratio):
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
