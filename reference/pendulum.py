"""Writes vectors/pendulum.csv: the exact motion for every row of inputs/pendulum.csv, by mpmath (orbit.py).

The 1998 inputs in 16 strata are frozen as hex floats, so that no random generator or host logarithm
can move them; this script derives everything else. Run: python pendulum.py (about half a minute).
"""

from fractions import Fraction

import exact
import orbit

NAME = "pendulum.csv"
INPUTS = "id stratum theta0 velocity0 omega2 t".split()
HEADER = ["id", "stratum", "regime", *INPUTS[2:], *orbit.OUTPUTS[1:]]


def row(inputs):
    """One row of the file from its input columns."""
    theta0, velocity0, omega2, t = (float.fromhex(inputs[name]) for name in INPUTS[2:])
    regime, *outputs = orbit.outputs(theta0, velocity0, Fraction(omega2), t)
    return [inputs["id"], inputs["stratum"], regime, *(inputs[name] for name in INPUTS[2:]), *outputs]


if __name__ == "__main__":
    exact.write(NAME, HEADER, map(row, exact.read(exact.ROOM / "inputs" / NAME)))
