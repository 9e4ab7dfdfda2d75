"""One version and one address: what every package says of both is what Cargo.toml says."""

import json
import re
import tomllib
from pathlib import Path

from tree import files, finish

# What a page of a package shows or leads to must be found from there: README.md is the page of three of them.
RELATIVE = re.compile(r"(?:\]\(|^\[[^\]]+\]: )(?![a-z]+:|#)([^)\s]+)", re.MULTILINE)
# Where the version stands in a file, and the address.
TEXTS = (
    ("CITATION.cff", r"^version: (\S+)$", r"^repository-code: (\S+)$"),
    ("packages/conda/recipe.yaml", r"^  version: (\S+)$", r"^  homepage: (\S+)$"),
    ("pyproject.toml", None, r'^Source = "(\S+)"$'),
    ("python/libration/references.bib", None, r"^  url = \{(\S+)\},$"),
    ("CHANGELOG.md", r"^## (\d\S*)", None),
)


def said(root: Path) -> dict[str, tuple[str | None, str | None]]:
    """The version and the address of every place that has them; None for what a place does not say."""
    found: dict[str, tuple[str | None, str | None]] = {}
    cargo = tomllib.loads((root / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]
    for name, each in cargo.get("dependencies", {}).items():
        if isinstance(each, dict) and "path" in each:
            found[f"Cargo.toml: {name}"] = each.get("version", "").removeprefix("="), None
    for path in files(root, ".", ".json"):
        if path.name in ("package.json", "package-lock.json"):
            package = json.loads(path.read_text(encoding="utf-8"))
            found[path.relative_to(root).as_posix()] = package["version"], package.get("repository", {}).get("url")
    for name, *patterns in TEXTS:
        if (root / name).is_file():
            text = (root / name).read_text(encoding="utf-8")
            found[name] = tuple(p and (re.findall(p, text, re.MULTILINE) or [""])[0] for p in patterns)
    return found


def findings(root: Path) -> list[str]:
    package = tomllib.loads((root / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]
    version, address, found = package["version"], package["repository"], []
    for place, (number, url) in said(root).items():
        link = None if url is None else url.removeprefix("git+").removesuffix(".git")
        for what, got, wanted in (("version", number, version), ("address", link, address)):
            if got is not None and got != wanted:
                found.append(f"{place}: {what} {got or 'missing'}, and Cargo.toml says {wanted}")
    for page in ("README.md", "fit/README.md", "wasm/npm/README.md"):
        if (root / page).is_file():
            text = re.sub(r"```.*?```", "", (root / page).read_text(encoding="utf-8"), flags=re.DOTALL)
            found += [
                f"{page}: {link} leads nowhere from the page of a package: write {address}/…"
                for link in RELATIVE.findall(text)
            ]
    return found


if __name__ == "__main__":
    finish(findings)
