"""Motions stated on the command line by an energy, a turning angle or a period, and when they pass an angle."""

import json

import pytest

from libration import Pendulum
from libration.cli import main


@pytest.fixture
def answer(capsys):
    """The JSON object that a command prints."""

    def run(words):
        assert main([*words.split(), "--json"]) == 0
        return json.loads(capsys.readouterr().out)

    return run


@pytest.mark.parametrize(
    ("options", "made"),
    [
        ("--energy-ratio 0.5", Pendulum.from_energy(energy_ratio=0.5, omega0=2.0)),
        ("--energy-ratio-c -1e-20 --downwards", Pendulum.from_energy(energy_ratio_c=-1e-20, direction=-1, omega0=2.0)),
        ("--energy 3rad2/s2 --theta0 10deg", Pendulum.from_energy(energy=3.0, theta0=0.17453292519943295, omega0=2.0)),
        ("--turning-angle 170deg", Pendulum.from_turning_angle(2.9670597283903604, omega0=2.0)),
        ("--turning-angle 1e-17 --from-top", Pendulum.from_turning_angle(theta_max_from_top=1e-17, omega2=-4.0)),
        ("--period 4s", Pendulum.from_period(4.0, omega0=2.0)),
        ("--period 4s --rotation", Pendulum.from_period(4.0, regime="rotation", omega0=2.0)),
    ],
)
def test_the_motion_is_that_of_python(answer, options, made):
    found = answer(f"at 1.5s --omega0 2 {options}")
    [instant] = found["instants"]
    assert (instant["theta_rad"], instant["velocity_rad_per_s"]) == made.motion(1.5)
    assert found["given"] == options.split()[0][2:].replace("-", "_")
    assert (found["theta0_rad"], found["velocity0_rad_per_s"]) == (made.theta0, made.velocity0)
    found = answer(f"solve --omega0 2 {options}")
    assert found["regime"] == made.regime and found["energy_ratio_c"] == made.energy_ratio_c
    found = answer(f"period --omega0 2 {options} --only exact")
    assert found["period_s"] == made.period


def test_without_a_frequency_and_several_angles(answer, capsys):
    found = answer("period --energy-ratio-c 1e-17 --only exact")
    assert found["period_omega0_rad"] == Pendulum.from_energy(energy_ratio_c=1e-17).period
    assert main("period --energy-ratio 0.9 --theta0 1deg,10deg,20deg --only exact".split()) == 0
    assert capsys.readouterr().out.count("1.64") == 3


def test_an_energy_is_that_at_the_start_where_there_is_friction(answer):
    found = answer("solve --energy-ratio 0.5 --omega0 2 --linear 0.1 --until 1s")
    assert found["velocity0_rad_per_s"] == Pendulum.from_energy(energy_ratio=0.5, omega0=2.0).velocity0


def test_crossings(answer):
    found = answer("at --crossing 60deg --theta0 0 --velocity0 3 --omega0 1")
    [instant] = found["instants"]
    assert instant["t_s"] == Pendulum(0.0, 3.0).times(1.0471975511965979, 0.0, 9.0)[0]
    assert instant["theta_deg"] == pytest.approx(60, rel=1e-15)


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (
            "at 1s --energy-ratio 0.5 --energy 1 --omega0 1",
            "--energy-ratio = 0.5 and --energy = 1: give one of the two",
        ),
        ("at 1s --energy 1 --velocity0 1 --omega0 1", "--energy = 1 and --velocity0 = 1: give one of the two"),
        ("at 1s --energy-ratio -1 --omega0 1", "--energy-ratio = -1.0: must be finite and not negative"),
        ("at 1s --energy-ratio-c 2 --omega0 1", "--energy-ratio-c = 2.0: must be finite and at most 1"),
        ("at 1s --energy-ratio 0.5m --omega0 1", "--energy-ratio = 0.5m: must be a plain number, without a unit"),
        ("at 1s --energy-ratio inf --omega0 1", "--energy-ratio = inf: must be a finite number"),
        ("at 1s --turning-angle 200deg --omega0 1", "--turning-angle = 3.490658503988659: must be from 0 to pi"),
        ("at 1s --turning-angle -1deg --from-top --omega0 1", "--turning-angle = -0.017453292519943295: must be from"),
        ("at 1s --period 1s --omega0 1", "--period = 1.0: must be at least that of small swings, 6.283185307179586"),
        ("at 1s --period 0s --rotation --omega0 1", "--period = 0.0: must be positive in rotation"),
        ("period --period 1s", "--period = 1s: needs --length or --omega0 beside it"),
        ("period --energy 1rad2/s2", "--energy = 1rad2/s2: has a unit, but no frequency is given"),
        ("at 1s --theta0 1 --rotation --omega0 1", "--rotation: needs an energy beside it, such as --period"),
        ("at 1s --theta0 1 --downwards --omega0 1", "--downwards: needs an energy beside it, such as --energy"),
        ("at 1s --energy 1 --rotation --omega0 1", "--rotation: needs --period beside it, the time of a turn"),
        ("at 1s --energy-ratio 0.5 --theta0 2 --omega0 1", "--theta0 = 2.0: must be an angle that the energy reaches"),
        ("at 1s --crossing 1 --theta0 1 --omega0 1", "TIME = 1s and --crossing = 1: give one of the two"),
        ("at --crossing 2 --theta0 1 --omega0 1", "--crossing = 2: is an angle that the motion does not pass"),
        ("at --crossing 0 --theta0 1 --omega0 1 --linear 0.1", "--crossing = 0: is for a motion without friction"),
    ],
)
def test_refusals(capsys, words, line):
    assert main(words.split()) == 2
    shown = capsys.readouterr()
    assert shown.out == "" and len(shown.err.splitlines()) == 1
    assert line in shown.err, shown.err
