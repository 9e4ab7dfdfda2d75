"""The promised times, each as the best of many: what one call and the import cost at most."""

import subprocess
import sys
import time
import timeit

import pytest

from libration import Pendulum

PENDULUM = Pendulum(3.0, 0.1, length=1.0)


def best(work, number):
    """Shortest mean time of one call in seconds."""
    return min(timeit.repeat(work, number=number, repeat=20)) / number


@pytest.mark.parametrize("method", ["theta", "velocity", "motion", "turns"])
def test_one_instant_takes_two_microseconds_at_most(method):
    call = getattr(PENDULUM, method)
    assert best(lambda: call(1.234), 2000) <= 2e-6


def test_one_set_up_takes_ten_microseconds_at_most():
    assert best(lambda: Pendulum(3.0, 0.1, length=1.0), 500) <= 10e-6


def test_import_takes_half_as_long_again_as_numpy_at_most():
    durations = {"numpy": [], "libration": []}
    for _ in range(15):
        for package, seconds in durations.items():
            begin = time.perf_counter()
            subprocess.run([sys.executable, "-c", f"import {package}"], check=True)
            seconds.append(time.perf_counter() - begin)
    assert min(durations["libration"]) <= 1.5 * min(durations["numpy"])
