"""The targets on every processor that was measured: the newest run of each is kept in bench/results/processors.json."""

import json
from pathlib import Path

from .tables import number, table
from .targets import Target, targets

RUNS = Path(__file__).resolve().parents[1] / "results/processors.json"


def ratio_text(value: float, limit: float) -> str:
    """A ratio, as one over a number where its limit is below a tenth."""
    return f"1/{1 / value:.3g}" if limit < 0.1 and value < 1 else number(value)


def entry(target: Target, processor: str) -> dict:
    """What is kept of a target: where it was worst, how much, and how much was allowed."""
    case, worst = target.worst
    return {"case": case, "measured": worst, "limit": target.limit, "allowed": target.allowed(processor)}


def kept(held: dict[str, dict]) -> list[dict]:
    """The runs by processor, this run first in place of the one of its processor before it."""
    head = held["orbits"]
    processor = head["processor"]
    run = {"processor": processor, "date": head["date"], "command": head["command"]}
    run["targets"] = {target.work: entry(target, processor) for target in targets(held)}
    before = json.loads(RUNS.read_text(encoding="utf-8")) if RUNS.is_file() else []
    return [run, *(other for other in before if other["processor"] != processor)]


def cell(found: dict | None) -> str:
    """The worst ratio and where it was; in bold where it misses its limit."""
    if found is None:
        return ""
    text = ratio_text(found["measured"], found["limit"])
    return f"{text if found['measured'] <= found['allowed'] else f'**{text}**'} ({found['case']})"


def by_processor(runs: list[dict]) -> str:
    """The table of targets, a column for each processor."""
    head = [f"{run['processor']}: {run['date'].split()[0]}" for run in runs]
    body = []
    for work, found in runs[0]["targets"].items():
        limit = ratio_text(found["limit"], found["limit"])
        body.append([work, limit, *(cell(run["targets"].get(work)) for run in runs)])
    return table(["work, ours / theirs", "limit", *head], body, (0, *range(2, 2 + len(runs))))


def missed(held: dict[str, dict]) -> list[str]:
    """A line for each target that this run misses."""
    return [
        f"{work}: {ratio_text(found['measured'], found['limit'])} at {found['case']}, limit {found['allowed']:.3g}"
        for work, found in kept(held)[0]["targets"].items()
        if not found["measured"] <= found["allowed"]
    ]
