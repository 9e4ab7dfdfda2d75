"""Checks vectors/bunches.csv: a row derived again, and every row by the Fourier series of the angle in place of a quadrature.

The mean square angle of a libration is 32 sum q**n/(n (1 + q**n))**2 over odd n. Mutated rows must fail. Called by check.py.
"""

import bunches
import exact
import mpmath as mp
from table import counted, fail

FILES = {"bunches.csv": 1}


def by_series(shape, scale):
    """The rms angle to some 17 digits."""
    with mp.workdps(22):
        scale = mp.mpf(scale)
        top = bunches.energy_ratio(scale * bunches.LAST if shape == "gaussian" else scale)

        def square(m):
            q = mp.qfrom(m=m)
            total, n = mp.mpf(0), 1
            while q**n > mp.eps * n:
                total += 32 * q**n / (n * (1 + q**n)) ** 2
                n += 2
            return total

        def over(weight):
            def at(m):
                return bunches.density(shape, bunches.action(m) / scale) * mp.ellipk(m) * weight(m)

            return mp.quad(at, [0, top / 8, top])

        return mp.sqrt(over(square) / over(lambda m: 1))


def contradicts(row, true):
    value = sum(mp.mpf(float.fromhex(row[f"rms_{part}"])) for part in ("hi", "lo"))
    return not abs(value / true - 1) < 1e-16


def check(name, every, rng):
    """Fails at the first row that is not what it should be; says how many are."""
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != bunches.HEADER or counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail(name, "columns differ, or README.md lacks the line", counted(name, rows))
    if [{key: row[key] for key in ("stratum", "scale")} for row in rows] != list(bunches.inputs()):
        fail(name, "inputs are not what the generator draws")
    sample = rows if every else rng.sample(rows, FILES[name])
    for row in sample:
        if bunches.row(row) != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    for row in rows:
        with mp.workdps(30):
            true = by_series(row["stratum"], float.fromhex(row["scale"]))
            moved = float.fromhex(row["rms_hi"]) * (1 + 2.0**-51)
            if contradicts(row, true):
                fail(name, "the series contradicts", row)
            if not contradicts({**row, "rms_hi": moved.hex()}, true):
                fail(name, "a mutated row passes:", row)
    return f"{len(rows)} rows, {len(sample)} derived again"
