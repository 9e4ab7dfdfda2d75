"""The scripts of examples/ in a small form: each against the law that it states, and its picture drawn. fit.py is in tests_jax."""

import math
import runpy
from pathlib import Path

import numpy as np
import pytest
import scipy.stats
from matplotlib.figure import Figure

ROOT = Path(__file__).resolve().parents[2] / "examples"
SMALL = {
    "filamentation": {"n": 2_000, "dense": 5_000, "times": 24},
    "tunes": {"n": 5_000},
    "capture": {"n": 50, "durations": (10.0, 20.0, 50.0)},
    "training": {"n": 3, "times": 4},
    "sections": {"n": 4, "periods": 25, "drives": 3},
}


def script(name):
    return runpy.run_path(str(ROOT / f"{name}.py"))


@pytest.mark.parametrize("name", SMALL)
def test_pictures_are_drawn(name):
    of = script(name)
    figure = Figure(figsize=of["SIZE"], layout="constrained", dpi=40)
    of["draw"](figure, **SMALL[name])
    figure.draw_without_rendering()
    assert all(axes.has_data() and axes.get_xlabel() for axes in figure.axes if axes.get_label() != "<colorbar>")


def test_a_bunch_that_is_not_matched_smears_to_even_phases():
    of = script("filamentation")
    start, *later = of["rms_angle"]([0.0, 1000.0, 1003.0, 1006.0], 20_000)
    end = of["rms_in_the_end"](2_000)
    assert abs(start / 0.85 - 1) < 1e-2 and np.abs(np.array(later) / end - 1).max() < 5e-3
    assert abs(start / end - 1) > 0.1, "one that is matched must show"


def test_the_mean_of_a_kicked_bunch_falls_by_the_formula():
    of = script("filamentation")
    t = np.array([50.0, 200.0, 400.0, 800.0])
    found, law = of["centroid"](t, 50_000), of["centroid_law"](t)
    assert found[-1] < 0.1 * found[0] and np.abs(found / law - 1).max() < 2e-2
    assert np.abs(of["centroid_law"](1.05 * t) / law - 1).max() > 5e-2, "a spoiled law must show"


@pytest.mark.parametrize("name", ["waterbag", "parabolic", "gaussian"])
def test_tunes_are_spread_by_the_formula(name):
    of = script("tunes")
    m = np.sin(np.linspace(math.pi, 0.0, 20_001)[1:-1] / 2) ** 2
    tune, density = of["law"](name, m)
    below = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(tune))])
    assert abs(below[-1] - 1) < 2e-3
    found = of["frequencies"](name, 20_000)
    gap = scipy.stats.kstest(found, lambda at: np.interp(at, tune, below)).statistic
    assert gap < 3e-3
    assert scipy.stats.kstest(found * 0.995, lambda at: np.interp(at, tune, below)).statistic > 3e-2, "spoiled"


def test_what_is_captured_slowly_has_the_action_that_it_had():
    of = script("capture")
    omega0, share, state = of["captured"](2500.0, 200)
    assert np.abs(share - of["law"](omega0)).max() < 2.5e-2
    assert np.abs(share - of["law"](1.1 * omega0)).max() > 4e-2, "a spoiled law must show"
    before, after = of["actions"](state, 200)
    assert abs(np.median(after / before) / 2 - 1) < 5e-3 and np.mean(np.abs(after - 2 * before) < 0.1) > 0.9
    _, _, fast = of["captured"](10.0, 300)
    before, after = of["actions"](fast, 300)
    assert np.mean(np.abs(after - 2 * before) < 0.1) < 0.3


def test_training_data_are_right_to_the_last_digits():
    of = script("training")
    theta0, t = of["starts"](4), np.array([2.0, 20.0])
    true = of["truth"](theta0, t)
    errors = {name: np.abs(angles(theta0, t) - true).max() for name, (angles, _) in of["WAYS"].items()}
    assert errors.pop("libration") < 1e-15
    assert all(1e-7 < each < 1e-2 for each in errors.values())


def test_a_period_of_the_drive_shrinks_areas():
    of = script("sections")
    for start in ((0.3, 0.1), (-2.0, 1.5)):
        assert abs(of["shrinks_by"](start, 1.5) / math.exp(-of["PERIOD"] / of["Q"]) - 1) < 1e-12


@pytest.mark.parametrize(("g", "points"), [(0.9, 1), (1.07, 2), (1.35, 1), (1.45, 2)])
def test_periods_double(g, points):
    """As in Baker & Gollub, section 3.3: the number of points of the section of one attractor."""
    of = script("sections")
    theta, velocity = of["sections"]([(0.2, 0.3)], [g], 140, settled=120)
    assert len({(round(a, 5), round(b, 5)) for a, b in zip(theta[0], velocity[0], strict=True)}) == points
    *_, wild = of["sections"]([(0.2, 0.3)], [1.5], 140, settled=120)
    assert len(set(wild[0].round(5))) == 20
