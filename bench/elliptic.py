"""The elliptic functions of libration, SciPy and mpmath side by side: domain, worst error, time. Writes docs/elliptic.md.

Errors are in the unit of functions.toml, ulp + 2^-100 of the condition in all arguments, on every row of the truth of a
function whose parameter the library can be asked for: SciPy and mpmath take m, so a row that states mc or k is theirs
only where m is a double. What is complex, not a number, an exception or takes longer than LIMIT is no answer; what has
not four right digits is wrong, and neither enters the worst error.

    python bench/elliptic.py            measure, write bench/results/elliptic.json and the page: make bench-elliptic
    python bench/elliptic.py --page     write the page from the results as they stand
    python bench/elliptic.py --check    compare the page with the results as they stand instead
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"

import csv
import json
import math
import signal
import statistics
import sys
import warnings
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
from page import number, table
from rivals.elliptic import Function, Rival, functions
from run import header
from timing import rounds

ROOT = Path(__file__).resolve().parents[1]
RESULTS = ROOT / "bench/results/elliptic.json"
PAGE = ROOT / "docs/elliptic.md"
LIMIT = 3
COUNT = 100_000
SCALARS = 200
PROMISED = 5
FOUR_DIGITS = Fraction(1, 10**4)


def truth(function: Function) -> list[dict]:
    """The rows of a function that have a value, infinite ones included."""
    with (ROOT / f"reference/vectors/{function.file}.csv").open(newline="", encoding="utf-8") as lines:
        rows = [row for row in csv.DictReader(lines) if function.label in (None, row.get("function"))]
    if len(rows) < 100:
        raise SystemExit(f"{function.file}: {len(rows)} rows")
    return [row for row in rows if all(row[f"{output}_hi"] != "nan" for output in function.outputs)]


def judged(row: dict, output: str, got: float) -> tuple[str, float]:
    """`answer` with its error in the unit of the contract, `wrong` or `none`; a part of a complex value in the unit of
    the larger part."""
    high, low = (float.fromhex(row[f"{output}_{part}"]) for part in ("hi", "lo"))
    if math.isnan(got):
        return "none", math.inf
    if math.isinf(got) or math.isinf(high):
        return ("answer", 0.0) if got == high else ("wrong", math.inf)
    size = abs(high)
    if output.endswith(("_re", "_im")):
        size = max(abs(float.fromhex(row[f"{output[:-2]}{part}_hi"])) for part in ("re", "im"))
    away = abs(Fraction(got) - Fraction(high) - Fraction(low))
    if math.isinf(size):
        return "answer", 0.0  # beside an infinite part
    units = away / (Fraction(math.ulp(size)) + ease(row[f"cond_{output}"]))
    error = float(units) if units < 2**1000 else math.inf
    return ("wrong" if error > PROMISED and away > FOUR_DIGITS * Fraction(size) else "answer"), error


def ease(condition: str) -> Fraction:
    """2^-100 of a condition, which may be beyond the doubles."""
    return Fraction(condition) / 2**100


def asked(row: dict, function: Function, rival: Rival | None) -> dict | None:
    """The keyword that states the parameter of a row exactly for a library; None where it has none or is not for it."""
    if not function.parameter:
        numbers = {name: float.fromhex(row[name]) for name in function.arguments}
        return {} if rival is None or rival.inside(numbers) else None
    given, value = row["given"], float.fromhex(row["parameter"])
    if rival is None:
        return {given: value}
    if not math.isfinite(value) or (given == "q" and "q" not in rival.keywords):
        return None
    exact = {"m": Fraction(value), "q": Fraction(value), "mc": 1 - Fraction(value), "k": Fraction(value) ** 2}[given]
    keyword = {given: value}
    if given not in rival.keywords:
        if "m" not in rival.keywords or abs(exact) > sys.float_info.max or Fraction(float(exact)) != exact:
            return None
        keyword = {"m": float(exact)}
    numbers = {name: float.fromhex(row[name]) for name in function.arguments} | {"m": exact}
    return keyword if rival.inside(numbers) else None


def overdue(*_) -> None:
    raise TimeoutError


def real(value) -> float:
    """The answer as a double; NaN where it is complex."""
    if isinstance(value, mpmath.mpc | complex):
        return float(value.real) if value.imag == 0 else math.nan
    return float(value)


def one(call, arguments: list[float], keyword: dict) -> tuple[float, ...]:
    """The outputs for one row, NaN where the library gives none in time."""
    signal.alarm(LIMIT)
    try:
        got = call(*arguments, **keyword)
        return tuple(map(real, got)) if isinstance(got, tuple) else (real(got),)
    except (
        ValueError,
        ZeroDivisionError,
        OverflowError,
        TimeoutError,
        mpmath.libmp.NoConvergence,
        NotImplementedError,
    ):
        return ()
    finally:
        signal.alarm(0)


def measured(function: Function, rival: Rival | None) -> dict | None:
    """Rows asked, without answer and wrong, and the worst error of the others; `rival` None is libration."""
    counts, worst, total = {"asked": 0, "none": 0, "wrong": 0, "within": 0}, 0.0, 0
    for row in truth(function):
        total += 1
        arguments = [float.fromhex(row[name]) for name in function.arguments]
        keyword = asked(row, function, rival)
        if keyword is None:
            continue
        counts["asked"] += 1
        got = one(function.ours if rival is None else rival.call, arguments, keyword)
        verdicts = [judged(row, x, got[i] if got else math.nan) for i, x in enumerate(function.outputs)]
        kinds = [kind for kind, _ in verdicts]
        kind = "none" if "none" in kinds else "wrong" if "wrong" in kinds else "answer"
        if kind == "answer":
            error = max(error for _, error in verdicts)
            worst = max(worst, error)
            counts["within"] += error <= PROMISED
        else:
            counts[kind] += 1
    return {"rows": total, **counts, "worst": worst}


def inputs(function: Function, count: int) -> tuple[list[np.ndarray], np.ndarray, str]:
    """Moderate arguments that all three libraries take, a parameter for each, and its keyword."""
    random = np.random.default_rng(5)
    spans = {"u": (-10, 10), "re": (-5, 5), "im": (-1, 1), "z": (-10, 10), "phi": (-1.5, 1.5), "n": (-2, 0.9)}
    arguments = [random.uniform(*spans.get(name, (0.1, 10)), count) for name in function.arguments]
    return arguments, random.uniform(0.05, 0.9, count), "q" if function.name.startswith("theta") else "m"


def times(function: Function) -> dict[str, list[float]]:
    """Nanoseconds per value, round by round: arrays for libration and SciPy, scalars for mpmath."""
    arguments, parameters, keyword = inputs(function, COUNT)
    given = {keyword: parameters} if function.parameter else {}
    calls = {"ours": lambda: function.ours(*arguments, **given)}
    if function.parameter and function.arguments:
        calls["ours, one parameter"] = lambda: function.ours(*arguments, **{keyword: 0.7})
    if function.scipy is not None:
        calls["scipy"] = lambda: function.scipy.call(*arguments, **given)
    if function.mpmath is not None:
        scalars = [[float(x) for x in column[:SCALARS]] for column in (*arguments, parameters)]

        def each():
            for *values, parameter in zip(*scalars, strict=True):
                function.mpmath.call(*values, **({keyword: parameter} if function.parameter else {}))

        calls["mpmath"] = each
    counts = {name: SCALARS if name == "mpmath" else COUNT for name in calls}
    return {name: [second / counts[name] * 1e9 for second in seconds] for name, seconds in rounds(calls).items()}


# ------------------------------------------------------------------------------------------------------- the page


def cells(record: dict | None, nanoseconds: list[float] | None) -> list[str]:
    """Rows asked, rows without answer, wrong rows, worst error and time of one library."""
    if record is None:
        return [""] * 5
    if record["asked"] == 0:
        return ["0", "", "", "", time(nanoseconds)]
    worst = number(record["worst"]) if record["asked"] > record["none"] + record["wrong"] else ""
    return [
        f"{record['asked']:,}",
        *(f"{record[x]:,}" if record[x] else "" for x in ("none", "wrong")),
        worst,
        time(nanoseconds),
    ]


def time(nanoseconds: list[float] | None) -> str:
    return number(statistics.median(nanoseconds)) if nanoseconds else ""


def errors(records: list[dict]) -> str:
    head = ["function", "rows", "worst", "ns, one m", "ns, each its m"]
    for library in ("SciPy", "mpmath"):
        head += [f"{library}: rows", "no answer", "wrong", "worst", "ns"]
    body = []
    for record in records:
        ours, taken = record["ours"], record["times"]
        line = [f"`{record['name']}`", f"{ours['rows']:,}", number(ours["worst"])]
        line += [time(taken.get("ours, one parameter")), time(taken["ours"])]
        body.append([*line, *cells(record["scipy"], taken.get("scipy")), *cells(record["mpmath"], taken.get("mpmath"))])
    return table(head, body)


def domains() -> str:
    body = []
    for function in functions():
        theirs = [rival.domain if rival else "not there" for rival in (function.scipy, function.mpmath)]
        body.append([f"`{function.name}`", function.domain, *theirs])
    return table(["function", "libration", "SciPy", "mpmath"], body, (0, 1, 2, 3))


def page(held: dict) -> str:
    """The page, whole."""
    versions = held["versions"]
    parts = {
        **{name: held[name] for name in ("date", "command", "processor", "system")},
        "load": str(held["load at the start"]),
        "versions": ", ".join(
            f"{name} {versions[name]}" for name in ("libration", "Python", "numpy", "scipy", "mpmath")
        ),
        "errors": errors(held["records"]),
        "domains": domains(),
        "count": f"{COUNT:,}",
        "promised": str(PROMISED),
        "limit": str(LIMIT),
    }
    text = Path(__file__).with_name("elliptic.md.in").read_text(encoding="utf-8")
    for place, part in parts.items():
        text = text.replace("{" + place + "}", part)
    return text


def run() -> None:
    """Measure everything and write the results."""
    signal.signal(signal.SIGALRM, overdue)
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    head, records = {**header(False), "command": "make bench-elliptic"}, []
    for function in functions():
        ways = {"ours": None, "scipy": function.scipy, "mpmath": function.mpmath}
        record = {"name": function.name, "times": times(function)}
        for name, rival in ways.items():
            record[name] = measured(function, rival) if rival is not None or name == "ours" else None
        records.append(record)
        print(function.name, {name: record[name] for name in ways}, flush=True)
    text = json.dumps({**head, "records": records}, ensure_ascii=False, indent=1)
    RESULTS.write_text(text.replace("Infinity", "1e999") + "\n", encoding="utf-8")


def main() -> int:
    """Write or compare; libration breaking its own promise is an error."""
    check = "--check" in sys.argv[1:]
    if not check and "--page" not in sys.argv[1:]:
        run()
    if not RESULTS.is_file():
        raise SystemExit("bench/results/elliptic.json is missing: make bench-elliptic")
    held = json.loads(RESULTS.read_text(encoding="utf-8"))
    text = page(held)
    if check and (not PAGE.is_file() or PAGE.read_text(encoding="utf-8") != text):
        print("docs/elliptic.md is not what bench/results says: make bench-elliptic")
        return 1
    PAGE.write_text(text, encoding="utf-8")
    broken = [r["name"] for r in held["records"] if r["ours"]["within"] < r["ours"]["rows"]]
    print(
        f"libration breaks its promise: {', '.join(broken)}"
        if broken
        else "docs/elliptic.md is what bench/results says"
    )
    return bool(broken)


if __name__ == "__main__":
    sys.exit(main())
