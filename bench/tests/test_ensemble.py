"""The errors and promises of the page of ensembles can say no, and every way to go turn by turn is the pendulum."""

import math

import numpy as np
import pytest
from cases.ensemble import DT, KNOWN, angle, bunch, gap
from report.ensemble import ensemble_page, promises
from rivals.turns import OURS, jump, leapfrog, order8, ours

TURNS = 20


@pytest.fixture(scope="module")
def true():
    theta0, velocity0 = (column[:KNOWN].tolist() for column in bunch())
    return np.array([float(angle(*state, DT * TURNS)) for state in zip(theta0, velocity0, strict=True)])


def after(go):
    theta, velocity = (column[:KNOWN].copy() for column in bunch())
    go(theta, velocity, TURNS)
    return theta


def test_every_way_is_the_pendulum(true):
    for go in (ours(DT), jump(DT)):
        assert gap(after(go), true) < 1e-13
    errors = [gap(after(order8(DT, steps)), true) for steps in (1, 2)]
    assert errors[1] < 1e-8 and 2**7 < errors[0] / errors[1] < 2**9.5
    errors = [gap(after(leapfrog(DT, steps)), true) for steps in (20, 40)]
    assert 3.8 < errors[0] / errors[1] < 4.2 and errors[0] < 0.1


def test_a_wrong_angle_has_an_error(true):
    assert gap(true + math.tau, true) < 1e-14
    assert gap(true + 1e-9, true) > 9e-10
    assert math.isnan(gap(true * math.nan, true))


def held(ns=1.0, error=1e-12, seconds=50.0):
    """Results as they are kept."""
    turns = [
        {"way": OURS, "nanoseconds": [ns] * 7, "error": error, "note": ""},
        {"way": "NumPy: order 8, 4 a turn", "nanoseconds": [15.0] * 7, "error": 1e-11, "note": ""},
        {"way": "NumPy: order 8, 1 a turn", "nanoseconds": [4.0] * 7, "error": 1e-6, "note": ""},
        {"way": "heyoka", "nanoseconds": [], "error": None, "note": "not available: heyoka"},
    ]
    one = {"particles": 10**6, "turns": 1000, "track": [seconds, seconds], "jump": [[0.05, 0.05]]}
    one |= {"one turn": [[0.05, 0.05]], "sine and cosine": [[0.03, 0.03]]}
    sums = [{"states": 10**8, "seconds": 9.0, "processor": 18.0, "memory": 3e8}]
    store = {"bytes": 8e8, "chunks": 39, "zarr": [[1.0, 1.0]], "np.save": [[0.7, 0.7]]}
    head = {name: "" for name in ("date", "command", "processor", "system", "load at the start")}
    versions = {name: "" for name in ("libration", "Python", "numpy", "heyoka", "zarr")}
    return {
        **head,
        "versions": versions,
        "turns": turns,
        "million": [{"threads": 1, **one}, {"threads": 2, **one}],
        "runs": {"sums": sums, "store": store},
    }


def test_promises_can_be_broken():
    def broken(**changed):
        return [what for what, _, holds in promises(held(**changed)) if not holds]

    usual = ["turn by turn at 1e-10: 10 × cheaper than heyoka", "10⁶ particles × 1,000 turns, 2 threads: 30 s"]
    assert broken() == usual
    assert broken(ns=1.3)[0].startswith("turn by turn at 1e-10: 12 × cheaper than NumPy: order 8, 4")
    assert len(broken(seconds=56.0)) == 3


def test_what_is_missing_has_a_row():
    text = ensemble_page(held())
    assert "| heyoka | not available: heyoka |" in text
    assert f"| {OURS} | 1e-12 | 1 | 1 |" in text and "| NumPy: order 8, 1 a turn | 1e-6 | 4 | 4 |" in text
    part = ensemble_page({name: value for name, value in held().items() if name != "million"})
    assert "python bench/run_ensemble.py million" in part and "1,000 turns, 2 threads" not in part
