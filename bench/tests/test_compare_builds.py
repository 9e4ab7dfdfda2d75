"""The comparison of two builds: equal builds are equal, a build that moves one last digit is not."""

import subprocess
import sys
from pathlib import Path

import numpy as np
from compare_builds import difference, medians

SCRIPT = Path(__file__).parents[1] / "compare_builds.py"
QUICK = ["--only", "carlson_rc", "--rounds", "1", "--pairs", "1", "--limit", "1e9"]


def compared(old: str, new: str) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, SCRIPT, old, new, *QUICK], capture_output=True, text=True)


def test_a_build_is_equal_to_itself():
    run = compared(sys.executable, sys.executable)
    assert run.returncode == 0, run.stderr
    assert "bits differ: nowhere" in run.stdout
    assert "carlson_rc" in run.stdout


def test_a_last_digit_that_moves_is_found(tmp_path):
    (tmp_path / "sitecustomize.py").write_text(
        "import numpy, libration.elliptic as elliptic\n"
        "right = elliptic.carlson_rc\n"
        "def carlson_rc(x, y, out=None):\n"
        "    found = right(x, y, out=out)\n"
        "    found[7] = numpy.nextafter(found[7], 9)\n"
        "    return found\n"
        "elliptic.carlson_rc = carlson_rc\n"
    )
    python = tmp_path / "python"
    python.write_text(f'#!/bin/sh\nPYTHONPATH="{tmp_path}" exec "{sys.executable}" "$@"\n')
    python.chmod(0o755)
    run = compared(sys.executable, str(python))
    assert run.returncode == 1, run.stderr
    assert "1 of 2,048 differ, 1 ulp" in run.stdout
    assert "bits differ: carlson_rc" in run.stdout


def test_a_missing_interpreter_is_named():
    run = compared(sys.executable, "no-such-python")
    assert run.returncode == 1
    assert run.stderr.strip() == "no interpreter no-such-python"


def test_difference_counts_values_and_units():
    one = np.array([1.0, -0.0, np.nan, 2.0])
    assert difference([one], [one.copy()]) == "same"
    assert difference([one], [np.array([1.0, 0.0, -np.nan, 2.0])]) == "1 of 4 differ, sign of zero"
    assert difference([one], [np.array([1.0, -5e-324, np.nan, 2.0])]) == "1 of 4 differ, 1 ulp"
    assert difference([one], [np.array([1.0, -0.0, 1.0, 2.0])]).startswith("1 of 4 differ")
    assert difference([one], [one[:3]]) == "types or shapes differ"
    assert difference([np.array([1 + 2j])], [np.array([1 + np.nextafter(2, 3) * 1j])]) == "1 of 2 differ, 1 ulp"
    assert difference([np.array(["rest"])], [np.array(["well"])]) == "1 of 1 differ"


def test_the_ratio_is_formed_within_a_round():
    old, new, ratio = medians([(1.0, 2.0), (10.0, 20.0), (4.0, 9.0)])
    assert (old, new, ratio) == (4.0, 9.0, 2.0)
