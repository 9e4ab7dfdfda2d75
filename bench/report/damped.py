"""From bench/results/damped.json to docs/benchmarks-damped.md: error and time of the damped motion by every method."""

import statistics
from pathlib import Path

from cases.damped import HORIZON
from rivals.damped import OURS

from .tables import error, number, table


def damped_table(records: list[dict], few: int, many: int) -> str:
    """One case: a row a method."""
    body = []
    seconds = {(record["method"], record["count"]): record["seconds"] for record in records}
    for name in dict.fromkeys(record["method"] for record in records):
        mine = [record for record in records if record["method"] == name]
        line = [name]
        if mine[0]["error"] is None:
            body.append([name, mine[0]["note"], "", "", "", ""])
            continue
        line.append(error(max(record["error"] for record in mine)))
        for count in (few, many):
            taken, base = seconds[name, count], seconds[OURS, count]
            line.append(number(statistics.median(taken) * 1e6 / mine[0]["periods"]))
            line.append(number(statistics.median(a / b for a, b in zip(taken, base, strict=True))))
        body.append(line)
    head = ["method", "error", f"µs a period, {few} times", "ratio", f"µs a period, {many:,} times", "ratio"]
    return table(head, body)


def damped_page(held: dict) -> str:
    """The page, whole."""
    records = held["records"]
    few, many = sorted({record["count"] for record in records})
    tables = []
    for case in dict.fromkeys(record["case"] for record in records):
        mine = [record for record in records if record["case"] == case]
        tables.append(
            f"## {case[0].upper()}{case[1:]}, {mine[0]['periods']:g} periods\n\n{damped_table(mine, few, many)}"
        )
    versions = held["versions"]
    parts = {
        **{name: held[name] for name in ("date", "command", "processor", "system")},
        "load": str(held["load at the start"]),
        "versions": ", ".join(
            f"{name} {versions[name]}" for name in ("libration", "Python", "numpy", "scipy", "heyoka")
        ),
        "horizon": f"{HORIZON:g} and more",
        "few": str(few),
        "many": f"{many:,}",
        "tables": "\n\n".join(tables),
    }
    text = Path(__file__).with_name("damped.md.in").read_text(encoding="utf-8")
    for place, part in parts.items():
        text = text.replace("{" + place + "}", part)
    return text
