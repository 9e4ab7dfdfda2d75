"""Builds what the conda recipe builds, by its own script, from the source distribution that it names; then its own tests.

    python packages/try_recipe.py

rattler-build reads and renders the recipe. conda's channels are not asked: the interpreter, maturin and the compilers are those of this
environment.
"""

import subprocess
import sys
import tarfile
from pathlib import Path

from rattler_build import Stage0Recipe, VariantConfig

ROOT = Path(__file__).resolve().parents[1]
RECIPE = ROOT / "packages/conda/recipe.yaml"
PLACE = ROOT / "target/packages/conda"
VARIANTS = {"c_compiler": ["gcc"], "rust_compiler": ["rust"], "c_stdlib": ["sysroot"], "python": ["3.13"]}


def listed(value) -> list:
    """What the renderer gives as one text where there is one."""
    return [value] if isinstance(value, str) else list(value)


def main() -> int:
    [variant] = Stage0Recipe.from_file(str(RECIPE)).render(VariantConfig(VARIANTS))
    found = variant.recipe if not callable(variant.recipe) else variant.recipe()
    recipe = found.to_dict()
    PLACE.mkdir(parents=True, exist_ok=True)
    with tarfile.open(RECIPE.parent / recipe["source"][0]["path"]) as archive:
        archive.extractall(PLACE, filter="data")
    [folder] = PLACE.glob("libration-*")
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", PLACE / "environment"], check=True)
    python = PLACE / "environment/bin/python"
    for line in listed(recipe["build"]["script"]):
        words = line.replace("${{ PYTHON }}", str(python))
        subprocess.run(words, shell=True, cwd=folder, check=True, capture_output=True)
    for test in recipe["tests"]:
        for name in test.get("python", {}).get("imports", []):
            subprocess.run([python, "-c", f"import {name}"], cwd=PLACE, check=True)
        for line in listed(test.get("script", [])):
            subprocess.run(f"{python.parent}/{line}", shell=True, cwd=PLACE, check=True, stdout=subprocess.DEVNULL)
    for name in recipe["about"]["license_file"]:
        assert (folder / name).is_file(), name
    print(f"the recipe builds libration {recipe['package']['version']}, and its tests hold")
    return 0


if __name__ == "__main__":
    sys.exit(main())
