"""`libration papers`: every figure of the three papers, and every number they claim beside the one measured here.

All files are opened before anything is drawn, and renamed at the end.
"""

import contextlib
import csv
import io
import os
import shutil
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, BinaryIO

from libration.cli.files import staged
from libration.cli.help import Topic
from libration.cli.language import say, told
from libration.cli.offers import folders, words
from libration.cli.parser import Finding, Options, Refusal, Value, Word, command, refusal
from libration.cli.picture import check_matplotlib, check_package

if TYPE_CHECKING:
    from libration.papers import Claim

DESCRIPTION = """\
Three papers about the pendulum, checked: Salas 2019, Lima 2019 and Horsley 2025. Draws each
of their figures again, and prints each number that they claim beside the one measured here."""

TOPICS = (
    Topic(
        "files in DIR",
        text="""\
salas-1 to salas-7, lima-1 to lima-4, horsley-1 to horsley-3, horsley-phase-space and horsley-ellipse, each as .svg and
.png with source and choices in the caption; claims.csv with the rows of the table. Files that exist are replaced; all
are written, or none.""",
    ),
    Topic(
        "verdicts",
        text="""\
A claim is `reproduced`, `corrected` (the measured value is right), or `not reproducible` for the reason given. The exit
code is 0 if what is measured supports every verdict, else 1. The wrong lines of the papers are listed in
docs/errata.md.""",
    ),
)
EXAMPLES = ("libration papers", "libration papers lima --out figures")

FORMS = ("svg", "png")
COLUMNS = ("work", "place", "claim", "printed", "ours", "value", "verdict", "reason")


class PapersOptions(Options):
    """The options of `libration papers`."""

    paper: str | None
    out: str | None


def run(options: PapersOptions) -> None:
    """Draw the figures, write and print the claims; a Finding if a verdict is not supported."""
    folder = "out" if options.out is None else options.out
    works = chosen_works(options.paper)
    check_folder(folder)
    check_matplotlib("--out", folder, "papers")
    if works != ("lima",):
        check_package("SciPy", ("scipy.integrate",), "--out", folder, "papers")

    from libration.papers import claims, pictures

    drawn = [picture for work in works for picture in pictures(work)]
    with contextlib.ExitStack() as stack:
        files: dict[tuple[str, str], BinaryIO] = {}
        for picture in drawn:
            for form in FORMS:
                path = os.path.join(folder, f"{picture.name}.{form}")
                files[picture.name, form] = stack.enter_context(staged("--out", path, (".svg", ".png")))
        table = stack.enter_context(staged("--out", os.path.join(folder, "claims.csv"), (".csv", ".csv")))
        rows = [row for work in works for row in claims(work)]
        table.write(csv_text(rows).encode())
        for picture in drawn:
            picture.save({form: files[picture.name, form] for form in FORMS})
    print_table(rows)
    say(summary(rows))
    names = told(f"{len(drawn)} figures as .svg and .png, and claims.csv")
    say(f"written to {folder}: {names}")
    failed = next((row for row in rows if not row.stands), None)
    if failed is not None:
        raise Finding(f"{failed.work}, {failed.place}: {failed.claim}: {failed.ours} does not support {failed.verdict}")


def chosen_works(paper: str | None) -> tuple[str, ...]:
    """The papers asked for, or a Refusal."""
    from libration.papers._works import chosen

    try:
        return chosen(paper)
    except ValueError as error:
        raise Refusal(str(error)) from error


def check_folder(folder: str) -> None:
    """Refuse what cannot be a directory."""
    if not folder or not folder.isprintable():
        raise refusal("--out", folder, "must be a directory")
    if os.path.exists(folder) and not os.path.isdir(folder):
        raise refusal("--out", folder, "is not a directory")
    parent = os.path.dirname(os.path.abspath(folder))
    if not os.path.isdir(parent):
        raise refusal("--out", folder, f"cannot be made: there is no directory {parent}")


def csv_text(rows: "Sequence[Claim]") -> str:
    """The claims as comma-separated text; the measured value reads back to the same double."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for row in rows:
        value = "" if row.measured is None else repr(row.value)
        writer.writerow((row.work, row.place, row.claim, row.printed, row.ours, value, verdict_text(row), row.reason))
    return text.getvalue()


def verdict_text(row: "Claim") -> str:
    """The verdict; with its reason in brackets if the claim cannot be reproduced."""
    return f"{row.verdict} ({row.reason})" if row.measured is None else str(row.verdict)


def print_table(rows: "Sequence[Claim]") -> None:
    """Verdict, place and claim, and below them the printed and the measured value."""
    width = max(shutil.get_terminal_size((100, 24)).columns, 60)
    work = None
    for row in rows:
        if row.work != work:
            work = row.work
            print(f"{work}\n")
        head = f"  {told(str(row.verdict)):16}  "
        text = textwrap.wrap(f"{row.place}: {row.claim}".replace(" = ", "\u00a0=\u00a0"), width - len(head))
        print("\n".join([head + text[0]] + [" " * len(head) + line for line in text[1:]]))
        print(
            "\n".join(textwrap.wrap(told(values(row)), width, initial_indent=" " * 22, subsequent_indent=" " * 22))
            + "\n"
        )


def values(row: "Claim") -> str:
    """The printed and the measured value as text."""
    if row.measured is None:
        return row.reason
    note = f" ({row.reason})" if row.reason else ""
    return f"printed: {row.printed}; measured: {row.ours}{note}"


def summary(rows: "Sequence[Claim]") -> str:
    """How many claims, and how many with each verdict."""
    verdicts = [str(row.verdict) for row in rows]
    counts = ", ".join(f"{verdicts.count(verdict)} {told(verdict)}" for verdict in dict.fromkeys(verdicts))
    return f"{len(rows)} claims: {counts}"


COMMAND = command(
    "papers",
    DESCRIPTION,
    run,
    PapersOptions,
    short="every figure of three papers about the pendulum, and a check of their numbers",
    parameters=[
        Word(
            "paper",
            "PAPER",
            "salas, lima or horsley (default all three)",
            "the paper",
            offered=words("salas", "lima", "horsley"),
        ),
        Value(
            "--out",
            "DIR",
            "directory of the files (default out); made if the one above it exists",
            "the results",
            offered=folders,
        ),
    ],
    usage=["libration papers", "[salas | lima | horsley]", "[--out DIR]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
