"""Errors of libration, and of the usual SciPy recipe, on every reference row; writes docs/accuracy.md.

The error of an output is E = |got - reference| / (ulp(max(|reference|, floor)) + conditioning), in units of the last place, with
    floor        = 2^-30 * scale   scale = the largest |angle| (pi for separatrix and rotation) or |velocity| of the orbit,
    conditioning = min(2^-100 * cond, 2^-44 * scale)   cond = what relative changes of the inputs move the output by.
So an angle near zero, after a billion periods, is measured by what the inputs determine. The period has no floor, and its
conditioning term is 2^-100 * cond. Reference values are hi + lo; differences are exact (fractions).

    python bench/accuracy.py            measure, write docs/accuracy.md, exit 1 if a promise of functions.toml breaks
    python bench/accuracy.py --check    measure and compare with the page instead of writing it
"""

import csv
import math
import re
import statistics
import sys
import tomllib
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

import numpy
import scipy
from scipy.special import ellipj, ellipk, ellipkinc, ellipkm1

import libration

sys.path.append(str(Path(__file__).parent))  # for who loads this file by its path

from report.tables import table

ROOT = Path(__file__).resolve().parents[1]
VECTORS = ROOT / "reference/vectors/pendulum.csv"
PAGE = ROOT / "docs/accuracy.md"
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


def scipy_recipe(row: Row) -> tuple[float, float, float]:
    """Angle, velocity and period as users write them with ellipj, ellipkinc and ellipk, all in double."""
    with numpy.errstate(all="ignore"):
        omega0 = math.sqrt(row.omega2)
        turns = round(row.theta0 / (2 * math.pi))
        half = (row.theta0 - 2 * math.pi * turns) / 2
        x = row.velocity0 / (2 * omega0)
        k = math.hypot(math.sin(half), x)
        m = k * k
        if m == 0:
            return 2 * math.pi * turns, 0.0, 2 * math.pi / omega0
        if m <= 1:
            phi0 = math.atan2(math.sin(half), x)
            sn, cn, dn, _ = ellipj(ellipkinc(phi0, m) + omega0 * row.t, m)
            theta, velocity = 2 * math.atan2(k * sn, dn), 2 * omega0 * k * cn
            period = 4 * (ellipk(m) if row.velocity0 else ellipkm1(math.cos(half) ** 2)) / omega0
        else:
            sign = math.copysign(1.0, row.velocity0)
            _, _, dn, am = ellipj(sign * ellipkinc(half, 1 / m) + k * omega0 * row.t, 1 / m)
            theta, velocity = 2 * sign * am, 2 * sign * omega0 * k * dn
            period = 2 * ellipk(1 / m) / (omega0 * k)
        return theta + 2 * math.pi * turns, velocity, period


def measure(path: Path = VECTORS) -> dict[str, dict]:
    """Per stratum: the errors of every row on each path, and how many regimes are right."""
    found = rows(path)
    strata = {row.stratum: {"rows": 0, "regimes": 0, "errors": {}} for row in found}

    def note(row: Row, path: str, output: str, error: float) -> None:
        strata[row.stratum]["errors"].setdefault((path, output), []).append(error)

    for row in found:
        orbit = libration.Pendulum(row.theta0, row.velocity0, omega2=row.omega2)
        strata[row.stratum]["rows"] += 1
        strata[row.stratum]["regimes"] += orbit.regime.value == row.regime
        ours = orbit.theta(row.t), orbit.velocity(row.t), orbit.period
        for output, got, rival in zip(OUTPUTS, ours, scipy_recipe(row), strict=True):
            note(row, "orbit", output, row.error(output, got))
            note(row, "scipy", output, row.error(output, rival))
        for output in ATTRIBUTES:
            note(row, "orbit", output, row.error(output, getattr(orbit, output)))
        n, angle = orbit.turns(row.t)
        for part in (row.scale, row.cond):
            part["turns"] = part["theta"]
        row.reference["turns"] = row.reference["theta"] - 2 * PI * int(n)
        note(row, "orbit", "turns", row.error("turns", angle) if -math.pi <= angle < math.pi else math.inf)
    stated = [row for row in found if row.omega0 is not None]
    columns = numpy.array([(row.t, row.theta0, row.velocity0, row.omega0) for row in stated]).T
    times, theta0, velocity0, omega0 = columns
    pair = libration.motion(*columns)
    single = libration.theta(*columns), libration.velocity(*columns)
    step = libration.advance(theta0, velocity0, times, omega0)
    for output, *results in zip(OUTPUTS, pair, single, step, strict=False):
        for index, row in enumerate(stated):
            error = max(row.error(output, result[index], floor=Fraction(1)) for result in results)
            note(row, "states", output, error)
    return strata


def promises() -> dict[tuple[str, str], tuple[float, float]]:
    """Per path and output the promised largest error and median, from functions.toml."""
    table = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))
    held = {}
    for output in (*OUTPUTS, *ATTRIBUTES, "turns"):
        row = table["Pendulum." + output]
        held["orbit", output] = row["error_max_ulp"], row.get("error_median_ulp", math.inf)
    for output in ("theta", "velocity"):
        row = min(table[output]["error_max_ulp_own_state"], table["advance"]["error_max_ulp"])
        held["states", output] = row, math.inf
    return held


def failures(strata: dict[str, dict]) -> list[str]:
    """One line for every promise that a stratum breaks."""
    found = []
    for stratum, held in strata.items():
        if held["regimes"] != held["rows"]:
            found.append(f"{stratum}: regime wrong in {held['rows'] - held['regimes']} rows")
        for (path, output), (largest, median) in promises().items():
            errors = held["errors"][path, output]
            for what, got, limit in [("largest", max(errors), largest), ("median", statistics.median(errors), median)]:
                if not got <= limit:
                    found.append(f"{stratum}: {what} error of {output} ({path}) is {got:.3g}, promised {limit:g}")
    return found


def shown(value: float) -> str:
    """An error as the page prints it."""
    return f"{value:.2f}" if value < 100 else f"{value:.0e}".replace("e+", "e") if value < math.inf else "inf"


def by_stratum(strata: dict[str, dict], output: str) -> str:
    """Every stratum's errors of one output on every path."""
    head = ["stratum", "rows", "one orbit at many times: max", "median", "SciPy recipe: max", "median"]
    body = []
    for stratum, held in strata.items():
        paths = [held["errors"]["orbit", output], held["errors"]["scipy", output]]
        numbers = [shown(what(errors)) for errors in paths for what in (max, statistics.median)]
        body.append([stratum, str(held["rows"]), *numbers])
        if states := held["errors"].get(("states", output)):
            body[-1] += [str(len(states)), shown(max(states))]
    own = ["rows of arrays", "arrays of orbits: max"] if output != "period" else []
    return f"## {output}\n\n" + table(head + own, body)


def reach(found: list[Row]) -> tuple[str, str]:
    """The smallest swing of the reference rows, rounded up to a power of ten, and the most periods."""
    smallest = min(row.reference["theta_max"] for row in found if row.regime == "libration")
    periods = max(
        abs(Fraction(row.t)) / row.reference["period"] for row in found if row.reference["period"] != math.inf
    )
    return f"1e{math.ceil(math.log10(smallest))}", f"{float(periods) / 1e6:.0f} million"


def page(strata: dict[str, dict]) -> str:
    """docs/accuracy.md, whole."""

    def worst(path: str, output: str, what=max) -> str:
        return shown(max(what(held["errors"][path, output]) for held in strata.values()))

    def orbit(output: str) -> list[str]:
        return [output, worst("orbit", output), worst("orbit", output, statistics.median)]

    summary = []
    for output in OUTPUTS:
        rival = [error for held in strata.values() for error in held["errors"]["scipy", output]]
        lost = 100 * sum(error > 1000 for error in rival) / len(rival)
        own = worst("states", output) if output != "period" else ""
        theirs = [shown(max(rival)), shown(statistics.median(rival)), f"{lost:.0f} %"]
        summary.append([*orbit(output), own, *theirs])
    head = [
        "error, in units of the last place",
        "one orbit at many times: max",
        "worst median",
        "arrays of orbits: max",
    ]
    more = [orbit(output) for output in (*ATTRIBUTES, "turns")]
    total, regimes = (sum(held[count] for held in strata.values()) for count in ("rows", "regimes"))
    tables = [by_stratum(strata, output) for output in OUTPUTS]
    swing, periods = reach(rows())
    tables.append("## attributes and turns\n\n" + table(["over all strata", "max", "worst median"], more))
    return TEXT.format(
        versions=f"libration {libration.__version__}, NumPy {numpy.__version__}, SciPy {scipy.__version__}",
        summary=table([*head, "SciPy recipe: max", "median", "rows wrong by more than 1000"], summary),
        rows=total,
        swing=swing,
        periods=periods,
        strata=len(strata),
        regimes="all" if regimes == total else f"{regimes} of {total}",
        tables="\n\n".join(tables),
    )


TEXT = """# Accuracy

Written by `python bench/accuracy.py` with {versions}.

<!-- summary -->
{summary}

The unit is one unit in the last place (ulp) of the exact value, but at least that of 2^-30 of the orbit's largest angle or
velocity (for arrays of orbits: of the largest itself). The period has no such floor.

The table is over {rows} orbits and times in {strata} strata. Most of them are hard on purpose: from swings below {swing} rad to
the last double before the separatrix, and up to {periods} periods. The regime is right in {regimes} rows. *Worst median* is
the largest of the medians of the strata. *inf* means that at least one answer was not finite where the exact value is, or
the reverse.
<!-- end summary -->

The error is E = |got - reference| / (ulp(max(|reference|, 2^-30 scale)) + conditioning). Here scale is the largest |angle| (pi
for separatrix and rotation) or |velocity| of the orbit, conditioning = min(2^-100 cond, 2^-44 scale), and cond is how much
the output moves when each input moves by its own size. The period has no floor, and its conditioning term is 2^-100 cond.
Attributes are measured with neither. Arrays of orbits go through `theta`, `velocity`, `motion` and `advance`. They are
measured with the floor at scale, on the rows whose omega0 is a double. The reference values
([reference/](../reference/README.md)) are exact for the doubles passed in and stored as hi + lo; differences are taken in
fractions. The promises are listed in [the reference](reference/index.md).

The SciPy recipe is m = sin²(θ₀/2) + (θ̇₀/2ω₀)², `ellipkinc` for the starting phase, `ellipj` for the motion, and the angle
from 2·atan2(k·sn, dn) or 2·am. The period is from `ellipk` (`ellipkm1` when released from rest). All of it is in double
precision. Near the separatrix and after many periods it has no digits left; its medians show where it is accurate.

{tables}
"""


def differences(old: str, new: str) -> list[str]:
    """Lines in which two pages differ: words exactly; an error by a quarter or 0.15 (instruction sets differ)."""
    value = re.compile(r"(?<=\| )(\d[\d.e]*|inf)(?=(?: %)? \|)")

    def close(one: str, other: str) -> bool:
        a, b = float(one), float(other)
        return a == b or ((a < 100) == (b < 100) and abs(a - b) <= max(0.15, 0.25 * b))

    found = []
    for one, other in zip(old.splitlines(), new.splitlines(), strict=False):
        same = value.sub("#", one) == value.sub("#", other)
        if not same or not all(map(close, value.findall(one), value.findall(other))):
            found.append(f"- {one}\n+ {other}")
    return found if len(old.splitlines()) == len(new.splitlines()) else [*found, "the pages differ in length"]


def main() -> int:
    """Measure, then write or compare the page; 1 when a promise is broken or the page is stale."""
    strata = measure()
    text = page(strata)
    found = failures(strata)
    if "--check" in sys.argv[1:]:
        stale = differences(PAGE.read_text(encoding="utf-8"), text)
        found += [f"{PAGE.name} is not what this run writes: make docs\n{line}" for line in stale]
    else:
        PAGE.write_text(text, encoding="utf-8")
        print(text.partition("<!-- summary -->\n")[2].partition("<!-- end summary -->")[0])
    print("\n".join(found) if found else "every promise of functions.toml holds in every stratum")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
