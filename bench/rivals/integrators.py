"""Rivals that integrate: SciPy's DOP853 and LSODA (odeint), and heyoka's Taylor integrator, at a tolerance each.

The right-hand side uses math.sin, which is what makes the first two fastest; heyoka compiles it. What heyoka compiles
is kept from call to call and not counted.
"""

import functools
import math
import warnings

import numpy as np
from scipy.integrate import odeint, solve_ivp

from .method import Call, Method, NotAvailable, Refused

BATCH = 32
DENSE_SPAN = 2e4  # time units: beyond this a kept dense output needs gigabytes


def rate(t, state):
    """The pendulum's equation with omega0 = 1."""
    return state[1], -math.sin(state[0])


def sorted_span(t) -> float:
    """The last of the times, which must rise."""
    if np.any(np.diff(t) < 0):
        raise Refused("times must rise")
    return float(t[-1])


def dop853_call(right, start, t, tolerance: float) -> Call:
    """theta and velocity by solve_ivp with DOP853, of an equation from a start."""

    def call():
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = solve_ivp(right, (0.0, t[-1]), start, "DOP853", t, rtol=tolerance, atol=tolerance)
        if found.status:
            raise Refused(found.message)
        return found.y[0], found.y[1]

    return call


def lsoda_call(right, start, t, tolerance: float) -> Call:
    """The same by odeint."""
    times = t if t[0] == 0 else np.concatenate([[0.0], t])

    def call():
        found = odeint(right, start, times, tfirst=True, rtol=tolerance, atol=tolerance, mxstep=10**9)
        found = found[len(times) - len(t) :]
        return found[:, 0], found[:, 1]

    return call


def dop853(tolerance: float):
    """Preparation of solve_ivp with DOP853."""

    def prepare(orbit, t) -> Call:
        sorted_span(t)
        return dop853_call(rate, [orbit.theta0, orbit.velocity0], t, tolerance)

    return prepare


def lsoda(tolerance: float):
    """Preparation of odeint."""

    def prepare(orbit, t) -> Call:
        sorted_span(t)
        return lsoda_call(rate, [orbit.theta0, orbit.velocity0], t, tolerance)

    return prepare


@functools.cache
def equations():
    """heyoka and the pendulum's equation in its terms."""
    try:
        import heyoka
    except ImportError as error:
        raise NotAvailable("heyoka") from error
    theta, velocity = heyoka.make_vars("theta", "velocity")
    return heyoka, [(theta, velocity), (velocity, -heyoka.sin(theta))]


@functools.cache
def taylor(tolerance: float):
    """A compiled single integrator."""
    heyoka, system = equations()
    return heyoka.taylor_adaptive(system, [0.0, 0.0], tol=tolerance)


@functools.cache
def taylor_batch(tolerance: float):
    """A compiled integrator of BATCH states at a time."""
    heyoka, system = equations()
    return heyoka.taylor_adaptive_batch(system, np.zeros((2, BATCH)), tol=tolerance)


def dense(tolerance: float):
    """Preparation of heyoka's fastest method for many samples of one orbit: one propagation, then its dense output."""

    def prepare(orbit, t) -> Call:
        span, integrator = float(np.max(t)), taylor(tolerance)
        if span > DENSE_SPAN:
            raise Refused("dense output too long")

        def call():
            integrator.time = 0.0
            integrator.state[:] = orbit.theta0, orbit.velocity0
            found = integrator.propagate_until(span, c_output=True)[4](t)
            return found[:, 0], found[:, 1]

        return call

    return prepare


def grid(tolerance: float):
    """Preparation of heyoka's propagate_grid."""

    def prepare(orbit, t) -> Call:
        sorted_span(t)
        integrator = taylor(tolerance)
        times = t if t[0] == 0 else np.concatenate([[0.0], t])

        def call():
            integrator.time = 0.0
            integrator.state[:] = orbit.theta0, orbit.velocity0
            found = integrator.propagate_grid(times)[5][len(times) - len(t) :]
            return found[:, 0], found[:, 1]

        return call

    return prepare


def batch(tolerance: float):
    """Preparation of states of their own, BATCH at a time."""

    def prepare(theta0, velocity0, t) -> Call:
        integrator = taylor_batch(tolerance)
        times = np.broadcast_to(t, np.shape(theta0))
        theta, velocity = np.empty(len(theta0)), np.empty(len(theta0))
        state = integrator.state

        def call():
            for first in range(0, len(theta0), BATCH):
                part = slice(first, first + BATCH)
                lanes = len(theta0[part])
                integrator.set_time(0.0)
                state[:] = 0.0
                state[0, :lanes], state[1, :lanes] = theta0[part], velocity0[part]
                until = np.zeros(BATCH)
                until[:lanes] = times[part]
                integrator.propagate_until(until)
                theta[part], velocity[part] = state[:, :lanes]
            return theta, velocity

        return call

    return prepare


def one_by_one(prepare_orbit):
    """States of their own by an integrator that knows only one orbit."""

    def prepare(theta0, velocity0, t) -> Call:
        class State:
            """What the preparation of one orbit reads."""

        def call():
            found = np.empty((2, len(theta0)))
            for index, state in enumerate(zip(theta0, velocity0, t, strict=True)):
                orbit = State()
                orbit.theta0, orbit.velocity0 = float(state[0]), float(state[1])
                found[:, index] = [output[0] for output in prepare_orbit(orbit, np.array([state[2]]))()]
            return tuple(found)

        return call

    return prepare


def at_tolerance(name: str, prepare, tolerance: float) -> Method:
    """An integrator at a tolerance, for one orbit and, state after state, for many."""
    prepared = prepare(tolerance)
    return Method(f"{name}, tol {tolerance:.0e}", prepared, one_by_one(prepared), any_order=False)


HEYOKA_DENSE = Method("heyoka, dense output, tol 1e-15", orbit=dense(1e-15))
HEYOKA_GRID = Method("heyoka, propagate_grid, tol 1e-15", orbit=grid(1e-15), any_order=False)
HEYOKA_BATCH = Method(f"heyoka, batch of {BATCH}, tol 1e-15", states=batch(1e-15), advance=batch(1e-15))
