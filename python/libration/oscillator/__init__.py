"""Nonlinear springs: Duffing's oscillator and the cubic-quintic one, and the forms of Duffing's solutions.

All of it is in `libration` itself.

Examples
--------
>>> from libration import Duffing
>>> f"{Duffing(1.0, p=1.0, q=1.0).period:.6f}"
'4.768022'
"""

from ._cubic_quintic import CubicQuintic
from ._duffing import Duffing, duffing_motion
from ._form import DuffingForm
from ._oscillator import OscillatorRegime

__all__ = ["CubicQuintic", "Duffing", "DuffingForm", "OscillatorRegime", "duffing_motion"]


def __dir__() -> list[str]:
    return __all__
