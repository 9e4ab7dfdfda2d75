"""From bench/results/ to docs/benchmarks.md, docs/benchmarks-orbits.md and their pictures: no number is typed by hand."""

import json
import statistics
from pathlib import Path

from cases.orbits import ORBITS
from measurement.sections import SECTIONS
from measurement.timing import ratio
from rivals.ours import THETA

from . import pictures
from .processors import RUNS, by_processor, kept, missed
from .tables import error, number, table
from .targets import kernel

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "bench/results"
PAGES = ("benchmarks.md", "benchmarks-orbits.md")
SHOWN = ("150°", "170°")


def results() -> dict[str, dict]:
    """The sections by name. One that is missing, or of another run, is an error."""
    found = {}
    for name in SECTIONS:
        path = RESULTS / f"{name}.json"
        if not path.is_file():
            raise SystemExit(f"{path.relative_to(ROOT)} is missing: make bench")
        found[name] = json.loads(path.read_text(encoding="utf-8"))
    if len({(held["date"], held["command"]) for held in found.values()}) > 1:
        raise SystemExit("bench/results holds sections of different runs: make bench")
    return found


def nanoseconds(record: dict) -> float:
    """Median nanoseconds per sample."""
    return statistics.median(record["seconds"]) / record["count"] * 1e9


def against(records: list[dict], first: str = THETA.name) -> str:
    """Nanoseconds of every method, ratio to the method `first`, and worst errors, one row each."""
    [ours] = [record for record in records if record["method"] == first]
    body = []
    for record in records:
        if not record["seconds"]:
            body.append([record["method"], "", "", "", "", record["note"]])
            continue
        if record["count"] == ours["count"]:
            times = ratio(record["seconds"], ours["seconds"])
        else:
            times = nanoseconds(record) / nanoseconds(ours)
        notes = [record["note"]] + (["one call"] if len(record["seconds"]) == 1 else [])
        errors = [*map(error, record["errors"]), "", ""][:2]
        body.append(
            [record["method"], number(nanoseconds(record)), number(times), *errors, ", ".join(filter(None, notes))]
        )
    head = ["method", "ns per sample", "times ours", "worst error θ", "worst error θ̇", ""]
    return table(head, body, (0, 5))


def by_orbit(records: list[dict], names: tuple[str, ...], heading: str) -> str:
    """A table for each of the orbits, under a heading of that level."""
    tables = [(name, against([record for record in records if record["case"] == name])) for name in names]
    return "\n\n".join(f"{heading} {name}\n\n{text}" for name, text in tables)


def matrix(records: list[dict], column: str, name) -> str:
    """Nanoseconds per sample and worst error of θ: a row for every method, a column for every value of `column`."""
    values = list(dict.fromkeys(record["asked"] for record in named(records, column)))
    methods = list(dict.fromkeys(record["method"] for record in records))
    cells = {(record["method"], record["asked"]): record for record in named(records, column)}
    body = []
    for method in methods:
        line = [method]
        for value in values:
            record = cells.get((method, value))
            if record is None or not record["seconds"]:
                line.append(record["note"] if record else "")
            else:
                fewer = "" if record["full"] else f" ({record['count']:,} samples)"
                line.append(f"{number(nanoseconds(record))} ns, {error(record['errors'][0])}{fewer}")
        body.append(line)
    return table(["method", *map(name, values)], body)


def named(records: list[dict], column: str) -> list[dict]:
    """Records with what was asked of every method beside what each of them did."""
    asked, found = 0, []
    for record in records:
        if record["method"] == THETA.name:
            asked = record["count"]
        value = asked if column == "count" else record[column]
        found.append({**record, "asked": value, "full": record["count"] == asked})
    return found


def long_times(records: list[dict]) -> str:
    """Ten and 1e9 periods, sorted and in random order."""
    body = []
    for record in records:
        errors = [*map(error, record["errors"]), ""][:2]
        where = [record["case"], record["method"], f"{record['periods']:g}".replace("e+0", "e"), record["order"]]
        body.append([*where, number(nanoseconds(record)) if record["seconds"] else record["note"], *errors])
    head = ["orbit", "method", "periods", "order", "ns per sample", "worst error θ", "worst error θ̇"]
    return table(head, body, (0, 1, 3))


def column_table(records: list[dict]) -> str:
    """Functions of columns beside their peers, nanoseconds a row."""
    body = []
    for record in records:
        ours, theirs = (statistics.median(taken) * 1e9 for taken in record["seconds"].values())
        times = ratio(*record["seconds"].values())
        body.append(
            [record["case"], number(ours), record["peer"], number(theirs), number(times), number(record["limit"])]
        )
    return table(["function", "ns", "beside", "ns", "ratio", "limit"], body, (0, 2))


def thread_table(records: list[dict]) -> str:
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
        times = kernel(record)
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
        "targets": by_processor(kept(held)),
        "orbits": by_orbit(held["orbits"]["records"], SHOWN, "###"),
        "others": by_orbit(held["orbits"]["records"], tuple(o.name for o in ORBITS if o.name not in SHOWN), "##"),
        "states": against(held["states"]["records"], held["states"]["records"][0]["method"]),
        "steps": against(held["steps"]["records"], held["steps"]["records"][0]["method"]),
        "sizes": matrix(held["sizes"]["records"], "count", lambda count: f"{count:,}"),
        "horizons": matrix(held["horizons"]["records"], "periods", lambda p: f"{p:,.0f} periods"),
        "long_times": long_times(held["long_times"]["records"]),
        "digits": against(held["digits"]["records"]),
        "calls": small_calls(held["calls"]["records"]),
        "columns": column_table(held["columns"]["records"]),
        "threads": thread_table(held["threads"]["records"]),
        "standard": held["sizes"]["records"][0]["case"],
    }
    written = {}
    for name in PAGES:
        written[name] = Path(__file__).with_name(f"{name}.in").read_text(encoding="utf-8")
        for place, part in parts.items():
            written[name] = written[name].replace("{" + place + "}", part)
    return written


def check() -> int:
    """1 if a page is not what the results say."""
    written = pages(results())
    found = {name: ROOT / "docs" / name for name in written}
    stale = [name for name, path in found.items() if not path.is_file() or path.read_text("utf-8") != written[name]]
    lines = [f"docs/{name} is not what bench/results says: python bench/run.py --page" for name in stale]
    print("\n".join(lines) or "the pages are what bench/results says")
    return bool(stale)


def write() -> int:
    """Write the pages and pictures; 1 if a target is missed."""
    held = results()
    RUNS.write_text(json.dumps(kept(held), ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    for name, text in pages(held).items():
        (ROOT / "docs" / name).write_text(text, encoding="utf-8")
    pictures.draw(held, ROOT / "docs")
    lines = missed(held)
    print("\n".join(lines) or "every target is met")
    return bool(lines)
