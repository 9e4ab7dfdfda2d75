"""True angles and velocities for a sample of the inputs, in Arb balls, by the flow map of reference/balls.py.

Runs in a process of its own that knows neither libration nor NumPy: it reads lines `theta0 velocity0 t` of hexadecimal
floats (omega0 = 1, each taken as an exact rational) and writes `theta_hi theta_lo velocity_hi velocity_lo` for each.

    python bench/truth.py < inputs > truths
"""

import sys
from fractions import Fraction
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1] / "reference")

from balls import pendulum_values, rising  # noqa: E402  (the room reference/ is put on the path first)


def hi_lo(value) -> tuple[str, str]:
    """The double nearest to a narrow ball, and the one nearest to the rest."""
    hi = float(value.mid())
    return hi.hex(), float((value - hi).mid()).hex()


def main() -> None:
    """Answer every line; a ball that stays too wide is an error, never an answer."""
    for line in sys.stdin:
        theta0, velocity0, t = (Fraction(float.fromhex(word)) for word in line.split())
        # an instant at which nothing has happened yet, or rest, holds exact zeros: no relative width to wait for
        if t == 0 or theta0 == velocity0 == 0:
            print(*(float(x).hex() for x in (theta0, 0, velocity0, 0)))
            continue
        values = rising(lambda inputs=(theta0, velocity0, Fraction(1), t): motion(*inputs))
        print(*hi_lo(values["theta"]), *hi_lo(values["velocity"]))


def motion(*inputs: Fraction) -> dict:
    """Angle and velocity alone: the widths of other outputs do not matter."""
    values = pendulum_values(*inputs)
    return {name: values[name] for name in ("theta", "velocity")}


if __name__ == "__main__":
    main()
