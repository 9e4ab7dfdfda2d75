"""`libration fit`: what is printed, JSON, several files, exit codes, refusals in one line."""

import json
import math

import numpy as np
import pytest

from libration import DampedPendulum, Friction
from libration.cli import main

T = np.linspace(0.0, 24.0, 600)


def swing(seed=3):
    motion = DampedPendulum(math.radians(70), length=0.8, gravity=9.81, friction=Friction(linear=0.02))
    return np.degrees(motion.theta(T) + np.random.default_rng(seed).normal(0.0, 0.01, T.size))


def write(path, theta, head="t [s];theta [deg]"):
    rows = (f"{t:.6f};{each:.6f}".replace(".", ",") for t, each in zip(T, theta, strict=True))
    path.write_text("\n".join([head, *rows]) + "\n")
    return str(path)


@pytest.fixture
def file(tmp_path):
    return write(tmp_path / "swing.csv", swing())


def test_what_is_printed(file, capsys):
    assert main(["fit", file, "--length", "0.800±0.001"]) == 0
    printed = capsys.readouterr().out
    for text in ("theta [deg]", "600 samples", "nothing", "linear friction", "<- chosen", "rad/s", "g = 9.8", "u of g"):
        assert text in printed


def test_counts_at_a_rate(tmp_path, capsys):
    counts = tmp_path / "counts.txt"
    counts.write_text("\n".join(str(round(each * 4096 / 360)) for each in swing()) + "\n")
    said = []
    for rate in ("25/s", "25Hz", "25 1/s", "25fps"):
        assert main(["fit", str(counts), "--unit", "angle=4096/rev", "--rate", rate, "--json"]) == 0
        said.append(json.loads(capsys.readouterr().out))
    assert said[0]["omega0"]["value"] == pytest.approx(math.sqrt(9.81 / 0.8) * (T.size / 24 / 25), rel=3e-3)
    assert all(each == said[0] for each in said)


def test_json(file, capsys):
    assert main(["fit", file, "--length", "80.0(1)cm", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["g"]["value"] == pytest.approx(9.81, abs=0.008)
    assert told["g"]["u"] == pytest.approx(0.0124, abs=0.0006)
    assert told["length"]["value"] == 0.8
    assert told["model"] == "linear" and told["window"] == [0.0, 24.0] and told["dropped"] == []
    assert told["friction"]["linear"]["value"] == pytest.approx(0.02, abs=5e-4)
    assert told["files"] == [] and told["source"] == file


ESTIMATE = {name: float for name in ("value", "u", "expanded", "statistical", "model", "calibration")}
NUMBER = (float, int)
# The names that are promised, with their types; a list stands for each of its elements, () for anything.
SCHEMA = {
    "source": str,
    "kind": str,
    "model": str,
    "rms": float,
    "rms_deg": float,
    "omega0": ESTIMATE,
    "g": ESTIMATE,
    "length": ESTIMATE,
    "offset": ESTIMATE,
    "offset_deg": ESTIMATE,
    "scale": (),
    "friction": {"linear": ESTIMATE, "quadratic": (), "dry": (), "presliding": ()},
    "swing": float,
    "verdicts": [str],
    "grades": [str],
    "stands": bool,
    "understood": [str],
    "dropped": [{"reason": str, "count": int, "rows": [int]}],
    "window": [float],
    "window_reason": str,
    "samples": int,
    "ladder": [{"model": str, "rms": float, "aicc": (), "bic": (), "omega0": float, "wanted_negative": [str]}],
    "correlation": {"names": [str], "rows": [[float]]},
    "budget": [{"source": str, "u": float}],
    "corrections": [{"name": str, "relative_period": float, "made": bool}],
    "monte_carlo": [float],
    "diagnostics": (),
    "state": [float],
    "files": [str],
}


def departures(found, schema, place=""):
    """Where JSON departs from a schema."""
    if schema == ():
        return []
    if isinstance(schema, dict):
        if not isinstance(found, dict):
            return [f"{place}: no object"]
        missing = [f"{place}.{name}: missing" for name in schema if name not in found]
        return missing + [
            each
            for name, part in schema.items()
            if name in found
            for each in departures(found[name], part, f"{place}.{name}")
        ]
    if isinstance(schema, list):
        if not isinstance(found, list):
            return [f"{place}: no list"]
        return [each for number, one in enumerate(found) for each in departures(one, schema[0], f"{place}[{number}]")]
    wanted = NUMBER if schema is float else schema
    right = isinstance(found, wanted) and isinstance(found, bool) == (schema is bool)
    return [] if right else [f"{place}: {found!r} is no {schema.__name__}"]


def test_json_keeps_its_schema(tmp_path, capsys):
    theta = swing()
    theta[[7, 300]] += 90.0
    file = write(tmp_path / "swing.csv", theta)
    words = "--length 0.800±0.001 --model quadratic --bob 12mm,66g --monte-carlo 200 --json"
    assert main(["fit", file, *words.split()]) == 0
    told = json.loads(capsys.readouterr().out)
    assert departures(told, SCHEMA) == []
    assert told["dropped"] and told["corrections"] and told["ladder"]
    for each in (told["omega0"], told["g"], told["offset_deg"], told["friction"]["linear"]):
        parts = math.hypot(each["statistical"], each["model"], each["calibration"])
        assert each["u"] == pytest.approx(parts, rel=1e-12) and each["expanded"] == 2 * each["u"]
    # What spoils it is found.
    assert departures(told | {"rms_deg": "1"}, SCHEMA) and departures({"g": None}, {"g": ESTIMATE})


def test_options_reach_the_fit(file, capsys):
    words = (
        "--gravity 9.81±0.01 --model quadratic --window 2s:20s --scale 0.5% --clock 1e-4 --free-scale --bootstrap 50"
    )
    assert main(["fit", file, *words.split(), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["model"] == "quadratic" and told["scale"]["value"] == pytest.approx(1.0, abs=0.02)
    assert 2.0 <= told["window"][0] < told["window"][1] <= 20.0
    assert told["length"]["u"] > 0.8 * 0.001
    assert told["diagnostics"]["omega0_u_bootstrap"] > 0


def test_columns_and_units(tmp_path, capsys):
    file = write(tmp_path / "counts.txt", swing() * 4096 / 360, head="a;b")
    assert main(["fit", file, "--column", "time=a", "--column", "angle=b", "--unit", "angle=4096/rev", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["omega0"]["value"] == pytest.approx(3.5018, abs=0.002)


def test_a_verdict_is_exit_code_1(tmp_path, capsys):
    file = write(tmp_path / "cosine.csv", 50 * np.exp(-0.01 * T) * np.cos(3.5 * T))
    assert main(["fit", file, "--length", "0.8"]) == 1
    told = capsys.readouterr()
    assert "DO NOT QUOTE" in told.out and "nothing: " in told.out
    assert "linear cosine" in told.err and told.err.count("\n") == 1


REFUSED = [
    ("", "missing FILE"),
    ("FILE --length 0.8 --gravity 9.8", "give one of the two"),
    ("FILE --length -0.8m", "--length = -0.8m: must be greater than 0"),
    ("FILE --length 0.8kg", "unknown unit 'kg'"),
    ("FILE --length 0.8±", "a value with its standard uncertainty"),
    ("FILE --model cubic", "must be one of auto, none"),
    ("FILE --model liner", "did you mean linear?"),
    ("FILE --column theta", "must be ROLE=NAME"),
    ("FILE --column angle=a --column angle=b", "angle is given twice"),
    ("FILE --column angle=z", "swing.csv: "),
    ("FILE --run 0", "--run = 0"),
    ("FILE --run 1.5", "must be a whole number"),
    ("FILE --window 3", "two times with a colon"),
    ("FILE --window 9:3", "later than the first"),
    ("FILE --window 100:200", "swing.csv: 0 samples in the window"),
    ("FILE --scale 200%", "relative uncertainty"),
    ("FILE --rate 0", "--rate = 0"),
    ("FILE --lenght 1", "did you mean --length?"),
    ("FILE --report a.txt", "must end in .html or .htm"),
    ("FILE --plot a.jpg", "must end in .png or .svg"),
    ("FILE --title a --report a.html", "needs --plot FILE"),
    ("absent.csv", "absent.csv: cannot be read: No such file"),
    (".", "cannot be read: Is a directory"),
    ("-", "unknown option '-'; see libration fit --help"),
]


@pytest.mark.parametrize(("words", "message"), REFUSED)
def test_refusals(words, message, file, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    before = sorted(tmp_path.iterdir())
    assert main(["fit", *(file if word == "FILE" else word for word in words.split())]) == 2
    told = capsys.readouterr()
    assert message in told.err and told.err.count("\n") == 1 and not told.out
    assert sorted(tmp_path.iterdir()) == before


CONTENTS = [
    ("", "is empty"),
    ("t,theta\n0,1\n1,2\n", ""),
    ("t,theta\n" + "".join(f"{k},0.5\n" for k in range(50)), "no column moves"),
    ("some words\nand more\n", "no row of numbers"),
    ("t,theta\n" + "".join(f"{k},nan\n" for k in range(50)), "no number"),
    ('{"t": [0, 1, 2], "theta": [1, 2, 3]}', "bad.csv: is JSON; write a table of text"),
    ("\n<!DOCTYPE html>\n<table><tr><td>0</td><td>1</td></tr></table>", "bad.csv: is a page of HTML; save"),
    ("%PDF-1.7\n1 0 obj\n", "bad.csv: is a PDF; give"),
]


@pytest.mark.parametrize(("content", "message"), CONTENTS)
def test_no_record(content, message, tmp_path, capsys):
    path = tmp_path / "bad.csv"
    path.write_text(content)
    assert main(["fit", str(path), "--unit", "angle=rad"]) == 2
    told = capsys.readouterr()
    assert "bad.csv" in told.err and message in told.err and told.err.count("\n") == 1 and not told.out


def test_a_file_whose_name_begins_as_an_option_does(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    write(tmp_path / "-a.csv", swing())
    assert main(["fit", "-a.csv"]) == 2
    assert "unknown option '-a.csv'; a file of this name is written './-a.csv'" in capsys.readouterr().err
    assert main(["fit", "./-a.csv", "--model", "linear"]) == 0


def test_a_device_without_an_end(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("libration.measurement._columns.MOST_BYTES", 1000)
    path = write(tmp_path / "long.csv", swing())
    assert main(["fit", path]) == 2
    assert "long.csv: cannot be read: it holds more than 1000 bytes" in capsys.readouterr().err


def test_a_bob_without_a_mass(file, capsys):
    assert main(["fit", file, "--length", "0.8", "--bob", "12.5mm", "--model", "linear"]) == 0
    assert "bob size" in capsys.readouterr().out


def test_times_far_from_0_are_told_apart(tmp_path, capsys):
    path = tmp_path / "stamps.csv"
    rows = "".join(f"{1717171717 + t:.3f},{each:.4f}\n" for t, each in zip(T, swing(), strict=True))
    path.write_text("t [s],theta [deg]\n" + rows)
    assert main(["fit", str(path), "--model", "linear"]) == 0
    assert "1717171717.00 s to 1717171741.00 s, from the release" in capsys.readouterr().out


def test_the_budget_is_a_table(file, capsys):
    assert main(["fit", file, "--length", "0.800±0.001", "--model", "linear"]) == 0
    lines = capsys.readouterr().out.split("\n")
    places = {line.index(each) for line in lines for each in ("  fit", "  length") if line.endswith(each)}
    assert len(places) == 1


def test_a_refused_file_leaves_nothing(file, tmp_path, capsys):
    bad = tmp_path / "bad.csv"
    bad.write_text("")
    assert main(["fit", file, str(bad)]) == 2
    assert not capsys.readouterr().out
    report = tmp_path / "a.html"
    assert main(["fit", str(bad), "--report", str(report)]) == 2
    assert not report.exists()


def test_parts_give_the_length(file, capsys):
    assert main(["fit", file, "--part", "rod:1.200±0.001m,300g", "--json", "--model", "linear"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["length"]["value"] == pytest.approx(0.8)
    # A heavy ball at the end of a thread is nearly a point.
    words = ["--part", "rod:0.8m,0.1g", "--part", "ball:80cm,1kg,1mm"]
    assert main(["fit", file, *words, "--json", "--model", "linear"]) == 0
    assert json.loads(capsys.readouterr().out)["g"]["value"] == pytest.approx(9.81, abs=0.01)


PARTS = [
    ("--part cube:1m,1kg", "must be rod:LENGTH,MASS"),
    ("--part rod:1m", "must be rod:LENGTH,MASS"),
    ("--part point:1m,1s", "unknown unit 's'"),
    ("--part point:-1m,1kg", "must be 0 or greater"),
    ("--part point:0m,1kg", "--part: moment = 0"),
    ("--part point:1m,1kg --length 1m", "--part and --length"),
]


@pytest.mark.parametrize(("words", "message"), PARTS)
def test_bad_parts(words, message, file, capsys):
    assert main(["fit", file, *words.split()]) == 2
    told = capsys.readouterr()
    assert message in told.err and told.err.count("\n") == 1 and not told.out
