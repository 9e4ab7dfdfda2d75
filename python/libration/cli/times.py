"""Instants: evenly spaced (`--until`, `--samples`) or read from a column of a text file (`--times`, `--column`).

A file is read completely before the first number is used: `#` lines and blank lines are skipped, the first other line
may be a header, the columns are separated by tab, semicolon or comma, order and repetitions are kept. Where tabs or
semicolons separate, a comma in a number is a decimal comma.
"""

import itertools
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import TYPE_CHECKING

from libration.cli.files import readable
from libration.cli.memory import available_bytes, bytes_text
from libration.cli.parser import Refusal, quoted, refusal, shown
from libration.cli.quantities import ONE, TIME, Dimension, quantity, scaled

if TYPE_CHECKING:
    from libration._arrays import Floats

LARGEST_FILE = 256 * 2**20
# A line with more characters is not a row of a table.
LONGEST_LINE = 2**20
# Four columns of doubles, and as much again while they are computed and compared.
BYTES_PER_SAMPLE = 64
BLOCK = 100_000
# What a text file does not contain: control characters other than tab, line feed, vertical tab, form feed, return.
CONTROL = re.compile(rb"[\x00-\x08\x0e-\x1a\x1c-\x1f\x7f]")
# Bytes of whole lines that are decoded together; a chunk of blank lines is skipped at once.
CHUNK = 2**20
BYTE_ORDER_MARK = b"\xef\xbb\xbf"
BRACKETS = {"]": "[", ")": "("}
SIGNS = "+-.\N{MINUS SIGN}"
# A whole number: a row of them may be numbers with decimal commas, split at the commas.
WHOLE = re.compile(r"[+-]?[0-9]+([eE][+-]?[0-9]+)?")
DECIMAL_COMMA = re.compile(r"[+-]?[0-9]*,[0-9]+([eE][+-]?[0-9]+)?")


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
    data = text_bytes(file)
    lines: Iterator[tuple[int, str]] = numbered(file, data)
    first = next(lines, None)
    if first is None:
        raise file.refusal(f"holds no {kind.plural}: it is empty, but for comments")
    separator = next((each for each in "\t;," if each in first[1]), ",")
    cells = row(first[1], separator)
    header = cells if is_header(cells) else None
    if header is not None:
        lines = below_header(file, first[0], lines)
    index, name, factor = chosen(file, column, cells, header, kind)
    if header is None:
        lines = itertools.chain([first], lines)
    doubtful = header is None and column is None and separator == "," and len(cells) > 1
    values = read_column(file, lines, separator, len(cells), index, factor, doubtful, header is not None)
    if not len(values):
        raise file.refusal(f"holds no {kind.plural}: no row follows the header in line {first[0]}")
    fits_memory(file.option, file.path, len(values))
    return values, name


def below_header(file: TextFile, number: int, lines: Iterator[tuple[int, str]]) -> Iterator[tuple[int, str]]:
    """The lines below a header, or a Refusal if the first of them has the names of several columns."""
    second = next(lines, None)
    if second is None:
        return lines
    at, line = second
    separator = next((each for each in "\t;," if each in line), None)
    if separator is not None and is_header(row(line, separator)):
        reason = f"lines {number} and {at} are both words: is one a title, or one of units? begin it with #"
        raise file.refusal(reason)
    return itertools.chain([second], lines)


def text_bytes(file: TextFile) -> bytes:
    """The bytes of a text file that is not too large, or a Refusal."""
    size, regular = readable(file.option, file.path)
    limit = bytes_text(LARGEST_FILE)
    advice = "; in Python, Pendulum(...).theta(t) takes any array"
    if regular and size > LARGEST_FILE:
        raise file.refusal(f"has {bytes_text(size)}, more than the {limit} that are read{advice}")
    parts: list[bytes] = []
    total = 0
    try:
        with open(file.path, "rb") as opened:
            while part := opened.read(2**20):
                if found := CONTROL.search(part):
                    raise file.refusal(f"is not text: byte {total + found.start()} is 0x{found[0].hex()}")
                parts.append(part)
                total += len(part)
                if total > LARGEST_FILE:
                    raise file.refusal(f"has more than the {limit} that are read{advice}")
    except OSError as error:
        raise file.refusal(f"cannot be read: {error.strerror or error}") from error
    if not total:
        raise file.refusal("is empty")
    return b"".join(parts)


def numbered(file: TextFile, data: bytes) -> Iterator[tuple[int, str]]:
    """The lines that are not blank and not comments, with their numbers; a Refusal for one that is too long."""
    encoding = encoding_of(data)
    number = 1
    for chunk in chunks(data.removeprefix(BYTE_ORDER_MARK) if encoding == "utf-8" else data):
        if chunk.isspace() and b"\t" not in chunk:
            number += chunk.count(b"\n")
            continue
        for line in chunk.decode(encoding).removesuffix("\n").split("\n"):
            # Tabs at the end stay: they may separate empty cells.
            kept = line.strip(" ")
            if kept and not kept.isspace() and not kept.startswith("#"):
                if len(kept) > LONGEST_LINE:
                    reason = f"line {number} has {len(kept)} characters, more than the {LONGEST_LINE} that are read"
                    raise file.refusal(reason)
                yield number, kept
            number += 1


def encoding_of(data: bytes) -> str:
    """`utf-8` if all lines are valid UTF-8, else `latin-1`."""
    try:
        for chunk in chunks(data):
            chunk.decode()
    except UnicodeDecodeError:
        return "latin-1"
    return "utf-8"


def chunks(data: bytes) -> Iterator[bytes]:
    """Whole lines, about a million bytes at a time: in both encodings no character contains the byte of a line feed."""
    if b"\r" in data:
        data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    start = 0
    while start < len(data):
        end = data.find(b"\n", start + CHUNK) + 1 or len(data)
        yield data[start:end]
        start = end


def row(line: str, separator: str) -> list[str]:
    """The cells of a line, stripped."""
    if '"' in line:
        return [cell.strip() for cell in quoted_cells(line, separator)]
    return [cell.strip() for cell in line.split(separator)]


def quoted_cells(line: str, separator: str) -> Iterator[str]:
    """The cells of a line some of which are in quotes; a quote inside them is written twice (RFC 4180).

    Not by the csv module: it refuses a cell of 131,072 characters unless a setting of the whole process is changed.
    """
    position = 0
    while True:
        parts: list[str] = []
        if line.startswith('"', position):
            position += 1
            while (end := line.find('"', position)) >= 0 and line.startswith('"', end + 1):
                parts.append(line[position : end + 1])
                position = end + 2
            end = len(line) if end < 0 else end
            parts.append(line[position:end])
            position = end + 1
        end = line.find(separator, position)
        parts.append(line[position:] if end < 0 else line[position:end])
        yield "".join(parts)
        if end < 0:
            return
        position = end + 1


def name_and_unit(cell: str, dimension: Dimension = TIME) -> tuple[str, str | None]:
    """`t`, `ms` for a header's cell `t [ms]`, `t (ms)`, `t/ms` or `t_ms`; the unit is None where there is none."""
    if cell[-1:] in BRACKETS:
        opening = cell.find(BRACKETS[cell[-1]])
        return (cell, None) if opening < 0 else (cell[:opening].rstrip(), cell[opening + 1 : -1].strip())
    at = max(cell.rfind("/"), cell.rfind("_"))
    unit = cell[at + 1 :].lstrip()
    return (cell[:at].rstrip(), unit) if at >= 0 and dimension.factor(unit) is not None else (cell, None)


def is_header(cells: Sequence[str]) -> bool:
    """Whether the first line names columns: no cell is a number, and the first cell does not begin like one."""
    start = cells[0][:1]
    numeric = any(number(cell) is not None or DECIMAL_COMMA.fullmatch(cell) for cell in cells)
    return not numeric and start not in tuple(SIGNS) and not start.isnumeric()


def is_plain(cell: str) -> bool:
    """Whether a cell has nothing that only float() accepts in a number: `1_0`, digits of other scripts."""
    return cell.isascii() and "_" not in cell


def number(cell: str) -> float | None:
    """The double in a cell, or None."""
    try:
        return float(cell) if is_plain(cell) else None
    except ValueError:
        return None


def chosen(
    file: TextFile, column: str | None, cells: Sequence[str], header: list[str] | None, kind: ColumnKind
) -> tuple[int, str, Decimal]:
    """Index, name and factor to the first unit of the column to read."""
    if column is None and kind.place >= len(cells):
        raise file.refusal(f"has {len(cells)} column, and the {kind.plural} are in a second")
    if header is None:
        names = [str(k) for k in range(1, len(cells) + 1)]
        if column is None:
            return kind.place, names[kind.place], ONE
        if column not in names:
            raise refusal("--column", column, f"{shown(file.path)} has no header; its columns are {listed(names)}")
        return names.index(column), column, ONE
    bare = [name_and_unit(cell, kind.dimension)[0] for cell in header]
    if column is None:
        index = next((k for k, each in enumerate(bare) if each.lower() in kind.names), kind.place)
    elif header.count(column) == 1:
        index = header.index(column)
    elif bare.count(column) == 1:
        index = bare.index(column)
    else:
        several = "names several columns" if column in header + bare else "is no column"
        raise refusal("--column", column, f"{several} of {shown(file.path)}; it has {listed(header)}")
    unit = name_and_unit(header[index], kind.dimension)[1] or next(iter(kind.dimension.units))
    factor = kind.dimension.factor(unit)
    if factor is None:
        takes = f"{kind.dimension.plural} take {', '.join(kind.dimension.units)}"
        raise file.refusal(f"column {quoted(header[index])} is in {quoted(unit)}; {takes}")
    return index, header[index], factor


def listed(names: Sequence[str]) -> str:
    """Column names for a refusal, twelve at most."""
    return ", ".join(map(quoted, names[:12])) + (", ..." if len(names) > 12 else "")


def read_column(
    file: TextFile,
    lines: Iterator[tuple[int, str]],
    separator: str,
    width: int,
    index: int,
    factor: Decimal,
    doubtful: bool,
    headed: bool,
) -> "Floats":
    """One column as an array of seconds, block by block; `doubtful` if commas between whole numbers may be decimal."""
    import numpy as np

    blocks: list[Floats] = []
    comma = point = False
    while block := list(itertools.islice(lines, BLOCK)):
        rows = [row(line, separator) for _, line in block]
        if separator != ",":
            found = commas_as_points(rows, index)
            comma, point = comma or found[0], point or found[1]
            if comma and point:
                reason = "has decimal commas and decimal points in one column; write the one or the other"
                raise file.refusal(reason)
        try:
            ragged = any(len(cells) != width for cells in rows)
            values = None if ragged else np.array([float(cells[index]) for cells in rows])
        except ValueError:
            values = None
        if values is None or not np.isfinite(values).all() or not all(is_plain(cells[index]) for cells in rows):
            raise bad_row(file, block, rows, width, index, headed and not blocks)
        doubtful = doubtful and all(WHOLE.fullmatch(cell) for cells in rows for cell in cells)
        if factor != ONE:
            values = np.array([scaled(cells[index], factor) for cells in rows])
        blocks.append(values)
    if doubtful:
        reason = "holds only whole numbers and commas: decimal commas? write points; columns? choose one by --column 1"
        raise file.refusal(reason)
    return np.concatenate(blocks) if blocks else np.empty(0)


def commas_as_points(rows: Sequence[list[str]], index: int) -> tuple[bool, bool]:
    """Write decimal commas of a column as points; whether there were commas, and whether there were points."""
    comma = point = False
    for cells in rows:
        cell = cells[index] if index < len(cells) else ""
        if DECIMAL_COMMA.fullmatch(cell):
            comma = True
            cells[index] = cell.replace(",", ".")
        elif "." in cell:
            point = True
    return comma, point


def bad_row(
    file: TextFile,
    block: Sequence[tuple[int, str]],
    rows: Sequence[Sequence[str]],
    width: int,
    index: int,
    below_header: bool,
) -> Refusal:
    """The Refusal for the first bad row of a block, which may be the first below a header."""
    for (line, _), cells in zip(block, rows, strict=True):
        if len(cells) != width:
            reason = f"has {len(cells)} cells, and the first row has {width}"
            if re.fullmatch(r"[+-]?[0-9]+", cells[0]) and len(cells) == 2 * width:
                reason += "; a decimal comma? write a point"
        elif (value := number(cells[index])) is None:
            reason = f"{quoted(cells[index])} is not a number"
            if DECIMAL_COMMA.fullmatch(cells[index]):
                reason += f"; write {cells[index].replace(',', '.')}"
            elif not cells[index]:
                reason = "has an empty cell"
        elif not math.isfinite(value):
            reason = f"{quoted(cells[index])} is not finite"
        else:
            below_header = False
            continue
        if below_header and "write" not in reason:
            reason += "; if the line above is a title, begin it with #"
        return file.refusal(f"line {line} {reason}")
    return file.refusal("cannot be read")
