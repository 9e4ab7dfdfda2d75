"""What commands that sample a motion share: their instants, their files and their picture."""

import contextlib
import importlib
import os
import textwrap

from libration.cli.files import staged
from libration.cli.parser import Refusal, quoted, refusal, shown
from libration.cli.times import even_times, file_times

TABLES = (".csv", ".npz", ".json")
PICTURES = (".png", ".svg")

FILES = """\
files:
  .csv keeps the parameters in `#` lines and names its columns with units; every number
  reads back to the same double. .npz (numpy.load) and .json hold the same.
  A file is written beside its name and then renamed, so it is whole or not there; one that
  exists is replaced. A missing directory is made if the one above it exists.
  --times reads text up to 256 MiB: `#` lines are skipped, columns are separated by comma,
  semicolon or tab, a header is optional. Without --column it takes the column t or time,
  else the first; whole numbers between commas, which may be decimal commas, need a header
  or --column. A unit in the header, as in `t [ms]`, holds; otherwise seconds. The order is
  kept."""


def instant_options(parser):
    """Add the options of the instants."""
    group = parser.add_argument_group("the instants")
    parser.value(group, "--until", "TIME", "last instant; the first is 0 (default 10s)")
    parser.value(group, "--samples", "N", "number of instants, evenly spaced, both ends included (default 501)")
    parser.value(group, "--times", "FILE", "read the instants from a text file instead")
    parser.value(
        group,
        "--column",
        "NAME",
        "column of --times that holds the instants: its name, or its number if there is no header",
    )


def result_options(parser, columns, curve):
    """Add the options of the files and the summary; `columns` and `curve` say what is written and drawn."""
    group = parser.add_argument_group("the results")
    parser.value(group, "--out", "FILE", f"write {columns} to a .csv, .npz or .json file")
    parser.value(group, "--plot", "FILE", f"draw {curve} and the phase portrait to a .png or .svg file")
    group.add_argument("--json", action="store_true", help="print the summary as one JSON object")


@contextlib.contextmanager
def targets(options):
    """The staged table and picture, None for those not asked for; they take their places at the end."""
    with contextlib.ExitStack() as stack:
        table = picture = None
        if options.out is not None:
            table = stack.enter_context(staged("--out", options.out, TABLES, keep=read_files(options)))
        if options.plot is not None:
            picture = stack.enter_context(staged("--plot", options.plot, PICTURES, keep=read_files(options)))
        yield table, picture


def written(options):
    """The files that were asked for."""
    return [path for path in (options.out, options.plot) if path is not None]


def sampled(times, source):
    """How many instants, from where to where, and out of which file."""
    several = len(times) > 1
    span = f"{len(times)} instants, {times[0]:.6g} s to {times[-1]:.6g} s" if several else f"t = {times[0]:.6g} s"
    return span + (f", {source}" if source else "")


def nans(values):
    """How many values are NaN."""
    import numpy as np

    return int(np.count_nonzero(np.isnan(values)))


def valueless(count):
    """The line on samples that lie beyond 2**53 half periods, as lines of a summary."""
    text = f"{count}, more than 2^53 half periods away: nan in a table"
    return [("of them too far to be known", text)] if count else []


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
    times = getattr(options, "times", None)
    return () if times is None else (times,)


def instants(options):
    """The instants, and where they come from."""
    if options.times is None:
        return even_times(options.until, options.samples), None
    times, column = file_times(options.times, options.column)
    return times, f"column {quoted(column)} of {shown(options.times)}"


def plotter(module, name, option, path):
    """A function that draws, or a Refusal if matplotlib is missing, before anything is computed; None without a path."""
    if path is None:
        return None
    check_matplotlib(option, path, "plot")
    return getattr(importlib.import_module(module), name)


def check_matplotlib(option, path, extra):
    """Refuse to draw if matplotlib is missing or does not start; `extra` is what installs it with libration."""
    check_package("matplotlib", ("matplotlib.backends.backend_agg", "matplotlib.figure"), option, path, extra)


def check_package(package, modules, option, path, extra):
    """Refuse an option whose package is missing or does not start."""
    try:
        for module in modules:
            importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise refusal(option, path, f"needs {package}: pip install 'libration[{extra}]'") from error
    except Exception as error:
        # Settings are read now, and a bad one may raise anything.
        reason = textwrap.shorten(str(error) or type(error).__name__, 160, placeholder=" ...")
        raise refusal(option, path, f"{package} does not start: {reason}") from error


def form(path):
    """The form that the ending of a picture's name asks for."""
    return path.rpartition(".")[2].lower()


def draw(plot, motion, times, picture, path):
    """Draw into the staged file; numbers near the largest double have no place on an axis."""
    try:
        plot(motion, times, picture, form=form(path))
    except (ArithmeticError, RuntimeError, ValueError) as error:
        large = isinstance(error, OverflowError) or any(words in str(error) for words in ("NaN or Inf", "zero-size"))
        reason = "the motion is too large for an axis" if large else str(error)
        raise refusal("--plot", path, f"cannot be drawn: {reason}") from error
