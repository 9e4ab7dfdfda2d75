"""The damped motion by libration, heyoka and SciPy side by side: measures it and writes docs/benchmarks-damped.md.

    python bench/run_damped.py            measure, write bench/results/damped.json and the page: make bench-damped
    python bench/run_damped.py --page     write the page from the results as they are
    python bench/run_damped.py --check    compare the page with the results as they are

Exit status 1 if libration breaks its promise, or the page is not what the results say.
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"  # read when libration is imported

import argparse
import json
import sys
from pathlib import Path

from measurement.damped import damped_records
from measurement.environment import environment
from report.damped import damped_page
from rivals.damped import OURS

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "bench/results/damped.json"
PAGE = ROOT / "docs/benchmarks-damped.md"
PROMISED = 1e-12


def main() -> int:
    """Measure, then write or compare the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--page", action="store_true", help="write the page from the results as they are")
    parser.add_argument("--check", action="store_true", help="compare the page with the results as they are")
    options = parser.parse_args()
    if not options.check and not options.page:
        held = {**environment("make bench-damped"), "records": damped_records()}
        RESULTS.write_text(json.dumps(held, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    if not RESULTS.is_file():
        raise SystemExit("bench/results/damped.json is missing: make bench-damped")
    held = json.loads(RESULTS.read_text(encoding="utf-8"))
    text = damped_page(held)
    if options.check and (not PAGE.is_file() or PAGE.read_text(encoding="utf-8") != text):
        print("docs/benchmarks-damped.md is not what bench/results says: python bench/run_damped.py --page")
        return 1
    if not options.check:
        PAGE.write_text(text, encoding="utf-8")
    ours = [record for record in held["records"] if record["method"] == OURS]
    if broken := [record["case"] for record in ours if not record["error"] <= PROMISED]:
        print(f"libration breaks its promise: {', '.join(broken)}")
        return 1
    print("docs/benchmarks-damped.md is what bench/results says")
    return 0


if __name__ == "__main__":
    sys.exit(main())
