"""Data frames of pandas and Polars as text tables for the reader: an index that says something is a column, durations are in s."""

import io
from typing import Any


def frame_as_text(frame: Any) -> bytes:
    """The bytes of a text table with the columns of a data frame, or of a series of pandas beside its index."""
    if hasattr(frame, "to_csv"):
        return of_pandas(frame)
    durations = [name for name, kind in frame.schema.items() if type(kind).__name__ == "Duration"]
    written = io.BytesIO()
    frame.with_columns(*(frame[name].dt.total_microseconds() / 1e6 for name in durations)).write_csv(written)
    return written.getvalue()


def of_pandas(frame: Any) -> bytes:
    """The same of pandas."""
    table = frame if hasattr(frame, "columns") else frame.to_frame("values" if frame.name is None else frame.name)
    # Whole numbers without a name count the rows; anything else without one is the time.
    named = table.index.name is not None
    if named or table.index.dtype.kind in "fmM":
        table = table.rename_axis(table.index.name if named else "time").reset_index()
    for name in [name for name in table.columns if table[name].dtype.kind == "m"]:
        table = table.assign(**{str(name): table[name].dt.total_seconds()})
    return bytes(table.to_csv(index=False).encode())
