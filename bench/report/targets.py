"""The targets of a run: each with its limit, the worst ratio measured, where it was, and whether the target is met.

A ratio is the median over the rounds of one run of ours / theirs. The worst of the orbits of a target counts.
"""

import math
import statistics
from dataclasses import dataclass

from cases.orbits import BEYOND_150, UP_TO_150
from measurement.threads import ACTIONS
from measurement.timing import ratio
from rivals.formulas import LINEAR, SCIPY, SCIPY_MOTION, SINE_COSINE
from rivals.ours import MOTION, THETA

MILLION = 10**6
LOWER = [orbit.name for orbit in UP_TO_150]
NEAR = ["179.999°", "1 − κ² = 1e-12", "1 − κ² = −1e-12"]
BEYOND = [orbit.name for orbit in BEYOND_150]
HIGHER = [name for name in BEYOND if name not in NEAR]
EASIER, SMALL = ["90°", "150°", "170°"], ["0.1°", "30°"]


@dataclass(frozen=True)
class Target:
    """One line of the table.

    Parameters
    ----------
    work : str
        What is divided by what.
    limit : float
        The largest ratio allowed.
    ratios : dict
        Ratio by case; empty if the run has none, and then the target is not met.
    lanes : bool
        Whether it is of a kernel over lanes. Without AVX-512, which has twice as many, twice the limit is allowed.
    """

    work: str
    limit: float
    ratios: dict[str, float]
    lanes: bool = True

    @property
    def worst(self) -> tuple[str, float]:
        """The case with the largest ratio, and that ratio."""
        return max(self.ratios.items(), key=lambda item: item[1], default=("not measured", math.inf))

    def allowed(self, processor: str) -> float:
        """The limit on a processor, whose instruction sets are named."""
        return self.limit * (2 if self.lanes and "avx512" not in processor else 1)

    def holds(self, processor: str) -> bool:
        """Whether the worst ratio is within that limit."""
        return self.worst[1] <= self.allowed(processor)


def pairs(records: list[dict], ours: str, theirs: str, cases: list[str]) -> dict[str, float]:
    """Ratio of two methods in each of the cases, at a full count in all rounds."""
    held = {(record["case"], record["method"]): record for record in records if record["seconds"]}
    found = {}
    for case in cases:
        a, b = held.get((case, ours)), held.get((case, theirs))
        found[case] = ratio(a["seconds"], b["seconds"]) if a and b and a["count"] == b["count"] else math.inf
    return found


def heyoka(records: list[dict], ours: str) -> dict[str, float]:
    """Ours against the fastest of heyoka's methods that did all the samples, orbit after orbit."""
    found = {}
    for case in dict.fromkeys(record["case"] for record in records):
        here = [r for r in records if r["case"] == case and r["seconds"] and r["count"] == MILLION]
        rivals = [r for r in here if r["method"].startswith("heyoka")]
        mine = [r for r in here if r["method"] == ours]
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


def columns(records: list[dict]) -> list[Target]:
    """Functions of columns: one target for all with the same peer and limit."""
    found: dict[tuple[str, float], dict[str, float]] = {}
    for record in records:
        key = record["peer"].partition(" ")[0], record["limit"]
        found.setdefault(key, {})[record["case"]] = ratio(*record["seconds"].values())
    return [
        Target(
            f"columns: {' and '.join(ratios) if len(ratios) < 3 else f'{len(ratios)} functions'} / {peer}",
            limit,
            ratios,
        )
        for (peer, limit), ratios in found.items()
    ]


def targets(results: dict[str, dict]) -> list[Target]:
    """Every target, from the records of one run by section."""
    orbits, states, steps, long_times, calls, threads = (
        results[name]["records"] for name in ("orbits", "states", "steps", "long_times_ratio", "calls", "threads")
    )
    theta, motion, linear = THETA.name, MOTION.name, LINEAR.name
    million = "10⁶ sorted times"
    late = {r["case"]: ratio(*(r["seconds"][f"{r['case']} {p:g}"] for p in (1e9, 10))) for r in long_times}
    return [
        Target(f"θ of one orbit up to 150°, {million} / θ₀ cos ω₀t", 0.3, pairs(orbits, theta, linear, LOWER)),
        Target(f"θ at 170° and of the rotation, {million} / the same", 0.35, pairs(orbits, theta, linear, HIGHER)),
        Target(f"θ next to the separatrix, {million} / the same", 0.45, pairs(orbits, theta, linear, NEAR)),
        Target("θ and θ̇ up to 150° / θ₀ cos ω₀t", 0.55, pairs(orbits, motion, linear, LOWER)),
        Target("θ and θ̇ of the other orbits / θ₀ cos ω₀t", 0.8, pairs(orbits, motion, linear, BEYOND)),
        Target(
            "θ of one orbit at 90°, 150°, 170° / SciPy recipe", 1 / 100, pairs(orbits, theta, SCIPY.name, EASIER), False
        ),
        Target("θ of one orbit at 0.1°, 30° / SciPy recipe", 1 / 60, pairs(orbits, theta, SCIPY.name, SMALL), False),
        Target(
            "10⁶ states of their own, θ and θ̇ / SciPy recipe",
            1 / 15,
            pairs(states, motion, SCIPY_MOTION.name, [states[0]["case"]]),
        ),
        Target(
            "`advance(a, b, 0.3, out=(a, b))` of 10⁶ random states / `np.sin(a) + np.cos(a)`",
            1.2,
            pairs(steps, motion, SINE_COSINE.name, [steps[0]["case"]]),
        ),
        Target("10⁶ samples, θ / heyoka's fastest method (which gives both)", 1 / 20, heyoka(orbits, theta), False),
        Target("10⁶ samples, θ and θ̇ / heyoka's fastest method", 1 / 20, heyoka(orbits, motion), False),
        Target(
            "two threads / one thread, 10⁷ times",
            0.65,
            two([r for r in threads if r["count"] > MILLION], "1", "2"),
            False,
        ),
        Target(
            "two threads / one thread, 10⁶ actions",
            0.6,
            two([r for r in threads if r["case"] == ACTIONS], "1", "2"),
            False,
        ),
        *columns(results["columns"]["records"]),
        Target("time at 10⁹ periods / time at 10 periods", 1.1, late, False),
        Target(
            "`Pendulum.theta(t, out=)` at 1,000 samples / the kernel alone",
            2,
            {record["case"]: kernel(record) for record in calls},
            False,
        ),
    ]
