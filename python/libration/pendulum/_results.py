"""What the results of the pendulum are called where arrays carry labels."""

from .._labels import Result

THETA = Result("theta", "rad", "angle")
VELOCITY = Result("velocity", "rad/s", "angular velocity")
MOTION = THETA, VELOCITY
TURNS = Result("n", "1", "whole turns"), Result("angle", "rad", "angle beyond whole turns")
PHASE = Result("phase", "rad", "phase")
ACTION = Result("action", "rad**2/s", "action per unit inertia")
FREQUENCY = Result("frequency", "rad/s", "mean angular frequency")
DISTORTION = Result("harmonic_distortion", "1", "harmonic distortion of the angle")
# The units differ from element to element.
SENSITIVITIES = Result("sensitivities", None, "derivatives of the state by start and force")
SECOND_SENSITIVITIES = Result("second_sensitivities", None, "second derivatives of the state by start and force")
