"""Numerical solutions by name, and the command that compares them and the approximations with the exact motion."""

import csv
import json
import math
import pickle

import numpy as np
import pytest

from libration import Pendulum, approx
from libration.cli import main
from libration.cli.compare import APPROXIMATIONS, NUMERICAL

HORSLEY = Pendulum(3.0, length=1.0, gravity=9.8)
HORSLEY_WORDS = "compare --theta0 3 --length 1m --gravity 9.8".split()


def test_steps_have_their_order():
    pendulum = Pendulum(2.0)
    for scheme, order in [("euler", 1), ("euler-cromer", 1), ("verlet", 2), ("rk4", 4)]:
        coarse, fine = (approx.numerical(f"{scheme}:{step}").of(pendulum).error(0.5) for step in (0.02, 0.01))
        assert math.log2(coarse.difference / fine.difference) == pytest.approx(order, abs=0.1)


def test_energy_of_euler_grows_and_of_euler_cromer_does_not():
    pendulum = Pendulum(1.0)
    assert np.abs(approx.numerical("euler:0.05").of(pendulum).theta(np.linspace(0, 60, 600))).max() > 2.0
    assert np.abs(approx.numerical("euler-cromer:0.05").of(pendulum).theta(np.linspace(0, 60, 600))).max() < 1.03


def test_between_steps_the_angle_is_as_good_as_at_them():
    pendulum = Pendulum(2.5, 0.3)
    rk4 = approx.numerical("rk4:0.05").of(pendulum)
    t = np.linspace(0, 7, 1234)
    # The cubic through two states errs by h^4/384 of the fourth derivative.
    assert np.abs(rk4.theta(t) - pendulum.theta(t)).max() < 2e-6
    assert np.array_equal(rk4.theta(t[::-1]), rk4.theta(t)[::-1])
    assert rk4.theta(0.0) == 2.5 and rk4.theta(np.empty(0)).shape == (0,)


def test_scipy_defaults_send_horsleys_pendulum_over_the_top():
    lost = approx.numerical("solve_ivp").of(HORSLEY)
    assert lost.over_the_top(10 / HORSLEY.period) == pytest.approx(9.47, abs=0.005)
    assert math.isnan(lost.over_the_top(1))
    for name in ("rk4:0.025", "odeint"):
        kept = approx.numerical(name).of(HORSLEY)
        assert math.isnan(kept.over_the_top(10 / HORSLEY.period))
    assert approx.numerical("odeint").of(HORSLEY).error(10 / HORSLEY.period).difference == pytest.approx(
        3.7e-5, rel=0.05
    )


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("eular:0.1", "numerical solution = 'eular:0.1': must be one of euler:H, "),
        ("euler", "numerical solution = 'euler': must be euler:H with a step H > 0 in s, as euler:0.01"),
        ("rk4:-1", "numerical solution = 'rk4:-1': must be rk4:H with a step H > 0 in s, as rk4:0.01"),
        ("rk4:nan", "numerical solution = 'rk4:nan': must be rk4:H with a step H > 0 in s, as rk4:0.01"),
        ("odeint:3", "numerical solution = 'odeint:3': must be odeint without a step"),
        ("euler:\n0.1", "numerical solution = 'euler:\\n0.1': must be euler:H"),
        ("euler:1_0", "numerical solution = 'euler:1_0': must be euler:H"),
        ("euler: 0.1", "numerical solution = 'euler: 0.1': must be euler:H"),
        ("euler:\uff11", "numerical solution = 'euler:\uff11': must be euler:H"),
        ("", "numerical solution = '': must be one of "),
        (None, "name = None: must be one of euler:H, "),
        (b"rk4:1", "name = b'rk4:1': must be one of euler:H, "),
    ],
)
def test_names_that_are_refused(name, message):
    with pytest.raises(ValueError) as caught:
        approx.numerical(name)
    assert str(caught.value).startswith(message) and "\n" not in str(caught.value)


def test_a_solution_is_a_value():
    rk4 = approx.numerical("rk4:0.10")
    assert (
        rk4.name == "rk4:0.1" and rk4 == approx.numerical("rk4:1e-1") and hash(rk4) == hash(approx.numerical("rk4:.1"))
    )
    made = rk4.of(Pendulum(1.0))
    assert pickle.loads(pickle.dumps(made)) == made
    with pytest.raises(AttributeError):
        rk4.name = "euler:1"
    for bad in (None, "x", 1.0):
        with pytest.raises(ValueError, match=r"pendulum = .*: must be a Pendulum"):
            rk4.of(bad)
    assert rk4.of(Pendulum(0.0)).error() == (0.0, 0.0, 0.0, pytest.approx(math.nan, nan_ok=True))
    hanging = approx.numerical("rk4:0.01").of(Pendulum(3.0, omega2=-1.0))
    assert math.isnan(hanging.over_the_top(1)) and hanging.error().difference < 1e-8


def test_errors_are_looked_for_within_the_span(recwarn):
    pendulum = Pendulum(1.0)
    for name in ("rk4:1e6", "euler:1e300", "rk4:0.01"):
        for periods in (1e-300, 0.3, 1):
            assert approx.numerical(name).of(pendulum).error(periods).t <= periods * pendulum.period
    assert not recwarn.list


def test_spans_and_times_that_are_refused():
    for bad in (None, "1", True):
        with pytest.raises(ValueError, match=r"periods = .*: must be one real number"):
            approx.numerical("rk4:0.01").of(Pendulum(1.0)).error(bad)
    for bad in ("1", None, 1j, ["a"]):
        with pytest.raises(TypeError, match="must be real numbers"):
            approx.numerical("rk4:0.01").of(Pendulum(1.0)).theta(bad)
        with pytest.raises(TypeError, match="must be real numbers"):
            approx.angle("harmonic").of(Pendulum(1.0)).theta(bad)
    rk4 = approx.numerical("rk4:0.01").of(Pendulum(1.0))
    for periods in (0, -1, math.nan, 1e5):
        with pytest.raises(ValueError, match=r"periods = .*: must be above 0 and at most 10000"):
            rk4.error(periods)
    with pytest.raises(ValueError, match="must be at most 5,000,000 steps"):
        approx.numerical("rk4:1e-12").of(Pendulum(1.0)).error(1)
    with pytest.raises(ValueError, match="must be finite and not negative"):
        rk4.theta([1.0, -1.0])
    with pytest.raises(ValueError, match="must be finite for an error over periods"):
        approx.numerical("rk4:0.01").of(Pendulum(0.0, 2.0)).error(1)


def test_the_help_names_what_there_is():
    for topic, registry in ((APPROXIMATIONS, approx.angle), (NUMERICAL, approx.numerical)):
        assert [name for terms, _ in topic.rows for name in terms.split(", ")] == list(registry.names)


def test_the_command_says_limas_percentages(capsys):
    words = "compare --theta0 157.5deg --with harmonic,fourier:4,fourier-theta:4".split()
    assert main([*words, "--json"]) == 0
    errors = json.loads(capsys.readouterr().out)["errors"]
    percent = {(each["name"], each["periods"]): each["largest_error_percent"] for each in errors}
    assert percent["harmonic", 1.0] == pytest.approx(12.3427, abs=5e-5)
    assert percent["fourier:4", 1.0] == pytest.approx(0.3989, abs=5e-5)
    # Periodic approximations are as good after a hundred periods.
    assert percent["fourier:4", 100.0] == pytest.approx(percent["fourier:4", 1.0], rel=1e-6)
    assert main(words) == 0
    text = capsys.readouterr().out
    assert "over 1 period" in text and "over 100 periods" in text and "0.3989" in text and "12.34" in text


def test_the_command_tells_the_trap_and_the_gaps(capsys):
    assert main([*HORSLEY_WORDS, "--with", "solve_ivp,rk4:0.025"]) == 0
    said = capsys.readouterr().out
    assert "goes over the top at t = 9.468 s" in next(
        line for line in said.splitlines() if line.startswith("solve_ivp")
    )
    assert "over the top" not in next(line for line in said.splitlines() if line.startswith("rk4"))
    assert main("compare --theta0 144deg --with fourier:1".split()) == 0
    assert "undefined from t/T = 0\n" in capsys.readouterr().out


def test_the_command_writes_its_table_and_its_picture(capsys, tmp_path):
    table, picture = tmp_path / "a.csv", tmp_path / "a.svg"
    words = [*HORSLEY_WORDS, "--with", "fourier:1,rk4:0.025", "--periods", "0.5"]
    assert main([*words, "--out", str(table), "--plot", str(picture)]) == 0
    assert f"written  {picture}" in capsys.readouterr().out
    rows = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    names, *values = csv.reader(rows)
    assert names == ["t [s]", "theta [rad]", "theta_fourier_1 [rad]", "theta_rk4_0.025 [rad]"]
    assert len(values) == 501 and values[0][2] == "nan" and float(values[-1][1]) == pytest.approx(-3.0)
    assert b"<svg" in picture.read_bytes()[:400]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--theta0 1", "missing --with, what to compare, such as --with harmonic,fourier:4"),
        ("--theta0 1 --with fourrier:4", "--with = fourrier:4: must be one of fourier:N, "),
        ("--theta0 1 --with fourier:0", "--with = fourier:0: must be fourier:N with a whole N from 1 to 500"),
        ("--theta0 1 --with fourier:1000000", "must be fourier:N with a whole N from 1 to 500"),
        ("--theta0 1 --with linear,,harmonic", "--with = linear,,harmonic: has an empty name"),
        ("--theta0 1 --with linear,linear", "--with = linear,linear: names linear twice"),
        ("--theta0 180deg --with linear", "--theta0 = 180deg: is the upright balance, whose period is infinite"),
        ("--theta0 540deg --with harmonic", "--theta0 = 540deg: is the upright balance, whose period is infinite"),
        ("--theta0 1 --with fourier:4,fourier:04", "--with = fourier:4,fourier:04: names fourier:4 twice"),
        ("--theta0 1 --with rk4:0.1,rk4:1e-1", "--with = rk4:0.1,rk4:1e-1: names rk4:0.1 twice"),
        ("--theta0 0 --with linear", "--theta0 = 0: is at rest"),
        ("--theta0 0 --velocity0 2 --with linear", "--velocity0 = 2: is on the separatrix"),
        (
            "--theta0 0 --velocity0 3 --with harmonic",
            "--with = harmonic: regime = rotation: must be libration for harmonic",
        ),
        ("--theta0 1 --with linear --periods 0", "--periods = 0: must be above 0 and at most 10000"),
        ("--theta0 1 --with rk4:1e-12", "must be at most 5,000,000 steps"),
    ],
)
def test_refusals(words, message, capsys):
    assert main(["compare", *words.split()]) == 2
    said = capsys.readouterr().err
    assert message in said and said.count("\n") == 1 and said.startswith("libration compare: ")


def test_the_steepest_approximations_are_answered_at_once(capsys):
    assert main("compare --theta0 3 --with taylor:200,fourier:500 --periods 1000 --json".split()) == 0
    errors = json.loads(capsys.readouterr().out)["errors"]
    assert [each["largest_error_rad"] is None for each in errors] == [True, True, False, False]
    assert [each["periods"] for each in errors] == [100.0, 1000.0] * 2


def test_the_secular_error_is_found_late_in_time():
    # The largest of two million instants.
    for degrees, periods, largest in [(170.0, 100, 6.1082), (164.5, 100, 6.0118), (179.0, 10, 6.2654)]:
        found = approx.angle("small-m").of(Pendulum(math.radians(degrees))).error(periods)
        assert found.difference == pytest.approx(largest, abs=6e-5)


@pytest.mark.parametrize(
    "words", ["--theta0 150deg", "--theta0 0 --velocity0 1.9999999999999998", "--theta0 179.99999999deg"]
)
def test_period_and_formulas_are_of_one_swing(words, capsys):
    assert main(["period", *words.split(), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    for each in answer["formulas"]:
        assert each["period_ratio"] / answer["period_ratio"] - 1 == pytest.approx(
            each["relative_error"], rel=1e-14, abs=3e-15
        )


@pytest.mark.parametrize("angle", ["180deg", "-180deg", "540deg", "-900deg"])
def test_no_formula_is_shown_at_the_upright_balance(angle, capsys):
    assert main(["period", "--theta0", angle]) == 0
    assert "formulas       none" in capsys.readouterr().out
    assert main(["period", "--theta0", angle, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["formulas"] == []
