"""What the commands that sample a motion share: instants, files and the plot."""

import contextlib
import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, BinaryIO

import click

from libration.cli.files import staged, staged_table
from libration.cli.help import Topic
from libration.cli.language import told
from libration.cli.offers import files, units
from libration.cli.parser import Refusal, Value, quoted, refusal, shown
from libration.cli.picture import PICTURES, PictureOptions, picture_options
from libration.cli.quantities import TIME
from libration.cli.results import OutOptions, check_printed, out_options
from libration.cli.style import PLAIN, NumberStyle, StyleOptions, style_options
from libration.cli.times import even_times, file_times

if TYPE_CHECKING:
    from libration._arrays import Floats


FILES = Topic(
    "files",
    text="""\
.csv keeps the parameters in `#` lines and names its columns with units; every number reads back to the same double.
.npz (numpy.load) and .json hold the same. A file is written under another name and then renamed: it is complete, or it
does not appear. One that exists is replaced. A missing directory is made if its parent exists.

--times reads text up to 256 MiB: `#` lines are skipped, columns are separated by comma, semicolon or tab, a header is
optional. The default of --column is the column t or time, else the first. Whole numbers between commas, which may be
decimal commas, need a header or --column. The unit is that of the header, as in `t [ms]`; default s. The order is kept.
""",
)


class ResultOptions(StyleOptions, OutOptions, PictureOptions):
    """The options of the files and the summary, as typed."""

    # The file of the instants; None for a command without that option.
    times: str | None = None


class InstantOptions(ResultOptions):
    """The options of the instants and the results, as typed."""

    until: str | None
    samples: str | None
    column: str | None


def instant_options() -> list[Value]:
    """The options of the instants."""
    group = "the instants"
    column = "column of --times that holds the instants: its name, or its number if there is no header"
    return [
        Value("--until", "TIME", "last instant; the first is 0 (default 10s)", group, offered=units(TIME)),
        Value(
            "--samples",
            "N",
            "number of instants, evenly spaced, both ends included; 1: the last alone (default 501)",
            group,
        ),
        Value("--times", "FILE", "read the instants from a text file instead", group, offered=files),
        Value("--column", "NAME", column, group),
    ]


def result_options(columns: str, curve: str) -> list[click.Option]:
    """The options of the files and the summary; `columns` and `curve` say what is written and drawn."""
    return [
        *out_options(columns, "them", "print the summary as one JSON object"),
        *style_options("15"),
        *picture_options(curve),
    ]


@contextlib.contextmanager
def targets(options: ResultOptions, keep: Sequence[str] = ()) -> Iterator[tuple[BinaryIO | None, BinaryIO | None]]:
    """The staged table and plot, None for one not asked for; they are renamed at the end. `keep` are files that are read."""
    keep = [*keep, *([options.times] if options.times is not None else [])]
    with contextlib.ExitStack() as stack:
        table = plot = None
        if options.out is not None:
            table = stack.enter_context(staged_table(options.out, keep=keep))
        if options.plot is not None:
            plot = stack.enter_context(staged("--plot", options.plot, PICTURES, keep=keep))
        yield table, plot


def sampled(times: "Floats", source: str | None, style: NumberStyle = PLAIN) -> str:
    """How many instants, the first and the last, and the file that they are read from."""
    several, (first, last) = len(times) > 1, (style.signed(f"{each:.6g}") for each in (times[0], times[-1]))
    span = f"{len(times)} instants, {first} s to {last} s" if several else f"t = {first} s"
    return told(span) + (f", {told(source)}" if source else "")


def nans(values: "Floats") -> int:
    """How many values are NaN."""
    import numpy as np

    return int(np.count_nonzero(np.isnan(values)))


def valueless(count: int) -> list[tuple[str, str]]:
    """The line on samples that lie beyond 2**53 half periods, as lines of a summary."""
    text = f"{count}, more than 2^53 half periods away: nan in a table"
    return [("of them too far to be known", text)] if count else []


def check_instants(options: InstantOptions) -> None:
    """Refuse options about instants that contradict each other."""
    for option, given in (("--until", options.until), ("--samples", options.samples)):
        if options.times is not None and given is not None:
            raise refusal(option, given, "the instants are read from --times; give one of the two")
    if options.column is not None and options.times is None:
        raise refusal("--column", options.column, "needs --times FILE beside it")


def check_targets(options: ResultOptions) -> None:
    """Refuse one file under two names: the second would replace the first; and two things on the standard output."""
    check_printed(options)
    if options.out is None or options.plot is None or "\0" in options.out + options.plot:
        return
    if os.path.realpath(options.out) == os.path.realpath(options.plot):
        raise Refusal(f"--out = {shown(options.out)} and --plot = {shown(options.plot)}: are one file; give two")


def instants(options: InstantOptions) -> "tuple[Floats, str | None]":
    """The instants, and the column and file that they are read from."""
    if options.times is None:
        return even_times(options.until, options.samples), None
    times, column = file_times(options.times, options.column)
    return times, f"column {quoted(column)} of {shown(options.times)}"
