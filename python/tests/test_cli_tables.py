"""Tables on the standard output and in files, decimal commas, few digits; `libration at`; `libration period` of several
angles; angles from the top."""

import csv
import json
import math

import numpy as np
import pytest

from libration import Pendulum, approx
from libration.cli import main

SOLVE = ["solve", "--theta0", "3", "--length", "1m", "--gravity", "9.8", "--samples", "20"]
SWINGS = ["period", "--theta0", "20deg,60deg,150deg", "--length", "1m", "--gravity", "9.7867"]


@pytest.fixture
def printed(capsys, tmp_path, monkeypatch):
    """Run in an empty directory; return what is printed, and nothing on the standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*words):
        assert main(list(words)) == 0
        shown = capsys.readouterr()
        assert shown.err == ""
        return shown.out

    return run


def rows(text, separator=","):
    """The header and the rows of a table without its `#` lines."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    header, *body = csv.reader(lines, delimiter=separator)
    return header, body


@pytest.mark.parametrize(
    "words",
    [
        SOLVE,
        ["duffing", "--p", "1", "--q", "-1", "--u0", "1.1", "--samples", "9"],
        ["compare", "--theta0", "2", "--with", "fourier:2", "--periods", "0.01"],
        ["at", "1s,2s", "--theta0", "2", "--omega0", "1"],
        SWINGS,
    ],
)
def test_what_is_printed_is_what_is_written(printed, words):
    table = printed(*words, "--out", "-")
    assert "written" in printed(*words, "--out", "a.csv")
    with open("a.csv", newline="") as file:
        assert file.read() == table
    assert printed(*words, "--out", "-", "--decimal", "point") == table


def test_a_picture_goes_with_a_printed_table(printed, tmp_path):
    assert printed(*SOLVE, "--out", "-", "--plot", "a.png") == printed(*SOLVE, "--out", "-")
    assert [each.name for each in tmp_path.iterdir()] == ["a.png"]


@pytest.mark.parametrize(
    "words", [SOLVE, ["compare", "--theta0", "2", "--with", "fourier:2", "--periods", "0.01"], SWINGS]
)
def test_decimal_commas_are_the_same_numbers(printed, words):
    header, body = rows(printed(*words, "--out", "-"))
    comma = printed(*words, "--out", "-", "--decimal", "comma")
    assert comma.startswith("# decimal comma, columns separated by semicolons\n")
    assert "." not in "".join(line for line in comma.splitlines() if "libration = " not in line).replace(
        "theta_rk4.", ""
    )
    there, commas = rows(comma, ";")
    assert there == header
    assert [[cell.replace(",", ".") for cell in row] for row in commas] == body


def test_a_table_with_decimal_commas_feeds_times(printed):
    printed(*SOLVE, "--out", "comma.csv", "--decimal", "comma")
    again = printed(*SOLVE[:-2], "--times", "comma.csv", "--out", "-")
    assert again == printed(*SOLVE, "--out", "-")


def test_digits_in_a_file_and_in_print(printed):
    _, body = rows(printed(*SOLVE, "--out", "-", "--digits", "4"))
    assert body[1][0] == "0.5263"
    text = printed(*SOLVE, "--digits", "4", "--decimal", "comma")
    assert "period                          5,161 s" in text
    assert "5.16069774997798 s" in printed(*SOLVE)


def test_one_sample_is_the_last(printed):
    _, body = rows(printed(*SOLVE[:-2], "--until", "5s", "--samples", "1", "--out", "-"))
    expected = Pendulum(3.0, length=1.0, gravity=9.8).motion(5.0)
    assert [float(cell) for cell in body[0][:3]] == [5.0, *map(float, expected)]
    assert len(body) == 1


def test_one_instant(printed):
    words = ["at", "7.3s", "--theta0", "150deg", "--length", "1m"]
    theta, velocity = Pendulum(math.radians(150), length=1.0).motion(7.3)
    lines = dict(line.split("  ", 1) for line in printed(*words).splitlines())
    assert lines["theta"].strip() == f"{theta:.10g} rad = {math.degrees(theta):.10g} deg"
    assert lines["velocity"].strip() == f"{velocity:.10g} rad/s = {math.degrees(velocity):.10g} deg/s"
    found = json.loads(printed(*words, "--json"))["instants"]
    assert found == [
        {
            "t_s": 7.3,
            "theta_rad": float(theta),
            "theta_deg": math.degrees(theta),
            "velocity_rad_per_s": float(velocity),
            "velocity_deg_per_s": math.degrees(velocity),
        }
    ]


def test_turns_of_a_rotation(printed, monkeypatch):
    words = ["at", "7.3s;-3h", "--theta0", "0", "--velocity0", "400deg/s", "--omega0", "0.5Hz"]
    first, second = json.loads(printed(*words, "--json"))["instants"]
    turns, angle = Pendulum(0.0, math.radians(400), omega0=math.pi).turns([7.3, -10800.0])
    assert (first["turns"], second["turns"]) == tuple(turns)
    assert (first["angle_rad"], second["angle_rad"]) == tuple(angle)
    assert "6 whole turns and -2.789274156 rad = -159.8136371 deg" in printed("at", "7.3s", *words[2:])
    monkeypatch.setenv("COLUMNS", "120")
    assert "turns   angle [rad]   angle [deg]" in printed(*words)


def test_an_instant_that_is_too_far(printed):
    assert "theta  not known, it is more than 2^53" in printed("at", "1e20s", "--theta0", "1", "--omega0", "1")
    assert "-: not known, it is" in printed("at", "1e20s,3s", "--theta0", "1", "--omega0", "1")


def test_periods_of_several_swings(printed):
    text = printed(*SWINGS, "--only", "exact,linear", "--decimal", "comma")
    assert text.splitlines() == [
        "period in s",
        "",
        "theta0    exact   linear",
        " 20deg  2,02386  2,00845",
        " 60deg  2,15544  2,00845",
        "150deg  3,53930  2,00845",
    ]
    header, body = rows(printed(*SWINGS, "--out", "-"))
    names = header[3:]
    assert header[:3] == ["theta0 [rad]", "theta0 [deg]", "exact [s]"]
    assert names == [f"{each} [s]" for each in (formula.name for formula in listed())]
    for degrees, row in zip((20, 60, 150), body, strict=True):
        pendulum = Pendulum(float(row[0]), length=1.0, gravity=9.7867)
        assert row[1] == f"{degrees}.0"
        assert float(row[2]) == pendulum.period
        small = Pendulum(0.0, length=1.0, gravity=9.7867).period
        for formula, cell in zip(listed(), row[3:], strict=True):
            assert float(cell) == pytest.approx(small * float(formula.ratio(pendulum.theta_max)), rel=1e-14)


def listed():
    """Every formula with its usual number."""
    return [formula for formula in approx._period.listed()]


def test_wide_tables_stand_in_blocks(printed, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    text = printed(*SWINGS)
    assert max(map(len, text.splitlines())) <= 60
    assert text.count("theta0") == text.count(" 20deg") > 2


def test_motions_that_are_no_swings_have_no_formula(printed):
    words = ["period", "--theta0", "0rad,10deg,180deg", "--omega0", "1", "--only", "linear,exact"]
    lines = printed(*words).splitlines()
    assert lines[2].split() == ["theta0", "exact", "linear"]
    assert lines[3].split() == ["0rad", "6.28319", "-"]
    assert lines[5].split() == ["180deg", "154.873", "-"]
    assert "no swing" in lines[-1]
    found = json.loads(printed(*words, "--json"))["swings"]
    assert [each["formulas"]["linear"] for each in found] == [None, math.tau, None]


def test_ratios_without_a_frequency(printed):
    header, body = rows(printed("period", "--theta0", "150deg", "--only", "exact", "--out", "-"))
    assert header == ["theta0 [rad]", "theta0 [deg]", "exact [T/T0]"]
    assert float(body[0][2]) == pytest.approx(1.762204, abs=5e-7)


def test_chosen_formulas_of_one_angle(printed):
    words = ["period", "--theta0", "150deg", "--length", "1m", "--only", "agm:3,cromer"]
    text = printed(*words)
    assert [line.split()[0] for line in text.splitlines() if line.startswith(("agm", "crom"))] == ["agm:3", "cromer"]
    assert "T [s]" in text and "T [s]" not in printed("period", "--theta0", "150deg")


def test_angles_from_the_top(printed):
    near = ["--theta0", "1e-20rad", "--from-top", "--length", "1m", "--gravity", "9.8"]
    pendulum = Pendulum(1e-20, omega2=-9.8)
    found = json.loads(printed("at", "7s", *near, "--json"))
    assert found["instants"][0]["theta_rad"] == float(pendulum.theta(7.0))
    assert (found["angles"], found["length_m"]) == ("from the top", 1.0)
    assert json.loads(printed("period", *near, "--json"))["period_s"] == pendulum.period
    assert "period T             infinite" in printed("period", *near[2:], "--theta0", "0")
    header, body = rows(printed("solve", *near, "--out", "-", "--samples", "3"))
    assert header == ["t [s]", "theta [rad]", "velocity [rad/s]"]
    assert [float(row[1]) for row in body] == pendulum.theta([0.0, 5.0, 10.0]).tolist()
    assert "harmonic" in printed("compare", *near, "--with", "harmonic")


def test_a_swing_is_the_same_from_the_top_and_from_the_bottom(printed):
    assert "turning angle  2.61799387799149 rad = 150 deg from the bottom\n" in printed(
        "period", "--theta0", "30deg", "--from-top"
    )
    top = json.loads(printed("period", "--theta0", "30deg", "--from-top", "--json"))
    bottom = json.loads(printed("period", "--theta0", "150deg", "--json"))
    assert top["period_ratio"] == pytest.approx(bottom["period_ratio"], rel=1e-14)
    assert [each["name"] for each in top["formulas"]] == [each["name"] for each in bottom["formulas"]]


@pytest.mark.parametrize("omega2", ["-4", "-4 1/s^2", "4", "0"])
def test_omega2_of_any_sign(printed, omega2):
    words = ["--theta0", "0.5", "--velocity0", "1", "--omega2", omega2]
    found = json.loads(printed("at", "2", *words, "--json"))["instants"][0]
    assert found["theta_rad"] == float(Pendulum(0.5, 1.0, omega2=float(omega2.split()[0])).theta(2.0))
    printed("period", *words)
    printed("solve", *words, "--plot", "a.png")


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ("at", "missing TIME, the instant, such as libration at 7.3s --theta0 150deg --length 1m"),
        ("at 3", "missing --theta0, the initial angle"),
        ("at 3 --theta0 1", "missing --length or --omega0, such as --length 1m"),
        ("at 3x --theta0 1 --omega0 1", "TIME = 3x: unknown unit 'x'; times take s, ms, min, h"),
        ("at 3s,,4s --theta0 1 --omega0 1", "TIME = 3s,,4s: has an empty place"),
        ("at 3s 4s --theta0 1 --omega0 1", "unknown word '4s'; a value follows its option, and several are joined"),
        ("at --theta 1", "unknown option '--theta'; did you mean --theta0?"),
        ("at 3 --theta0 1 --omega0 1 --out - --json", "--out = - and --json: both print on the standard output"),
        ("at 3 --theta0 1 --omega0 1 --out a.txt", "must end in .csv, .npz or .json; - is the standard output"),
        ("at 3 --theta0 1 --omega0 1 --digits 0", "--digits = 0: must be a whole number from 1 to 17"),
        ("at 3 --theta0 1 --omega0 1 --digits 2.5", "--digits = 2.5: must be a whole number from 1 to 17"),
        ("at 3 --theta0 1 --omega0 1 --decimal ,", "--decimal = ,: must be point or comma"),
        ("at 3 --theta0 1 --omega0 1 --decimal comma --out a.npz", "--decimal = comma: is for what is printed and for"),
        ("at 3 --theta0 1 --omega0 1 --digits 3 --out a.json", "--digits = 3: is for what is printed and for .csv"),
        ("at 3 --theta0 1 --omega0 1 --omega2 1", "--omega0 = 1 and --omega2 = 1: give one of the two"),
        ("at 3 --theta0 1 --omega2 -1 --from-top", "--omega2 = -1: below 0 counts the angle from the top already"),
        ("at 3 --theta0 1 --omega2 1m", "--omega2 = 1m: unknown unit 'm'; squares of angular frequencies take 1/s2"),
        ("at 3 --theta0 1 --omega2 nan", "--omega2 = nan: must be a finite number"),
        ("solve --theta0 1 --omega0 1 --out - --json", "--out = - and --json: both print on the standard output"),
        ("solve --theta0 1 --omega0 1 --out", "--out: needs a value, --out FILE; see libration solve --help"),
        ("period --theta0 20deg,,3", "has an empty place"),
        ("period --theta0 1 --only exat", "--only = exat: must be one of exact, "),
        ("period --theta0 1 --only linear,linear", "--only = linear,linear: names linear twice"),
        ("period --theta0 1 --only agm:x", "--only = agm:x: must be "),
        ("period --theta0 1 --plot a.png --chart b.png", "--plot = a.png and --chart = b.png: are one option"),
        ("period --theta0 1 --chart a.pdf", "--chart = a.pdf: must end in .png or .svg"),
        ("at 1 --theta0 1 --from-top --omega0 1e200", "--omega0 = 1e+200: with --from-top gives a square of omega0"),
        ("at 1 --theta0 1 --from-top --omega0 1e-200", "--omega0 = 1e-200: with --from-top gives a square of omega0"),
        ("period --theta0 1 --from-top --length 1e-320m", "with --from-top gives a square of omega0 that is beyond"),
        ("compare --theta0 1 --from-top --with linear", "which is about theta = 0; leave out --from-top"),
    ],
)
def test_refusals(capsys, tmp_path, monkeypatch, words, line):
    monkeypatch.chdir(tmp_path)
    assert main(words.split()) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.startswith(f"libration {words.split()[0]}: ") and shown.err.count("\n") == 1
    assert line in shown.err
    assert list(tmp_path.iterdir()) == []


def test_a_table_that_fails_prints_nothing(capsys, monkeypatch):
    def fail(*_):
        raise MemoryError

    monkeypatch.setattr(Pendulum, "motion", fail)
    assert main([*SOLVE, "--out", "-"]) == 2
    assert capsys.readouterr().out == ""


def test_npz_has_the_si_columns(printed):
    printed("at", "1s,2s", "--theta0", "1", "--omega0", "1", "--out", "a.npz")
    with np.load("a.npz") as archive:
        assert archive["theta"].tolist() == Pendulum(1.0).theta([1.0, 2.0]).tolist()


def test_what_is_beyond_the_doubles_is_told_in_words(capsys):
    assert main("at 1 --theta0 170deg --velocity0 -1e308 --omega0 1".split()) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    assert "theta     -1e+308 rad = -inf deg\n" in shown.out
    assert "turns     not known, the angle is too large\n" in shown.out
    assert main("at 1s,2s --theta0 170deg --velocity0 -1e308 --omega0 1".split()) == 0
    shown = capsys.readouterr()
    assert "nan" not in shown.out
    assert shown.out.endswith("\n-: not known, the angle is too large\n")
