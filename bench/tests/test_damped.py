"""The error of the damped page can say no, and its cases are those of the reference vectors."""

import math

import numpy as np
import pytest
from cases.damped import HORIZON, damped_cases
from measurement.damped import damped_error
from report.damped import damped_page
from rivals.damped import OURS, ours

CASE = damped_cases()[0]


def answer():
    return ours(CASE, np.array(CASE.times))()


def test_cases_have_a_truth_at_their_end():
    for case in damped_cases():
        assert case.times == sorted(case.times) and case.times[-1] > HORIZON
        assert case.linear or case.quadratic or case.dry


def test_a_wrong_answer_has_an_error():
    theta, velocity = answer()
    assert damped_error(CASE, theta, velocity) < 1e-14
    assert damped_error(CASE, -theta, velocity) > 1e-3
    assert damped_error(CASE, theta, velocity * (1 + 1e-9)) > 1e-12
    spoiled = theta.copy()
    spoiled[-1] = math.nan
    assert damped_error(CASE, spoiled, velocity) == math.inf
    with pytest.raises(ValueError, match="shorter"):
        damped_error(CASE, theta[:-1], velocity[:-1])


def test_a_rival_that_is_missing_has_a_row():
    head = {name: "" for name in ("date", "command", "processor", "system", "load at the start")}
    versions = {name: "" for name in ("libration", "Python", "numpy", "scipy", "heyoka")}
    entry = {"case": "linear", "periods": 2, "note": ""}
    records = [
        {**entry, "method": name, "count": count, "error": error, "seconds": seconds, "note": note}
        for count in (4, 10)
        for name, error, seconds, note in ((OURS, 1e-16, [1e-5], ""), ("heyoka", None, [], "not available: heyoka"))
    ]
    text = damped_page({**head, "versions": versions, "records": records})
    assert "| heyoka | not available: heyoka |" in text and f"| {OURS} | 1e-16 | 5 | 1 |" in text
