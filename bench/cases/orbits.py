"""The inputs of every comparison: orbits, times and states, as doubles, the same for every method of a run.

omega0 is 1 throughout: the angle depends on omega0 t only. Random numbers come from one seeded generator.
"""

import math
from dataclasses import dataclass

import numpy as np

SEED = 20190202
OMEGA0 = 1.0


@dataclass(frozen=True)
class Orbit:
    """An orbit by its initial state.

    Parameters
    ----------
    name : str
        As the page calls it.
    theta0, velocity0 : float
        State at t = 0, in rad and rad/s, with omega0 = 1.
    """

    name: str
    theta0: float
    velocity0: float = 0.0

    @property
    def period(self) -> float:
        """Period to about nine digits, which is enough to choose instants: nothing is compared with it."""
        s, c, half = math.sin(self.theta0 / 2), math.cos(self.theta0 / 2), self.velocity0 / 2
        mc = (c - half) * (c + half)
        if mc > 0:
            return 2 * math.pi / mean(1.0, math.sqrt(mc))
        return math.pi / mean(math.hypot(s, half), math.sqrt(-mc))

    @property
    def scale(self) -> float:
        """The largest |angle| of a libration; pi for a rotation."""
        kappa = math.hypot(math.sin(self.theta0 / 2), self.velocity0 / 2)
        return 2 * math.asin(kappa) if kappa < 1 else math.pi


def mean(a: float, b: float) -> float:
    """The arithmetic-geometric mean."""
    while abs(a - b) > 1e-12 * a:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


UP_TO_150 = [Orbit(f"{degrees:g}°", math.radians(degrees)) for degrees in (0.1, 30, 90, 150)]
BEYOND_150 = [
    Orbit("170°", math.radians(170)),
    Orbit("179.999°", math.radians(179.999)),
    Orbit("1 − κ² = 1e-12", 0.0, 2 * math.sqrt(1 - 1e-12)),
    Orbit("1 − κ² = −1e-12", 0.0, 2 * math.sqrt(1 + 1e-12)),
    Orbit("fast rotation", 0.5, 20.0),
]
ORBITS = UP_TO_150 + BEYOND_150
BY_NAME = {orbit.name: orbit for orbit in ORBITS}


def times(orbit: Orbit, count: int, periods: float, order: str = "sorted") -> np.ndarray:
    """`count` times over `periods` periods: equally spaced, or the same ones shuffled.

    A single time is that of a third of the span, which is nothing special for any orbit.
    """
    span = periods * orbit.period
    if count == 1:
        return np.array([span / 3])
    t = np.linspace(0.0, span, count)
    return t if order == "sorted" else np.random.default_rng(SEED).permutation(t)


def states(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Random states with a time each: theta0 in (-pi, pi), velocity0 in (-3, 3), t in (0, 100); all regimes."""
    random = np.random.default_rng(SEED)
    return random.uniform(-math.pi, math.pi, count), random.uniform(-3, 3, count), random.uniform(0, 100, count)


def sample(count: int, most: int) -> np.ndarray:
    """Which inputs are compared with the reference values: the first, the last and random ones between, in order."""
    if count <= most:
        return np.arange(count)
    inner = np.random.default_rng(SEED).choice(np.arange(1, count - 1), most - 2, replace=False)
    return np.sort(np.concatenate([[0], inner, [count - 1]]))
