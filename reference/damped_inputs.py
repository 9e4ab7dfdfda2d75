"""The motions of damped.csv: start, constants, torque, times, and whether derivatives are written."""

import math
import random
from fractions import Fraction

INPUTS = [
    "theta0", "velocity0", "omega2", "linear", "quadratic", "dry", "presliding",
    "constant", "amplitude", "frequency", "phase",
]  # fmt: skip
# Samples of the torque: short numbers, 0.375 s apart from -3 s on.
SAMPLE_TIMES = [Fraction(3 * i, 8) - 3 for i in range(400)]
SAMPLE_VALUES = [Fraction((i * 7) % 11 - 5, 16) for i in range(400)]


def cases():
    """(stratum, inputs, samples, times, whether derivatives are written)."""
    draw = random.Random(20261130)

    def short(low, high, parts=64):
        """A dyadic number, so that inputs and their sums are short."""
        return Fraction(draw.randint(int(low * parts), int(high * parts)), parts)

    def case(stratum, times, slopes=False, kind="", **given):
        inputs = dict.fromkeys(INPUTS, Fraction(0))
        inputs["omega2"] = Fraction(1)
        inputs.update({name: Fraction(value) for name, value in given.items()})
        return stratum, inputs, kind, [Fraction(t) for t in times], slopes

    degrees = [5, 45, 90, 150, 175, 179, 179.9]
    angles = [math.radians(x) for x in degrees]
    laws = {
        "linear": {"linear": 1 / 256},
        "quadratic": {"quadratic": 1 / 64},
        "dry": {"dry": 1 / 1024},
        "mixed": {"linear": 1 / 512, "quadratic": 1 / 128, "dry": 1 / 2048},
        "presliding": {"linear": 1 / 1024, "dry": 1 / 512, "presliding": 1 / 64},
    }
    for law, friction in laws.items():
        for theta0 in angles:
            # A hundred periods of two of them.
            far = [650] if theta0 in (angles[2], angles[6]) else []
            yield case(law, [1, 7.5, 65, *far], theta0=theta0, **friction)
            if theta0 in (angles[0], angles[2], angles[5]):
                yield case(law, [3, 20], True, theta0=theta0, velocity0=0.25, omega2=1.5, **friction)
    # Through turns over the top, both ways, and slowly over it.
    for law, friction in laws.items():
        for velocity0 in (2.5, -4, 12, 2.0625):
            yield case(f"{law}_rotation", [2, 20, 100], theta0=0.5, velocity0=velocity0, **friction)
        yield case(f"{law}_rotation", [1.5, 12], True, theta0=-1, velocity0=3, omega2=2, **friction)
    # Friction that stops the swing: at once, after a turn, after several.
    for dry in (0.5, 0.25, 0.0625, 0.9375):
        for theta0 in (0.25, 1, 2.5):
            yield case("stops", [1, 4, 30], theta0=theta0, dry=dry)
    yield case("stops", [2, 5], True, theta0=2.5, dry=0.25, linear=0.0625)
    yield case("stops", [2, 40], True, theta0=1, velocity0=1.5, dry=0.125, constant=0.25)
    # Stuck and released by a torque that changes.
    for frequency, phase in ((0.25, 0.5), (1.25, 2), (0.75, -1)):
        given = {
            "theta0": 0.5,
            "dry": 0.5,
            "linear": 0.03125,
            "amplitude": 0.9375,
            "frequency": frequency,
            "phase": phase,
        }
        yield case("released", [3, 12, 60], **given)
        yield case("released", [5, 16], True, **given)
    # Bias and drive.
    for constant in (0.5, 0.9375, 1.25):
        yield case("biased", [2, 20, 100], theta0=0.25, constant=constant, linear=0.125)
        yield case("biased", [1, 15], True, theta0=0.25, constant=constant, linear=0.125, dry=0.03125)
    for amplitude, frequency in ((0.5, 0.6875), (1.125, 1.5), (0.25, 8)):
        given = {"theta0": 0.125, "linear": 0.125, "amplitude": amplitude, "frequency": frequency, "phase": 0.75}
        yield case("driven", [2, 20, 80], **given)
        yield case("driven", [1, 15], True, constant=0.25, quadratic=0.0625, **given)
    for kind in ("steps", "lines", "cubics"):
        yield case("samples", [0.5, 6, 60], kind=kind, theta0=1, linear=0.0625)
        yield case("samples", [4, 20], True, kind=kind, theta0=0.5, velocity0=0.5, dry=0.0625, quadratic=0.125)
        yield case("samples", [6, 50], kind=kind, theta0=0.5, dry=0.25)
    # No friction and no torque, friction that drives, no force, and the force upside down.
    yield case("limits", [1, 10, 100], theta0=1, linear=2**-60)
    yield case("limits", [1, 10], True, theta0=2)
    yield case("limits", [1, 10, 20], theta0=0.25, linear=-0.03125)
    yield case("limits", [1, 8], True, theta0=0.25, velocity0=2, omega2=0, linear=0.25, quadratic=0.5, dry=0.125)
    yield case("limits", [1, 8, 40], theta0=0.25, velocity0=0.5, omega2=-1, linear=0.0625)
    for _ in range(8):
        friction = {"linear": short(0, 0.1, 512), "quadratic": short(0, 0.2, 256), "dry": short(0, 0.1, 256)}
        start = {"theta0": short(-3, 3), "velocity0": short(-2, 2), "omega2": short(0.5, 30)}
        yield case("drawn", [short(0.1, 3), short(5, 30)], True, **start, **friction)
