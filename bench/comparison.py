"""One comparison: several ways, the same inputs, interleaved rounds, every answer held against the truth.

A record is what one way gave: `case`, `periods`, `count`, `order`, `way`, `seconds` (one entry a round, seconds per
call), `errors` (one per output, see ruler.py) or a `note` that says why there is nothing.
"""

import functools
import math
from collections.abc import Callable

import numpy as np
from cases import Orbit, sample, times
from rivals import NotAvailable, Refused, Way
from ruler import SAMPLE, Truth
from timing import LIMIT, SLOW, affordable, rounds

GOAL = 1e-9
TOLERANCES = [10.0**-digits for digits in range(3, 14)] + [3e-14]
TOO_LONG = f"> {LIMIT:g} s"


def tried(entry: dict, make: Callable[[int], Callable[[], tuple]], wanted: int, truth: Callable[[int], Truth]) -> None:
    """Find out how far a way gets, hold its first answer against the truth, and note what is missing.

    Parameters
    ----------
    entry : dict
        The record to fill; its `count` is what was asked of everybody.
    make : callable
        The preparation for a number of samples.
    wanted : int
        How many this way is asked for.
    truth : callable
        The truth for that many samples, or None where the way is only a yardstick.
    """
    try:
        with np.errstate(all="ignore"):
            limit, call, answer, taken = affordable(make, wanted)
    except NotAvailable as missing:
        entry["note"] = f"not available: {missing}"
        return
    except Refused as refused:
        entry["note"] = str(refused)
        return
    if not limit:
        entry["note"] = TOO_LONG
        return
    if limit < entry["count"]:
        entry["note"] = f"{wanted:,} samples: {TOO_LONG}" if limit < wanted else f"{wanted:,} samples only"
    entry["count"] = limit
    if held := truth(limit):
        entry["errors"] = held.errors(answer)
    if taken > SLOW and not entry["way"].startswith("libration"):  # a demand rests on ours: always in rounds
        entry["seconds"] = [taken]
    else:
        entry["call"] = call


def interleaved(entries: list[dict]) -> list[dict]:
    """Fill the `seconds` of every entry that has a `call`, in rounds; the calls are dropped from the records."""
    with np.errstate(all="ignore"):
        taken = rounds({entry["way"]: entry["call"] for entry in entries if entry["call"]})
    for entry in entries:
        del entry["call"]
        entry["seconds"] = taken.get(entry["way"], entry["seconds"])
        print(f"    {entry['way']:44s}", shown(entry) if entry["seconds"] else entry["note"], flush=True)
    return entries


def shown(entry: dict) -> str:
    """A record as the terminal shows it."""
    seconds = sorted(entry["seconds"])[len(entry["seconds"]) // 2]
    worst = max(entry["errors"], default=math.nan)
    return f"{entry['count']:>9d} {seconds / entry['count'] * 1e9:12.2f} ns/sample   error {worst:.1e}"


def one_orbit(
    ways: list[Way],
    orbit: Orbit,
    count: int,
    periods: float,
    order: str = "sorted",
    most: dict[str, int] | None = None,
    over: set[str] | frozenset[str] = frozenset(),
) -> list[dict]:
    """Records of one orbit.

    Parameters
    ----------
    ways : list of Way
        Who takes part.
    orbit, count, periods, order
        The inputs, see cases.times.
    most : dict, optional
        Samples that a way is given at most, by its name, where the full count is known to take too long.
    over : set of str, optional
        Ways known to take longer than the limit here; they are only named.
    """
    print(f"  {orbit.name}, {count} times over {periods:g} periods, {order}", flush=True)

    @functools.cache
    def truth(few: int) -> Truth:
        t = times(orbit, few, periods, order)
        return Truth(orbit.theta0, orbit.velocity0, t, sample(few, SAMPLE))

    entries = []
    for way in ways:
        here = {"case": orbit.name, "periods": periods, "count": count, "order": order, "way": way.name}
        entries.append({**here, "errors": [], "seconds": [], "note": "", "call": None})
        entry = entries[-1]
        if way.name in over:
            entry["note"] = TOO_LONG
            continue
        if order == "random" and not way.any_order:
            entry["note"] = "times must rise"
            continue
        tried(
            entry,
            lambda few, way=way: way.orbit(orbit, times(orbit, few, periods, order)),
            min(count, (most or {}).get(way.name, count)),
            truth,
        )
    return interleaved(entries)


def tuned(build: Callable[[float], Callable], orbit: Orbit, periods: float) -> tuple[float | None, float]:
    """The loosest tolerance that reaches GOAL, or None, and the one with the smallest error.

    Parameters
    ----------
    build : callable
        The preparation of an integrator at a tolerance.
    """
    t = times(orbit, SAMPLE, periods)
    truth = Truth(orbit.theta0, orbit.velocity0, t, np.arange(SAMPLE))
    found = {}
    for tolerance in TOLERANCES:
        try:
            found[tolerance] = max(truth.errors(build(tolerance)(orbit, t)()))
        except Refused:
            found[tolerance] = math.inf
    reached = [tolerance for tolerance, error in found.items() if error <= GOAL]
    return (reached[0] if reached else None), min(found, key=found.get)


def own_states(ways: list[Way], work: str, inputs: tuple, most: dict[str, int], case: str) -> list[dict]:
    """Records of states of their own: `work` is `states` or `advance`; the last of `inputs` is t, or dt for all."""
    count = len(inputs[0])
    print(f"  {case}, {count} states", flush=True)

    @functools.cache
    def truth(few: int) -> Truth:
        theta0, velocity0, t = (np.broadcast_to(part, count)[:few] for part in inputs)
        return Truth(theta0, velocity0, t, sample(few, SAMPLE))

    entries = []
    for way in ways:
        entry = {"case": case, "periods": None, "count": count, "order": "random", "way": way.name}
        entry.update(errors=[], seconds=[], note="", call=None)
        entries.append(entry)

        def prepared(few: int, way=way):
            return getattr(way, work)(*(np.copy(part[:few]) if np.ndim(part) else part for part in inputs))

        held = (lambda few: None) if way.name.startswith("np.") else truth
        tried(entry, prepared, min(count, most.get(way.name, count)), held)
    return interleaved(entries)
