"""Draws the pictures of docs/ensembles-examples.md: the scripts of examples/ in the look of the house.

Run: python docs/ensemble_pictures.py [NAME ...]
"""

import runpy
import sys
from pathlib import Path

from libration.plot._style import quiet, save_figure

ROOT = Path(__file__).resolve().parents[1]
NAMES = ("filamentation", "tunes", "capture", "fit", "training", "sections")


def picture(name):
    """Draw one picture beside this file."""
    script = runpy.run_path(str(ROOT / "examples" / f"{name}.py"))

    def draw(figure):
        script["draw"](figure)
        for axes in figure.axes:
            if axes.get_label() != "<colorbar>":
                quiet(axes)

    save_figure({"png": ROOT / "docs" / f"ensembles-{name}.png"}, script["SIZE"], draw)


if __name__ == "__main__":
    for name in sys.argv[1:] or NAMES:
        picture(name)
