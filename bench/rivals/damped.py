"""The damped motion by libration, heyoka and SciPy: a preparation gives a call that answers theta and velocity at the times.

heyoka is compiled once for each friction, which is not counted. |v| v and sgn v are analytic only where v keeps its sign. So its
integrator stops at v = 0 by an event whose callback changes a sign; with linear friction it has no event. SciPy's right-hand side uses
math.sin, which is what makes it fastest, and takes the sign of v where it stands. LSODA is SciPy's odeint.
"""

import functools
import math

import numpy as np

import libration

from .integrators import dop853_call, lsoda_call
from .method import Call, NotAvailable


def ours(case, t) -> Call:
    """`DampedPendulum.motion`, from the arguments on."""
    friction = libration.Friction(linear=case.linear, quadratic=case.quadratic, dry=case.dry)

    def call():
        return libration.DampedPendulum(case.theta0, omega0=1.0, friction=friction).motion(t)

    return call


def with_derivatives(case, t) -> Call:
    """The same with the derivatives by the start and every constant."""
    friction = libration.Friction(linear=case.linear, quadratic=case.quadratic, dry=case.dry)

    def call():
        pendulum = libration.DampedPendulum(case.theta0, omega0=1.0, friction=friction)
        pendulum.sensitivities(t)
        return pendulum.motion(t)

    return call


@functools.cache
def compiled(linear: float, quadratic: float, dry: float):
    """heyoka's integrator of one friction; par[0] is the sign of the velocity."""
    try:
        import heyoka
    except ImportError as error:
        raise NotAvailable("heyoka") from error
    theta, velocity = heyoka.make_vars("theta", "velocity")
    side = heyoka.par[0]
    force = -heyoka.sin(theta) - 2 * linear * velocity
    if quadratic:
        force -= quadratic * side * velocity * velocity
    if dry:
        force -= dry * side
    events = []
    if quadratic or dry:

        def turned(integrator, direction):
            # The sign of the acceleration is that of the velocity from here on.
            integrator.pars[0] = direction
            return True

        events = [heyoka.t_event(velocity, callback=turned)]
    return heyoka.taylor_adaptive([(theta, velocity), (velocity, force)], [0.0, 0.0], tol=1e-15, t_events=events)


def heyoka_taylor(case, t) -> Call:
    """heyoka's propagate_grid at tolerance 1e-15."""
    integrator = compiled(case.linear, case.quadratic, case.dry)
    times = np.concatenate([[0.0], t])

    def call():
        integrator.reset_cooldowns() if integrator.with_events else None
        integrator.time = 0.0
        integrator.state[:] = case.theta0, 0.0
        if integrator.with_events:
            integrator.pars[0] = -1.0
        found = integrator.propagate_grid(times)[-1][1:]
        return found[:, 0], found[:, 1]

    return call


def rate(case):
    """The right-hand side."""
    linear, quadratic, dry, sin = 2 * case.linear, case.quadratic, case.dry, math.sin

    def rate(t, state):
        theta, velocity = state
        force = -sin(theta) - (linear + quadratic * abs(velocity)) * velocity
        return velocity, force - math.copysign(dry, velocity) if velocity else force

    return rate


def dop853(tolerance: float):
    """Preparation of solve_ivp with DOP853."""
    return lambda case, t: dop853_call(rate(case), [case.theta0, 0.0], t, tolerance)


def lsoda(tolerance: float):
    """Preparation of odeint."""
    return lambda case, t: lsoda_call(rate(case), [case.theta0, 0.0], t, tolerance)


OURS = "libration"
DERIVATIVES = "libration, with 22 derivatives"
HEYOKA = "heyoka, tol 1e-15"
TIGHT = "DOP853, tol 3e-14"
METHODS = {
    OURS: ours,
    DERIVATIVES: with_derivatives,
    HEYOKA: heyoka_taylor,
    TIGHT: dop853(3e-14),
    "DOP853, tol 1e-10": dop853(1e-10),
    "LSODA, tol 1e-13": lsoda(1e-13),
}
