"""What type checkers see: the package is clean, a program that uses it too, and its mistakes are found."""

import subprocess
import sys
from pathlib import Path

import pytest

import libration

TESTS = Path(__file__).parent
PACKAGE = Path(libration.__file__).parent
MYPY = [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "--config-file="]


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    """What one run has read another need not."""
    return tmp_path_factory.mktemp("mypy")


def errors(cache, *files):
    command = [*MYPY, "--cache-dir", str(cache), *map(str, files)]
    run = subprocess.run(command, cwd=PACKAGE.parent, capture_output=True, text=True)
    assert not run.stderr, run.stderr
    return run.stdout.splitlines()


def test_the_package_and_a_program_that_uses_it_are_clean(cache):
    assert errors(cache, PACKAGE, TESTS / "typing_use.py") == []


def test_every_mistake_is_found(cache, tmp_path):
    program = (TESTS / "typing_use.py").read_text(encoding="utf-8")
    spoiled = tmp_path / "spoiled.py"
    spoiled.write_text(program.replace("  # type: ignore", "  # mistake"), encoding="utf-8")
    mistakes = [number for number, line in enumerate(program.splitlines(), 1) if "# type: ignore" in line]
    found = {int(line.split(":")[1]) for line in errors(cache, spoiled) if ": error: " in line}
    assert len(mistakes) >= 10 and found == set(mistakes)


@pytest.mark.parametrize(
    ("expression", "said"),
    [
        ("libration.Pendulm", "module 'libration' has no attribute 'Pendulm'. Did you mean: 'Pendulum'?"),
        ("libration.elliptic.complet_k", "has no attribute 'complet_k'. Did you mean: 'complete_k'?"),
        ("libration.approx.angel", "has no attribute 'angel'. Did you mean: 'angle'?"),
        ("libration.aprox", "has no attribute 'aprox'. Did you mean: 'approx'?"),
        ("libration.Pendulum(1.0).perod", "has no attribute 'perod'. Did you mean: 'period'?"),
    ],
)
def test_a_misspelt_name_is_answered_with_the_nearest(expression, said):
    run = subprocess.run([sys.executable, "-c", f"import libration; {expression}"], capture_output=True, text=True)
    assert run.returncode == 1
    last = run.stderr.splitlines()[-1]
    assert last.startswith("AttributeError: ") and last.endswith(said)


def test_the_package_says_that_it_is_typed():
    assert (PACKAGE / "py.typed").is_file()
