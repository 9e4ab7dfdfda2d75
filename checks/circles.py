"""No circle of files: a file never uses, by whatever way, a file that uses it."""

from pathlib import Path

from python_imports import Folder
from rust_imports import Crate
from tree import finish
from typescript_imports import Scripts

ROOMS = {
    "core/src": Crate,
    "fit/src": Crate,
    "python/src": Crate,
    "wasm/src": Crate,
    "wasm/fit/src": Crate,
    "wasm/motions/src": Crate,
    "wasm/period/src": Crate,
    "wasm/reader/src": Crate,
    "python": Folder,
    "bench": Folder,
    "reference": Folder,
    "lab": Scripts,
    "wasm/npm/src": Scripts,
}


def reached(imports: dict[Path, set[Path]], start: Path) -> set[Path]:
    """Every file that a file uses, by itself or through others."""
    found, new = set(), [start]
    while new:
        fresh = imports[new.pop()] - found
        found |= fresh
        new += fresh
    return found


def findings(root: Path) -> list[str]:
    found = []
    for room, kind in ROOMS.items():
        imports = kind(root / room).imports()
        reach = {path: reached(imports, path) for path in imports}
        circles = {frozenset(other for other in reach[path] if path in reach[other]) for path in imports}
        for circle in sorted(map(sorted, filter(None, circles))):
            found.append(f"{room}: {len(circle)} files in a circle:")
            for path in circle:
                uses = ", ".join(str(other.relative_to(root / room)) for other in sorted(imports[path] & set(circle)))
                found.append(f"    {path.relative_to(root / room)} uses {uses}")
    return found


if __name__ == "__main__":
    finish(findings)
