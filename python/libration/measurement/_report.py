"""A fit, or several together, as one HTML page that needs no other file, in a light and a dark theme.

Pictures are SVG within it, narrower ones on a narrow screen; their colours are those of the page.
"""

import re
from collections.abc import Callable, Sequence
from html import escape
from io import BytesIO
from typing import Any

from . import _text, _together_text
from ._page import STYLE, themed
from ._words import Words

# Before a number, not within one.
MINUS = re.compile(r"(?<![^\s(])-(?=[0-9])")
# In inches; a narrow screen has the second.
WIDE, NARROW = 8.0, 4.0


def page(fit: Any, lang: str = "en") -> str:
    """The page of one record."""
    say = Words(lang)
    title = say.word("Pendulum fit: {name}", name=file_name(fit))
    parts = [place(fit), quote(fit, _text.sentence(fit, say), say), verdicts(told(fit), say), heading("Result", say)]
    return whole(title, [*parts, *record(fit, say, "a")], say)


def page_together(found: Any, lang: str = "en") -> str:
    """The page of several records: what they share, then each."""
    say = Words(lang)
    title = say.word("{count} records together", count=str(len(found.fits)))
    parts = [quote(found, _together_text.sentence(found, say), say), verdicts(found._told(), say)]
    heads, rows = _together_text.table(found, say)
    shared = [(say.word("together"), say.word(_together_text.KINDS[found.kind])), *_together_text.result(found, say)]
    parts += [heading("What the records share", say), table(shared), scrolled(table(rows, heads))]
    parts += [picture_together(found, say), *corrected(found, say), *uncertain(found, say)]
    for number, fit in enumerate(found.fits, start=1):
        parts += [f"<h1>{number}. {escape(file_name(fit))}</h1>", place(fit), verdicts(told(fit), say)]
        parts += record(fit, say, f"r{number}", shared=True)
    return whole(title, parts, say)


def file_name(fit: Any) -> str:
    """The name of its file without the folder."""
    return str(fit._given.name).replace("\\", "/").rpartition("/")[2] or str(fit._given.name)


def place(fit: Any) -> str:
    """The path of its file, where it is more than the name."""
    name = str(fit._given.name)
    return f'<p class="small">{escape(name)}</p>' if name != file_name(fit) else ""


def record(fit: Any, say: Words, mark: str, shared: bool = False) -> list[str]:
    """What a page says of a record."""
    numbers = [*_text.result(fit, say), (say.word("model"), _text.model_words(fit, say))]
    law = _text.equation(fit, say)
    parts = [table(numbers), f'<p class="small">{escape(law)}</p>' if law else ""]
    parts += [heading("Data with the fitted curve, and residuals", say), pictures(fit, say, mark)]
    against = swings(fit, say, mark)
    if against:
        note = say.word("Each dot is one period of the record; the curve is the exact law at the fitted omega0.")
        parts += [heading("Period against swing", say), against, f'<p class="small">{note}</p>']
    if not shared:
        parts += [*corrected(fit, say), *uncertain(fit, say)]
    if fit._found["ladder"]:
        parts += [heading("Friction models", say), ladder(fit, say)]
    fitted = say.word("Fitted: {window}.", window=_text.window(fit, say))
    parts += [heading("What was read", say), listed([*map(say.told, fit.understood), fitted])]
    return [*parts, heading("What was left out", say), listed(_text.left_out(fit, say))]


def whole(title: str, parts: Sequence[str], say: Words) -> str:
    """The file."""
    from .. import __version__

    made = say.word(
        "Made by libration {version}. Uncertainties are standard ones, k = 1 (JCGM 100:2008).", version=__version__
    )
    body = "\n".join([f"<h1>{escape(title)}</h1>", *filter(None, parts), f'<p class="small">{made}</p>'])
    body = re.sub(r"(?<=\d) deg\b", "°", body.replace("^2", "²").replace("omega0", "ω₀"))
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    head += '<meta name="color-scheme" content="light dark">'
    return (
        f'<!doctype html>\n<html lang="{say.name}">\n<head>{head}<title>{escape(title)}</title>\n'
        f"<style>{STYLE}</style></head>\n<body>\n{body}\n</body>\n</html>\n"
    )


def heading(text: str, say: Words) -> str:
    """A heading."""
    return f"<h2>{escape(say.word(text))}</h2>"


def quote(found: Any, sentence: str, say: Words) -> str:
    """The sentence to quote."""
    kind = "quote" if found.stands else "quote refuted"
    return f'<p class="{kind}"><span class="grade">{say.word("To quote:")}</span> {escape(sentence)}</p>'


def told(fit: Any) -> list[tuple[str, str]]:
    """Grades and sentences."""
    return list(zip(fit._grades, fit.verdicts, strict=True))


def verdicts(found: Sequence[tuple[str, str]], say: Words) -> str:
    """What speaks against the result."""
    rows = [
        f'<li><span class="grade {grade}">{escape(say.word(_text.GRADES[grade]))}:</span> {escape(say.told(each))}</li>'
        for grade, each in found
    ]
    return f"{heading('Verdicts', say)}<ul>{''.join(rows)}</ul>" if rows else ""


def table(rows: Sequence[tuple[str, ...]], heads: tuple[str, ...] = (), chosen: int = -1) -> str:
    """Rows whose first column is words."""
    head = "<tr>" + "".join(f"<th>{escape(each)}</th>" for each in heads) + "</tr>" if heads else ""
    made = []
    for number, (first, *others) in enumerate(rows):
        mark = ' class="chosen"' if number == chosen else ""
        cells = "".join(f'<td class="number">{escape(MINUS.sub("−", each))}</td>' for each in others)
        made.append(f"<tr{mark}><td>{escape(first)}</td>{cells}</tr>")
    return f"<table>{head}{''.join(made)}</table>"


def scrolled(text: str) -> str:
    """A wide table, which a narrow screen moves by itself."""
    return f'<div class="scrolled">{text}</div>'


def uncertain(found: Any, say: Words) -> list[str]:
    """Every part of the uncertainty of what is quoted, and what they combine to."""
    name, value, unit = _text.quoted(found)
    name = say.word(name)
    total = sum(u * u for _, u in _text.budget_rows(found))
    rows = [
        (say.word(source), _text.small(u, value.u), f"{100 * u * u / total:.0f} %" if total > 0 else "")
        for source, u in _text.budget_rows(found)
    ]
    rows.append((say.word("{name}, combined", name=name), f"{value.u:.2g}", "100 %" if total > 0 else ""))
    rows.append((say.word("{name}, expanded (k = 2)", name=name), f"{value.expanded:.2g}", ""))
    # A narrow screen breaks no equation.
    rows = [(source.replace("k = ", "k\u00a0=\u00a0"), say.decimal(u), share) for source, u, share in rows]
    heads = (say.word("source"), say.word("u in {unit}", unit=unit), say.word("of the variance"))
    notes = [_text.taken_as_exact(found, say)]
    alone = _text.naive(found)
    if alone is not None:
        form = "If the residuals were independent, the fit's part would be {u} {unit}; it is not taken so."
        notes.append(say.word(form, u=say.decimal(f"{alone:.2g}"), unit=unit))
    below = [f'<p class="small">{escape(each)}</p>' for each in notes if each]
    return [heading("Budget of uncertainty", say), table(rows, heads, len(rows) - 2), *below]


def corrected(found: Any, say: Words) -> list[str]:
    """What bob, wire and air do to the period."""
    rows = _text.correction_rows(found, say)
    if not rows:
        return []
    heads = (say.word("effect"), say.word("change of the period"), say.word("corrected"))
    return [heading("Corrections", say), table(rows, heads)]


def ladder(fit: Any, say: Words) -> str:
    """Every friction model that was tried."""
    steps: list[dict[str, Any]] = fit._found["ladder"]
    rows = [
        (say.word(str(each["model"])), say.decimal(_text.rms(fit, each["rms"])), say.decimal(f"{each['omega0']:.6f}"))
        for each in steps
    ]
    chosen = [str(each["model"]) for each in steps].index(fit.model)
    return table(rows, (say.word("friction"), say.word("rms residual"), say.word("omega0 in rad/s")), chosen)


def listed(texts: list[str]) -> str:
    """Sentences as a list."""
    return f"<ul>{''.join(f'<li>{escape(each)}</li>' for each in texts)}</ul>"


def pictures(fit: Any, say: Words, mark: str) -> str:
    """Data and residuals."""
    from ..plot._fit import draw_both

    said = say.word("Data with the fitted curve; residuals below")
    return both(lambda figure: draw_both(figure, fit, say), (5.6, 4.6), said, f"{mark}d")


def swings(fit: Any, say: Words, mark: str) -> str:
    """Period against swing, where the record shows it."""
    from ..plot._fit import draw_swings, swings_of

    if swings_of(fit)[0].size < 3:
        return ""

    def draw(figure: Any) -> None:
        draw_swings(figure.subplots(), fit, say)

    return both(draw, (3.6, 3.2), say.word("Period against swing"), f"{mark}s")


def picture_together(found: Any, say: Words) -> str:
    """What the records share."""
    from ..plot._together import draw_together

    said = say.word("What the records share")
    return both(lambda figure: draw_together(figure, found, say), (4.4, 3.8), said, "t")


def both(draw: Callable[[Any], None], heights: tuple[float, float], said: str, mark: str) -> str:
    """One picture for wide and one for narrow screens."""
    from ..plot._style import save_figure

    made = []
    for kind, width, height in (("wide", WIDE, heights[0]), ("narrow", NARROW, heights[1])):
        file = BytesIO()
        save_figure({"svg": file}, (width, height), draw, dpi=150)
        svg = file.getvalue().decode()
        svg = own_ids(themed(svg[svg.index("<svg") :]), f"{mark}{kind[0]}")
        svg = svg.replace("<svg", f'<svg role="img" aria-label="{escape(said)}"', 1)
        made.append(f'<figure class="{kind}">{svg}</figure>')
    return "".join(made)


def own_ids(svg: str, mark: str) -> str:
    """Names that no other picture of the page has."""
    svg = re.sub(r'\bid="', f'id="{mark}-', svg)
    svg = re.sub(r'href="#', f'href="#{mark}-', svg)
    return svg.replace("url(#", f"url(#{mark}-")
