"""Rounds: all methods do the same work in turn, round after round, so that a slow minute is slow for all.

A slot of a round is one call that is not timed, then as many timed calls as fill SLOT seconds; its result is the mean.
Ratios are medians of the ratios within rounds. A call that takes longer than PATIENT is timed once a slot, without the call
before it. A call longer than SLOW has no rounds: its only timing is that of the call whose answer was compared, and the page
marks it.
"""

import gc
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

LIMIT = 30.0
ROUNDS = 7
SLOT = 0.012
PATIENT = 0.2
SLOW = 1.5


@dataclass
class Timed:
    """What the rounds say of one method; `seconds` has one entry a round, seconds per call."""

    call: Callable[[], tuple]
    clock: Callable[[], int] = time.perf_counter_ns
    first: float = 0.0
    repeats: int = 1
    seconds: list[float] = field(default_factory=list)

    def slot(self) -> None:
        """One slot of a round."""
        if self.first <= PATIENT:
            self.call()
        begun = self.clock()
        for _ in range(self.repeats):
            self.call()
        self.seconds.append((self.clock() - begun) / 1e9 / self.repeats)


def rounds(
    calls: dict[str, Callable[[], tuple]], count: int = ROUNDS, clock: Callable[[], int] = time.perf_counter_ns
) -> dict[str, list[float]]:
    """Seconds per call of every method in every round, all interleaved, starting with another one each round.

    Parameters
    ----------
    calls : dict
        Methods of doing the same work, by name.
    count : int
        Rounds, at least 7 for anything that a target rests on.
    clock : callable
        Nanoseconds: `time.process_time_ns` counts those of the processor, for calls of one thread on a machine that is busy.
    """
    timed = {}
    for name, call in calls.items():
        for _ in range(2):
            begun = clock()
            call()
            first = max((clock() - begun) / 1e9, 1e-9)
            if first > PATIENT:
                break
        timed[name] = Timed(call, clock, first, max(1, round(SLOT / first)))
    turn = list(timed)
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
    return {name: held.seconds for name, held in timed.items()}


def ratio(ours: list[float], theirs: list[float]) -> float:
    """Median over the rounds of ours / theirs; against one number where a slow method has only one."""
    if len(ours) != len(theirs):
        return statistics.median(ours) / statistics.median(theirs)
    return statistics.median(a / b for a, b in zip(ours, theirs, strict=True))


def affordable(make: Callable[[int], Callable], count: int, limit: float = LIMIT) -> tuple:
    """How many samples end within the limit: that number, the call for it, its first answer (copied) and its seconds.

    Powers of ten up to `count`. Two trials give a fixed part and a part for each sample, which predict the next trial.
    So a long start is not counted again for every sample. Nothing within the limit: (0, None, (), 0.0).

    Parameters
    ----------
    make : callable
        Prepares the work for that many samples and returns the call.
    count : int
        Samples wanted.
    """
    best: tuple = (0, None, (), 0.0)
    wanted, before = min(count, 10), None
    while True:
        call = make(wanted)
        begun = time.perf_counter()
        answer = call()
        taken = time.perf_counter() - begun
        if taken > limit:
            return best
        best = wanted, call, tuple(np.array(part) for part in answer), taken
        if wanted == count:
            return best
        after = min(count, 10 * wanted)
        slope = 0.0 if before is None else max(0.0, (taken - before[1]) / (wanted - before[0]))
        if taken + slope * (after - wanted) > limit:
            return best
        before, wanted = (wanted, taken), after
