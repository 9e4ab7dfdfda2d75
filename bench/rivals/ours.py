"""libration, by its public surface: outputs preallocated, the orbit kept or built anew in every call."""

import numpy as np

import libration

from .method import Call, Method


def theta(orbit, t) -> Call:
    """The angle, of an orbit that is kept."""
    pendulum, out = libration.Pendulum(orbit.theta0, orbit.velocity0), np.empty_like(t)
    return lambda: (pendulum.theta(t, out=out),)


def fresh(orbit, t) -> Call:
    """The angle, of an orbit set up in every call."""
    theta0, velocity0, out = orbit.theta0, orbit.velocity0, np.empty_like(t)
    return lambda: (libration.Pendulum(theta0, velocity0).theta(t, out=out),)


def allocating(orbit, t) -> Call:
    """The angle in a new array every time."""
    pendulum = libration.Pendulum(orbit.theta0, orbit.velocity0)
    return lambda: (pendulum.theta(t),)


def motion(orbit, t) -> Call:
    """Angle and velocity; the function is the one with `out=`."""
    theta0, velocity0, out = orbit.theta0, orbit.velocity0, (np.empty_like(t), np.empty_like(t))
    return lambda: libration.motion(t, theta0, velocity0, out=out)


def states(theta0, velocity0, t) -> Call:
    """Angle and velocity of states of their own."""
    out = np.empty_like(t), np.empty_like(t)
    return lambda: libration.motion(t, theta0, velocity0, out=out)


def advance(theta, velocity, dt) -> Call:
    """The states themselves move on, in place."""
    return lambda: libration.advance(theta, velocity, dt, out=(theta, velocity))


THETA = Method("libration: θ", orbit=theta)
FRESH = Method("libration: θ, orbit set up in the call", orbit=fresh)
ALLOCATING = Method("libration: θ, new array", orbit=allocating)
MOTION = Method("libration: θ and θ̇", orbit=motion, states=states, advance=advance)
