"""A fit in plain lines: what was understood and left out, window, ladder, result, budget, verdicts, the sentence to quote.

The parts that a page shows too are in three languages.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from ._estimate import Estimate, rounded
from ._words import Words

ENGLISH = Words("en")
# Name and unit of each friction term.
TERMS = {
    "linear": ("linear friction", "1/s"),
    "quadratic": ("quadratic friction", "1/rad"),
    "dry": ("dry friction", "rad/s^2"),
    "presliding": ("presliding angle", "rad"),
}
# Term of the equation and letter of each; dry friction changes its sign over the presliding angle, not at once.
SYMBOLS = {
    "linear": ("2γθ′", "γ"),
    "quadratic": ("β|θ′|θ′", "β"),
    "dry": ("μ sgn θ′", "μ"),
    "presliding": ("", "δ"),
}
RMS_UNITS = {"angle": "deg", "velocity": "deg/s", "acceleration": "m/s^2"}
# Words before the sentence of a verdict.
GRADES = {"refuted": "DO NOT QUOTE", "warning": "warning", "note": "note"}


def model_words(fit: Any, say: Words = ENGLISH) -> str:
    """The friction in words: the terms that act."""
    if fit._given.kind in ("gate", "swings") and fit.model == "none":
        return say.word("the exact period of each swing")
    terms = [say.word(name) for name in fit.friction]
    if not terms:
        return say.word("no friction")
    *first, last = terms
    joined = say.word("{first} and {last}", first=", ".join(first), last=last) if first else last
    return say.word("{terms} friction", terms=joined)


def small(u: float, whole: float) -> str:
    """A part of an uncertainty to two digits, 0 where it does not count, `not known` where it is no number."""
    if math.isnan(u):
        return "not known"
    return f"{u:.2g}" if u > 1e-6 * whole else "0"


def text(fit: Any, say: Words = ENGLISH) -> str:
    """The whole text, a line for each thing."""
    return in_columns(pairs(fit, say))


def in_columns(lines: Sequence[tuple[str, str]]) -> str:
    """Labels, and texts in a second column."""
    width = max(len(label) for label, _ in lines)
    return "\n".join(f"{label:{width}}  {each}".rstrip() for label, each in lines)


def pairs(fit: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """Labels and texts; a text that goes on has no label."""
    blank = [("", "")]
    lines = [*read(fit, say), *blank, *ladder(fit, say), *blank, *result(fit, say), *corrections(fit, say)]
    found = verdict_lines(fit, say)
    ending = [*blank, (say.word("to quote"), sentence(fit, say))]
    return [*lines, *blank, *budget(fit, say), *([*blank, *found] if found else []), *ending]


def read(fit: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """What was read, left out and fitted."""
    lines = [
        (say.word("file"), fit._given.name),
        *labelled(say.word("understood"), list(map(say.told, fit.understood))),
    ]
    return [*lines, *labelled(say.word("dropped"), left_out(fit, say)), (say.word("window"), window(fit, say))]


def verdict_lines(fit: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """What speaks against the result."""
    return [(say.word(GRADES[grade]), say.told(each)) for grade, each in zip(fit._grades, fit.verdicts, strict=True)]


def labelled(label: str, texts: Sequence[str]) -> list[tuple[str, str]]:
    """The first text with the label, the others below."""
    return [(label if number == 0 else "", each) for number, each in enumerate(texts)]


def left_out(fit: Any, say: Words = ENGLISH) -> list[str]:
    """What the reader and the fit left out, a sentence each."""
    told = [say.told(each["sentence"]) for each in fit._given.dropped]
    for each in fit.dropped:
        if "rows" in each:
            count, rows = each["count"], ", ".join(str(row + 1) for row in each["rows"][:5])
            form = "{count} row: {reason} (row {rows})" if count == 1 else "{count} rows: {reason} (rows {rows})"
            more = ", ..." if count > 5 else ""
            told.append(say.word(form, count=str(count), reason=say.told(each["reason"]), rows=rows + more))
    return told or [say.word("nothing")]


def window(fit: Any, say: Words = ENGLISH) -> str:
    """What was fitted."""
    found = fit._found
    known = math.isfinite(fit.swing)
    degrees = say.decimal(f"{math.degrees(fit.swing):.1f}")
    swing = say.word("; the largest swing is {swing} deg", swing=degrees) if known else ""
    count = str(found["samples"])
    if fit._given.kind in ("gate", "swings"):
        return say.word("all {count} periods{swing}", count=count, swing=swing)
    first, last = (say.decimal(each) for each in told_apart(*fit.window))
    reason = say.word(str(found["window_reason"]))
    form = "{first} s to {last} s, {reason}: {count} samples{swing}"
    return say.word(form, first=first, last=last, reason=reason, count=count, swing=swing)


def told_apart(first: float, last: float) -> tuple[str, str]:
    """Two times to four digits; of stamps that are far from 0, to four digits of the time between them."""
    if max(abs(first), abs(last)) < 1000.0 * (last - first):
        return f"{first:.4g}", f"{last:.4g}"
    places = max(0, 3 - math.floor(math.log10(last - first))) if last > first else 0
    return f"{first:.{places}f}", f"{last:.{places}f}"


def rms(fit: Any, value: float) -> str:
    """A root mean square residual with its unit."""
    unit = RMS_UNITS.get(fit._given.kind)
    if unit is None:
        return f"{1000 * value:.3g} ms"
    return f"{math.degrees(value) if unit.startswith('deg') else value:.3g} {unit}"


def ladder(fit: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """Every friction model that was tried, with the chosen one named."""
    steps = fit._found["ladder"]
    chosen = (say.word("model"), model_words(fit, say))
    if len(steps) < 2:
        return [chosen]
    rows = [(say.word("with"), say.word("rms"), say.word("omega0 in rad/s"))]
    for each in steps:
        mark = say.word(" <- chosen") if each["model"] == fit.model else ""
        wanted = ", ".join(say.word(str(name)) for name in each["wanted_negative"])
        held = say.word(" (held at 0: {terms})", terms=wanted) if wanted else ""
        numbers = say.decimal(rms(fit, each["rms"])), say.decimal(f"{each['omega0']:.6f}")
        rows.append((say.word(str(each["model"])), numbers[0], f"{numbers[1]}{held}{mark}"))
    wide = [max(len(row[column]) for row in rows) for column in (0, 1)]
    table = [f"{name:{wide[0]}}  {left:>{wide[1]}}  {right}" for name, left, right in rows]
    return [chosen, *labelled(say.word("tried"), table)]


def result(fit: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """The numbers."""
    lines = [("omega0", f"{fit.omega0} rad/s"), *quantities(fit, fit._found["length_given"], say)]
    for name, each in fit.friction.items():
        label, unit = TERMS[name]
        lines.append((say.word(label), f"{each} {unit}"))
    if fit._found["offset_deg"] is not None and fit._given.kind == "angle":
        offset = fit._found["offset_deg"]
        lines.append((say.word("rest at"), f"{rounded(offset['value'], offset['u'])} deg"))
    if fit.scale is not None:
        sensor = fit._given.kind == "acceleration"
        at = say.word("{value} m from the pivot", value=str(fit.scale))
        lines.append((say.word("sensor at"), at) if sensor else (say.word("scale of angle"), str(fit.scale)))
    return [(label, say.decimal(each)) for label, each in [*lines, (say.word("rms residual"), rms(fit, fit.rms))]]


def quantities(found: Any, length_given: bool, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """g and the length of a result, the given one first; and what Monte Carlo says."""
    lines = []
    if found.g is not None and found.length is not None:
        g, length = f"{found.g} m/s^2", f"{found.length} m"
        given = say.word("{value} (given)", value=length if length_given else g)
        both = [("g", given), (say.word("length"), length)]
        lines = [(say.word("length"), given), ("g", g)] if length_given else both
    drawn = found._found.get("monte_carlo")
    if drawn is not None:
        _, value, unit = quoted(found)
        low, high = (like(each, value.u) for each in drawn)
        lines.append((say.word("Monte Carlo, 95 %"), say.word("{low} to {high} {unit}", low=low, high=high, unit=unit)))
    return lines


def like(value: float, u: float) -> str:
    """A value to the digits that an uncertainty leaves."""
    return rounded(value, u).partition(" ±")[0].removeprefix("(") if u > 0 else f"{value:.6g}"


def corrections(found: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """What bob, wire and air do to the period."""
    rows = correction_rows(found, say)
    if not rows:
        return []
    wide = max(len(name) for name, _, _ in rows)
    form = "{change} of the period, corrected: {made}"
    table = [f"{name:{wide}}  {say.word(form, change=f'{change:>9}', made=made)}" for name, change, made in rows]
    return [("", ""), *labelled(say.word("corrections"), table)]


def correction_rows(found: Any, say: Words = ENGLISH) -> list[tuple[str, str, str]]:
    """Name, relative change of the period, and whether it was corrected."""
    made = {True: "yes", False: "no"}
    of_none = "no: neither g nor the length is quoted"
    return [
        (
            say.word(str(row["name"])),
            say.decimal(f"{row['relative_period']:+.2g}"),
            say.word(made[bool(row["made"])] if found.g is not None else of_none),
        )
        for row in found._found.get("corrections") or ()
    ]


def quoted(found: Any) -> tuple[str, Estimate, str]:
    """Name, value and unit of what the record was measured for."""
    if found.g is None:
        return "omega0", found.omega0, "rad/s"
    if found._found.get("length_given", found._found.get("length") is None) or found.length is None:
        return "g", found.g, "m/s^2"
    return "length", found.length, "m"


def budget_rows(found: Any) -> list[tuple[str, float]]:
    """The parts of the uncertainty of what is quoted; without what is only for comparison."""
    rows = [(str(row["source"]), row["u"]) for row in found._found["budget"]]
    kept = [(source, u) for source, u in rows if not source.startswith("as if") and (source != "corrections" or u)]
    return [(source, math.nan if u is None else float(u)) for source, u in kept]


def naive(found: Any) -> float | None:
    """The uncertainty as if residuals were independent."""
    rows = [row["u"] for row in found._found["budget"] if str(row["source"]).startswith("as if")]
    return float(rows[0]) if rows and rows[0] is not None else None


def budget(found: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """The budget of uncertainty."""
    name, value, unit = quoted(found)
    head = say.word("u of {name}", name=say.word(name))
    lines = [(head, say.word("{u} {unit}, of which", u=say.decimal(f"{value.u:.2g}"), unit=unit))]
    rows = [(say.decimal(small(u, value.u)), say.word(source)) for source, u in budget_rows(found)]
    wide = max(len(u) for u, _ in rows)
    lines += [("", f"{u:{wide}}  {source}") for u, source in rows]
    alone = naive(found)
    if alone is not None:
        form = "({u} {unit}, if the residuals were independent; they are not taken so)"
        lines.append(("", say.word(form, u=say.decimal(f"{alone:.2g}"), unit=unit)))
    exact = taken_as_exact(found, say)
    return [*lines, ("", exact)] if exact else lines


def taken_as_exact(found: Any, say: Words = ENGLISH) -> str:
    """The sentence about a length or a g that was given without an uncertainty, or none."""
    other = {"g": "length", "length": "gravity"}.get(quoted(found)[0], "")
    if any(source == other and u == 0 for source, u in budget_rows(found)):
        return say.word(f"The {other} was given without an uncertainty and is taken as exact.")
    return ""


def sentence(fit: Any, say: Words = ENGLISH) -> str:
    """What a report quotes."""
    if not fit.stands:
        return say.word("nothing: {verdict}", verdict=say.told(fit.verdicts[0]))
    periods = fit._given.kind in ("gate", "swings")
    swings = (
        say.word(" of swings up to {swing} deg", swing=f"{math.degrees(fit.swing):.0f}")
        if math.isfinite(fit.swing)
        else ""
    )
    form = (
        "from {count} periods{swings}, fitted by {equation}"
        if periods
        else "from {count} samples{swings}, fitted by {equation}"
    )
    equation = {"equation": equation_words(fit, say), "swings": swings}
    return quoting(fit, say.word(form, count=str(fit._found["samples"]), **equation), say)


def equation_words(fit: Any, say: Words = ENGLISH) -> str:
    """The equation that was fitted."""
    if fit._given.kind in ("gate", "swings") and fit.model == "none":
        return model_words(fit, say)
    if not fit.friction:
        return say.word("the pendulum equation without friction")
    return say.word("the pendulum equation with {friction}", friction=model_words(fit, say))


def equation(fit: Any, say: Words = ENGLISH) -> str:
    """The equation with the terms that act and what their letters are, or nothing of periods alone."""
    if fit._given.kind in ("gate", "swings"):
        return ""
    acting = [SYMBOLS[name] for name in fit.friction]
    shown = " + ".join(["θ″", *(term for term, _ in acting if term), "ω₀² sin θ"])
    letters = [f"{letter} = {say.word(TERMS[name][0])}" for name, (_, letter) in zip(fit.friction, acting, strict=True)]
    return say.word("Equation: {equation} = 0", equation=shown) + "".join(f"; {each}" for each in letters)


def quoting(found: Any, how: str, say: Words = ENGLISH) -> str:
    """The quantity with its uncertainties, and how it was found."""
    name, value, unit = quoted(found)
    parts: Mapping[str, str] = {
        "quantity": say.word(name),
        "value": say.decimal(str(value)),
        "unit": unit,
        "expanded": say.decimal(f"{value.expanded:.2g}"),
    }
    return say.word(
        "{quantity} = {value} {unit} (standard uncertainty, k = 1; {expanded} {unit} at k = 2), {how}.",
        how=how,
        **parts,
    )
