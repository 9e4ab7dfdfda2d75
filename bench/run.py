"""The benchmark of the motion: every section, its raw rounds into bench/results/, then the pages of docs/ and their pictures.

    python bench/run.py                     what `make bench` runs
    python bench/run.py --full              more horizons, orbits and slow rivals to their limit: `make bench-full`
    python bench/run.py --page              write the pages from the results as they are
    python bench/run.py --check             compare the pages with the results as they are; the pictures are left alone
    python bench/run.py orbits steps        these sections only; no page, because its sections must be of one run
    python bench/run.py calls --out FOLDER  results into FOLDER instead, to try something out

Exit status 1 if a target (report/targets.py) is missed, or a page is not what the results say.
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"  # read when libration is imported; threads.py sets its own
os.environ["RAYON_NUM_THREADS"] = "1"  # read by ellippy, which takes all cores otherwise

import argparse
import json
import sys
import time
from pathlib import Path

from measurement.environment import environment
from measurement.sections import SECTIONS, plain_json
from report import benchmarks


def main() -> int:
    """Run the sections, write their results, and the pages if all of them ran."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sections", nargs="*", metavar="section", help=", ".join(SECTIONS))
    parser.add_argument("--full", action="store_true", help="more horizons and orbits, slow rivals to their limit")
    parser.add_argument("--page", action="store_true", help="write the pages from the results as they are")
    parser.add_argument("--check", action="store_true", help="compare the pages with the results as they are")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="results into this folder, and no page")
    options = parser.parse_args()
    if unknown := set(options.sections) - set(SECTIONS):
        parser.error(f"no section {', '.join(sorted(unknown))}: {', '.join(SECTIONS)}")
    if options.check or options.page:
        return benchmarks.check() if options.check else benchmarks.write()
    folder = options.out or benchmarks.RESULTS
    folder.mkdir(parents=True, exist_ok=True)
    head, begun = environment("make bench-full" if options.full else "make bench"), time.monotonic()
    for name in options.sections or SECTIONS:
        print(f"{name}: {SECTIONS[name].__doc__}", flush=True)
        started = time.monotonic()
        records = SECTIONS[name](options.full)
        held = {"section": name, **head, "minutes": round((time.monotonic() - started) / 60, 2), "records": records}
        text = json.dumps(plain_json(held), ensure_ascii=False, indent=1)
        (folder / f"{name}.json").write_text(text + "\n", encoding="utf-8")
    print(f"{(time.monotonic() - begun) / 60:.1f} minutes")
    return 0 if options.sections or options.out else benchmarks.write()


if __name__ == "__main__":
    sys.exit(main())
