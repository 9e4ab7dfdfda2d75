"""From bench/results/ensemble.json to docs/benchmarks-ensembles.md: a bunch turn by turn, a million particles, sums and stores."""

import statistics
from pathlib import Path

from rivals.turns import OURS

from .tables import error, number, table

# The error at which ways are compared.
WANTED = 1e-10
SINES = "NumPy: a sine and a cosine"


def nanoseconds(held: dict) -> dict[str, list[float]]:
    """By way, of those that could be had."""
    return {each["way"]: each["nanoseconds"] for each in held["turns"] if each["nanoseconds"]}


def ratio(theirs: list[float], ours: list[float]) -> float:
    """The median of the ratios within rounds."""
    return statistics.median(a / b for a, b in zip(theirs, ours, strict=True))


def turns_table(held: dict) -> str:
    """A row a way."""
    taken, body = nanoseconds(held), []
    for each in held["turns"]:
        name = each["way"]
        if each["note"]:
            body.append([name, each["note"], "", ""])
            continue
        found = "" if each["error"] is None else error(each["error"])
        body.append([name, found, number(statistics.median(taken[name])), number(ratio(taken[name], taken[OURS]))])
    return table(["way", "error, rad", "ns a particle and turn", "of `advance`"], body)


def million_table(held: dict) -> str:
    """A row for one thread and for two."""
    body = []
    for each in held["million"]:
        jump, turn = (statistics.median(row[0] for row in each[name]) for name in ("jump", "one turn"))
        sines = statistics.median(row[0] for row in each["sine and cosine"])
        states = each["particles"]
        body.append(
            [
                str(each["threads"]),
                number(each["track"][0]),
                number(each["track"][1]),
                number(each["track"][1] / states / each["turns"] * 1e9),
                number(jump),
                number(turn / states * 1e9),
                number(turn / sines),
            ]
        )
    head = ["threads", "all turns, s", "of the processor, s", "ns a particle and turn", "one jump, s"]
    return table([*head, "`advance`, ns", "over a sine and a cosine"], body, words=())


def runs_table(held: dict) -> str:
    """Sums and the store."""
    sums, store = held["runs"]["sums"], held["runs"]["store"]
    seconds, processor, memory = (
        statistics.median(each[name] for each in sums) for name in ("seconds", "processor", "memory")
    )
    body = [
        [
            f"{sums[0]['states']:.0e} states summed by two workers".replace("e+0", "e"),
            number(seconds),
            number(processor),
            f"{memory / 1e6:.0f} MB over all processes",
        ]
    ]
    for name, words in (("zarr", "10⁷ × 10 states into a store"), ("np.save", "the same by `np.save`")):
        taken = [statistics.median(row[part] for row in store[name]) for part in (0, 1)]
        body.append([words, number(taken[0]), number(taken[1]), f"{store['bytes'] / 1e6:.0f} MB"])
    return table(["run", "s", "of the processor, s", ""], body)


def promises(held: dict) -> list[tuple[str, str, bool]]:
    """What is asked, what was found, and whether it holds: of the parts that were measured."""
    found = []
    for name, told in (("turns", of_turns), ("million", of_a_million), ("runs", of_runs)):
        if name in held:
            found += told(held)
    return found


def of_turns(held: dict) -> list[tuple[str, str, bool]]:
    """Turn by turn."""
    taken, found = nanoseconds(held), []
    errors = {each["way"]: each["error"] for each in held["turns"] if each["nanoseconds"]}
    for kind, least in (("NumPy: order 8", 12.0), ("heyoka", 10.0)):
        good = [name for name in taken if name.startswith(kind) and errors[name] <= WANTED]
        if not good:
            found.append((f"turn by turn at {WANTED:.0e}: {least:g} × cheaper than {kind}", "none is there", False))
            continue
        best = min(good, key=lambda name: statistics.median(taken[name]))
        times = ratio(taken[best], taken[OURS])
        found.append(
            (f"turn by turn at {WANTED:.0e}: {least:g} × cheaper than {best}", f"{times:.1f} ×", times >= least)
        )
    return found


def of_a_million(held: dict) -> list[tuple[str, str, bool]]:
    """A million particles."""
    found = []
    for each, most in zip(held["million"], (55.0, 30.0), strict=True):
        seconds = each["track"][0]
        words = f"10⁶ particles × 1,000 turns, {each['threads']} thread{'s' * (each['threads'] > 1)}: {most:g} s"
        found.append((words, f"{seconds:.1f} s", seconds <= most))
    one = held["million"][0]
    names = "jump", "one turn", "sine and cosine"
    jump, turn, sines = (statistics.median(row[0] for row in one[name]) for name in names)
    found.append(("one jump over all turns, 1 thread: 0.07 s", f"{jump:.3f} s", jump <= 0.07))
    found.append(("`advance`: 2 × a sine and a cosine", f"{turn / sines:.2f} ×", turn <= 2 * sines))
    return found


def of_runs(held: dict) -> list[tuple[str, str, bool]]:
    """Sums and the store."""
    sums, store = held["runs"]["sums"], held["runs"]["store"]
    seconds = statistics.median(each["seconds"] for each in sums)
    memory = max(each["memory"] for each in sums)
    times = statistics.median(a[0] / b[0] for a, b in zip(store["zarr"], store["np.save"], strict=True))
    return [
        ("10⁸ states summed by two workers: 10 s", f"{seconds:.1f} s", seconds <= 10),
        ("the same: 400 MB over all processes", f"{memory / 1e6:.0f} MB", memory <= 400e6),
        ("10⁷ × 10 states into a store: 2 × `np.save`", f"{times:.2f} ×", times <= 2),
    ]


TABLES = {"turns": turns_table, "million": million_table, "runs": runs_table}
MISSING = "Not measured yet: `python bench/run_ensemble.py {}` adds it."


def ensemble_page(held: dict) -> str:
    """The page, whole."""
    versions = held["versions"]
    told = [[what, found, "yes" if holds else "no"] for what, found, holds in promises(held)]
    parts = {
        **{name: held[name] for name in ("date", "command", "processor", "system")},
        "load": str(held["load at the start"]),
        "versions": ", ".join(
            f"{name} {versions[name]}" for name in ("libration", "Python", "numpy", "heyoka", "zarr")
        ),
        "promises": table(["promise", "found", "holds"], told, words=(0, 2)),
        **{name: of(held) if name in held else MISSING.format(name) for name, of in TABLES.items()},
    }
    text = Path(__file__).with_name("ensemble.md.in").read_text(encoding="utf-8")
    for place, part in parts.items():
        text = text.replace("{" + place + "}", part)
    return text
