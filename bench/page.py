"""Writes docs/benchmarks.md, docs/benchmarks-orbits.md and their pictures from bench/results/: nothing by hand.

python bench/page.py            write the page, exit 1 if a demand is missed
python bench/page.py --check    compare the page with the results as they stand instead; the pictures are left alone
"""

import json
import statistics
import sys
from pathlib import Path

import demands
import pictures
from cases import ORBITS
from rivals.ours import THETA
from timing import ratio

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "bench/results"
PAGES = ("benchmarks.md", "benchmarks-orbits.md")
SHOWN = ("150°", "170°")
SECTIONS = ("digits", "calls", "orbits", "sizes", "horizons", "span", "far", "states", "steps", "threads")


def results() -> dict[str, dict]:
    """The sections as they stand; one that is missing, or of another run, is an error."""
    found = {}
    for name in SECTIONS:
        path = RESULTS / f"{name}.json"
        if not path.is_file():
            raise SystemExit(f"{path.relative_to(ROOT)} is missing: make bench")
        found[name] = json.loads(path.read_text(encoding="utf-8"))
    if len({(held["date"], held["command"]) for held in found.values()}) > 1:
        raise SystemExit("bench/results holds sections of different runs: make bench")
    return found


def number(value: float) -> str:
    """Three digits, in plain notation with thousands apart where that is short."""
    if value >= 1e6 or 0 < value < 1e-3:
        return f"{value:.2g}".replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def error(value: float | str) -> str:
    """A worst error as the page prints it."""
    value = float(value)
    return f"{value:.0e}".replace("e+0", "e").replace("e-0", "e-").replace("e+", "e") if value < float("inf") else "inf"


def table(head: list[str], body: list[list[str]], words: tuple[int, ...] = (0,)) -> str:
    """A table of a page; columns of `words` to the left, numbers to the right."""
    rule = ["---" if place in words else "---:" for place in range(len(head))]
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, rule, *body])


def nanoseconds(record: dict) -> float:
    """Median nanoseconds per sample."""
    return statistics.median(record["seconds"]) / record["count"] * 1e9


def against(records: list[dict], first: str = THETA.name) -> str:
    """Everybody's nanoseconds, ratio to the way `first`, and worst errors, one row each."""
    [ours] = [record for record in records if record["way"] == first]
    body = []
    for record in records:
        if not record["seconds"]:
            body.append([record["way"], "", "", "", "", record["note"]])
            continue
        if record["count"] == ours["count"]:
            times = ratio(record["seconds"], ours["seconds"])
        else:
            times = nanoseconds(record) / nanoseconds(ours)
        notes = [record["note"]] + (["one call"] if len(record["seconds"]) == 1 else [])
        errors = [*map(error, record["errors"]), "", ""][:2]
        body.append(
            [record["way"], number(nanoseconds(record)), number(times), *errors, ", ".join(filter(None, notes))]
        )
    head = ["way", "ns per sample", "times ours", "worst error θ", "worst error θ̇", ""]
    return table(head, body, (0, 5))


def judged(held: dict[str, dict]) -> str:
    """The table of demands."""
    body = []
    for demand in demands.demands(held):
        case, worst = demand.worst
        asked = number(demand.asked) if demand.asked >= 0.1 else f"1/{1 / demand.asked:.0f}"
        measured = f"1/{1 / worst:.1f}" if demand.asked < 0.1 and worst < 1 else number(worst)
        body.append([demand.work, measured, case, asked, "yes" if demand.holds else "**no**"])
    return table(["work, ours / theirs", "measured", "worst at", "asked, at most", "holds"], body, (0, 2, 4))


def by_orbit(records: list[dict], names: tuple[str, ...]) -> str:
    """A table for each of the orbits."""
    tables = [(name, against([record for record in records if record["case"] == name])) for name in names]
    return "\n\n".join(f"### {name}\n\n{text}" for name, text in tables)


def matrix(records: list[dict], column: str, name) -> str:
    """Nanoseconds per sample and worst error of θ: a row for every way, a column for every value of `column`."""
    values = list(dict.fromkeys(record["asked"] for record in named(records, column)))
    ways = list(dict.fromkeys(record["way"] for record in records))
    cells = {(record["way"], record["asked"]): record for record in named(records, column)}
    body = []
    for way in ways:
        line = [way]
        for value in values:
            record = cells.get((way, value))
            if record is None or not record["seconds"]:
                line.append(record["note"] if record else "")
            else:
                fewer = "" if record["full"] else f" ({record['count']:,} samples)"
                line.append(f"{number(nanoseconds(record))} ns, {error(record['errors'][0])}{fewer}")
        body.append(line)
    return table(["way", *map(name, values)], body)


def named(records: list[dict], column: str) -> list[dict]:
    """Records with what was asked of everybody beside what one of them did."""
    asked, found = 0, []
    for record in records:
        if record["way"] == THETA.name:
            asked = record["count"]
        value = asked if column == "count" else record[column]
        found.append({**record, "asked": value, "full": record["count"] == asked})
    return found


def spread(records: list[dict]) -> str:
    """Near and far, sorted and in random order."""
    body = []
    for record in records:
        errors = [*map(error, record["errors"]), ""][:2]
        where = [record["case"], record["way"], f"{record['periods']:g}".replace("e+0", "e"), record["order"]]
        body.append([*where, number(nanoseconds(record)) if record["seconds"] else record["note"], *errors])
    head = ["orbit", "way", "periods", "order", "ns per sample", "worst error θ", "worst error θ̇"]
    return table(head, body, (0, 1, 3))


def both(records: list[dict]) -> str:
    """One thread and two."""
    body = []
    for record in records:
        one, two = (statistics.median(record["seconds"][key]) / record["count"] * 1e9 for key in "12")
        times = ratio(record["seconds"]["2"], record["seconds"]["1"])
        body.append([record["case"], f"{record['count']:,}", number(one), number(two), number(times)])
    return table(["work", "samples", "ns, one thread", "ns, two threads", "two / one"], body)


def small_calls(records: list[dict]) -> str:
    """A call of a thousand samples over the kernel alone."""
    body = []
    for record in records:
        micro = statistics.median(record["seconds"]["1000"]) * 1e6
        times = demands.kernel(record)
        body.append([record["case"], number(micro), number(micro / times), number(times)])
    return table(["orbit", "µs for 1,000 samples", "µs of the kernel alone", "ratio"], body)


def pages(held: dict[str, dict]) -> dict[str, str]:
    """The pages by name, whole."""
    head = held["orbits"]
    versions = ", ".join(f"{name} {value}" for name, value in head["versions"].items())
    minutes = sum(section["minutes"] for section in held.values())
    parts = {
        "date": head["date"],
        "command": head["command"],
        "minutes": f"{minutes:.0f}",
        "processor": f"{head['processor']} ({head['processors available']} available)",
        "load": str(head["load at the start"]),
        "system": head["system"],
        "versions": versions,
        "demands": judged(held),
        "orbits": by_orbit(held["orbits"]["records"], SHOWN),
        "others": by_orbit(held["orbits"]["records"], tuple(o.name for o in ORBITS if o.name not in SHOWN)),
        "states": against(held["states"]["records"], held["states"]["records"][0]["way"]),
        "steps": against(held["steps"]["records"], held["steps"]["records"][0]["way"]),
        "sizes": matrix(held["sizes"]["records"], "count", lambda count: f"{count:,}"),
        "horizons": matrix(held["horizons"]["records"], "periods", lambda p: f"{p:,.0f} periods"),
        "far": spread(held["far"]["records"]),
        "digits": against(held["digits"]["records"]),
        "calls": small_calls(held["calls"]["records"]),
        "threads": both(held["threads"]["records"]),
        "standard": held["sizes"]["records"][0]["case"],
    }
    written = {}
    for name in PAGES:
        written[name] = Path(__file__).with_name(f"{name}.in").read_text(encoding="utf-8")
        for place, part in parts.items():
            written[name] = written[name].replace("{" + place + "}", part)
    return written


def main() -> int:
    """Write or compare; the demands decide the exit status of writing, staleness that of comparing."""
    held = results()
    stale = []
    for name, text in pages(held).items():
        path = ROOT / "docs" / name
        if "--check" not in sys.argv[1:]:
            path.write_text(text, encoding="utf-8")
        elif not path.is_file() or path.read_text(encoding="utf-8") != text:
            stale.append(f"docs/{name} is not what bench/results says: python bench/page.py")
    if "--check" in sys.argv[1:]:
        print("\n".join(stale) or "the pages are what bench/results says")
        return bool(stale)
    pictures.draw(held, ROOT / "docs")
    print(judged(held))
    return not all(demand.holds for demand in demands.demands(held))


if __name__ == "__main__":
    sys.exit(main())
