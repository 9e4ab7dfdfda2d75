"""What cubic-quintic oscillators know besides their motion, through the Python door and the command line."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest
from bits import same
from test_duffing import error, truth

import libration
from libration import CubicQuintic, Duffing
from libration.cli import main

ROOT = Path(__file__).resolve().parents[2]
with (ROOT / "reference/vectors/oscillator_action.csv").open(newline="") as file:
    ROWS = [row for row in csv.DictReader(file) if float.fromhex(row["r"]) == float.fromhex(row["c"]) == 0.0]
NAMES = ("u0", "velocity0", "p", "q", "s", "t")
GIVEN = [[float.fromhex(row[name]) for name in NAMES] for row in ROWS]
# u0, velocity0, p, q, s: about 0, over it, in a well on either side, of every kind of roots.
BOUNDED = [
    (0.6, 0.1, 1.0, 1.0, 1.0),
    (0.4, 0.2, 1.0, -2.5, 1.0),
    (1.2, 0.1, 1.0, -2.5, 1.0),
    (-1.3, 0.2, 1.0, -2.5, 1.0),
    (1.9, 0.3, 1.0, -2.5, 1.0),
    (0.3, 0.4, -1.0, 0.5, 1.0),
    (-0.9, 0.1, -1.0, 0.5, 1.0),
    (0.3, -0.2, 1.0, -0.2, -0.1),
    (0.7, 0.0, 0.0, 0.0, 1.0),
]


def spring(u0, velocity0, p, q, s):
    return CubicQuintic(u0, velocity0, p=p, q=q, s=s)


def worst(spoil=1.0):
    """Largest error of action, frequency and phase, in 4 ulp plus 2**-100 of the condition."""
    largest = 0.0
    for row, (*start, t) in zip(ROWS, GIVEN, strict=True):
        one = spring(*start)
        for name, got in (("action", one.action), ("frequency", one.frequency), ("phase", one.phase(t))):
            value = truth(row, name)
            size = max(abs(float(value[0])), 3.2 if name == "phase" else 0.0)
            unit = 4 * math.ulp(size) + 2.0**-100 * float(row[f"cond_{name}"]) if math.isfinite(size) else 1.0
            largest = max(largest, error(float(got) * spoil, value, unit))
    return largest


def test_actions_frequencies_and_phases_are_true():
    assert len(ROWS) > 120
    assert worst() <= 1.0
    assert worst(spoil=1 + 2e-15) > 1.0


def test_series_are_the_motion():
    """The sum of a series is u and velocity, and action times frequency the mean of velocity^2."""
    for given in BOUNDED:
        one = spring(*given)
        mean, u, velocity = one.fourier(90)
        t = one.period * np.arange(400) / 400
        waves = np.outer(one.phase(t), np.arange(1, 91))
        assert np.abs(mean + np.cos(waves) @ u - one.u(t)).max() < 1e-14
        assert np.abs(np.sin(waves) @ velocity - one.velocity(t)).max() < 1e-13
        assert abs(one.action * one.frequency / np.mean(one.velocity(t) ** 2) - 1) < 1e-13
        assert abs(one.distortion - math.sqrt(float((u[1:] ** 2).sum())) / abs(float(u[0]))) < 1e-14
        assert one.fourier(3).u.tolist() == u[:3].tolist()


def test_motions_without_a_swing():
    assert spring(0.0, 0.0, 1.0, 1.0, 1.0).action == 0.0
    assert math.isnan(spring(2.0, 0.0, 1.0, 0.0, -1.0).action)
    assert math.isnan(spring(2.0, 0.0, 1.0, 0.0, -1.0).frequency)
    with pytest.raises(ValueError, match=r"^n = 0: must be from 1 to 1000$"):
        spring(1.0, 0.0, 1.0, 1.0, 1.0).fourier(0)


def test_without_a_fifth_power():
    """The values of `Duffing`, by another way; and with a small one they tend to them."""
    for s in (0.0, 1e-30, 1e-17):
        plain, one = Duffing(1.0, p=1.0, q=1.0), CubicQuintic(1.0, p=1.0, q=1.0, s=s)
        assert abs(one.action / 0.63692176913058357215 - 1) < 1e-15
        series = one.fourier(3)
        assert abs(series.u[0] / 0.98171061628166613084 - 1) < 1e-15
        assert abs(series.u[2] / 0.017960677962689629434 - 1) < 1e-15
        assert one.frequency == pytest.approx(plain.frequency, rel=1e-15)
        assert one.distortion == pytest.approx(plain.distortion, rel=1e-15)
        assert one.phase(3.7) == pytest.approx(plain.phase(3.7), rel=1e-15)
        assert np.allclose(one.sensitivities(2.0)[:, :4], plain.sensitivities(2.0)[:, :4], rtol=1e-13)
    periods = libration.cubic_quintic_period([0.5, 1.0, 2.0], p=1.0, q=0.1, s=0.0)
    assert np.abs(periods / [6.225139992418638458, 6.060656736957466768, 5.51685188810429422] - 1).max() < 1e-15


def test_sensitivities():
    given = [0.6, 0.1, 1.0, -2.5, 1.0]
    for t in (0.7, -3.0, 40.0):
        by = spring(*given).sensitivities(t)
        for k in range(5):
            step = 1e-5
            ends = [spring(*(x + side * step * (i == k) for i, x in enumerate(given))).motion(t) for side in (1, -1)]
            number = (np.array(ends[0]) - np.array(ends[1])) / (2 * step)
            assert np.abs(by[:, k] - number).max() < 1e-7 * (1 + np.abs(by).max() ** 3), (t, k)
    assert spring(*given).sensitivities(np.zeros((2, 3))).shape == (2, 3, 2, 5)
    determinant = np.linalg.det(spring(*given).sensitivities([1.0, 7.0, 100.0])[..., :2])
    assert np.abs(determinant - 1).max() < 1e-11


def test_starts():
    wells = {"p": 1.0, "q": -2.5, "s": 1.0}
    for about in (-1.4, 0.0, 1.4):
        for action in (0.01, 0.03):
            for phase in (0.0, 0.7, 3.0, -1.5):
                one = CubicQuintic.from_action_phase(action, phase, about=about, **wells)
                assert abs(one.action / action - 1) < 1e-13 and one.regime == ("well" if about else "libration")
                assert abs(one.phase(0.0) - phase) < 1e-12
    # A swing far smaller than the displacement.
    tiny = CubicQuintic.from_action_phase(1e-6, 0.7, about=1.4, **wells)
    assert abs(tiny.action / 1e-6 - 1) < 1e-13 and abs(tiny.phase(0.0) - 0.7) < 1e-11
    over = CubicQuintic.from_action_phase(2.0, 0.5, about=1.4, **wells)
    assert over.regime == "libration" and abs(over.action / 2 - 1) < 1e-13
    one = CubicQuintic.from_action_phase(0.3, 1.0, p=0.0, q=0.0, s=1.0)
    assert abs(one.action / 0.3 - 1) < 1e-13
    # The stable equilibrium of a force without a linear term is 0, and the only one.
    assert Duffing.from_action_phase(0.3, 0.0, p=0.0, q=1.0).velocity0 == pytest.approx(0.0, abs=1e-15)
    one = CubicQuintic.from_energy(0.5, 0.2, direction=-1, **wells)
    assert one.velocity0 < 0 and abs(one.energy - 0.5) < 1e-15
    for refused, message in (
        (lambda: CubicQuintic.from_energy(-1.0, p=1.0, q=1.0, s=0.0), "energy = -1.0: must be at least the potential"),
        (lambda: CubicQuintic.from_action_phase(0.05, 0.0, **wells), "about = None: must be given: next to"),
        (lambda: CubicQuintic.from_action_phase(-1.0, 0.0, **wells), "action = -1.0: must be finite and not negative"),
        (lambda: CubicQuintic.from_action_phase(1.0, 0.0, p=-1.0, q=0.0, s=0.0), "p, q, s = -1.0, 0.0, 0.0: must be"),
        (
            lambda: CubicQuintic.from_action_phase(9.0, 0.0, p=1.0, q=0.0, s=-1.0),
            "action = 9.0: must be that of a motion",
        ),
    ):
        with pytest.raises(ValueError) as caught:
            refused()
        assert str(caught.value).startswith(message)


def test_arrays():
    u0, velocity0, p, q, s, _ = np.array(GIVEN).T
    force = {"p": p, "q": q, "s": s}
    alone = [spring(*start) for *start, _ in GIVEN]
    for kind in ("period", "frequency", "action"):
        found = getattr(libration, f"cubic_quintic_{kind}")(u0, velocity0, **force)
        assert same(found, np.array([getattr(each, kind) for each in alone]))
    assert same(libration.cubic_quintic_phase(u0, velocity0, **force), np.array([each.phase(0.0) for each in alone]))
    assert libration.cubic_quintic_regime(u0, velocity0, **force).tolist() == [each.regime for each in alone]
    t = [0.7, -3.0, 40.0]
    assert same(libration.cubic_quintic_motion(t, 1.2, p=1.0, q=-2.5, s=1.0)[0], spring(1.2, 0.0, 1.0, -2.5, 1.0).u(t))
    two = libration.cubic_quintic_motion(0.7, [1.2, math.inf], p=1.0, q=-2.5, s=1.0)[0]
    assert abs(two[0] / spring(1.2, 0.0, 1.0, -2.5, 1.0).u(0.7) - 1) < 1e-15 and math.isnan(two[1])
    behind, ahead = libration.cubic_quintic_escape_times([2.0, 0.5, math.inf], p=1.0, q=0.0, s=-1.0)
    one = CubicQuintic(2.0, p=1.0, q=0.0, s=-1.0)
    assert (behind[0], ahead[0], ahead[1]) == (one.escape_time_backward, one.escape_time, math.inf)
    assert math.isnan(ahead[2])


def test_several_starts(capsys, tmp_path):
    table, picture = tmp_path / "a.csv", tmp_path / "a.png"
    words = "cubic-quintic --p 1 --q -2.5 --s 1 --u0 0.2:1.9:18".split()
    assert main([*words, "--out", str(table), "--plot", str(picture), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert [each["regime"] for each in answer["motions"][::8]] == ["libration", "well", "libration"]
    for each in answer["motions"]:
        one = CubicQuintic(each["u0"], p=1.0, q=-2.5, s=1.0)
        assert (each["period_s"], each["action"]) == (one.period, one.action)
    assert picture.read_bytes()[1:4] == b"PNG" and len(table.read_text().splitlines()) > 18
    assert main("cubic-quintic --p 1 --q -2.5 --u0 0.2:1.9:18".split()) == 2
    assert capsys.readouterr().err.startswith("libration cubic-quintic: missing --s; such as --p 1")


BEAM = "--mass 1e-11kg --stiffness 10N/m --cubic 1e12N/m3 --quintic 1e23N/m^5"
FORCE = {"p": 10.0 / 1e-11, "q": 1e12 / 1e-11, "s": 1e23 / 1e-11}


def test_mass_and_stiffnesses(capsys, tmp_path):
    table = tmp_path / "a.csv"
    words = f"cubic-quintic {BEAM} --u0 1um --velocity0 -0.2m/s --until 20us --samples 5 --out {table}".split()
    assert main([*words, "--json"]) == 0
    answer, one = json.loads(capsys.readouterr().out), CubicQuintic(1e-6, -0.2, **FORCE)
    assert [answer[name] for name in ("u0", "velocity0", "p", "q", "s")] == [1e-6, -0.2, *FORCE.values()]
    assert (answer["period_s"], answer["frequency_Hz"]) == (one.period, one.frequency / math.tau)
    assert "t [s],u [m],velocity [m/s]" in table.read_text().splitlines()
    assert main(words) == 0
    said = capsys.readouterr().out
    assert f"frequency              {one.frequency / math.tau:.15g} Hz\n" in said
    assert f"range of u             {one.range[0]:.15g} to {one.range[1]:.15g} m\n" in said
    assert main(f"cubic-quintic {BEAM} --u0 0.1um,1µm --json".split()) == 0
    motions = json.loads(capsys.readouterr().out)["motions"]
    assert [each["frequency_Hz"] for each in motions] == [
        CubicQuintic(u0, **FORCE).frequency / math.tau for u0 in (1e-7, 1e-6)
    ]
    # What is not given is 0, and raised digits are read.
    assert main("cubic-quintic --mass 1e-11kg --stiffness 10N/m --cubic 1e12N/m³ --u0 1um --json".split()) == 0
    assert json.loads(capsys.readouterr().out)["period_s"] == CubicQuintic(1e-6, **FORCE | {"s": 0.0}).period


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--mass 1kg --s 1 --u0 1", "--s and a mass with stiffnesses: give one of both; beside --mass it is --quintic"),
        ("--quintic 1N/m5 --u0 1m", f"missing --mass, --stiffness; such as {BEAM.replace('^', '')} --u0 1um"),
        ("--mass 1kg --stiffness 1N/m", f"missing --u0; such as {BEAM.replace('^', '')} --u0 1um"),
        ("--mass 0kg --stiffness 1N/m --u0 1m", "--mass = 0kg: must be above 0"),
        (
            "--mass 1kg --stiffness 1N/m --quintic 1N/m3 --u0 1m",
            "--quintic = 1N/m3: unknown unit 'N/m3'; quintic stiffnesses take N/m5",
        ),
        (
            "--mass 1kg --stiffness 1N/m --force 1N --u0 1m",
            "unknown option '--force'; see libration cubic-quintic --help",
        ),
        ("--p 1 --q 1 --s 1 --u0 1m", "--u0 = 1m: must be a plain number, without a unit"),
    ],
)
def test_what_a_mass_refuses(words, message, capsys):
    assert main(["cubic-quintic", *words.split()]) == 2
    assert capsys.readouterr().err == f"libration cubic-quintic: {message}\n"
