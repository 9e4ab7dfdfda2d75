"""Links from a page to a file of the repository that is no page: on the site they lead to the repository on its forge."""

import tomllib
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

ROOT = Path(__file__).resolve().parents[2]
SOURCE = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["urls"]["Source"]
# What the site shows under another name.
SHOWN = {"NOTATION.md": "notation", "CHANGELOG.md": "changes"}


class SourceLinks(SphinxTransform):
    """What MyST takes for a download or for a document that it does not know."""

    # After the translated text is in its place (20): it has links of its own.
    default_priority = 25

    def apply(self) -> None:
        for kind in (addnodes.download_reference, addnodes.pending_xref):
            for node in list(self.document.findall(kind)):
                path = self.target(node)
                if path is None:
                    continue
                if path.name in SHOWN and path.parent == ROOT:
                    node["refdomain"], node["reftarget"] = "doc", SHOWN[path.name]
                    continue
                anchor = f"#{node['reftargetid']}" if node.get("reftargetid") else ""
                place = f"{'tree' if path.is_dir() else 'blob'}/main/{path.relative_to(ROOT).as_posix()}{anchor}"
                node.replace_self(nodes.reference("", "", *node.children, refuri=f"{SOURCE}/{place}"))

    def target(self, node: nodes.Element) -> Path | None:
        """The file or folder of the repository that a link means, unless it is a page of the site."""
        if node.get("reftype") != "myst":
            return None
        name = str(node["reftarget"])
        known = node.get("refdomain") == "doc"
        if known and name in self.env.found_docs:
            return None
        # A file outside of the pages has its whole path for its name, without the ending.
        path = Path(f"{name}.md") if known else (Path(self.env.doc2path(self.env.docname)).parent / name).resolve()
        return path if path.exists() and path.is_relative_to(ROOT) else None


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_transform(SourceLinks)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
