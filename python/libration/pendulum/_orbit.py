"""What an orbit is made of: its strict set-up from a state or from action and phase, kept in compiled form.

In _by_energy.py it is made from an energy, a turning angle or a period.
"""

import math
import sys
import warnings
from typing import Any, Self

import numpy as np

from .. import _core
from .._immutable import Immutable
from .._messages import explained
from .._scalars import radians, real
from ._states import kind

TWO_TURNS = 4 * math.pi


def _warn_of_radians(theta0: float) -> None:
    """Say how a large angle was taken, where the call comes from outside of this package."""
    # Above this function stand the constructor, what explains its errors, and the one who calls it.
    caller = sys._getframe(3).f_globals.get("__name__", "")
    if caller.partition(".")[0] == __name__.partition(".")[0]:
        return
    rest = math.remainder(theta0, math.tau)
    turns = round((theta0 - rest) / math.tau)
    warnings.warn(
        f"theta0 = {theta0!r} is in radians: {turns:.6g} whole turns and {math.degrees(rest):.4g} degrees; "
        f"for degrees write Pendulum.degrees({theta0!r})",
        UserWarning,
        stacklevel=4,
    )


def frequency_given(omega0: Any, omega2: Any, length: Any, gravity: Any) -> dict[str, float]:
    """The numbers that state the frequency, by name; those that are not given are left out."""
    given = {}
    if omega0 is not None:
        given["omega0"] = real("omega0", omega0)
    if omega2 is not None:
        given["omega2"] = real("omega2", omega2)
    if length is not None:
        given["length"] = real("length", length)
    if gravity is not None:
        given["gravity"] = real("gravity", gravity)
    return given


class Orbit(Immutable):
    """One orbit as it was given; `Pendulum` is its public name."""

    __slots__ = ("_frequency", "_operands", "_orbit", "_stated")

    _frequency: dict[str, float]
    # The method that made it, "" for the class itself, and its arguments but for the frequency.
    _stated: tuple[str, dict[str, Any]]
    _operands: tuple[np.ndarray, ...]
    _orbit: _core.Orbit

    @explained
    def __new__(
        cls,
        theta0: float | None = None,
        velocity0: float = 0.0,
        *,
        theta0_from_top: float | None = None,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        frequency = frequency_given(omega0, omega2, length, gravity)
        if theta0_from_top is not None:
            if theta0 is not None:
                raise ValueError("exactly one of theta0 and theta0_from_top must be given, not both")
            beyond = real("theta0_from_top", theta0_from_top)
            given = {"theta0_from_top": beyond, "velocity0": real("velocity0", velocity0)}
            start = beyond, given["velocity0"], 1.0, kind("from_top", "velocity")
            return cls._made(_core.Orbit.from_start(*start, **frequency), "", given, frequency)
        if theta0 is None:
            raise TypeError(f"{cls.__name__}() needs theta0, or theta0_from_top; the angle 0 is the bottom")
        theta0 = real("theta0", theta0)
        orbit = _core.Orbit(theta0, real("velocity0", velocity0), **frequency)
        if abs(theta0) > TWO_TURNS and velocity0 == 0:
            _warn_of_radians(theta0)
        return cls._made(orbit, "", {"theta0": orbit.theta0, "velocity0": orbit.velocity0}, frequency)

    @classmethod
    def _made(cls, orbit: _core.Orbit, by: str, given: dict[str, Any], frequency: dict[str, float]) -> Self:
        """The object of an orbit, with what it was made from."""
        self = super().__new__(cls)
        object.__setattr__(self, "_frequency", frequency or {"omega0": 1.0})
        # As arrays without dimensions: NumPy takes them as they are, in half the time it needs for Python's numbers.
        object.__setattr__(self, "_operands", tuple(map(np.asarray, orbit.operands)))
        object.__setattr__(self, "_orbit", orbit)
        object.__setattr__(self, "_stated", (by, given))
        return self

    @classmethod
    @explained
    def degrees(
        cls,
        theta0: float,
        velocity0: float = 0.0,
        *,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        """Orbit from an initial angle in degrees and an initial angular velocity in degrees per second.

        Everything the orbit answers is in radians. 180 degrees is pi, which no double is: ``theta0`` is then ``math.pi``, which
        is 1.2e-16 below, and the pendulum swings with a long period, as ``Pendulum(math.pi)`` does. So do all odd multiples:
        none of them rests upright.

        Parameters
        ----------
        theta0 : scalar
            Initial angle in degrees, finite.
        velocity0 : scalar, default 0.0
            Initial angular velocity in degrees per second, finite.
        omega0, omega2, length, gravity : scalar, optional
            As for `Pendulum`; omega0 is in rad/s.

        Returns
        -------
        Pendulum

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: 0.5 ulp of each of the two; `math.radians`, which rounds twice, is often an ulp off. Source: pi to 76
        digits, OEIS A000796.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.Pendulum.degrees(120, length=0.8)
        >>> f"{pendulum.theta0:.6f} rad, period {pendulum.period:.6f} s"
        '2.094395 rad, period 2.463754 s'
        """
        state = radians(real("theta0", theta0)), radians(real("velocity0", velocity0))
        return cls(*state, **frequency_given(omega0, omega2, length, gravity))

    @classmethod
    @explained
    def from_action_phase(
        cls,
        action: float,
        phase: float,
        *,
        direction: float = 0,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        """Orbit with this action and, at t = 0, this phase.

        The inverse of `action` and `phase`. An action does not tell the regime, so it is said: between 4 omega0/pi and
        8 omega0/pi both a libration and a rotation have it.

        Parameters
        ----------
        action : scalar
            In rad**2/s: from 0 and below 8 omega0/pi in libration, above 4 omega0/pi in rotation.
        phase : scalar
            In rad, finite, as `phase` gives it.
        direction : 0, 1 or -1, default 0
            0 for a libration, 1 and -1 for a rotation upwards and downwards.
        omega0, omega2, length, gravity : scalar, optional
            As for `Pendulum`.

        Returns
        -------
        Pendulum

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: 4 ulp of the largest angle and velocity, plus what an ulp of the action makes of them. Angles count
        from theta = 0. For omega2 < 0 the bottom is at pi: there theta0 is right to an ulp of pi, 4.4e-16, and the action of
        the orbit to omega0 (4.4e-16 theta_max + 2e-31) and 4 ulp. A narrower swing is lost. Source: Newton's method on the
        action's integrals, DLMF 19.4.1, 19.4.2.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.Pendulum.from_action_phase(1.0, 0.5)
        >>> f"{pendulum.theta0:.6f} {pendulum.action:.6f} {pendulum.phase(0.0):.6f}"
        '0.751444 1.000000 0.500000'
        """
        frequency = frequency_given(omega0, omega2, length, gravity)
        place = real("action", action), real("phase", phase), real("direction", direction)
        return cls(*_core.Orbit.state_of(*place, **frequency), **frequency)

    @property
    def theta0(self) -> float:
        """Initial angle in rad, as given, without error; rounded where it was given from the top."""
        return self._orbit.theta0

    @property
    def velocity0(self) -> float:
        """Initial angular velocity in rad/s, as given, without error; rounded where an energy or a period was given."""
        return self._orbit.velocity0

    @property
    def omega0(self) -> float:
        """Angular frequency of small swings in rad/s, the square root of the absolute value of `omega2`.

        Error promised: 1 ulp. Source: Salas (1).
        """
        return self._orbit.omega0

    @property
    def omega2(self) -> float:
        """Square of the angular frequency of small swings in 1/s**2; below 0 when hanging from the other side.

        Error promised: 1 ulp. Source: Salas (1).
        """
        return self._orbit.omega2

    @property
    def length(self) -> float | None:
        """Length in m, as given, without error; None where the frequency was given by `omega0` or `omega2`."""
        return self._frequency.get("length")

    @property
    def gravity(self) -> float | None:
        """Acceleration of gravity in m/s**2, without error: as given, or 9.80665 beside a `length`; None without one."""
        return self._orbit.operands[4] if "length" in self._frequency else None

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (), {**self._stated[1], **self._frequency}

    def _identity(self) -> tuple[Any, ...]:
        return self._orbit.operands

    def __repr__(self) -> str:
        by, _ = self._stated
        name = type(self).__name__
        return super().__repr__().replace(name, f"{name}.{by}", 1) if by else super().__repr__()

    def __reduce__(self) -> tuple[Any, ...]:
        by, given = self._stated
        attributes = getattr(self, "__dict__", None) or None
        return (_rebuilt, (type(self), by, given, self._frequency), attributes) if by else super().__reduce__()


def _rebuilt(made: type[Orbit], by: str, given: dict[str, Any], frequency: dict[str, float]) -> Orbit:
    """What a pickle or a copy makes of an orbit that a method made; it does not call the constructor of a subclass."""
    method: Any = getattr(made, by)
    orbit: Orbit = method(**given, **frequency)
    return orbit
