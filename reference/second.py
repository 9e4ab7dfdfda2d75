"""Reference values for the second derivatives of angle and velocity; writes vectors/second.csv.

Central differences, at 200 digits and more, of the first derivatives of orbit.py, on orbits away from rest and from the
separatrix. Columns `d2theta_ij`, `d2velocity_ij` with i <= j of 0 theta0, 1 velocity0, 2 omega0 (20 digits, decimal).
Run: python second.py (half a minute).
"""

from fractions import Fraction

import exact
import mpmath as mp
import orbit
from exact import decimal, mpf, real

NAME = "second.csv"
PAIRS = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]
HEADER = "id stratum theta0 velocity0 omega0 t".split()
HEADER += [f"d2{of}_{i}{j}" for of in ("theta", "velocity") for i, j in PAIRS]
STEP = Fraction(1, 2**200)


def first(theta0, velocity0, omega0, t):
    """Derivatives of angle and velocity by theta0, velocity0, omega0."""
    _, _, D = orbit.evaluate(theta0, velocity0, omega0 * omega0, t)
    twice = 2 * real(omega0)
    return [[D[0], D[1], twice * D[2]], [D[3], D[4], twice * D[5]]]


def row(inputs):
    given = [Fraction(float.fromhex(inputs[name])) for name in HEADER[2:6]]
    digits = orbit.first_digits(*given[:2], given[2] ** 2, given[3]) + 150
    with mp.workdps(digits):
        slopes = []
        for j in range(3):
            sides = []
            for sign in (1, -1):
                moved = list(given)
                moved[j] += sign * STEP
                sides.append(first(*moved))
            slopes.append(
                [[(a - b) / (2 * real(STEP)) for a, b in zip(*of, strict=True)] for of in zip(*sides, strict=True)]
            )
        values = [slopes[j][of][i] for of in range(2) for i, j in PAIRS]
        mirrored = [slopes[i][of][j] for of in range(2) for i, j in PAIRS]
        worst = max(abs(a - b) / (1 + abs(a)) for a, b in zip(values, mirrored, strict=True))
        assert worst < mpf(10) ** -60, worst
        return [*(inputs[name] for name in HEADER[:6]), *(decimal(+value, 20) for value in values)]


def inputs():
    """Librations and rotations of both senses, to 300 periods, reproducible."""
    state = 12345
    for stratum, count in [
        ("libration", 60),
        ("rotation", 40),
        ("gentle", 20),
        ("steep", 20),
        ("least", 20),
        ("nearest", 20),
    ]:
        for i in range(count):
            parts = []
            for _ in range(4):
                state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
                parts.append((state >> 11) / 2**53)
            a, b, c, d = parts
            omega0 = 0.5 + 3 * c
            theta0, velocity0 = {
                "libration": (2 * (2 * a - 1), omega0 * (2 * b - 1) / 2),
                "rotation": (3 * (2 * a - 1), omega0 * (2.5 + 3 * b) * (1 if i % 2 else -1)),
                "gentle": (0.02 * (2 * a - 1), omega0 * 0.02 * (2 * b - 1)),
                "least": (4e-5 * (a + 1), omega0 * 4e-5 * (b - 0.5)),
                "nearest": (1e-4 * (2 * a - 1), omega0 * (2 + (2e-6 + 1e-6 * b) * (1 if i % 2 else -1))),
                "steep": (0.3 * (2 * a - 1), omega0 * (1.9 + 0.3 * b)),
            }[stratum]
            t = (2 * d - 1) * (10 if i % 3 else 300) / omega0
            yield dict(
                zip(
                    HEADER[:6],
                    [f"sec-{stratum}-{i}", stratum, *(value.hex() for value in (theta0, velocity0, omega0, t))],
                    strict=True,
                )
            )


if __name__ == "__main__":
    exact.write(NAME, HEADER, map(row, inputs()))
