"""One comparison: several ways, the same inputs, interleaved rounds, every answer held against the truth.

A record is what one way gave: `case`, `periods`, `count`, `order`, `way`, `seconds` (one entry a round, seconds per
call), `errors` (one per output, see ruler.py) or a `note` that says why there is nothing.
"""

import math
from collections.abc import Callable

import numpy as np

from cases import Orbit, sample, times
from rivals import NotAvailable, Refused, Way
from ruler import SAMPLE, Truth
from timing import LIMIT, ROUNDS, affordable, rounds

GOAL = 1e-9
TOLERANCES = [10.0**-digits for digits in range(3, 14)] + [3e-14]
TOO_LONG = f"> {LIMIT:g} s"


def tried(make: Callable[[], Callable[[], tuple]]) -> tuple[Callable[[], tuple] | None, tuple, str]:
    """The prepared call, its first answer copied, and a note where there is none."""
    try:
        call = make()
        with np.errstate(all="ignore"):
            return call, tuple(np.array(part) for part in call()), ""
    except NotAvailable as missing:
        return None, (), f"not available: {missing}"
    except Refused as refused:
        return None, (), str(refused)


def interleaved(entries: list[dict], count: int = ROUNDS, whole: bool = False) -> list[dict]:
    """Fill the `seconds` of every entry that has a `call`, in rounds; the calls are dropped from the records."""
    with np.errstate(all="ignore"):
        taken = rounds({entry["way"]: entry["call"] for entry in entries if entry["call"]}, count, whole)
    for entry in entries:
        del entry["call"]
        if entry["way"] in taken:
            entry["seconds"] = taken[entry["way"]]
            print(f"    {entry['way']:44s}", shown(entry), flush=True)
        else:
            print(f"    {entry['way']:44s}", entry["note"], flush=True)
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
    count_rounds: int = ROUNDS,
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
    truths: dict[int, Truth] = {}
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
        wanted = min(count, (most or {}).get(way.name, count))
        try:
            limit = affordable(lambda few, way=way: way.orbit(orbit, times(orbit, few, periods, order))(), wanted)
        except (NotAvailable, Refused):
            limit = wanted
        if not limit:
            entry["note"] = TOO_LONG
            continue
        t = times(orbit, limit, periods, order)
        if limit < count:
            entry["note"] = f"{count:g} samples: {TOO_LONG}" if limit < wanted else f"{wanted:g} samples only"
        entry["count"] = limit
        entry["call"], answer, note = tried(lambda way=way, t=t: way.orbit(orbit, t))
        entry["note"] = note or entry["note"]
        if entry["call"]:
            if limit not in truths:
                truths[limit] = Truth(orbit.theta0, orbit.velocity0, t, sample(limit, SAMPLE))
            entry["errors"] = truths[limit].errors(answer)
    return interleaved(entries, count_rounds)


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
        call, answer, _ = tried(lambda tolerance=tolerance: build(tolerance)(orbit, t))
        found[tolerance] = max(truth.errors(answer)) if call else math.inf
    reached = [tolerance for tolerance, error in found.items() if error <= GOAL]
    return (reached[0] if reached else None), min(found, key=found.get)


def own_states(ways: list[Way], work: str, inputs: tuple, most: dict[str, int], case: str) -> list[dict]:
    """Records of states of their own: `work` is `states` or `advance`; the last of `inputs` is t, or dt for all."""
    count = len(inputs[0])
    print(f"  {case}, {count} states", flush=True)
    truths: dict[int, Truth] = {}
    entries = []
    for way in ways:
        here = {"case": case, "periods": None, "count": count, "order": "random", "way": way.name}
        entry = {**here, "errors": [], "seconds": [], "note": "", "call": None}
        entries.append(entry)

        def prepared(few: int, way=way):
            return getattr(way, work)(*(np.copy(part[:few]) if np.ndim(part) else part for part in inputs))

        wanted = min(count, most.get(way.name, count))
        try:
            limit = affordable(lambda few, prepared=prepared: prepared(few)(), wanted)
        except (NotAvailable, Refused):
            limit = wanted
        if not limit:
            entry["note"] = TOO_LONG
            continue
        if limit < count:
            entry["note"] = f"{count:g} states: {TOO_LONG}" if limit < wanted else f"{wanted:g} states only"
        entry["count"] = limit
        _, answer, note = tried(lambda prepared=prepared, limit=limit: prepared(limit))
        entry["note"] = note or entry["note"]
        if note:
            continue
        entry["call"] = prepared(limit)
        if way.name.startswith("np."):
            continue  # a yardstick, no motion
        if limit not in truths:
            t = np.broadcast_to(inputs[2], np.shape(inputs[0]))[:limit]
            truths[limit] = Truth(inputs[0][:limit], inputs[1][:limit], t, sample(limit, SAMPLE))
        entry["errors"] = truths[limit].errors(answer)
    return interleaved(entries)
