"""`libration solve`: the motion at many instants, its summary, a table and a plot.

Everything that can be refused is refused before the motion is evaluated; files appear whole or not at all.
"""

import contextlib
import os
import textwrap

from libration.cli.files import staged, strict, write_table
from libration.cli.parameters import found_parameters, given_parameters, keyed
from libration.cli.parser import Parser, Refusal, quoted, refusal, shown
from libration.cli.state import UNITS, has_frequency, pendulum, state, state_options
from libration.cli.times import even_times, file_times

TABLES = (".csv", ".npz", ".json")
PICTURES = (".png", ".svg")

DESCRIPTION = """\
The exact motion of a pendulum: angle and angular velocity at many instants, and how far
the linear solution, theta0 cos(omega0 t) + velocity0 / omega0 sin(omega0 t), is from it.
The angle counts on through turns."""

EPILOG = f"""\
{UNITS}

files:
  .csv keeps the parameters in `#` lines and names its columns with units; every number
  reads back to the same double. .npz (numpy.load) and .json hold the same.
  A file is written beside its name and then renamed, so it is whole or not there; one that
  exists is replaced. A missing directory is made if the one above it exists.
  --times reads text up to 256 MiB: `#` lines are skipped, columns are separated by comma,
  semicolon or tab, a header is optional. Without --column it takes the column t or time,
  else the first; whole numbers between commas, which may be decimal commas, need a header
  or --column. A unit in the header, as in `t [ms]`, holds; otherwise seconds. The order is
  kept.

With --json: one object on the standard output; the keys end in the unit. null stands for a
value that is infinite or does not exist; "regime" tells which: on the separatrix the period
is infinite, in rotation there is no turning angle.

examples:
  libration solve --theta0 170deg --length 1m
  libration solve --theta0 3 --length 1m --gravity 9.8 --out motion.csv --plot motion.png
  libration solve --theta0 0 --velocity0 2.5 --omega0 1 --times instants.csv --out a.npz"""


def parser():
    """The options of `libration solve`."""
    made = Parser("libration solve", DESCRIPTION, EPILOG)
    made.usage = "libration solve --theta0 ANGLE (--length LENGTH | --omega0 OMEGA0) [options]"
    state_options(made, "(this or --omega0 is required)")
    group = made.add_argument_group("the instants")
    made.value(group, "--until", "TIME", "last instant; the first is 0 (default 10s)")
    made.value(group, "--samples", "N", "number of instants, evenly spaced, both ends included (default 501)")
    made.value(group, "--times", "FILE", "read the instants from a text file instead")
    made.value(
        group,
        "--column",
        "NAME",
        "column of --times that holds the instants: its name, or its number if there is no header",
    )
    group = made.add_argument_group("the results")
    made.value(group, "--out", "FILE", "write t, theta, velocity and theta_linear to a .csv, .npz or .json file")
    made.value(group, "--plot", "FILE", "draw theta(t) and the phase portrait to a .png or .svg file")
    group.add_argument("--json", action="store_true", help="print the summary as one JSON object")
    return made


def run(words):
    """Solve what the words ask for, write the files, print the summary."""
    options = parser().options(words)
    given = state(options)
    if not has_frequency(given):
        raise Refusal("missing --length or --omega0, such as --length 1m; `libration period` works without")
    check_instants(options)
    check_targets(options)
    motion = pendulum(given)
    with contextlib.ExitStack() as stack:
        table = picture = None
        if options.out is not None:
            table = stack.enter_context(staged("--out", options.out, TABLES, keep=read_files(options)))
        if options.plot is not None:
            picture = stack.enter_context(staged("--plot", options.plot, PICTURES, keep=read_files(options)))
            plot_motion = plotter(options.plot)
        times, source = instants(options)
        columns, largest, at = motion_columns(motion, times)
        if table:
            write_table(table, options.out, table_parameters(given, motion), columns)
        if picture:
            draw(plot_motion, motion, times, picture, options.plot)
    files = [path for path in (options.out, options.plot) if path is not None]
    if options.json:
        answer = keyed(given_parameters(given, motion) + found_parameters(motion))
        answer |= {"samples": len(times), "first_t_s": float(times[0]), "last_t_s": float(times[-1])}
        answer |= {"linear_difference_rad": largest, "linear_difference_t_s": at, "files": files}
        print(strict(answer))
    else:
        print_text(motion, times, source, largest, at, files)


def check_instants(options):
    """Refuse options about instants that contradict each other."""
    for name in ("until", "samples"):
        if options.times is not None and getattr(options, name) is not None:
            raise refusal(
                f"--{name}", getattr(options, name), "the instants are read from --times; give one of the two"
            )
    if options.column is not None and options.times is None:
        raise refusal("--column", options.column, "needs --times FILE beside it")


def check_targets(options):
    """Refuse one file under two names: the second would replace the first."""
    if options.out is None or options.plot is None or "\0" in options.out + options.plot:
        return
    if os.path.realpath(options.out) == os.path.realpath(options.plot):
        raise Refusal(f"--out = {shown(options.out)} and --plot = {shown(options.plot)}: are one file; give two")


def read_files(options):
    """The files that are read and must not be written over."""
    return () if options.times is None else (options.times,)


def instants(options):
    """The instants, and where they come from."""
    if options.times is None:
        return even_times(options.until, options.samples), None
    times, column = file_times(options.times, options.column)
    return times, f"column {quoted(column)} of {shown(options.times)}"


def plotter(path):
    """plot_motion, or a Refusal if matplotlib is missing: before anything is computed."""
    try:
        import matplotlib.backends.backend_agg
        import matplotlib.figure  # noqa: F401
    except ModuleNotFoundError as error:
        raise refusal("--plot", path, "needs matplotlib: pip install 'libration[plot]'") from error
    except Exception as error:
        # Its settings are read now, and a bad one may raise anything.
        reason = textwrap.shorten(str(error) or type(error).__name__, 160, placeholder=" ...")
        raise refusal("--plot", path, f"matplotlib does not start: {reason}") from error
    from libration.plot import plot_motion

    return plot_motion


def draw(plot_motion, motion, times, picture, path):
    """Draw into the staged file; numbers near the largest double have no place on an axis."""
    try:
        plot_motion(motion, times, picture, form=path.rpartition(".")[2].lower())
    except (ArithmeticError, RuntimeError, ValueError) as error:
        large = isinstance(error, OverflowError) or "NaN or Inf" in str(error)
        reason = "the motion is too large for an axis" if large else str(error)
        raise refusal("--plot", path, f"cannot be drawn: {reason}") from error


def motion_columns(motion, times):
    """The columns of the table; the largest difference from the linear solution and the instant where it occurs."""
    import numpy as np

    from libration.plot import linear_theta

    theta, velocity = motion.motion(times)
    linear = linear_theta(motion, times)
    with np.errstate(over="ignore", invalid="ignore"):
        difference = np.abs(theta - linear)
    columns = [("t", "s", times), ("theta", "rad", theta), ("velocity", "rad/s", velocity)]
    columns.append(("theta_linear", "rad", linear))
    if np.isnan(difference).all():
        return columns, None, None
    where = int(np.nanargmax(difference))
    return columns, float(difference[where]), float(times[where])


def table_parameters(given, motion):
    """The parameters that a table carries."""
    from libration import __version__

    return [("libration", __version__, ""), *given_parameters(given, motion), *found_parameters(motion)]


def print_text(motion, times, source, largest, at, files):
    """The summary for people."""
    from libration.cli.summary import angle_text, digits, period_text, print_lines

    regime = str(motion.regime)
    span = (
        f"{len(times)} instants, {times[0]:.6g} s to {times[-1]:.6g} s" if len(times) > 1 else f"t = {times[0]:.6g} s"
    )
    lines = [
        ("regime", regime),
        ("period", period_text(regime, motion.period)),
        ("turning angle", angle_text(regime, motion.theta_max)),
        ("energy", f"{digits(motion.energy)} rad^2/s^2 per unit inertia, 0 at the bottom"),
        ("energy ratio", digits(motion.energy_ratio)),
        ("1 - energy ratio", digits(motion.energy_ratio_c)),
        ("sampled", span + (f", {source}" if source else "")),
        (
            "largest difference from linear",
            "not known" if largest is None else f"{largest:.6g} rad, at t = {at:.6g} s",
        ),
    ]
    print_lines(lines + [("written", path) for path in files])
