"""Damped motions that are compared: those of reference/vectors/damped.csv over a hundred periods, with their truth at four times."""

import csv
from dataclasses import dataclass
from pathlib import Path

VECTORS = Path(__file__).resolve().parents[2] / "reference/vectors/damped.csv"
STRATA = ("linear", "quadratic", "dry", "mixed")
HORIZON = 600.0  # time units of 1/omega0: a hundred small swings


@dataclass(frozen=True)
class DampedCase:
    """A motion from rest with omega0 = 1, and the rows of the file about it, sorted by time."""

    friction: str
    theta0: float
    linear: float
    quadratic: float
    dry: float
    rows: tuple[dict, ...]

    @property
    def name(self) -> str:
        """As the page calls it."""
        return f"{self.friction}, from {self.theta0 * 57.29577951308232:.4g}°"

    @property
    def times(self) -> list[float]:
        """Times with a truth."""
        return [float.fromhex(row["t"]) for row in self.rows]


def damped_cases() -> list[DampedCase]:
    """From 90 and from 179.9 degrees with each friction."""
    held: dict[tuple, list[dict]] = {}
    with VECTORS.open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            inputs = tuple(float.fromhex(row[name]) for name in ("theta0", "linear", "quadratic", "dry"))
            still = float.fromhex(row["velocity0"]) == 0.0 and float.fromhex(row["omega2"]) == 1.0
            if row["stratum"] in STRATA and still:
                held.setdefault((row["stratum"], *inputs), []).append(row)
    found = []
    for (friction, *inputs), rows in held.items():
        rows.sort(key=lambda row: float.fromhex(row["t"]))
        case = DampedCase(friction, *inputs, tuple(rows))
        if case.times[-1] > HORIZON:
            found.append(case)
    if len(found) != 2 * len(STRATA):
        raise SystemExit(f"{VECTORS}: {len(found)} motions over a hundred periods, not {2 * len(STRATA)}")
    return found
