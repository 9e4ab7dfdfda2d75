"""Which files of a folder of TypeScript a file imports: values and types, at once and when they are asked for."""

import os.path
import re
from pathlib import Path

from tree import files

# `from '...'`, `import '...'` and `import('...')` of a file beside; what follows a `?` says how it is built.
IMPORT = re.compile(r"""\b(?:from|import)\s*\(?\s*['"](\.[^'"?]*)""")


class Scripts:
    """The files under a folder, and the files that each names."""

    def __init__(self, folder: Path):
        self.paths = set(files(folder, ".", ".ts"))

    def file(self, path: Path) -> Path | None:
        """The file that is meant: `./a`, `./a.js` and `./a.ts` are a.ts, a folder is its index."""
        named = (
            path,
            path.with_name(f"{path.name}.ts"),
            path.parent / f"{path.name.removesuffix('.js')}.ts",
            path / "index.ts",
        )
        return next((each for each in named if each in self.paths), None)

    def imports(self) -> dict[Path, set[Path]]:
        found = {}
        for path in self.paths:
            named = IMPORT.findall(path.read_text(encoding="utf-8"))
            targets = {self.file(Path(os.path.normpath(path.parent / each))) for each in named}
            found[path] = targets - {None, path}
        return found
