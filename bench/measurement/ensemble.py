"""Ensembles in figures: a bunch turn by turn by every way, with its error; a million particles; and what sums and stores take.

Turn by turn all ways move the same chunk in the same rounds on one thread, by the time of the processor. The error is that of the angles of some particles after
1,000 turns against mpmath. Whole runs are measured in processes of their own, by their seconds and those of the processor.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path

from cases.ensemble import COUNT, DT, KNOWN, TURNS, bunch, gap, truth
from rivals.method import NotAvailable
from rivals.turns import ways

from .ensemble_runs import stored, summed
from .timing import rounds

# Turns of a call that is timed.
TIMED = 20
# Particles and turns of a whole run, and how often the jump is repeated.
MILLION, REPEATS = 10**6, 5


def turn_records() -> list[dict]:
    """Nanoseconds a state and turn, and the error, of every way."""
    true, found, calls = truth(), {}, {}
    for name, prepare in ways(DT).items():
        found[name] = {"way": name, "nanoseconds": [], "error": None, "note": ""}
        try:
            go = prepare()
        except NotAvailable as missing:
            found[name]["note"] = f"not available: {missing}"
            continue
        turns = TURNS if "jump" in name else TIMED
        if "cosine" not in name:
            # As many as fill every batch.
            theta, velocity = (column[: 4 * KNOWN].copy() for column in bunch())
            go(theta, velocity, TURNS)
            found[name]["error"] = gap(theta, true)
        states = bunch()

        def call(go=go, states=states, turns=turns):
            go(*states, turns)
            return states

        calls[name] = call, turns
    for name, seconds in rounds({name: call for name, (call, _) in calls.items()}, clock=time.process_time_ns).items():
        found[name]["nanoseconds"] = [each / COUNT / calls[name][1] * 1e9 for each in seconds]
    return list(found.values())


MILLION_RUN = """
import json, resource, sys, time
import numpy as np
import libration
from libration import ensemble
count, turns, dt, repeats = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4])
start = ensemble.bunch(count, distribution="waterbag", energy_ratio=0.95, seed=1)
def taken(work):
    theta, velocity = (each.copy() for each in start)
    begun, before = time.perf_counter(), time.process_time()
    work(theta, velocity)
    return [time.perf_counter() - begun, time.process_time() - before]
def tracked(theta, velocity):
    ensemble.track(theta, velocity, dt, steps=turns, out=(theta, velocity, np.empty(count, np.int64)))
def jumped(theta, velocity):
    libration.advance(theta, velocity, turns * dt, out=(theta, velocity))
def sines(theta, velocity):
    np.sin(theta, out=velocity), np.cos(theta, out=velocity)
jumped(*(each.copy() for each in start))
print(json.dumps({"track": taken(tracked), "jump": [taken(jumped) for _ in range(repeats)],
                  "one turn": [taken(lambda theta, velocity: libration.advance(theta, velocity, dt, out=(theta, velocity)))
                               for _ in range(repeats)],
                  "sine and cosine": [taken(sines) for _ in range(repeats)]}))
"""


def million_records(turns: int = TURNS) -> list[dict]:
    """A million particles for 1,000 turns, and in one jump, by one thread and by two."""
    found = []
    for threads in (1, 2):
        words = [sys.executable, "-c", MILLION_RUN, *map(str, (MILLION, turns, DT, REPEATS))]
        environment = {**os.environ, "LIBRATION_NUM_THREADS": str(threads)}
        run = subprocess.run(words, capture_output=True, text=True, check=True, env=environment)
        found.append({"threads": threads, "particles": MILLION, "turns": turns, **json.loads(run.stdout)})
    return found


def run_records(repeats: int = 3) -> dict:
    """10**8 states summed by two workers, and 10**7 x 10 into a store beside np.save."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        sums = []
        for _ in range(repeats):
            sums.append(summed(folder))
            shutil.rmtree(folder / "sums.zarr")
        return {"sums": sums, "store": stored(folder)}


PARTS = {"turns": turn_records, "million": million_records, "runs": run_records}


def ensemble_records(parts: Iterable[str]) -> dict:
    """The parts that are asked for."""
    found = {}
    for name in parts:
        begun = time.perf_counter()
        found[name] = PARTS[name]()
        print(f"  {name}: {time.perf_counter() - begun:.0f} s", flush=True)
    return found
