"""What a pendulum with friction and torque is made of: its strict set-up, kept in compiled form."""

from __future__ import annotations

from typing import Any, Self

from .. import _core
from .._immutable import Immutable
from .._messages import explained
from .._scalars import real, shown
from ..pendulum._orbit import frequency_given
from ._friction import Friction
from ._torque import Torque


class SetUp(Immutable):
    """A pendulum with friction and torque as it was given; `DampedPendulum` is its public name."""

    __slots__ = ("_damped", "_frequency", "_friction", "_start", "_torque")

    _damped: _core.DampedPendulum
    _frequency: dict[str, float]
    _friction: Friction
    _start: tuple[float, float]
    _torque: Torque

    @explained
    def __new__(
        cls,
        theta0: float,
        velocity0: float = 0.0,
        *,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
        friction: Friction | None = None,
        torque: Torque | None = None,
    ) -> Self:
        frequency = frequency_given(omega0, omega2, length, gravity)
        start = real("theta0", theta0), real("velocity0", velocity0)
        friction = Friction() if friction is None else friction
        torque = Torque() if torque is None else torque
        if not isinstance(friction, Friction):
            raise ValueError(f"friction = {shown(friction)}: must be a Friction")
        if not isinstance(torque, Torque):
            raise ValueError(f"torque = {shown(torque)}: must be a Torque")
        self = super().__new__(cls)
        terms, samples = torque._operands()
        made = _core.DampedPendulum(*start, friction._terms, terms, samples, **frequency)
        object.__setattr__(self, "_damped", made)
        object.__setattr__(self, "_frequency", frequency or {"omega0": 1.0})
        object.__setattr__(self, "_friction", friction)
        object.__setattr__(self, "_start", start)
        object.__setattr__(self, "_torque", torque)
        return self

    @property
    def theta0(self) -> float:
        """Initial angle in rad, as given, without error."""
        return self._start[0]

    @property
    def velocity0(self) -> float:
        """Initial angular velocity in rad/s, as given, without error."""
        return self._start[1]

    @property
    def friction(self) -> Friction:
        """Friction, as given."""
        return self._friction

    @property
    def torque(self) -> Torque:
        """Torque, as given."""
        return self._torque

    @property
    def omega0(self) -> float:
        """Angular frequency of small undamped swings in rad/s, the square root of the absolute value of `omega2`.

        Error promised: 1 ulp. Source: Salas (1).
        """
        return self._damped.frequency[0]

    @property
    def omega2(self) -> float:
        """Its square in 1/s**2; below 0 when hanging from the other side.

        Error promised: 1 ulp. Source: Salas (1).
        """
        return self._damped.frequency[1]

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        start = {"theta0": self.theta0, "velocity0": self.velocity0}
        return (), {**start, **self._frequency, "friction": self._friction, "torque": self._torque}

    def _identity(self) -> tuple[Any, ...]:
        return (*self._start, *sorted(self._frequency.items()), self._friction, self._torque)
