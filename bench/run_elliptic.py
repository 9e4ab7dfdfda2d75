"""The elliptic functions of libration, SciPy, ellippy and mpmath side by side: measures them and writes docs/elliptic.md.

    python bench/run_elliptic.py            measure, write bench/results/elliptic.json and the page: make bench-elliptic
    python bench/run_elliptic.py --page     write the page from the results as they are
    python bench/run_elliptic.py --check    compare the page with the results as they are

Exit status 1 if libration breaks its promise, or the page is not what the results say.
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"  # read when libration is imported
os.environ["RAYON_NUM_THREADS"] = "1"  # read by ellippy, which takes all cores otherwise

import argparse
import json
import sys
from pathlib import Path

from measurement.elliptic_family import records
from measurement.environment import environment
from report.elliptic_family import page

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "bench/results/elliptic.json"
PAGE = ROOT / "docs/elliptic.md"


def main() -> int:
    """Measure, then write or compare the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--page", action="store_true", help="write the page from the results as they are")
    parser.add_argument("--check", action="store_true", help="compare the page with the results as they are")
    options = parser.parse_args()
    if not options.check and not options.page:
        held = {**environment("make bench-elliptic"), "records": records()}
        text = json.dumps(held, ensure_ascii=False, indent=1)
        RESULTS.write_text(text.replace("Infinity", "1e999") + "\n", encoding="utf-8")
    if not RESULTS.is_file():
        raise SystemExit("bench/results/elliptic.json is missing: make bench-elliptic")
    held = json.loads(RESULTS.read_text(encoding="utf-8"))
    text = page(held)
    if options.check and (not PAGE.is_file() or PAGE.read_text(encoding="utf-8") != text):
        print("docs/elliptic.md is not what bench/results says: python bench/run_elliptic.py --page")
        return 1
    if not options.check:
        PAGE.write_text(text, encoding="utf-8")
    if broken := [record["name"] for record in held["records"] if record["ours"]["within"] < record["ours"]["rows"]]:
        print(f"libration breaks its promise: {', '.join(broken)}")
        return 1
    print("docs/elliptic.md is what bench/results says")
    return 0


if __name__ == "__main__":
    sys.exit(main())
