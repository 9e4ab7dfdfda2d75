"""The exact nonlinear pendulum, in every regime, right to the last digits.

``Pendulum`` is one orbit and answers at any time; ``DampedPendulum`` has friction and torque, ``fit`` finds
both and g in measurements; ``theta``, ``velocity``, ``motion`` and ``advance`` work on arrays of
states; ``jacobi``, ``complete_k`` and the rest are the elliptic functions behind them, all of which are in
``libration.elliptic``; ``approx`` holds the approximations by name, ``libration.ensemble`` bunches of many
pendulums, ``libration.jax`` and ``libration.torch`` motions with derivatives for JAX and PyTorch, and
``libration.papers`` three papers worked through.
Angles are in radians, everything else in SI units.

Examples
--------
>>> import libration
>>> f"{libration.Pendulum(3.0, length=1.0, gravity=9.8).theta(10.0):.6f}"
'2.922419'
"""

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import approx as approx
    from . import elliptic as elliptic
    from . import ensemble as ensemble
    from . import jax as jax
    from . import measurement as measurement
    from . import oscillator as oscillator
    from . import papers as papers
    from . import pendulum as pendulum
    from . import plot as plot
    from . import torch as torch
    from ._cite import cite
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
        from_nome,
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
    from .measurement import (
        Estimate,
        Fit,
        Together,
        fit,
        fit_together,
        gravity_of_period,
        gravity_of_pivots,
        normal_gravity,
    )
    from .oscillator import (
        CubicQuintic,
        Duffing,
        DuffingForm,
        OscillatorFourier,
        OscillatorRegime,
        cubic_quintic_action,
        cubic_quintic_escape_times,
        cubic_quintic_frequency,
        cubic_quintic_motion,
        cubic_quintic_period,
        cubic_quintic_phase,
        cubic_quintic_regime,
        duffing_action,
        duffing_escape_times,
        duffing_frequency,
        duffing_motion,
        duffing_period,
        duffing_phase,
        duffing_regime,
    )
    from .pendulum import (
        Fourier,
        Pendulum,
        Regime,
        action,
        advance,
        energy,
        energy_ratio,
        energy_ratio_c,
        frequency,
        from_action_phase,
        harmonic_distortion,
        motion,
        next_crossing,
        period,
        phase,
        regime,
        sensitivities,
        theta,
        theta_max,
        turns,
        uncertain_motion,
        uncertain_period,
        velocity,
    )

__all__ = [
    "CubicQuintic",
    "DampedPendulum",
    "Duffing",
    "DuffingForm",
    "Estimate",
    "Fit",
    "Fourier",
    "Friction",
    "JacobiComplexValues",
    "JacobiValues",
    "OscillatorFourier",
    "OscillatorRegime",
    "Pendulum",
    "Regime",
    "Together",
    "Torque",
    "__version__",
    "action",
    "advance",
    "carlson_rc",
    "carlson_rd",
    "carlson_rf",
    "carlson_rj",
    "cite",
    "complete_e",
    "complete_k",
    "complete_pi",
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
    "energy",
    "energy_ratio",
    "energy_ratio_c",
    "fit",
    "fit_together",
    "frequency",
    "from_action_phase",
    "from_nome",
    "gravity_of_period",
    "gravity_of_pivots",
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
    "next_crossing",
    "nome",
    "normal_gravity",
    "period",
    "phase",
    "regime",
    "sensitivities",
    "theta",
    "theta1",
    "theta2",
    "theta3",
    "theta4",
    "theta_max",
    "turns",
    "uncertain_motion",
    "uncertain_period",
    "velocity",
]


# The packages whose names are those of this one, the lightest first.
_ROOMS = ("_cite", "pendulum", "damped", "oscillator", "elliptic", "measurement")


def __dir__() -> list[str]:
    return [*__all__, "approx", "elliptic", "ensemble", "jax", "papers", "plot"]


if "LIBRATION_NUM_THREADS" in os.environ:
    # The core reads it and refuses a bad number; that is due at once.
    import_module("._core", __name__)

# Hidden from type checkers, so that a name that does not exist is an error there too.
if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        """A public name or a package, loaded when it is asked for: `libration --help` does not wait for NumPy."""
        if name == "__version__":
            found = import_module("._core", __name__).__version__
        elif name in __all__:
            rooms = (import_module(f".{room}", __name__) for room in _ROOMS)
            found = getattr(next(room for room in rooms if name in room.__all__), name)
        elif name in (*_ROOMS, "approx", "ensemble", "jax", "papers", "plot", "torch"):
            found = import_module(f".{name}", __name__)
        else:
            elliptic = import_module(".elliptic", __name__)
            if name in elliptic.__all__:
                raise AttributeError(f"module 'libration' has no attribute {name!r}: did you mean elliptic.{name}?")
            raise import_module("._messages", __name__).no_member("libration", name)
        globals()[name] = found
        return found
