"""How the page of a fit looks: its style in a light and a dark theme, and the colours of its pictures as those of the theme."""

import re

from ..plot._style import BLACK, EXACT, LINEAR, SEPARATRIX

# Of each colour that a picture is drawn in, the name of the page's.
COLOURS = {
    "#000000": "ink",
    BLACK: "ink",
    "#ffffff": "paper",
    "#777777": "edge",
    "#f0f0f0": "grid",
    "#cccccc": "grid",
    EXACT: "exact",
    SEPARATRIX: "data",
    LINEAR: "soft",
}
STYLE = """\
:root{color-scheme:light dark;--paper:#fff;--ink:#1a1a1a;--soft:#5f6670;--edge:#777;--grid:#e9ecef;--panel:#f1f7fb;
--exact:#0072b2;--data:#c44601;--warn:#fdf3ee}
@media(prefers-color-scheme:dark){:root{--paper:#12161b;--ink:#eceff1;--soft:#a9b3bd;--edge:#87919b;--grid:#2b333b;
--panel:#1a2630;--exact:#6cb6ec;--data:#f08a4b;--warn:#33221a}}
body{font:16px/1.5 system-ui,"Segoe UI",Roboto,"Liberation Sans",sans-serif;color:var(--ink);background:var(--paper);
max-width:50rem;margin:0 auto;padding:1rem}
h1{font-size:1.5rem;line-height:1.25;margin:.5rem 0;overflow-wrap:anywhere}
h1~h1{border-top:2px solid var(--edge);padding-top:1rem;margin-top:3rem}
h2{font-size:1.15rem;margin:2rem 0 .5rem}
.quote{border-left:4px solid var(--exact);background:var(--panel);padding:.75rem 1rem;margin:1rem 0}
.quote.refuted{border-color:var(--data);background:var(--warn)}.grade{font-weight:600}span.refuted{color:var(--data)}
table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:.3rem .8rem .3rem 0;
border-bottom:1px solid var(--grid);vertical-align:top}th{font-weight:600}
th+th,td.number{text-align:right;font-variant-numeric:tabular-nums}
th:first-child,td:first-child{padding-left:.4rem;overflow-wrap:anywhere}th:last-child,td:last-child{padding-right:.4rem}
.scrolled{overflow-x:auto;margin:1.5rem 0}.scrolled th{vertical-align:bottom}.scrolled td.number{white-space:nowrap}.scrolled td:first-child{min-width:9rem}
.chosen{background:var(--panel)}ul{padding-left:1.2rem}figure{margin:1rem 0}svg{width:100%;height:auto;display:block}
svg text{fill:var(--ink)}li,p{overflow-wrap:anywhere}.narrow{display:none}.small{color:var(--soft);font-size:.9rem}
@media(max-width:600px){.wide{display:none}.narrow{display:block}}
@media print{:root{color-scheme:light;--paper:#fff;--ink:#1a1a1a;--soft:#5f6670;--edge:#777;--grid:#e9ecef;--panel:#f1f7fb;
--exact:#0072b2;--data:#c44601;--warn:#fdf3ee}body{max-width:none}h1~h1{break-before:page}svg,table{break-inside:avoid}}
"""


def themed(svg: str) -> str:
    """A picture whose colours are those of the page's theme."""
    names = "|".join(COLOURS)
    svg = re.sub(rf"(?<=: )({names})\b", lambda found: f"var(--{COLOURS[found[0]]})", svg)
    # What has no colour of its own is black.
    return svg.replace('<g id="figure_1">', '<g id="figure_1" style="fill: var(--ink)">', 1)
