"""Checks vectors/duffing.csv and vectors/cubic_quintic.csv, as check.py does the others. Run: python oscillator_check.py

Every row must agree with the addition on an elliptic curve in balls (curve.py), the conditions of a sample with
central differences of it; a seeded sample is derived again and must be the same text; spoiled rows must fail.
"""

import argparse
import random

import cubic_quintic
import curve
import duffing
import exact
from check import counted, fail, spoiled

SAMPLES = {duffing: 40, cubic_quintic: 20}


def main(everything=False, seed=1):
    rng = random.Random(seed)
    readme = (exact.ROOM / "README.md").read_text()
    for module, size in SAMPLES.items():
        name = module.NAME
        rows = exact.read(exact.VECTORS / name)
        if list(rows[0]) != module.HEADER:
            fail(name, "columns differ from the generator's")
        if counted(name, rows) not in readme:
            fail("README.md lacks the line", counted(name, rows))
        given = module.inputs()
        if [{key: row[key] for key in given[0]} for row in rows] != given:
            fail(name, "inputs are not what the generator draws")
        sample = rows if everything else rng.sample(rows, size)
        again = module.all_rows(sample) if everything else map(module.row, sample)
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
            for column, bad in spoiled(row):
                if not curve.wrong(bad) + curve.slopes_wrong(bad):
                    fail(name, "a spoiled", column, "passes")
        print(f"{name}: {len(rows)} rows, {len(sample)} derived again", flush=True)


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--all", action="store_true")
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    main(chosen.all, chosen.seed)
