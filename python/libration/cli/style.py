"""How numbers are written: the decimal sign and the digits, in tables for people and in those for a spreadsheet."""

import math
from dataclasses import dataclass

import click

from libration.cli.language import comma as comma_of_language
from libration.cli.language import told
from libration.cli.offers import words
from libration.cli.parser import Options, Value, refusal
from libration.cli.quantities import whole

SIGNS = ("point", "comma")
# A double has no more decimal digits that mean anything.
MOST_DIGITS = 17


@dataclass(frozen=True)
class NumberStyle:
    """The decimal sign in files, the significant digits where they are chosen, and the decimal sign for people."""

    comma: bool = False
    digits: int | None = None
    read: bool = False

    @property
    def separator(self) -> str:
        """What stands between the columns of a file: spreadsheets that read decimal commas expect semicolons."""
        return ";" if self.comma else ","

    def signed(self, text: str) -> str:
        """A number for people as text with the decimal sign."""
        return text.replace(".", ",") if self.comma or self.read else text

    def shown(self, value: float, digits: int) -> str:
        """A number for people, with so many significant digits if none were chosen."""
        return self.signed(f"{value:.{self.digits or digits}g}")

    def aligned(self, value: float, digits: int) -> str:
        """A number of a column, with zeros to the last of its digits; a dash for NaN."""
        if math.isnan(value):
            return "-"
        return (
            self.signed(f"{value:#.{self.digits or digits}g}".rstrip(".")) if math.isfinite(value) else told("infinite")
        )

    def written(self, value: float) -> str:
        """A number for a file: all digits, so that it reads back to the same double, if none were chosen."""
        text = repr(value) if self.digits is None else f"{value:.{self.digits}g}"
        return text.replace(".", ",") if self.comma else text


PLAIN = NumberStyle()


class StyleOptions(Options):
    """The options of the decimal sign and the digits, as typed."""

    decimal: str | None
    digits: str | None
    out: str | None


def style_options(default: str) -> list[click.Option]:
    """The options of the decimal sign and the digits; `default` says how many digits are printed."""
    group = "the numbers"
    comma = "comma: decimal commas in what is printed, and semicolons between the columns of a .csv (default point; in what is printed, that of the language)"
    return [
        Value("--decimal", "SIGN", comma, group, offered=words(*SIGNS)),
        Value("--digits", "N", f"significant digits, 1 to 17 (default {default}, all in a file)", group),
    ]


def number_style(options: StyleOptions) -> NumberStyle:
    """The style that the options ask for, or a Refusal."""
    if options.decimal is not None and options.decimal not in SIGNS:
        raise refusal("--decimal", options.decimal, "must be point or comma")
    if options.out is not None and options.out.lower().endswith((".npz", ".json")):
        for option, given in (("--decimal", options.decimal), ("--digits", options.digits)):
            if given not in (None, "point"):
                raise refusal(option, given, "is for what is printed and for .csv; --out names another kind of file")
    return NumberStyle(
        options.decimal == "comma",
        None if options.digits is None else whole("--digits", options.digits, 1, MOST_DIGITS),
        options.decimal is None and comma_of_language(),
    )
