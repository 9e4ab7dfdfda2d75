"""Oscillators beside the pendulum: a set-up, a motion at many times, and rows with states of their own, on one thread.

The pendulum's kernel at 170° is the yardstick of a motion, np.cos that of rows, and a set-up stands by itself.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from cases.orbits import SEED

import libration

COUNT = 16_384  # times of one orbit: inputs and outputs stay in the second-level cache
ROWS = 20_000
MADE = 50  # set-ups a call
SETUP, MOTION, OWN = "set-up", "motion", "rows"
PENDULUM, COSINE = "pendulum at 170°", "np.cos"
DUFFING = {  # u0, velocity0, p, q, r, c
    "Duffing, libration": (1.0, 0.3, 1.0, 1.0, 0.0, 0.0),
    "Duffing, well": (1.2, 0.1, -1.0, 1.0, 0.0, 0.0),
    "Duffing, escape": (1.0, 0.3, -1.0, -1.0, 0.0, 0.0),
    "with r, libration": (1.0, 0.0, 1.0, 0.2, 0.5, 0.0),
    "with r and c, libration": (1.1, 0.3, 1.3, 0.21, 0.57, 0.11),
    "with r, well": (1.2, 0.1, -1.0, 1.0, 0.1, 0.0),
    "with r and c, escape": (1.7, 0.3, 1.3, -0.81, 0.57, 0.11),
}
QUINTIC = {  # u0, velocity0, p, q, s
    "cubic-quintic, libration": (1.0, 0.3, 1.0, 1.0, 1.0),
    "cubic-quintic, well": (1.2, 0.1, -1.0, 0.5, 1.0),
    "cubic-quintic, escape": (1.0, 0.3, -1.0, -1.0, -1.0),
}


@dataclass(frozen=True)
class Work:
    """One call: what it does `count` times, beside which peer, and the largest ratio or (of a set-up) nanoseconds that are asked for."""

    kind: str
    case: str
    count: int
    call: Callable[[], object]
    peer: str
    limit: float


def many(make: Callable[[], object]) -> Callable[[], object]:
    """MADE set-ups in one call."""
    return lambda: [make() for _ in range(MADE)]


def between(oscillator: object) -> np.ndarray:
    """COUNT times: between the escapes, or up to 100."""
    behind, ahead = max(oscillator.escape_time_backward, 0.0), min(oscillator.escape_time, 100.0)
    return behind + (ahead - behind) * (np.arange(COUNT) + 0.5) / COUNT


def works() -> tuple[list[Work], dict[str, tuple[int, Callable[[], object]]]]:
    """All calls, and the peers' with what they do."""
    pair = np.empty(COUNT), np.empty(COUNT)
    made = {name: partial(libration.Duffing, a, b, p=p, q=q, r=r, c=c) for name, (a, b, p, q, r, c) in DUFFING.items()}
    made |= {name: partial(libration.CubicQuintic, a, b, p=p, q=q, s=s) for name, (a, b, p, q, s) in QUINTIC.items()}
    found = [Work(SETUP, name, MADE, many(make), "", 3000.0) for name, make in made.items()]
    for name, make in made.items():
        oscillator = make()
        found.append(Work(MOTION, name, COUNT, partial(oscillator.motion, between(oscillator)), PENDULUM, 1.5))
    draw = np.random.default_rng(SEED).uniform
    t, u0, velocity0 = draw(0.0, 100.0, ROWS), draw(-3.14, 3.14, ROWS), draw(-3.0, 3.0, ROWS)
    p, q, r, c, s = (draw(low, high, ROWS) for low, high in ((-3, 3), (0.1, 3), (-1, 1), (-1, 1), (0.1, 3)))
    few = slice(ROWS // 10)
    rows = {
        "duffing_motion": (ROWS, partial(libration.duffing_motion, t, u0, velocity0, p, q), 100),
        "duffing_motion with r and c": (ROWS, partial(libration.duffing_motion, t, u0, velocity0, p, q, r=r, c=c), 100),
        "cubic_quintic_motion": (
            *(ROWS // 10, partial(libration.cubic_quintic_motion, t[few], u0[few], p=p[few], q=q[few], s=s[few])),
            250,
        ),
    }
    found += [Work(OWN, name, count, call, COSINE, limit / 8) for name, (count, call, limit) in rows.items()]
    times = np.linspace(0.0, 100.0, COUNT)
    theta0 = np.deg2rad(170.0)
    peers = {
        PENDULUM: (COUNT, partial(libration.motion, times, theta0, out=pair)),
        COSINE: (COUNT, partial(np.cos, times, out=pair[0])),
    }
    return found, peers
