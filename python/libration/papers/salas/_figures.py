"""The figures of Salas 2019: 1 to 7, with the examples 1 to 4.

The text gives data for example 3 only. The captions say what was chosen for the others.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from ... import approx
from ...pendulum import Pendulum
from ...plot._style import BLACK, DASHED, DOTTED, angle_ticks, logarithmic, sizes, spans_decades
from .._diagram import angle, arrow, bare, bob, ceiling, letter, path, rod, vertical, write
from .._exact import salas_23
from .._picture import BLUE, GREY, RED, Picture, dashed, dotted, exact, named, panels

if TYPE_CHECKING:
    from matplotlib.figure import Figure

State: TypeAlias = tuple[float, float]

# Chosen: a libration with a velocity, a rotation, and a small swing with a velocity; omega0 = 1.
EXAMPLE1 = (1.0, 1.2)
EXAMPLE2 = (1.0, 2.18)
EXAMPLE3 = (math.pi / 2, 0.0)
EXAMPLE4 = (0.5, 0.4)
PHI, TIME = r"$\varphi$ [rad]", r"$t$, in units of $1/\omega$"
# The ends of the stated ranges of (2) and (3).
CUBIC, QUINTIC = 7 * math.pi / 18, 2 * math.pi / 3


def draw_pendulum(figure: Figure) -> None:
    """Figure 1."""
    axes = figure.subplots()
    bare(axes, (-0.6, -1.42), (1.05, 0.13))
    swing = math.radians(38)
    ceiling(axes)
    vertical(axes)
    path(axes, -0.45, 0.95)
    rod(axes, swing)
    angle(axes, 0, swing, 0.36, r"$\varphi$")
    write(axes, bob(swing, 0.55) + (0.09, 0.05), r"$l$", letter())
    write(axes, bob(swing) + (0.13, 0.02), r"$m$", letter())
    arrow(axes, bob(swing), (0, -0.55), RED, r"$mg$", (0.11, 0.05))
    along = -0.55 * math.sin(swing) * np.array([math.cos(swing), math.sin(swing)])
    arrow(axes, bob(swing), along, BLUE, r"$mg\,\sin\varphi$", (-0.07, -0.1))


def draw_sines(figure: Figure) -> None:
    """Figure 2."""
    upper, lower = panels(figure, (1.5, 1))
    phi = np.linspace(0, np.pi, 721)
    cubic, quintic = (approx.sine(name).value(phi) for name in ("salas-2", "salas-3"))
    upper.plot(phi, np.sin(phi), color=BLACK, lw=1.6, label=r"$\sin\varphi$")
    dotted(upper, phi, cubic, r"$\varphi-\frac{40}{243}\varphi^3$, (2)")
    dashed(upper, phi, quintic, r"$\varphi-\frac{40}{243}\varphi^3+\frac{1}{131}\varphi^5$, (3)")
    dotted(lower, phi, cubic - np.sin(phi), "")
    dashed(lower, phi, quintic - np.sin(phi), "")
    for end, text, color in ((CUBIC, "(2) to 70°", RED), (QUINTIC, "(3) to 120°", BLUE)):
        for axes in (upper, lower):
            axes.axvline(end, color=color, lw=0.9, alpha=0.6)
        lower.text(end - 0.03, 0.049, text, color=color, fontsize=9, ha="right", va="top")
    upper.set_ylim(-1.15, 1.5)
    lower.set_ylim(-0.055, 0.055)
    lower.set_xlim(0, np.pi)
    angle_ticks(lower.xaxis, 0, np.pi)
    named(upper, "", "value")
    named(lower, PHI, "difference")


def draw_numerical(figure: Figure, state: State, until: float, *, wrapped: bool = False) -> None:
    """Figures 3 and 4: exact and numerical, and their difference."""
    upper, lower = panels(figure)
    t = np.linspace(0, until, 1501)
    pendulum = Pendulum(*state)
    exact_theta = pendulum.theta(t)
    if wrapped:
        angle = salas_23(t, *state)
        gaps = np.flatnonzero(np.abs(np.diff(angle)) > np.pi) + 1
        upper.plot(
            np.insert(t, gaps, np.nan), np.insert(angle, gaps, np.nan), color=GREY, lw=1.1, label="(23) as printed"
        )
    exact(upper, t, exact_theta)
    numerical = approx.numerical("odeint").of(pendulum).theta(t)
    dashed(upper, t, numerical, "numerical (odeint)")
    lower.plot(t, 1e6 * (numerical - exact_theta), color=BLUE, lw=1.3, ls=DASHED)
    lower.set_xlim(0, until)
    angle_ticks(upper.yaxis, *upper.get_ylim())
    named(upper, "", PHI)
    named(lower, TIME, "difference [µrad]")


def draw_trigonometric(
    figure: Figure, state: State, name: str, periods: float, label: str, second: tuple[str, str] | None = None
) -> None:
    """Figures 5 to 7: exact and trigonometric, and their difference."""
    upper, lower = panels(figure)
    swing = Pendulum(*state)
    t = np.linspace(0, periods * swing.period, 1501)
    exact(upper, t, swing.theta(t))
    approximation = approx.angle(name).of(swing)
    dashed(upper, t, approximation.theta(t), label)
    differences = [approximation.difference(t)]
    if second:
        other = approx.angle(second[0]).of(swing)
        dotted(upper, t, other.theta(t), second[1])
        differences.append(other.difference(t))
    decades = spans_decades(differences)
    for difference, color, dash in zip(differences, (BLUE, RED), (DASHED, DOTTED), strict=False):
        lower.plot(t, sizes(difference) if decades else difference, color=color, lw=1.5, ls=dash)
    if decades:
        logarithmic(lower, differences)
    lower.set_xlim(0, t[-1])
    angle_ticks(upper.yaxis, *upper.get_ylim())
    named(upper, "", PHI)
    named(lower, TIME, "|difference| [rad]" if decades else "difference [rad]")


def told(state: State) -> str:
    """A state as text, with its parameter."""
    return f"φ₀ = {state[0]:.4g} rad, φ̇₀ = {state[1]:.4g} ω, m = {Pendulum(*state).energy_ratio:.4f}"


ENDS = "The lower panel is ours."
SIZE = (7.5, 5.6)
PICTURES = (
    Picture(
        "salas-1",
        "The pendulum",
        "After Salas 2019, fig. 1: a massless rod of length l with a point mass m at its end; its weight mg gives the "
        "restoring torque −mgl sin φ of (1).",
        (5.6, 5.2),
        draw_pendulum,
    ),
    Picture(
        "salas-2",
        "Polynomials for the sine",
        "After Salas 2019, fig. 2: sin φ and its approximations (2) and (3), with the ends of their stated ranges. "
        "The range drawn is our choice; the curves are odd. " + ENDS,
        SIZE,
        draw_sines,
    ),
    Picture(
        "salas-3",
        "Example 1: exact and numerical solution, libration",
        "After Salas 2019, fig. 3: solid, the exact solution (23); dashed, the numerical one, by SciPy's odeint at its "
        f"default tolerances. The data of example 1 are not in the text; chosen: {told(EXAMPLE1)}. " + ENDS,
        SIZE,
        lambda figure: draw_numerical(figure, EXAMPLE1, 20.0),
    ),
    Picture(
        "salas-4",
        "Example 2: exact and numerical solution, rotation",
        "After Salas 2019, fig. 4: solid, the exact solution (23), its turns counted on; grey, (23) as printed, whose "
        "arctan knows one turn; dashed, the numerical one, by SciPy's odeint at its default tolerances. The data of "
        f"example 2 are not in the text; chosen: {told(EXAMPLE2)}. " + ENDS,
        SIZE,
        lambda figure: draw_numerical(figure, EXAMPLE2, 15.0, wrapped=True),
    ),
    Picture(
        "salas-5",
        "Example 3: exact solution and trigonometric solution (35)",
        "After Salas 2019, fig. 5, with the data of (36): φ₀ = π/2 at rest, ω = 1. Solid, the exact solution; dashed, "
        "(35). The span of two periods is our choice. " + ENDS,
        SIZE,
        lambda figure: draw_trigonometric(figure, EXAMPLE3, "trigonometric", 2, "(35)"),
    ),
    Picture(
        "salas-6",
        "Example 3: exact solution and the formula for small m",
        "After Salas 2019, fig. 6, which the text counts to example 3 and does not explain. Solid, the exact solution; "
        "dashed, the formula printed above the figure, first order in m, at m = 1/2, far outside of its range: its "
        "terms grow with time. Dotted, ours: first order in m too, but bounded. " + ENDS,
        SIZE,
        lambda figure: draw_trigonometric(
            figure, EXAMPLE3, "small-m", 2, "formula for small m", ("small-m-bounded", "bounded")
        ),
    ),
    Picture(
        "salas-7",
        "Example 4: exact solution and the formula for small m",
        "After Salas 2019, fig. 7: solid, the exact solution; dashed, the formula for small m printed above fig. 6; "
        "dotted, ours: first order in m too, but bounded. The data of example 4 are not in the text; chosen: "
        f"{told(EXAMPLE4)}. " + ENDS,
        SIZE,
        lambda figure: draw_trigonometric(
            figure, EXAMPLE4, "small-m", 3, "formula for small m", ("small-m-bounded", "bounded")
        ),
    ),
)
