"""Where results go: a file or the standard output, and the names of the files that were written."""

import click

from libration.cli.files import STANDARD_OUTPUT
from libration.cli.offers import files
from libration.cli.parser import Flag, Options, Refusal, Value


class OutOptions(Options):
    """The options of the results, as typed."""

    out: str | None
    json: bool


def out_options(written: str, printed: str, summary: str = "print one JSON object") -> list[click.Option]:
    """The options of the results: what is written, the pronoun for it where it is printed, and what --json does."""
    group = "the results"
    out = f"write {written} to a .csv, .npz or .json file, - to print {printed}"
    return [Value("--out", "FILE", out, group, offered=files), Flag("--json", summary, group)]


def check_printed(options: OutOptions) -> None:
    """Refuse two things on the standard output."""
    if options.out == STANDARD_OUTPUT and options.json:
        raise Refusal("--out = - and --json: both print on the standard output; give one of the two")


def written(*paths: str | None) -> list[str]:
    """The files that were asked for, among what --out and --plot name."""
    return [path for path in paths if path is not None and path != STANDARD_OUTPUT]
