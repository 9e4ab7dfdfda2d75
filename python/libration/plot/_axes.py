"""The axes that a plot draws into: those of the user, or a new figure; and what the user sees of a missing matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._scalars import shown
from ._style import MISSING, legend, quiet

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def given_or_new(ax: Any, size: tuple[float, float] = (6.4, 4.2)) -> tuple[Axes, bool]:
    """The axes to draw into, and whether they are new.

    A figure of the user keeps its look and its settings; pyplot is used for a new figure only, which a notebook shows.
    """
    if ax is not None:
        if not hasattr(ax, "transAxes"):
            raise ValueError(f"ax = {shown(ax)}: must be Axes of matplotlib, or None for a new figure")
        if ax.name != "rectilinear":
            raise ValueError(f"ax = {shown(ax)}: must be plain Axes, with x and y; its projection is {ax.name}")
        return ax, False
    try:
        from matplotlib import pyplot
    except ModuleNotFoundError as error:
        raise ImportError(MISSING) from error
    axes = pyplot.subplots(figsize=size, layout="constrained")[1]
    quiet(axes)
    return axes, True


def named(axes: Any, new: bool) -> None:
    """The legend: above new axes, inside those of the user, whose title stands above."""
    if not axes.get_legend_handles_labels()[0]:
        return
    if new:
        legend(axes)
    else:
        axes.legend(loc="best", fontsize="small", framealpha=0.85)


def once(axes: Any, label: str) -> str:
    """A label, hidden from the legend where the axes have it already."""
    present = axes.get_legend_handles_labels()[1]
    return "_" + label if label in present else label
