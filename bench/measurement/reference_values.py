"""Exact angles and velocities for a sample of the inputs, in Arb balls, by the addition theorem of reference/balls.py.

Runs in a process of its own, which imports neither libration nor NumPy. It reads lines `theta0 velocity0 t` of hexadecimal
floats (omega0 = 1, each taken as an exact rational). It writes `theta_hi theta_lo velocity_hi velocity_lo` for each.

    python bench/measurement/reference_values.py < inputs > values
"""

import sys
from fractions import Fraction
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[2] / "reference")

from balls import narrowed, pendulum_values  # noqa: E402  (reference/ is put on the path first)


def hi_lo(value) -> tuple[str, str]:
    """The double nearest to a narrow ball, and the one nearest to the rest."""
    hi = float(value.mid())
    return hi.hex(), float((value - hi).mid()).hex()


def main() -> None:
    """Answer every line. A ball that stays too wide is an error, never an answer."""
    for line in sys.stdin:
        theta0, velocity0, t = (Fraction(float.fromhex(word)) for word in line.split())
        # at t = 0 and at rest the values are exact, zeros among them: a zero has no relative width
        if t == 0 or theta0 == velocity0 == 0:
            print(*(float(x).hex() for x in (theta0, 0, velocity0, 0)))
            continue
        values = narrowed(lambda inputs=(theta0, velocity0, Fraction(1), t): motion(*inputs))
        print(*hi_lo(values["theta"]), *hi_lo(values["velocity"]))


def motion(*inputs: Fraction) -> dict:
    """Angle and velocity alone: the widths of other outputs do not matter."""
    values = pendulum_values(*inputs)
    return {name: values[name] for name in ("theta", "velocity")}


if __name__ == "__main__":
    main()
