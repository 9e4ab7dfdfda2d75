"""g from a period by the exact law, and the normal g of a place: Python and the command."""

import json
import math

import pytest

import libration
from libration.cli import main


@pytest.mark.parametrize("degrees", [0.0, 1.0, 20.0, 90.0, 170.0, 179.9])
@pytest.mark.parametrize("sign", [1, -1])
def test_g_by_the_exact_period(degrees, sign):
    swing = math.radians(degrees)
    period = (
        libration.Pendulum(swing, length=0.7, gravity=9.8).period if degrees else 2 * math.pi * math.sqrt(0.7 / 9.8)
    )
    found = libration.gravity_of_period(period, 0.7, swing=sign * swing)
    assert found.value == pytest.approx(9.8, rel=1e-14)
    assert found.u == 0


def test_uncertainties_combine():
    found = libration.gravity_of_period((2.0, 0.002), (1.0, 0.001))
    assert found.u == pytest.approx(math.pi**2 * math.hypot(0.002, 0.001), rel=1e-12)
    # d ln T / d swing = swing/8 for small swings, and g is as T**-2.
    swung = libration.gravity_of_period(2.0, 1.0, swing=(0.1, 0.01))
    assert swung.u == pytest.approx(swung.value * 2 * 0.1 / 8 * 0.01, rel=5e-3)


def test_g_of_a_swing_that_decays():
    swing = math.radians(80)
    # Ten swings of a pendulum with linear friction, by the integration and its turning points.
    pendulum = libration.DampedPendulum(swing, length=0.7, gravity=9.8, friction=libration.Friction(linear=0.002))
    turns = list(pendulum.turning_times(0.1, 40.0))[:20]
    end = abs(pendulum.theta(turns[-1]))
    found = libration.gravity_of_period(turns[-1] / 10, 0.7, swing=swing, end=end)
    # What is left is of second order in the friction, which is 5e-4 of the frequency.
    assert found.value == pytest.approx(9.8, rel=1e-5)
    # By one of the angles alone it is another one.
    for alone in (swing, end):
        assert abs(libration.gravity_of_period(turns[-1] / 10, 0.7, swing=alone).value - 9.8) > 0.02
    # And where it does not decay, the same.
    still = libration.gravity_of_period(2.0, 0.7, swing=(swing, 0.0), end=(swing, 0.0))
    assert still.value == libration.gravity_of_period(2.0, 0.7, swing=swing).value
    told = libration.gravity_of_period(2.0, 0.7, swing=(swing, 0.02), end=(0.5, 0.01))
    parts = [libration.gravity_of_period(2.0, 0.7, swing=(swing, u), end=(0.5, v)).u for u, v in ((0.02, 0), (0, 0.01))]
    assert told.u == pytest.approx(math.hypot(*parts), rel=1e-12)


@pytest.mark.parametrize(
    ("latitude", "expected"),
    # Normal gravity at the equator, at 45 degrees and at the pole, NIMA TR 8350.2, table 3.4 and equation 4-1.
    [(0.0, 9.7803253359), (45.0, 9.8061977694), (90.0, 9.8321849378)],
)
def test_normal_gravity(latitude, expected):
    for sign in (1, -1):
        assert libration.normal_gravity(sign * math.radians(latitude)) == pytest.approx(expected, abs=2e-9)


def test_normal_gravity_falls_with_height():
    # The free-air gradient, 0.3086 mGal/m.
    fallen = libration.normal_gravity(math.radians(45)) - libration.normal_gravity(math.radians(45), 100.0)
    assert fallen == pytest.approx(100 * 3.0855e-6, rel=1e-3)


REFUSED = [
    (lambda: libration.gravity_of_period(0.0, 1.0), "period = 0 s"),
    (lambda: libration.gravity_of_period(1.0, math.inf), "length = inf m"),
    (lambda: libration.gravity_of_period(1.0, 1.0, swing=4.0), "swing = 4 rad"),
    (lambda: libration.gravity_of_period(1.0, 1.0, swing=1.0, end=0.0), "swing at the end = 0 rad"),
    (lambda: libration.gravity_of_period(1.0, 1.0, end=1.0), "swing = 0 rad"),
    (lambda: libration.gravity_of_period((1.0, math.nan), 1.0), "uncertainty of period"),
    (lambda: libration.normal_gravity(2.0), "latitude = 2 rad"),
    (lambda: libration.normal_gravity(1.0, 2e5), "height = 200000 m"),
    (lambda: libration.normal_gravity(math.nan), "latitude = NaN rad"),
]


@pytest.mark.parametrize(("call", "message"), REFUSED)
def test_bad_arguments(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_the_command(capsys):
    words = "gravity --period 2.0218±0.0010 --length 1.000(1)m --swing 20±1deg --latitude -23.5deg --height 760m"
    assert main(words.split()) == 0
    printed = capsys.readouterr().out
    assert "9.807 ± 0.020 m/s^2" in printed
    assert "9.78619 m/s^2 at -23.5 deg, 760 m" in printed
    assert main([*words.split(), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["g"]["value"] == libration.gravity_of_period(2.0218, 1.0, swing=math.radians(20)).value
    assert told["normal_g"] == pytest.approx(9.78619, abs=1e-5)


WORDS = [
    ("", "missing --period and --length"),
    ("--period 2s", "missing --length"),
    ("--period 2s --length 1m --swing 180deg", "must be less than 180deg"),
    ("--latitude 52.1", "write 52.1deg"),
    ("--latitude 91deg", "from -90deg to 90deg"),
    ("--latitude 9deg --height 4000km", "--height = 4000km: must be from -12000"),
    ("--height 3m", "missing --period"),
    ("--swing 3deg --latitude 1deg", "needs --period and --length"),
    ("--period 2±1±1 --length 1m", "one value, or a value with its standard uncertainty"),
    ("--period 2s --length 1m±2deg", "unknown unit 'deg'"),
    ("--period 2s --length 1m±-2m", "must be 0 or greater"),
]


@pytest.mark.parametrize(("words", "message"), WORDS)
def test_refusals(words, message, capsys):
    assert main(["gravity", *words.split()]) == 2
    told = capsys.readouterr()
    assert message in told.err and told.err.count("\n") == 1 and not told.out
