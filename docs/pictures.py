"""Draws docs/duffing.png, the phase portraits of the springs with orbits of every regime, and docs/periods.png; docs/damped.png, a
motion with friction; docs/junction.png, Shapiro's steps; docs/bucket.png, a million particles; docs/why/integrators.png and orders.png.

Run: python docs/pictures.py
"""

from pathlib import Path

import bucket
import junction
import numpy as np
from scipy.special import jv
from why import integrators

from libration import DampedPendulum, Duffing, Friction
from libration.plot import plot_periods
from libration.plot._axes import named
from libration.plot._language import ENGLISH
from libration.plot._potential import barriers, equilibria, polynomial, potential
from libration.plot._springs import along
from libration.plot._style import DASHED, EXACT, FAINT, GREEN, LINEAR, PURPLE, SEPARATRIX, quiet, save_figure

# Title, p and q, half width and height, and orbits: a label, where it stands over the orbit, and a start each.
PANELS = [
    ("hardening, p = 1, q = 1", 1.0, 1.0, 1.9, 2.6, [("libration", 0.0, 1.4, 0.0), ("", 0.0, 0.8, 0.0)]),
    (
        "double well, p = −1, q = 1/2",
        -1.0,
        0.5,
        2.7,
        1.9,
        [("libration", 0.0, 2.3, 0.0), ("homoclinic", 1.41, 2.0, 0.0), ("well", 1.3, 1.8, 0.0), ("", 0.0, -1.8, 0.0)],
    ),
    (
        "softening, p = 1, q = −1/2",
        1.0,
        -0.5,
        2.7,
        2.1,
        [
            ("libration", 0.0, 0.5, 0.0),
            ("heteroclinic", 0.0, 0.0, 1.0),
            ("escape", 0.0, 0.0, 1.4),
            ("", 0.0, 1.8, 0.0),
            ("", 0.0, -1.8, 0.0),
        ],
    ),
    (
        "repelling, p = −1, q = −1",
        -1.0,
        -1.0,
        1.9,
        2.6,
        [("escape", 0.0, 0.0, 0.6), ("", 0.0, 0.5, 0.0), ("", 0.0, -0.5, 0.0)],
    ),
    ("no linear force, p = 0, q = 1", 0.0, 1.0, 1.9, 2.6, [("libration", 0.0, 1.3, 0.0), ("", 0.0, 0.8, 0.0)]),
    ("linear, p = 1, q = 0", 1.0, 0.0, 1.9, 2.6, [("linear", 0.0, 1.3, 0.0), ("", 0.0, 0.8, 0.0)]),
]


def draw(axes, title, p, q, width, height, orbits):
    """One portrait."""
    grid, speed = np.linspace(-width, width, 601), np.linspace(-height, height, 601)
    springs = [(label, at, Duffing(u0, velocity0, p=p, q=q)) for label, at, u0, velocity0 in orbits]
    spring = springs[0][2]
    stiffness, resting = polynomial(spring), [0.0, *equilibria(spring)]
    energy = potential(stiffness, grid)[None, :] + speed[:, None] ** 2 / 2
    axes.contour(grid, speed, energy, levels=10, colors=FAINT, linewidths=0.8, linestyles="solid")
    if tops := barriers(stiffness, resting):
        axes.contour(grid, speed, energy, levels=tops, colors=SEPARATRIX, linewidths=1.2, linestyles=[DASHED])
    for label, at, each in springs:
        assert not label or each.regime == label, (title, label, each.regime)
        u, velocity = along(each, width)
        axes.plot(u, velocity, color=EXACT, lw=1.8)
        if label:
            above = np.flatnonzero(np.isfinite(u) & (velocity > 0))
            place = above[np.argmin(np.abs(u[above] - at))]
            patch = {"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.9}
            middle = {"ha": "center", "va": "center", "fontsize": 9.5, "color": EXACT, "bbox": patch, "zorder": 4}
            axes.annotate(label, (u[place], velocity[place]), **middle)
    for rest in resting:
        stable = sum((2 * k + 1) * c * rest ** (2 * k) for k, c in enumerate(stiffness)) >= 0
        axes.plot(
            [rest], [0.0], "o", ms=5.5, color=SEPARATRIX if stable else "white", mec=SEPARATRIX, mew=1.3, zorder=5
        )
    axes.set(xlim=(-width, width), ylim=(-height, height), xlabel="u", ylabel=r"$\dot u$")
    axes.set_title(title, fontsize=11, loc="left")
    quiet(axes)


def draw_springs(figure):
    """Six portraits and what their lines mean."""
    panels = figure.subplots(2, 3)
    for axes, panel in zip(panels.flat, PANELS, strict=True):
        draw(axes, *panel)
    first = panels.flat[0]
    marks = [
        first.plot([], [], color=EXACT, lw=1.8, label="orbits, with their regimes")[0],
        first.plot([], [], color=SEPARATRIX, lw=1.2, ls=DASHED, label="separatrix")[0],
        first.plot([], [], color=FAINT, lw=1.2, label=ENGLISH.word("other energies"))[0],
        first.plot([], [], "o", ms=5.5, color=SEPARATRIX, label="stable equilibrium")[0],
        first.plot([], [], "o", ms=5.5, color="white", mec=SEPARATRIX, mew=1.3, label="unstable equilibrium")[0],
    ]
    figure.legend(handles=marks, loc="outside lower center", ncols=5, frameon=False, fontsize=10)


def draw_damped(figure):
    """A pendulum that turns over the top twice, swings and is stopped by dry friction: angle, energy and spiral."""
    friction = Friction(linear=0.03, quadratic=0.02, dry=0.02)
    pendulum, t = DampedPendulum(0.0, 2.9, friction=friction), [0.0, 75.0]
    panels = figure.subplot_mosaic([["angle", "phase"], ["energy", "phase"]], width_ratios=(1.25, 1))
    look = {"color": EXACT, "lw": 1.6, "label": "with friction"}
    for axes in panels.values():
        quiet(axes)
    pendulum.plot(t, ax=panels["angle"], undamped=False, **look)
    pendulum.plot_energy(t, ax=panels["energy"], **look)
    pendulum.plot_phase(panels["phase"], t=t, **look)
    for axes in panels.values():
        named(axes, new=True)


def draw_junction(figure):
    """Shapiro's steps, and how wide they are."""
    left, right = figure.subplots(1, 2)
    colors = {"steps": SEPARATRIX, "dashes": DASHED, "still": LINEAR, "driven": EXACT, "orders": (EXACT, GREEN, PURPLE)}
    junction.draw_curve(left, quiet, colors)
    junction.draw_widths(right, quiet, colors, jv)


def draw_bucket(figure):
    """A bunch in a bucket."""
    colors = {"edge": SEPARATRIX, "dashes": DASHED, "bunch": EXACT, "tune": GREEN}
    bucket.draw_bucket(figure, quiet, colors)


def main():
    """Write the pictures beside this file."""
    save_figure({"png": Path(__file__).with_name("duffing.png")}, (12, 7.6), draw_springs)
    plot_periods(Path(__file__).with_name("periods.png"))
    save_figure({"png": Path(__file__).with_name("damped.png")}, (12, 6.4), draw_damped)
    save_figure({"png": Path(__file__).with_name("junction.png")}, (12, 5), draw_junction)
    save_figure({"png": Path(__file__).with_name("bucket.png")}, (13, 5), draw_bucket)
    save_figure({"png": Path(__file__).parent / "why/integrators.png"}, (12, 5), integrators.draw_over_time)
    save_figure({"png": Path(__file__).parent / "why/orders.png"}, (8, 5), integrators.draw_orders)


if __name__ == "__main__":
    main()
