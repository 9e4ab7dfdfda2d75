"""A fit as one HTML page that needs no other file; pictures are SVG within it, narrower ones on a narrow screen."""

import re
from collections.abc import Callable, Sequence
from html import escape
from io import BytesIO
from typing import Any

from ._text import GRADES, budget_rows, left_out, model_words, naive, quoted, result, rms, sentence, small, window

# In inches; a narrow screen has the second.
WIDE, NARROW = 8.0, 4.0
STYLE = """\
:root{color-scheme:light}
body{font:16px/1.5 system-ui,"Segoe UI",Roboto,"Liberation Sans",sans-serif;color:#1a1a1a;background:#fff;max-width:50rem;
margin:0 auto;padding:1rem}
h1{font-size:1.5rem;margin:.5rem 0;overflow-wrap:anywhere}h2{font-size:1.15rem;margin:2rem 0 .5rem}
.quote{border-left:4px solid #0072b2;background:#f1f7fb;padding:.75rem 1rem;margin:1rem 0}
.refuted{border-color:#c44601;background:#fdf3ee}.grade{font-weight:600}
table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:.3rem .8rem .3rem 0;border-bottom:1px solid #e2e2e2;
vertical-align:top}th{font-weight:600}th+th,td.number{text-align:right;font-variant-numeric:tabular-nums}
th:last-child,td:last-child{padding-right:0}
.chosen{background:#f1f7fb}ul{padding-left:1.2rem}figure{margin:0}svg{width:100%;height:auto;display:block}
li,p{overflow-wrap:anywhere}.narrow{display:none}.small{color:#555;font-size:.9rem}
@media(max-width:600px){.wide{display:none}.narrow{display:block}}
@media print{body{max-width:none}}
"""


def page(fit: Any) -> str:
    """The page."""
    name = escape(fit._given.name)
    parts = [f"<h1>Pendulum fit: {name}</h1>", quote(fit), verdicts(fit), "<h2>Result</h2>", numbers(fit)]
    parts += ["<h2>Data with the fitted curve, and residuals</h2>", pictures(fit)]
    against = swings(fit)
    if against:
        parts += ["<h2>Period against swing</h2>", against]
        parts.append(
            '<p class="small">Each dot is one period of the record; the curve is the exact law at the fitted omega0.</p>'
        )
    parts += ["<h2>Budget of uncertainty</h2>", budget(fit)]
    if fit._found["ladder"]:
        parts += ["<h2>Friction models</h2>", ladder(fit)]
    parts += ["<h2>What was read</h2>", listed([*fit.understood, f"Fitted: {window(fit)}."])]
    parts += ["<h2>What was left out</h2>", listed(left_out(fit))]
    from .. import __version__

    parts.append(
        f'<p class="small">Made by libration {__version__}. Uncertainties are standard ones, k = 1 (JCGM 100:2008).</p>'
    )
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    body = "\n".join(part for part in parts if part)
    body = body.replace("^2", "²").replace("omega0", "ω₀")
    return (
        f'<!doctype html>\n<html lang="en">\n<head>{head}<title>Pendulum fit: {name}</title>\n'
        f"<style>{STYLE}</style></head>\n<body>\n{body}\n</body>\n</html>\n"
    )


def quote(fit: Any) -> str:
    """The sentence to quote."""
    kind = "quote" if fit.stands else "quote refuted"
    return f'<p class="{kind}"><span class="grade">To quote:</span> {escape(sentence(fit))}</p>'


def verdicts(fit: Any) -> str:
    """What speaks against the result."""
    found = zip(fit._grades, fit.verdicts, strict=True)
    rows = [f'<li><span class="grade">{GRADES[grade]}:</span> {escape(each)}</li>' for grade, each in found]
    return f"<h2>Verdicts</h2><ul>{''.join(rows)}</ul>" if rows else ""


def table(rows: Sequence[tuple[str, ...]], heads: tuple[str, ...] = (), chosen: int = -1) -> str:
    """Rows whose first column is words."""
    head = "<tr>" + "".join(f"<th>{escape(each)}</th>" for each in heads) + "</tr>" if heads else ""
    made = []
    for number, (first, *others) in enumerate(rows):
        mark = ' class="chosen"' if number == chosen else ""
        cells = "".join(f'<td class="number">{escape(each)}</td>' for each in others)
        made.append(f"<tr{mark}><td>{escape(first)}</td>{cells}</tr>")
    return f"<table>{head}{''.join(made)}</table>"


def numbers(fit: Any) -> str:
    """The numbers of the result."""
    return table([*result(fit), ("model", model_words(fit))])


def budget(fit: Any) -> str:
    """Every part of the uncertainty of what is quoted, and what they combine to."""
    name, value, unit = quoted(fit)
    total = sum(u * u for _, u in budget_rows(fit))
    rows = [
        (source, small(u, value.u), f"{100 * u * u / total:.0f} %" if total > 0 else "")
        for source, u in budget_rows(fit)
    ]
    rows.append((f"{name}, combined", f"{value.u:.2g}", "100 %" if total > 0 else ""))
    rows.append((f"{name}, expanded (k = 2)", f"{value.expanded:.2g}", ""))
    made = table(rows, ("source", f"u in {unit}", "of the variance"), len(rows) - 2)
    alone = naive(fit)
    if alone is None:
        return made
    note = f"If the residuals were independent, the fit's part would be {alone:.2g} {unit}; it is not taken so."
    return f'{made}<p class="small">{escape(note)}</p>'


def ladder(fit: Any) -> str:
    """Every friction model that was tried."""
    steps: list[dict[str, Any]] = fit._found["ladder"]
    rows = [(str(each["model"]), rms(fit, each["rms"]), f"{each['omega0']:.6f}") for each in steps]
    chosen = [str(each["model"]) for each in steps].index(fit.model)
    return table(rows, ("friction", "rms residual", "omega0 in rad/s"), chosen)


def listed(texts: list[str]) -> str:
    """Sentences as a list."""
    return f"<ul>{''.join(f'<li>{escape(each)}</li>' for each in texts)}</ul>"


def pictures(fit: Any) -> str:
    """Data and residuals."""
    from ..plot._fit import draw_both
    from ..plot._language import ENGLISH

    return both(
        lambda figure: draw_both(figure, fit, ENGLISH), (5.6, 4.6), "Data with the fitted curve; residuals below", "a"
    )


def swings(fit: Any) -> str:
    """Period against swing, where the record shows it."""
    from ..plot._fit import draw_swings, swings_of
    from ..plot._language import ENGLISH

    if swings_of(fit)[0].size < 3:
        return ""

    def draw(figure: Any) -> None:
        draw_swings(figure.subplots(), fit, ENGLISH)

    return both(draw, (3.6, 3.2), "Period against swing", "b")


def both(draw: Callable[[Any], None], heights: tuple[float, float], said: str, mark: str) -> str:
    """One picture for wide and one for narrow screens."""
    from ..plot._style import save_figure

    made = []
    for kind, width, height in (("wide", WIDE, heights[0]), ("narrow", NARROW, heights[1])):
        file = BytesIO()
        save_figure({"svg": file}, (width, height), draw, dpi=150)
        svg = file.getvalue().decode()
        svg = own_ids(svg[svg.index("<svg") :], f"{mark}{kind[0]}")
        svg = svg.replace("<svg", f'<svg role="img" aria-label="{said}"', 1)
        made.append(f'<figure class="{kind}">{svg}</figure>')
    return "".join(made)


def own_ids(svg: str, mark: str) -> str:
    """Names that no other picture of the page has."""
    svg = re.sub(r'\bid="', f'id="{mark}-', svg)
    svg = re.sub(r'href="#', f'href="#{mark}-', svg)
    return svg.replace("url(#", f"url(#{mark}-")
