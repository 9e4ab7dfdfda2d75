"""One step of `track`, in place: the exact flow of the pendulum, or kicks and drifts composed to order 8.

The composition has 15 steps of second order, each half a kick, a drift and half a kick; the halves that meet are one kick, so a step
costs 15 sines. Error O(dt**9) a step, symmetric and symplectic. Source: Suzuki & Umeno, in Computer Simulation Studies in
Condensed-Matter Physics VI (1993), 74; McLachlan, SIAM J. Sci. Comput. 16 (1995), 151; Kahan & Li, Math. Comp. 66 (1997), 1089,
where it is s15odr8; Hairer, Lubich & Wanner, Geometric Numerical Integration (2006), V.3.11.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from .. import _core
from .._arrays import Floats, NDArray

Kick: TypeAlias = Callable[[Floats, float], object]
# The first half of the lengths of the 15 steps over dt, and the middle one; the rest are these from the end.
LENGTHS = (
    0.74167036435061295344822780,
    -0.40910082580003159399730010,
    0.19075471029623837995387626,
    -0.57386247111608226665638773,
    0.29906418130365592384446354,
    0.33462491824529818378495798,
    0.31529309239676659663205666,
    -0.79688793935291635401978884,
)
DRIFTS = (*LENGTHS, *LENGTHS[-2::-1])
KICKS = tuple(0.5 * (before + after) for before, after in zip((0.0, *DRIFTS), (*DRIFTS, 0.0), strict=True))
# Time of each kick over dt, from the start of the step.
TIMES = tuple(math.fsum(DRIFTS[:stage]) for stage in range(len(KICKS)))


def exact(theta: Floats, velocity: Floats, dt: float, omega0: float, phase: float) -> None:
    """The pendulum whose bottom is at the angle `phase`, a time `dt` on."""
    if phase:
        np.subtract(theta, phase, out=theta)
    _core.advance(theta, velocity, dt, omega0, out=(theta, velocity))
    if phase:
        np.add(theta, phase, out=theta)


def order8(
    theta: Floats,
    velocity: Floats,
    dt: float,
    omega0: float,
    phase: float,
    kick: Callable[[float, float], None] | None,
) -> None:
    """One step of the composition; ``kick(weight, time)`` adds that part of the user's kick to the velocity."""
    force = -dt * omega0 * omega0
    change = np.empty_like(theta)
    for stage, weight in enumerate(KICKS):
        # What grows beyond the doubles is NaN in the end, without a warning.
        with np.errstate(over="ignore", invalid="ignore"):
            if stage:
                np.multiply(velocity, DRIFTS[stage - 1] * dt, out=change)
                np.add(theta, change, out=theta)
            if force:
                np.sin(theta - phase if phase else theta, out=change)
                np.multiply(change, weight * force, out=change)
                np.add(velocity, change, out=velocity)
        if kick:
            kick(weight, TIMES[stage])


def wrap(theta: Floats, turns: NDArray[np.int64]) -> None:
    """Takes whole turns from the angles, which then are in [-pi, pi), and adds them to `turns`; NaN stays NaN.

    The double nearest to pi is below pi, and in that range.
    """
    _core.wrap(theta, turns)
