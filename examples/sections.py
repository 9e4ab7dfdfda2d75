"""Poincaré sections of driven pendulums: an ensemble of starts, seen once in each period of the drive.

theta'' + theta'/q + sin(theta) = g cos(2/3 t). Without friction a weak drive leaves islands of regular motion in a chaotic sea around
the separatrix. With q = 2 all starts end on the same few points, or on a strange attractor: over the strength g of the drive the motion
doubles its period again and again, is chaotic, and regular once more. Every period shrinks areas by exp(-T/q) exactly,
wherever the pendulum is: `DampedPendulum.sensitivities` shows it.

Each pendulum is integrated by itself, some 15 microseconds a period of the drive, and threads share them: the interpreter is not held.
Run: python examples/sections.py; docs/ensembles-examples.md shows the picture.
Source: Baker & Gollub, Chaotic Dynamics (1996), chapters 3 and 4; Ott, Chaos in Dynamical Systems (2002), chapters 1 and 7.
"""

import math
import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from libration import DampedPendulum, Friction, Torque

# Of the picture, in inches.
SIZE = (13.5, 4.8)
DRIVE, Q = 2 / 3, 2.0
PERIOD = math.tau / DRIVE


def pendulum(start, g, q=Q):
    """One pendulum from an angle and a velocity; q is infinite without friction."""
    return DampedPendulum(*start, friction=Friction(linear=0.5 / q), torque=Torque(amplitude=g, frequency=DRIVE))


def sections(starts, drives, periods, q=Q, settled=0):
    """Angles in [-pi, pi) and velocities once a period of the drive, of each start under its drive: a row a pendulum."""

    def section(start, g):
        theta, velocity = pendulum(start, g, q).motion(PERIOD * np.arange(settled, periods))
        return theta - math.tau * np.floor(theta / math.tau + 0.5), velocity

    with ThreadPoolExecutor(os.cpu_count()) as threads:
        found = np.array(list(threads.map(section, starts, drives)))
    return found[:, 0], found[:, 1]


def grid(n, width=3.0, height=2.0):
    """Starts evenly spread over the phase plane."""
    number = np.arange(1, n + 1)
    return np.column_stack(
        [
            ((number * step) % 1 - 0.5) * 2 * size
            for step, size in ((0.7548776662466927, width), (0.5698402909980532, height))
        ]
    )


def shrinks_by(start, g):
    """The factor of an area after one period of the drive."""
    return np.linalg.det(pendulum(start, g).sensitivities(PERIOD)[:, :2])


def draw(figure, n=160, periods=400, drives=500):
    """Islands and sea without friction, the attractor with it, and the velocities over the strength of the drive."""
    sea, attractor, doubling = figure.subplots(1, 3, width_ratios=(1, 1, 1.35))
    dots = {"ls": "none", "marker": ",", "rasterized": True}
    theta, velocity = sections(grid(n // 2), [0.1] * (n // 2), periods, q=math.inf)
    height = np.abs(grid(n // 2)[:, 1])
    sea.scatter(theta, velocity, s=0.15, c=np.repeat(height[:, None], periods, axis=1), cmap="viridis", rasterized=True)
    sea.set(xlim=(-math.pi, math.pi), ylim=(-3, 3), xlabel="θ", ylabel="θ̇ over ω₀")
    sea.set_title("No friction, g = 0.1", loc="left", fontsize=11)

    theta, velocity = sections(grid(n), [1.5] * n, periods, settled=20)
    attractor.plot(theta.ravel(), velocity.ravel(), color="#0072b2", **dots)
    attractor.set(xlim=(-math.pi, math.pi), xlabel="θ")
    attractor.set_title("q = 2, g = 1.5", loc="left", fontsize=11)

    strengths = np.repeat(np.linspace(1.0, 1.5, drives), 4)
    _, velocity = sections(np.tile(grid(4), (drives, 1)), strengths, 120, settled=80)
    doubling.plot(np.repeat(strengths, velocity.shape[1]), velocity.ravel(), color="#0072b2", **dots)
    doubling.set(xlim=(1.0, 1.5), xlabel="strength of the drive g", ylabel="θ̇ once a period")
    doubling.set_title("q = 2, four starts for each g", loc="left", fontsize=11)


if __name__ == "__main__":
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    draw(figure)
    figure.savefig("sections.png")
