"""Instants: evenly spaced (`--until`, `--samples`) or read from a column of a text file (`--times`, `--column`).

A file is read completely before the first number is used: `#` lines and blank lines are skipped, the first other line
may be a header, the columns are separated by tab, semicolon or comma, order and repetitions are kept. Where tabs or
semicolons separate, a comma in a number is a decimal comma. The reader is fit's, in Rust.
"""

import math
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import TYPE_CHECKING

from libration.cli.files import readable
from libration.cli.memory import available_bytes, bytes_text
from libration.cli.parser import Refusal, quoted, refusal, shown
from libration.cli.quantities import TIME, Dimension, quantity

if TYPE_CHECKING:
    from libration._arrays import Floats

LARGEST_FILE = 256 * 2**20
# Four columns of doubles, and as much again while they are computed and compared.
BYTES_PER_SAMPLE = 64


def even_times(until: str | None, samples: str | None) -> "Floats":
    """Evenly spaced instants from 0 to `until`, both ends included, of one the last; the defaults are 10 s and 501."""
    last = 10.0 if until is None else quantity("--until", until, TIME, above=0)
    count = 501 if samples is None else sample_count(samples)
    import numpy as np

    return np.linspace(0.0, last, count) if count > 1 else np.array([last])


def sample_count(text: str) -> int:
    """A whole number of samples for which there is enough memory, or a Refusal."""
    try:
        # float() bounds the exponent before int() forms a number of that many digits.
        typed = Decimal(text) if is_plain(text) and math.isfinite(float(text)) else None
    except (ArithmeticError, ValueError):
        typed = None
    if typed is None or typed != typed.to_integral_value():
        raise refusal("--samples", text, "must be a whole number, 1 or greater")
    count = int(typed)
    if count < 1:
        raise refusal("--samples", text, "must be 1 or greater")
    fits_memory("--samples", text, count)
    return count


def fits_memory(option: str, text: str, count: int) -> None:
    """Refuse a number of samples for which there is not enough memory."""
    need, have = count * BYTES_PER_SAMPLE, available_bytes()
    if need > have:
        raise refusal(option, text, f"would take {bytes_text(need)} of memory, and {bytes_text(have)} are available")


@dataclass(frozen=True)
class TextFile:
    """A text file that an option names."""

    option: str
    path: str

    @cached_property
    def data(self) -> bytes:
        """Its bytes, read once however many columns are asked for, or a Refusal."""
        return text_bytes(self)

    def refusal(self, reason: str) -> Refusal:
        """What is wrong with it."""
        return refusal(self.option, self.path, reason)


@dataclass(frozen=True)
class ColumnKind:
    """What a column holds, the names by which it is known, and which column it is if none has such a name."""

    plural: str
    names: tuple[str, ...]
    place: int
    dimension: Dimension


INSTANTS = ColumnKind("instants", ("t", "time", "times"), 0, TIME)


def file_times(path: str, column: str | None) -> "tuple[Floats, str]":
    """The instants in a column of a text file, in seconds, as an array, and the column's name."""
    return file_column(TextFile("--times", path), column, INSTANTS)


def file_column(file: TextFile, column: str | None, kind: ColumnKind) -> "tuple[Floats, str]":
    """A column of a text file, in the first unit of its dimension, as an array, and the column's name."""
    data = file.data
    from libration import _core

    def factor(unit: str) -> str | None:
        found = kind.dimension.factor(unit)
        return None if found is None else str(found)

    takes = f"{kind.dimension.plural} take {', '.join(kind.dimension.units)}"
    wanted = shown(file.path), kind.plural, kind.names, kind.place, takes
    try:
        values, name = _core.column(data, column, wanted, factor, quoted)
    except ValueError as error:
        about_column, reason = error.args
        raise (refusal("--column", column, reason) if about_column else file.refusal(reason)) from None
    fits_memory(file.option, file.path, len(values))
    return values, name


def is_plain(text: str) -> bool:
    """Whether a text has nothing that only float() accepts in a number: `1_0`, digits of other scripts."""
    return text.isascii() and "_" not in text


def text_bytes(file: TextFile) -> bytes:
    """The bytes of a text file that is not too large, or a Refusal."""
    size, regular = readable(file.option, file.path)
    limit = bytes_text(LARGEST_FILE)
    advice = "; in Python, Pendulum(...).theta(t) takes any array" if file.option == "--times" else ""
    if regular and size > LARGEST_FILE:
        raise file.refusal(f"has {bytes_text(size)}, more than the {limit} that are read{advice}")
    parts: list[bytes] = []
    total = 0
    try:
        with open(file.path, "rb") as opened:
            while part := opened.read(2**20):
                parts.append(part)
                total += len(part)
                if total > LARGEST_FILE:
                    raise file.refusal(f"has more than the {limit} that are read{advice}")
    except OSError as error:
        raise file.refusal(f"cannot be read: {error.strerror or error}") from error
    if not total:
        raise file.refusal("is empty")
    return b"".join(parts)
