"""Every command shown on a page prints what the page shows.

A ```console block holds lines `$ libration ...` (the only program it may run), each followed by its output.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from tree import files, finish

BLOCK = re.compile(r"^```console\n(.*?)^```", re.MULTILINE | re.DOTALL)
PROGRAM = Path(sys.executable).parent / "libration"


def findings(root: Path, program: str = str(PROGRAM)) -> list[str]:
    found = []
    environment = {**os.environ, "COLUMNS": "100", "LC_ALL": "C.UTF-8"}
    for page in files(root, ".", ".md"):
        for block in BLOCK.findall(page.read_text(encoding="utf-8")):
            for example in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
                command, _, shown = example.partition("\n")
                words = shlex.split(command)
                if words[0] != "libration":
                    found.append(f"{page.relative_to(root)}: `{command}` does not run libration")
                    continue
                with tempfile.TemporaryDirectory() as folder:
                    run = subprocess.run(
                        [program, *words[1:]], cwd=folder, env=environment, capture_output=True, text=True
                    )
                if (run.stdout + run.stderr).strip() != shown.strip():
                    found.append(f"{page.relative_to(root)}: `{command}` prints {(run.stdout + run.stderr)!r}")
    return found


if __name__ == "__main__":
    finish(findings)
