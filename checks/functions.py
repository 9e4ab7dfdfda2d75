"""functions.toml against the code: every row has its function, its truth and its test, every public name its row.

What is missing is named with the step of CONTRIBUTING.md that adds it.
"""

import re
import tomllib
from pathlib import Path

from names import exported
from tree import finish

FIELDS = ["summary", "arguments", "domain", "outside", "error", "source", "python", "test"]
STEPS = {
    "row": "step 1, a row in functions.toml",
    "vectors": "step 2, a generator in reference/",
    "rust": "step 3, the function",
    "python": "step 3, the function",
    "test": "step 3, the test that holds it",
}


def stands(root: Path, place: str) -> bool:
    """Whether `file` or `file::name` exists, name being the last word of a path such as Orbit::theta."""
    file, _, name = place.partition("::")
    if not (root / file).is_file():
        return False
    word = re.split(r"::|\.", name)[-1]
    definition = rf"\b(fn|def|class|struct|enum|static|const)\s+{word}\b"
    defined = rf"{definition}|^\s*{word}\s*[:=]|^\s*{word},?$"
    return not name or re.search(defined, (root / file).read_text(encoding="utf-8"), re.MULTILINE) is not None


def findings(root: Path) -> list[str]:
    found = []
    rows = tomllib.loads((root / "functions.toml").read_text(encoding="utf-8"))
    for name, row in rows.items():
        found += [f"functions.toml: {name} has no `{field}`" for field in FIELDS if not row.get(field)]
        numeric = "vectors" in row
        if numeric and not row.get("error_max_ulp"):
            found.append(f"functions.toml: {name} has vectors but promises no error_max_ulp")
        for field in ("vectors", "rust", "python", "test"):
            places = row.get(field, [])
            for place in [places] if isinstance(places, str) else places:
                if not stands(root, place):
                    found.append(f"{name}: {field} {place} is missing: {STEPS[field]}")
    package = root / "python/libration/__init__.py"
    for name in exported(package) if package.is_file() else []:
        if name not in rows and name[:2] != "__":
            found.append(f"{name}: in libration.__all__ without a row: {STEPS['row']}")
    return found


if __name__ == "__main__":
    finish(findings)
