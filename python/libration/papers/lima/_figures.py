"""The figures of Lima 2019: 1 to 4, 2 to 4 with the deviations in a lower panel."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from ... import approx
from ...pendulum import Pendulum
from ...plot._style import DASHED, DOTTED
from .._diagram import angle, arrow, bare, bob, letter, path, rod, vertical, write
from .._picture import BLUE, RED, Picture, dashed, dotted, exact, named, panels

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw_pendulum(figure: Figure) -> None:
    """Figure 1."""
    axes = figure.subplots()
    bare(axes, (-0.68, -1.25), (1.02, 0.12))
    start, swing = math.radians(58), math.radians(30)
    vertical(axes, 1.08)
    path(axes, -0.6, start)
    rod(axes, start, strong=False)
    rod(axes, swing)
    angle(axes, 0, start, 0.5, r"$\theta_0$", at=0.75)
    angle(axes, 0, swing, 0.28, r"$\theta$")
    axes.text(-0.1, 0.06, r"$C$", **letter())
    write(axes, bob(swing, 0.66) + (0.09, 0.03), r"$\ell$", letter())
    write(axes, bob(swing) + (0.14, -0.06), r"$m$", letter())
    back = -0.42 * np.array([math.cos(swing), math.sin(swing)])
    arrow(axes, bob(swing), back, BLUE, r"$v=\ell\,\dot\theta$", (-0.06, -0.1))


def draw_solutions(figure: Figure, theta0: float, order: int, text: str, half: str) -> None:
    """Figures 2 to 4: the exact solution, the harmonic one and N terms of the Fourier series, above their deviations."""
    upper, lower = panels(figure, (1.7, 1))
    swing = Pendulum(theta0)
    shares = np.linspace(0, 1, 1601)
    t = shares * swing.period
    exact(upper, shares, swing.theta(t))
    names = ("harmonic", f"fourier:{order}")
    terms = "1 term" if order == 1 else f"{order} terms"
    for name, curve, label, color, dash, width in zip(
        names,
        (dotted, dashed),
        ("harmonic, (17)", f"Fourier, (22), {terms}"),
        (RED, BLUE),
        (DOTTED, DASHED),
        (1.9, 1.7),
        strict=True,
    ):
        approximation = approx.angle(name).of(swing)
        curve(upper, shares, approximation.theta(t), label)
        lower.plot(shares, 100 * approximation.difference(t) / theta0, color=color, ls=dash, lw=width)
    lower.set_xlim(0, 1)
    upper.set_yticks(theta0 * np.linspace(-1, 1, 5), [f"−{text}", f"−{half}", "0", half, text])
    named(upper, "", r"$\theta$ [rad]")
    named(lower, r"$t/T$", r"deviation [% of $\theta_0$]")


def solutions(number: int, theta0: float, order: int, text: str, half: str) -> Picture:
    """The picture of figure 2, 3 or 4."""
    return Picture(
        f"lima-{number}",
        f"Periodic approximations, θ₀ = {text} = {math.degrees(theta0):g}°, N = {order}",
        f"After Lima 2019, fig. {number}: solid, the exact solution (16), corrected; dotted, the harmonic one "
        f"(17) with the exact period; dashed, the Fourier-based one (22) with N = {order}. Below, how far both deviate "
        "from the exact one, in % of θ₀ as in Lima's text. One period, in units of T, is our choice.",
        (7.5, 5.8),
        functools.partial(draw_solutions, theta0=theta0, order=order, text=text, half=half),
    )


PICTURES = (
    Picture(
        "lima-1",
        "The simple pendulum",
        "After Lima 2019, fig. 1: released at rest at θ₀, the bob passes θ with the velocity v = ℓ θ̇.",
        (6.2, 5.3),
        draw_pendulum,
    ),
    solutions(2, math.pi / 3, 1, "π/3", "π/6"),
    solutions(3, math.pi / 2, 2, "π/2", "π/4"),
    solutions(4, 7 * math.pi / 8, 4, "7π/8", "7π/16"),
)
