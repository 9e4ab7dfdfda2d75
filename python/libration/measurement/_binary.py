"""Files that a library of their own reads, as text tables for the reader: MATLAB by SciPy, Parquet by pandas."""

import csv
import importlib
import io
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np

INSTALL = "pip install 'libration[files]'"
# Of a matrix, as many columns at most are series of a record.
MOST_COLUMNS = 16
# Fewer values are parameters, no record.
LEAST_ROWS = 8


def as_text(content: bytes) -> bytes:
    """The bytes of a text table in the place of a MATLAB or Parquet file; other bytes as they are."""
    if content.startswith(b"PAR1"):
        frame = needed("pandas", "a Parquet file").read_parquet(io.BytesIO(content))
        return bytes(frame.to_csv(index=False).encode())
    if content.startswith(b"MATLAB 5.0"):
        loaded = needed("scipy.io", "a MATLAB file").loadmat(
            io.BytesIO(content), squeeze_me=True, struct_as_record=False
        )
        return table([each for name, value in loaded.items() if name[:2] != "__" for each in vectors(name, value)])
    return content


def needed(package: str, kind: str) -> Any:
    """A package, or a ValueError that says how to install it."""
    try:
        return importlib.import_module(package)
    except ModuleNotFoundError as error:
        raise ValueError(f"{kind} needs {package.partition('.')[0]}: {INSTALL}") from error


def vectors(name: str, value: Any) -> Iterator[tuple[str, np.ndarray]]:
    """Every series of numbers in a value of MATLAB, with its path of names."""
    if hasattr(value, "_fieldnames"):
        # A signal of Simulink says its name beside its values.
        label = getattr(value, "label", "")
        if isinstance(label, str) and label and hasattr(value, "values"):
            yield from vectors(label, value.values)
            return
        for field in value._fieldnames:
            yield from vectors(f"{name}.{field}", getattr(value, field))
        return
    array = np.asarray(value)
    if array.dtype == object:
        for number, each in enumerate(array.ravel()[:MOST_COLUMNS], start=1):
            yield from vectors(f"{name}{{{number}}}", each)
    elif array.dtype.kind in "iufb" and array.size >= LEAST_ROWS:
        if array.ndim == 1:
            yield name, array
        elif array.ndim == 2 and min(array.shape) <= MOST_COLUMNS:
            columns = array if array.shape[0] >= array.shape[1] else array.T
            yield from ((f"{name}({number})", column) for number, column in enumerate(columns.T, start=1))


def table(series: list[tuple[str, np.ndarray]]) -> bytes:
    """The series of the length that most have, the longer of two, as a text table."""
    if not series:
        raise ValueError("a MATLAB file without a series of at least 8 numbers")
    lengths = Counter(values.size for _, values in series)
    most = max(lengths, key=lambda size: (lengths[size] > 1, size))
    chosen = [(name, values) for name, values in series if values.size == most]
    text = io.StringIO()
    writer = csv.writer(text)
    # Two series that are equal would leave a question that has no answer.
    kept: list[tuple[str, np.ndarray]] = []
    for name, values in chosen:
        if not any(np.array_equal(values, other) for _, other in kept):
            kept.append((name, values))
    writer.writerow([name for name, _ in kept])
    writer.writerows(zip(*(values.tolist() for _, values in kept), strict=True))
    return text.getvalue().encode()
