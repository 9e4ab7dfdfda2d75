"""Quantities with units: taken where they convert, in every argument, and refused with the right unit named."""

import math

import numpy as np
import pint
import pytest
from bits import all_same, same

import libration
from libration import DampedPendulum, Duffing, Pendulum, approx, elliptic

UNITS = pint.UnitRegistry()
Q = UNITS.Quantity
SECONDS = np.linspace(0.0, 3.0, 7)


class Unconverted(Exception):
    """What astropy raises, as a class that nobody catches."""


class Astropy(np.ndarray):
    """An array of numbers in seconds or in 1/s, as those of astropy are: radians are no pure numbers there."""

    def __new__(cls, values, unit):
        made = np.asarray(values, dtype=float).view(cls)
        made.unit = unit
        return made

    def to_value(self, unit):
        if unit != self.unit:
            raise Unconverted(unit)
        return np.asarray(self)

    def __array_ufunc__(self, *arguments, **keywords):
        return NotImplemented

    def __float__(self):
        raise TypeError("only dimensionless scalar quantities can be converted to Python scalars")


def test_a_pendulum_of_quantities_is_that_of_its_numbers():
    stated = Pendulum(Q(150, "deg"), Q(0.5, "rad/s"), length=Q(65.0, "cm"), gravity=Q(9.8, "m/s^2"))
    assert stated == Pendulum(
        Q(150, "deg").to("rad").magnitude, 0.5, length=Q(65.0, "cm").to("m").magnitude, gravity=9.8
    )
    assert Pendulum(1.0, omega0=Q(3.0, "1/s")) == Pendulum(1.0, omega0=3.0)
    assert Pendulum(1.0, omega2=Q(-9.0, "1/s^2")) == Pendulum(1.0, omega2=-9.0)
    assert Pendulum(1.0, length=Astropy(2.0, "m")) == Pendulum(1.0, length=2.0)
    assert Pendulum(1.0, omega0=Astropy(3.0, "1/s")) == Pendulum(1.0, omega0=3.0)
    assert Pendulum.from_period(Q(3.0, "minute")) == Pendulum.from_period(180.0)
    assert DampedPendulum(Q(1.0, "rad"), length=Q(1.0, "m")).theta(2.0) == DampedPendulum(1.0, length=1.0).theta(2.0)


PENDULUM = Pendulum(2.0, 0.3, length=0.7)
CALLS = {
    "theta": PENDULUM.theta,
    "velocity": PENDULUM.velocity,
    "motion": PENDULUM.motion,
    "turns": PENDULUM.turns,
    "phase": PENDULUM.phase,
    "sensitivities": PENDULUM.sensitivities,
    "with friction": DampedPendulum(2.0, length=0.7, friction=libration.Friction(linear=0.1)).motion,
    "an approximation": approx.angle("fourier:4").of(PENDULUM).theta,
    "friction in the mean": lambda t: libration.damped.averaged_turning_angle(1.0, t, libration.Friction(linear=0.1)),
    "of arrays": lambda t: libration.motion(t, 1.0, 0.2),
    "a spring": Duffing(1.0, p=1.0, q=1.0).motion,
}


@pytest.mark.parametrize("name", CALLS)
def test_instants_with_units(name):
    call = CALLS[name]
    assert all_same(call(Q(SECONDS, "s")), call(SECONDS))
    assert all_same(call(Q(1500.0, "ms")), call(Q(1500.0, "ms").to("s").magnitude))
    assert all_same(call(Astropy(SECONDS, "s")), call(SECONDS))
    with pytest.raises(TypeError, match=r"^t in meter: must be in s, or in what converts to it$"):
        call(Q(1.0, "m"))


def test_arrays_of_states_with_units():
    angles, speeds = np.array([10.0, 90.0, 179.0]), np.array([0.1, 0.2, 0.3])
    plain = Q(angles, "deg").to("rad").magnitude, speeds
    found = libration.motion(Q(1.0, "s"), Q(angles, "deg"), velocity0=Q(speeds, "rad/s"), omega0=Q(2.0, "1/s"))
    assert all_same(found, libration.motion(1.0, *plain, 2.0))
    assert same(libration.period(Q(angles, "deg"), length=Q(1.0, "m")), libration.period(plain[0], length=1.0))
    out = np.empty(3)
    assert libration.theta(Q(SECONDS[:3], "s"), 1.0, out=out) is out and same(out, libration.theta(SECONDS[:3], 1.0))


def test_pure_numbers_may_have_units_too():
    assert elliptic.sn(Q(1.0, "m/m"), m=0.5) == elliptic.sn(1.0, m=0.5)
    assert elliptic.sn(Q(50.0, "percent"), m=0.5) == elliptic.sn(0.5, m=0.5)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: Pendulum(Q(1.0, "m")), "theta0 in meter: must be in rad, or in what converts to it"),
        (lambda: Pendulum(1.0, length=Q(1.0, "s")), "length in second: must be in m, or in what converts to it"),
        (
            lambda: Pendulum(1.0, length=Q(1.0, "m"), gravity=Q(9.8, "m/s")),
            "gravity in meter / second: must be in m/s**2",
        ),
        (
            lambda: Pendulum(1.0, omega0=Q(1.0, "Hz")),
            "omega0 in hertz: must be in rad/s; a frequency in Hz is 2 pi times as many rad/s",
        ),
        (lambda: Pendulum(1.0, length=Q([1.0, 2.0], "m")), "length = an array of shape (2,): must be one real number"),
        (lambda: libration.theta(1.0, 1.0, 0.0, Q([1.0, 2.0], "kHz")), "omega0 in kilohertz: must be in rad/s"),
        (lambda: libration.motion(1.0, Q([1.0, 2.0], "s")), "theta0 in second: must be in rad"),
        (lambda: elliptic.sn(Q(1.0, "m"), m=0.5), "u in meter: must be a number without units"),
        (lambda: Pendulum(1.0, length=Astropy(1.0, "s")), "length in s: must be in m"),
    ],
)
def test_the_right_unit_is_named(call, said):
    with pytest.raises((TypeError, ValueError)) as refused:
        call()
    assert str(refused.value).startswith(said) and "\n" not in str(refused.value)


def test_a_frequency_in_hertz_is_written_out():
    """What the refusal says is right: of a small swing the frequency in Hz is that of the swings."""
    found = Pendulum(1e-9, omega0=Q(2 * math.pi * 0.5, "rad/s"))
    assert found.period == pytest.approx(2.0, rel=1e-15)
