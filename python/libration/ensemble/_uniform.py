"""Uniform numbers of particles: those of a particle depend on the seed and on its number, and on nothing else.

Particle i has the counter i of Philox4x64-10 (Salmon et al., SC11, 2011), whose key is the seed: four words of 64 bits, of which
two are used. So any part of a bunch can be made anywhere, in any order. A quiet start takes an additive recurrence in
place of the generator: multiples of 1/rho and 1/rho**2, rho**3 = rho + 1, modulo 1, shifted by the seed. They fill the unit
square evenly, so sums over particles are nearer to their means. It is exact in integers. Source: Niederreiter, Random Number
Generation and Quasi-Monte Carlo Methods (1992), chapter 3; Birdsall & Langdon, Plasma Physics via Computer Simulation (1991), chapter 16.
"""

import numpy as np

from .. import _core
from .._arrays import Floats, NDArray

# Keys of Philox have two words: the seed, and what its words are for; 0 are the particles.
SHIFT = 1
# 2**64 over rho and over rho**2, to an odd number.
STEPS = np.array([13925035116211876495, 10511698010929265437], dtype=np.uint64)


def uniforms(seed: int, first: int, count: int, quiet: bool) -> Floats:
    """Two rows of `count` numbers in the open interval (0, 1): particles `first`, `first` + 1 and so on."""
    if not quiet:
        rows = np.empty((2, count))
        _core.uniforms(seed, first, *rows)
        return rows
    # The middle of one of 2**52 equal intervals: never 0 or 1, and u and 1 - u are as likely.
    return (np.right_shift(recurrence(seed, first, count), np.uint64(12)).astype(float) + 0.5) * 2.0**-52


def recurrence(seed: int, first: int, count: int) -> NDArray[np.uint64]:
    """Terms of the additive recurrence; whole numbers of 64 bits wrap around, which is modulo 1."""
    shift = np.random.Philox(key=np.array([seed, SHIFT], dtype=np.uint64)).random_raw(2)
    # By an array: that of one number would warn of the wrap.
    terms = np.uint64(first) + np.arange(count, dtype=np.uint64)
    return shift[:, None] + STEPS[:, None] * terms
