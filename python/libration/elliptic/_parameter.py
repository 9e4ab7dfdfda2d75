"""The parameter by exactly one keyword: ``m``, its complement ``mc = 1 - m``, the modulus ``k`` or the nome ``q``."""

from typing import Any

import numpy as np

from .. import _core


def ufuncs(name: str, keywords: tuple[str, ...] = ("m", "mc", "k")) -> dict[str, np.ufunc]:
    """The ufuncs of a function, one for every keyword."""
    return {keyword: getattr(_core, f"{name}_{keyword}") for keyword in keywords}


def chosen(table: dict[str, np.ufunc], **given: Any) -> tuple[np.ufunc, Any]:
    """The ufunc of the keyword that was given, and its value."""
    found = [(name, value) for name, value in given.items() if value is not None]
    if len(found) != 1:
        *others, last = given
        named = " and ".join(name for name, _ in found) or "none"
        raise ValueError(f"exactly one of {', '.join(others)} and {last} must be given, not {named}")
    [(name, value)] = found
    return table[name], value
