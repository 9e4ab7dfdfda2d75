"""Rivals in Python that evaluate a formula: the linear one, the SciPy recipe, elliptic-functions and mpmath.

The recipe is m = sin(theta0/2)^2 + (velocity0/2)^2, ellipkinc for the starting phase, ellipj for the motion and the
angle from 2 atan2(k sn, dn), in rotation from 2 am; with 2 asin(k sn) in its place it is no faster and loses digits.
"""

import math

import numpy as np
from scipy.special import ellipj, ellipkinc

from .method import Call, Method, NotAvailable


def linear(orbit, t) -> Call:
    """theta0 cos(omega0 t) with its three operations in a preallocated output."""
    theta0, omega0, out = orbit.theta0, 1.0, np.empty_like(t)

    def call():
        np.multiply(omega0, t, out=out)
        np.cos(out, out=out)
        return (np.multiply(theta0, out, out=out),)

    return call


def linear_as_written(orbit, t) -> Call:
    """theta0 cos(omega0 t) as one writes it."""
    theta0, omega0 = orbit.theta0, 1.0
    return lambda: (theta0 * np.cos(omega0 * t),)


def start(theta0: float, velocity0: float) -> tuple[float, float, float]:
    """kappa, and sine and cosine of the starting amplitude times kappa."""
    s, half = math.sin(theta0 / 2), velocity0 / 2
    return math.hypot(s, half), s, half


def recipe(orbit, t, jacobi, first_kind, with_velocity: bool) -> tuple:
    """Angle (and velocity) of one orbit by a library's Jacobi functions of the parameter."""
    k, s, half = start(orbit.theta0, orbit.velocity0)
    if k <= 1:
        m = k * k
        u = first_kind(math.atan2(s, half), m) + t
        sn, cn, dn, _ = jacobi(u, m)
        theta = 2 * np.arctan2(k * sn, dn)
        return (theta, 2 * k * cn) if with_velocity else (theta,)
    sign, m = math.copysign(1.0, orbit.velocity0), 1 / (k * k)
    _, _, dn, am = jacobi(sign * first_kind(orbit.theta0 / 2, m) + k * t, m)
    return (2 * sign * am, 2 * sign * k * dn) if with_velocity else (2 * sign * am,)


def recipe_of_states(theta0, velocity0, t, jacobi, first_kind) -> tuple:
    """Angle and velocity of states of their own; the two regimes by masks."""
    theta, velocity = np.empty_like(t), np.empty_like(t)
    turns = 2 * np.pi * np.round(theta0 / (2 * np.pi))
    s, half = np.sin((theta0 - turns) / 2), velocity0 / 2
    k = np.hypot(s, half)
    swings = k <= 1
    k_in, m = k[swings], k[swings] ** 2
    u = first_kind(np.arctan2(s[swings], half[swings]), m) + t[swings]
    sn, cn, dn, _ = jacobi(u, m)
    theta[swings], velocity[swings] = 2 * np.arctan2(k_in * sn, dn), 2 * k_in * cn
    k_out, sign = k[~swings], np.sign(velocity0[~swings])
    m = 1 / k_out**2
    u = sign * first_kind((theta0 - turns)[~swings] / 2, m) + k_out * t[~swings]
    _, _, dn, am = jacobi(u, m)
    theta[~swings], velocity[~swings] = 2 * sign * am, 2 * sign * k_out * dn
    return theta + turns, velocity


def elliptic_functions():
    """The Jacobi functions and the first integral of the package elliptic-functions."""
    try:
        import elliptic
    except ImportError as error:
        raise NotAvailable("elliptic-functions") from error
    return elliptic.ellipj, lambda phi, m: elliptic.elliptic12(phi, m)[0]


def by_mpmath(orbit, t, digits: int = 15) -> Call:
    """One sample at a time, at a working precision of `digits`."""
    try:
        import mpmath
    except ImportError as error:
        raise NotAvailable("mpmath") from error

    def call():
        theta = np.empty_like(t)
        with mpmath.workdps(digits):
            s, half = mpmath.sin(mpmath.mpf(orbit.theta0) / 2), mpmath.mpf(orbit.velocity0) / 2
            k = mpmath.hypot(s, half)
            if k <= 1:
                u0 = mpmath.ellipf(mpmath.atan2(s, half), k * k)
                for index, instant in enumerate(t.tolist()):
                    sn, dn = (mpmath.ellipfun(name, u0 + instant, m=k * k) for name in ("sn", "dn"))
                    theta[index] = 2 * mpmath.atan2(k * sn, dn)
                return (theta,)
            m, sign = 1 / k**2, math.copysign(1.0, orbit.velocity0)
            u0, K = sign * mpmath.ellipf(mpmath.mpf(orbit.theta0) / 2, m), mpmath.ellipk(m)
            for index, instant in enumerate(t.tolist()):
                u = u0 + k * instant
                sn, cn = (mpmath.ellipfun(name, u, m=m) for name in ("sn", "cn"))
                am = mpmath.atan2(sn, cn)
                am += 2 * mpmath.pi * mpmath.nint((mpmath.pi * u / (2 * K) - am) / (2 * mpmath.pi))
                theta[index] = 2 * sign * am
        return (theta,)

    return call


def orbit_recipe(library, with_velocity: bool):
    """Preparation of one orbit by a library's functions."""

    def prepare(orbit, t) -> Call:
        functions = library()
        return lambda: recipe(orbit, t, *functions, with_velocity)

    return prepare


def states_recipe(library):
    """Preparation of states of their own by a library's functions."""

    def prepare(theta0, velocity0, t) -> Call:
        functions = library()
        times = np.broadcast_to(t, np.shape(theta0))
        return lambda: recipe_of_states(theta0, velocity0, times, *functions)

    return prepare


def by_scipy():
    """The Jacobi functions and the first integral of SciPy."""
    return ellipj, ellipkinc


def sine_and_cosine(theta, velocity, dt) -> Call:
    """np.sin(a) + np.cos(a), a measure of cost for `advance`; it is no motion."""
    return lambda: (np.sin(theta) + np.cos(theta),)


LINEAR = Method("θ₀ cos ω₀t, NumPy with out=", orbit=linear)
LINEAR_AS_WRITTEN = Method("θ₀ cos ω₀t, NumPy as written", orbit=linear_as_written)
SINE_COSINE = Method("np.sin(a) + np.cos(a)", advance=sine_and_cosine)
SCIPY = Method("SciPy recipe: θ", orbit=orbit_recipe(by_scipy, False))
SCIPY_MOTION = Method(
    "SciPy recipe: θ and θ̇",
    orbit=orbit_recipe(by_scipy, True),
    states=states_recipe(by_scipy),
    advance=states_recipe(by_scipy),
)
ELLIPTIC_FUNCTIONS = Method(
    "elliptic-functions",
    orbit=orbit_recipe(elliptic_functions, True),
    states=states_recipe(elliptic_functions),
    advance=states_recipe(elliptic_functions),
)
MPMATH = Method("mpmath, 15 digits: θ", orbit=by_mpmath)
