"""The exact Fourier series of a motion in its phase, and how far from harmonic it is."""

from typing import Any, NamedTuple

import numpy as np

from . import _core
from .dispatch import apply
from .fixed import count
from .orbit import Orbit


class Fourier(NamedTuple):
    """Amplitudes of the harmonics j = 1, 2, ...: of sin(j phase) in theta, of cos(j phase) in the velocity."""

    theta: np.ndarray
    velocity: np.ndarray


class Series(Orbit):
    """The series of one orbit."""

    __slots__ = ()

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


def harmonic_distortion(theta_max: Any, *, out: Any = None, where: Any = True) -> Any:
    """Loss of harmonicity of a swing: the norm of the higher harmonics of its angle, over the first.

    What `Pendulum.distortion` is for a swing as wide as `theta_max`: theta_max**2/192 when small, sqrt(pi**2/8 - 1) = 0.48 in
    the limit of pi, approached only with the logarithm of the distance.

    Parameters
    ----------
    theta_max : scalar or array
        Turning angle in rad, from 0 to pi; else NaN.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the shape of `theta_max`

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 22.11.1, integrated; Lima 2019 describes the loss.

    Examples
    --------
    >>> import numpy as np
    >>> import libration
    >>> libration.harmonic_distortion(np.radians([30.0, 90.0, 170.0])).round(6)
    array([0.001451, 0.015031, 0.116256])
    """
    return apply(_core.harmonic_distortion, theta_max, out=out, where=where)
