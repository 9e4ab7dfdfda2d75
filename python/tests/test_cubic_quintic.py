"""The cubic-quintic oscillator through the Python door and the command line."""

import csv
import json
import math
import pickle
from pathlib import Path

import numpy as np
import pytest
from bits import same
from test_duffing import error, truth

from libration import CubicQuintic, Duffing
from libration.cli import main

ROOT = Path(__file__).resolve().parents[2]
with (ROOT / "reference/vectors/cubic_quintic.csv").open(newline="") as file:
    ROWS = list(csv.DictReader(file))
NAMES = ("u0", "velocity0", "alpha", "beta", "gamma", "t")


def worst(spoil=1.0):
    """Largest errors of u and velocity, in 4 ulp of the scale plus 2**-100 of the condition, and how many regimes are wrong."""
    largest, wrong = 0.0, 0
    for row in ROWS:
        u0, velocity0, p, q, s, t = (float.fromhex(row[name]) for name in NAMES)
        oscillator = CubicQuintic(u0, velocity0, p=p, q=q, s=s)
        wrong += oscillator.regime != row["regime"]
        u, velocity = oscillator.motion(t)
        for got, name in ((u * spoil, "u"), (velocity, "velocity")):
            scale = float(row[f"scale_{name}"])
            unit = 4 * math.ulp(scale) + 2.0**-100 * float(row[f"cond_{name}"]) if scale < math.inf else math.inf
            largest = max(largest, error(float(got), truth(row, name), unit))
    return largest, wrong


def test_truth():
    assert len(ROWS) >= 400
    largest, wrong = worst()
    assert wrong == 0
    assert largest <= 1.0


def test_a_spoiled_motion_is_found():
    assert worst(spoil=1 + 2e-15)[0] > 1.0


def test_without_a_fifth_power_it_is_the_cubic_one():
    t = np.linspace(-0.9, 0.9, 7)
    for u0, velocity0, p, q in [
        (1.0, 0.2, 1.0, 1.0),
        (1.4, 0.0, -1.0, 1.0),
        (0.3, 0.5, 1.0, -1.0),
        (2.0, 0.0, 1.0, -1.0),
    ]:
        cubic = Duffing(u0, velocity0, p=p, q=q)
        quintic = CubicQuintic(u0, velocity0, p=p, q=q, s=0.0)
        assert quintic.regime == cubic.regime
        assert np.allclose(quintic.u(t), cubic.u(t), rtol=1e-14, atol=1e-15)
        assert quintic.range == pytest.approx(cubic.range, rel=1e-15)
        assert quintic.escape_time == pytest.approx(cubic.escape_time, rel=1e-14)


def test_arrays_times_and_identity():
    spring = CubicQuintic(1.2, p=1.0, q=-2.5, s=1.0)
    t = np.linspace(0.0, 9.0, 11)
    u, velocity = spring.motion(t)
    assert same(u, spring.u(t)) and same(velocity, spring.velocity(t))
    assert same(u[3], np.asarray(spring.u(float(t[3])))[()])
    times = spring.times(1.25, 0.0, 20.0)
    assert len(times) > 2 and np.allclose(spring.u(times), 1.25, rtol=1e-13)
    assert pickle.loads(pickle.dumps(spring)) == spring
    assert repr(spring) == "CubicQuintic(u0=1.2, velocity0=0.0, p=1.0, q=-2.5, s=1.0)"
    with pytest.raises(ValueError) as caught:
        CubicQuintic(1.0, p=1.0, q=1.0, s=math.inf)
    assert str(caught.value) == "s = inf: must be finite"


def test_command(capsys, tmp_path):
    words = "cubic-quintic --p 1 --q -4 --s 3 --u0 1.2 --until 3s --samples 31".split()
    table, picture = tmp_path / "a.csv", tmp_path / "a.png"
    assert main([*words, "--out", str(table), "--plot", str(picture), "--json"]) == 0
    spring, answer = CubicQuintic(1.2, p=1.0, q=-4.0, s=3.0), json.loads(capsys.readouterr().out)
    assert (answer["regime"], answer["period_s"], answer["s"]) == (spring.regime, spring.period, 3.0)
    assert picture.read_bytes()[1:4] == b"PNG"
    rows = [line.split(",") for line in table.read_text().splitlines() if not line.startswith("#")]
    assert [float(row[1]) for row in rows[1:]] == spring.u(np.linspace(0.0, 3.0, 31)).tolist()
    assert main(words) == 0
    assert f"period                 {spring.period:.15g} s" in capsys.readouterr().out
    for bad, message in [
        ("--p 1", "missing --q, --s, --u0; such as --p 1 --q -0.5 --s 0.1 --u0 1"),
        ("--p 1 --q 1 --S 1", "unknown option '--S'; did you mean --s or --samples or --stiffness?"),
        ("--p 1 --q 1 --s 1m --u0 1", "--s = 1m: must be a plain number, without a unit"),
    ]:
        assert main(["cubic-quintic", *bad.split()]) == 2
        assert capsys.readouterr().err == f"libration cubic-quintic: {message}\n"
