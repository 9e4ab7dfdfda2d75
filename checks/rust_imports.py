"""Which files of a Rust crate a file uses.

A `pub use` is no import: a path through it leads to the file that defines the name, as far as can be told.
"""

import re
from pathlib import Path

from rust_paths import exported, source, used
from tree import files


class Crate:
    """The modules of a crate, as tuples of names, with their files and texts, and what they export from others."""

    def __init__(self, folder: Path):
        self.file, self.text = {}, {}
        for path in files(folder, ".", ".rs"):
            module = path.relative_to(folder).with_suffix("").parts
            module = module[:-1] if module[-1] in ("mod", "lib") else module
            self.file[module], self.text[module] = path, source(path)
        self.exports = {module: exported(text) for module, text in self.text.items()}

    def end(self, module: tuple, path: tuple, passed: tuple = ()) -> tuple:
        """The module in which a path written in `module` ends."""
        if path[0] == "crate":
            module, path = (), path[1:]
        while path and path[0] in ("super", "self"):
            module, path = module[: len(module) - (path[0] == "super")], path[1:]
        while path and (*module, path[0]) in self.file:
            module, path = (*module, path[0]), path[1:]
        for export in self.exports.get(module, []) if path and (module, path) not in passed else []:
            here = (*passed, (module, path))
            if export[-1] == path[0]:
                return self.end(module, (*export, *path[1:]), here)
            if export[-1] == "*":
                target = self.end(module, export[:-1], here)
                if re.search(
                    rf"\b(fn|struct|enum|trait|type|const|static)\s+{re.escape(path[0])}\b", self.text[target]
                ):
                    return target
        return module

    def imports(self) -> dict[Path, set[Path]]:
        found = {}
        for module, text in self.text.items():
            ends = {self.end(module, path) for path in used(text)}
            found[self.file[module]] = {self.file[end] for end in ends if end in self.file and end != module}
        return found
