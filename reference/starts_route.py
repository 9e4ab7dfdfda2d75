"""The check of starts.csv by other formulas than those of starts.py.

The period from m and 1 - m by Gauss's mean, the energy at the start and at t, and what was stated, each from the columns
as written, hi + lo. Where a difference of columns cancels, what the last of the 106 bits makes of it is allowed.
"""

import mpmath as mp
from exact import mpf

TOLERANCE = mpf(2) ** -98


def written(row, name):
    hi, lo = (float.fromhex(row[f"{name}_{part}"]) for part in ("hi", "lo"))
    return mpf(hi) + mpf(lo)


def wrong(row):
    """The columns of a row that contradict each other or what was stated."""
    if row["regime"] not in ("libration", "rotation"):
        return []
    with mp.workdps(400):
        m, mc, period, energy = (written(row, x) for x in ("energy_ratio", "energy_ratio_c", "period", "energy"))
        value, omega2 = (mpf(float.fromhex(row[x])) for x in ("value", "omega2"))
        omega = mp.sqrt(abs(omega2))
        if abs(mc) < mpf(10) ** -280 or m < mpf(10) ** -280:
            return []  # lo has no bits left
        if row["regime"] == "libration":
            expected = 2 * mp.pi / (omega * mp.agm(1, mp.sqrt(mc)))
        else:
            expected = mp.pi / (omega * mp.agm(mp.sqrt(m), mp.sqrt(-mc)))
        found = [] if abs(period - expected) <= expected * TOLERANCE else ["period"]
        if abs(energy - 2 * omega**2 * m) > energy * TOLERANCE:
            found.append("energy")
        if abs(m + mc - 1) > (m + abs(mc)) * TOLERANCE:
            found.append("energy_ratio")
        stated = {"energy_ratio": m, "energy_ratio_c": mc, "energy": energy, "period": period}
        stated |= {"period_of_rotation": period, "theta_max": written(row, "theta_max")}
        if row["known"] in stated and abs(stated[row["known"]] - value) > abs(value) * TOLERANCE:
            found.append(row["known"])
        for angle, speed in (("theta0", "velocity0"), ("theta", "velocity")):
            theta, velocity = written(row, angle), written(row, speed)
            top = mp.cos(theta / 2) ** 2 if omega2 > 0 else mp.sin(theta / 2) ** 2
            kinetic = velocity**2 / (4 * omega**2)
            # sin and cos of the rounded angle are off by its last bit.
            allowed = TOLERANCE * (kinetic + top + abs(mc)) + abs(theta) * TOLERANCE * mp.sqrt(top)
            if abs(kinetic - top + mc) > allowed + (abs(theta) * TOLERANCE) ** 2:
                found.append(speed)
        return found
