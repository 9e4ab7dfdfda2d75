"""One comparison: several methods, the same inputs, interleaved rounds, every answer compared with the reference values.

A record is what one method gave: `case`, `periods`, `count`, `order`, `method`, `seconds` (one entry a round, seconds per
call), `errors` (one per output, see ruler.py) or a `note` that says why there is nothing.
"""

import functools
import math
from collections.abc import Callable

import numpy as np
from cases.orbits import Orbit, sample, times
from rivals.method import Method, NotAvailable, Refused

from .ruler import SAMPLE, Reference
from .timing import LIMIT, SLOW, affordable, rounds

GOAL = 1e-9
TOLERANCES = [10.0**-digits for digits in range(3, 14)] + [3e-14]
TOO_LONG = f"> {LIMIT:g} s"


def first_answer(
    entry: dict,
    make: Callable[[int], Callable[[], tuple]],
    wanted: int,
    reference: Callable[[int], Reference | None],
) -> None:
    """Find how many samples a method can do in time, and the error of its first answer; note what is missing.

    Parameters
    ----------
    entry : dict
        The record to fill; its `count` is what every method is asked for.
    make : callable
        The preparation for a number of samples.
    wanted : int
        How many this method is asked for.
    reference : callable
        The reference values for that many samples, or None where the method is no motion.
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
    if held := reference(limit):
        entry["errors"] = held.errors(answer)
    if taken > SLOW and not entry["method"].startswith("libration"):  # targets need the rounds of ours
        entry["seconds"] = [taken]
    else:
        entry["call"] = call


def interleaved(entries: list[dict]) -> list[dict]:
    """Fill the `seconds` of every entry that has a `call`, in rounds; the calls are dropped from the records."""
    with np.errstate(all="ignore"):
        taken = rounds({entry["method"]: entry["call"] for entry in entries if entry["call"]})
    for entry in entries:
        del entry["call"]
        entry["seconds"] = taken.get(entry["method"], entry["seconds"])
        print(f"    {entry['method']:44s}", shown(entry) if entry["seconds"] else entry["note"], flush=True)
    return entries


def shown(entry: dict) -> str:
    """A record as the terminal shows it."""
    seconds = sorted(entry["seconds"])[len(entry["seconds"]) // 2]
    worst = max(entry["errors"], default=math.nan)
    return f"{entry['count']:>9d} {seconds / entry['count'] * 1e9:12.2f} ns/sample   error {worst:.1e}"


def one_orbit(
    methods: list[Method],
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
    methods : list of Method
        What is compared.
    orbit, count, periods, order
        The inputs, see `times`.
    most : dict, optional
        The most samples for a method, by its name, where the full count is known to take too long.
    over : set of str, optional
        Methods known to take longer than the limit here; they are only named.
    """
    print(f"  {orbit.name}, {count} times over {periods:g} periods, {order}", flush=True)

    @functools.cache
    def reference(few: int) -> Reference:
        t = times(orbit, few, periods, order)
        return Reference(orbit.theta0, orbit.velocity0, t, sample(few, SAMPLE))

    entries = []
    for method in methods:
        here = {"case": orbit.name, "periods": periods, "count": count, "order": order, "method": method.name}
        entries.append({**here, "errors": [], "seconds": [], "note": "", "call": None})
        entry = entries[-1]
        if method.name in over:
            entry["note"] = TOO_LONG
            continue
        if order == "random" and not method.any_order:
            entry["note"] = "times must rise"
            continue
        first_answer(
            entry,
            lambda few, method=method: method.orbit(orbit, times(orbit, few, periods, order)),
            min(count, (most or {}).get(method.name, count)),
            reference,
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
    reference = Reference(orbit.theta0, orbit.velocity0, t, np.arange(SAMPLE))
    found = {}
    for tolerance in TOLERANCES:
        try:
            found[tolerance] = max(reference.errors(build(tolerance)(orbit, t)()))
        except Refused:
            found[tolerance] = math.inf
    reached = [tolerance for tolerance, error in found.items() if error <= GOAL]
    return (reached[0] if reached else None), min(found, key=found.get)


def own_states(methods: list[Method], work: str, inputs: tuple, most: dict[str, int], case: str) -> list[dict]:
    """Records of states of their own: `work` is `states` or `advance`; the last of `inputs` is t, or dt for all."""
    count = len(inputs[0])
    print(f"  {case}, {count} states", flush=True)

    @functools.cache
    def reference(few: int) -> Reference:
        theta0, velocity0, t = (np.broadcast_to(part, count)[:few] for part in inputs)
        return Reference(theta0, velocity0, t, sample(few, SAMPLE))

    entries = []
    for method in methods:
        entry = {"case": case, "periods": None, "count": count, "order": "random", "method": method.name}
        entry.update(errors=[], seconds=[], note="", call=None)
        entries.append(entry)

        def prepared(few: int, method=method):
            return getattr(method, work)(*(np.copy(part[:few]) if np.ndim(part) else part for part in inputs))

        known = (lambda few: None) if method.name.startswith("np.") else reference
        first_answer(entry, prepared, min(count, most.get(method.name, count)), known)
    return interleaved(entries)
