"""Reference values of buckets, from the kinematics of a ring alone; writes vectors/rings.csv. Run: python rings.py.

A particle of the whole energy E + e has the momentum p = sqrt((E + e)**2 - mass**2), the speed c p/(E + e) and the orbit C (1 + alpha
(p/p0 - 1)), so it goes round in T(e). Of it only the derivative T' at e = 0 is used, by differences of many digits. On the average over a
turn e' = -(q V/T0) sin theta and theta' = omega_rf T' e/T0 (with the signs that make the middle stable), so

    omega0**2 = omega_rf abs(T' q) V/T0**2,    e(theta)**2 = 2 abs(q) V (1 + cos theta)/(omega_rf abs(T')) on the separatrix.

`slip` is (p0/T0) (dT/dp), `qs` omega0 T0/2 pi, `height` the largest e of the separatrix as a part of p0, `area` the integral of e over the time
theta/omega_rf, `tune` that of a swing to theta = 2 by its time: integrals by tanh-sinh quadrature. Each value at two precisions that agree to 25
digits. Columns: stratum, the arguments of the ring and its values as hi + lo, in hex.
"""

import csv

import exact
import mpmath as mp
from exact import mpf

NAME = "rings.csv"
GIVEN = "voltage harmonic energy mass charge circumference momentum_compaction".split()
VALUES = "revolution_frequency slip_factor qs omega0 height area tune".split()
HEADER = ["stratum", *GIVEN, *(f"{name}_{part}" for name in VALUES for part in ("hi", "lo"))]
LIGHT = 299_792_458
PROTON, ELECTRON = 938.272_088e6, 510998.95
RINGS = {
    # Far above transition, protons; ions of charge 82 there.
    "large": (8e6, 35640, 450e9, PROTON, 1, 26658.883, 3.225e-4),
    "top": (16e6, 35640, 7e12, PROTON, 1, 26658.883, 3.225e-4),
    "ions": (8e6, 35640, 82 * 450e9, 193.687e9, 82, 26658.883, 3.225e-4),
    # Below transition, and slow: 1/gamma**2 is nearly 1.
    "booster": (8e3, 1, PROTON + 160e6, PROTON, 1, 157.08, 0.0595),
    "slow": (500.0, 2, PROTON + 1e4, PROTON, 1, 20.0, 0.4),
    # Next to transition, on both sides.
    "near_above": (1e5, 84, 26e9, PROTON, 1, 628.3185, 0.001302318),
    "near_below": (1e5, 84, 26e9, PROTON, 1, 628.3185, 0.001302262),
    # Electrons; an orbit that is shorter at a larger momentum.
    "electrons": (2e6, 400, 3e9, ELECTRON, -1, 500.0, 1e-3),
    "negative": (2e6, 400, 3e9, ELECTRON, -1, 500.0, -1e-3),
}


def inputs():
    for stratum, numbers in RINGS.items():
        yield {"stratum": stratum, **{name: float(each).hex() for name, each in zip(GIVEN, numbers, strict=True)}}


def values(numbers):
    """The values of a ring, by name, at the working precision."""
    voltage, harmonic, energy, mass, charge, circumference, compaction = map(mpf, numbers)

    def momentum(e):
        return mp.sqrt((energy + e) ** 2 - mass**2)

    def turn(e):
        p = momentum(e)
        return circumference * (1 + compaction * (p / momentum(0) - 1)) * (energy + e) / (p * LIGHT)

    # The kinetic energy is what the derivatives vary with.
    step = (energy - mass) * mpf(10) ** -(mp.mp.dps // 3)
    first = (turn(step) - turn(-step)) / (2 * step)
    second = (turn(step / 2) - turn(-step / 2)) / step
    # The two leave out step**2 and a quarter of it.
    slope = (4 * second - first) / 3
    of_momentum = (momentum(step) - momentum(-step)) / (2 * step)
    of_momentum = (4 * (momentum(step / 2) - momentum(-step / 2)) / step - of_momentum) / 3
    period = turn(0)
    radio = 2 * mp.pi * harmonic / period
    force = abs(charge) * voltage
    omega0 = mp.sqrt(radio * abs(slope) * force) / period

    def separatrix(theta):
        return mp.sqrt(2 * force * (1 + mp.cos(theta)) / (radio * abs(slope)))

    def inverse_speed(theta):
        # theta' of a swing to 2, by its energy.
        return 1 / mp.sqrt(2 * (mp.cos(theta) - mp.cos(2)))

    quarter = mp.quad(inverse_speed, [0, 1, 2]) / omega0
    return {
        "revolution_frequency": 1 / period,
        "slip_factor": slope / of_momentum * momentum(0) / period,
        "qs": omega0 * period / (2 * mp.pi),
        "omega0": omega0,
        "height": separatrix(0) * of_momentum / momentum(0),
        "area": 2 * mp.quad(separatrix, [-mp.pi, 0, mp.pi]) / radio,
        "tune": period / (4 * quarter),
    }


def row(given):
    numbers = [float.fromhex(given[name]) for name in GIVEN]
    with mp.workdps(150):
        once = values(numbers)
    with mp.workdps(190):
        again = values(numbers)
    found = [given[name] for name in ("stratum", *GIVEN)]
    with mp.workdps(60):
        for name in VALUES:
            if exact.agreement(once[name], again[name]) > mpf(10) ** -25:
                raise SystemExit(f"reference: {given['stratum']} {name}: two precisions do not agree to 25 digits")
            found += exact.hi_lo(+again[name])
    return found


if __name__ == "__main__":
    with (exact.VECTORS / NAME).open("w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(HEADER)
        for given in inputs():
            out.writerow(row(given))
