"""The record of the lab's test of its fit: what the command line gives for it is what lab/tests/fit.test.ts holds the page to.

The JSON beside the record is what `libration fit record-70deg.csv --length 0.800±0.001 --json` printed. Both sides are compared
with it to 1e-12, so they agree with each other. So it is with the malformed files and their lines.
"""

import base64
import json
from pathlib import Path
from typing import Any

import pytest

import libration
from libration.cli import main

RECORD = Path(__file__).parents[2] / "lab/tests/record-70deg.csv"
KEYS = (
    "omega0",
    "g",
    "length",
    "offset",
    "friction",
    "swing",
    "verdicts",
    "window",
    "samples",
    "ladder",
    "budget",
    "rms",
)


def difference(found: Any, wanted: Any) -> float:
    """Largest difference of numbers at the same place, against the size of the wanted one; texts must be the same."""
    if isinstance(wanted, dict):
        assert found.keys() == wanted.keys()
        return max((difference(found[key], wanted[key]) for key in wanted), default=0.0)
    if isinstance(wanted, list | tuple):
        assert len(found) == len(wanted)
        return max((difference(one, other) for one, other in zip(found, wanted, strict=True)), default=0.0)
    if isinstance(wanted, float):
        return abs(found - wanted) / max(1e-3, abs(wanted))
    assert found == wanted
    return 0.0


@pytest.mark.parametrize("key", KEYS)
def test_the_command_line_gives_what_the_page_is_held_to(key: str) -> None:
    wanted = json.loads(RECORD.with_suffix(".json").read_text(encoding="utf-8"))
    found = libration.fit(RECORD, length=(0.8, 0.001)).to_dict()
    assert difference(found[key], wanted[key]) < 1e-12


def test_a_record_with_another_time_does_not(tmp_path: Path) -> None:
    spoiled = tmp_path / RECORD.name
    spoiled.write_text(RECORD.read_text(encoding="utf-8").replace("0.1,", "0.1001,", 1), encoding="utf-8")
    wanted = json.loads(RECORD.with_suffix(".json").read_text(encoding="utf-8"))
    assert difference(libration.fit(spoiled, length=(0.8, 0.001)).to_dict()["g"], wanted["g"]) > 1e-9


MALFORMED = json.loads(RECORD.with_name("malformed.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("file", MALFORMED, ids=lambda file: str(file["name"]))
def test_malformed_files_have_the_line_of_the_page(
    file: dict[str, str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    content = base64.b64decode(file["base64"]) if "base64" in file else file["text"].encode()
    Path(file["name"]).write_bytes(content)
    assert main(["fit", file["name"]]) == 2
    assert capsys.readouterr().err == f"libration fit: {file['line']}\n"
