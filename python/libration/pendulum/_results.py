"""What the results of the pendulum are called where arrays carry labels."""

from .._labels import Result

THETA = Result("theta", "rad", "angle")
VELOCITY = Result("velocity", "rad/s", "angular velocity")
MOTION = THETA, VELOCITY
TURNS = Result("n", "1", "whole turns"), Result("angle", "rad", "angle beyond whole turns")
PHASE = Result("phase", "rad", "phase")
ACTION = Result("action", "rad**2/s", "action per unit inertia")
FREQUENCY = Result("frequency", "rad/s", "mean angular frequency")
PERIOD = Result("period", "s", "period")
THETA_MAX = Result("theta_max", "rad", "turning angle")
ENERGY = Result("energy", "rad**2/s**2", "energy per unit inertia")
ENERGY_RATIO = Result("energy_ratio", "1", "energy over that at the top")
ENERGY_RATIO_C = Result("energy_ratio_c", "1", "complement of the energy ratio")
REGIME = Result("regime", None, "kind of motion")
CROSSING = Result("next_crossing", "s", "time of the next crossing")
DISTORTION = Result("harmonic_distortion", "1", "harmonic distortion of the angle")
# The units differ from element to element.
SENSITIVITIES = Result("sensitivities", None, "derivatives of the state by start and force")
SECOND_SENSITIVITIES = Result("second_sensitivities", None, "second derivatives of the state by start and force")
