"""Several records together: runs of one pendulum, lengths, a reversible pendulum; in Python and from the command."""

import json
import math
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest

import libration
from libration import DampedPendulum, Friction, Together, fit, fit_together
from libration.cli import main

T = np.linspace(0.0, 16.0, 400)
OPTIONS = {"model": "linear"}


def record(length=0.8, seed=1, theta0=1.0):
    motion = DampedPendulum(theta0, length=length, gravity=9.81, friction=Friction(linear=0.02))
    return T, motion.theta(T) + np.random.default_rng(seed).normal(0.0, 0.005, T.size)


def write(path, given):
    rows = "".join(f"{t:.4f},{theta:.6f}\n" for t, theta in zip(*given, strict=True))
    path.write_text("t [s],theta [rad]\n" + rows)
    return str(path)


def test_runs_of_one_pendulum():
    runs = [record(seed=seed) for seed in range(4)]
    found = fit_together(runs, length=(0.8, 0.001), **OPTIONS)
    assert isinstance(found, Together) and found.kind == "runs" and len(found.fits) == 4
    alone = fit(*runs[0], length=(0.8, 0.001), **OPTIONS)
    assert found.omega0.statistical < 0.7 * alone.omega0.statistical
    # The length is the same error in all of them.
    assert found.g.calibration == pytest.approx(9.81 / 800, rel=0.01)
    assert abs(found.g.value - 9.81) < 3 * found.g.u
    # The mean of the records by their weights.
    weights = np.array([1 / (each.omega0.statistical**2 + each.omega0.model**2) for each in found.fits])
    mean = np.average([each.omega0.value for each in found.fits], weights=weights)
    assert found.omega0.value == pytest.approx(mean, rel=1e-12)
    assert found.chi_squared[1] == 3
    assert "together" in str(found) and "from 4 records of one pendulum" in found.sentence()


def test_runs_that_do_not_agree_are_flagged():
    found = fit_together([record(), record(length=0.81)], **OPTIONS)
    assert any("do not agree on omega0" in each for each in found.verdicts)
    assert found.omega0.u > 3 * found.fits[0].omega0.u


def test_lengths_give_g_and_their_common_error():
    lengths = [0.4, 0.6, 0.8, 1.0]
    # Each is measured 15 mm short.
    records = [record(length=length + 0.015, seed=number) for number, length in enumerate(lengths)]
    found = fit_together(records, lengths=[(length, 2e-4) for length in lengths], **OPTIONS)
    assert found.kind == "lengths" and found.omega0 is None and found.length is None
    assert abs(found.g.value - 9.81) < 4 * found.g.u < 0.1
    assert abs(found.length_offset.value - 0.015) < 4 * found.length_offset.u
    assert any("short by 0.01" in each for each in found.verdicts)
    parts = {row["source"]: row["u"] for row in found.to_dict()["budget"]}
    assert parts["lengths"] == found.g.calibration > parts["fit"] == found.g.statistical > 0
    # The variance of the straight line through values with equal errors.
    x = np.array([1 / each.omega0.value**2 for each in found.fits])
    spread = np.sum((x - x.mean()) ** 2)
    assert found.g.calibration == pytest.approx(2e-4 / math.sqrt(spread), rel=0.05)


def test_a_reversible_pendulum():
    # Two distances whose product is the square of the radius of gyration have one period.
    found = fit_together([record(1.0, 1), record(1.0, 2)], pivots=[(0.66, 1e-3), (0.34, 1e-3)], **OPTIONS)
    assert found.kind == "reversible"
    assert abs(found.g.value - 9.81) < 4 * found.g.u
    assert found.g.calibration == pytest.approx(9.81 * math.hypot(1e-3, 1e-3), rel=0.1)
    better = fit_together([record(1.0, 1), record(1.0, 2)], pivots=[(0.66, 1e-3)], between=(1.0, 1e-5), **OPTIONS)
    assert better.g.u < 0.6 * found.g.u
    assert "reversible" in better.sentence()


def test_gravity_of_pivots_reduces_swings():
    def period(distance, swing):
        # A uniform rod of 1 m: k^2 = 1/12.
        return libration.Pendulum(swing, length=(1 / 12 + distance**2) / distance, gravity=9.8).period

    found = libration.gravity_of_pivots([period(0.4, 0.3), period(0.3, 0.5)], [0.4, 0.3], swings=[0.3, 0.5])
    assert found.value == pytest.approx(9.8, rel=1e-12)
    between = libration.gravity_of_pivots([period(0.4, 0.3), period(0.3, 0.5)], [0.4], between=0.7, swings=(0.3, 0.5))
    assert between.value == pytest.approx(9.8, rel=1e-12)
    with pytest.warns(UserWarning, match="outside of"):
        libration.gravity_of_pivots([1.5995, 1.5995], [0.4], between=0.6503)
    with pytest.raises(ValueError, match="must be two"):
        libration.gravity_of_pivots([1.0], [0.4, 0.3])
    with pytest.raises(ValueError, match="lies between them"):
        libration.gravity_of_pivots([1.0, 1.0], [0.9], between=0.7)


def test_a_record_that_does_not_stand_speaks_against_all():
    cosine = T, 0.6 * np.exp(-0.01 * T) * np.cos(3.5 * T)
    found = fit_together([record(), cosine], length=0.8)
    assert not found.stands
    assert found.sentence().startswith("nothing: record 2: ") and "DO NOT QUOTE" in str(found)
    assert found.to_dict()["grades"][0] == "refuted"


def test_monte_carlo_of_runs():
    found = fit_together([record(), record(seed=2)], length=(0.8, 0.001), monte_carlo=2000, **OPTIONS)
    low, high = found.to_dict()["monte_carlo"]
    assert (high - low) / (2 * 1.96 * found.g.u) == pytest.approx(1.0, abs=0.12)


REFUSED = [
    (dict(), 1, "1 record: together are at least two"),
    (dict(lengths=[0.8]), 2, "are 1 for 2 records"),
    (dict(lengths=[0.8, 0.9], gravity=9.8), 2, "lengths and gravity"),
    (dict(lengths=[0.8, 0.9], pivots=[0.4, 0.3]), 2, "lengths and pivots"),
    (dict(lengths=[0.8, 0.8]), 2, ""),
    (dict(pivots=[0.4]), 2, "has two of each"),
    (dict(between=0.4), 2, "between: needs pivots"),
    (dict(lengths=[0.8, 0.9], monte_carlo=100), 2, "monte_carlo: is for records of one pendulum"),
    (dict(length=-1.0), 2, "length = -1"),
    (dict(model="cubic"), 2, "model = 'cubic'"),
    (dict(window=(100.0, 200.0)), 2, "record 1: 0 samples in the window"),
]


@pytest.mark.parametrize(("options", "count", "message"), REFUSED)
def test_bad_options(options, count, message):
    if not message:
        # Equal lengths still give g, from their mean.
        assert fit_together([record(seed=seed) for seed in range(count)], **OPTIONS, **options).g.value > 9
        return
    with pytest.raises(ValueError, match=message) as refusal:
        fit_together([record(seed=seed) for seed in range(count)], **options)
    assert "\n" not in str(refusal.value)


def test_a_record_given_twice_is_refused():
    with pytest.raises(ValueError, match=r"^record 2: holds the record of record 1 again; give each record once$"):
        fit_together([record(), record()], **OPTIONS)


@pytest.fixture(scope="module")
def kinds():
    records = [record(0.5), record(0.8), record(1.1)]
    return {
        "runs": fit_together([record(), record(seed=2)], length=(0.8, 0.001), **OPTIONS),
        "lengths": fit_together(records, lengths=[(0.5, 1e-3), (0.8, 1e-3), (1.1, 1e-3)], **OPTIONS),
        "reversible": fit_together([record(1.0), record(1.0, 2)], pivots=[0.66], between=1.0, **OPTIONS),
    }


@pytest.mark.parametrize("kind", ["runs", "lengths", "reversible"])
@pytest.mark.parametrize("lang", ["en", "pt-BR", "es"])
def test_pictures_and_pages(kind, lang, kinds):
    found = kinds[kind]
    picture = BytesIO()
    found.plot(picture, form="svg", lang=lang)
    assert {"en": "measured", "pt-BR": "medido", "es": "medido"}[lang] in picture.getvalue().decode()
    page = found.report(lang)
    assert f'<html lang="{lang}">' in page and page.count("<h1>") == 1 + len(found.fits)
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    assert found.plot(ax=axes, lang=lang) is axes


def test_the_line_of_the_lengths_is_drawn(kinds):
    found = kinds["lengths"]
    axes = found.plot()
    line = next(each for each in axes.get_lines() if each.get_label() == "fitted")
    x, y = line.get_data()
    assert (y[1] - y[0]) / (x[1] - x[0]) == pytest.approx(1 / found.g.value, rel=1e-9)


@pytest.fixture
def files(tmp_path):
    return [write(tmp_path / f"{name}.csv", record(length)) for name, length in (("a", 0.5), ("b", 0.8), ("c", 1.1))]


def test_a_record_that_is_given_twice_is_refused(files, tmp_path, capsys):
    copy = tmp_path / "copy.csv"
    copy.write_bytes(Path(files[1]).read_bytes().replace(b"\n", b"\r\n"))
    for other in (files[1], str(copy)):
        assert main(["fit", files[1], other, "--report", str(tmp_path / "a.html")]) == 2
        told = capsys.readouterr()
        assert f"{other}: holds the record of {files[1]} again" in told.err and told.err.count("\n") == 1
    assert not (tmp_path / "a.html").exists()


def test_the_command_of_runs(files, tmp_path, capsys):
    again = write(tmp_path / "again.csv", record(seed=7))
    assert main(["fit", files[1], again, "--length", "0.800±0.001", "--model", "linear", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["kind"] == "runs" and told["g"]["value"] == pytest.approx(9.81, abs=0.02)
    assert [each["source"] for each in told["records"]] == [files[1], again]
    assert main(["fit", files[1], again, "--model", "linear"]) == 0
    printed = capsys.readouterr().out
    assert printed.count("to quote") == 1 and "record 2" in printed and "together" in printed


def test_the_command_of_lengths(files, tmp_path, capsys):
    words = [
        word for file, length in zip(files, ("0.5", "80cm", "1.1m"), strict=True) for word in (file, "--length", length)
    ]
    report, picture = tmp_path / "g.html", tmp_path / "g.png"
    assert (
        main(["fit", *words, "--model", "linear", "--report", str(report), "--plot", str(picture), "--lang", "es"]) == 0
    )
    assert "una misma g con varias longitudes" in capsys.readouterr().out
    assert "Para citar" in report.read_text() and picture.read_bytes()[1:4] == b"PNG"


def test_the_command_of_pivots(tmp_path, capsys):
    up, down = write(tmp_path / "up.csv", record(1.0, 1)), write(tmp_path / "down.csv", record(1.0, 2))
    words = ["--pivot", "0.660±0.001", "--between", "1.00000±0.00001", "--model", "linear", "--json"]
    assert main(["fit", up, down, *words]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["kind"] == "reversible" and abs(told["g"]["value"] - 9.81) < 4 * told["g"]["u"]


def test_all_runs_of_a_file(tmp_path, capsys):
    (t, first), (_, second) = record(), record(seed=2)
    rows = "".join(f"{a:.4f},{b:.6f},{a:.4f},{c:.6f}\n" for a, b, c in zip(t, first, second, strict=True))
    path = tmp_path / "runs.csv"
    path.write_text("Time (s) Run #1,Angle (rad) Run #1,Time (s) Run #2,Angle (rad) Run #2\n" + rows)
    assert main(["fit", str(path), "--run", "all", "--model", "linear", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [each["source"] for each in told["records"]] == [f"{path}, run 1", f"{path}, run 2"]
    assert len(fit_together(path, run="all", **OPTIONS).fits) == 2
    with pytest.raises(ValueError, match="run='all' takes every run"):
        fit_together(path, **OPTIONS)


WORDS = [
    ("A B --length 0.5 --length 0.8 --length 1.1", "--length: is given 3 times for 2 records"),
    ("A --length 0.5 --length 0.8", "--length: is given twice for 1 record;"),
    ("A B --length 0.5 --length 0.8 --gravity 9.8", "give one of the two"),
    ("A B --pivot 0.5", "--pivot: is given once; give it twice"),
    ("A --pivot 0.5 --pivot 0.4", "has two records"),
    ("A B --pivot 0.5 --pivot 0.4 --length 1", "--pivot and --length"),
    ("A B --between 0.5", "needs --pivot beside it"),
    ("A B --length 0.5 --length 0.8 --monte-carlo 1000", "--monte-carlo: is for records of one pendulum"),
    ("A --bob 12mm --wire 1g --length 1", "needs the mass of the bob"),
    ("A --bob 12mm,66g --part point:1m,1kg", "--bob and --part"),
    ("A --fluid water --length 1", "--fluid: needs --bob"),
    ("A --bob 12mm,66g --fluid oil", "must be air, water, or DENSITY"),
    ("A --bob 12mm,66g --without bouyancy", "did you mean buoyancy?"),
    ("A --bob 12mm,1mg --length 1", "a bob that floats"),
    ("A --monte-carlo 10", "--monte-carlo = 10"),
    ("A --report r.html --dpi 50", "needs --plot FILE"),
    ("A --report r.html --lang fr", "--lang = fr"),
    ("A B --window 100:200", "a.csv: 0 samples"),
]


@pytest.mark.parametrize(("words", "message"), WORDS)
def test_refusals(words, message, files, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    before = sorted(tmp_path.iterdir())
    given = {"A": files[0], "B": files[1]}
    assert main(["fit", *(given.get(word, word) for word in words.split())]) == 2
    told = capsys.readouterr()
    assert message in told.err and told.err.count("\n") == 1 and not told.out
    assert sorted(tmp_path.iterdir()) == before


def test_the_command_of_corrections(files, capsys):
    words = (
        "--length 0.8 --bob 12.5mm,66g --wire 0.4g --fluid 998kg/m^3,1mm^2/s --without added-mass --model linear --json"
    )
    assert main(["fit", files[1], *words.split()]) == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)["corrections"]}
    assert rows["buoyancy"]["made"] and not rows["added mass"]["made"]
    assert rows["buoyancy"]["relative_period"] > 0.05
