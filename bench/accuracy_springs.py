"""Errors of the springs on every reference row, by strata: rows, wrong regimes, the worst and the median error of every output.

u and velocity are measured in ulp of the largest of the motion, all others in their own; the ulp is widened by 2^-100 of the condition.
What is infinite or does not exist, as it should, counts for nothing; where it should be finite, the error is infinite.

    python bench/accuracy_springs.py             Duffing's oscillator with even powers
    python bench/accuracy_springs.py duffing     without them; cubic_quintic: with a fifth power
"""

import csv
import math
import statistics
import sys
from collections import defaultdict
from pathlib import Path

from libration import CubicQuintic, Duffing

VECTORS = Path(__file__).resolve().parents[1] / "reference/vectors"
# Columns of the coefficients, with the names of the arguments.
SPRINGS = {
    "duffing": (Duffing, {"p": "p", "q": "q"}),
    "cubic_quintic": (CubicQuintic, {"alpha": "p", "beta": "q", "gamma": "s"}),
    "helmholtz_duffing": (Duffing, {"p": "p", "q": "q", "r": "r", "c": "c"}),
}
OUTPUTS = ("u", "velocity", "period", "low", "high", "energy", "escape", "escape_backward")


def error(row: dict[str, str], name: str, got: float) -> float | None:
    """How far a value is from hi + lo; infinite for a wrong NaN or infinity, none for a right one."""
    hi, lo = (float.fromhex(row[f"{name}_{part}"]) for part in ("hi", "lo"))
    if not (math.isfinite(hi) and math.isfinite(got)):
        return None if got == hi or (math.isnan(got) and math.isnan(hi)) else math.inf
    unit = math.ulp(float(row.get(f"scale_{name}", hi)))
    return abs((got - hi) - lo) / (unit + 2.0**-100 * float(row.get(f"cond_{name}", 0.0)))


def measured(family: str) -> dict[str, dict]:
    """By stratum: the number of rows and of wrong regimes, and the errors of each output."""
    kind, columns = SPRINGS[family]
    strata: dict[str, dict] = {}
    with (VECTORS / f"{family}.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            at = strata.setdefault(row["stratum"], {"rows": 0, "wrong": 0, "errors": defaultdict(list)})
            force = {name: float.fromhex(row[column]) for column, name in columns.items()}
            one = kind(float.fromhex(row["u0"]), float.fromhex(row["velocity0"]), **force)
            values = [*map(float, one.motion(float.fromhex(row["t"]))), one.period, *one.range, one.energy]
            values += [one.escape_time, one.escape_time_backward]
            at["rows"] += 1
            at["wrong"] += str(one.regime) != row["regime"]
            for name, got in zip(OUTPUTS, values, strict=True):
                far = error(row, name, got)
                at["errors"][name] += [] if far is None else [far]
    return strata


def main() -> None:
    family = sys.argv[1] if len(sys.argv) > 1 else "helmholtz_duffing"
    strata = measured(family)
    print(f"| {family} | rows | wrong regimes | {' | '.join(OUTPUTS)} |")
    print(f"|---|{'---:|' * (len(OUTPUTS) + 2)}")
    whole = {"rows": 0, "wrong": 0, "errors": defaultdict(list)}
    for stratum, at in strata.items():
        show(stratum, at)
        for key in ("rows", "wrong"):
            whole[key] += at[key]
        for name, errors in at["errors"].items():
            whole["errors"][name] += errors
    show("all", whole)


def show(stratum: str, at: dict) -> None:
    """A row of the table: worst / median of each output."""
    lists = [at["errors"][name] for name in OUTPUTS]
    cells = [f"{max(each):.2f} / {statistics.median(each):.2f}" if each else "" for each in lists]
    print(f"| {stratum} | {at['rows']} | {at['wrong']} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
