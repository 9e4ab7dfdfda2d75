"""Files written completely or not at all: staged beside the target, then renamed to it.

The staged file is opened before anything is computed, so a target that cannot be written is refused at once. After
any later error it is removed, and so is a directory made for it.
"""

import contextlib
import errno
import io
import json
import math
import os
import secrets
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, BinaryIO, TypeAlias

from libration.cli.language import told
from libration.cli.parser import refusal
from libration.cli.style import PLAIN, NumberStyle

if TYPE_CHECKING:
    from libration._arrays import Floats, NDArray

# Name, value and unit.
Parameter: TypeAlias = tuple[str, float | str, str]
# Name, unit and values.
Column: TypeAlias = "tuple[str, str, Floats]"
Json: TypeAlias = "float | str | Sequence[Json] | Mapping[str, Json] | None"

ROWS = 50_000


@contextlib.contextmanager
def staged(
    option: str, path: str, suffixes: Sequence[str], *, keep: Sequence[str] = (), also: str = ""
) -> Iterator[BinaryIO]:
    """Open a file beside `path`; rename it to `path` when the block ends, or remove it after an error.

    Parameters
    ----------
    option, path : str
        The option and its value, the target; a missing parent directory is made if its own parent exists.
    suffixes : sequence of str
        The endings that the option allows.
    keep : sequence of str
        Files that are read, which must not be the target.
    also : str
        What else the option takes, for the refusal of an ending.

    Yields
    ------
    io.BufferedWriter
    """
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in suffixes or "\0" in path:
        *most, last = suffixes
        listed = f"{', '.join(most)} {told('or')} {last}"
        raise refusal(option, path, told(f"must end in {listed}") + told(also))
    target = os.path.realpath(path)
    for read in keep:
        if target == os.path.realpath(read):
            raise refusal(option, path, "is the file read; give another name")
    with refused_writing(option, path):
        made = parent_made(option, path, os.path.dirname(target))
    beside = os.path.join(os.path.dirname(target), f".libration-{secrets.token_hex(6)}.part")
    try:
        with refused_writing(option, path):
            writable(option, path, target)
            with open(beside, "xb") as file:
                yield file
            os.replace(beside, target)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(beside)
        if made:
            with contextlib.suppress(OSError):
                os.rmdir(made)
        raise


@contextlib.contextmanager
def refused_writing(option: str, path: str) -> Iterator[None]:
    """An OSError of the block as a Refusal."""
    try:
        yield
    except OSError as error:
        if error.errno == errno.EPIPE:
            raise
        raise refusal(option, path, f"cannot be written: {error.strerror or error}") from error


def parent_made(option: str, path: str, parent: str) -> str | None:
    """Make the target's directory if only that is missing; return it if it was made."""
    if os.path.isdir(parent):
        return None
    if os.path.lexists(parent):
        raise refusal(option, path, f"cannot be written: {parent} is not a directory")
    if not os.path.isdir(os.path.dirname(parent)):
        raise refusal(option, path, f"cannot be written: there is no directory {os.path.dirname(parent)}")
    os.mkdir(parent)
    return parent


def writable(option: str, path: str, target: str) -> None:
    """Refuse a target that exists and must not be replaced: os.replace does not check."""
    with contextlib.suppress(FileNotFoundError):
        # The error for a name that is too long or for circular links would come only with the renaming, or never.
        os.stat(target)
    if os.path.isdir(target):
        raise refusal(option, path, "cannot be written: it is a directory")
    if os.path.exists(target) and not os.path.isfile(target):
        raise refusal(option, path, "cannot be written: it is not a regular file")
    if os.path.exists(target) and not os.access(target, os.W_OK):
        raise refusal(option, path, "cannot be written: it is read-only")


def write_csv(
    file: BinaryIO, parameters: Sequence[Parameter], columns: Sequence[Column], style: NumberStyle = PLAIN
) -> None:
    """Comma-separated doubles by repr, which read back bit for bit, after `#` lines with the parameters.

    With a decimal comma, semicolons separate, and the first `#` line says so.

    Parameters
    ----------
    file : binary file
    parameters : list of (str, value, str)
        Name, value and unit.
    columns : list of (str, str, ndarray)
        Name, unit and values.
    style : NumberStyle
        The decimal sign and the digits.
    """
    lines = ["# decimal comma, columns separated by semicolons"] if style.comma else []
    lines += [
        f"# {name} = {style.written(value) if isinstance(value, float) else value} {unit}".rstrip()
        for name, value, unit in parameters
    ]
    lines.append(style.separator.join(f"{name} [{unit}]" if unit else name for name, unit, _ in columns))
    text = style.written if style.comma or style.digits is not None else repr
    file.write(("\n".join(lines) + "\n").encode())
    count = len(columns[0][2])
    for start in range(0, count, ROWS):
        texts = [map(text, values[start : start + ROWS].tolist()) for _, _, values in columns]
        file.write(("\n".join(map(style.separator.join, zip(*texts, strict=True))) + "\n").encode())


def write_npz(file: BinaryIO, parameters: Sequence[Parameter], columns: Sequence[Column]) -> None:
    """A NumPy archive: the columns as arrays, the parameters as scalars, all by name, in SI units."""
    import numpy as np

    # Of two columns with one name the first is in the SI unit.
    arrays: dict[str, NDArray[Any]] = {name: values for name, _, values in reversed(columns)}
    arrays.update({name: np.array(value) for name, value, _ in parameters})
    # NumPy declares allow_pickle beside `**arrays`, and type checkers take the arrays for it.
    savez: Callable[..., None] = np.savez
    savez(file, **arrays)


def write_json(file: BinaryIO, parameters: Sequence[Parameter], columns: Sequence[Column]) -> None:
    """One strict JSON object: the keys end in the unit; null stands for infinity and NaN."""
    head = strict({key(name, unit): value for name, value, unit in parameters})
    file.write(f'{{"parameters": {head}'.encode())
    for name, unit, values in columns:
        file.write(f',\n "{key(name, unit)}": ['.encode())
        for start in range(0, len(values), ROWS):
            text = strict(values[start : start + ROWS].tolist())[1:-1]
            file.write((", " * (start > 0) + text).encode())
        file.write(b"]")
    file.write(b"}\n")


def key(name: str, unit: str) -> str:
    """`period` in `s` as `period_s`, `velocity` in `rad/s` as `velocity_rad_per_s`."""
    return f"{name}_{unit.replace('/', '_per_').replace('^', '')}" if unit and unit != "T/T0" else name


def strict(value: Json) -> str:
    """JSON text with null for each infinity and NaN."""
    return json.dumps(finite(value), allow_nan=False)


def finite(value: Json) -> Json:
    """A number, text, dictionary or list with None for each infinity and NaN."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {name: finite(each) for name, each in value.items()}
    if isinstance(value, list):
        return [finite(each) for each in value]
    return value


TABLES = (".csv", ".npz", ".json")
# As the name of a file: the standard output.
STANDARD_OUTPUT = "-"


@contextlib.contextmanager
def staged_table(path: str, *, keep: Sequence[str] = ()) -> Iterator[BinaryIO]:
    """Open what --out names: a staged file, or for `-` what is printed when the block ends."""
    if path != STANDARD_OUTPUT:
        with staged("--out", path, TABLES, keep=keep, also="; - is the standard output, as .csv") as file:
            yield file
        return
    printed = io.BytesIO()
    yield printed
    sys.stdout.write(printed.getvalue().decode())


def write_table(
    file: BinaryIO, path: str, parameters: Sequence[Parameter], columns: Sequence[Column], style: NumberStyle = PLAIN
) -> None:
    """Write parameters and columns in the format of the suffix of `path`."""
    suffix = os.path.splitext(path)[1].lower()
    if suffix == ".npz":
        write_npz(file, parameters, columns)
    elif suffix == ".json":
        write_json(file, parameters, columns)
    else:
        write_csv(file, parameters, columns, style)


def readable(option: str, path: str) -> tuple[int, bool]:
    """Refuse a file that cannot be read; return its size and whether it is a regular file."""
    try:
        state = os.stat(path)
    except (OSError, ValueError) as error:
        raise refusal(option, path, f"cannot be read: {getattr(error, 'strerror', None) or error}") from error
    if os.path.isdir(path):
        raise refusal(option, path, "cannot be read: it is a directory")
    return state.st_size, os.path.isfile(path)
