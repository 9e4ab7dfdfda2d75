"""The exact nonlinear pendulum, in every regime, right to the last digits.

``Pendulum`` is one orbit and answers at any time; ``DampedPendulum`` has friction and torque; ``theta``, ``velocity``, ``motion`` and ``advance`` work on arrays of
states; ``jacobi``, ``complete_k`` and the rest are the elliptic functions behind them, all of which are in
``libration.elliptic``; ``approx`` holds the approximations by name, and
``libration.papers`` three papers worked through. Angles are in radians, everything else in SI units.

Examples
--------
>>> import libration
>>> f"{libration.Pendulum(3.0, length=1.0, gravity=9.8).theta(10.0):.6f}"
'2.922419'
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import elliptic as elliptic
from ._core import __version__
from .damped import DampedPendulum, Friction, Torque
from .elliptic import (
    JacobiComplexValues,
    JacobiValues,
    carlson_rc,
    carlson_rd,
    carlson_rf,
    carlson_rj,
    complete_e,
    complete_k,
    complete_pi,
    heuman_lambda,
    incomplete_e,
    incomplete_f,
    incomplete_pi,
    jacobi,
    jacobi_complex,
    jacobi_epsilon,
    jacobi_zeta,
    nome,
    theta1,
    theta2,
    theta3,
    theta4,
)
from .oscillator import CubicQuintic, Duffing, DuffingForm, OscillatorRegime, duffing_motion
from .pendulum import (
    Fourier,
    Pendulum,
    Regime,
    action,
    advance,
    frequency,
    from_action_phase,
    harmonic_distortion,
    motion,
    phase,
    sensitivities,
    theta,
    velocity,
)

if TYPE_CHECKING:
    from . import approx as approx
    from . import papers as papers
    from . import plot as plot

__all__ = [
    "CubicQuintic",
    "DampedPendulum",
    "Duffing",
    "DuffingForm",
    "Fourier",
    "Friction",
    "JacobiComplexValues",
    "JacobiValues",
    "OscillatorRegime",
    "Pendulum",
    "Regime",
    "Torque",
    "__version__",
    "action",
    "advance",
    "carlson_rc",
    "carlson_rd",
    "carlson_rf",
    "carlson_rj",
    "complete_e",
    "complete_k",
    "complete_pi",
    "duffing_motion",
    "frequency",
    "from_action_phase",
    "harmonic_distortion",
    "heuman_lambda",
    "incomplete_e",
    "incomplete_f",
    "incomplete_pi",
    "jacobi",
    "jacobi_complex",
    "jacobi_epsilon",
    "jacobi_zeta",
    "motion",
    "nome",
    "phase",
    "sensitivities",
    "theta",
    "theta1",
    "theta2",
    "theta3",
    "theta4",
    "velocity",
]


def __dir__() -> list[str]:
    return [*__all__, "approx", "elliptic", "papers", "plot"]


# Hidden from type checkers, so that a name that does not exist is an error there too.
if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        """The packages that are loaded when they are asked for."""
        if name in ("approx", "papers", "plot"):
            return import_module(f".{name}", __name__)
        raise AttributeError(f"module 'libration' has no attribute {name!r}")
