"""Particles of a temperature: the density exp(-H/T) over phase space, H = velocity**2/2 + omega0**2 (1 - cos theta).

With k = omega0**2/T the angle has the density exp(-2 k sin**2(theta/2)), von Mises, and the velocity is normal of variance T. Inside the
separatrix alone, the density of the angle has the factor erf(sqrt(2 k) cos(theta/2)), and the normal ends at 2 omega0 cos(theta/2). The
inverse cumulative function of the angle is that of a density linear in each of 2**14 intervals, right to some 1e-6 of itself.
Source: Landau & Lifshitz, Statistical Physics 1, section 28; Devroye, Non-Uniform Random Variate Generation (1986), chapter 2.
"""

import importlib
import importlib.util
import math
from functools import lru_cache
from typing import Any

import numpy as np

from .._arrays import Floats

INTERVALS = 2**14
# Where the density is below a part in 2**52 of its maximum.
LAST = 40.0


def special() -> Any:
    """SciPy's functions of the normal distribution."""
    if importlib.util.find_spec("scipy") is None:
        raise ImportError("distribution = 'thermal': needs SciPy: pip install 'libration[ensemble]'")
    return importlib.import_module("scipy.special")


def thermal(temperature: float, omega0: float, rotations: bool, u: Floats) -> tuple[Floats, Floats]:
    """States of a temperature in rad**2/s**2, in librations only unless `rotations`; `u` are two rows of uniform numbers."""
    stiffness = (omega0 / math.sqrt(temperature)) ** 2
    theta = angle_of(stiffness, rotations, u[0])
    normal = special()
    inside = 1.0 if rotations else normal.erf(math.sqrt(2.0 * stiffness) * np.cos(0.5 * theta))
    return theta, math.sqrt(temperature) * normal.ndtri(0.5 + (u[1] - 0.5) * inside)


def angle_of(stiffness: float, rotations: bool, u: Floats) -> Floats:
    """Angle in [-pi, pi] that a fraction `u` of the particles is below."""
    nodes, densities, cumulative = tabled(stiffness, rotations)
    wanted = np.abs(2.0 * u - 1.0) * cumulative[-1]
    place = np.minimum(np.searchsorted(cumulative, wanted, side="right"), INTERVALS) - 1
    width = nodes[1] - nodes[0]
    start, slope = densities[place], (densities[place + 1] - densities[place]) / width
    rest = wanted - cumulative[place]
    # The root of start s + slope s**2/2 = rest in the form that does not cancel; 0 where nothing is left.
    root = np.sqrt(np.maximum(start * start + 2.0 * slope * rest, 0.0))
    step = np.divide(2.0 * rest, start + root, out=np.zeros_like(rest), where=rest > 0.0)
    angle: Floats = np.copysign(np.minimum(nodes[place] + step, nodes[-1]), u - 0.5)
    return angle


@lru_cache(maxsize=8)
def tabled(stiffness: float, rotations: bool) -> tuple[Floats, Floats, Floats]:
    """Angles from 0 on at equal distances, their densities, and the integrals of these."""
    end = 2.0 * math.asin(math.sqrt(min(1.0, 0.5 * LAST / stiffness)))
    nodes = np.linspace(0.0, end, INTERVALS + 1)
    densities = np.exp(-2.0 * stiffness * np.sin(0.5 * nodes) ** 2)
    if not rotations:
        densities *= special().erf(math.sqrt(2.0 * stiffness) * np.maximum(np.cos(0.5 * nodes), 0.0))
    steps = 0.5 * (densities[1:] + densities[:-1]) * (nodes[1] - nodes[0])
    return nodes, densities, np.concatenate([[0.0], np.cumsum(steps)])
