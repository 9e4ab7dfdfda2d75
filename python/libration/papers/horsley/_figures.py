"""The figures of Horsley 2025: the force diagram, the two graphs, and two figures that the essay suggests.

These are the phase space and a figure of the elliptic functions: on the ellipse x**2 + y**2/b**2 = 1 with
b**2 = 1/(1 - m), a point at the distance r has cn = x/r, sn = y/r, dn = 1/r, and sin(theta/2) = k x.
"""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from ... import approx
from ...elliptic import complete_k, jacobi
from ...pendulum import Pendulum
from ...plot import linear_theta
from ...plot._style import BLACK, DASHED, DOTTED, GREEN, PURPLE, angle_ticks, quiet
from .._diagram import angle, arrow, bare, bob, letter, path, rod, vertical, write
from .._picture import BLUE, GREY, RED, Picture, named, panels

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

GRAVITY, LENGTH = 9.8, 1.0
DARK_RED, BRIGHT_RED = "#7a1f12", "#e0301e"
# The ellipse: released at rest from 120 degrees, m = 3/4, half axes 1 and 2.
RELEASE = 2 * math.pi / 3


def swing(theta0: float) -> Pendulum:
    """Horsley's pendulum: 1 m, g = 9.8 m/s2."""
    return Pendulum(theta0, length=LENGTH, gravity=GRAVITY)


def draw_forces(figure: Figure) -> None:
    """Figure 1: the force diagram."""
    axes = figure.subplots()
    bare(axes, (-0.45, -1.52), (1.2, 0.1))
    at = math.radians(35)
    place = bob(at)
    vertical(axes)
    path(axes, 0, at)
    rod(axes, at)
    angle(axes, 0, at, 0.22, r"$\theta$")
    write(axes, bob(at, 0.3) + (0.07, 0.05), r"$l$", letter())
    write(axes, bob(at / 4, 0.95), r"$s$", letter())
    write(axes, place + (0.13, 0.06), r"$m$", letter())
    weight = 0.6
    radial, along = np.array([math.sin(at), -math.cos(at)]), -np.array([math.cos(at), math.sin(at)])
    arrow(axes, place, -0.52 * radial, DARK_RED, r"$T$", (0.0, -0.13))
    arrow(axes, place, (0, -weight), BRIGHT_RED, r"$mg$", (0.0, -0.08))
    arrow(axes, place, weight * math.sin(at) * along, GREEN, r"$mg\,\sin\theta$", (-0.14, -0.1), thick=1.5)
    arrow(axes, place, weight * math.cos(at) * radial, GREEN, r"$mg\,\cos\theta$", (0.2, -0.02), thick=1.5)
    # The components add up to the weight.
    tip = place + (0, -weight)
    for corner in (weight * math.sin(at) * along, weight * math.cos(at) * radial):
        axes.plot(*zip(place + corner, tip, strict=True), color=GREEN, lw=0.8, ls=(0, (3, 3)))


def draw_graph(figure: Figure, theta0: float) -> None:
    """The two graphs: the nonlinear and the linear equation over ten seconds."""
    upper, lower = panels(figure, (2.2, 1))
    pendulum = swing(theta0)
    t = np.linspace(0, 10, 500)
    numerical = approx.numerical("odeint").of(pendulum).theta(t)
    upper.plot(t, numerical, color=BLUE, lw=1.8, label="nonlinear (odeint)")
    upper.plot(t, linear_theta(pendulum, t), color=RED, lw=1.5, ls=DASHED, label="linear")
    upper.plot(t[::10], pendulum.theta(t[::10]), "o", ms=3.2, color=BLACK, mew=0, label="exact")
    lower.plot(t, 1e6 * (numerical - pendulum.theta(t)), color=BLUE, lw=1.2)
    lower.set_xlim(0, 10)
    named(upper, "", "angular displacement [rad]")
    named(lower, "time [s]", "odeint − exact\n[µrad]")


def draw_phase_space(figure: Figure) -> None:
    """The orbits of (2) in the plane of angle and velocity."""
    axes = figure.subplots()
    quiet(axes)
    omega0 = swing(1.0).omega0
    grid = np.linspace(-2 * np.pi, 2 * np.pi, 801)
    speed = np.linspace(-3.2 * omega0, 3.2 * omega0, 801)
    energy = (speed[:, None] / (2 * omega0)) ** 2 + np.sin(grid[None, :] / 2) ** 2
    levels = (0.05, 0.2, 0.4, 0.6, 0.8, 1.3, 1.7, 2.2)
    axes.contour(grid, speed, energy, levels=levels, colors="#c4c4c4", linewidths=0.9)
    for sign, label in ((1, "separatrix"), (-1, None)):
        axes.plot(
            grid, sign * 2 * omega0 * np.abs(np.cos(grid / 2)), color=RED, lw=1.7, ls=DASHED, label=label, zorder=3
        )
    for theta0, color, style in ((0.4, BLUE, DOTTED), (3.0, BLUE, "-")):
        pendulum = swing(theta0)
        theta, velocity = pendulum.motion(np.linspace(0, pendulum.period, 401))
        axes.plot(theta, velocity, color=color, lw=2, ls=style, label=f"from rest at {theta0:g} rad")
    axes.plot(np.arange(-1, 2) * 2 * np.pi, np.zeros(3), "o", ms=6, color=BLACK, label="bottom", clip_on=False)
    axes.plot([-np.pi, np.pi], [0, 0], "o", ms=6, color="white", mec=BLACK, label="top")
    for x, y, text in ((-np.pi, 8.35, "rotation, forward"), (-np.pi, -8.35, "rotation, back"), (0, 3.4, "libration")):
        patch: dict[str, str | float] = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
        axes.text(x, y, text, **letter("#666666") | {"fontsize": 9.5, "bbox": patch})
    axes.set(xlim=(grid[0], grid[-1]), ylim=(speed[0], speed[-1]))
    angle_ticks(axes.xaxis, grid[0], grid[-1])
    axes.set_xlabel(r"$\theta$ [rad]")
    axes.set_ylabel(r"$\dot\theta$ [rad/s]")
    axes.legend(loc="lower right", bbox_to_anchor=(1.01, 1.0), ncols=5, frameon=False, fontsize=9, columnspacing=1.0)


def draw_ellipse(figure: Figure) -> None:
    """Three panels: the elliptic functions on the ellipse, the chord of the pendulum, and both over time."""
    left, middle, right = figure.subplots(1, 3, width_ratios=(1.05, 1.0, 1.25))
    m, k = math.sin(RELEASE / 2) ** 2, math.sin(RELEASE / 2)
    u = 0.55 * complete_k(m=m)
    on_ellipse(left, m, u)
    on_circle(middle, k, u)
    over_time(right, m, u)


def on_ellipse(axes: Axes, m: float, u: float) -> None:
    """The point at u, its distance and its angle."""
    b = 1 / math.sqrt(1 - m)
    bare(axes, (-2.75, -2.2), (1.4, 2.3))
    turn = np.linspace(0, 2 * np.pi, 400)
    axes.plot(np.cos(turn), b * np.sin(turn), color=BLACK, lw=1.6)
    axes.plot(np.cos(turn), np.sin(turn), color=GREY, lw=1, ls=(0, (4, 3)))
    axes.plot([-1.3, 1.35], [0, 0], color="#9a9a9a", lw=0.9)
    axes.plot([0, 0], [-2.2, 2.25], color="#9a9a9a", lw=0.9)
    z = jacobi(u, m=m)
    x, y = z.cn / z.dn, z.sn / z.dn
    axes.plot([0, x], [0, y], color=BLUE, lw=1.6)
    axes.plot([x, x], [0, y], color="#9a9a9a", lw=1, ls=(0, (3, 3)))
    axes.plot([0, x], [0, 0], color=RED, lw=3, solid_capstyle="butt")
    axes.plot([x], [y], "o", ms=7, color=BLUE)
    axes.plot([0.36 * math.cos(each) for each in np.linspace(0, z.am)], 0.36 * np.sin(np.linspace(0, z.am)), color=BLUE)
    small = letter() | {"fontsize": 11}
    axes.text(0.5 * math.cos(z.am / 2), 0.5 * math.sin(z.am / 2), r"$\varphi$", **small | {"color": BLUE})
    axes.text(0.5 * x - 0.14, 0.5 * y + 0.06, r"$r$", **small | {"color": BLUE})
    axes.text(x / 2, -0.15, r"$x$", **small | {"color": RED})
    axes.text(x - 0.12, 0.42 * y, r"$y$", **small)
    axes.text(0.07, b + 0.14, r"$b$", **small)
    axes.text(1.11, -0.14, r"$1$", **small)
    told = "cn$\\,u = x/r$\nsn$\\,u = y/r$\ndn$\\,u = 1/r$\n$u=\\int_0^\\varphi r\\,d\\varphi$"
    axes.text(-2.75, 2.2, told, fontsize=11, va="top", linespacing=1.5)


def on_circle(axes: Axes, k: float, u: float) -> None:
    """The pendulum at the same u, with the chord from the lowest point to the bob."""
    m = k * k
    bare(axes, (-0.62, -1.2), (1.15, 0.95))
    z = jacobi(u, m=m)
    theta = 2 * math.asin(k * z.cn / z.dn)
    path(axes, -0.5, RELEASE)
    vertical(axes, 1.0)
    rod(axes, RELEASE, strong=False)
    rod(axes, theta)
    low, place = bob(0.0), bob(theta)
    axes.plot([low[0], place[0]], [low[1], place[1]], color=RED, lw=3, solid_capstyle="butt")
    angle(axes, 0, theta, 0.24, r"$\theta$")
    beside = low + 0.42 * (place - low) + (-0.17, 0.17)
    write(axes, beside, "chord\n$2lk\\,x$", letter(RED) | {"fontsize": 11, "linespacing": 1.2})
    write(axes, bob(theta, 0.6) + (-0.02, 0.1), r"$l$", letter() | {"fontsize": 11})
    axes.text(-0.62, 0.9, r"$\sin(\theta/2) = k\,x = k\,\mathrm{cd}\,u$", fontsize=11, va="top")


def over_time(axes: Axes, m: float, u: float) -> None:
    """x on the ellipse and on the circle over one period."""
    quiet(axes)
    quarter = complete_k(m=m)
    shares = np.linspace(0, 4, 801)
    z = jacobi(shares * quarter, m=m)
    axes.plot(shares, z.cn / z.dn, color=BLACK, lw=1.7, label=r"$x=\mathrm{cd}\,u$, ellipse")
    axes.plot(shares, np.cos(shares * np.pi / 2), color=GREY, lw=1.3, ls=(0, (4, 3)), label="cosine, circle")
    for values, color, dash, label in (
        (z.sn, GREEN, DASHED, "sn"),
        (z.cn, BLUE, DOTTED, "cn"),
        (z.dn, PURPLE, (0, (6, 2, 1, 2)), "dn"),
    ):
        axes.plot(shares, values, color=color, lw=1.4, ls=dash, label=label)
    axes.plot([u / quarter], [jacobi(u, m=m).cn / jacobi(u, m=m).dn], "o", ms=7, color=BLUE)
    axes.set(xlim=(0, 4), ylim=(-1.08, 1.08))
    axes.set_xlabel(r"$u/K$, where $u=\omega_0 t$")
    axes.legend(loc="lower right", bbox_to_anchor=(1.02, 1.0), ncols=3, frameon=False, fontsize=9, handlelength=1.5)


def graph(number: int, theta0: float) -> Picture:
    """The figure of the graph at 0.4 or 3 rad."""
    ratio = swing(theta0).period * swing(theta0).omega0 / math.tau
    return Picture(
        f"horsley-{number}",
        f"Nonlinear and linear pendulum, released at rest from {theta0:g} rad",
        f"After Horsley 2025, appendix, the graph at {theta0:g} rad: l = 1 m, g = 9.8 m/s², 0 to 10 s. Blue, the "
        "nonlinear equation (2) by SciPy's odeint at its default tolerances, as in the essay's code; red and dashed, the "
        f"linear equation (1); dots, the exact solution. The period is {ratio:.4f} times that of (1). "
        "The lower panel is ours.",
        (7.5, 5.6),
        functools.partial(draw_graph, theta0=theta0),
    )


PICTURES = (
    Picture(
        "horsley-1",
        "Force diagram of a simple pendulum",
        "After Horsley 2025, fig. 1: the weight mg (bright red) with its components along the arc s and along the rod "
        "(green), and the tension T of the rod (dark red). The length is l, as in the essay's text.",
        (5.8, 5.6),
        draw_forces,
    ),
    graph(2, 0.4),
    graph(3, 3.0),
    Picture(
        "horsley-phase-space",
        "Phase space of the pendulum, l = 1 m, g = 9.8 m/s²",
        "Wished for in Horsley 2025, summary: the orbits of (2) in the plane of θ and θ̇. Blue, the two motions of the "
        "graphs; red and dashed, the separatrix θ̇ = ±2ω₀ cos(θ/2) between librations and rotations; grey, other "
        "energies.",
        (8.5, 5.4),
        draw_phase_space,
    ),
    Picture(
        "horsley-ellipse",
        "Elliptic functions on the ellipse, and the pendulum's chord",
        "Wished for in Horsley 2025, summary. Left: on x² + y²/b² = 1, b² = 1/(1 − m), the point at u; dashed, the "
        "circle of m = 0. Middle: the chord from the lowest point to the bob is 2lk times the ellipse's x, as the arc "
        "is the circle's x for small swings. Right: the functions over a period. Chosen: released at 120°, m = 3/4.",
        (11.0, 4.9),
        draw_ellipse,
    ),
)
