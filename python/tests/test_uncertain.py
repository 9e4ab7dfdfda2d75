"""Numbers with uncertainties: derivatives against differences of neighbouring motions, correlations, and the means digit for digit."""

import math

import numpy as np
import pytest
from uncertainties import correlation_matrix, ufloat

from libration import Pendulum, uncertain_motion, uncertain_period

STARTS = [
    (1.0, 0.0, 0.65, 9.8),
    (3.0, 0.2, 1.0, 9.8),
    (0.5, 9.0, 0.4, 9.8),
    (0.0, -3.0, 2.0, 9.8),
    (-2.0, 0.0, 1.0, 1.6),
]
NAMES = ("theta0", "velocity0", "length", "gravity")


def slopes(call, given, step=1e-6):
    """Derivatives of a call by each argument, by central differences of the fourth order."""
    found = []
    for j, value in enumerate(given):
        h = step * max(1.0, abs(value))

        def moved(k, j=j, h=h):
            return call(*(each + k * h * (i == j) for i, each in enumerate(given)))

        found.append((8 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12 * h))
    return np.array(found)


@pytest.mark.parametrize("start", STARTS)
def test_derivatives_are_those_of_neighbouring_motions(start):
    given = [ufloat(value, 1e-3) for value in start]
    theta0, velocity0, length, gravity = given
    time = ufloat(2.3, 1e-3)
    found = uncertain_motion(time, theta0, velocity0, length=length, gravity=gravity)
    for of, each in enumerate(found):
        truth = slopes(
            lambda a, v, length, g, t, of=of: float(Pendulum(a, v, length=length, gravity=g).motion(t)[of]),
            [*start, 2.3],
        )
        got = np.array([each.derivatives[name] for name in (*given, time)])
        assert got == pytest.approx(truth, rel=1e-6, abs=1e-6 * np.abs(truth).max())
        assert each.nominal_value == Pendulum(*start[:2], length=start[2], gravity=start[3]).motion(2.3)[of]


@pytest.mark.parametrize("start", STARTS)
def test_derivatives_of_the_period(start):
    given = [ufloat(value, 1e-3) for value in start]
    found = uncertain_period(*given[:2], length=given[2], gravity=given[3])
    truth = slopes(lambda a, v, length, g: Pendulum(a, v, length=length, gravity=g).period, list(start))
    got = np.array([found.derivatives[name] for name in given])
    assert got == pytest.approx(truth, rel=1e-6, abs=1e-6 * np.abs(truth).max())
    assert found.nominal_value == Pendulum(*start[:2], length=start[2], gravity=start[3]).period


def test_what_is_correlated_stays_so():
    angle = ufloat(1.0, 0.01)
    theta, velocity = uncertain_motion(0.0, angle)
    assert (theta - angle).std_dev == 0.0 and velocity.std_dev == 0.0
    period = uncertain_period(angle)
    # A quarter of a period later the pendulum is at the bottom, whatever the angle was.
    assert uncertain_motion(period / 4, angle)[0].std_dev < 1e-9
    assert abs(correlation_matrix([period, angle])[0, 1]) == pytest.approx(1.0)


def test_small_swings_by_hand():
    length, gravity = ufloat(1.0, 0.002), ufloat(9.81, 0.01)
    period = uncertain_period(1e-4, length=length, gravity=gravity)
    assert period.std_dev / period.nominal_value == pytest.approx(math.hypot(0.002, 0.01 / 9.81) / 2, rel=1e-7)
    assert uncertain_period(1e-4, omega0=ufloat(2.0, 0.1)).std_dev == pytest.approx(math.pi / 20, rel=1e-7)


def test_arrays_of_instants():
    times = np.linspace(0.0, 3.0, 4)
    theta, velocity = uncertain_motion(times, ufloat(1.0, 0.01))
    assert theta.shape == velocity.shape == (4,)
    assert [each.nominal_value for each in theta] == Pendulum(1.0).theta(times).tolist()
    assert theta[0].std_dev == pytest.approx(0.01)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: uncertain_period(0.0), "rest has no derivative of the period"),
        (lambda: uncertain_period(ufloat(0.0, 0.1), 2.0), "separatrix has no derivative"),
        (lambda: uncertain_motion(1.0, ufloat(math.nan, 1)), "theta0 = NaN"),
        (lambda: uncertain_motion(1.0, 1.0, length=ufloat(-1.0, 0.1)), "length = -1"),
    ],
)
def test_refusals(call, said):
    with pytest.raises(ValueError, match=said):
        call()
