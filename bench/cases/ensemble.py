"""A bunch that is followed turn by turn: omega0 dt = 0.3, and where some of its particles are after 1,000 turns, by mpmath.

The truth is theta = 2 asin(k sn(u0 + t)), k**2 = sin(theta0/2)**2 + (velocity0/2)**2, sn u0 = sin(theta0/2)/k, cn u0 = velocity0/2k,
with 50 digits (DLMF 22.19.2), and never our own.
"""

import math

import mpmath
import numpy as np

from libration import ensemble

DT, TURNS = 0.3, 1000
# A chunk that stays in the cache, as all ways have it; those of its particles whose truth is known.
COUNT, KNOWN = 8192, 64


def bunch() -> tuple[np.ndarray, np.ndarray]:
    """Evenly filled up to 0.95 of the energy at the top."""
    return ensemble.bunch(COUNT, distribution="waterbag", energy_ratio=0.95, seed=1)


def truth() -> np.ndarray:
    """Angles of the first particles after TURNS turns, each of the double DT."""
    theta0, velocity0 = (column[:KNOWN].tolist() for column in bunch())
    with mpmath.workdps(50):
        return np.array([float(angle(*state, mpmath.mpf(DT) * TURNS)) for state in zip(theta0, velocity0, strict=True)])


def angle(theta0: float, velocity0: float, t):
    """Angle of a libration with omega0 = 1."""
    sine, half = mpmath.sin(mpmath.mpf(theta0) / 2), mpmath.mpf(velocity0) / 2
    m = sine**2 + half**2
    k = mpmath.sqrt(m)
    start = mpmath.ellipf(mpmath.atan2(sine, half), m)
    return 2 * mpmath.asin(k * mpmath.ellipfun("sn", start + t, m=m))


def gap(theta: np.ndarray, true: np.ndarray) -> float:
    """The largest distance of angles, modulo 2 pi."""
    apart = theta[: len(true)] - true
    return float(np.abs(apart - math.tau * np.round(apart / math.tau)).max())
