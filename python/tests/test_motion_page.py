"""The table of the motion that the page saves, beside that of `libration solve`.

lab/tests/motion-150deg.csv is what the page writes; lab/tests/save.test.ts holds the page to its bytes. The command writes the same
bytes but for the last digits of angles and velocities: a browser multiplies and adds with two roundings, most processors with one.
Rounded to 12 digits both files are the same.
"""

from pathlib import Path

import numpy as np
import pytest

from libration.cli import main

PAGE = Path(__file__).parents[2] / "lab/tests/motion-150deg.csv"
COMMAND = "solve --theta0 150deg --length 1m --gravity 9.81 --until 4s --samples 41 --out".split()
# Lines before the rows.
HEADER = 13


def page_lines() -> list[str]:
    return PAGE.read_text(encoding="utf-8").split("\n")


def rounded_page() -> list[str]:
    return [",".join(f"{value:.12g}" for value in row) for row in numbers(page_lines())]


def written(tmp_path: Path, *options: str) -> list[str]:
    path = tmp_path / "motion.csv"
    main([*COMMAND, str(path), *options])
    return path.read_text(encoding="utf-8").split("\n")


def numbers(lines: list[str]) -> "np.ndarray[tuple[int, int], np.dtype[np.float64]]":
    return np.array([[float(cell) for cell in line.split(",")] for line in lines[HEADER:] if line])


def test_header_instants_and_linear_motion_are_the_same_bytes(tmp_path: Path) -> None:
    command, page = written(tmp_path), page_lines()
    assert command[:HEADER] == page[:HEADER]
    assert len(command) == len(page)
    for one, other in zip(command[HEADER:], page[HEADER:], strict=True):
        assert one.split(",")[::3] == other.split(",")[::3]


def test_angles_and_velocities_are_the_same_to_the_last_digits(tmp_path: Path) -> None:
    command, page = (numbers(lines) for lines in (written(tmp_path), page_lines()))
    floor = np.array([0, 0, np.abs(page[:, 2]).max() * 2.0**-30, 0])
    # Each is within 4 ulp of the truth.
    assert (np.abs(command - page) <= 8 * np.spacing(np.maximum(np.abs(page), floor))).all()


def test_rounded_to_12_digits_the_files_are_the_same(tmp_path: Path) -> None:
    assert written(tmp_path, "--digits", "12")[HEADER:-1] == rounded_page()


@pytest.mark.parametrize(("option", "value"), [("--gravity", "9.8100001"), ("--theta0", "150.00001deg")])
def test_another_motion_is_another_file(tmp_path: Path, option: str, value: str) -> None:
    path, words = tmp_path / "motion.csv", list(COMMAND)
    words[words.index(option) + 1] = value
    main([*words, str(path), "--digits", "12"])
    other = path.read_text(encoding="utf-8").split("\n")[HEADER:-1]
    assert len(other) == 41
    assert other != rounded_page()
