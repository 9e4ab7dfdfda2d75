"""Orbits stated by their energy, their turning angle or their period, none of which is rounded to a velocity.

Source: Landau & Lifshitz, Mechanics, section 11; DLMF 22.19(i).
"""

from typing import Any, Self

from .. import _core
from .._messages import explained
from .._scalars import real, shown
from ._orbit import Orbit, frequency_given
from ._states import kind


class ByEnergy(Orbit):
    """The part of a `Pendulum` that makes one from an energy."""

    __slots__ = ()

    @classmethod
    @explained
    def from_energy(
        cls,
        *,
        energy_ratio: float | None = None,
        energy_ratio_c: float | None = None,
        energy: float | None = None,
        theta0: float | None = None,
        theta0_from_top: float | None = None,
        direction: float = 1,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        """Orbit with this energy, from the bottom upwards unless said otherwise.

        Next to the separatrix a velocity cannot say which motion is meant: between the last double below 2 omega0 and the
        first one above lie all with abs(1 - kappa**2) < 2e-16. Its complement says it to the last digit.

        Parameters
        ----------
        energy_ratio : scalar, exactly one of the three
            kappa**2, the energy over that at the top: finite and >= 0. 1 is the separatrix, 0 rests at the bottom.
        energy_ratio_c : scalar
            1 - kappa**2, finite and <= 1; below 0 in rotation.
        energy : scalar
            Per unit inertia, in rad**2/s**2, finite and >= 0: 0 at the stable equilibrium, 2 omega0**2 at the top.
        theta0 : scalar, optional
            Initial angle in rad that the energy reaches; the bottom if not given. The turning angle may be given as
            `theta_max` rounds it.
        theta0_from_top : scalar, optional
            The same less pi, instead of `theta0`; where omega2 is below 0, theta counts from the top already.
        direction : 1 or -1, default 1
            Whether it starts upwards or downwards.
        omega0, omega2, length, gravity : scalar, optional
            As for `Pendulum`. Without a force only `energy` is known.

        Returns
        -------
        Pendulum

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        `velocity0` is rounded; every other answer is that of the energy as given. Error promised: as for `Pendulum`.
        Source: Salas (23), solved for the velocity.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.Pendulum.from_energy(energy_ratio_c=1e-17)
        >>> print(pendulum.regime, f"{pendulum.period:.9f} {pendulum.velocity0}")
        libration 83.833070606 2.0
        """
        energies = {"energy_ratio": energy_ratio, "energy_ratio_c": energy_ratio_c, "energy": energy}
        given = {name: real(name, value) for name, value in energies.items() if value is not None}
        if len(given) != 1:
            named = " and ".join(given) or "none"
            raise ValueError(f"exactly one of energy_ratio, energy_ratio_c and energy must be given, not {named}")
        [(name, value)] = given.items()
        frequency = frequency_given(omega0, omega2, length, gravity)
        return cls._by("from_energy", given, name, value, (theta0, theta0_from_top, direction), frequency)

    @classmethod
    @explained
    def from_turning_angle(
        cls,
        theta_max: float | None = None,
        *,
        theta_max_from_top: float | None = None,
        theta0: float | None = None,
        theta0_from_top: float | None = None,
        direction: float = 1,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        """Orbit that turns back at this angle, from the bottom upwards unless said otherwise.

        Parameters
        ----------
        theta_max : scalar, exactly one of the two
            Turning angle in rad, counted from the stable equilibrium, from 0 to pi.
        theta_max_from_top : scalar
            pi less the turning angle, from 0 to pi: it keeps its digits next to the top; 0 is the separatrix.
        theta0, theta0_from_top, direction : scalar, optional
            Where it starts and whereto, as for `from_energy`.
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
        Error promised: as for `Pendulum`, from theta_max_from_top = 1e-290 on. Source: kappa = sin(theta_max/2), Landau &
        Lifshitz, Mechanics, section 11.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.Pendulum.from_turning_angle(2.0)
        >>> f"{pendulum.velocity0:.6f} {pendulum.theta(pendulum.period / 4):.6f}"
        '1.682942 2.000000'
        """
        angles = {"theta_max": theta_max, "theta_max_from_top": theta_max_from_top}
        given = {name: real(name, value) for name, value in angles.items() if value is not None}
        if len(given) != 1:
            named = "both" if given else "none"
            raise ValueError(f"exactly one of theta_max and theta_max_from_top must be given, not {named}")
        [(name, value)] = given.items()
        frequency = frequency_given(omega0, omega2, length, gravity)
        return cls._by("from_turning_angle", given, name, value, (theta0, theta0_from_top, direction), frequency)

    @classmethod
    @explained
    def from_period(
        cls,
        period: float,
        *,
        regime: str = "libration",
        theta0: float | None = None,
        theta0_from_top: float | None = None,
        direction: float = 1,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Self:
        """Orbit with this period, from the bottom upwards unless said otherwise.

        The inverse of `period`; a period does not tell the regime, so it is said.

        Parameters
        ----------
        period : scalar
            In s. Of a libration at least that of small swings, 2 pi/omega0, which rests, and up to 2676/omega0; of a turn
            above 0 and up to 1338/omega0. Infinite for the separatrix.
        regime : {"libration", "rotation"}, default "libration"
            Whether `period` is that of a full swing or of a turn.
        theta0, theta0_from_top, direction : scalar, optional
            Where it starts and whereto, as for `from_energy`.
        omega0, omega2, length, gravity : scalar, optional
            As for `Pendulum`. Without a force there is a period of rotation only.

        Returns
        -------
        Pendulum

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: as for `Pendulum`, plus what an ulp of the period makes of each value: next to 2 pi/omega0 the turning
        angle changes much. Source: Newton's method on the period's integral, DLMF 22.19(i), 19.4.1.

        Examples
        --------
        The swing that takes a quarter longer than small ones:

        >>> import math
        >>> import libration
        >>> f"{libration.Pendulum.from_period(1.25 * math.tau).theta_max:.9f}"
        '1.798085155'
        """
        if regime not in ("libration", "rotation"):
            raise ValueError(f"regime = {shown(regime)}: must be 'libration' or 'rotation'")
        given = {"period": real("period", period), **({"regime": "rotation"} if regime == "rotation" else {})}
        known = "rotation" if regime == "rotation" else "period"
        frequency = frequency_given(omega0, omega2, length, gravity)
        return cls._by("from_period", given, known, given["period"], (theta0, theta0_from_top, direction), frequency)

    @classmethod
    def _by(
        cls,
        method: str,
        given: dict[str, Any],
        known: str,
        value: Any,
        place: tuple[Any, Any, Any],
        frequency: dict[str, float],
    ) -> Self:
        """The orbit of what is known of it and of the place where it starts."""
        theta0, theta0_from_top, direction = place
        counted, angle = "bottom", 0.0
        if theta0 is not None and theta0_from_top is not None:
            raise ValueError("at most one of theta0 and theta0_from_top must be given, not both")
        if theta0 is not None:
            counted, angle = "theta", real("theta0", theta0)
            given = {**given, "theta0": angle}
        if theta0_from_top is not None:
            counted, angle = "from_top", real("theta0_from_top", theta0_from_top)
            given = {**given, "theta0_from_top": angle}
        sense = real("direction", direction)
        given = {**given, "direction": int(sense)} if sense in (1, -1) else given
        orbit = _core.Orbit.from_start(angle, value, sense, kind(counted, known), **frequency)
        return cls._made(orbit, method, given, frequency)
