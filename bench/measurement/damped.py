"""Time and error of the damped motion: every method at the same times in the same rounds, against the reference vectors.

The error is the largest |got - truth| over angle and velocity at the times that have a truth, of the largest angle or velocity of the
motion up to then. All methods are asked for these times alone, and for ten thousand times besides.
"""

import math

import numpy as np
from cases.damped import damped_cases
from rivals.damped import METHODS
from rivals.method import NotAvailable, Refused

import libration

from .timing import rounds

DENSE = 10_000


def damped_error(case, theta, velocity) -> float:
    """The error of the answers at the times of the rows."""
    worst = 0.0
    for row, *got in zip(case.rows, theta, velocity, strict=True):
        for name, value in zip(("theta", "velocity"), got, strict=True):
            if not math.isfinite(value):
                return math.inf
            hi, lo = (float.fromhex(row[f"{name}_{word}"]) for word in ("hi", "lo"))
            worst = max(worst, abs((value - hi) - lo) / float(row[f"scale_{name}"]))
    return worst


def turns(case) -> float:
    """How many periods the motion has up to its last time: two turns each."""
    friction = libration.Friction(linear=case.linear, quadratic=case.quadratic, dry=case.dry)
    pendulum = libration.DampedPendulum(case.theta0, omega0=1.0, friction=friction)
    return len(pendulum.turning_times(0.0, case.times[-1])) / 2


def damped_records() -> list[dict]:
    """A record for each case, density and method."""
    found = []
    for case in damped_cases():
        few = np.array(case.times)
        many = np.sort(np.concatenate([few, np.linspace(0.0, few[-1], DENSE - len(few) + 2)[1:-1]]))
        for t in (few, many):
            calls, entries = {}, {}
            for name, prepare in METHODS.items():
                entry = {"case": case.name, "periods": turns(case), "count": len(t), "method": name}
                entries[name] = {**entry, "seconds": [], "error": None, "note": ""}
                try:
                    call = prepare(case, t)
                    theta, velocity = (np.array(part)[np.searchsorted(t, few)] for part in call())
                except (NotAvailable, Refused) as missing:
                    entries[name]["note"] = f"not available: {missing}"
                    continue
                entries[name]["error"] = damped_error(case, theta, velocity)
                calls[name] = call
            for name, seconds in rounds(calls).items():
                entries[name]["seconds"] = seconds
            found += entries.values()
        print(f"  {case.name}", flush=True)
    return found
