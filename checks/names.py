"""One name for one idea: NOTATION.md is the dictionary, and what it forbids is not written anywhere."""

import ast
import re
import tomllib
from pathlib import Path

from tree import code_lines, files, finish

ROOMS = ["core", "fit", "python", "wasm", "reference", "bench", "docs"]
FORBIDDEN = [
    (r"\b(k2|ksq|m1)\b", "the parameter is `m`, its complement `mc`, the modulus `k`"),
    (r"\b(angle0|phase0|freq|w0|omega_0|oscillation|circulation|(fn|def) amplitude)\b", "not a name of NOTATION.md"),
    (
        # But for the method that a trait of the optimiser asks for.
        r"\b(fn|def)\s+(get|set|compute|calc|calculate)_(?!params\(&mut self, params)",
        "a quantity is a noun: no get_, set_, compute_, calc_",
    ),
    (
        r"\b(theta|angle)\w*\s*=\s*x\s*;?$|\blet\s+x\s*=\s*theta|^\s*x\s*=\s*theta\w*\s*$",
        "an angle is not called x",
    ),
    (
        r"\b(fn|def)\s+(theta|velocity|motion|incomplete_\w)\w*\([^)]*\bx\b",
        "an argument is `u`, an angle is not x",
    ),
]
FILES = {"util", "utils", "misc", "common", "helper", "helpers", "tool", "tools"}


def exported(package: Path) -> list[str]:
    """The names in `__all__` of a Python file."""
    for node in ast.parse(package.read_text(encoding="utf-8")).body:
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        if any(isinstance(target, ast.Name) and target.id == "__all__" for target in targets):
            return list(ast.literal_eval(node.value))
    return []


def findings(root: Path) -> list[str]:
    found = []
    for path in [path for room in ROOMS for path in files(root, room, ".rs", ".py", ".pyi")]:
        name = path.relative_to(root).as_posix()
        if path.stem in FILES:
            found.append(f"{name}: a file is named after what it computes")
        for number, line in code_lines(path, "//" if path.suffix == ".rs" else "#"):
            line = re.sub(r'"[^"]*"', '""', line).rstrip()
            found += [f"{name}:{number}: {why}: {line.strip()}" for what, why in FORBIDDEN if re.search(what, line)]
    dictionary = set(re.findall(r"`(\w+)`", (root / "NOTATION.md").read_text(encoding="utf-8")))
    listed = set(tomllib.loads((root / "functions.toml").read_text(encoding="utf-8")))
    package = root / "python/libration/__init__.py"
    if not package.is_file():
        return [*found, "python/libration/__init__.py: missing, so no public name can be read"]
    unknown = [name for name in exported(package) if name not in dictionary | listed and name[:2] != "__"]
    return found + [f"{name}: public, but neither in NOTATION.md nor in functions.toml" for name in unknown]


if __name__ == "__main__":
    finish(findings)
