"""Parts of a drawing of a pendulum: rod, bob, angles and arrows, for figure 1 of each paper and the ellipse."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias, TypedDict

import numpy as np

from .._arrays import Floats
from ..plot._style import BLACK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Point: TypeAlias = tuple[float, float] | Floats

ROD = "#5a5a5a"


class Letter(TypedDict, total=False):
    """The style of a label, as matplotlib takes it."""

    color: str
    fontsize: float
    ha: str
    va: str
    linespacing: float
    bbox: dict[str, str | float]


def bare(axes: Axes, low: tuple[float, float], high: tuple[float, float]) -> None:
    """Set equal scales and the visible range from corner to corner, and hide the frame."""
    axes.set_aspect("equal")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.axis("off")


def bob(theta: float, length: float = 1.0) -> Floats:
    """The position of the bob; the pivot is at the origin."""
    return np.array([length * np.sin(theta), -length * np.cos(theta)])


def rod(axes: Axes, theta: float, *, strong: bool = True) -> None:
    """The rod with its bob; not strong for an earlier position."""
    x, y = bob(theta)
    color, fill = (ROD, BLACK) if strong else ("#bdbdbd", "#e2e2e2")
    axes.plot([0, x], [0, y], color=color, lw=2 if strong else 1.4, solid_capstyle="round", zorder=2)
    axes.plot([x], [y], "o", ms=17, color=fill, mec=color, zorder=3)
    axes.plot([0], [0], "o", ms=6, color="white", mec=BLACK, mew=1.3, zorder=4)


def vertical(axes: Axes, length: float = 1.2) -> None:
    """The dashed vertical line below the pivot."""
    axes.plot([0, 0], [0, -length], color="#9a9a9a", lw=1.1, ls=(0, (5, 4)), zorder=1)


def ceiling(axes: Axes, width: float = 0.32) -> None:
    """The beam that carries the pivot, hatched."""
    axes.plot([-width, width], [0.035, 0.035], color=BLACK, lw=1.4)
    for x in np.linspace(-width, width - 0.05, 12):
        axes.plot([x, x + 0.05], [0.035, 0.085], color=BLACK, lw=0.8)


def angle(axes: Axes, start: float, stop: float, radius: float, text: str, color: str = BLACK, at: float = 0.5) -> None:
    """An arc between two angles from the downward vertical, labelled at a fraction of the arc."""
    turn = np.linspace(start, stop, 60)
    axes.plot(radius * np.sin(turn), -radius * np.cos(turn), color=color, lw=1.1)
    place = start + at * (stop - start)
    write(axes, (radius + 0.07) * np.array([np.sin(place), -np.cos(place)]), text, letter(color))


def path(axes: Axes, start: float, stop: float, length: float = 1.0) -> None:
    """The circle of the bob, dotted."""
    turn = np.linspace(start, stop, 120)
    axes.plot(length * np.sin(turn), -length * np.cos(turn), color="#9a9a9a", lw=1, ls=(0, (1, 3)), zorder=1)


def arrow(
    axes: Axes,
    start: Point,
    vector: Point,
    color: str,
    text: str = "",
    beside: tuple[float, float] = (0.0, 0.0),
    *,
    thick: float = 1.8,
) -> None:
    """A force or a velocity: an arrow with a label at its tip."""
    tip = np.asarray(start) + vector
    axes.annotate(
        "",
        (tip[0], tip[1]),
        (start[0], start[1]),
        arrowprops={"arrowstyle": "-|>", "color": color, "lw": thick, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 15},
        zorder=5,
    )
    write(axes, tip + beside, text, letter(color))


def write(axes: Axes, place: Point, text: str, style: Letter) -> None:
    """A label at a position."""
    axes.text(place[0], place[1], text, **style)


def letter(color: str = BLACK) -> Letter:
    """The style of the labels."""
    return {"color": color, "fontsize": 13, "ha": "center", "va": "center"}
