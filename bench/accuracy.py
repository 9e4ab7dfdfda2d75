"""Errors of libration, and of the usual SciPy recipe, on every reference row; writes docs/accuracy.md.

The error of an output stands in measurement/orbit_rows.py.

    python bench/accuracy.py            measure, write docs/accuracy.md, exit 1 if a promise of functions.toml breaks
    python bench/accuracy.py --check    measure and compare with the page instead of writing it
"""

import math
import re
import statistics
import sys
import tomllib
from fractions import Fraction
from pathlib import Path

import numpy
import scipy
from scipy.special import ellipj, ellipk, ellipkinc, ellipkm1

import libration

sys.path.append(str(Path(__file__).parent))  # for who loads this file by its path

from measurement.orbit_rows import ATTRIBUTES, OUTPUTS, PI, VECTORS, Row, rows
from report.tables import table

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/accuracy.md"


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
