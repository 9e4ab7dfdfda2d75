"""SciPy's least squares, begun where a fit has ended, finds nothing better; and the derivatives are those of the motion.

The residuals are those of the public `DampedPendulum`, the derivatives of SciPy's search finite differences: of the fit's own search
nothing is used but where it ended.
"""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.optimize._numdiff import approx_derivative

from libration import DampedPendulum, Fit, Friction, fit

OMEGA2 = 9.81 / 0.8
TERMS = ("linear", "quadratic", "dry", "presliding")
MODELS = {
    "none": {},
    "linear": {"linear": 0.02},
    "quadratic": {"linear": 0.01, "quadratic": 0.02},
    "dry": {"linear": 0.02, "quadratic": 0.03, "dry": 0.1},
    "presliding": {"linear": 0.02, "quadratic": 0.03, "dry": 0.3, "presliding": 0.05},
}
KINDS = [(model, "angle") for model in MODELS] + [("linear", "velocity"), ("dry", "velocity")]
T = np.linspace(0.0, 20.0, 600)


def record(model, quantity="angle", seed=5):
    motion = DampedPendulum(1.2, omega2=OMEGA2, friction=Friction(**MODELS[model]))
    exact = motion.theta(T) if quantity == "angle" else motion.velocity(T)
    return exact + 0.03 + np.random.default_rng(seed).normal(0.0, 0.002, T.size)


def shown(found: Fit, quantity: str):
    """What a record would show, as a function of theta, velocity, omega2, the friction terms and the rest."""
    times = found.t - found.state_time

    def curve(values):
        theta, velocity, omega2, *terms, rest = values
        friction = Friction(**dict(zip(TERMS, terms, strict=False)))
        motion = DampedPendulum(theta, velocity, omega2=omega2, friction=friction)
        return rest + (motion.theta(times) if quantity == "angle" else motion.velocity(times))

    motion = found.motion()
    friction = [each.value for each in found.friction.values()]
    return curve, np.array([motion.theta0, motion.velocity0, motion.omega0**2, *friction, found.offset.value])


def search(found, quantity, begin):
    curve, _ = shown(found, quantity)
    tight = {"ftol": 1e-15, "xtol": 1e-15, "gtol": 1e-15}
    return least_squares(lambda values: curve(values) - found.measured, begin, "3-point", x_scale="jac", **tight)


@pytest.mark.parametrize(("model", "quantity"), KINDS)
def test_scipy_finds_nothing_better(model, quantity):
    found = fit(T, record(model, quantity), model=model, quantity=quantity)
    curve, values = shown(found, quantity)
    assert list(found.friction) == list(MODELS[model]) and all(each.value > 0 for each in found.friction.values())
    cost = 0.5 * np.sum((curve(values) - found.measured) ** 2)
    assert cost == pytest.approx(0.5 * np.sum(found.residuals**2), rel=1e-9)
    best = search(found, quantity, values)
    assert best.cost > (1 - 1e-8) * cost
    # The spoiled sibling: from a place beside the minimum it does find something better.
    spoiled = values.copy()
    spoiled[2] += 0.1 * 2 * found.omega0.value * found.omega0.u
    beside = 0.5 * np.sum((curve(spoiled) - found.measured) ** 2)
    assert search(found, quantity, spoiled).cost < (1 - 1e-6) * beside


def test_a_term_at_its_bound_would_make_the_fit_worse():
    held = None
    for seed in range(6):
        y = DampedPendulum(1.2, omega2=OMEGA2, friction=Friction(quadratic=0.02)).theta(T)
        y = y + np.random.default_rng(seed).normal(0.0, 0.002, T.size)
        found = fit(T, y, model="quadratic")
        if found.friction["linear"].value > 0:
            continue
        held = found
        curve, values = shown(found, "angle")
        upward = values.copy()
        upward[3] = 1e-6
        slope = np.sum((curve(upward) - found.measured) ** 2) - np.sum((curve(values) - found.measured) ** 2)
        assert slope > 0
        free = np.delete(np.arange(values.size), 3)

        def others(some, values=values, free=free, curve=curve, measured=found.measured):
            every = values.copy()
            every[free] = some
            return curve(every) - measured

        cost = 0.5 * np.sum(others(values[free]) ** 2)
        assert least_squares(others, values[free], "3-point", x_scale="jac", xtol=1e-15).cost > (1 - 1e-8) * cost
        # It is as uncertain as if it were free, and so is what depends on it.
        assert found.friction["linear"].u > 0
    assert held is not None


@pytest.mark.parametrize("model", MODELS)
def test_derivatives_are_those_of_the_motion(model):
    found = fit(T, record(model), model=model)
    curve, values = shown(found, "angle")
    motion = found.motion()
    exact = motion.sensitivities(found.t - found.state_time)[:, 0, : 3 + len(MODELS[model])]
    step = np.maximum(np.abs(values), 0.01)
    near = approx_derivative(curve, values, method="3-point", abs_step=3e-5 * step)[:, :-1]
    size = np.abs(exact).max(axis=0)
    assert (np.abs(exact - near).max(axis=0) / size).max() < 1e-6
    assert (np.abs(1.0001 * exact - near).max(axis=0) / size).max() > 5e-5
