"""A stationary bucket of a ring in the units of the machine, and the pendulum that its particles are.

A particle zeta ahead of the middle (m) with the relative momentum error delta has the angle theta = 2 pi h zeta/C, and on the average
over a turn theta'' = -omega0**2 sin theta, omega0 = 2 pi qs/T0, qs**2 = h abs(eta q) V/(2 pi beta**2 E): the limit of small qs
of the map of a cavity that kicks once a turn. E is the whole energy, eta = alpha_c - 1/gamma**2 the slip factor, above transition positive.
Source: Lee, Accelerator Physics (2019), section 3.II; Chao et al., Handbook of Accelerator Physics and Engineering (2013), 2.1.
"""

import math
from typing import Any, Self

import numpy as np

from .._arrays import Floats
from .._immutable import Immutable
from .._messages import explained
from .._scalars import count, real, shown
from ..pendulum import frequency
from ._bunch import bunch, positive
from ._density import SHAPES, largest_rms
from ._lumped import lumped_tune
from ._values import inside, real_numbers

LIGHT = 299_792_458.0  # The speed of light in m/s, exact since 1983.


class Bucket(Immutable):
    """The stationary bucket of a ring: tunes, size, and the way to the pendulum and back.

    Parameters
    ----------
    voltage : scalar
        Amplitude of the voltage a turn in V, positive.
    harmonic : int
        Periods of the voltage a turn, positive.
    energy : scalar
        Whole energy of a particle in eV, above `mass`.
    mass : scalar
        Rest energy in eV, positive.
    charge : scalar
        In elementary charges, of either sign, not 0.
    circumference : scalar
        Of the ring in m, positive.
    momentum_compaction : scalar
        Relative change of length of the orbit over that of the momentum, 1/gamma_t**2; of any sign, not at transition.
    synchronous_phase : scalar, default 0.0
        In rad: 0 or pi, where the middle of the bucket gains no energy.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    The pendulum stands for a cavity spread around the ring; `lumped_tune` tells by how much one cavity differs. A bucket does not
    change; it is hashable. Error promised: 4 ulp, of eta times what its difference cancels next to transition. Source: Lee, Accelerator Physics (2019), section 3.II.

    Examples
    --------
    The LHC at injection:

    >>> from libration import ensemble
    >>> lhc = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
    >>> print(f"{lhc.qs:.5f} {lhc.omega0 / 6.283185:.1f} Hz {lhc.area:.2f} eV s {lhc.height:.1e}")
    0.00566 63.7 Hz 1.43 eV s 1.0e-03
    """

    __slots__ = (
        "charge",
        "circumference",
        "energy",
        "harmonic",
        "mass",
        "momentum_compaction",
        "synchronous_phase",
        "voltage",
    )

    voltage: float
    harmonic: int
    energy: float
    mass: float
    charge: float
    circumference: float
    momentum_compaction: float
    synchronous_phase: float

    @explained
    def __new__(
        cls,
        voltage: float,
        harmonic: int,
        energy: float,
        mass: float,
        charge: float,
        circumference: float,
        momentum_compaction: float,
        *,
        synchronous_phase: float = 0.0,
    ) -> Self:
        made = object.__new__(cls)
        given: dict[str, Any] = {
            "voltage": positive("voltage", voltage),
            "harmonic": count("harmonic", harmonic),
            "energy": positive("energy", energy),
            "mass": positive("mass", mass),
            "charge": real("charge", charge),
            "circumference": positive("circumference", circumference),
            "momentum_compaction": real("momentum_compaction", momentum_compaction),
            "synchronous_phase": real("synchronous_phase", synchronous_phase),
        }
        for name, value in given.items():
            object.__setattr__(made, name, value)
        made._check()
        return made

    def _check(self) -> None:
        """Refuses what is no stationary bucket."""
        if self.harmonic < 1:
            raise ValueError(f"harmonic = {self.harmonic}: must be positive")
        if self.energy <= self.mass:
            raise ValueError(f"energy = {self.energy!r}: must be the whole energy in eV, above mass, {self.mass!r}")
        for name in ("charge", "momentum_compaction"):
            if not math.isfinite(value := getattr(self, name)):
                raise ValueError(f"{name} = {value!r}: must be finite")
        if self.charge == 0.0:
            raise ValueError("charge = 0.0: must not be 0")
        if self.synchronous_phase not in (0.0, math.pi):
            raise ValueError(
                f"synchronous_phase = {self.synchronous_phase!r}: must be 0 or pi, a stationary bucket; an accelerating one has no"
                " elliptic solution: take track(..., scheme='order8') or DampedPendulum(torque=)"
            )
        if self.slip_factor == 0.0:
            raise ValueError(
                f"momentum_compaction = {self.momentum_compaction!r}: must not be 1/gamma**2; there is no bucket at transition"
            )
        for name in ("qs", "area", "height"):
            if not 0.0 < getattr(self, name) < math.inf:
                raise ValueError(f"{name} = {getattr(self, name)!r} of these numbers: must be within the doubles")

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        ring = self.voltage, self.harmonic, self.energy, self.mass, self.charge, self.circumference
        keyword = {"synchronous_phase": self.synchronous_phase} if self.synchronous_phase else {}
        return (*ring, self.momentum_compaction), keyword

    @property
    def _beta2(self) -> float:
        """Square of the speed over that of light, without the cancellation of 1 - 1/gamma**2."""
        return (self.energy - self.mass) / self.energy * ((self.energy + self.mass) / self.energy)

    @property
    def revolution_frequency(self) -> float:
        """Turns a second, in Hz.

        Error promised: 4 ulp. Source: Lee, Accelerator Physics (2019), chapter 3.
        """
        return math.sqrt(self._beta2) * LIGHT / self.circumference

    @property
    def slip_factor(self) -> float:
        """eta = alpha_c - 1/gamma**2: relative change of the time of a turn over that of the momentum; positive above transition.

        Error promised: 4 ulp. Source: Lee, Accelerator Physics (2019), chapter 3.
        """
        return self.momentum_compaction - (self.mass / self.energy) ** 2

    @property
    def qs(self) -> float:
        """Synchrotron tune of small amplitudes: periods a turn, sqrt(h abs(eta q) V/(2 pi beta**2 E)).

        Error promised: 4 ulp. Source: Lee, Accelerator Physics (2019), chapter 3.
        """
        force = self.harmonic * abs(self.slip_factor) * (abs(self.charge) * self.voltage / self.energy)
        return math.sqrt(force / (math.tau * self._beta2))

    @property
    def omega0(self) -> float:
        """Angular frequency of small amplitudes, in rad/s.

        Error promised: 4 ulp. Source: Lee, Accelerator Physics (2019), chapter 3.
        """
        return math.tau * self.qs * self.revolution_frequency

    @property
    def height(self) -> float:
        """Half height of the bucket in delta: 2 qs/(h abs(eta)).

        Error promised: 4 ulp. Source: Lee, Accelerator Physics (2019), chapter 3.
        """
        return 2.0 * self.qs / (self.harmonic * abs(self.slip_factor))

    @property
    def area(self) -> float:
        """Area of the bucket over energy and time, in eV s: 16 qs beta**2 E/(2 pi f0 h**2 abs(eta)).

        Error promised: 4 ulp. Source: Lee, Accelerator Physics (2019), chapter 3.
        """
        return 16.0 * self.omega0 * self._area_of_action

    @property
    def _area_of_action(self) -> float:
        """eV s in one rad**2/s of dtheta dvelocity."""
        angle, velocity = self._factors
        return math.sqrt(self._beta2) * self.energy / LIGHT / abs(angle * velocity)

    @property
    def _factors(self) -> tuple[float, float]:
        """theta over zeta, velocity over delta."""
        turn = math.tau * self.harmonic
        return turn / self.circumference, -turn * self.revolution_frequency * self.slip_factor

    @explained
    def tune(self, theta_max: Any) -> Any:
        """Synchrotron tune at an amplitude, of the pendulum: the cavity spread around the ring.

        Parameters
        ----------
        theta_max : scalar or array
            Largest angle in rad, in (-pi, pi); else NaN.

        Returns
        -------
        float64 or ndarray
            Periods a turn.

        Notes
        -----
        qs pi/(2 K(sin**2(theta_max/2))). Source: Lee, Accelerator Physics (2019), section 3.II.

        Examples
        --------
        >>> from libration import ensemble
        >>> lhc = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
        >>> lhc.tune([0.0, 2.0]).round(6)
        array([0.005664, 0.004262])
        """
        return self.qs * frequency(inside(theta_max), 0.0)

    @explained
    def lumped_tune(self, theta_max: Any) -> Any:
        """Synchrotron tune at an amplitude, of the map: one cavity, one kick a turn.

        Tracked for some hundred periods, which takes a tenth of a second or more; what it differs from `tune` by is physics, and
        grows as ``qs**2``: asin(pi qs)/(pi qs) - 1 for small amplitudes.

        Parameters
        ----------
        theta_max : scalar or array
            Angle in rad of a start at rest opposite to the cavity, in (-pi, pi).

        Returns
        -------
        float64 or ndarray
            Periods a turn; NaN where the motion is not regular, or leaves the bucket.

        Notes
        -----
        A weighted mean of the angle a turn. Source: Das, Saiki, Sander & Yorke, Nonlinearity 30 (2017), 4111.

        Examples
        --------
        >>> from libration import ensemble
        >>> ring = ensemble.Bucket(1.5e6, 400, 3e9, 510998.95, -1, 400.0, 1.2e-3)
        >>> print(f"{ring.qs:.4f} {ring.lumped_tune(1.0) / ring.tune(1.0) - 1:.1e}")
        0.0062 3.4e-05
        """
        wanted = np.asarray(inside(theta_max))
        known = np.abs(wanted.ravel()) < math.pi
        tunes = np.full(wanted.size, np.nan)
        tunes[known] = lumped_tune(self.qs, wanted.ravel()[known])
        return tunes.reshape(wanted.shape)[()]

    @explained
    def to_pendulum(self, zeta: Any, delta: Any) -> Any:
        """States of the pendulum for places in the bucket: ``(theta, velocity)``.

        Parameters
        ----------
        zeta : scalar or array
            How far a particle is ahead of the middle, in m.
        delta : scalar or array
            Relative momentum error.

        Returns
        -------
        pair of float64 or ndarray
            Angle in rad and angular velocity in rad/s, for the frequency `omega0`.

        Examples
        --------
        >>> from libration import ensemble
        >>> lhc = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
        >>> theta, velocity = lhc.to_pendulum(0.1, 1e-4)
        >>> print(f"{theta:.4f} {velocity / lhc.omega0:.4f}")
        0.8400 -0.2002
        """
        angle, velocity = self._factors
        return np.multiply(real_numbers(zeta), angle), np.multiply(real_numbers(delta), velocity)

    @explained
    def from_pendulum(self, theta: Any, velocity: Any) -> Any:
        """Places in the bucket for states of the pendulum: ``(zeta, delta)``.

        Parameters
        ----------
        theta : scalar or array
            Angle in rad.
        velocity : scalar or array
            Angular velocity in rad/s.

        Returns
        -------
        pair of float64 or ndarray
            How far a particle is ahead of the middle, in m, and its relative momentum error.

        Examples
        --------
        >>> from libration import ensemble
        >>> lhc = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
        >>> zeta, delta = lhc.from_pendulum(0.84, 0.0)
        >>> f"{zeta:.4f} {abs(delta):.4f}"
        '0.1000 0.0000'
        """
        angle, factor = self._factors
        return np.divide(real_numbers(theta), angle), np.divide(real_numbers(velocity), factor)

    @explained
    def matched(
        self,
        n: int,
        *,
        seed: int,
        emittance: float | None = None,
        bunch_length: float | None = None,
        distribution: str = "gaussian",
        quiet: bool = False,
        first: int = 0,
    ) -> tuple[Floats, Floats]:
        """A bunch that stays as it is: ``(zeta, delta)``.

        Parameters
        ----------
        n : int
            How many particles.
        seed : int
            As for `bunch`.
        emittance : scalar, optional
            Area in eV s, positive and below `area`: the whole of a waterbag or parabolic bunch; for a gaussian one 4 pi J0, which
            is 4 pi times the rms length times the rms energy of a short bunch.
        bunch_length : scalar, optional
            Rms of zeta in m, positive; either this or `emittance`.
        distribution : {"gaussian", "waterbag", "parabolic"}, default "gaussian"
            As for `bunch`.
        quiet : bool, default False
            As for `bunch`.
        first : int, default 0
            As for `bunch`.

        Returns
        -------
        pair of ndarray
            Of shape ``(n,)``.

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Examples
        --------
        >>> from libration import ensemble
        >>> lhc = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
        >>> zeta, delta = lhc.matched(100_000, bunch_length=0.1124, seed=1)
        >>> print(f"{zeta.std():.4f} m {delta.std():.2e}")
        0.1122 m 3.75e-04
        """
        if distribution not in SHAPES:
            raise ValueError(f"distribution = {shown(distribution)}: must be one of {', '.join(SHAPES)}")
        if (emittance is None) == (bunch_length is None):
            both = "no width" if emittance is None else "emittance and bunch_length"
            raise ValueError(f"{both} given: matched takes one of emittance=, bunch_length=")
        known: dict[str, Any] = {"distribution": distribution, "seed": seed, "omega0": self.omega0, "quiet": quiet}
        if emittance is not None:
            size = positive("emittance", emittance)
            if size >= self.area:
                raise ValueError(
                    f"emittance = {size!r}: must be positive and below the area of the bucket, {self.area:.6g} eV s"
                )
            known["action"] = size / ((2.0 if distribution == "gaussian" else 1.0) * math.tau * self._area_of_action)
        else:
            length = positive("bunch_length", bunch_length)
            last = largest_rms(distribution) / self._factors[0]
            if length >= last:
                raise ValueError(
                    f"bunch_length = {length!r}: must be positive and below {last:.6g} m, an rms of the full bucket"
                )
            known["sigma_theta"] = length * self._factors[0]
        zeta, delta = self.from_pendulum(*bunch(n, first=first, **known))
        return zeta, delta
