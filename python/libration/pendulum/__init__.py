"""The pendulum theta'' + omega0**2 sin(theta) = 0: one orbit, and functions of arrays of states.

All of it is in `libration` itself.

Examples
--------
>>> from libration import Pendulum
>>> f"{Pendulum(3.0).period:.6f}"
'16.155539'
"""

from ._action import action, frequency, from_action_phase, phase
from ._constants import Regime
from ._fourier import Fourier, harmonic_distortion
from ._kept import energy, energy_ratio, energy_ratio_c, period, regime, theta_max
from ._motion import advance, motion, theta, velocity
from ._passages import next_crossing, turns
from ._pendulum import Pendulum
from ._sensitivities import sensitivities
from ._uncertain import uncertain_motion, uncertain_period

__all__ = [
    "Fourier",
    "Pendulum",
    "Regime",
    "action",
    "advance",
    "energy",
    "energy_ratio",
    "energy_ratio_c",
    "frequency",
    "from_action_phase",
    "harmonic_distortion",
    "motion",
    "next_crossing",
    "period",
    "phase",
    "regime",
    "sensitivities",
    "theta",
    "theta_max",
    "turns",
    "uncertain_motion",
    "uncertain_period",
    "velocity",
]


def __dir__() -> list[str]:
    return __all__
