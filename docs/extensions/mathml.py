"""Formulas as MathML, which browsers draw themselves: no script, no font from elsewhere."""

import re

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator


def formula(tex: str, display: str) -> str:
    """One formula; a dot for a derivative is an accent, which stands close to its letter."""
    dot = r"<mover>(<mi>[^<]*</mi>)<mo>(&#x002D9;|&#x000A8;)</mo>"
    return re.sub(dot, r'<mover accent="true">\1<mo>\2</mo>', convert(tex, display=display))


def inline(writer: HTML5Translator, node: nodes.math) -> None:
    writer.body.append(formula(node.astext(), "inline"))
    raise nodes.SkipNode


def block(writer: HTML5Translator, node: nodes.math_block) -> None:
    writer.body.append(f'<div class="formula">{formula(node.astext(), "block")}</div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_html_math_renderer("mathml", (inline, None), (block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
