"""Distributions over the action, which stay as they are: densities, inverse cumulative functions, and their rms angle.

A density over phase space that depends on the action J alone does not change as the pendulums swing: phases are spread evenly, and
a fraction u of the particles has a smaller action. With x = J/scale, and X the action of the separatrix over the scale:

    waterbag    density 1          x < 1    x = u
    parabolic   density 1 - x      x < 1    x = 1 - sqrt(1 - u)
    gaussian    density exp(-x)    x < X    x = -log(1 - u (1 - exp(-X)))

The scale of a given rms angle is found by integrals over the energy ratio m, dJ = (4/pi) omega0 K(m) dm. Source: Lee, Accelerator
Physics (2019), sections 3.II and 3.V; Landau & Lifshitz, Mechanics, section 49; Takahasi & Mori, Publ. RIMS 9 (1974), 721.
"""

import math
from functools import lru_cache

import numpy as np

from .. import _core
from .._arrays import Floats
from ..elliptic import complete_k, nome
from ..pendulum import action, from_action_phase

# Action of the separatrix over omega0, and the rms angle of a bucket that is filled evenly.
EDGE = 8 / math.pi
FULL = math.sqrt(math.pi**2 - 8)
SHAPES = ("gaussian", "waterbag", "parabolic")
# Where exp(-x) is below a part in 2**52 of the whole.
LAST = 40.0


def ratio_of(shape: str, u: Floats, edge: float) -> Floats:
    """Action over the scale that a fraction `u` of the particles is below; `edge` is X, and may be infinite."""
    if shape == "waterbag":
        return u
    if shape == "parabolic":
        # 1 - sqrt(1 - u) without its cancellation.
        return u / (1.0 + np.sqrt(1.0 - u))
    ratio = np.empty_like(u)
    _core.exponential(u, math.expm1(-edge), ratio)
    return ratio


def density(shape: str, ratio: Floats) -> Floats:
    """Density at actions over the scale, up to the last that there is."""
    if shape == "waterbag":
        return np.ones_like(ratio)
    return 1.0 - ratio if shape == "parabolic" else np.exp(-ratio)


def rms(shape: str, scale: float) -> float:
    """Rms angle of a matched bunch whose scale, over omega0, is given."""
    actions, squares, weights = over_energies(min(scale * (LAST if shape == "gaussian" else 1.0), EDGE))
    weights = weights * density(shape, actions / scale)
    return math.sqrt(np.sum(weights * squares) / np.sum(weights))


@lru_cache(maxsize=8)
def largest_rms(shape: str) -> float:
    """The rms angle that bunches of this shape inside the bucket stay below, or reach."""
    return rms(shape, EDGE) if shape == "parabolic" else FULL


@lru_cache(maxsize=64)
def scale_of(shape: str, sigma_theta: float) -> float:
    """The scale, over omega0, whose matched bunch has this rms angle; the caller has seen that there is one. Kept: chunks ask again."""
    # Small bunches have sigma**2 of 1, 1/2 and 1/3 of the scale; larger ones never have twice that.
    low, high = 0.5 * sigma_theta**2, 1e12 if shape == "gaussian" else EDGE
    while low < (middle := math.sqrt(low * high)) < high:
        low, high = (middle, high) if rms(shape, middle) < sigma_theta else (low, middle)
    return low


@lru_cache(maxsize=8)
def over_energies(last: float) -> tuple[Floats, Floats, Floats]:
    """Actions over omega0 from 0 to `last`, the mean square angle of each, and the weights of an integral over dJ.

    The double exponential rule takes the logarithm of K at the separatrix in its stride.
    """
    turning, _ = from_action_phase(last, 0.5 * math.pi)
    top = 1.0 if last >= EDGE else math.sin(0.5 * float(turning)) ** 2
    step = np.arange(-128, 129) / 32.0
    exponent = math.pi * np.sinh(step)
    part, rest = 1.0 / (1.0 + np.exp(-exponent)), 1.0 / (1.0 + np.exp(exponent))
    kept = np.minimum(part, rest) > 1e-60
    m, mc = top * part[kept], (1.0 - top) + top * rest[kept]
    weights = (part * rest * np.cosh(step))[kept]
    low = m < 0.5
    quarter = np.where(low, complete_k(m=np.where(low, m, 0.5)), complete_k(mc=np.where(low, 0.5, mc)))
    q = np.where(low, nome(m=np.where(low, m, 0.5)), nome(mc=np.where(low, 0.5, mc)))
    return action(0.0, 2.0 * np.sqrt(m)), mean_square(q), weights * quarter


def mean_square(q: Floats) -> Floats:
    """Mean square angle of librations by their nome: Parseval's sum over the Fourier series of the angle."""
    total = np.zeros_like(q)
    odd, largest = 1, 1.0
    while largest > 1e-18:
        power = q**odd
        term = 32.0 * power / (odd * (1.0 + power)) ** 2
        total += term
        largest = float(np.max(term))
        odd += 2
    return total
