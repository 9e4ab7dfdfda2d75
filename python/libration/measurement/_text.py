"""A fit in plain lines: what was understood and left out, window, ladder, result, budget, verdicts, the sentence to quote."""

import math
from collections.abc import Sequence
from typing import Any

from ._estimate import Estimate, rounded

# Name and unit of each friction term.
TERMS = {
    "linear": ("linear friction", "1/s"),
    "quadratic": ("quadratic friction", "1/rad"),
    "dry": ("dry friction", "rad/s^2"),
    "presliding": ("presliding angle", "rad"),
}
MODELS = {
    "none": "no friction",
    "linear": "linear friction",
    "quadratic": "linear and quadratic friction",
    "dry": "linear, quadratic and dry friction",
    "presliding": "linear, quadratic, dry and presliding friction",
}
RMS_UNITS = {"angle": "deg", "velocity": "deg/s", "acceleration": "m/s^2"}
# Words before the sentence of a verdict.
GRADES = {"refuted": "DO NOT QUOTE", "warning": "warning", "note": "note"}


def model_words(fit: Any) -> str:
    """The friction model in words."""
    if fit._given.kind in ("gate", "swings") and fit.model == "none":
        return "the exact period of each swing"
    return MODELS[str(fit.model)]


def small(u: float, whole: float) -> str:
    """A part of an uncertainty to two digits, 0 where it does not count."""
    return f"{u:.2g}" if u > 1e-6 * whole else "0"


def text(fit: Any) -> str:
    """The whole text, a line for each thing."""
    lines = pairs(fit)
    width = max(len(label) for label, _ in lines)
    return "\n".join(f"{label:{width}}  {each}".rstrip() for label, each in lines)


def pairs(fit: Any) -> list[tuple[str, str]]:
    """Labels and texts; a text that goes on has no label."""
    blank = [("", "")]
    lines = [("file", fit._given.name), *labelled("understood", fit.understood), *labelled("dropped", left_out(fit))]
    lines += [("window", window(fit)), *blank, *ladder(fit), *blank, *result(fit), *blank, *budget(fit)]
    found = [(GRADES[grade], each) for grade, each in zip(fit._grades, fit.verdicts, strict=True)]
    if found:
        lines += [*blank, *found]
    return [*lines, *blank, ("to quote", sentence(fit))]


def labelled(label: str, texts: Sequence[str]) -> list[tuple[str, str]]:
    """The first text with the label, the others below."""
    return [(label if number == 0 else "", each) for number, each in enumerate(texts)]


def left_out(fit: Any) -> list[str]:
    """What the reader and the fit left out, a sentence each."""
    told = [each["sentence"] for each in fit._given.dropped]
    for each in fit.dropped:
        if "rows" in each:
            count, rows = each["count"], ", ".join(str(row + 1) for row in each["rows"][:5])
            word = "row" if count == 1 else "rows"
            told.append(f"{count} {word}: {each['reason']} ({word} {rows}{', ...' if count > 5 else ''})")
    return told or ["nothing"]


def window(fit: Any) -> str:
    """What was fitted."""
    found = fit._found
    swing = f"; the largest swing is {math.degrees(fit.swing):.1f} deg" if math.isfinite(fit.swing) else ""
    if fit._given.kind in ("gate", "swings"):
        return f"all {found['samples']} periods{swing}"
    first, last = fit.window
    return f"{first:.4g} s to {last:.4g} s, {found['window_reason']}: {found['samples']} samples{swing}"


def rms(fit: Any, value: float) -> str:
    """A root mean square residual with its unit."""
    unit = RMS_UNITS.get(fit._given.kind)
    if unit is None:
        return f"{1000 * value:.3g} ms"
    return f"{math.degrees(value) if unit.startswith('deg') else value:.3g} {unit}"


def ladder(fit: Any) -> list[tuple[str, str]]:
    """Every friction model that was tried, with the chosen one named."""
    steps = fit._found["ladder"]
    chosen = ("model", model_words(fit))
    if len(steps) < 2:
        return [chosen]
    rows = [("with", "rms", "omega0 in rad/s")]
    for each in steps:
        mark = " <- chosen" if each["model"] == fit.model else ""
        held = f" (held at 0: {', '.join(each['wanted_negative'])})" if each["wanted_negative"] else ""
        rows.append((str(each["model"]), rms(fit, each["rms"]), f"{each['omega0']:.6f}{held}{mark}"))
    wide = [max(len(row[column]) for row in rows) for column in (0, 1)]
    table = [f"{name:{wide[0]}}  {left:>{wide[1]}}  {right}" for name, left, right in rows]
    return [chosen, *labelled("tried", table)]


def result(fit: Any) -> list[tuple[str, str]]:
    """The numbers."""
    lines = [("omega0", f"{fit.omega0} rad/s")]
    given = fit._found["length_given"]
    if fit.g is not None and fit.length is not None:
        g, length = f"{fit.g} m/s^2", f"{fit.length} m"
        lines += [("length", f"{length} (given)"), ("g", g)] if given else [("g", f"{g} (given)"), ("length", length)]
    for name, each in fit.friction.items():
        label, unit = TERMS[name]
        lines.append((label, f"{each} {unit}"))
    if fit._found["offset_deg"] is not None and fit._given.kind == "angle":
        offset = fit._found["offset_deg"]
        lines.append(("rest at", f"{rounded(offset['value'], offset['u'])} deg"))
    if fit.scale is not None:
        sensor = fit._given.kind == "acceleration"
        lines.append(("sensor at", f"{fit.scale} m from the pivot") if sensor else ("scale of angle", str(fit.scale)))
    return [*lines, ("rms residual", rms(fit, fit.rms))]


def quoted(fit: Any) -> tuple[str, Estimate, str]:
    """Name, value and unit of what the record was measured for."""
    if fit.g is None or fit.length is None:
        return "omega0", fit.omega0, "rad/s"
    return ("g", fit.g, "m/s^2") if fit._found["length_given"] else ("length", fit.length, "m")


def budget_rows(fit: Any) -> list[tuple[str, float]]:
    """The parts of the uncertainty of what is quoted; without what is only for comparison."""
    rows = [(str(row["source"]), row["u"]) for row in fit._found["budget"]]
    kept = [(source, u) for source, u in rows if not source.startswith("as if") and (source != "corrections" or u)]
    return [(source, math.nan if u is None else float(u)) for source, u in kept]


def naive(fit: Any) -> float | None:
    """The uncertainty as if residuals were independent."""
    found = [row["u"] for row in fit._found["budget"] if str(row["source"]).startswith("as if")]
    return float(found[0]) if found and found[0] is not None else None


def budget(fit: Any) -> list[tuple[str, str]]:
    """The budget of uncertainty."""
    name, value, unit = quoted(fit)
    lines = [(f"u of {name}", f"{value.u:.2g} {unit}, of which")]
    lines += [("", f"{small(u, value.u)}  {source}") for source, u in budget_rows(fit)]
    alone = naive(fit)
    if alone is not None:
        lines.append(("", f"({alone:.2g}  {unit}, if the residuals were independent; they are not taken so)"))
    exact = {"g": "length", "length": "gravity"}.get(name)
    if exact and any(source == exact and u == 0 for source, u in budget_rows(fit)):
        lines.append(("", f"The {exact} was given without an uncertainty and is taken as exact."))
    return lines


def sentence(fit: Any) -> str:
    """What a report quotes."""
    if not fit.stands:
        return f"nothing: {fit.verdicts[0]}"
    name, value, unit = quoted(fit)
    found: Any = fit._found
    record = "periods" if fit._given.kind in ("gate", "swings") else "samples"
    swing = f" of swings up to {math.degrees(fit.swing):.0f} deg" if math.isfinite(fit.swing) else ""
    periods = fit._given.kind in ("gate", "swings") and fit.model == "none"
    equation = model_words(fit) if periods else f"the pendulum equation with {model_words(fit)}"
    how = f"from {found['samples']} {record}{swing}, fitted by {equation}"
    return f"{name} = {value} {unit} (standard uncertainty, k = 1; {value.expanded:.2g} {unit} at k = 2), {how}."
