"""Rounds: everybody does the same work in turn, round after round, so that a slow minute is slow for all.

A slot of a round is one untimed call, then as many timed ones as fill SLOT seconds; its result is the mean. Ratios are
medians of the ratios within rounds. A call that takes longer than PATIENT is timed once a slot, without the untimed
call; one longer than SLOW is timed in one round only, and what the run then has of it is one number, said so.
"""

import gc
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field

LIMIT = 30.0
ROUNDS = 7
SLOT = 0.012
PATIENT = 0.2
SLOW = 0.7


@dataclass
class Timed:
    """What the rounds say of one way of doing the work.

    Parameters
    ----------
    call : callable without arguments
        Does the work once and returns its answer.
    seconds : list of float
        One entry a round: seconds per call.
    """

    call: Callable[[], tuple]
    first: float = 0.0
    repeats: int = 1
    seconds: list[float] = field(default_factory=list)

    def slot(self) -> None:
        """One slot of a round."""
        if self.first <= PATIENT:
            self.call()
        begun = time.perf_counter_ns()
        for _ in range(self.repeats):
            self.call()
        self.seconds.append((time.perf_counter_ns() - begun) / 1e9 / self.repeats)


def rounds(calls: dict[str, Callable[[], tuple]], count: int = ROUNDS, whole: bool = False) -> dict[str, list[float]]:
    """Seconds per call of every way in every round, all interleaved, starting with another one each round.

    Parameters
    ----------
    calls : dict
        Ways of doing the same work, by name.
    count : int
        Rounds, at least 7 for anything that a demand rests on.
    whole : bool
        Whether slow ways take part in every round too.
    """
    timed = {}
    for name, call in calls.items():
        for _ in range(2):
            begun = time.perf_counter_ns()
            call()
            first = max((time.perf_counter_ns() - begun) / 1e9, 1e-9)
            if first > PATIENT:
                break
        timed[name] = Timed(call, first, max(1, round(SLOT / first)))
        if first > SLOW and not whole:
            timed[name].seconds.append(first)
    turn = [name for name, way in timed.items() if whole or not way.seconds]
    collecting = gc.isenabled()
    gc.disable()
    try:
        for index in range(count):
            for place in range(len(turn)):
                timed[turn[(place + index) % len(turn)]].slot()
            gc.collect()
    finally:
        if collecting:
            gc.enable()
    return {name: way.seconds for name, way in timed.items()}


def ratio(ours: list[float], theirs: list[float]) -> float:
    """Median over the rounds of ours / theirs; against one number where a slow way has only one."""
    if len(ours) != len(theirs):
        return statistics.median(ours) / statistics.median(theirs)
    return statistics.median(a / b for a, b in zip(ours, theirs, strict=True))


def affordable(run: Callable[[int], object], count: int, limit: float = LIMIT) -> int:
    """The largest power of ten up to `count` (or `count` itself) expected to end within the limit; 0 if none is.

    Parameters
    ----------
    run : callable
        Does the work for that many samples. Two trials give a fixed part and a part for each sample, which tell the
        rest, so that nobody is charged for a long set-up as if every sample had it.
    count : int
        Samples wanted.
    """
    trials: list[tuple[int, float]] = []
    best, wanted = 0, min(count, 10)
    while True:
        begun = time.perf_counter()
        run(wanted)
        trials.append((wanted, time.perf_counter() - begun))
        if trials[-1][1] > limit:
            return best
        best = wanted
        if wanted == count:
            return best
        wanted = min(count, 10 * wanted)
        expected = trials[-1][1]
        if len(trials) > 1:
            (few, short), (many, long) = trials[-2:]
            expected += max(0.0, (long - short) / (many - few)) * (wanted - many)
        if expected > limit:
            return best
