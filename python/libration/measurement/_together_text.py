"""Records together in plain lines: each in short, a table of them, what they share, budget, verdicts, the sentence to quote."""

import math
from typing import Any

from ._estimate import rounded
from ._text import (
    ENGLISH,
    GRADES,
    budget,
    corrections,
    equation_words,
    in_columns,
    labelled,
    ladder,
    quantities,
    quoting,
    read,
    rms,
    verdict_lines,
)
from ._words import Words

KINDS = {
    "runs": "runs of one pendulum",
    "lengths": "one g at several lengths",
    "reversible": "a reversible pendulum",
}


def text(found: Any, say: Words = ENGLISH) -> str:
    """The whole text."""
    blank = [("", "")]
    lines: list[tuple[str, str]] = []
    for number, fit in enumerate(found.fits, start=1):
        # What was tried is for one record alone.
        lines += [
            (f"{say.word('record')} {number}", fit._given.name),
            *read(fit, say)[1:],
            ladder(fit, say)[0],
            (say.word("rms residual"), say.decimal(rms(fit, fit.rms))),
            *verdict_lines(fit, say),
            *blank,
        ]
    lines += [*labelled(say.word("together"), [say.word(KINDS[found.kind]), *table_lines(found, say)])]
    lines += [*blank, *result(found, say)]
    lines += [*corrections(found, say), *blank, *budget(found, say)]
    told = [(say.word(GRADES[grade]), say.told(each)) for grade, each in found._told()]
    return in_columns(
        [*lines, *([*blank, *told] if told else []), *blank, (say.word("to quote"), sentence(found, say))]
    )


def table_lines(found: Any, say: Words = ENGLISH) -> list[str]:
    """The rows of the records in columns."""
    heads, rows = table(found, say)
    numbered = [("", *heads), *((str(number), *row[1:]) for number, row in enumerate(rows, start=1))]
    numbered[0] = ("", *heads[1:])
    wide = [max(len(row[column]) for row in numbered) for column in range(len(numbered[0]))]
    return ["  ".join(f"{each:{width}}" for each, width in zip(row, wide, strict=True)).rstrip() for row in numbered]


def table(found: Any, say: Words = ENGLISH) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Heads and rows: the record, what is known of it alone, omega0, the largest swing, friction, residual."""
    apart = found._apart.lengths or found._apart.pivots
    name = {"lengths": "length", "reversible": "pivot"}.get(found.kind)
    heads = [say.word("record"), *([f"{say.word(name)} (m)"] if name else []), "omega0 (rad/s)"]
    heads += [f"{say.word('swing')} (°)", say.word("friction"), say.word("rms residual")]
    rows = []
    for number, fit in enumerate(found.fits):
        swing = f"{math.degrees(fit.swing):.1f}" if math.isfinite(fit.swing) else ""
        own = [rounded(*apart[number]) if number < len(apart) else ""] if apart else []
        numbers = [*own, str(fit.omega0), swing]
        row = [fit._given.name, *map(say.decimal, numbers), say.word(fit.model), say.decimal(rms(fit, fit.rms))]
        rows.append(tuple(row))
    return tuple(heads), rows


def result(found: Any, say: Words = ENGLISH) -> list[tuple[str, str]]:
    """The numbers that the records share."""
    lines = [] if found.omega0 is None else [("omega0", f"{found.omega0} rad/s")]
    given = found.g is not None and found._found.get("omega0") is not None
    if given:
        lines += quantities(found, found._found["length_given"], say)
    elif found.g is not None:
        lines.append(("g", f"{found.g} m/s^2"))
    elif found._found.get("monte_carlo"):
        lines += quantities(found, False, say)
    if found.length_offset is not None:
        lines.append((say.word("missing in each length"), f"{found.length_offset} m"))
    if found._apart.between is not None:
        lines.append((say.word("distance between"), f"{rounded(*found._apart.between)} m"))
    if found.chi_squared is not None:
        lines.append((say.word("agreement"), agreement(found, say)))
    return [(label, say.decimal(each)) for label, each in lines]


def agreement(found: Any, say: Words = ENGLISH) -> str:
    """Chi squared in words."""
    chi, freedom = found.chi_squared
    if freedom == 1:
        return say.word("chi squared {chi} for 1 degree of freedom", chi=f"{chi:.2g}")
    return say.word("chi squared {chi} for {count} degrees of freedom", chi=f"{chi:.3g}", count=str(freedom))


def sentence(found: Any, say: Words = ENGLISH) -> str:
    """What a report quotes."""
    if not found.stands:
        name, _, verdict = found.verdicts[0].partition(": ")
        told = say.told(found.verdicts[0]) if "refuted" in found._grades else f"{name}: {say.told(verdict)}"
        return say.word("nothing: {verdict}", verdict=told)
    count = str(len(found.fits))
    if found.kind == "reversible":
        how = say.word("from the periods about both pivots of a reversible pendulum")
    elif found.kind == "lengths":
        common = found.length_offset is not None
        form = "from {count} lengths with a common error of them" if common else "from {count} lengths"
        how = say.word(form, count=count)
    else:
        how = say.word("from {count} records of one pendulum", count=count)
    # The equation of the record with most friction terms.
    return quoting(found, f"{how}, {fitted_by(found, say)}", say)


def fitted_by(found: Any, say: Words = ENGLISH) -> str:
    """The equation, of the record whose friction has most terms."""
    most = max(found.fits, key=lambda fit: len(fit.friction))
    return say.word("fitted by {equation}", equation=equation_words(most, say))
