"""Quantities of pint, astropy, unyt and the like, taken as their numbers in the units of this package.

The library of the quantity converts it, with its own rounding; what does not convert is refused, and the right unit named. Hertz are no
radians per second, though libraries that count radians as pure numbers convert one into the other: they are refused.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from ._advice import UNITS, has_units

# The SI unit of what has none here, and of what is a number in the user's units.
NONE = ""


def plain(name: str, value: Any) -> Any:
    """The number, or the array of numbers, of a quantity in the unit of the argument `name`; what has no units stays as it is.

    Raises
    ------
    ValueError
        If the quantity does not convert, in one line that names the unit.
    """
    if not has_units(value):
        return value
    unit = UNITS.get(name, NONE)
    own = str(getattr(value, "units", getattr(value, "unit", "")))
    if unit.startswith("rad") and ("hertz" in own.lower() or "hz" in own.lower()):
        raise ValueError(f"{name} in {own}: must be in {unit}; a frequency in Hz is 2 pi times as many rad/s")
    for each in (unit, *without_radians(unit)):
        try:
            return value.to_value(each) if hasattr(value, "to_value") else value.to(each).magnitude
        except Exception:
            # Each library has errors of its own for this.
            continue
    must = f"must be in {unit}, or in what converts to it" if unit else "must be a number without units"
    raise ValueError(f"{name} in {own or 'no unit'}: {must}")


def without_radians(unit: str) -> list[str]:
    """The same unit for libraries in which radians do not convert into numbers."""
    return (
        [{"rad": "", "rad/s": "1/s", "rad**2/s**2": "1/s**2"}[unit]] if unit in ("rad", "rad/s", "rad**2/s**2") else []
    )


def plain_call(
    function: Callable[..., Any], arguments: tuple[Any, ...], keywords: dict[str, Any]
) -> tuple[tuple[Any, ...], dict[str, Any]] | None:
    """The arguments of a call with plain numbers in the place of quantities; None if there is no quantity."""
    given = [*arguments, *keywords.values()]
    if not any(map(has_units, given)):
        return None
    try:
        bound = inspect.signature(function).bind(*arguments, **keywords)
    except TypeError:
        return None
    names = {id(value): name for name, value in bound.arguments.items()}
    positional = tuple(plain(names.get(id(value), ""), value) for value in arguments)
    return positional, {name: plain(name, value) for name, value in keywords.items()}
