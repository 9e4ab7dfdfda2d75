"""The reference rows of the pendulum, and the error of an answer, in the standard library alone: any interpreter can measure.

The error of an output is E = |got - reference| / (ulp(max(|reference|, floor)) + conditioning), in units of the last place, with
    floor        = 2^-30 * scale   scale = the largest |angle| (pi for separatrix and rotation) or |velocity| of the orbit,
    conditioning = min(2^-100 * cond, 2^-44 * scale)   cond = what relative changes of the inputs move the output by.
So an angle near zero, after a billion periods, is measured by what the inputs determine. The period has no floor, and its
conditioning term is 2^-100 * cond. Reference values are hi + lo; differences are exact (fractions).
"""

import csv
import math
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

VECTORS = Path(__file__).resolve().parents[2] / "reference/vectors/pendulum.csv"
OUTPUTS = ("theta", "velocity", "period")
ATTRIBUTES = ("theta_max", "energy_ratio", "energy_ratio_c", "energy")
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")


@dataclass
class Row:
    """One reference row: an orbit, a time, the values there and how they are measured."""

    stratum: str
    regime: str
    theta0: float
    velocity0: float
    omega2: float
    t: float
    reference: dict = field(default_factory=dict)  # output -> Fraction, or an infinite float
    scale: dict = field(default_factory=dict)
    cond: dict = field(default_factory=dict)

    def error(self, output: str, got: float, floor: Fraction = Fraction(1, 2**30)) -> float:
        """E as defined above; infinite for NaN and for an infinity on one side only."""
        reference, got = self.reference[output], float(got)
        if not math.isfinite(got) or isinstance(reference, float):
            return 0.0 if got == reference or (got != got and reference != reference) else math.inf
        conditioning = self.cond.get(output, 0) / 2**100
        unit = abs(reference)
        if output in self.scale:
            conditioning = min(conditioning, self.scale[output] / 2**44)
            unit = max(unit, floor * self.scale[output])
        ratio = abs(Fraction(got) - reference) / (Fraction(math.ulp(float(unit))) + conditioning)
        return float(ratio) if ratio < 2**1000 else math.inf

    @property
    def omega0(self) -> float | None:
        """The square root of omega2 where it is a double, else None: only such a row can be stated with omega0."""
        root = math.sqrt(max(self.omega2, 0.0))
        return root if root > 0 and Fraction(root) ** 2 == Fraction(self.omega2) else None


def number(text: str) -> float:
    """A double written in decimal or as a hexadecimal float."""
    return float.fromhex(text) if "0x" in text else float(text)


def measure_of(row: Row) -> dict:
    """The largest |angle| and |velocity| of the orbit; three digits are enough, so plain doubles serve."""
    upward = 0.0 if row.omega2 >= 0 else math.pi  # hanging from the other side
    sine = math.sin(row.theta0 / 2) if row.omega2 >= 0 else math.cos(row.theta0 / 2)
    omega0 = math.sqrt(abs(row.omega2))
    kappa = math.hypot(sine, row.velocity0 / (2 * omega0)) if omega0 else math.inf
    velocity = 2 * omega0 * kappa if omega0 else abs(row.velocity0)
    if row.regime in ("separatrix", "rotation"):
        return {"theta": Fraction(math.pi), "velocity": Fraction(velocity)}
    bottom = row.theta0 - math.remainder(row.theta0 - upward, 2 * math.pi)  # 2 pi n
    return {"theta": Fraction(abs(bottom) + 2 * math.asin(min(1.0, kappa))), "velocity": Fraction(velocity)}


def rows(path: Path = VECTORS) -> list[Row]:
    """The reference rows. A missing file or column is an error; no row is skipped."""
    found = []
    with path.open(newline="", encoding="utf-8") as lines:
        for line in csv.DictReader(line for line in lines if not line.startswith("#")):
            inputs = [number(line[name]) for name in ("theta0", "velocity0", "omega2", "t")]
            row = Row(line["stratum"], line["regime"], *inputs)
            for output in OUTPUTS + ATTRIBUTES:
                hi, lo = number(line[output + "_hi"]), number(line[output + "_lo"])
                row.reference[output] = Fraction(hi) + Fraction(lo) if math.isfinite(hi) else hi
            row.cond = {output: Fraction(line["cond_" + output]) for output in OUTPUTS}
            row.scale = measure_of(row)
            found.append(row)
    if len(found) < 1998:
        raise SystemExit(f"{path}: {len(found)} rows, at least 1998 expected")
    return found
