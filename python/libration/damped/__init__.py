"""The pendulum with friction and torque: integrated to full double precision, with its derivatives.

theta'' + 2 linear theta' + quadratic abs(theta') theta' + dry sgn(theta') + omega0**2 sin(theta) = torque(t)

Examples
--------
>>> import libration
>>> friction = libration.Friction(linear=0.02, dry=0.01)
>>> f"{libration.DampedPendulum(1.0, friction=friction).theta(30.0):.9f}"
'-0.274804241'
"""

from ._friction import Friction
from ._laws import averaged_energy_loss, averaged_turning_angle, averaged_turning_rate, half_swing
from ._pendulum import DampedPendulum
from ._torque import Torque

__all__ = [
    "DampedPendulum",
    "Friction",
    "Torque",
    "averaged_energy_loss",
    "averaged_turning_angle",
    "averaged_turning_rate",
    "half_swing",
]
