"""What the checks of all vectors share: the row counts as README.md prints them, mutated rows, and how a check ends."""

import math
from collections import Counter


def fail(*words):
    raise SystemExit(" ".join(["reference:", *map(str, words)]))


def counted(name, rows):
    """Row counts by stratum, as README.md prints them."""
    counts = Counter(row["stratum"] for row in rows)
    strata = ", ".join(f"{stratum} {count}" for stratum, count in counts.items())
    return f"| `{name}` | {len(rows)} | {strata} |"


def mutated(row):
    """The row with each hi + lo moved by 2^-100 and each decimal by 1e-4, one column at a time."""
    for column, text in row.items():
        if column.endswith("_lo"):
            hi = float.fromhex(row[column[:-2] + "hi"])
            if 1e-250 < abs(hi) < math.inf:
                moved = float.fromhex(text) + hi * 2.0**-100
                yield column, {**row, column: moved.hex()}
        elif column.startswith(("cond_", "dtheta_", "dvelocity_")) and text not in ("0", "0.0"):
            digit = "8" if text.lstrip("-")[0] != "8" else "3"
            sign = "-" if text.startswith("-") else ""
            yield column, {**row, column: sign + digit + text.lstrip("-")[1:]}
