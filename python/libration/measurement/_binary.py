"""Files that a library of their own reads, as text tables for the reader: MATLAB by SciPy and h5py, Parquet by pyarrow."""

import csv
import importlib
import io
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

import numpy as np

Series: TypeAlias = list[tuple[str, np.ndarray]]

INSTALL = "pip install 'libration[files]'"
# Of a matrix, as many columns at most are series of a record.
MOST_COLUMNS = 16
# Fewer values are parameters, no record.
LEAST_ROWS = 8


def as_text(content: bytes) -> bytes:
    """The bytes of a text table in the place of a MATLAB or Parquet file; other bytes as they are."""
    for mark, kind, packages, read in READERS:
        if content.startswith(mark):
            modules = [needed(package, kind) for package in packages]
            try:
                found = read(content, *modules)
            except Exception as error:
                # Libraries of binary files raise whatever their damage is.
                reason = " ".join(str(error).split()) or type(error).__name__
                raise ValueError(f"{kind} that cannot be read: {reason[:200]}") from error
            return found if isinstance(found, bytes) else table(found)
    return content


def of_parquet(content: bytes, parquet: Any, compute: Any, text: Any) -> bytes:
    """The columns of a Parquet file, durations in s."""
    columns = parquet.read_table(io.BytesIO(content))
    for place, field in enumerate(columns.schema):
        if str(field.type).startswith("duration"):
            nanoseconds = columns.column(place).cast("duration[ns]").cast("int64")
            columns = columns.set_column(place, field.name, compute.divide(nanoseconds.cast("float64"), 1e9))
    written = io.BytesIO()
    text.write_csv(columns, written)
    return written.getvalue()


def of_matlab(content: bytes, reader: Any) -> Series:
    """The series of a MATLAB file up to version 7."""
    loaded = reader.loadmat(io.BytesIO(content), squeeze_me=True, struct_as_record=False)
    return [each for name, value in loaded.items() if name[:2] != "__" for each in vectors(name, value)]


def of_hdf5(content: bytes, hdf5: Any) -> Series:
    """The series of a MATLAB file of version 7.3, which is HDF5; its matrices are transposed there, which columns do not mind."""
    found: Series = []

    def visited(name: str, value: Any) -> None:
        if isinstance(value, hdf5.Dataset) and not name.startswith("#"):
            found.extend(vectors(name.replace("/", "."), np.squeeze(value[()])))

    with hdf5.File(io.BytesIO(content), "r") as file:
        file.visititems(visited)
    return found


# The first bytes, what it is, the packages that read it, and how.
READERS: tuple[tuple[bytes, str, tuple[str, ...], Callable[..., "bytes | Series"]], ...] = (
    (b"PAR1", "a Parquet file", ("pyarrow.parquet", "pyarrow.compute", "pyarrow.csv"), of_parquet),
    (b"MATLAB 5.0", "a MATLAB file", ("scipy.io",), of_matlab),
    (b"MATLAB 7.3", "a MATLAB file of version 7.3", ("h5py",), of_hdf5),
)


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


def table(series: Series) -> bytes:
    """The series of the length that most have, the longer of two, as a text table."""
    if not series:
        raise ValueError("a MATLAB file without a series of at least 8 numbers")
    lengths = Counter(values.size for _, values in series)
    most = max(lengths, key=lambda size: (lengths[size] > 1, size))
    chosen = [(name, values) for name, values in series if values.size == most]
    text = io.StringIO()
    writer = csv.writer(text)
    # Two series that are equal would leave a question that has no answer.
    kept: Series = []
    for name, values in chosen:
        if not any(np.array_equal(values, other) for _, other in kept):
            kept.append((name, values))
    writer.writerow([name for name, _ in kept])
    writer.writerows(zip(*(values.tolist() for _, values in kept), strict=True))
    return text.getvalue().encode()
