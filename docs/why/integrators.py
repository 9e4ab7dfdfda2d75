"""Draws docs/why/integrators.png, errors and energies of numerical solutions over time, and docs/why/orders.png, errors over steps.

Run by docs/pictures.py. The exact motion is the core's; the solutions are those of `libration.approx.numerical`.
"""

import numpy as np
from scipy.integrate import odeint, solve_ivp

from libration import Pendulum, approx
from libration.plot._style import BLACK, DASHED, DOTTED, EXACT, FAINT, GREEN, OCHRE, PURPLE, SEPARATRIX, quiet

HORSLEY = Pendulum(3.0, length=1.0, gravity=9.8)
PERIODS, STEP = 100.0, 0.01
# Each with a colour and dashes.
OVER_TIME = {
    "solve_ivp": (SEPARATRIX, "-"),
    f"euler-cromer:{STEP}": (OCHRE, DOTTED),
    f"verlet:{STEP}": (GREEN, DASHED),
    f"rk4:{STEP}": (PURPLE, "-"),
    "odeint": (EXACT, DASHED),
}
OVER_STEP = {
    "euler": (SEPARATRIX, "-", 1),
    "euler-cromer": (OCHRE, DOTTED, 1),
    "verlet": (GREEN, DASHED, 2),
    "rk4": (PURPLE, "-", 4),
}


def motion(name, t):
    """Angle and velocity of a numerical solution of Horsley's pendulum."""
    start, omega2 = [HORSLEY.theta0, 0.0], HORSLEY.omega0**2
    if name == "solve_ivp":
        return solve_ivp(lambda _, y: [y[1], -omega2 * np.sin(y[0])], (0.0, t[-1]), start, t_eval=t).y
    if name == "odeint":
        return odeint(lambda y, _: [y[1], -omega2 * np.sin(y[0])], start, np.insert(t, 0, 0.0))[1:].T
    # At a step the slope of the interpolating cubics is the velocity, and t holds the times of steps alone.
    solution, short = approx.numerical(name).of(HORSLEY), 1e-5
    return solution.theta(t), (solution.theta(t + short) - solution.theta(t - short)) / (2 * short)


def draw_over_time(figure):
    """The largest error and the largest error of the energy until each time, for Horsley's pendulum."""
    left, right = figure.subplots(1, 2)
    t = np.arange(1, round(PERIODS * HORSLEY.period / STEP)) * STEP
    exact, omega2 = HORSLEY.theta(t), HORSLEY.omega0**2
    for name, (color, dashes) in OVER_TIME.items():
        theta, velocity = motion(name, t)
        energy = velocity**2 / 2 + 2 * omega2 * np.sin(theta / 2) ** 2
        look = {"color": color, "ls": dashes, "lw": 1.7, "label": name}
        left.loglog(t / HORSLEY.period, np.maximum.accumulate(np.abs(theta - exact)), **look)
        right.loglog(t / HORSLEY.period, np.maximum.accumulate(np.abs(energy - HORSLEY.energy)) / (2 * omega2), **look)
    left.set(ylabel="largest error so far [rad]", ylim=(1e-9, 1e4))
    right.set(ylabel="largest error of the energy so far / energy of the top", ylim=(1e-9, 1e1))
    for axes in (left, right):
        axes.set(xlabel="time / period", xlim=(0.1, PERIODS))
        quiet(axes)
    left.legend(frameon=False, fontsize=9, loc="upper left", ncols=2)


def draw_orders(figure):
    """The error after one period of a swing of 90 degrees against the step."""
    axes = figure.subplots()
    swing, steps = Pendulum(np.radians(90.0)), np.array([1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1])
    for scheme, (color, dashes, order) in OVER_STEP.items():
        errors = [approx.numerical(f"{scheme}:{step!r}").of(swing).error(1).difference for step in steps.tolist()]
        axes.loglog(steps, errors, color=color, ls=dashes, marker="o", ms=4, lw=1.7, label=f"{scheme}, order {order}")
    for order, at in ((1, 1e-3), (2, 1e-6), (4, 1e-13)):
        axes.loglog(steps, at * (steps / steps[0]) ** order, color=FAINT, lw=1.0, zorder=0)
        axes.annotate(
            f"slope {order}", (steps[-1], at * (steps[-1] / steps[0]) ** order), color=BLACK, fontsize=9, ha="right"
        )
    axes.set(xlabel="step × ω₀", ylabel="largest error in one period [rad]")
    quiet(axes)
    axes.legend(frameon=False, fontsize=9)
