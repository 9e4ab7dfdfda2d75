"""Which files of a folder of Python a file imports: at the top, inside functions, for type checkers, and by name.

A name that a package imports to hand it on leads to the file that defines it.
"""

import ast
from pathlib import Path

from tree import files


class Folder:
    """The modules under a folder, and the import statements of each."""

    def __init__(self, folder: Path):
        self.file, self.trees = {}, {}
        for path in files(folder, ".", ".py", ".pyi"):
            parts = path.relative_to(folder).with_suffix("").parts
            module = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            self.file[module], self.trees[module] = path, ast.parse(path.read_text(encoding="utf-8"))

    def absolute(self, module: str, level: int, name: str) -> str:
        """The full name of what `from ..name` means in a module."""
        if not level:
            return name
        package = module.split(".") + (["__init__"] if self.file[module].stem == "__init__" else [])
        return ".".join([*package[: len(package) - level], *filter(None, [name])])

    def defines(self, module: str, name: str, seen: tuple = ()) -> set[str]:
        """The module that a name of a module comes from; none outside of the folder."""
        if f"{module}.{name}".lstrip(".") in self.file:
            return {f"{module}.{name}".lstrip(".")}
        if module not in self.file:
            return set()
        if self.file[module].stem == "__init__" and (module, name) not in seen:
            for node in ast.walk(self.trees[module]):
                for alias in node.names if isinstance(node, ast.ImportFrom) else []:
                    if (alias.asname or alias.name) == name:
                        origin = self.absolute(module, node.level, node.module or "")
                        return self.defines(origin, alias.name, (*seen, (module, name)))
        return {module}

    def of(self, module: str) -> set[str]:
        found = set()
        for node in ast.walk(self.trees[module]):
            if isinstance(node, ast.Import):
                found |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                origin = self.absolute(module, node.level, node.module or "")
                found |= {each for alias in node.names for each in self.defines(origin, alias.name)}
            elif isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] == "import_module":
                first = node.args[0]
                if isinstance(first, ast.Constant):
                    name = first.value.lstrip(".")
                    found.add(self.absolute(module, len(first.value) - len(name), name))
        return found & set(self.file) - {module}

    def imports(self) -> dict[Path, set[Path]]:
        return {path: {self.file[each] for each in self.of(module)} for module, path in self.file.items()}
