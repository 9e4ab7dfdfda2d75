"""What is given to a fit, as columns: a file, a data frame, or arrays; and measures, which are values with uncertainties."""

import errno
import os
import re
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from .. import _core
from .._scalars import count, real, shown
from ._binary import as_text
from ._frames import frame_as_text

# The names of what is no file.
ARRAYS, FRAME = "arrays", "data frame"
# In place of the number of a run.
ALL = "all"
# What a column may be.
ROLES = ("time", "angle", "velocity", "acceleration", "x", "y", "period")
# As the messages of the reader name the options of the command; a value ends where its sentence goes on.
OPTION = re.compile(r"--(column|unit) (\w+)=(.+?)(?=: |[;,]| or --| and --|$)")
PLAIN_OPTION = re.compile(r"--(rate|run|length)( (?=[A-Z]))?")
# Bytes of the largest file: its columns take some twenty times its memory, and a device may have no end.
MOST_BYTES = 1 << 30


class Given(NamedTuple):
    """What is fitted: a name for messages, the kind and its columns, and what the reader said."""

    name: str
    kind: str
    columns: list[Any]
    understood: list[str]
    dropped: list[dict[str, Any]]
    # In the file, of which this is one.
    runs: int = 1


def measure(name: str, given: Any) -> tuple[float, float]:
    """Value and standard uncertainty of a number, a pair, or a value of `uncertainties`."""
    if hasattr(given, "nominal_value"):
        return float(given.nominal_value), float(given.std_dev)
    pair = isinstance(given, tuple | list) or (isinstance(given, np.ndarray) and given.ndim == 1)
    if isinstance(given, str) or (pair and len(given) != 2):
        raise ValueError(f"{name} = {shown(given)}: must be a number or (value, standard uncertainty)")
    if pair:
        return real(name, given[0]), real(f"uncertainty of {name}", given[1])
    return real(name, given), 0.0


def stated_of(
    columns: Mapping[str, str | int] | None,
    units: Mapping[str, str] | None,
    rate: float | None,
    run: int | str | None,
    length: tuple[float, float] | None,
) -> dict[str, Any]:
    """What is stated about a file, as the reader takes it."""
    return {
        "columns": by_role("columns", columns, (str, int, np.integer)),
        "units": by_role("units", units, (str,)),
        "rate": rate,
        "run": run if run is None or (isinstance(run, str) and run == ALL) else run_of(run),
        "length": length and length[0],
    }


def by_role(name: str, given: Mapping[str, str | int] | None, kinds: tuple[type, ...]) -> list[str]:
    """Names of columns, or units, by what they are, as the reader takes them."""
    if given is None:
        return []
    if not isinstance(given, Mapping):
        example = "theta" if name == "columns" else "deg"
        raise ValueError(f"{name} = {shown(given)}: must be a mapping, such as {{'angle': '{example}'}}")
    for role, each in given.items():
        if role not in ROLES:
            raise ValueError(f"{name}: {shown(role)} must be one of {', '.join(ROLES)}")
        if not isinstance(each, kinds) or isinstance(each, bool) or not str(each).strip():
            wanted = "the name of a column, or its number from 1" if name == "columns" else "the name of a unit"
            raise ValueError(f"{name}: {role} = {shown(each)} must be {wanted}")
    return [f"{role}={each}" for role, each in given.items()]


def run_of(run: Any) -> int:
    """The number of a run."""
    if isinstance(run, str) or (number := count("run", run)) < 1:
        raise ValueError(f"run = {shown(run)}: must be a whole number from 1, or 'all' for fit_together")
    return number


def content_of(path: str | bytes) -> bytes:
    """The bytes of a file, or an OSError."""
    with open(path, "rb") as file:
        content = file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise OSError(errno.EFBIG, f"it holds more than {MOST_BYTES} bytes, the most that are read", path)
    return content


def of_bytes(name: str, content: bytes, stated: Mapping[str, Any]) -> Given:
    """The columns in the bytes of a file."""
    name = name if name.isprintable() else repr(name)
    try:
        # No name: the reader would cut a long one, and the end of a path says most.
        record = _core.Record("", as_text(content), **stated)
        kind, columns = record.columns()
    except ValueError as error:
        raise ValueError(f"{name}: {str(error).removeprefix(': ')}") from None
    dropped = [
        {"reason": reason, "count": count, "lines": lines, "sentence": sentence}
        for reason, count, lines, sentence in record.dropped
    ]
    return Given(name, kind, columns, record.understood, dropped, record.run[1])


def runs_of_bytes(name: str, content: bytes, stated: Mapping[str, Any]) -> list[Given]:
    """The columns in the bytes of a file; of every run in it where `run` is "all"."""
    if stated["run"] != ALL:
        return [of_bytes(name, content, stated)]
    first = of_bytes(name, content, {**stated, "run": None})
    if first.runs == 1:
        return [first]
    each = (of_bytes(name, content, {**stated, "run": run}) for run in range(1, first.runs + 1))
    return [given._replace(name=f"{given.name}, run {run}") for run, given in enumerate(each, start=1)]


def of_source(source: Any, values: Any, quantity: str, stated: Mapping[str, Any]) -> Given:
    """The columns of whatever was given, which is one record."""
    if stated["run"] == ALL:
        raise ValueError("run = 'all': is for fit_together; fit takes the number of one run")
    if isinstance(source, list) and values is None and source and not is_number(source[0]):
        raise TypeError(f"source: is a list of {len(source)}; fit_together takes several records")
    return of_each(source, values, quantity, stated)[0]


def is_number(each: Any) -> bool:
    """Whether it may be an element of a list of times, or a row of times and values."""
    return not isinstance(each, str | os.PathLike | tuple) and np.ndim(each) < 2 and not hasattr(each, "columns")


def of_each(source: Any, values: Any, quantity: str, stated: Mapping[str, Any]) -> list[Given]:
    """The columns of a source, which may be a file of several runs."""
    if isinstance(source, tuple) and len(source) == 2 and values is None:
        source, values = source
    if values is None and isinstance(source, np.ndarray) and source.ndim == 2 and source.shape[1] == 2:
        source, values = source.T
    if values is not None:
        needless = [name for name, each in stated.items() if each and name != "length"]
        if needless:
            advice = "; arrays are in s and rad: np.radians(values)" if needless[0] == "units" else ""
            raise ValueError(
                f"{needless[0]} = {shown(stated[needless[0]])}: is for files and data frames, not for arrays{advice}"
            )
        return [of_arrays(source, values, quantity)]
    try:
        if isinstance(source, str | os.PathLike):
            name = os.fspath(source)
            return runs_of_bytes(str(name), content_of(name), stated)
        if hasattr(source, "to_csv") or hasattr(source, "write_csv"):
            return runs_of_bytes(FRAME, frame_as_text(source), stated)
    except ValueError as error:
        raise ValueError(in_python(str(error))) from None
    raise TypeError(f"source = {shown(source)}: must be a path, a data frame, or times with their values beside them")


def in_python(message: str) -> str:
    """A message of the reader with the arguments of `fit` in the place of the command's options."""
    message = OPTION.sub(lambda found: f'{found[1]}s={{"{found[2]}": "{found[3].strip()}"}}', message)
    return PLAIN_OPTION.sub(lambda found: f"{found[1]}=" if found[2] else found[1], message)


def of_arrays(t: Any, values: Any, quantity: str) -> Given:
    """Two arrays of one dimension and one length, in SI units."""
    kinds = ("angle", "velocity", "acceleration", "gate", "swings")
    if quantity not in kinds:
        raise ValueError(f"quantity = {shown(quantity)}: must be one of {', '.join(kinds)}")
    columns = []
    for name, given in (("t", t), ("values", values)):
        array = reals(name, given)
        if array.ndim != 1:
            raise ValueError(f"{name}: has the shape {array.shape}; must have one dimension")
        columns.append(np.ascontiguousarray(array))
    if columns[0].size != columns[1].size:
        raise ValueError(f"t and values: have {columns[0].size} and {columns[1].size} elements; must have equally many")
    return Given(ARRAYS, quantity, columns, [], [])


def reals(name: str, given: Any) -> Any:
    """An array of doubles, NaN where a mask covers it."""
    kind = getattr(getattr(given, "dtype", None), "kind", "")
    if kind in ("M", "m"):
        seconds = "(t - t[0]) / np.timedelta64(1, 's')" if kind == "M" else f"{name} / np.timedelta64(1, 's')"
        raise TypeError(f"{name}: holds {'dates' if kind == 'M' else 'durations'}; must be real numbers, {seconds}")
    try:
        if kind == "c":
            raise TypeError
        return np.ma.filled(np.ma.asarray(given, dtype=float), np.nan)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name} = {shown(given)}: must be real numbers") from None
