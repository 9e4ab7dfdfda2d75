"""`libration period`: the period of one motion, and its ratio to that of small swings."""

import math

from libration.cli.parser import Parser
from libration.cli.state import UNITS, has_frequency, pendulum, period_phase, small_swing_period, state, state_options

DESCRIPTION = """\
The exact period of a pendulum that starts at an angle, at rest or with a velocity.
In rotation it is the time of one turn; on the separatrix it is infinite; at rest it is that
of small swings."""

EPILOG = f"""\
Without --length or --omega0 the answer is T/T0, the ratio to the period of small swings,
and T*omega0; --velocity0 is then a plain number, the multiple of omega0.

{UNITS}

With --json: one object; the keys end in the unit. null stands for a value that is infinite
or does not exist; "regime" tells which: on the separatrix the period is infinite, in
rotation there is no turning angle.

examples:
  libration period --theta0 150deg
  libration period --theta0 20deg --length 25cm
  libration period --theta0 0 --velocity0 400deg/s --omega0 0.5Hz --json"""


def parser():
    """The options of `libration period`."""
    made = Parser("libration period", DESCRIPTION, EPILOG)
    made.usage = "libration period --theta0 ANGLE [--length LENGTH | --omega0 OMEGA0] [options]"
    state_options(made, "(gives the period in seconds)")
    group = made.add_argument_group("the results")
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
    if options.json:
        print_json(given, motion, regime, with_frequency, phase, ratio)
    else:
        print_text(given, motion, regime, with_frequency, phase, ratio)


def print_json(given, motion, regime, with_frequency, phase, ratio):
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
