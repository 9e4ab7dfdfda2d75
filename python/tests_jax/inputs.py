"""Motions in every stratum of the truth's inputs, and the derivatives of periods by mpmath."""

import csv
import math
from pathlib import Path

import mpmath
import numpy as np

VECTORS = Path(__file__).parents[2] / "reference/vectors/pendulum.csv"
SECOND = VECTORS.with_name("second.csv")


def rows(dtype):
    """Time, angle, velocity and omega0 of up to 1,000 periods, rounded to floats that a product of two fits as well."""
    found = []
    for row in csv.DictReader(VECTORS.open(encoding="utf-8")):
        t, theta0, velocity0, omega2 = (float.fromhex(row[name]) for name in ("t", "theta0", "velocity0", "omega2"))
        state = (t, theta0, velocity0, math.sqrt(max(omega2, 0.0)))
        if omega2 > 0 and not abs(t) > 1000 * float.fromhex(row["period_hi"]):
            found.append(state)
    found = np.array(found, dtype)
    if dtype == np.float32:
        large = np.abs(found)
        found = found[(large < 1e15).all(1) & ((large > 1e-12) | (found == 0)).all(1) & (large[:, 1] < 1e6)]
    return found


def second_derivatives():
    """Time, angle, velocity and omega0 of the rows of reference/second.py, and the second derivatives of angle and velocity."""
    given, slopes = [], []
    for row in csv.DictReader(SECOND.open(encoding="utf-8")):
        given.append([float.fromhex(row[name]) for name in ("t", "theta0", "velocity0", "omega0")])
        pairs = [[f"{min(i, j)}{max(i, j)}" for j in range(3)] for i in range(3)]
        slopes.append(
            [[[float(row[f"d2{of}_{pair}"]) for pair in line] for line in pairs] for of in ("theta", "velocity")]
        )
    return np.array(given), np.array(slopes)


def period_slopes(theta, velocity, omega0):
    """The derivatives of the period of a state, by differences of 60 digits."""

    def period(theta, velocity, omega0):
        m = mpmath.sin(theta / 2) ** 2 + (velocity / (2 * omega0)) ** 2
        return 4 * mpmath.ellipk(m) / omega0 if m < 1 else 2 * mpmath.ellipk(1 / m) / (omega0 * mpmath.sqrt(m))

    with mpmath.workdps(60):
        state = [mpmath.mpf(float(each)) for each in (theta, velocity, omega0)]
        return [float(mpmath.diff(period, state, order)) for order in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]


def states_of_periods():
    """Librations and rotations, some of them next to the separatrix."""
    rng = np.random.default_rng(4)
    theta, velocity, omega0 = (rng.uniform(*ends, 40) for ends in ((-3, 3), (-4, 4), (0.5, 2)))
    near = (
        2
        * omega0[:8]
        * np.cos(theta[:8] / 2)
        * (1 + np.array([1, -1, 1, -1, 1, -1, 1, -1]) * 10.0 ** -np.arange(2, 10))
    )
    return theta, np.concatenate([near, velocity[8:]]), omega0
