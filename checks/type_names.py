"""One type name, one meaning: no struct, enum, trait, class, interface or alias has the name of another one in its room."""

import ast
import re
from collections import defaultdict
from pathlib import Path

from tree import code_lines, files, finish

ROOMS = [
    *("core/src", "fit/src", "python/src", "wasm/src", "wasm/fit/src", "wasm/motions/src"),
    *("wasm/period/src", "wasm/reader/src"),
    *("wasm/npm/src", "lab/src", "python/libration", "bench", "reference"),
]
RUST = re.compile(r"^(?:\s*(?:pub(?:\([^)]*\))?\s+)?(?:struct|enum|trait|union)|(?:pub(?:\([^)]*\))?\s+)?type)\s+(\w+)")

TYPESCRIPT = re.compile(r"^(?:export )?(?:declare )?(?:abstract )?(?:class|interface|type|enum) (\w+)", re.MULTILINE)


def types(path: Path) -> set[str]:
    """The types that a file defines, but for its unit tests."""
    if path.suffix == ".py":
        nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        classes = {node.name for node in nodes if isinstance(node, ast.ClassDef)}
        return classes | set(re.findall(r"^(\w+): TypeAlias", path.read_text(encoding="utf-8"), re.MULTILINE))
    if path.suffix == ".ts":
        return set(TYPESCRIPT.findall(path.read_text(encoding="utf-8")))
    found = set()
    for _, line in code_lines(path, "//"):
        if line.lstrip().startswith("#[cfg(test)]"):
            break
        found |= set(RUST.findall(line))
    return found


def findings(root: Path) -> list[str]:
    places = defaultdict(list)
    for top in ROOMS:
        for path in files(root, top, ".rs", ".py", ".ts"):
            room = [top, *path.relative_to(root / top).parts[:-1]][:2]
            for name in types(path):
                places["/".join(room), name].append(path.relative_to(root / top).as_posix())
    return [
        f"{room}: {name} is defined in {len(where)} files: {', '.join(where)}"
        for (room, name), where in sorted(places.items())
        if len(where) > 1
    ]


if __name__ == "__main__":
    finish(findings)
