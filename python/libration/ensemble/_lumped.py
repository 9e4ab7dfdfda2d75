"""Tune of the map that a ring with one cavity is: half a drift, a kick of the sine, half a drift, once a turn.

A mean over the angle that a state turns by each turn, weighted by exp(-1/(x (1 - x))), is right to many digits after some hundred
periods, where an unweighted one goes as one over them. The difference from the pendulum grows as qs**2 + O(qs**4): of a small qs it
is taken from two larger ones. Source: Lee, Accelerator Physics (2019), section 3.II; Das, Saiki, Sander & Yorke, Nonlinearity
30 (2017), 4111.
"""

import math

import numpy as np

from .._arrays import Floats
from ..pendulum import frequency

# Tunes below the first are extrapolated from these two; periods of small swings in a mean.
LARGE = (0.01, 0.02)
PERIODS = 150
# Two means over halves of the time that differ by more than this part are of no regular motion.
SAME = 1e-6


def lumped_tune(qs: float, theta_max: Floats) -> Floats:
    """Tune a turn of starts at rest at the angles `theta_max`, opposite to the cavity; NaN where there is none."""
    if qs >= LARGE[0]:
        return tune_of_the_map(qs, theta_max)
    pendulum = frequency(theta_max, 0.0)
    near, far = ((tune_of_the_map(each, theta_max) / each - pendulum) / each**2 for each in LARGE)
    slope = (far - near) / (LARGE[1] ** 2 - LARGE[0] ** 2)
    return qs * (pendulum + qs**2 * (near + slope * (qs**2 - LARGE[0] ** 2)))


def tune_of_the_map(qs: float, theta_max: Floats) -> Floats:
    """The tune by tracking, in whole; that of small amplitudes is asin(pi qs)/pi."""
    if math.pi * qs >= 1.0:
        return np.full_like(theta_max, np.nan)
    small = np.abs(theta_max) < 1e-9
    theta = np.where(small, 1e-9, np.abs(theta_max))
    scale = math.tau * qs
    momentum = np.zeros_like(theta)
    turns = 2 * math.ceil(PERIODS / (2 * qs))
    sums, weights = np.zeros((3, theta.size)), np.zeros(3)
    turned = np.zeros_like(theta)
    for turn in range(turns):
        # In units of velocity over omega0, so that small swings are circles but for O(qs**2).
        middle = theta + 0.5 * scale * momentum
        after = momentum - scale * np.sin(middle)
        moved = middle + 0.5 * scale * after
        step = np.arctan2(theta * after - momentum * moved, theta * moved + momentum * after)
        theta, momentum = moved, after
        turned = np.maximum(turned, np.abs(theta))
        for part, x in enumerate(((turn + 0.5) / turns, (2 * turn + 1) / turns, (2 * turn + 1) / turns - 1.0)):
            if 0.0 < x < 1.0:
                weight = math.exp(-1.0 / (x * (1.0 - x)))
                sums[part] -= weight * step
                weights[part] += weight
    whole, first, second = sums / weights[:, None] / math.tau
    regular = (turned < math.pi + 0.5 * scale) & (np.abs(first - second) <= SAME * np.abs(whole))
    return np.where(small, math.asin(math.pi * qs) / math.pi, np.where(regular, whole, np.nan))
