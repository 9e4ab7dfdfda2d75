"""The ruler and the targets can fail: a mutated answer has a large error, a missed target is not met."""

import math

import numpy as np
import pytest
from cases.orbits import BY_NAME, sample, times
from measurement import timing
from measurement.ruler import Reference, error
from measurement.timing import affordable, ratio, rounds
from report.targets import Target, pairs
from rivals import ours
from rivals.method import NotAvailable


@pytest.mark.parametrize("name", ["30°", "1 − κ² = 1e-12", "fast rotation"])
def test_reference_accepts_ours_and_refuses_a_mutated_answer(name):
    orbit = BY_NAME[name]
    t = times(orbit, 500, 1e6)
    reference = Reference(orbit.theta0, orbit.velocity0, t, sample(500, 20))
    theta, velocity = ours.MOTION.orbit(orbit, t)()
    assert max(reference.errors((theta, velocity))) < 3e-16
    assert reference.errors((-theta, velocity))[0] > 1e-3
    assert reference.errors((theta * (1 + 1e-14), velocity))[0] > 1e-15
    assert reference.errors((np.roll(theta, 1), velocity))[0] > 1e-6
    theta[reference.indices[3]] = math.nan
    assert reference.errors((theta, velocity))[0] == math.inf


def test_error_is_relative_to_the_scale_and_signed():
    hi, lo = np.array([-1.0, 1e-20]), np.array([0.0, 0.0])
    assert error(hi, hi, lo, 1.0) == 0
    assert error(-hi, hi, lo, 1.0) == 2
    assert error([-1.0, 1e-3], hi, lo, 1.0) == pytest.approx(1e-3)
    assert error([-1.0, math.inf], hi, lo, 1.0) == math.inf
    with pytest.raises(ValueError):
        error([-1.0], hi, lo, 1.0)


def test_target_is_met_only_if_its_worst_case_was_measured_and_is_within_the_limit():
    record = {"case": "a", "count": 10, "seconds": [1.0] * 7}
    records = [{**record, "method": "ours"}, {**record, "method": "theirs", "seconds": [2.0] * 7}]
    assert Target("", 0.5, pairs(records, "ours", "theirs", ["a"])).holds("avx512f")
    assert not Target("", 0.49, pairs(records, "ours", "theirs", ["a"])).holds("avx512f")
    assert not Target("", 0.5, pairs(records, "ours", "theirs", ["a", "b"])).holds("avx512f")
    assert not Target("", 0.5, pairs(records, "ours", "missing", ["a"])).holds("avx512f")
    assert not Target("", 0.5, {}).holds("avx512f")
    assert not Target("", 0.5, {"a": 0.6}, False).holds("avx2")
    assert Target("", 0.5, {"a": 1.0}).holds("avx2") and not Target("", 0.5, {"a": 1.01}).holds("avx2")
    records[1]["count"] = 5
    assert not Target("", 9.0, pairs(records, "ours", "theirs", ["a"])).holds("avx512f")


def test_rounds_take_every_method_seven_times_and_ratios_go_pair_by_pair():
    taken = rounds({"a": lambda: (sum(range(1000)),), "b": lambda: (sum(range(4000)),)})
    assert [len(seconds) for seconds in taken.values()] == [7, 7]
    assert 0 < ratio(taken["a"], taken["b"]) < 1
    assert ratio([1.0, 2.0, 30.0], [2.0, 4.0, 3.0]) == 0.5


def test_no_method_is_asked_beyond_the_limit(monkeypatch):
    asked, clock = [], [0.0]

    def slow(count):
        def call():
            asked.append(count)
            clock[0] += count * 1e-4
            return (count,)

        return call

    monkeypatch.setattr(timing.time, "perf_counter", lambda: clock[0])
    limit, *_ = affordable(slow, 10**6, limit=0.05)
    assert limit == 100 and max(asked) == 100


def test_a_rival_that_is_missing_is_not_available(monkeypatch):
    from rivals import compiled

    monkeypatch.setattr(compiled.shutil, "which", lambda name: None)
    compiled.driver.cache_clear()
    assert compiled.version("gsl") == "not available"
    with pytest.raises(NotAvailable):
        compiled.GSL.orbit(BY_NAME["30°"], np.zeros(1))
    compiled.driver.cache_clear()
