"""The core's `rk45` is SciPy's `solve_ivp` as it comes, step by step; the other schemes between their steps."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from libration import Pendulum, _core, approx

CASES = [
    (Pendulum(3.0, length=1.0, gravity=9.8), 10.0),
    (Pendulum(0.4), 100.0),
    (Pendulum(2.0, 0.3, omega0=2.0), 30.0),
    (Pendulum(0.0, 3.0), 20.0),
    (Pendulum(1.0, -2.5, omega2=4.0), 15.0),
    (Pendulum(1e-7, 0.0), 8.0),
    (Pendulum(0.0, 0.0), 3.0),
    (Pendulum(2.5, 0.1, omega2=-1.0), 12.0),
]


def scipy(pendulum: Pendulum, until: float, **options):
    def slopes(_t, state):
        return state[1], -pendulum.omega2 * math.sin(state[0])

    return solve_ivp(slopes, (0.0, until), (pendulum.theta0, pendulum.velocity0), **options)


def ours(pendulum: Pendulum, until: float, scheme: str = "rk45", step: float | None = None):
    return _core.NumericalSolution(scheme, step, pendulum._orbit, until)


@pytest.mark.parametrize(("pendulum", "until"), CASES)
def test_every_step_of_scipy(pendulum, until):
    # The estimate of the error is a difference: what sums in another order lose of it moves the steps, and an unstable
    # motion with them.
    growth = 1e2 if abs(pendulum.theta0) > 2.9 else 1.0
    expected = scipy(pendulum, until)
    t, theta, velocity = ours(pendulum, until).steps()
    assert t.size == expected.t.size
    assert np.abs(t - expected.t).max() <= 1e-9 * growth * until
    assert np.abs(theta - expected.y[0]).max() <= 1e-9 * growth * max(1.0, np.abs(expected.y[0]).max())
    assert np.abs(velocity - expected.y[1]).max() <= 1e-9 * growth * max(1.0, np.abs(expected.y[1]).max())


@pytest.mark.parametrize(("pendulum", "until"), CASES)
def test_the_interpolant_of_scipy(pendulum, until):
    growth = 1e2 if abs(pendulum.theta0) > 2.9 else 1.0
    t = np.linspace(0.0, until, 1201)
    expected = scipy(pendulum, until, t_eval=t).y[0]
    got = approx.numerical("rk45").of(pendulum).theta(t)
    assert np.abs(got - expected).max() <= 1e-9 * growth * max(1.0, np.abs(expected).max())


def test_another_tolerance_is_another_solution():
    pendulum, until = CASES[2]
    expected = scipy(pendulum, until, rtol=1e-4)
    assert ours(pendulum, until).steps()[0].size != expected.t.size


def test_horsley_goes_over_the_top_and_the_exact_motion_does_not():
    pendulum, until = CASES[0]
    over = ours(pendulum, until).over_the_top
    assert f"{over:.2f}" == "9.47"
    # Between the instants of SciPy's own answer where it passes pi.
    t = np.linspace(0.0, until, 100_001)
    theirs = t[np.argmax(np.abs(scipy(pendulum, until, t_eval=t).y[0]) > math.pi)]
    assert 0 <= theirs - over <= 1e-4
    assert np.abs(pendulum.theta(t)).max() <= 3.0
    assert math.isnan(ours(pendulum, until, "rk4", 0.025).over_the_top)


def test_rk45_by_name_takes_no_step():
    assert approx.numerical("rk45").of(Pendulum(3.0, length=1.0, gravity=9.8)).over_the_top(2) > 9.4
    with pytest.raises(ValueError, match="must be rk45 without a step"):
        approx.numerical("rk45:0.1")
    assert "rk45" in approx.numerical.names
