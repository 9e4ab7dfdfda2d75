"""Ways to follow a bunch turn by turn: each prepares a call that moves the states, in place, by so many turns.

Between two turns a kick may come, so all stop at each one. Kicks and drifts in NumPy are written as fast as NumPy goes: nothing is
allocated in the loop, and nothing is wrapped. heyoka's integrator keeps the states of a batch, and goes to the end of each turn.
"""

import functools
from collections.abc import Callable

import numpy as np

import libration
from libration.ensemble._schemes import DRIFTS, KICKS

from .integrators import equations

Go = Callable[[np.ndarray, np.ndarray, int], None]
OURS = "libration: `advance`, once a turn"


def ours(dt: float) -> Go:
    """`libration.advance` with `out=`."""

    def go(theta, velocity, turns):
        for _ in range(turns):
            libration.advance(theta, velocity, dt, out=(theta, velocity))

    return go


def jump(dt: float) -> Go:
    """All turns at once."""

    def go(theta, velocity, turns):
        libration.advance(theta, velocity, turns * dt, out=(theta, velocity))

    return go


def sines(dt: float) -> Go:
    """The yardstick: a sine and a cosine by NumPy."""

    def go(theta, velocity, turns):
        out = np.empty_like(theta)
        for _ in range(turns):
            np.sin(theta, out=out)
            np.cos(theta, out=out)

    return go


def composed(dt: float, steps: int, drifts: tuple[float, ...], kicks: tuple[float, ...]) -> Go:
    """Kicks and drifts, `steps` compositions a turn; the kicks at the ends of two that meet are one, but for the turn's end."""
    step = dt / steps
    within = [*drifts] * steps
    halves = [kicks[0], *(kicks[1:-1] + (kicks[0] + kicks[-1],)) * (steps - 1), *kicks[1:]]

    def go(theta, velocity, turns):
        change = np.empty_like(theta)
        for _ in range(turns):
            for place, weight in enumerate(halves):
                if place:
                    np.multiply(velocity, within[place - 1] * step, out=change)
                    np.add(theta, change, out=theta)
                np.sin(theta, out=change)
                np.multiply(change, -weight * step, out=change)
                np.add(velocity, change, out=velocity)

    return go


def leapfrog(dt: float, steps: int) -> Go:
    """Half a kick, a drift, half a kick."""
    return composed(dt, steps, (1.0,), (0.5, 0.5))


def order8(dt: float, steps: int) -> Go:
    """The composition of 15 of these to order 8, which `track` has too."""
    return composed(dt, steps, DRIFTS, KICKS)


@functools.cache
def taylor(size: int, tolerance: float):
    """heyoka's integrator of `size` states at a time."""
    heyoka, system = equations()
    return heyoka.taylor_adaptive_batch(system, np.zeros((2, size)), tol=tolerance)


def heyoka(dt: float, size: int, tolerance: float) -> Go:
    """Batches, stopped at the end of each turn."""
    integrator = taylor(size, tolerance)

    def go(theta, velocity, turns):
        for first in range(0, len(theta), size):
            part = slice(first, first + size)
            integrator.set_time(0.0)
            integrator.state[:] = theta[part], velocity[part]
            for turn in range(turns):
                integrator.propagate_until((turn + 1) * dt)
            theta[part], velocity[part] = integrator.state

    return go


def ways(dt: float) -> dict[str, Callable[[], Go]]:
    """Every way by its name; a preparation may raise `NotAvailable`."""
    found: dict[str, Callable[[], Go]] = {
        OURS: lambda: ours(dt),
        "libration: one jump over all turns": lambda: jump(dt),
    }
    found["NumPy: kick and drift, 1 a turn"] = lambda: leapfrog(dt, 1)
    found["NumPy: kicks and drifts, 100 a turn"] = lambda: leapfrog(dt, 100)
    for steps in (1, 2, 3, 4, 5, 6):
        found[f"NumPy: order 8, {steps} a turn"] = functools.partial(order8, dt, steps)
    for size, tolerance in ((32, 1e-15), (256, 1e-15), (256, 1e-12)):
        found[f"heyoka: batches of {size}, tol {tolerance:.0e}"] = functools.partial(heyoka, dt, size, tolerance)
    found["NumPy: a sine and a cosine"] = lambda: sines(dt)
    return found
