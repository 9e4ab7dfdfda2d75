"""Drawn pendulums: rod, bob, angles and arrows, for the papers' first figures and the picture on the ellipse."""

import numpy as np

from ._picture import BLACK

ROD = "#5a5a5a"


def bare(axes, low, high):
    """Equal scales, no frame, the corners of what is seen."""
    axes.set_aspect("equal")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.axis("off")


def bob(theta, length=1.0):
    """Where the bob is, the pivot at the origin."""
    return np.array([length * np.sin(theta), -length * np.cos(theta)])


def rod(axes, theta, *, strong=True):
    """The rod with its bob; a faint one shows an earlier place."""
    x, y = bob(theta)
    color, fill = (ROD, BLACK) if strong else ("#bdbdbd", "#e2e2e2")
    axes.plot([0, x], [0, y], color=color, lw=2 if strong else 1.4, solid_capstyle="round", zorder=2)
    axes.plot([x], [y], "o", ms=17, color=fill, mec=color, zorder=3)
    axes.plot([0], [0], "o", ms=6, color="white", mec=BLACK, mew=1.3, zorder=4)


def vertical(axes, length=1.2):
    """The dashed line of equilibrium."""
    axes.plot([0, 0], [0, -length], color="#9a9a9a", lw=1.1, ls=(0, (5, 4)), zorder=1)


def ceiling(axes, width=0.32):
    """The beam that carries the pivot, hatched."""
    axes.plot([-width, width], [0.035, 0.035], color=BLACK, lw=1.4)
    for x in np.linspace(-width, width - 0.05, 12):
        axes.plot([x, x + 0.05], [0.035, 0.085], color=BLACK, lw=0.8)


def angle(axes, start, stop, radius, text, color=BLACK, at=0.5):
    """An arc between two angles from the downward vertical, with its letter beside it at a share of the way."""
    turn = np.linspace(start, stop, 60)
    axes.plot(radius * np.sin(turn), -radius * np.cos(turn), color=color, lw=1.1)
    place = start + at * (stop - start)
    axes.text(*((radius + 0.07) * np.array([np.sin(place), -np.cos(place)])), text, **letter(color))


def path(axes, start, stop, length=1.0):
    """The circle on which the bob moves, dotted."""
    turn = np.linspace(start, stop, 120)
    axes.plot(length * np.sin(turn), -length * np.cos(turn), color="#9a9a9a", lw=1, ls=(0, (1, 3)), zorder=1)


def arrow(axes, start, vector, color, text="", beside=(0.0, 0.0), *, thick=1.8):
    """A force or a velocity: an arrow with its letter beside the tip."""
    tip = np.asarray(start) + vector
    axes.annotate(
        "",
        tip,
        start,
        arrowprops={"arrowstyle": "-|>", "color": color, "lw": thick, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 15},
        zorder=5,
    )
    axes.text(*(tip + beside), text, **letter(color))


def letter(color=BLACK):
    """The style of letters."""
    return {"color": color, "fontsize": 13, "ha": "center", "va": "center"}
