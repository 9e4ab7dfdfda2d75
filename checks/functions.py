"""functions.toml against the package: a row for every public member, a member for every row, and no count typed by hand.

What is missing is named with the step of CONTRIBUTING.md that adds it.
"""

import re
import runpy
import tomllib
from pathlib import Path

from tree import files, finish

FIELDS = {"members", "error_max_ulp", "error_median_ulp", "error_max_ulp_own_state", "vectors", "rust", "test"}
FUNCTION, TEST = "step 3, the function", "step 3, the test that holds it"
STEPS = {"vectors": "step 2, a generator in reference/", "rust": FUNCTION, "test": TEST}
# How many there are follows from the registries, which grow.
WORDS = r"\d+|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|\w+teen|twenty"
COUNT = rf"\b({WORDS}) (\w+ )?(formulas|approximations|schemes|claims|errata)\b"
ROOMS = [("docs", ".md"), ("python/libration", ".py"), ("core/src/approx", ".rs")]


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
    rows = tomllib.loads((root / "functions.toml").read_text(encoding="utf-8"))
    found, known = [], runpy.run_path(str(root / "docs/surface.py"))["surface"](root)
    for name, row in rows.items():
        found += [f"functions.toml: {name}: `{field}` stands in the docstring" for field in row if field not in FIELDS]
        found += [f"functions.toml: {name} has no `test`"] if not row.get("test") else []
        if "vectors" in row and not row.get("error_max_ulp"):
            found.append(f"functions.toml: {name} has vectors but promises no error_max_ulp")
        for field in ("vectors", "rust", "test"):
            places = row.get(field, [])
            missing = [each for each in ([places] if isinstance(places, str) else places) if not stands(root, each)]
            found += [f"{name}: {field} {place} is missing: {STEPS[field]}" for place in missing]
        command = (root / f"python/libration/cli/{name[10:].replace('-', '_')}.py").is_file()
        named = row.get("members", []) if command or name[-2:] == "pq" else [name, *row.get("members", [])]
        found += [f"functions.toml: {each}: no public member has this name" for each in named if each not in known]
    covered = set(rows).union(*(row.get("members", []) for row in rows.values()))
    found += [
        f"{name}: public, without a row: step 1, a row in functions.toml" for name in known if name not in covered
    ]
    for path in [root / "README.md", *(path for room, suffix in ROOMS for path in files(root, room, suffix))]:
        counts = re.finditer(COUNT, path.read_text(encoding="utf-8"), re.IGNORECASE)
        found += [f"{path.relative_to(root)}: `{count[0]}` is a count typed by hand" for count in counts]
    return found


if __name__ == "__main__":
    finish(findings)
