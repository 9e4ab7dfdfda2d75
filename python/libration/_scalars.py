"""The strict reading of one number: refused in one line that names the argument, its value and what is allowed."""

from operator import index
from typing import Any

import numpy as np

from ._advice import advice, has_units
from ._units import plain

# The functions that take arrays of what a constructor takes one of.
OF_ARRAYS = {"theta0": "libration.motion", "velocity0": "libration.motion", "u0": "libration.duffing_motion"}


def real(name: str, value: Any) -> float:
    """``value`` as a float if it is one real number, else a ``ValueError`` that names the argument."""
    if type(value) is float:
        return value
    kind = getattr(getattr(value, "dtype", None), "kind", None)
    single = kind is not None and kind in "iuf" and getattr(value, "ndim", None) == 0
    if single or (isinstance(value, int | float) and not isinstance(value, bool)):
        try:
            return float(value)
        except OverflowError:
            raise ValueError(f"{name} = an integer beyond the doubles: must be finite") from None
        except TypeError:
            # A number with a unit of astropy.
            pass
    if has_units(value):
        return real(name, plain(name, value))
    several = OF_ARRAYS.get(name) if getattr(value, "ndim", 0) or isinstance(value, list | tuple) else None
    hint = f"; {several} takes arrays" if several else advice(name, value)
    raise ValueError(f"{name} = {shown(value)}: must be one real number, a Python or NumPy scalar{hint}")


def radians(degrees: float) -> float:
    """The double nearest to an angle in degrees as radians."""
    from decimal import Context, Decimal

    # Of pi/180; a product of 60 digits leaves one rounding to a double.
    factor = Decimal("0.0174532925199432957692369076848861271344287188854172545609719144017100911460")
    return float(Context(prec=60).multiply(Decimal(degrees), factor))


def count(name: str, value: Any) -> int:
    """``value`` as an int of 64 bits if it is a whole number, else a ``ValueError`` that names the argument."""
    try:
        if isinstance(value, bool | np.bool):
            raise TypeError
        whole = index(value)
    except TypeError:
        raise ValueError(f"{name} = {shown(value)}: must be a whole number") from None
    if not -(2**63) <= whole < 2**63:
        raise ValueError(f"{name} = an integer beyond 64 bits: must be in range")
    return whole


def shown(value: Any) -> str:
    """A value as it stands in an error: on one line, and short."""
    if getattr(value, "ndim", 0):
        return f"an array of shape {value.shape}"
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"{text[:57]}..."
