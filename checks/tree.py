"""What every check needs: the project's own files under a root, and the way a check ends.

A check is a function from the root to a list of one-line findings; no finding means it holds.
"""

import sys
from pathlib import Path

NOT_OURS = {".git", ".venv", "target", "out", "dist", "dist-tests", "build", "node_modules", "__pycache__"}


def files(root: Path, folder: str, *suffixes: str) -> list[Path]:
    """The files under root/folder with one of the suffixes, sorted, without what a build leaves behind."""
    found = (root / folder).rglob("*")
    return sorted(
        path
        for path in found
        if path.suffix in suffixes
        and path.is_file()
        and not any(part in NOT_OURS or part.endswith("_cache") for part in path.relative_to(root).parts)
    )


def code_lines(path: Path, comment: str):
    """Numbered lines of a source file without comments; blank where nothing else is left."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        yield number, line.split(comment)[0]


def finish(findings) -> None:
    """Run a check on the checkout (or on the folder named on the command line); exit 1 with what it found."""
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]
    found = findings(root)
    print("\n".join(found) if found else f"{Path(sys.argv[0]).stem}: holds")
    sys.exit(bool(found))
