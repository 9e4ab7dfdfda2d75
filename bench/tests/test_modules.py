"""No file of bench/ hides a package that a rival is imported from, and the rooms import in one direction only."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).parents[1]
BELOW = {  # what a room may import from bench/
    "cases": {"cases"},
    "rivals": {"rivals"},
    "measurement": {"measurement", "rivals", "cases"},
    "report": {"report", "measurement", "rivals", "cases"},
}


def imported(path: Path) -> set[str]:
    """The first word of every absolute import of a file, also of those inside functions."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level:
            found.add(node.module.partition(".")[0])
    return found


def packages(folder: Path) -> set[str]:
    """Every package that the rivals are imported from."""
    return set().union(*(imported(path) for path in (folder / "rivals").glob("*.py")))


def hidden(folder: Path) -> list[str]:
    """The files and folders of `folder` that have the name of such a package."""
    names = packages(folder)
    return sorted(path.name for path in folder.rglob("*") if path.suffix in (".py", "") and path.stem in names)


def test_no_file_has_the_name_of_a_package_of_a_rival(tmp_path):
    assert {"elliptic", "heyoka", "libration", "mpmath", "numpy", "scipy"} <= packages(BENCH)
    assert hidden(BENCH) == []
    (tmp_path / "rivals").mkdir()
    (tmp_path / "rivals/formulas.py").write_text("def f():\n    import elliptic\n")
    (tmp_path / "elliptic.py").touch()
    assert hidden(tmp_path) == ["elliptic.py"]


def test_what_a_script_of_bench_imports_is_the_package_of_the_rival():
    script = """import importlib, sys
for name in sys.argv[1:]:
    try:
        print(importlib.import_module(name).__file__)
    except ModuleNotFoundError as missing:
        assert missing.name == name, missing
"""
    names = sorted(packages(BENCH))
    run = subprocess.run([sys.executable, "-c", script, *names], cwd=BENCH, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    found = [Path(line) for line in run.stdout.splitlines() if line != "None"]
    assert found and not any(path.is_relative_to(BENCH) for path in found), found


@pytest.mark.parametrize("room", BELOW)
def test_a_room_imports_only_what_is_below_it(room):
    ours = {path.stem for path in BENCH.iterdir() if path.suffix in (".py", "")}
    for path in (BENCH / room).glob("*.py"):
        assert imported(path) & ours <= BELOW[room], path
