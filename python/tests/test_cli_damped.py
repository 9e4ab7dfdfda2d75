"""`libration solve` and `libration at` with friction and torque: numbers, tables, pictures, help, refusals."""

import csv
import json
import math

import numpy as np
import pytest

from libration import DampedPendulum, Friction, Torque
from libration.cli import main

START = ["--theta0", "2", "--length", "1m"]
FRICTION = ["--linear", "0.02/s", "--quadratic", "0.01", "--dry", "0.1 rad/s2"]
DECAY = DampedPendulum(2.0, length=1.0, friction=Friction(linear=0.02, quadratic=0.01, dry=0.1))
DRIVE = ["--torque", "0.5", "--torque-amplitude", "20deg/s2", "--torque-frequency", "0.5Hz", "--torque-phase", "90deg"]
DRIVEN = DampedPendulum(
    2.0,
    length=1.0,
    friction=Friction(linear=0.02),
    torque=Torque(constant=0.5, amplitude=math.radians(20), frequency=math.pi, phase=math.pi / 2),
)


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def answer(capsys, *words):
    assert main([*words, "--json"]) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    return json.loads(shown.out, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))


def test_a_decay(capsys):
    got = answer(capsys, "solve", *START, *FRICTION, "--until", "60s")
    [(begin, _)] = DECAY.rests(0.0, 60.0)
    assert (got["linear_1_per_s"], got["quadratic_1_per_rad"], got["dry_rad_per_s2"]) == (0.02, 0.01, 0.1)
    assert got["stop_time_s"] == begin and got["rests_s"] == [[begin, 60.0]]
    assert got["turning_times_s"] == DECAY.turning_times(0.0, 60.0).tolist()
    assert got["turning_angles_rad"] == DECAY.theta(DECAY.turning_times(0.0, 60.0)).tolist()
    assert (got["last_theta_rad"], got["last_velocity_rad_per_s"]) == DECAY.motion(60.0)
    assert (got["undamped_regime"], got["samples_nan"]) == ("libration", 0)
    assert got["energy_rad2_per_s2"] == DECAY.energy(0.0)


def test_a_driven_motion(capsys):
    got = answer(capsys, "solve", *START, "--linear", "0.02", *DRIVE, "--until", "20s")
    assert got["last_theta_rad"] == DRIVEN.theta(20.0)
    assert (got["torque_amplitude_rad_per_s2"], got["torque_frequency_rad_per_s"]) == (math.radians(20), math.pi)
    assert got["stop_time_s"] is None


@pytest.mark.parametrize(
    ("typed", "linear"), [("0.6/min", 0.01), ("36 1/h", 0.01), ("0,01", 0.01), ("-0.01 s-1", -0.01)]
)
def test_units(capsys, typed, linear):
    got = answer(capsys, "solve", *START, "--linear", typed)
    assert got["linear_1_per_s"] == pytest.approx(linear, rel=1e-15)


def test_tables():
    for name in ("a.csv", "a.npz", "a.json"):
        assert main(["solve", *START, *FRICTION, "--samples", "5", "--out", name]) == 0
    with open("a.csv", newline="") as file:
        head, *rows = csv.reader(line for line in file if not line.startswith("#"))
    assert head == ["t [s]", "theta [rad]", "velocity [rad/s]", "energy [rad^2/s^2]"]
    t = np.linspace(0, 10, 5)
    truth = np.stack([t, *DECAY.motion(t), DECAY.energy(t)], axis=1)
    assert np.array_equal(np.array(rows, dtype=float), truth)
    with np.load("a.npz") as arrays:
        assert np.array_equal(arrays["theta"], truth[:, 1]) and float(arrays["dry"]) == 0.1
    with open("a.json") as file:
        assert json.load(file)["energy_rad2_per_s2"] == truth[:, 3].tolist()
    with open("a.csv") as file:
        assert "# linear = 0.02 1/s\n" in file.readlines()


def test_summary_for_people(capsys):
    assert main(["solve", *START, *FRICTION, "--until", "60s"]) == 0
    lines = {line[:16].strip(): line[16:].strip() for line in capsys.readouterr().out.splitlines()}
    assert lines["friction"] == "linear 0.02 1/s, quadratic 0.01 1/rad, dry 0.1 rad/s^2"
    assert lines["without friction"].startswith("libration, period 2.66632624")
    turning = DECAY.turning_times(0.0, 60.0)
    assert lines["turning points"].startswith(f"{turning.size}, t = 0 s at 2 rad = 114.592 deg to t = ")
    assert lines["stops"].startswith(f"at t = {DECAY.rests(0.0, 60.0)[0][0]:.15g} s, theta = ")


def test_a_motion_that_turns_over_the_top_and_is_held(capsys):
    words = ["solve", "--theta0", "0", "--velocity0", "7", "--omega0", "1", "--linear", "0.1", "--until", "30s"]
    assert main(words) == 0
    n = int(DampedPendulum(0.0, 7.0, friction=Friction(linear=0.1)).turns(30.0)[0])
    assert f"over the top      {n} whole turns forward" in capsys.readouterr().out
    held = [
        "solve",
        "--theta0",
        "0",
        "--omega0",
        "1",
        "--dry",
        "0.5",
        "--torque-amplitude",
        "0.7",
        "--torque-frequency",
        "0.1",
    ]
    assert main([*held, "--torque-phase", "-90deg", "--until", "100s"]) == 0
    assert "held by dry friction" in capsys.readouterr().out


def test_a_torque_of_a_file(capsys):
    with open("tau.csv", "w") as file:
        file.write("t [s],torque [deg/s2]\n0,0\n1,90\n4,-90\n")
    got = answer(capsys, "solve", *START, "--torque-file", "tau.csv", "--until", "5s", "--samples", "6")
    samples = [0.0, 1.0, 4.0], [0.0, math.pi / 2, -math.pi / 2]
    pendulum = DampedPendulum(2.0, length=1.0, torque=Torque(samples=samples))
    assert got["samples_nan"] == 1 and got["last_theta_rad"] is None
    assert got["turning_times_s"] == pendulum.turning_times(0.0, 4.0).tolist()
    assert main(["solve", *START, "--torque-file", "tau.csv", "--until", "5s"]) == 0
    assert "of them not reached" in capsys.readouterr().out


def test_at(capsys):
    got = answer(capsys, "at", "1min,2min", *START, *FRICTION)
    assert [each["theta_rad"] for each in got["instants"]] == DECAY.theta([60.0, 120.0]).tolist()
    assert got["undamped_regime"] == "libration" and "regime" not in got
    assert main(["at", "20s", "--theta0", "0", "--velocity0", "7", "--omega0", "1", "--linear", "0.1"]) == 0
    assert "whole turns" in capsys.readouterr().out
    assert main(["at", "-1s", *START, "--dry", "0.1", "--presliding", "1deg"]) == 0
    assert "not known, the motion does not get there" in capsys.readouterr().out


@pytest.mark.parametrize("words", [FRICTION, [*DRIVE, "--linear", "0.3"], ["--linear", "0.1", "--from-top"]])
def test_pictures(words):
    assert main(["solve", *START, *words, "--plot", "a.png", "--lang", "pt-BR"]) == 0
    with open("a.png", "rb") as file:
        assert file.read(4) == b"\x89PNG"


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["--linear", "0.02/m"], "--linear = 0.02/m: unknown unit '/m'; rates take /s, /min"),
        (["--linear", ""], "--linear = '': is not a number with a unit; rates look like 1.5 or 1.5/s"),
        (["--linear", "much"], "--linear = much: is not a number with a unit; rates look like 1.5 or 1.5/s"),
        (["--dry", "-0.1"], "--dry = -0.1: must be finite and not negative"),
        (["--dry", "0.1m"], "--dry = 0.1m: unknown unit 'm'; torques over inertia take rad/s2, deg/s2"),
        (["--presliding", "1deg"], "--presliding = 1deg: needs --dry beside it, the friction that it belongs to"),
        (["--dry", "1", "--presliding", "1e-30"], "--presliding = 1e-30: must be 0, or finite and at least 1e-10"),
        (
            ["--torque-amplitude", "1"],
            "--torque-amplitude = 1: needs --torque-frequency beside it, such as 0.5Hz; a constant torque is --torque",
        ),
        (["--torque-frequency", "1Hz"], "--torque-frequency = 1Hz: needs --torque-amplitude beside it"),
        (["--torque-phase", "1"], "--torque-phase = 1: needs --torque-amplitude beside it"),
        (["--torque-file", "none.csv"], "--torque-file = none.csv: cannot be read: No such file or directory"),
        (["--torque-file", "late.csv"], "--torque-file = late.csv: first torque time = 1.0 (the last is 2.0): must be"),
        (
            ["--torque-file", "back.csv"],
            "--torque-file = back.csv: torque time = 0.0: must be later than the one before it",
        ),
        (["--gamma", "0.1"], "unknown option '--gamma'; did you mean --linear?"),
        (["--friction", "0.1"], "unknown option '--friction'; did you mean --linear?"),
    ],
)
def test_refusals(capsys, words, line):
    for name, text in (("late.csv", "t,torque\n1.0,0.5\n2.0,0.5\n"), ("back.csv", "t,torque\n1.0,0.5\n0.0,0.5\n")):
        with open(name, "w") as file:
            file.write(text)
    assert main(["solve", *START, *words]) == 2
    shown = capsys.readouterr()
    assert shown.out == "" and shown.err.startswith(f"libration solve: {line}"), shown.err
    assert shown.err.count("\n") == 1
