"""Motions in JAX: values and derivatives in every stratum of the truth's inputs, transformations, and what is refused.

The truth is the core at the floats passed: of float64 to 8 ulp, of derivatives to 1e-12 of the largest change; and for second
derivatives the rows of reference/second.py.
"""

import math
import warnings

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from inputs import rows, second_derivatives

import libration
from libration.jax import advance, motion, period


class Truth:
    """What the core says of rows, and the sizes that errors are measured by."""

    def __init__(self, given):
        t, theta0, velocity0, omega0 = given.astype(float).T
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            orbits = [libration.Pendulum(*start, omega0=w) for *start, w in zip(theta0, velocity0, omega0, strict=True)]
        self.motion = np.array([orbit.motion(each) for orbit, each in zip(orbits, t, strict=True)])
        self.complement = np.array([orbit.energy_ratio_c for orbit in orbits])
        self.periods = np.abs(t) / np.array([orbit.period for orbit in orbits])
        ratio = np.array([orbit.energy_ratio for orbit in orbits])
        reach = np.nan_to_num(np.array([orbit.theta_max for orbit in orbits]))
        angle = np.maximum(np.maximum(np.abs(theta0), reach), np.abs(self.motion[:, 0]))
        speed = np.maximum(np.maximum(np.abs(velocity0), 2 * omega0 * np.sqrt(ratio)), np.abs(self.motion[:, 1]))
        self.scale = np.stack([angle, speed], -1)
        self.changes = np.stack([angle, speed, omega0], -1)

    def error(self, found):
        gap = np.abs(np.asarray(found, float).T - self.motion)
        return np.where(gap == 0, 0, gap / np.where(self.scale > 0, self.scale, 1)).max(-1)

    def regular(self, least, periods):
        return (np.abs(self.complement) >= least) & (self.periods <= periods)


@pytest.fixture(scope="module")
def truth():
    return {dtype: Truth(rows(dtype)) for dtype in (np.float64, np.float32)}


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("digits", ["full", "short"])
def test_values(digits, dtype, truth):
    given, truth = rows(dtype), truth[dtype]
    with jax.enable_x64(dtype == np.float64):
        found = motion(*given.T, digits=digits)
        spoiled = motion(given[:, 0] * dtype(1 + 40 * np.finfo(dtype).eps), *given.T[1:], digits=digits)
    assert found[0].dtype == dtype and len(given) > 1600
    if digits == "short":
        asked, bound = truth.regular(1e-4, 50), {np.float64: 1e-12, np.float32: 5e-5}[dtype]
    else:
        asked, bound = np.full(len(given), True), {np.float64: 1e-14, np.float32: 5e-7}[dtype]
    assert asked.sum() > 1000
    assert (truth.error(found) <= bound)[asked].all()
    bound = bound if digits == "full" else bound / 50
    assert not (truth.error(spoiled) <= bound)[asked].all(), "a wrong time must show"


@pytest.mark.parametrize("digits, least, periods", [("full", 1e-6, 1000), ("short", 1e-4, 50)])
def test_first_derivatives(digits, least, periods, truth):
    given, truth = rows(np.float64), truth[np.float64]
    asked = truth.regular(least, periods) & (np.abs(given).max(1) < 1e9) & (np.abs(given[:, 1:3]).max(1) > 1e-100)
    expected, changes = libration.sensitivities(*given.T), truth.changes[:, None]
    force = -(given[:, 3] ** 2) * np.sin(truth.motion[:, 0])
    by_time = np.stack([truth.motion[:, 1], force], -1)
    rate = truth.scale[:, 1:] * np.stack([np.ones(len(given)), given[:, 3]], -1)
    columns = jax.jit(jax.vmap(jax.jacfwd(lambda *each: jnp.stack(motion(*each, digits=digits)), argnums=(0, 1, 2, 3))))

    def gaps(given):
        found = np.stack(columns(*given.T), -1)
        return np.abs(found[..., 1:] - expected) * changes, np.abs(found[..., 0] - by_time)

    with jax.enable_x64(True):
        by_start, by_t = gaps(given)
        spoiled, _ = gaps(given * [1, 1, 1, 1 + 1e-9])
    bound = 1e-11 * np.abs(expected * changes).max(-1, keepdims=True)
    assert asked.sum() > 1000
    assert (by_start <= bound)[asked].all()
    # The sine of many turns has the error of the angle.
    assert (by_t <= 1e-11 * rate)[asked & (np.abs(truth.motion[:, 0]) < 100)].all()
    assert not (spoiled <= bound)[asked].all(), "derivatives elsewhere must show"


@pytest.mark.parametrize("digits", ["full", "core"])
def test_second_derivatives(digits):
    """Against reference/second.py; its stratum "nearest" has 1 - kappa^2 of some 1e-6, of both signs."""
    given, expected = second_derivatives()
    reach = np.maximum(np.abs(given[:, 1]), math.pi)
    changes = np.stack([reach, np.maximum(np.abs(given[:, 2]), 2 * given[:, 3]), given[:, 3]], -1)
    weights = changes[:, None, :, None] * changes[:, None, None, :]
    hessian = jax.jit(jax.vmap(jax.jacfwd(jax.jacrev(lambda start, t: jnp.stack(motion(t, *start, digits=digits))))))
    with jax.enable_x64(True):
        found, spoiled = (np.asarray(hessian(given[:, 1:] * factor, given[:, 0])) for factor in (1, 1 + 1e-9))
    largest = np.abs(expected * weights).max((2, 3), keepdims=True)
    near = np.abs(libration.energy_ratio_c(*given.T[1:])) < 1e-5
    assert len(given) == 180 and near.sum() == 20
    for part in (near, ~near):
        assert (np.abs(found - expected) * weights <= 1e-11 * largest)[part].all()
        assert not (np.abs(spoiled - expected) * weights <= 1e-11 * largest)[part].all()


def test_second_derivatives_next_to_the_separatrix():
    """At short times and late ones, where half periods move most; the truth are the core's closed forms, right to 1e-12."""
    rng = np.random.default_rng(1)
    theta0, omega0, side = rng.uniform(-3, 3, 200), rng.uniform(0.5, 2, 200), rng.choice([-1, 1], (2, 200))
    # At shorter times second derivatives are below 1e-3 themselves, and what is rounded is of the order of 1.
    t = rng.uniform(0.1, 1, 200) * rng.choice([-60, -20, -2, 2, 20, 60], 200)
    complement = np.minimum(10 ** rng.uniform(-5.999, -4, 200), 0.5 * np.cos(theta0 / 2) ** 2)
    velocity0 = 2 * omega0 * np.sqrt(np.cos(theta0 / 2) ** 2 - side[0] * complement) * side[1]
    given = np.stack([t, theta0, velocity0, omega0], -1)
    changes = np.stack([np.full(200, math.pi), 2 * omega0, omega0], -1)
    weights = changes[:, None, :, None] * changes[:, None, None, :]
    orbits = [libration.Pendulum(*start, omega0=w) for _, *start, w in given]
    expected = np.array([orbit.second_sensitivities(each) for orbit, each in zip(orbits, t, strict=True)])
    with jax.enable_x64(True):
        hessian = jax.jit(jax.vmap(jax.jacfwd(jax.jacrev(lambda start, t: jnp.stack(motion(t, *start))))))
        found = np.asarray(hessian(given[:, 1:], t))
    largest = np.abs(expected * weights).max((2, 3), keepdims=True)
    assert np.isfinite(expected).all() and (np.abs(found - expected) * weights <= 1e-11 * largest).all()


def test_at_the_separatrix_derivatives_have_no_kink():
    """There 1 - kappa^2 is 0 exactly, and min(m, 1) would halve the derivative."""
    t, omega0 = 1.5, 2.0
    with jax.enable_x64(True):
        found = jax.jacfwd(lambda *start: jnp.stack(motion(t, *start)), argnums=(0, 1, 2))(0.0, 4.0, omega0)
    expected = libration.sensitivities(t, 0.0, 4.0, omega0)
    assert np.abs(np.stack(found, -1) - expected).max() < 1e-11 * np.abs(expected).max()
    assert np.abs(np.stack(found, -1) / 2 - expected).max() > 0.1


def test_periods_and_their_derivatives():
    rng = np.random.default_rng(2)
    theta, velocity, omega0 = (rng.uniform(*ends, 300) for ends in ((-3, 3), (0.1, 4), (0.5, 2)))
    with jax.enable_x64(True):
        found, spoiled = (np.asarray(period(theta * factor, velocity, omega0)) for factor in (1, 1 + 1e-12))
        by = np.asarray(jax.jit(jax.vmap(jax.grad(period, argnums=(0, 1, 2))))(theta, velocity, omega0))
    expected = libration.period(theta, velocity, omega0)
    assert np.abs(found / expected - 1).max() < 1e-14 < np.abs(spoiled / expected - 1).max()
    # After a period the state is the same: what the start changes beyond that, the period has changed.
    slopes = libration.sensitivities(expected, theta, velocity, omega0)[:, 0]
    regular = np.abs(libration.energy_ratio_c(theta, velocity, omega0)) > 1e-2
    for place, start in enumerate((1.0, 0.0, 0.0)):
        wanted = (start - slopes[:, place]) / velocity
        assert np.abs(by[place] - wanted)[regular].max() < 1e-9 * np.abs(wanted[regular]).max()


def test_a_value_with_its_gradient_and_a_scan():
    start = (1.0, 0.3, 1.2)
    last = jax.jit(jax.value_and_grad(lambda *start: motion(2.0, *start, digits="short")[0], argnums=(0, 1, 2)))
    value, slope = last(*start)
    assert abs(value - libration.theta(2.0, *start)) < 1e-6
    assert np.abs(np.array(slope) - libration.sensitivities(2.0, *start)[0]).max() < 1e-5

    def step(state, _):
        return advance(*state, 0.2, 1.2, digits="short"), state[0]

    final, passed = jax.lax.scan(step, (jnp.float32(1.0), jnp.float32(0.3)), length=10)
    assert abs(final[0] - value) < 1e-5 and passed.shape == (10,)


def test_bad_elements_are_nan_and_nothing_else_is():
    inf, nan = math.inf, math.nan
    given = np.array([[1, 1, 0, 1], [inf, 1, 0, 1], [1, inf, 0, 1], [1, 1, nan, 1], [1, 1, 0, 0], [1, 1, 1e30, 1]], "f")
    assert np.isfinite(motion(*given.T, digits="short")).tolist() == [[True] + [False] * 5] * 2


def test_bad_arguments_are_one_line():
    with pytest.raises(
        TypeError, match=r"^t is float64, but JAX computes in float32: pass float32, or call jax.config"
    ):
        motion(np.ones(3), 1.0)
    with pytest.raises(TypeError, match=r"^velocity must be real, not complex"):
        advance(1.0, 2j, 0.5)
    with pytest.raises(ValueError, match=r"^digits must be 'full', 'short' or 'core', not 'all'$"):
        period(1.0, digits="all")
