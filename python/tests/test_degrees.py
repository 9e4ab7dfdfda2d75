"""Degrees are not radians: the door for degrees, its rounding, and the warning where they are passed for radians."""

import copy
import math
import pickle
import warnings
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import libration
from libration import Duffing, Pendulum
from libration.cli import main

# pi to 60 digits (OEIS A000796), apart from the constant under test.
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")


def nearest(degrees):
    """The double nearest to an angle as radians: Python rounds the quotient of whole numbers correctly."""
    exact = Fraction(degrees) * PI / 180
    return exact.numerator / exact.denominator


@given(st.floats(-720, 720), st.floats(-1e300, 1e300))
def test_degrees_are_rounded_once(theta0, velocity0):
    pendulum = Pendulum.degrees(theta0, velocity0, length=0.8)
    assert pendulum.theta0 == nearest(theta0)
    assert pendulum.velocity0 == nearest(velocity0)
    assert pendulum.length == 0.8


def test_math_radians_would_not_do():
    """The sibling: it rounds twice, and the test above sees it."""
    assert any(math.radians(each) != nearest(each) for each in range(1, 360))
    assert all(Pendulum.degrees(each).theta0 == nearest(each) for each in range(1, 360))


def test_half_a_turn_is_a_swing_below_the_top():
    for degrees in (180, -180, 540, 180.0, np.float32(180)):
        upright = Pendulum.degrees(degrees)
        assert upright.regime == "libration"
    assert Pendulum.degrees(180) == Pendulum(math.pi)
    assert Pendulum.degrees(360).theta0 == math.tau
    assert Pendulum.degrees(-0.0).theta0.hex() == "-0x0.0p+0"


def test_degrees_take_every_frequency():
    assert Pendulum.degrees(90, omega0=2.0) == Pendulum(math.pi / 2, omega0=2.0)
    assert Pendulum.degrees(90, omega2=-2.0) == Pendulum(math.pi / 2, omega2=-2.0)
    assert Pendulum.degrees(90, 180, length=2, gravity=1.62) == Pendulum(math.pi / 2, math.pi, length=2, gravity=1.62)
    for bad in (math.nan, math.inf, "90", None, True, 10**400):
        with pytest.raises(ValueError, match=r"^theta0 = .*: must be "):
            Pendulum.degrees(bad)


def test_a_subclass_has_the_door_too():
    class Clock(Pendulum):
        pass

    assert type(Clock.degrees(30)) is Clock


def said(call):
    """The warnings of a call as Python's own filter shows them."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        call()
    return caught


def test_a_large_release_warns_once_a_place():
    def thrice():
        for theta0 in (120, 120.0, np.int64(120)):
            Pendulum(theta0, length=0.8)

    [warning] = said(thrice)
    assert warning.category is UserWarning
    assert str(warning.message) == (
        "theta0 = 120.0 is in radians: 19 whole turns and 35.49 degrees; for degrees write Pendulum.degrees(120.0)"
    )
    assert warning.filename == __file__
    assert warning.lineno == thrice.__code__.co_firstlineno + 2


@pytest.mark.parametrize("theta0", [math.nextafter(4 * math.pi, 13), -13.0, 1e300])
def test_what_warns(theta0):
    assert len(said(lambda: Pendulum(theta0))) == 1
    assert len(said(lambda: Pendulum(theta0, 0, omega2=-1))) == 1


@pytest.mark.filterwarnings("error")
def test_what_does_not_warn():
    assert Pendulum(4 * math.pi).velocity0 == 0
    assert Pendulum(-12.5).velocity0 == 0
    assert Pendulum(120.0, 1e-3).theta0 == 120.0
    assert Pendulum.degrees(5000).theta0 > 80
    libration.motion(1.0, np.array([120.0, 200.0]))
    libration.motion(1.0, 120.0)
    libration.advance(120.0, 0.0, 1.0)
    assert main(["period", "--theta0", "5000deg"]) == 0
    Duffing.of_pendulum(Pendulum(1.0))
    with pytest.raises(ValueError):
        Pendulum(math.nan)


def test_copies_do_not_warn_again():
    made = []
    assert len(said(lambda: made.append(Pendulum(300.0)))) == 1
    assert said(lambda: (copy.copy(made[0]), copy.deepcopy(made[0]), pickle.loads(pickle.dumps(made[0])))) == []


def test_length_and_gravity_are_kept():
    pendulum = Pendulum(1.0, length=2, gravity=-1.62)
    assert (pendulum.length, pendulum.gravity) == (2.0, -1.62)
    for again in (copy.copy(pendulum), copy.deepcopy(pendulum), pickle.loads(pickle.dumps(pendulum))):
        assert (again.length, again.gravity) == (2.0, -1.62)
    assert repr(pendulum) == "Pendulum(theta0=1.0, velocity0=0.0, length=2.0, gravity=-1.62)"
    alone = Pendulum(1.0, length=0.8)
    assert (alone.length, alone.gravity) == (0.8, 9.80665)
    assert repr(alone) == "Pendulum(theta0=1.0, velocity0=0.0, length=0.8)"
    assert Pendulum.from_action_phase(1.0, 0.5, length=3.0).length == 3.0


@pytest.mark.parametrize("given", [{}, {"omega0": 2.0}, {"omega2": -2.0}])
def test_no_length_and_no_gravity_without_a_length(given):
    assert Pendulum(1.0, **given).length is None
    assert Pendulum(1.0, **given).gravity is None
