"""Draws docs/duffing.png, the phase portraits of the springs with orbits of every regime, and docs/periods.png.

Run: python docs/pictures.py
"""

from pathlib import Path

import matplotlib
import numpy as np

from libration import Duffing
from libration.plot import plot_periods
from libration.plot._springs import along, barriers, equilibria, polynomial, potential
from libration.plot._style import EXACT, FAINT, SEPARATRIX, quiet

matplotlib.use("Agg")
from matplotlib import pyplot

# Title, p and q, half width and height, and orbits: a label and a start each.
PANELS = [
    ("hardening, p = 1, q = 1", 1.0, 1.0, 1.9, 2.6, [("libration", 1.4, 0.0), ("", 0.8, 0.0)]),
    (
        "double well, p = −1, q = 1/2",
        -1.0,
        0.5,
        2.7,
        1.9,
        [("libration", 2.3, 0.0), ("homoclinic", 2.0, 0.0), ("well", 1.8, 0.0), ("well", -1.8, 0.0)],
    ),
    (
        "softening, p = 1, q = −1/2",
        1.0,
        -0.5,
        2.7,
        2.1,
        [
            ("libration", 0.5, 0.0),
            ("heteroclinic", 0.0, 1.0),
            ("escape", 1.8, 0.0),
            ("escape", -1.8, 0.0),
            ("escape", 0.0, 1.4),
        ],
    ),
    (
        "repelling, p = −1, q = −1",
        -1.0,
        -1.0,
        1.9,
        2.6,
        [("escape", 0.5, 0.0), ("escape", 0.0, 0.6), ("escape", -0.5, 0.0)],
    ),
    ("no linear force, p = 0, q = 1", 0.0, 1.0, 1.9, 2.6, [("libration", 1.3, 0.0), ("libration", 0.8, 0.0)]),
    ("linear, p = 1, q = 0", 1.0, 0.0, 1.9, 2.6, [("linear", 1.3, 0.0), ("linear", 0.8, 0.0)]),
]


def draw(axes, title, p, q, width, height, orbits):
    """One portrait."""
    grid, speed = np.linspace(-width, width, 601), np.linspace(-height, height, 601)
    springs = [(label, Duffing(u0, velocity0, p=p, q=q)) for label, u0, velocity0 in orbits]
    spring = springs[0][1]
    stiffness, resting = polynomial(spring), [0.0, *equilibria(spring)]
    energy = potential(stiffness, grid)[None, :] + speed[:, None] ** 2 / 2
    axes.contour(grid, speed, energy, levels=10, colors=FAINT, linewidths=0.8, linestyles="solid")
    if tops := barriers(stiffness, resting):
        axes.contour(grid, speed, energy, levels=tops, colors=SEPARATRIX, linewidths=1.0, linestyles="dashed")
    named = set()
    for label, each in springs:
        assert not label or each.regime == label, (title, label, each.regime)
        u, velocity = along(each, width)
        axes.plot(u, velocity, color=EXACT, lw=1.8)
        if label and label not in named:
            named.add(label)
            shown = np.flatnonzero(np.isfinite(u) & (np.abs(velocity) < 0.75 * height))
            at = shown[np.argmax(velocity[shown])]
            axes.annotate(
                label,
                (u[at], velocity[at]),
                xytext=(0, 4),
                textcoords="offset points",
                ha="center",
                fontsize=9,
                color=EXACT,
            )
    axes.plot(resting, [0.0] * len(resting), "o", ms=4, color=SEPARATRIX)
    axes.set(xlim=(-width, width), ylim=(-height, height), xlabel="u", ylabel=r"$\dot u$")
    axes.set_title(title, fontsize=11, loc="left")
    quiet(axes)


def main():
    """Write the pictures beside this file."""
    figure, panels = pyplot.subplots(2, 3, figsize=(12, 7), dpi=100, layout="constrained")
    for axes, panel in zip(panels.flat, PANELS, strict=True):
        draw(axes, *panel)
    figure.savefig(Path(__file__).with_name("duffing.png"))
    plot_periods(Path(__file__).with_name("periods.png"))


if __name__ == "__main__":
    main()
