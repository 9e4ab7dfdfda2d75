"""What to write in place of a value that is no real number: the seconds of a time, the numbers of a quantity with units."""

import re
from typing import Any

import numpy as np

# The SI units of arguments, by their names; other arguments have none, or the user's.
UNITS = {
    "t": "s",
    "dt": "s",
    "start": "s",
    "stop": "s",
    "theta": "rad",
    "theta0": "rad",
    "theta0_from_top": "rad",
    "theta_from_top": "rad",
    "theta_max_from_top": "rad",
    "phase": "rad",
    "period": "s",
    "energy": "rad**2/s**2",
    "action": "rad**2/s",
    "theta_max": "rad",
    "phi": "rad",
    "velocity": "rad/s",
    "velocity0": "rad/s",
    "omega0": "rad/s",
    "omega2": "rad**2/s**2",
    "length": "m",
    "gravity": "m/s**2",
}
DEGREES = re.compile(r"\s*([+-]?[0-9]+(?:\.[0-9]*)?)\s*(?:deg|degree|degrees|°|º)\s*")


def advice(name: str, value: Any) -> str:
    """The end of a refusal: what to write for the argument `name`; empty where nothing is known."""
    written = _quantity(name, value) or _time(name, value) or _array(name, value) or _collection(name, value)
    return f"; write {written or _number(name, value)}" if written or _number(name, value) else ""


def has_units(value: Any) -> bool:
    """Whether a value is a quantity of pint, astropy, unyt or the like."""
    return _quantity("", value) != ""


def _quantity(name: str, value: Any) -> str:
    if isinstance(value, type):
        return ""
    unit = UNITS.get(name, "")
    if hasattr(value, "unit") and hasattr(value, "to_value"):
        return f"{name}.to_value({unit!r})"
    if hasattr(value, "units") and (hasattr(value, "magnitude") or hasattr(value, "to_value")):
        return f"{name}.to({unit!r}).magnitude"
    return ""


def _time(name: str, value: Any) -> str:
    """Differences of times, and dates."""
    if isinstance(value, type):
        return ""
    kind = element_kind(value)
    if kind == "m":
        return f"{name} / np.timedelta64(1, 's')"
    if kind == "M":
        start = f"{name}[0]" if getattr(value, "ndim", 0) else "start"
        return f"({name} - {start}) / np.timedelta64(1, 's')"
    if hasattr(value, "total_seconds"):
        return f"{name}.total_seconds()"
    if hasattr(value, "timetuple"):
        return f"({name} - start).total_seconds()"
    return ""


def _array(name: str, value: Any) -> str:
    """Arrays of other numbers, or of what can be made numbers."""
    kind = element_kind(value)
    if kind == "c":
        return f"np.real({name})"
    if kind == "f" and value.dtype.itemsize > 8:
        return f"{name}.astype(float)"
    if kind == "V" and value.dtype.names:
        return f"{name}[{value.dtype.names[0]!r}]"
    if kind in ("O", "U", "S", "T"):
        first = next(iter(np.ravel(np.asarray(value, dtype=object))), None)
        if hasattr(first, "total_seconds"):
            return f"[each.total_seconds() for each in {name}]"
        try:
            np.asarray(value, dtype=float)
        except (TypeError, ValueError, OverflowError):
            return ""
        return f"np.asarray({name}, dtype=float)"
    return ""


def _collection(name: str, value: Any) -> str:
    """Collections that are no sequences, and functions that were not called."""
    if isinstance(value, set | frozenset):
        return f"sorted({name})"
    if isinstance(value, dict):
        return f"list({name}.values())"
    if hasattr(value, "__next__") or type(value).__name__ in ("dict_keys", "dict_values", "map", "filter", "zip"):
        return f"list({name})"
    if callable(value) and not isinstance(value, type) and hasattr(value, "__name__"):
        return f"{value.__name__}(...), its result"
    return ""


def _number(name: str, value: Any) -> str:
    """Single values that are numbers of another kind, or their text."""
    if isinstance(value, complex):
        return f"{name}.real"
    if isinstance(value, str):
        if found := DEGREES.fullmatch(value):
            return f"np.radians({found[1]})" if UNITS.get(name) == "rad" else ""
        try:
            float(value)
        except ValueError:
            return ""
        return f"float({name})"
    if not isinstance(value, bool | int | float) and not hasattr(value, "dtype") and hasattr(value, "__float__"):
        return f"float({name})"
    return ""


def element_kind(value: Any) -> str:
    """The letter of NumPy for the kind of an array's elements; empty for what has none."""
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    return kind if isinstance(kind, str) else ""
