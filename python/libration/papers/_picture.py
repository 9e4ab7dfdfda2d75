"""The figures of the papers: each has a title, a caption and metadata, and is saved as SVG or PNG.

Only drawing needs matplotlib. Its Figure is used without pyplot, in the style of `libration.plot`. The caption is below
the figure and in the metadata of the file.
"""

from __future__ import annotations

import os
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import IO, TYPE_CHECKING

import numpy as np

from .._arrays import Floats
from ..plot._style import BLACK, DASHED, DOTTED, EXACT, LINEAR, SEPARATRIX, head, legend, quiet, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# The exact curve is black, approximations are red and dotted or blue and dashed, as in Lima 2019.
RED, BLUE, GREY = SEPARATRIX, EXACT, LINEAR
# Characters of the caption per inch of width.
CHARACTERS = 16


@dataclass(frozen=True)
class Picture:
    """One figure of a paper, drawn by this package.

    Parameters
    ----------
    name : str
        File name without suffix: the paper and the number of the figure.
    title : str
        What the figure shows, in one line.
    caption : str
        The source, and what was chosen where the paper gives no value.
    size : pair of float
        Width and height, inches.
    draw : callable
        Draws into a matplotlib Figure.

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration.papers import pictures
    >>> picture = pictures("lima")[0]
    >>> print(picture.name, picture.size)
    lima-1 (6.2, 5.3)
    >>> file = BytesIO()
    >>> picture.save({"png": file})
    >>> file.getvalue()[1:4]
    b'PNG'
    """

    name: str
    title: str
    caption: str
    size: tuple[float, float]
    draw: Callable[[Figure], None]

    def save(self, files: Mapping[str, str | os.PathLike[str] | IO[bytes]]) -> None:
        """Draw once, and save in every file format of `files`.

        Parameters
        ----------
        files : dict
            Path or binary file by file format, `svg` or `png`.

        Raises
        ------
        ImportError
            If matplotlib is missing, or SciPy where the paper integrates.

        Examples
        --------
        >>> from io import BytesIO
        >>> from libration.papers import pictures
        >>> file = BytesIO()
        >>> pictures("salas")[1].save({"svg": file})
        >>> b"Polynomials for the sine" in file.getvalue()
        True
        """

        def draw(figure: Figure) -> None:
            with np.errstate(all="ignore"):
                self.draw(figure)
            head(figure, self.title)
            # No line break within `m = 0.1`.
            text = textwrap.fill(self.caption.replace(" = ", "\u00a0=\u00a0"), int(CHARACTERS * self.size[0]))
            figure.supxlabel(text, x=0.012, ha="left", fontsize=8.5, color="#555555", linespacing=1.35)

        save_figure(dict(files), self.size, draw, dpi=200, told={"Title": self.title, "Description": self.caption})


def panels(figure: Figure, heights: tuple[float, float] = (2.1, 1)) -> tuple[Axes, Axes]:
    """An upper and a lower panel over the same axis."""
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=heights)
    for axes in (upper, lower):
        quiet(axes)
    lower.axhline(0, color="#999999", lw=0.8)
    return upper, lower


def exact(axes: Axes, t: Floats, theta: Floats) -> None:
    """The exact solution: black, solid."""
    axes.plot(t, theta, color=BLACK, lw=2.1, label="exact")


def dotted(axes: Axes, t: Floats, theta: Floats, label: str) -> None:
    """The first approximation: red, dotted."""
    axes.plot(t, theta, color=RED, lw=1.9, ls=DOTTED, label=label)


def dashed(axes: Axes, t: Floats, theta: Floats, label: str) -> None:
    """The second approximation, or the numerical solution: blue, dashed."""
    axes.plot(t, theta, color=BLUE, lw=1.7, ls=DASHED, label=label)


def named(axes: Axes, horizontal: str, vertical: str) -> None:
    """Label both axes, and add the legend."""
    axes.set_xlabel(horizontal)
    axes.set_ylabel(vertical)
    if axes.get_legend_handles_labels()[0]:
        legend(axes)
