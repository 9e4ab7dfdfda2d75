"""The tables of docs/approximations.md: every formula with its source, its range and its errors, measured when the page is written."""

import math

from libration import approx
from libration.approx._period import listed

ANGLES = (30, 60, 90, 120, 150, 170)
SHOWN = (
    *("linear", "harmonic", "fourier:1", "fourier:2", "fourier:4", "fourier:6", "fourier-theta:1", "fourier-theta:2"),
    *(
        "fourier-theta:4",
        "trigonometric",
        "small-m",
        "small-m-bounded",
        "cubic",
        "cubic-quintic",
        "taylor:4",
        "taylor:8",
    ),
)
SINES = (("salas-2", 70), ("salas-3", 120), ("taylor:3", 70), ("taylor:5", 120), ("best:3", 70), ("best:5", 120))


def sources() -> str:
    """Formula, source, stated range and gaps of every approximation of the angle."""
    lines = ["| name | θ(t) | source | stated | no value |", "|---|---|---|---|---|"]
    for each in approx.angle:
        lines.append(row(f"`{each.pattern}`", each.formula, each.source, each.stated, each.undefined))
    return table(lines)


def angles() -> str:
    """Largest error of every approximation of the angle over one period, and the angle up to which it is within one percent."""
    heads = [*(f"{degrees}°" for degrees in ANGLES), "within 1 % up to"]
    lines = [row("name", *heads), "|---|" + "---:|" * len(heads)]
    for name in SHOWN:
        formula = approx.angle(name)
        errors = [formula.error(math.radians(degrees)) for degrees in ANGLES]
        cells = ["undefined" if math.isnan(error) else percent(error) for error in errors]
        lines.append(row(f"`{name}`", *cells, reach(formula.ranges(0.01))))
    return table(lines)


def periods() -> str:
    """T/T0 by every formula, its error and the turning angles where its error is within a thousandth."""
    heads = [*(f"{degrees}°" for degrees in (*ANGLES, 179)), "within 0.1 %"]
    lines = [row("name", "T/T₀", "source", "stated", *heads), "|---|---|---|---|" + "---:|" * len(heads)]
    for formula in listed():
        errors = [percent(formula.error(math.radians(degrees)), "+") for degrees in (*ANGLES, 179)]
        facts = formula.formula, formula.source, formula.stated
        lines.append(row(f"`{formula.name}`", *facts, *errors, reach(formula.ranges(0.001))))
    return table(lines)


def sines() -> str:
    """The polynomials for the sine, and their largest errors on a range."""
    lines = [
        row("name", "source", "on", "coefficients of φ, φ³, …", "largest error", "relative"),
        "|---|---|---|---|---:|---:|",
    ]
    for name, degrees in SINES:
        phi_max = math.radians(degrees)
        formula = approx.sine(name, **({"phi_max": phi_max} if name.startswith("best") else {}))
        error = formula.error(phi_max)
        coefficients = ", ".join(f"{each:.6g}" for each in formula.coefficients)
        lines.append(
            row(
                f"`{name}`",
                formula.source,
                f"{degrees}°",
                coefficients,
                f"{error.absolute:.3g}",
                percent(error.relative) + " %",
            )
        )
    return table(lines)


def percent(part, sign=""):
    """A part in percent to three digits."""
    return f"{100 * part:{sign}.3g}"


def reach(ranges):
    """Where an error stays within its bound."""
    spans = []
    for low, high in ranges:
        # Rounded inwards, but for the top.
        low, high = math.ceil(10 * math.degrees(low)) / 10, math.floor(10 * math.degrees(high) + 1e-9) / 10
        spans.append(f"{high:.1f}°" if low < 0.2 else f"{low:.1f}° to {high:.1f}°")
    return ", ".join(spans) or "nowhere"


def row(*cells):
    """One line of a table."""
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"


def table(lines):
    """Lines as a block."""
    return "\n" + "\n".join(lines) + "\n\n"
