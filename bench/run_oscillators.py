"""The oscillators beside the pendulum: measures set-ups, motions and rows, and writes docs/benchmarks-oscillators.md.

python bench/run_oscillators.py            measure, write bench/results/oscillators.json and the page: make bench-oscillators
python bench/run_oscillators.py --show     measure, and print the page
python bench/run_oscillators.py --page     write the page from the results as they are
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"  # read when libration is imported

import argparse
import json
import statistics
import sys
from pathlib import Path

from measurement.environment import environment
from measurement.oscillators import SETUP, works
from measurement.timing import rounds
from report.tables import number, table

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "bench/results/oscillators.json"
PAGE = ROOT / "docs/benchmarks-oscillators.md"
COMMAND = "make bench-oscillators"


def measured() -> list[dict]:
    """A record for each call: nanoseconds of one, and its ratio to the peer's."""
    found, peers = works()
    calls = {name: call for name, (_, call) in peers.items()}
    seconds = rounds(calls | {f"{work.kind}: {work.case}": work.call for work in found})
    each = {name: [1e9 * taken / count for taken in seconds[name]] for name, (count, _) in peers.items()}
    records = []
    for work in found:
        own = [1e9 * taken / work.count for taken in seconds[f"{work.kind}: {work.case}"]]
        ratio = statistics.median(a / b for a, b in zip(own, each[work.peer], strict=True)) if work.peer else None
        theirs = statistics.median(each[work.peer]) if work.peer else None
        records.append(
            {"kind": work.kind, "case": work.case, "nanoseconds": statistics.median(own), "peer": work.peer}
            | {"theirs": theirs, "ratio": ratio, "limit": work.limit}
        )
    return records


def page(held: dict) -> str:
    """The page, whole."""
    body = []
    for record in held["records"]:
        alone = record["kind"] == SETUP
        against = record["nanoseconds"] if alone else record["ratio"]
        limit = f"{record['limit']:g} ns" if alone else f"{record['limit']:g}"
        body.append(
            [record["kind"], record["case"], number(record["nanoseconds"]), record["peer"]]
            + ["" if alone else number(record["theirs"]), "" if alone else number(record["ratio"])]
            + [limit, "yes" if against <= record["limit"] else "**no**"]
        )
    head = ["work", "oscillator", "ns", "beside", "ns", "ratio", "limit", "met"]
    return f"""# Oscillators beside the pendulum

Written by `{held["command"]}` on {held["date"]}. Processor: {held["processor"]}; load {held["load at the start"]} at the start.

One thread, from Python. A *set-up* is one object; a *motion* is one oscillator at 16,384 times, displacement and velocity, a time of each;
*rows* have starts and coefficients of their own. Times are medians of the rounds; ratios are medians of the ratios within rounds.

{table(head, body, (0, 1, 3, 7))}
"""


def main() -> int:
    """Measure, then write or print the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--show", action="store_true", help="measure, and print the page")
    parser.add_argument("--page", action="store_true", help="write the page from the results as they are")
    options = parser.parse_args()
    held = json.loads(RESULTS.read_text(encoding="utf-8")) if options.page else None
    if held is None:
        held = {**environment(COMMAND), "records": measured()}
        if options.show:
            print(page(held))
            return 0
        RESULTS.write_text(json.dumps(held, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(page(held), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
