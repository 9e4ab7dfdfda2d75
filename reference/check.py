"""Checks vectors/*.csv: every file by itself, a process for each processor; exits with an error at the first difference.

Run: python check.py [FILE ...] [--all] [--seed N]. Row counts must be those of README.md, a seeded sample of every
file is derived again, every row must agree with another method, and mutated rows must fail: see rows_check.py,
oscillator_check.py, helmholtz_duffing_check.py, oscillator_rows_check.py, approx_check.py, bunches_check.py, rings_check.py. --all takes
every row as the sample and draws all inputs again.
"""

import argparse
import random
import time
from concurrent.futures import ProcessPoolExecutor, as_completed

import approx_check
import bunches_check
import damped_check
import exact
import helmholtz_duffing_check
import oscillator_check
import oscillator_rows_check
import rings_check
import rows_check

CHECKS = {
    # The longest ones first, so that no processor is idle at the end.
    **dict.fromkeys(oscillator_check.SAMPLES, oscillator_check.check),
    **dict.fromkeys(helmholtz_duffing_check.FILES, helmholtz_duffing_check.check),
    **dict.fromkeys(oscillator_rows_check.FILES, oscillator_rows_check.check),
    **dict.fromkeys(rows_check.GENERATORS, rows_check.check),
    **dict.fromkeys(approx_check.FILES, approx_check.check),
    **dict.fromkeys(damped_check.FILES, damped_check.check),
    **dict.fromkeys(bunches_check.FILES, bunches_check.check),
    **dict.fromkeys(rings_check.FILES, rings_check.check),
}


def check(name, every, seed):
    """Checks one file. Each file has its own seed, so that its sample is the same alone and among all files."""
    begun = time.process_time()
    said = CHECKS[name](name, every, random.Random(f"{seed} {name}"))
    return f"{name}: {said}, {time.process_time() - begun:.0f} s"


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("files", nargs="*", metavar="FILE", help="names in vectors/, all without")
    options.add_argument("--all", action="store_true")
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    if unknown := sorted({path.name for path in exact.VECTORS.glob("*.csv")} ^ set(CHECKS)):
        raise SystemExit(f"reference: no check, or no file: {', '.join(unknown)}")
    if unknown := sorted(set(chosen.files) - set(CHECKS)):
        raise SystemExit(f"reference: {unknown[0]}: must be one of {', '.join(CHECKS)}")
    with ProcessPoolExecutor() as pool:
        names = chosen.files or list(CHECKS)
        waiting = [pool.submit(check, name, chosen.all, chosen.seed) for name in names]
        try:
            for done in as_completed(waiting):
                print(done.result(), flush=True)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


if __name__ == "__main__":
    main()
