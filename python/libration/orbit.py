"""What an orbit object is made of: its strict set-up, kept in compiled form, its identity and its pickle.

What can be asked of it stands by topic: pendulum.py, passages.py, action_angle.py, derivatives.py, series.py.
"""

from typing import Any, Self

import numpy as np

from . import _core
from .fixed import Fixed, real


class Orbit(Fixed):
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
