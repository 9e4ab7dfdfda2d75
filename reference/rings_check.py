"""Checks vectors/rings.csv: a row derived again, and every value by the formulas of the books in place of kinematics and integrals.

qs = sqrt(h abs(eta q) V/(2 pi beta**2 E)), height = 2 qs/(h abs(eta)), area = 16 qs beta**2 E/(2 pi f0 h**2 abs(eta)), tune = qs pi/(2 K(sin(1)**2)).
Source: Lee, Accelerator Physics (2019), section 3.II. Mutated rows must fail. Called by check.py.
"""

import exact
import mpmath as mp
import rings
from table import counted, fail

FILES = {"rings.csv": 1}


def by_formulas(numbers):
    """The values of a ring, by name."""
    voltage, harmonic, energy, mass, charge, circumference, compaction = map(mp.mpf, numbers)
    beta2 = 1 - (mass / energy) ** 2
    turns = mp.sqrt(beta2) * rings.LIGHT / circumference
    slip = compaction - (mass / energy) ** 2
    qs = mp.sqrt(harmonic * abs(slip * charge) * voltage / (2 * mp.pi * beta2 * energy))
    return {
        "revolution_frequency": turns,
        "slip_factor": slip,
        "qs": qs,
        "omega0": 2 * mp.pi * qs * turns,
        "height": 2 * qs / (harmonic * abs(slip)),
        "area": 16 * qs * beta2 * energy / (2 * mp.pi * turns * harmonic**2 * abs(slip)),
        "tune": qs * mp.pi / (2 * mp.ellipk(mp.sin(1) ** 2)),
    }


def contradicts(row, name, true):
    value = sum(mp.mpf(float.fromhex(row[f"{name}_{part}"])) for part in ("hi", "lo"))
    return not abs(value / true - 1) < 1e-25


def check(name, every, rng):
    """Fails at the first row that is not what it should be; says how many are."""
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != rings.HEADER or counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail(name, "columns differ, or README.md lacks the line", counted(name, rows))
    if [{key: row[key] for key in ("stratum", *rings.GIVEN)} for row in rows] != list(rings.inputs()):
        fail(name, "inputs are not what the generator draws")
    sample = rows if every else rng.sample(rows, FILES[name])
    for row in sample:
        if rings.row(row) != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    for row in rows:
        with mp.workdps(50):
            true = by_formulas([float.fromhex(row[each]) for each in rings.GIVEN])
            for value in rings.VALUES:
                moved = float.fromhex(row[f"{value}_lo"]) * (1 + 2.0**-20)
                if contradicts(row, value, true[value]):
                    fail(name, f"the formula of {value} contradicts", row)
                if not contradicts({**row, f"{value}_lo": moved.hex()}, value, true[value]):
                    fail(name, "a mutated row passes:", row)
    return f"{len(rows)} rows, {len(sample)} derived again"
