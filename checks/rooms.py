"""The import law: which room may know which other one. The law itself stands in rooms.toml beside this file.

Read from the text, line by line and without comments, so a formula cannot enter a room unseen.
"""

import re
import tomllib
from pathlib import Path

from tree import code_lines, files, finish

TABLE = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))


def findings(root: Path) -> list[str]:
    found = []
    for law in TABLE["laws"]:
        forbidden = TABLE.get(law["forbidden"].strip("{}"), law["forbidden"])
        for path in files(root, law["room"], law["suffix"]):
            name = path.relative_to(root).as_posix()
            if law.get("except", "\n") in name:
                continue
            for number, line in code_lines(path, "#" if law["suffix"] == ".py" else "//"):
                if line.lstrip().startswith("#[cfg(test)]"):
                    break  # a unit test at the end of a file may panic
                line = re.sub(r'"([^"\\]|\\.)*"', '""', line)
                if re.search(forbidden, line):
                    found.append(f"{name}:{number}: {law['law']}: {line.strip()}")
    return found


if __name__ == "__main__":
    finish(findings)
