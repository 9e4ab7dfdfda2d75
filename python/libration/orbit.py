"""What an orbit object is made of: its strict set-up, kept in compiled form, its identity and its pickle.

What can be asked of it stands by topic: pendulum.py, passages.py, action_angle.py, derivatives.py, series.py.
"""

from operator import index
from typing import Any, NoReturn, Self

import numpy as np

from . import _core


class Orbit:
    """One orbit, which does not change; `Pendulum` is its public name."""

    __slots__ = ("_frequency", "_operands", "_orbit")

    _frequency: tuple[tuple[str, float], ...]
    _operands: tuple[np.ndarray, ...]
    _orbit: _core.Orbit

    def __new__(
        cls,
        theta0: float,
        velocity0: float = 0.0,
        *,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        given = {"omega0": omega0, "omega2": omega2, "length": length, "gravity": gravity}
        frequency = {name: real(name, value) for name, value in given.items() if value is not None}
        orbit = _core.Orbit(real("theta0", theta0), real("velocity0", velocity0), **frequency)
        self = super().__new__(cls)
        object.__setattr__(self, "_frequency", tuple(frequency.items()) or (("omega0", 1.0),))
        # As arrays without dimensions: NumPy takes them as they are, in half the time it needs for Python's numbers.
        object.__setattr__(self, "_operands", tuple(map(np.asarray, orbit.operands)))
        object.__setattr__(self, "_orbit", orbit)
        return self

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change: cannot set {name}")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change: cannot delete {name}")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Orbit):
            return NotImplemented
        return self._orbit.operands == other._orbit.operands

    def __hash__(self) -> int:
        return hash(self._orbit.operands)

    def __repr__(self) -> str:
        frequency = ", ".join(f"{name}={value!r}" for name, value in self._frequency)
        return f"{type(self).__name__}(theta0={self._orbit.theta0!r}, velocity0={self._orbit.velocity0!r}, {frequency})"

    def __reduce__(self) -> tuple[Any, ...]:
        arguments = type(self), self._orbit.theta0, self._orbit.velocity0, dict(self._frequency)
        return _rebuilt, arguments, getattr(self, "__dict__", None) or None


def _rebuilt(kind: type[Orbit], theta0: float, velocity0: float, frequency: dict[str, float]) -> Orbit:
    """An orbit from what its pickle or copy holds: the arguments, whatever a subclass makes of its own."""
    return Orbit.__new__(kind, theta0, velocity0, **frequency)


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
    if getattr(value, "ndim", 0):
        shown = f"an array of shape {value.shape}"
    else:
        shown = " ".join(repr(value).split())
        shown = shown if len(shown) <= 60 else f"{shown[:57]}..."
    raise ValueError(f"{name} = {shown}: must be one real number, a Python or NumPy scalar")


def count(name: str, value: Any) -> int:
    """``value`` as an int of 64 bits if it is a whole number, else a ``ValueError`` that names the argument."""
    try:
        if isinstance(value, bool | np.bool):
            raise TypeError
        whole = index(value)
    except TypeError:
        raise ValueError(f"{name} = {value!r}: must be a whole number") from None
    return min(max(whole, -(2**63)), 2**63 - 1)
