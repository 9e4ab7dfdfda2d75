"""The elliptic functions of libration, SciPy, ellippy and mpmath: rows with an answer, worst error and time of each.

The unit of error is that of functions.toml, ulp + 2^-100 of the condition in all arguments. Every row of the reference
vectors counts whose parameter the library can be asked for: the others take m, so a row that states mc or k is asked
of them only where m is a double. A complex value, NaN, an exception, or more than LIMIT seconds is no answer. An answer
without four right digits is wrong. Neither enters the worst error.
"""

import csv
import importlib.util
import math
import signal
import sys
import warnings
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
from rivals.elliptic_family import Function, Rival, functions

from .timing import rounds

VECTORS = Path(__file__).resolve().parents[2] / "reference/vectors"
LIMIT = 3
COUNT = 100_000
SCALARS = 200
PROMISED = 5
FOUR_DIGITS = Fraction(1, 10**4)


def vectors(function: Function) -> list[dict]:
    """The rows of a function that have a value, infinite ones included."""
    with (VECTORS / f"{function.file}.csv").open(newline="", encoding="utf-8") as lines:
        rows = [row for row in csv.DictReader(lines) if function.label in (None, row.get("function"))]
    if len(rows) < 100:
        raise SystemExit(f"{function.file}: {len(rows)} rows")
    return [row for row in rows if all(row[f"{output}_hi"] != "nan" for output in function.outputs)]


def verdict(row: dict, output: str, got: float) -> tuple[str, float]:
    """`answer`, `wrong` or `none`, and the error; a part of a complex value is measured in units of the larger part."""
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
    units = away / (Fraction(math.ulp(size)) + conditioning(row[f"cond_{output}"]))
    error = float(units) if units < 2**1000 else math.inf
    return ("wrong" if error > PROMISED and away > FOUR_DIGITS * Fraction(size) else "answer"), error


def conditioning(condition: str) -> Fraction:
    """2^-100 of a condition, which may be beyond the range of doubles."""
    return Fraction(condition) / 2**100


def keyword(row: dict, function: Function, rival: Rival | None) -> dict | None:
    """The keyword that states the parameter of a row exactly; None if the library has none or states another domain."""
    if not function.parameter:
        numbers = {name: float.fromhex(row[name]) for name in function.arguments}
        return {} if rival is None or rival.inside(numbers) else None
    given, value = row["given"], float.fromhex(row["parameter"])
    if rival is None:
        return {given: value}
    if not math.isfinite(value) or (given == "q" and "q" not in rival.keywords):
        return None
    exact = {"m": Fraction(value), "q": Fraction(value), "mc": 1 - Fraction(value), "k": Fraction(value) ** 2}[given]
    found = {given: value}
    if given not in rival.keywords:
        if "m" not in rival.keywords or abs(exact) > sys.float_info.max or Fraction(float(exact)) != exact:
            return None
        found = {"m": float(exact)}
    numbers = {name: float.fromhex(row[name]) for name in function.arguments} | {"m": exact}
    return found if rival.inside(numbers) else None


def too_late(*_) -> None:
    """What the alarm of LIMIT seconds does."""
    raise TimeoutError


def real(value) -> float:
    """The answer as a double; NaN where it is complex."""
    if isinstance(value, mpmath.mpc | complex):
        return float(value.real) if value.imag == 0 else math.nan
    return float(value)


def answer(call, arguments: list[float], given: dict) -> tuple[float, ...]:
    """The outputs for one row, NaN where the library gives none in time."""
    signal.alarm(LIMIT)
    try:
        got = call(*arguments, **given)
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
    for row in vectors(function):
        total += 1
        arguments = [float.fromhex(row[name]) for name in function.arguments]
        given = keyword(row, function, rival)
        if given is None:
            continue
        counts["asked"] += 1
        got = answer(function.ours if rival is None else rival.call, arguments, given)
        verdicts = [verdict(row, x, got[i] if got else math.nan) for i, x in enumerate(function.outputs)]
        kinds = [kind for kind, _ in verdicts]
        kind = "none" if "none" in kinds else "wrong" if "wrong" in kinds else "answer"
        if kind == "answer":
            error = max(error for _, error in verdicts)
            worst = max(worst, error)
            counts["within"] += error <= PROMISED
        else:
            counts[kind] += 1
    return {"rows": total, **counts, "worst": worst}


def moderate(function: Function, count: int) -> tuple[list[np.ndarray], np.ndarray, str]:
    """Moderate arguments that all libraries take, a parameter for each, and its keyword."""
    random = np.random.default_rng(5)
    spans = {"u": (-10, 10), "re": (-5, 5), "im": (-1, 1), "phi": (-1.5, 1.5), "n": (-2, 0.9)}
    if function.parameter:
        spans["z"] = (-10, 10)  # of theta functions; Carlson's is not negative
    arguments = [random.uniform(*spans.get(name, (0.1, 10)), count) for name in function.arguments]
    return arguments, random.uniform(0.05, 0.9, count), "q" if function.name.startswith("theta") else "m"


def nanoseconds(function: Function) -> dict[str, list[float]]:
    """Nanoseconds per value, round by round: arrays for libration, SciPy and ellippy, scalars for mpmath."""
    arguments, parameters, keyword = moderate(function, COUNT)
    given = {keyword: parameters} if function.parameter else {}
    calls = {"ours": lambda: function.ours(*arguments, **given)}
    if function.parameter and function.arguments:
        calls["ours, one parameter"] = lambda: function.ours(*arguments, **{keyword: 0.7})
    if function.scipy is not None:
        calls["scipy"] = lambda: function.scipy.call(*arguments, **given)
    if there(function.ellippy):
        calls["ellippy"] = lambda: function.ellippy.call(*arguments, **given)
    if function.mpmath is not None:
        scalars = [[float(x) for x in column[:SCALARS]] for column in (*arguments, parameters)]

        def each():
            for *values, parameter in zip(*scalars, strict=True):
                function.mpmath.call(*values, **({keyword: parameter} if function.parameter else {}))

        calls["mpmath"] = each
    counts = {name: SCALARS if name == "mpmath" else COUNT for name in calls}
    return {name: [second / counts[name] * 1e9 for second in seconds] for name, seconds in rounds(calls).items()}


def there(rival: Rival | None) -> bool:
    """Whether ellippy has the function, and is installed."""
    return rival is not None and importlib.util.find_spec("ellippy") is not None


def records() -> list[dict]:
    """Every function of every library, measured."""
    signal.signal(signal.SIGALRM, too_late)
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    found = []
    for function in functions():
        ellippy = function.ellippy if there(function.ellippy) else None
        asked = {"ours": None, "scipy": function.scipy, "ellippy": ellippy, "mpmath": function.mpmath}
        record = {"name": function.name, "times": nanoseconds(function)}
        for name, rival in asked.items():
            record[name] = measured(function, rival) if rival is not None or name == "ours" else None
        found.append(record)
        print(function.name, {name: record[name] for name in asked}, flush=True)
    return found
