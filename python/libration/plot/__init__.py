"""Pictures of motions, fits, springs, formulas of the period and approximations, saved as PNG or SVG.

matplotlib is needed only here (`pip install 'libration[plot]'`), and only when a picture is drawn.

Examples
--------
>>> from io import BytesIO
>>> from libration import Pendulum, plot
>>> picture = BytesIO()
>>> plot.plot_motion(Pendulum(3.0), [0.0, 10.0], picture, form="png")
>>> picture.getvalue()[1:4]
b'PNG'
"""

from ._backbone import plot_backbone
from ._comparison import plot_comparison
from ._fit import plot_fit
from ._linear import linear_theta
from ._motion import plot_motion
from ._periods import plot_period, plot_periods
from ._springs import plot_oscillator
from ._together import plot_together

__all__ = [
    "linear_theta",
    "plot_backbone",
    "plot_comparison",
    "plot_fit",
    "plot_motion",
    "plot_oscillator",
    "plot_period",
    "plot_periods",
    "plot_together",
]


def __dir__() -> list[str]:
    return __all__
