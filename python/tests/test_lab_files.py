"""What the lab's tests hold its view Data to is what the command line prints: lab/tests/fits.json and lab/tests/gravity.json.

lab/tests/data.test.ts compares the page with the same two files to 1e-12, parts of uncertainties to 1e-11, so they agree with each other.
"""

import json
from pathlib import Path
from typing import Any

import pytest
from test_fit_page import difference

from libration.cli import main

TESTS = Path(__file__).parents[2] / "lab/tests"
FITS = json.loads((TESTS / "fits.json").read_text(encoding="utf-8"))
PERIODS = json.loads((TESTS / "gravity.json").read_text(encoding="utf-8"))


def printed(capsys: pytest.CaptureFixture[str], command: list[str]) -> Any:
    main([*command, "--json"])
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize("case", FITS, ids=[case["name"] for case in FITS])
def test_fits(
    case: dict[str, Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for file in case["files"]:
        name = file["name"]
        text = file["text"] or (TESTS / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    found = printed(capsys, ["fit", *case["command"]])
    wanted = dict(case["answer"])
    for row, record in zip(wanted.pop("records", []), found.get("records", []), strict=True):
        assert difference({key: record[key] for key in row}, row) < 1e-12
    for key, value in wanted.items():
        assert difference(found[key], value) < 1e-12, key


@pytest.mark.parametrize("case", PERIODS, ids=[" ".join(case["command"]) for case in PERIODS])
def test_periods(case: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    assert difference(printed(capsys, ["gravity", *case["command"]]), case["answer"]) < 1e-12


def test_another_period_is_another_g(capsys: pytest.CaptureFixture[str]) -> None:
    command = ["--period", "2.042", *PERIODS[0]["command"][2:]]
    assert difference(printed(capsys, ["gravity", *command]), PERIODS[0]["answer"]) > 1e-5
