"""From bench/results/elliptic.json to docs/elliptic.md: domain, worst error and time of libration, SciPy, ellippy and mpmath."""

import statistics
from pathlib import Path

from measurement.elliptic_family import COUNT, LIMIT, PROMISED
from rivals.elliptic_family import functions

from .tables import number, table


def cells(record: dict | None, nanoseconds: list[float] | None) -> list[str]:
    """Rows asked, rows without answer, wrong rows, worst error and time of one library."""
    if record is None:
        return [""] * 5
    if record["asked"] == 0:
        return ["0", "", "", "", median(nanoseconds)]
    worst = number(record["worst"]) if record["asked"] > record["none"] + record["wrong"] else ""
    return [
        f"{record['asked']:,}",
        *(f"{record[x]:,}" if record[x] else "" for x in ("none", "wrong")),
        worst,
        median(nanoseconds),
    ]


def median(nanoseconds: list[float] | None) -> str:
    """The median as the page prints it."""
    return number(statistics.median(nanoseconds)) if nanoseconds else ""


def errors(records: list[dict]) -> str:
    """The table of errors and times."""
    head = ["function", "rows", "worst", "ns, one m", "ns, each its m"]
    for library in ("SciPy", "ellippy", "mpmath"):
        head += [f"{library}: rows", "no answer", "wrong", "worst", "ns"]
    body = []
    for record in records:
        ours, taken = record["ours"], record["times"]
        line = [f"`{record['name']}`", f"{ours['rows']:,}", number(ours["worst"])]
        line += [median(taken.get("ours, one parameter")), median(taken["ours"])]
        for library in ("scipy", "ellippy", "mpmath"):
            line += cells(record.get(library), taken.get(library))
        body.append(line)
    return table(head, body)


def slower(records: list[dict]) -> str:
    """The functions that another library computes faster for arrays, each value with its own parameter."""
    found = []
    for record in records:
        taken = {name: statistics.median(each) for name, each in record["times"].items() if each}
        others = [taken[name] for name in ("scipy", "ellippy") if name in taken]
        if others and min(others) < taken["ours"]:
            found.append(f"`{record['name']}`")
    return ", ".join(found) or "none"


def domains() -> str:
    """The table of domains."""
    body = []
    for function in functions():
        theirs = [
            rival.domain if rival else "not there" for rival in (function.scipy, function.ellippy, function.mpmath)
        ]
        body.append([f"`{function.name}`", function.domain, *theirs])
    return table(["function", "libration", "SciPy", "ellippy", "mpmath"], body, (0, 1, 2, 3, 4))


def page(held: dict) -> str:
    """The page, whole."""
    versions = held["versions"]
    parts = {
        **{name: held[name] for name in ("date", "command", "processor", "system")},
        "load": str(held["load at the start"]),
        "versions": ", ".join(
            f"{name} {versions[name]}"
            for name in ("libration", "Python", "numpy", "scipy", "ellippy", "mpmath")
            if name in versions
        ),
        "errors": errors(held["records"]),
        "slower": slower(held["records"]),
        "domains": domains(),
        "count": f"{COUNT:,}",
        "promised": str(PROMISED),
        "limit": str(LIMIT),
    }
    text = Path(__file__).with_name("elliptic.md.in").read_text(encoding="utf-8")
    for place, part in parts.items():
        text = text.replace("{" + place + "}", part)
    return text
