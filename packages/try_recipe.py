"""Builds what the conda recipe builds, by its own script, from the source distribution that it names; then its own tests.

    python packages/try_recipe.py

conda's channels are not asked: the interpreter, maturin and the compilers are those of this environment.
"""

import re
import subprocess
import sys
import tarfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RECIPE = ROOT / "packages/conda/recipe.yaml"
PLACE = ROOT / "target/packages/conda"


def field(text: str, pattern: str) -> list[str]:
    """What a pattern finds in the recipe, at least once."""
    found = re.findall(pattern, text, re.MULTILINE)
    assert found, pattern
    return found


def main() -> int:
    text = RECIPE.read_text(encoding="utf-8")
    [version] = field(text, r"^  version: (\S+)$")
    text = text.replace("${{ version }}", version)
    [source] = field(text, r"^  path: (\S+)$")
    PLACE.mkdir(parents=True, exist_ok=True)
    with tarfile.open(RECIPE.parent / source) as archive:
        archive.extractall(PLACE, filter="data")
    [folder] = PLACE.glob("libration-*")
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", PLACE / "environment"], check=True)
    python = PLACE / "environment/bin/python"
    for line in field(text, r"^    - (\$\{\{ PYTHON \}\} .*)$"):
        subprocess.run(
            line.replace("${{ PYTHON }}", str(python)), shell=True, cwd=folder, check=True, capture_output=True
        )
    for name in field(text, r"^        - (libration[\w.]*)$"):
        subprocess.run([python, "-c", f"import {name}"], cwd=PLACE, check=True)
    for line in field(text, r"^      - (libration .*)$")[-1:]:
        subprocess.run(f"{python.parent}/{line}", shell=True, cwd=PLACE, check=True, stdout=subprocess.DEVNULL)
    for license in field(text, r"^    - (LICENSE-\S+)$"):
        assert (folder / license).is_file(), license
    print(f"the recipe builds libration {version}, and its tests hold")
    return 0


if __name__ == "__main__":
    sys.exit(main())
