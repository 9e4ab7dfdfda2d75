"""Data for a network that learns a motion: exact ones, and what the usual integrators make of them.

A network that keeps energy or area by its construction cannot be better than its data. Swings from rest are computed by the solver of the
usual data set (RK45 of SciPy at rtol=1e-10, whose atol=1e-6 is left as it is), by Runge and Kutta's fourth order and by leapfrog, each
with steps of 0.05, and by `ensemble.sweep`. The truth is theta = 2 asin(k sn(K + t)), k = sin(theta0/2), by mpmath with 40 digits.

Run: python examples/training.py; docs/ensembles-examples.md shows the picture. training.toml makes such data in a store.
Source: Greydanus, Dzamba & Yosinski, Hamiltonian Neural Networks, NeurIPS (2019); DLMF 22.19.2.
"""

import mpmath
import numpy as np
from scipy.integrate import solve_ivp

from libration import ensemble

# Of the picture, in inches.
SIZE = (11.5, 4.8)
STEP = 0.05


def starts(n):
    """Angles at rest, from small swings to nearly upright."""
    return np.linspace(0.2, 3.0, n)


def truth(theta0, t):
    """Angles at times, of swings from rest: a row a swing."""

    def angle(start, time):
        k = mpmath.sin(mpmath.mpf(start) / 2)
        return float(2 * mpmath.asin(k * mpmath.ellipfun("sn", mpmath.ellipk(k**2) + mpmath.mpf(time), k=k)))

    with mpmath.workdps(40):
        return np.array([[angle(float(start), float(time)) for time in t] for start in theta0])


def exact(theta0, t):
    """`ensemble.sweep`, a data set with names and units."""
    return ensemble.sweep(theta0=theta0, t=t).theta.values


def solver(theta0, t):
    """The solver of the usual data set."""

    def slope(_, state):
        return state[1], -np.sin(state[0])

    return np.array([solve_ivp(slope, (0, t[-1]), (each, 0.0), t_eval=t, rtol=1e-10).y[0] for each in theta0])


def by_steps(one_step):
    """Steps of STEP to times that are multiples of it."""

    def angles(theta0, t):
        theta, velocity, found, done = theta0.copy(), np.zeros_like(theta0), [], 0
        for marked in np.rint(t / STEP).astype(int):
            for _ in range(marked - done):
                theta, velocity = one_step(theta, velocity)
            found.append(theta)
            done = marked
        return np.array(found).T

    return angles


@by_steps
def leapfrog(theta, velocity):
    """Half a kick, a drift, half a kick."""
    middle = velocity - STEP / 2 * np.sin(theta)
    theta = theta + STEP * middle
    return theta, middle - STEP / 2 * np.sin(theta)


@by_steps
def fourth_order(theta, velocity):
    """Runge and Kutta's classical step."""
    slopes = np.zeros((2, theta.size))
    mean = slopes
    for part, weight in ((0, 1), (0.5, 2), (0.5, 2), (1, 1)):
        slopes = np.array([velocity + part * STEP * slopes[1], -np.sin(theta + part * STEP * slopes[0])])
        mean = mean + weight / 6 * slopes
    return theta + STEP * mean[0], velocity + STEP * mean[1]


WAYS = {
    "leapfrog": (leapfrog, "#c44601"),
    "Runge–Kutta, order 4": (fourth_order, "#946c00"),
    "RK45, rtol=1e-10": (solver, "#a8447c"),
    "libration": (exact, "#0072b2"),
}


def draw(figure, n=25, times=31):
    """The largest error of each way over time, and over the start."""
    over_time, over_start = figure.subplots(1, 2, sharey=True)
    theta0, t = starts(n), 2.0 * np.arange(1, times)
    true = truth(theta0, t)
    for name, (angles, color) in WAYS.items():
        # Of errors of 0, which have no logarithm, half a last digit is drawn.
        error = np.maximum(abs(angles(theta0, t) - true), 2.0**-54)
        over_time.semilogy(t, error.max(axis=0), "-o", ms=3, color=color, label=name)
        over_start.semilogy(np.degrees(theta0), error.max(axis=1), "-o", ms=3, color=color)
    over_time.set(xlim=(0, None), xlabel="t in units of 1/ω₀", ylabel="largest error of the angle in rad")
    over_time.set_title(f"Of {n} swings", loc="left", fontsize=11)
    over_start.set(xlim=(0, 180), xticks=range(0, 181, 45), xlabel="swing from rest at, in degrees")
    over_start.set_title(f"Up to t = {t[-1]:g}", loc="left", fontsize=11)
    figure.legend(loc="outside lower center", ncols=len(WAYS), frameon=False, fontsize=10)


if __name__ == "__main__":
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    draw(figure)
    figure.savefig("training.png")
