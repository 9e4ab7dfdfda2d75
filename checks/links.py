"""Every link of every page into the repository, relative or by its address, leads to a file, and every anchor to a heading."""

import re
import tomllib
from pathlib import Path

from tree import files, finish

INLINE = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")
DEFINED = re.compile(r"^\[[^\]]+\]: (\S+)$", re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """The anchors a reader's browser makes of a page's headings."""
    headings = re.findall(r"^#+\s+(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def findings(root: Path) -> list[str]:
    found = []
    cargo = root / "Cargo.toml"
    package = tomllib.loads(cargo.read_text(encoding="utf-8"))["workspace"]["package"] if cargo.is_file() else {}
    hosted = re.compile(re.escape(package.get("repository", "://")) + r"/(?:blob|tree|raw)/main/")
    for page in files(root, ".", ".md"):
        text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        text = re.sub(r"`[^`]*`", "", text)
        for link in INLINE.findall(text) + DEFINED.findall(text):
            here = hosted.match(link) is not None
            if re.match(r"[a-z]+:", link) and not here:
                continue
            file, _, anchor = hosted.sub("", link).partition("#")
            target = (root if here else page.parent) / file if file else page
            if not target.exists():
                found.append(f"{page.relative_to(root)}: {link} leads nowhere")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                found.append(f"{page.relative_to(root)}: {link} has no such heading")
    return found


if __name__ == "__main__":
    finish(findings)
