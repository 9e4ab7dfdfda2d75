"""The exact nonlinear pendulum, in every regime, right to the last digits.

``Pendulum`` is one orbit and answers at any time; ``theta``, ``velocity``, ``motion`` and ``advance`` work on arrays of
states; ``jacobi``, ``complete_k``, ``complete_e``, ``incomplete_f``, ``incomplete_e`` and ``nome`` are the elliptic
functions behind them. Angles are in radians, everything else in SI units.

Examples
--------
>>> import libration
>>> f"{libration.Pendulum(3.0, length=1.0, gravity=9.8).theta(10.0):.6f}"
'2.922419'
"""

from ._core import __version__
from .action_angle import action, frequency, from_action_phase, phase
from .arrays import advance, motion, theta, velocity
from .derivatives import sensitivities
from .elliptic import JacobiValues, complete_e, complete_k, incomplete_e, incomplete_f, jacobi, nome
from .pendulum import Pendulum, Regime
from .series import Fourier, harmonic_distortion

__all__ = [
    "Fourier",
    "JacobiValues",
    "Pendulum",
    "Regime",
    "__version__",
    "action",
    "advance",
    "complete_e",
    "complete_k",
    "frequency",
    "from_action_phase",
    "harmonic_distortion",
    "incomplete_e",
    "incomplete_f",
    "jacobi",
    "motion",
    "nome",
    "phase",
    "sensitivities",
    "theta",
    "velocity",
]
