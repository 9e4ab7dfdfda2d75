"""Motions as tables: of pandas or polars, whichever is there, of Arrow otherwise."""

from __future__ import annotations

import importlib
import sys
from typing import Any, ClassVar

import numpy as np

from ._advice import advice, element_kind
from ._scalars import shown
from ._units import plain

LIBRARIES = ("pandas", "polars", "pyarrow")
MISSING = "a table needs pandas, polars or pyarrow: pip install pandas"


class Tabled:
    """What gives its motion as a table."""

    __slots__ = ()

    # The functions of time whose values are columns, with their units; those of the pair that `motion` gives first.
    _columns: ClassVar[tuple[tuple[str, str | None], ...]] = (("theta", "rad"), ("velocity", "rad/s"))

    def to_dataframe(self, t: Any, library: str | None = None) -> Any:
        """The motion at the times `t` as a table, a row an instant and a column for `t` and for each function of it.

        Parameters
        ----------
        t : array of one dimension
            Time in s. A series of pandas gives its index to the rows.
        library : str, optional
            `pandas`, `polars` or `pyarrow`. By default that of `t`; else the one that the program has imported, in this order; else
            the first that is installed.

        Returns
        -------
        pandas.DataFrame, polars.DataFrame or pyarrow.Table
            Columns of float64 under the names of the methods; `attrs["units"]` of pandas and the metadata of the fields of Arrow have
            their units.

        Raises
        ------
        ImportError
            If none of the three is installed, or not the one that is asked for.
        ValueError
            If `t` has no or several dimensions, or `library` is none of those.

        Notes
        -----
        The same digits as the methods.

        Examples
        --------
        >>> import numpy as np
        >>> from libration import Pendulum
        >>> frame = Pendulum(3.0, length=1.0).to_dataframe(np.linspace(0.0, 2.0, 3), library="pandas")
        >>> print(frame.round(4))
             t  theta  velocity
        0  0.0  3.000    0.0000
        1  1.0  1.603   -4.3342
        2  2.0 -2.698   -1.3044
        """
        times = instants(t)
        motion: Any = self
        values = dict(zip((name for name, _ in self._columns[:2]), motion.motion(times), strict=True))
        values |= {name: getattr(self, name)(times) for name, _ in self._columns[2:]}
        units: dict[str, str | None] = {"t": "s", **dict(self._columns)}
        return table({"t": times} | values, units, chosen(t, library), t)


def instants(t: Any) -> np.ndarray:
    """The instants as an array of doubles."""
    given = plain("t", t)
    if hasattr(given, "iloc"):
        given = given.to_numpy(dtype=float, na_value=np.nan)
    times = np.asarray(given)
    if times.dtype.kind not in "biuf" or element_kind(given) in ("M", "m"):
        raise TypeError(f"t = {shown(t)}: must be real numbers{advice('t', t)}")
    if times.ndim != 1:
        raise ValueError(f"t of {times.ndim} dimensions: must have one, a row an instant; write np.ravel(t)")
    return times.astype(float)


def chosen(t: Any, library: str | None) -> Any:
    """The library of a table, loaded."""
    if library is not None:
        if library not in LIBRARIES:
            raise ValueError(f"library = {shown(library)}: must be {', '.join(LIBRARIES[:-1])} or {LIBRARIES[-1]}")
        try:
            return importlib.import_module(library)
        except ModuleNotFoundError as error:
            raise ImportError(f"a table of {library} needs it: pip install {library}") from error
    own = type(t).__module__.partition(".")[0]
    if own in LIBRARIES:
        return importlib.import_module(own)
    for name in sorted(LIBRARIES, key=lambda name: name not in sys.modules):
        try:
            return importlib.import_module(name)
        except ModuleNotFoundError:
            continue
    raise ImportError(MISSING)


def table(values: dict[str, np.ndarray], units: dict[str, str | None], library: Any, t: Any) -> Any:
    """The columns as a table of a library."""
    if library.__name__ == "pandas":
        frame = library.DataFrame(values, index=getattr(t, "index", None) if hasattr(t, "iloc") else None)
        frame.attrs["units"] = {name: unit for name, unit in units.items() if unit is not None}
        return frame
    if library.__name__ == "polars":
        return library.DataFrame(values)
    fields = [
        library.field(name, library.float64(), metadata={"units": units[name]} if units[name] else None)
        for name in values
    ]
    return library.table([library.array(each) for each in values.values()], schema=library.schema(fields))
