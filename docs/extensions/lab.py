"""The directive `lab`: the lab in a frame, with the state of its link. The site has the built page beside it, in lab/."""

from html import escape
from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import Directive, directives
from sphinx.application import Sphinx

# By the language of the site: what a link of the lab says of it, and the words of the link below the frame.
LANGUAGES = {
    "en": ("", "Open it in a page of its own"),
    "pt_BR": ("&lang=pt-BR", "Abrir em uma página própria"),
    "es": ("&lang=es", "Abrir en una página propia"),
}


class Lab(Directive):
    """A frame of the lab; its argument is the part of a link after the `#`."""

    required_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar = {"height": directives.positive_int}

    def run(self) -> list[nodes.Node]:
        env = self.state.document.settings.env
        language = env.config.language
        said, words = LANGUAGES[language]
        # Each language but English has a folder of the site.
        root = "../" * (env.docname.count("/") + (language != "en"))
        link = escape(f"{root}lab/index.html#{self.arguments[0].strip()}{said}")
        height = self.options.get("height", 640)
        frame = (
            f'<iframe src="{link}&amp;embed=1" width="100%" height="{height}" loading="lazy" title="the lab"></iframe>'
        )
        whole = f'<p class="lab-link"><a href="{link}">{words}</a></p>'
        return [nodes.raw("", f'<div class="lab">{frame}{whole}</div>', format="html")]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("lab", Lab)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
