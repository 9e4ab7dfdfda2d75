"""What is given to a fit, as columns: a file, a data frame, or arrays; and measures, which are values with uncertainties."""

import os
import re
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from .. import _core
from .._scalars import real, shown
from ._binary import as_text
from ._frames import frame_as_text

# The names of what is no file.
ARRAYS, FRAME = "arrays", "data frame"
# In place of the number of a run.
ALL = "all"
# As the messages of the reader name the options of the command.
OPTION = re.compile(r"--(column|unit) (\w+)=([^;,]+)")
PLAIN_OPTION = re.compile(r"--(rate|run|length)\b")


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
    if isinstance(given, tuple | list):
        if len(given) < 2:
            raise ValueError(f"{name} = {shown(given)}: must be a number or (value, standard uncertainty)")
        return real(name, given[0]), real(f"uncertainty of {name}", given[1])
    return real(name, given), 0.0


def stated_of(
    columns: Mapping[str, str] | None,
    units: Mapping[str, str] | None,
    rate: float | None,
    run: int | str | None,
    length: tuple[float, float] | None,
) -> dict[str, Any]:
    """What is stated about a file, as the reader takes it."""
    return {
        "columns": [f"{role}={name}" for role, name in (columns or {}).items()],
        "units": [f"{role}={unit}" for role, unit in (units or {}).items()],
        "rate": rate,
        "run": run,
        "length": length and length[0],
    }


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
            raise ValueError(
                f"{needless[0]} = {shown(stated[needless[0]])}: is for files and data frames, not for arrays"
            )
        return [of_arrays(source, values, quantity)]
    try:
        if isinstance(source, str | os.PathLike):
            name = os.fspath(source)
            with open(name, "rb") as file:
                content = file.read()
            return runs_of_bytes(str(name), content, stated)
        if hasattr(source, "to_csv") or hasattr(source, "write_csv"):
            return runs_of_bytes(FRAME, frame_as_text(source), stated)
    except ValueError as error:
        raise ValueError(in_python(str(error))) from None
    raise TypeError(f"source = {shown(source)}: must be a path, a data frame, or times with their values beside them")


def in_python(message: str) -> str:
    """A message of the reader with the arguments of `fit` in the place of the command's options."""
    message = OPTION.sub(lambda found: f'{found[1]}s={{"{found[2]}": "{found[3].strip()}"}}', message)
    return PLAIN_OPTION.sub(r"\1", message)


def of_arrays(t: Any, values: Any, quantity: str) -> Given:
    """Two arrays of one dimension and one length, in SI units."""
    kinds = ("angle", "velocity", "acceleration", "gate", "swings")
    if quantity not in kinds:
        raise ValueError(f"quantity = {shown(quantity)}: must be one of {', '.join(kinds)}")
    columns = []
    for name, given in (("t", t), ("values", values)):
        try:
            array = np.asarray(given, dtype=float)
        except (TypeError, ValueError):
            raise TypeError(f"{name} = {shown(given)}: must be real numbers") from None
        if array.ndim != 1:
            raise ValueError(f"{name}: has the shape {array.shape}; must have one dimension")
        columns.append(np.ascontiguousarray(array))
    if columns[0].size != columns[1].size:
        raise ValueError(f"t and values: have {columns[0].size} and {columns[1].size} elements; must have equally many")
    return Given(ARRAYS, quantity, columns, [], [])
