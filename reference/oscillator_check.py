"""Checks vectors/duffing.csv and vectors/cubic_quintic.csv, as rows_check.py does the others. Called by check.py.

Every row must agree with the addition on an elliptic curve in balls (curve.py), the conditions of a sample with
central differences of it; a seeded sample is derived again and must be the same text; mutated rows must fail.
"""

import cubic_quintic
import curve
import duffing
import exact
from table import counted, fail, mutated

SAMPLES = {duffing.NAME: (duffing, 20), cubic_quintic.NAME: (cubic_quintic, 10)}


def check(name, every, rng):
    """Fails at the first row of a file that is not what it should be; says how many are."""
    module, size = SAMPLES[name]
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != module.HEADER:
        fail(name, "columns differ from the generator's")
    if counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail("README.md lacks the line", counted(name, rows))
    given = module.inputs()
    if [{key: row[key] for key in given[0]} for row in rows] != given:
        fail(name, "inputs are not what the generator draws")
    sample = rows if every else rng.sample(rows, size)
    again = module.all_rows(sample) if every else map(module.row, sample)
    for row, texts in zip(sample, again, strict=True):
        if [str(text) for text in texts] != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    for row in rows:
        if found := curve.wrong(row):
            fail(name, "the curve contradicts", found, row)
    for row in sample:
        if found := curve.slopes_wrong(row):
            fail(name, "differences contradict", found, row)
    for regime in ("libration", "well", "escape"):
        row = next(row for row in rows if row["regime"] == regime and row["u_lo"] != "0x0.0p+0")
        for column, bad in mutated(row):
            if not curve.wrong(bad) + curve.slopes_wrong(bad):
                fail(name, "a mutated", column, "passes")
    return f"{len(rows)} rows, {len(sample)} derived again"
