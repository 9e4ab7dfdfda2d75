"""Errors of libration, and of the usual SciPy recipe, on every row of the truth; writes docs/accuracy.md.

The error of an output is E = |got - truth| / (ulp(max(|truth|, floor)) + ease): how many units in the last
place it is off, where one unit is never smaller than
    floor = 2^-30 * scale   scale = the largest |angle| (pi for separatrix and rotation) or |velocity| of the orbit,
    ease  = min(2^-100 * cond, 2^-44 * scale)   cond = what relative changes of the inputs move the output by,
so that an angle passing through zero after a billion periods is not asked for digits nobody can have. The period
has no floor and its ease is 2^-100 * cond. Truths are hi + lo; differences are exact (fractions).

    python bench/accuracy.py            measure, write docs/accuracy.md, exit 1 if a promise of functions.toml breaks
    python bench/accuracy.py --check    measure and compare with the page as it stands instead of writing it
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

ROOT = Path(__file__).resolve().parents[1]
VECTORS = ROOT / "reference/vectors/pendulum.csv"
PAGE = ROOT / "docs/accuracy.md"
OUTPUTS = ("theta", "velocity", "period")
ATTRIBUTES = ("theta_max", "energy_ratio", "energy_ratio_c", "energy")
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")


@dataclass
class Row:
    """One row of the truth: an orbit, an instant, what is true there and how it is measured."""

    stratum: str
    regime: str
    theta0: float
    velocity0: float
    omega2: float
    t: float
    truth: dict = field(default_factory=dict)  # output -> Fraction, or an infinite float
    scale: dict = field(default_factory=dict)
    cond: dict = field(default_factory=dict)

    def error(self, output: str, got: float, floor: Fraction = Fraction(1, 2**30)) -> float:
        """E as defined above; infinite for NaN and for an infinity on one side only."""
        truth, got = self.truth[output], float(got)
        if not math.isfinite(got) or isinstance(truth, float):
            return 0.0 if got == truth or (got != got and truth != truth) else math.inf
        ease = self.cond.get(output, 0) / 2**100
        unit = abs(truth)
        if output in self.scale:
            ease = min(ease, self.scale[output] / 2**44)
            unit = max(unit, floor * self.scale[output])
        ratio = abs(Fraction(got) - truth) / (Fraction(math.ulp(float(unit))) + ease)
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
    """The truth. A missing file or column is an error; nothing is passed over."""
    found = []
    with path.open(newline="", encoding="utf-8") as lines:
        for line in csv.DictReader(line for line in lines if not line.startswith("#")):
            inputs = [number(line[name]) for name in ("theta0", "velocity0", "omega2", "t")]
            row = Row(line["stratum"], line["regime"], *inputs)
            for output in OUTPUTS + ATTRIBUTES:
                hi, lo = number(line[output + "_hi"]), number(line[output + "_lo"])
                row.truth[output] = Fraction(hi) + Fraction(lo) if math.isfinite(hi) else hi
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
    truth = rows(path)
    strata = {row.stratum: {"rows": 0, "regimes": 0, "errors": {}} for row in truth}

    def note(row: Row, way: str, output: str, error: float) -> None:
        strata[row.stratum]["errors"].setdefault((way, output), []).append(error)

    for row in truth:
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
        for what in (row.scale, row.cond):
            what["turns"] = what["theta"]
        row.truth["turns"] = row.truth["theta"] - 2 * PI * int(n)
        note(row, "orbit", "turns", row.error("turns", angle) if -math.pi <= angle < math.pi else math.inf)
    stated = [row for row in truth if row.omega0 is not None]
    columns = numpy.array([(row.t, row.theta0, row.velocity0, row.omega0) for row in stated]).T
    times, theta0, velocity0, omega0 = columns
    pair = libration.motion(*columns)
    single = libration.theta(*columns), libration.velocity(*columns)
    step = libration.advance(theta0, velocity0, times, omega0)
    for output, *ways in zip(OUTPUTS, pair, single, step, strict=False):
        for index, row in enumerate(stated):
            error = max(row.error(output, way[index], floor=Fraction(1)) for way in ways)
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
        for (way, output), (largest, median) in promises().items():
            errors = held["errors"][way, output]
            for what, got, limit in [("largest", max(errors), largest), ("median", statistics.median(errors), median)]:
                if not got <= limit:
                    found.append(f"{stratum}: {what} error of {output} ({way}) is {got:.3g}, promised {limit:g}")
    return found


def shown(value: float) -> str:
    """An error as the page prints it."""
    return f"{value:.2f}" if value < 100 else f"{value:.0e}".replace("e+", "e") if value < math.inf else "inf"


def table(head: list[str], body: list[list[str]]) -> str:
    """A table of a page, numbers to the right."""
    lines = [head, ["---", *["---:"] * (len(head) - 1)], *body]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def by_stratum(strata: dict[str, dict], output: str) -> str:
    """Every stratum's errors of one output on every path."""
    head = ["stratum", "rows", "one orbit at many times: max", "median", "SciPy recipe: max", "median"]
    body = []
    for stratum, held in strata.items():
        ways = [held["errors"]["orbit", output], held["errors"]["scipy", output]]
        numbers = [shown(what(errors)) for errors in ways for what in (max, statistics.median)]
        body.append([stratum, str(held["rows"]), *numbers])
        if states := held["errors"].get(("states", output)):
            body[-1] += [str(len(states)), shown(max(states))]
    own = ["rows of arrays", "arrays of orbits: max"] if output != "period" else []
    return f"## {output}\n\n" + table(head + own, body)


def reach(truth: list[Row]) -> tuple[str, str]:
    """How small the smallest swing of the truth is, rounded up to a power of ten, and how many periods it goes."""
    smallest = min(row.truth["theta_max"] for row in truth if row.regime == "libration")
    periods = max(abs(Fraction(row.t)) / row.truth["period"] for row in truth if row.truth["period"] != math.inf)
    return f"1e{math.ceil(math.log10(smallest))}", f"{float(periods) / 1e6:.0f} million"


def page(strata: dict[str, dict]) -> str:
    """docs/accuracy.md, whole."""

    def worst(way: str, output: str, what=max) -> str:
        return shown(max(what(held["errors"][way, output]) for held in strata.values()))

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

One unit is the last place of the true value, but never less than that of 2^-30 of the orbit's largest angle or velocity
(for arrays of orbits: of the largest itself); the period has no such floor.

Over {rows} orbits and instants in {strata} strata, most of them hard on purpose: from swings below {swing} rad to the
last double before the separatrix and to {periods} periods. The regime is right in {regimes} rows. *Worst median* is the
largest of the strata's medians; *inf* means that at least one answer was not a finite number where the truth is one, or
the reverse.
<!-- end summary -->

The error is E = |got - truth| / (ulp(max(|truth|, 2^-30 scale)) + ease) with scale the largest |angle| (pi for
separatrix and rotation) or |velocity| of the orbit and ease = min(2^-100 cond, 2^-44 scale), where cond is by how
much the output moves when each input moves by its own size; the period has no floor and its ease is 2^-100 cond.
Attributes are measured with neither floor nor ease. Arrays of orbits go through `theta`, `velocity`, `motion` and
`advance`, measured with the floor at scale on the rows whose omega0 is a double. The truth
([reference/](../reference/README.md)) is exact for the doubles passed in and stored as hi + lo; differences are
taken in fractions. What is promised stands in [functions.md](functions.md).

The SciPy recipe is m = sin²(θ₀/2) + (θ̇₀/2ω₀)², `ellipkinc` for the starting phase, `ellipj` for the motion, the
angle from 2·atan2(k·sn, dn) or 2·am, the period from `ellipk` (`ellipkm1` when released from rest), in double
throughout. Near the separatrix and after many periods it has no digits left; its medians show where it is fine.

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
