"""Ensembles in figures, beside NumPy and heyoka: measures them and writes docs/benchmarks-ensembles.md.

    python bench/run_ensemble.py            measure, write bench/results/ensemble.json and the page: make bench-ensemble
    python bench/run_ensemble.py PART ...   measure these again, into the same file: turns, million, runs
    python bench/run_ensemble.py --page     write the page from the results as they are
    python bench/run_ensemble.py --check    compare the page with the results as they are
    python bench/run_ensemble.py --kills    twenty kills of a run at random moments, each resumed and compared byte by byte

The promises stand on the page; whether one holds depends on the machine and on
what else it does. Exit status 1 if libration is not as accurate as promised, or the page is not what the results say.
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"  # read when libration is imported

import argparse
import json
import sys
import tempfile
from pathlib import Path

from measurement.ensemble import PARTS, ensemble_records
from measurement.ensemble_runs import killed
from measurement.environment import environment
from report.ensemble import ensemble_page
from rivals.turns import OURS

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "bench/results/ensemble.json"
PAGE = ROOT / "docs/benchmarks-ensembles.md"
PROMISED = 1e-10


def main() -> int:
    """Measure, then write or compare the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", choices=[[], *PARTS], help="what to measure, all by default")
    for name, words in (
        ("page", "write the page from the results as they are"),
        ("check", "compare the page with the results as they are"),
        ("kills", "kill runs at random moments and resume them"),
    ):
        parser.add_argument(f"--{name}", action="store_true", help=words)
    options = parser.parse_args()
    if options.kills:
        with tempfile.TemporaryDirectory() as place:
            found = killed(Path(place))
        print(json.dumps(found))
        return int(found["alike"] < found["kills"])
    if not options.check and not options.page:
        kept = options.parts and RESULTS.is_file()
        before = json.loads(RESULTS.read_text(encoding="utf-8")) if kept else {}
        held = {**before, **environment("make bench-ensemble"), **ensemble_records(options.parts or PARTS)}
        RESULTS.write_text(json.dumps(held, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    if not RESULTS.is_file():
        raise SystemExit("bench/results/ensemble.json is missing: make bench-ensemble")
    held = json.loads(RESULTS.read_text(encoding="utf-8"))
    text = ensemble_page(held)
    if options.check and (not PAGE.is_file() or PAGE.read_text(encoding="utf-8") != text):
        print("docs/benchmarks-ensembles.md is not what bench/results says: python bench/run_ensemble.py --page")
        return 1
    if not options.check:
        PAGE.write_text(text, encoding="utf-8")
    if not all(each["error"] <= PROMISED for each in held.get("turns", []) if each["way"] == OURS):
        print("libration is not as accurate as promised")
        return 1
    print("docs/benchmarks-ensembles.md is what bench/results says")
    return 0


if __name__ == "__main__":
    sys.exit(main())
