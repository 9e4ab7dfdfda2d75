"""What an orbit keeps: its regime, period, reach, energy, action, frequency and Fourier series."""

from enum import StrEnum

from .._messages import explained
from .._scalars import count
from ._by_energy import ByEnergy
from ._fourier import Fourier


class Regime(StrEnum):
    """The four kinds of motion; a member compares equal to its string.

    Examples
    --------
    >>> Regime.LIBRATION == "libration"
    True
    """

    REST = "rest"
    LIBRATION = "libration"
    SEPARATRIX = "separatrix"
    ROTATION = "rotation"


class Constants(ByEnergy):
    """The part of a `Pendulum` that does not depend on time."""

    __slots__ = ()

    @property
    def regime(self) -> Regime:
        """Kind of motion: rest, libration, separatrix or rotation, decided without error for the doubles passed."""
        return Regime(self._orbit.regime)

    @property
    def period(self) -> float:
        """Period in s: 2 pi/omega0 at rest, infinite on the separatrix, the time of one turn in rotation.

        In libration 4 K(kappa**2)/omega0, in rotation 2 K(1/kappa**2)/(kappa omega0). Error promised: 4 ulp, half of
        all values 0.5 ulp, plus 2**-100 of its condition. Source: DLMF 22.19(i), 19.8.5.
        """
        return self._orbit.period

    @property
    def theta_max(self) -> float:
        """Turning angle in rad, 2 asin(kappa), counted from the stable equilibrium.

        Pi on the separatrix, NaN in rotation, which does not turn back. Error promised: 4 ulp. Source: 2 atan2 of
        kappa and sqrt(1 - kappa**2).
        """
        return self._orbit.theta_max

    @property
    def energy_ratio(self) -> float:
        """Energy over the energy at the top, kappa**2 = sin(theta0/2)**2 + (velocity0/(2 omega0))**2.

        Infinite in free rotation. Error promised: 4 ulp. Source: Salas (23), where it is m.
        """
        return self._orbit.energy_ratio

    @property
    def energy_ratio_c(self) -> float:
        """Complement 1 - kappa**2, computed directly: it has all its digits next to the separatrix too.

        Minus infinity in free rotation. Error promised: 4 ulp plus 2**-150 of its condition. Source:
        (c - x)(c + x), c = cos(theta0/2), x = velocity0/(2 omega0).
        """
        return self._orbit.energy_ratio_c

    @property
    def energy(self) -> float:
        """Energy per unit inertia in rad**2/s**2, velocity**2/2 + omega0**2 (1 - cos(theta)).

        Zero at the stable equilibrium. Error promised: 4 ulp. Source: Lima (4), divided by the inertia.
        """
        return self._orbit.energy

    @property
    def extremes(self) -> tuple[float, float]:
        """Lowest and highest angle in rad that the orbit reaches, in its own turn.

        Infinite in rotation, the limits on the separatrix, both the angle itself at rest. Error promised: 4 ulp. Source:
        `theta_max`, on both sides of the stable equilibrium.
        """
        return self._orbit.extremes

    @property
    def action(self) -> float:
        """Action in rad**2/s, the closed integral of velocity dtheta over 2 pi, never negative.

        In libration 8 omega0/pi (E(m) - (1 - m) K(m)) with m = kappa**2, in rotation 4 omega0/pi kappa E(1/m), on the
        separatrix 8 omega0/pi. Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 19.2(ii).
        """
        return self._orbit.action

    @property
    def frequency(self) -> float:
        """Mean angular frequency in rad/s, 2 pi over the period.

        Negative in rotation downwards, 0 on the separatrix, omega0 at rest. Error promised: 4 ulp, plus 2**-100 of its
        condition. Source: DLMF 22.19(i).
        """
        return self._orbit.frequency

    @explained
    def fourier(self, n: int) -> Fourier:
        """First `n` amplitudes of the exact Fourier series of angle and velocity in the phase.

        In libration theta = sum of theta[j - 1] sin(j phase) about the bottom it swings about; the even ones are zero. In
        rotation the angle has the phase, and the velocity the frequency, beside the sum. ``velocity[j - 1]`` is
        ``j * frequency * theta[j - 1]``, and the mean of velocity**2, by Parseval, is action times abs(frequency).

        Parameters
        ----------
        n : int
            How many harmonics, from 1 to 10 million.

        Returns
        -------
        Fourier
            Two arrays of length n, in rad and rad/s. NaN on the separatrix, zero at rest.

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: 4 ulp of each amplitude, plus 2**-100 of its condition. Source: DLMF 22.11.1, 22.11.3,
        integrated.

        Examples
        --------
        >>> import libration
        >>> pendulum = libration.Pendulum(3.0)
        >>> pendulum.fourier(5).theta.round(6)
        array([3.352945, 0.      , 0.415048, 0.      , 0.074976])
        >>> f"{pendulum.distortion:.6f}"
        '0.125883'
        """
        return Fourier(*self._orbit.fourier(count("n", n)))

    @property
    def distortion(self) -> float:
        """Harmonic distortion of the angle: the norm of its harmonics from the second on, over the first.

        In rotation that of what the angle has beside its phase; 0 at rest, NaN on the separatrix. Error promised: 4 ulp, plus
        2**-100 of its condition. Source: the series of `fourier`.
        """
        return self._orbit.distortion
