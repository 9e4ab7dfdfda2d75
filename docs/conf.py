"""The documentation as a site: `make site`. The pages are those that a forge shows; what they cannot have there is added here."""

import sys
import tomllib
from pathlib import Path

from docutils import nodes

DOCS = Path(__file__).resolve().parent
ROOT = DOCS.parent
PARTS = ROOT / "out/site-parts"
sys.path[:0] = [str(DOCS / "extensions")]

WORKSPACE = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]

project = "libration"
author = copyright = "the libration authors"
version = release = WORKSPACE["version"]
extensions = [
    "myst_parser",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx_copybutton",
    "sphinx_design",
    "commands",
    "lab",
    "mathml",
    "reference",
    "source_links",
]
root_doc = "index"
exclude_patterns = ["extensions", "locales", "templates", "typescript"]
templates_path = ["templates"]

# ------------------------------------------------------------------------------------------------- pages
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 4
# Only what is shown is copied, without the prompts.
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True
copybutton_only_copy_prompt_lines = True
highlight_language = "none"
nitpicky = True

# ------------------------------------------------------------------------------------------------- docstrings
numpydoc_show_class_members = False
numpydoc_xref_param_type = False
autodoc_typehints = "none"
autodoc_member_order = "bysource"

# ------------------------------------------------------------------------------------------------- languages
language = "en"
locale_dirs = ["locales"]
gettext_compact = False
gettext_uuid = False
gettext_location = False
figure_language_filename = "{path}{root}{ext}"

# ------------------------------------------------------------------------------------------------- look
html_theme = "pydata_sphinx_theme"
html_title = "libration"
html_static_path = ["static", "../lab/src/style/fonts/stix-two-math.woff2"]
# The lab, and the documentation of Rust and TypeScript, by `make site`.
html_extra_path = [str(PARTS)] if PARTS.is_dir() else []
html_css_files = ["site.css"]
# A page without pages below it has no list of them.
html_sidebars = {"tutorial": [], "guide": []}
html_show_sourcelink = False
html_math_renderer = "mathml"
html_theme_options = {
    "show_toc_level": 2,
    "navbar_align": "left",
    "navbar_end": ["languages", "theme-switcher"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "show_prev_next": True,
    "secondary_sidebar_items": ["page-toc"],
}
html_context = {"default_mode": "auto"}


def without_blank_ends(app, doctree):
    """A block of an example ends with a blank line for doctest alone."""
    for block in doctree.findall(nodes.literal_block):
        text = block.astext().rstrip()
        block.rawsource = text
        block.children = [nodes.Text(text)]


def parts_once(app, config):
    """The lab and the rest stand beside the pages in English, for all languages."""
    if config.language != "en":
        config.html_extra_path = []


def setup(app):
    app.connect("config-inited", parts_once)
    app.connect("doctree-read", without_blank_ends)
