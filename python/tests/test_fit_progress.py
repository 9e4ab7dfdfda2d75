"""The bar of a long fit: on a terminal only, with every step, and gone at the end."""

import io
import re
import time

import numpy as np
import pytest

from libration import DampedPendulum, Friction, _bar, _core
from libration.measurement._known import known_of
from libration.measurement._progress import STEPS, told_steps

T = np.linspace(0.0, 12.0, 300)
THETA = DampedPendulum(0.9, length=0.8, friction=Friction(linear=0.02)).theta(T) + np.random.default_rng(3).normal(
    0.0, 0.005, T.size
)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_the_core_tells_its_steps_in_order():
    told = []
    _core.fit_columns(("angle", [T, THETA]), known_of(), told.append)
    places = [STEPS.index(step) for step in told]
    assert places == sorted(places) and told[0] == "start" and told[-1] == "uncertainty"
    assert {"none", "linear", "quadratic", "dry"} <= set(told)
    told.clear()
    _core.fit_records([("angle", [T, THETA])] * 2, None, known_of(model="linear"), told.append)
    assert told.count("start") == 2 and "dry" not in told


def test_an_error_of_who_is_told_ends_the_fit():
    def told(step):
        raise RuntimeError(step)

    with pytest.raises(RuntimeError, match="start"):
        _core.fit_columns(("angle", [T, THETA]), known_of(), told)


def test_the_bar_is_drawn_and_wiped(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(_bar.sys, "stderr", terminal)
    monkeypatch.setattr(_bar, "DELAY", 0.0)
    monkeypatch.setenv("TERM", "xterm")
    with told_steps(["[a].csv", "b.csv"], True) as told:
        for step in ("start", "dry", "start", "uncertainty"):
            told(step)
            until = time.monotonic() + 20.0
            wanted = "b.csv: uncertainty" if step == "uncertainty" else "[a].csv"
            while wanted not in plain(terminal) and time.monotonic() < until:
                time.sleep(0.02)
    assert "[a].csv" in plain(terminal) and "b.csv: uncertainty" in plain(terminal) and "94 %" in plain(terminal)
    # The last thing written erases the line.
    assert terminal.getvalue().rstrip().endswith("\x1b[2K")


def plain(terminal):
    return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", terminal.getvalue())


def test_no_bar_where_nobody_sees_it(monkeypatch):
    for stream in (io.StringIO(), None):
        monkeypatch.setattr(_bar.sys, "stderr", stream)
        with told_steps(["a"], True) as told:
            assert told is None
    monkeypatch.setattr(_bar.sys, "stderr", Terminal())
    with told_steps(["a"], False) as told:
        assert told is None


def test_no_bar_without_rich(monkeypatch):
    def missing(name):
        raise ModuleNotFoundError(name=name)

    monkeypatch.setattr(_bar.sys, "stderr", Terminal())
    monkeypatch.setattr(_bar.importlib, "import_module", missing)
    with told_steps(["a"], True) as told:
        assert told is None
