"""Oscillators with even powers, and what all of them keep, through the Python door."""

import csv
import math
import pickle
from pathlib import Path

import dask.array
import numpy as np
import pytest
from bits import same
from matplotlib.figure import Figure
from test_duffing import error, truth

import libration
from libration import CubicQuintic, Duffing
from libration.plot import plot_backbone

ROOT = Path(__file__).resolve().parents[2]
with (ROOT / "reference/vectors/helmholtz_duffing.csv").open(newline="") as file:
    ROWS = list(csv.DictReader(file))
NAMES = ("u0", "velocity0", "p", "q", "r", "c", "t")
GIVEN = [[float.fromhex(row[name]) for name in NAMES] for row in ROWS]


def spring(u0, velocity0, p, q, r, c):
    return Duffing(u0, velocity0, p=p, q=q, r=r, c=c)


def unit_of(row, name):
    """4 ulp of the scale plus 2**-100 of the condition."""
    scale = float(row[f"scale_{name}"])
    return 4 * math.ulp(scale) + 2.0**-100 * float(row[f"cond_{name}"]) if scale < math.inf else math.inf


def worst(spoil=1.0):
    """Largest errors of u and velocity, in 4 ulp of the scale plus 2**-100 of the condition."""
    largest, wrong = 0.0, 0
    for row, (*start, t) in zip(ROWS, GIVEN, strict=True):
        oscillator = spring(*start)
        wrong += oscillator.regime != row["regime"]
        u, velocity = oscillator.motion(t)
        for got, name in ((u * spoil, "u"), (velocity, "velocity")):
            largest = max(largest, error(float(got), truth(row, name), unit_of(row, name)))
    return largest, wrong


def worst_of_rows(spoil=1.0):
    """The same of rows with states of their own, in one call."""
    t = [row[-1] for row in GIVEN]
    u0, velocity0, p, q, r, c = (np.array([row[k] for row in GIVEN]) for k in range(6))
    found = libration.duffing_motion(t, u0, velocity0, p, q, r=r, c=c)
    largest = 0.0
    for i, row in enumerate(ROWS):
        for got, name in ((found[0][i] * spoil, "u"), (found[1][i], "velocity")):
            largest = max(largest, error(float(got), truth(row, name), unit_of(row, name)))
    return largest


def test_truth():
    assert len(ROWS) >= 800
    largest, wrong = worst()
    assert wrong == 0
    assert largest <= 1.0
    assert worst_of_rows() <= 1.0
    assert worst_of_rows(spoil=1 + 2e-15) > 1.0


def test_a_spoiled_motion_is_found():
    assert worst(spoil=1 + 2e-15)[0] > 1.0


def each_row():
    return enumerate(np.array(GIVEN)[:, :6])


def test_arrays():
    u0, velocity0, p, q, r, c, t = np.array(GIVEN).T
    force = {"p": p, "q": q, "r": r, "c": c}
    all_of_them = [spring(*start) for *start, _ in GIVEN]
    u, velocity = libration.duffing_motion(t, u0, velocity0, p, q, r=r, c=c)
    rows = [
        libration.duffing_motion(t[i : i + 1], *start[:, None][:4], r=start[4:5], c=start[5:])
        for i, start in each_row()
    ]
    alone = np.concatenate(rows, axis=1)
    assert same(u, alone[0]) and same(velocity, alone[1])
    back = libration.duffing_motion(*(each[::-1] for each in (t, u0, velocity0, p, q)), r=r[::-1], c=c[::-1])
    assert same(back[0][::-1], u)
    for kind in ("period", "frequency", "action"):
        found = getattr(libration, f"duffing_{kind}")(u0, velocity0, **force)
        assert same(found, np.array([getattr(each, kind) for each in all_of_them]))
    assert same(libration.duffing_phase(u0, velocity0, **force), np.array([each.phase(0.0) for each in all_of_them]))
    assert libration.duffing_regime(u0, velocity0, **force).tolist() == [row["regime"] for row in ROWS]
    behind, ahead = libration.duffing_escape_times(u0, velocity0, **force)
    assert same(ahead, np.array([each.escape_time for each in all_of_them]))
    assert same(behind, np.array([each.escape_time_backward for each in all_of_them]))
    lazy = libration.duffing_period(dask.array.from_array(u0, chunks=100), 0.1, p=1.0, q=0.2, r=0.5)
    assert same(lazy.compute(), libration.duffing_period(u0, 0.1, p=1.0, q=0.2, r=0.5))


def test_stated_values():
    plain = Duffing(1.0, p=1.0, q=1.0)
    assert abs(plain.action / 0.63692176913058357215 - 1) < 1e-15
    series = plain.fourier(3)
    assert abs(series.u[0] / 0.98171061628166613084 - 1) < 1e-15
    assert abs(series.u[2] / 0.017960677962689629434 - 1) < 1e-15
    periods = libration.duffing_period([0.5, 1.0, 2.0], p=1.0, q=0.1)
    assert np.abs(periods / [6.225139992418638458, 6.060656736957466768, 5.51685188810429422] - 1).max() < 1e-15
    assert Duffing(0.0, p=1.0, q=1.0).action == 0.0
    assert math.isnan(Duffing(2.0, p=1.0, q=-1.0).action)


def test_series_are_the_motion():
    """The sum of a series is u and velocity, and action times frequency the mean of velocity^2."""
    for p, q, r, c in ((1.0, 0.2, 0.5, 0.0), (1.0, 0.0, 0.5, 0.1), (-1.0, 1.0, 0.2, 0.1), (1.0, -0.2, 0.1, 0.05)):
        one = Duffing(0.6, 0.1, p=p, q=q, r=r, c=c)
        mean, u, velocity = one.fourier(60)
        t = one.period * np.arange(400) / 400
        phase, orders = one.phase(t), np.arange(1, 61)
        waves = np.outer(phase, orders)
        assert np.abs(mean + np.cos(waves) @ u - one.u(t)).max() < 1e-14
        assert np.abs(np.sin(waves) @ velocity - one.velocity(t)).max() < 1e-13
        assert abs(one.action * one.frequency - np.mean(one.velocity(t) ** 2)) < 1e-14
        assert abs(one.distortion - math.sqrt(float((u[1:] ** 2).sum())) / abs(float(u[0]))) < 1e-14


def test_sensitivities():
    given = [0.6, 0.1, 1.0, 0.2, 0.5, 0.05]
    for t in (0.7, -3.0, 40.0):
        by = spring(*given).sensitivities(t)
        for k in range(6):
            step = 1e-5
            ends = [spring(*(x + side * step * (i == k) for i, x in enumerate(given))).motion(t) for side in (1, -1)]
            number = (np.array(ends[0]) - np.array(ends[1])) / (2 * step)
            assert np.abs(by[:, k] - number).max() < 1e-7 * (1 + np.abs(by).max() ** 3), (t, k)
    assert spring(*given).sensitivities(np.zeros((2, 3))).shape == (2, 3, 2, 6)
    determinant = np.linalg.det(spring(*given).sensitivities([1.0, 7.0, 100.0])[..., :2])
    assert np.abs(determinant - 1).max() < 1e-11


def test_starts():
    for force in ({"p": 1.0, "q": 0.2, "r": 0.5}, {"p": 1.0, "q": 1.0}, {"p": 1.0, "q": 0.0, "r": 0.5}):
        for action in (1e-6, 0.01, 0.2):
            one = Duffing.from_action_phase(action, 0.7, **force)
            assert abs(one.action / action - 1) < 1e-13 and abs(one.phase(0.0) - 0.7) < 1e-12
    wells = {"p": -1.0, "q": 1.0, "r": 0.1}
    left, right = (Duffing.from_action_phase(0.05, 0.0, about=about, **wells) for about in (-1.0, 1.0))
    assert left.range[1] < 0.0 < right.range[0]
    outer = Duffing.from_action_phase(1.0, 0.0, about=1.0, **wells)
    assert outer.regime == "libration" and abs(outer.action - 1.0) < 1e-13
    one = Duffing.from_energy(0.5, 0.2, p=1.0, q=0.2, r=0.5, direction=-1)
    assert one.velocity0 < 0 and abs(one.energy - 0.5) < 1e-15
    for refused, message in (
        (lambda: Duffing.from_energy(-1.0, p=1.0, q=1.0), "energy = -1.0: must be at least the potential at u0, 0.0"),
        (lambda: Duffing.from_action_phase(0.05, 0.0, **wells), "about = None: must be given: next to"),
        (lambda: Duffing.from_action_phase(-1.0, 0.0, p=1.0, q=1.0), "action = -1.0: must be finite and not negative"),
    ):
        with pytest.raises(ValueError) as caught:
            refused()
        assert str(caught.value).startswith(message)


def test_identity():
    one = Duffing(1.0, p=1.0, q=0.2, r=0.5, c=-0.1)
    assert repr(one) == "Duffing(u0=1.0, velocity0=0.0, p=1.0, q=0.2, r=0.5, c=-0.1)"
    assert pickle.loads(pickle.dumps(one)) == one and (one.r, one.c) == (0.5, -0.1)
    assert Duffing(1.0, p=1.0, q=0.2, r=0.0).u(3.0) == Duffing(1.0, p=1.0, q=0.2).u(3.0)
    with pytest.raises(ValueError, match=r"^r = inf: must be finite$"):
        Duffing(1.0, p=1.0, q=1.0, r=math.inf)
    assert "u″ + p u + r u² + q u³ = c" in one._repr_html_()


def test_pictures():
    for each in (
        Duffing(1.0, p=1.0, q=0.2, r=0.5),
        Duffing(1.0, p=1.0, q=0.0, r=-1.5),
        CubicQuintic(1.0, p=1.0, q=1.0, s=1.0),
    ):
        assert np.isfinite(each.plot(ax=Figure().subplots()).lines[0].get_ydata()).any()
    ax = plot_backbone(np.linspace(0.0, 2.0, 10_000), p=1.0, q=0.2, r=0.5, ax=Figure().subplots())
    assert len(ax.lines[0].get_xdata()) == 10_000
