"""Pages say what the last run said; nothing is left half done; no test looks away; no file is two files."""

import re
import runpy
from pathlib import Path

from tree import files, finish

SOURCES = (".rs", ".py", ".pyi", ".ts", ".css", ".md", ".toml", ".sh", ".yml", ".cff")
BLOCK = re.compile(r"<!-- generated: (\S+) -->\n(.*?)<!-- end generated -->", re.DOTALL)
LONGEST = 400
# A row, a section, a line for every function, however many there are.
TABLES = {"functions.toml", "python/libration/_core.pyi"}
WORDS = [
    (r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X)\b", "unfinished work does not stand in main"),
    (
        r"pytest\.(mark\.)?(sk" + r"ip|xf" + r"ail|import" + r"orskip)|#\[ig" + r"nore",
        "a test never looks away",
    ),
    (r"(?<![\w.])/(wo" + r"rk|ro" + r"ot|ho" + r"me)/\w", "a path of one machine"),
]


def findings(root: Path) -> list[str]:
    found = []
    for path in [*files(root, ".", *SOURCES), root / "Makefile"]:
        if not path.is_file():
            continue
        name = path.relative_to(root).as_posix()
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        if len(lines) > LONGEST and name not in TABLES:
            found.append(f"{name}: {len(lines)} lines; past {LONGEST} a file is probably two")
        for number, line in enumerate(lines, 1):
            found += [f"{name}:{number}: {why}: {line.strip()}" for what, why in WORDS if re.search(what, line)]
    if not (root / "docs/generate.py").is_file():
        return [*found, "docs/generate.py: missing, so no page can be compared"]
    written = runpy.run_path(str(root / "docs/generate.py"))["blocks"](root)
    held = {path: dict(BLOCK.findall(path.read_text(encoding="utf-8"))) for path in files(root, ".", ".md")}
    for path, blocks in held.items():
        for block, text in blocks.items():
            if written.get(block) != text:
                found.append(f"{path.relative_to(root)}: block `{block}` is not what a run writes: make docs")
    for block in written:
        if not any(block in blocks for blocks in held.values()):
            found.append(f"block `{block}` stands on no page")
    return found


if __name__ == "__main__":
    finish(findings)
