"""What a run must show: each demand with the ratio asked, the worst ratio measured, where it was, and whether it holds.

Ratios are medians over rounds of ours / theirs, within one run; the worst of the orbits named in the work is judged.
"""

import math
import statistics
from dataclasses import dataclass

from cases import GENTLE, STEEP
from rivals.formulas import LINEAR, SCIPY, SCIPY_MOTION, SINE_COSINE
from rivals.ours import MOTION, THETA
from timing import ratio

MILLION = 10**6
UP_TO_150 = [orbit.name for orbit in GENTLE]
BEYOND = [orbit.name for orbit in STEEP]
EASIER, SMALL = ["90°", "150°", "170°"], ["0.1°", "30°"]


@dataclass(frozen=True)
class Demand:
    """One line of the table.

    Parameters
    ----------
    work : str
        What is divided by what.
    asked : float
        The largest ratio allowed.
    found : dict
        Ratio by case; empty if the run has none, which does not hold.
    """

    work: str
    asked: float
    found: dict[str, float]

    @property
    def worst(self) -> tuple[str, float]:
        """The case with the largest ratio, and that ratio."""
        return max(self.found.items(), key=lambda item: item[1], default=("not measured", math.inf))

    @property
    def holds(self) -> bool:
        """Whether the worst ratio is within what is asked."""
        return self.worst[1] <= self.asked


def pairs(records: list[dict], ours: str, theirs: str, cases: list[str]) -> dict[str, float]:
    """Ratio of two ways in each of the cases, at a full count in all rounds."""
    held = {(record["case"], record["way"]): record for record in records if record["seconds"]}
    found = {}
    for case in cases:
        a, b = held.get((case, ours)), held.get((case, theirs))
        found[case] = ratio(a["seconds"], b["seconds"]) if a and b and a["count"] == b["count"] else math.inf
    return found


def heyoka(records: list[dict], ours: str) -> dict[str, float]:
    """Ours against the fastest of heyoka's ways that did all the samples, orbit after orbit."""
    found = {}
    for case in dict.fromkeys(record["case"] for record in records):
        here = [r for r in records if r["case"] == case and r["seconds"] and r["count"] == MILLION]
        rivals = [r for r in here if r["way"].startswith("heyoka")]
        mine = [r for r in here if r["way"] == ours]
        if rivals and mine:
            fastest = min(rivals, key=lambda r: statistics.median(r["seconds"]))
            found[case] = ratio(mine[0]["seconds"], fastest["seconds"])
    return found


def two(records: list[dict], few: str, many: str) -> dict[str, float]:
    """Ratio of two entries of `seconds` by their names."""
    return {record["case"]: ratio(record["seconds"][many], record["seconds"][few]) for record in records}


def kernel(record: dict) -> float:
    """A call of 1,000 samples over the kernel alone, which 16,000 more samples show."""
    few, many = record["seconds"]["1000"], record["seconds"]["17000"]
    return statistics.median(few) / (statistics.median(many) - statistics.median(few)) * 16


def demands(results: dict[str, dict]) -> list[Demand]:
    """Every demand, from the records of one run by section."""
    orbits, states, steps, span, calls, threads = (
        results[name]["records"] for name in ("orbits", "states", "steps", "span", "calls", "threads")
    )
    theta, motion, linear = THETA.name, MOTION.name, LINEAR.name
    million = "10⁶ sorted times"
    ahead = {r["case"]: ratio(*(r["seconds"][f"{r['case']} {p:g}"] for p in (1e9, 10))) for r in span}
    return [
        Demand(f"θ of one orbit up to 150°, {million} / θ₀ cos ω₀t", 0.35, pairs(orbits, theta, linear, UP_TO_150)),
        Demand(f"θ of the other orbits, {million} / θ₀ cos ω₀t", 0.6, pairs(orbits, theta, linear, BEYOND)),
        Demand("θ and θ̇ up to 150° / θ₀ cos ω₀t", 0.8, pairs(orbits, motion, linear, UP_TO_150)),
        Demand("θ and θ̇ of the other orbits / θ₀ cos ω₀t", 1.2, pairs(orbits, motion, linear, BEYOND)),
        Demand("θ of one orbit at 90°, 150°, 170° / SciPy recipe", 1 / 100, pairs(orbits, theta, SCIPY.name, EASIER)),
        Demand("θ of one orbit at 0.1°, 30° / SciPy recipe", 1 / 60, pairs(orbits, theta, SCIPY.name, SMALL)),
        Demand(
            "10⁶ states of their own, θ and θ̇ / SciPy recipe",
            1 / 12,
            pairs(states, motion, SCIPY_MOTION.name, [states[0]["case"]]),
        ),
        Demand(
            "`advance(a, b, 0.3, out=(a, b))` of 10⁶ random states / `np.sin(a) + np.cos(a)`",
            1.5,
            pairs(steps, motion, SINE_COSINE.name, [steps[0]["case"]]),
        ),
        Demand("10⁶ samples, θ / heyoka's fastest way (which gives both)", 1 / 20, heyoka(orbits, theta)),
        Demand("10⁶ samples, θ and θ̇ / heyoka's fastest way", 1 / 20, heyoka(orbits, motion)),
        Demand(
            "two threads / one thread, 10⁷ times", 0.65, two([r for r in threads if r["count"] > MILLION], "1", "2")
        ),
        Demand("time at 10⁹ periods / time at 10 periods", 1.1, ahead),
        Demand(
            "`Pendulum.theta(t, out=)` at 1,000 samples / the kernel alone",
            2,
            {record["case"]: kernel(record) for record in calls},
        ),
    ]
