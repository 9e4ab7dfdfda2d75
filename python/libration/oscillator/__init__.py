"""Nonlinear springs: Duffing's oscillator and the cubic-quintic one, and the forms of Duffing's solutions.

All of it is in `libration` itself.

Examples
--------
>>> from libration import Duffing
>>> f"{Duffing(1.0, p=1.0, q=1.0).period:.6f}"
'4.768022'
"""

from ._cubic_quintic import CubicQuintic
from ._duffing import Duffing
from ._form import DuffingForm
from ._knowledge import OscillatorFourier
from ._oscillator import OscillatorRegime
from ._quintic_rows import (
    cubic_quintic_action,
    cubic_quintic_escape_times,
    cubic_quintic_frequency,
    cubic_quintic_period,
    cubic_quintic_phase,
    cubic_quintic_regime,
)
from ._rows import (
    cubic_quintic_motion,
    duffing_action,
    duffing_escape_times,
    duffing_frequency,
    duffing_motion,
    duffing_period,
    duffing_phase,
    duffing_regime,
)

__all__ = [
    "CubicQuintic",
    "Duffing",
    "DuffingForm",
    "OscillatorFourier",
    "OscillatorRegime",
    "cubic_quintic_action",
    "cubic_quintic_escape_times",
    "cubic_quintic_frequency",
    "cubic_quintic_motion",
    "cubic_quintic_period",
    "cubic_quintic_phase",
    "cubic_quintic_regime",
    "duffing_action",
    "duffing_escape_times",
    "duffing_frequency",
    "duffing_motion",
    "duffing_period",
    "duffing_phase",
    "duffing_regime",
]
