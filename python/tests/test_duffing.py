"""The Duffing oscillator through the Python door and the command line."""

import csv
import json
import math
import pickle
from pathlib import Path

import dask.array
import numpy as np
import pytest
from bits import same
from matplotlib.figure import Figure

import libration
from libration import Duffing, DuffingForm, Pendulum
from libration.cli import main
from libration.plot._springs import draw_displacement, draw_portrait

ROOT = Path(__file__).resolve().parents[2]
with (ROOT / "reference/vectors/duffing.csv").open(newline="") as file:
    ROWS = list(csv.DictReader(file))


def truth(row, name):
    return float.fromhex(row[f"{name}_hi"]), float.fromhex(row[f"{name}_lo"])


def error(got, expected, unit):
    """Distance from hi + lo in a unit; a wrong NaN or infinity is far."""
    hi, lo = expected
    if math.isnan(hi) or math.isinf(hi):
        return 0.0 if got == hi or (math.isnan(got) and math.isnan(hi)) else math.inf
    return abs((got - hi) - lo) / unit if math.isfinite(got) else math.inf


def worst(spoil=1.0):
    """Largest errors of u and velocity, in 4 ulp of the scale plus 2**-100 of the condition."""
    largest, wrong = 0.0, 0
    for row in ROWS:
        u0, velocity0, p, q, t = (float.fromhex(row[name]) for name in ("u0", "velocity0", "p", "q", "t"))
        oscillator = Duffing(u0, velocity0, p=p, q=q)
        wrong += oscillator.regime != row["regime"]
        u, velocity = oscillator.motion(t)
        for got, name in ((u * spoil, "u"), (velocity, "velocity")):
            scale = float(row[f"scale_{name}"])
            condition = float(row[f"cond_{name}"])
            unit = 4 * math.ulp(scale) + 2.0**-100 * condition if scale < math.inf else math.inf
            largest = max(largest, error(float(got), truth(row, name), unit))
    return largest, wrong


def test_truth():
    assert len(ROWS) >= 600
    largest, wrong = worst()
    assert wrong == 0
    assert largest <= 1.0


def test_a_spoiled_motion_is_found():
    assert worst(spoil=1 + 2e-15)[0] > 1.0


COLUMNS = np.array([[float.fromhex(row[name]) for row in ROWS] for name in ("t", "u0", "velocity0", "p", "q")])


def worst_of_rows(u, velocity):
    """Largest errors of rows, in 4 ulp of the scale plus 2**-100 of the condition."""
    largest = 0.0
    for i, row in enumerate(ROWS):
        for got, name in ((u[i], "u"), (velocity[i], "velocity")):
            scale, condition = float(row[f"scale_{name}"]), float(row[f"cond_{name}"])
            unit = 4 * math.ulp(scale) + 2.0**-100 * condition if scale < math.inf else math.inf
            largest = max(largest, error(float(got), truth(row, name), unit))
    return largest


def test_arrays():
    u, velocity = libration.duffing_motion(*COLUMNS)
    assert worst_of_rows(u, velocity) <= 1.0
    assert worst_of_rows(u * (1 + 2e-15), velocity) > 1.0
    # Every row is its own value, whatever stands beside it.
    for i in range(0, len(ROWS), 7):
        alone = libration.duffing_motion(*COLUMNS[:, i : i + 1])
        assert same(np.concatenate(alone), np.array([u[i], velocity[i]]))
    back = libration.duffing_motion(*COLUMNS[:, ::-1])
    assert same(back[0][::-1], u) and same(back[1][::-1], velocity)
    chunks = libration.duffing_motion(*(dask.array.from_array(column, chunks=100) for column in COLUMNS))
    assert same(chunks[0].compute(), u)


def test_one_oscillator_keeps_the_digits_of_its_methods():
    t = np.linspace(-2.0, 5.0, 40)
    for i in range(0, len(ROWS), 31):
        one = Duffing(*COLUMNS[1:3, i], p=COLUMNS[3, i], q=COLUMNS[4, i])
        at, start = float(COLUMNS[0, i]), COLUMNS[1:, i]
        assert same(np.array(libration.duffing_motion(at, *start)), np.array(one.motion(at)))
        assert same(np.array(libration.duffing_motion(at * t, *map(np.asarray, start))), np.array(one.motion(at * t)))
    out = np.zeros(3), np.zeros(3)
    libration.duffing_motion([0.0, 1.0, 2.0], 1.0, 0.0, 1.0, 1.0, out=out)
    assert same(out[0], Duffing(1.0, p=1.0, q=1.0).u(np.array([0.0, 1.0, 2.0])))
    assert np.isnan(libration.duffing_motion(1.0, [1.0, math.inf])[0]).tolist() == [False, True]
    lazy = Duffing(1.0, p=1.0, q=1.0).u(dask.array.arange(5.0, chunks=2))
    assert same(lazy.compute(), Duffing(1.0, p=1.0, q=1.0).u(np.arange(5.0)))


def test_escapes_end_the_motion():
    spring = Duffing(2.0, p=1.0, q=-1.0)
    end = spring.escape_time
    assert spring.regime == "escape" and spring.escape_time_backward == -end
    assert np.isnan(spring.u([end * (1 + 1e-15), end * 1.5, -end * (1 + 1e-15)])).all()
    assert spring.u(end * (1 - 1e-9)) > 1e8
    assert spring.range == (2.0, math.inf) and spring.period == math.inf


def test_times():
    spring = Duffing(1.0, 0.3, p=-1.0, q=1.0)
    times = spring.times(0.9, 0.0, 30.0)
    assert len(times) > 2 and np.allclose(spring.u(times), 0.9, rtol=1e-14)
    assert len(Duffing(0.0, p=1.0, q=1.0).times(0.0, 0.0, 9.0)) == 0


@pytest.mark.parametrize("state", [(2.0, 0.0), (0.5, 1.0), (1.0, -3.0), (-0.3, 0.1)])
def test_link(state):
    pendulum = Pendulum(*state, length=1.3)
    spring = Duffing.of_pendulum(pendulum)
    stop = min(spring.escape_time, 3.0)
    t = np.linspace(0.0, 0.9 * stop, 20)
    assert np.allclose(2 * np.arctan(spring.u(t)), pendulum.theta(t), atol=1e-13)
    scale, back = spring.pendulum
    assert scale == pytest.approx(1.0, rel=1e-14)
    assert np.allclose(back.theta(t), pendulum.theta(t), atol=1e-12)
    assert Duffing(1.0, p=1.0, q=0.0).pendulum is None


def test_forms():
    t = np.linspace(-0.4, 0.4, 9)
    h = 1e-4
    table = DuffingForm.table()
    assert list(table) == "sn cn dn ns nc nd sc cs sd ds cd dc".split()
    assert all(table.values())
    for name, p, q in [("cn", 1.0, 1.0), ("sn", 1.0, -0.5), ("dn", -0.8, 1.0), ("ds", 0.2, -1.0), ("cs", -0.7, -1.0)]:
        form = DuffingForm(name, 1.0, 0.7, p=p, q=q)
        u = form.u(t)
        second = (form.velocity(t + h) - form.velocity(t - h)) / (2 * h)
        assert np.allclose(second + p * u + q * u**3, 0.0, atol=1e-5 * np.abs(u**3).max())
        assert form.m + form.mc == pytest.approx(1.0)
        assert isinstance(form.u(0.1), np.float64)
        assert pickle.loads(pickle.dumps(form)) == form
    for arguments, words in [
        (("xy", 1.0), "form = xy: must be one of sn, cn, dn"),
        (("cn", 1.0), "form = cn, p = 1.0, q = -3.0, c1 = 1.0: must be"),
    ]:
        with pytest.raises(ValueError) as caught:
            DuffingForm(*arguments, p=1.0, q=-3.0)
        assert str(caught.value).startswith(words)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"u0": math.inf, "p": 1.0, "q": 1.0}, "u0 = inf: must be finite"),
        ({"u0": 1.0, "p": math.nan, "q": 1.0}, "p = NaN: must be finite"),
        ({"u0": 1.0, "p": 1.0, "q": "a"}, "q = 'a': must be one real number, a Python or NumPy scalar"),
    ],
)
def test_bad_input(arguments, message):
    with pytest.raises(ValueError) as caught:
        Duffing(**arguments)
    assert str(caught.value) == message


def test_identity():
    spring = Duffing(1.0, p=-1.0, q=1.0)
    assert pickle.loads(pickle.dumps(spring)) == spring and hash(spring) == hash(Duffing(1.0, p=-1.0, q=1.0))
    assert repr(spring) == "Duffing(u0=1.0, velocity0=0.0, p=-1.0, q=1.0)"
    with pytest.raises(AttributeError):
        spring.p = 2.0


def test_command(capsys, tmp_path):
    words = "duffing --p 1 --q -1 --u0 1.1 --until 3s --samples 31".split()
    table, picture = tmp_path / "a.csv", tmp_path / "a.png"
    assert main([*words, "--out", str(table), "--plot", str(picture), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["regime"] == "escape" and answer["period_s"] is None and answer["samples"] == 31
    assert picture.read_bytes()[1:4] == b"PNG"
    assert table.read_text().splitlines()[-1].endswith("nan,nan")
    assert main([*words]) == 0
    assert "beyond an escape" in capsys.readouterr().out
    for bad, message in [
        ("duffing --p 1 --q 1", "libration duffing: missing --u0; such as --p 1 --q 0.5 --u0 2\n"),
        ("duffing --p 1m --q 1 --u0 1", "libration duffing: --p = 1m: must be a plain number, without a unit\n"),
    ]:
        assert main(bad.split()) == 2
        assert capsys.readouterr().err == message


def test_samples_that_are_too_far_are_counted(capsys):
    far = "--until 1e20s --samples 5".split()
    for words in (["duffing", *"--p 1 --q 1 --u0 1".split()], ["solve", *"--theta0 1 --omega0 1".split()]):
        assert main([*words, *far]) == 0
        assert "of them too far to be known" in (said := capsys.readouterr().out)
        assert "4, more than 2^53 half periods away: nan in a table" in said
        assert main([*words, *far, "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["samples_nan"] == 4
        assert main(words) == 0
        assert "too far" not in capsys.readouterr().out


def test_an_energy_beyond_the_doubles_is_said_in_words(capsys):
    assert main("duffing --p 1 --q 1 --u0 1e200".split()) == 0
    assert "beyond the largest double, 1.8e308, per unit mass" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("spring", "t", "label"),
    [
        (Duffing(1.0, p=1.0, q=1.0), (0.0, 1e6), "t [s], the first 95.4 of 10⁶ s"),
        (Duffing(1.0, p=-1.0, q=0.0), (0.0, 1000.0), "t [s], the first 3 of 1000 s"),
        (Duffing(1.1, p=1.0, q=-1.0), (-1000.0, 1000.0), "t [s], 8.5 of 2000 s"),
        (Duffing(1e-200, p=1.0, q=1.0), (0.0, 10.0), "t [s]"),
        (Duffing(1e100, p=1.0, q=1.0), (0.0, 1e-99), "t [s]"),
    ],
)
def test_pictures_show_the_motion_however_long_or_small(spring, t, label):
    figure = Figure()
    over_time, phases = figure.subplots(1, 2)
    draw_displacement(over_time, spring, np.array(t))
    draw_portrait(phases, spring)
    assert over_time.get_xlabel() == label
    for axes in (over_time, phases):
        x, y = axes.lines[0].get_data()
        seen = np.isfinite(y)
        assert np.ptp(x[seen]) > 0.2 * np.ptp(axes.get_xlim())
        assert np.ptp(y[seen]) > 0.2 * np.ptp(axes.get_ylim())


@pytest.mark.parametrize("pendulum", [Pendulum(0.0, 1e200), Pendulum(math.pi, 1e300)])
def test_pendulums_too_fast_for_a_spring(pendulum):
    with pytest.raises(ValueError) as caught:
        Duffing.of_pendulum(pendulum)
    assert str(caught.value) == "omega0^2 (1 - 2 m) = -inf: must be finite"
