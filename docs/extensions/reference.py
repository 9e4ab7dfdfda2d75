"""The directive `room`: every public member of a room of the package, from its docstrings and functions.toml.

The order and the names are those of docs/surface.py; a member is told once, by the shortest name it is imported by. Below each
docstring stand what functions.toml alone knows: where it is computed, and what holds it to its promise.
"""

import runpy
import tomllib
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.util.nodes import nested_parse_with_titles

ROOT = Path(__file__).resolve().parents[2]
ROWS = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))
HOMES = {member: row for name, row in ROWS.items() for member in [name, *row.get("members", [])]}
SURFACE = runpy.run_path(str(ROOT / "docs/surface.py"))["surface"](ROOT)
PLACES = {"rust": "Computed in", "vectors": "Truth", "test": "Tests"}


class Room(Directive):
    """One room, by the name of its module; its members in alphabetical order of their owners."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        room, lines = self.arguments[0], []
        for name, member in SURFACE.items():
            if member["room"] == room and "." not in name.removeprefix(f"{room}."):
                kind = {"class": "autoclass", "registry": "autodata"}.get(member["kind"], "autofunction")
                own = ", ".join(each.partition(".")[2] for each in SURFACE if each.startswith(f"{name}."))
                lines += [f".. {kind}:: {member['path']}", *([f"   :members: {own}"] if own else []), ""]
        content = nodes.section()
        content.document = self.state.document
        nested_parse_with_titles(self.state, StringList(lines, source=f"room {room}"), content)
        return content.children


def places(app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """What functions.toml knows of a member, as a last paragraph."""
    row = HOMES.get(name.removeprefix("libration."))
    if row is None:
        return
    told = []
    for field, words in PLACES.items():
        found = row.get(field, [])
        paths = [place.partition("::")[0] for place in ([found] if isinstance(found, str) else found)]
        if paths:
            told.append(f"{words} {', '.join(f':file:`{path}`' for path in dict.fromkeys(paths))}.")
    lines += ["", " ".join(told), ""]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("room", Room)
    # After numpydoc, which rewrites the sections of a docstring.
    app.connect("autodoc-process-docstring", places, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
