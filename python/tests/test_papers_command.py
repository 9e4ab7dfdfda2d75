"""`libration papers`: all files or none, the table of claims, and one line for whatever is wrong."""

import csv
import dataclasses
import os
import sys

import pytest

from libration import papers
from libration.cli import main
from libration.papers import claims, lima, pictures

FILES = {f"{picture.name}.{form}" for picture in pictures() for form in ("svg", "png")} | {"claims.csv"}


@pytest.fixture
def said(capsys, tmp_path, monkeypatch):
    """Run in an empty directory; return exit code, table and line."""
    monkeypatch.chdir(tmp_path)

    def run(*words):
        code = main(["papers", *words])
        shown = capsys.readouterr()
        return code, shown.out, shown.err.strip()

    return run


def test_every_figure_and_claim(said, tmp_path):
    code, table, line = said("--out", "figures")
    assert (code, line) == (0, "")
    assert set(os.listdir(tmp_path)) == {"figures"}
    assert set(os.listdir(tmp_path / "figures")) == FILES
    with open(tmp_path / "figures/claims.csv", encoding="utf-8", newline="") as file:
        written = list(csv.DictReader(file))
    assert len(written) == len(claims())
    for row, claim in zip(written, claims(), strict=True):
        assert row["place"] == claim.place
        assert row["verdict"].partition(" (")[0] == claim.verdict
        if claim.measured:
            assert float(row["value"]) == claim.value
            assert claim.ours in table.replace("\u00a0", " ").replace("\n" + " " * 22, " ")
    assert f"{len(claims())} claims: " in table
    for name in FILES - {"claims.csv"}:
        head = (tmp_path / "figures" / name).read_bytes()[:60]
        assert head.startswith(b"\x89PNG" if name.endswith("png") else b"<?xml")


def test_one_paper_and_lima_needs_no_scipy(said, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.integrate", None)
    code, table, _ = said("lima")
    assert code == 0
    assert set(os.listdir(tmp_path / "out")) == {name for name in FILES if name.startswith("lima")} | {"claims.csv"}
    assert table.startswith("Lima 2019\n")
    assert "written to out: 4 figures" in table


def test_a_claim_that_does_not_stand_is_named(said, monkeypatch):
    spoiled = dataclasses.replace(lima.CLAIMS[4], measured=lambda: 3.0)
    monkeypatch.setattr(lima, "CLAIMS", (*lima.CLAIMS[:4], spoiled))
    code, _, line = said("lima")
    assert code == 1
    assert line.startswith("libration papers: Lima 2019, section 4, fig. 2: largest error of the Fourier-based")
    assert line.endswith("3 % does not support reproduced")


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["slas"], "unknown paper 'slas': must be salas, lima or horsley"),
        (["Horsly"], "unknown paper 'Horsly': must be horsley, salas or lima"),
        ([""], "unknown paper '': must be salas, lima or horsley"),
        (["salas", "lima"], "unknown word 'lima'; see libration papers --help"),
        (["lima", "--ot", "x"], "unknown option '--ot'; did you mean --out?"),
        (["lima", "--out"], "--out: needs a value, --out DIR; see libration papers --help"),
        (["lima", "--out", ""], "--out = '': must be a directory"),
        (["lima", "--out", "a/b/c"], "--out = a/b/c: cannot be made: there is no directory"),
        (["lima", "--out", "file"], "--out = file: is not a directory"),
    ],
)
def test_bad_input_is_one_line(said, tmp_path, words, line):
    (tmp_path / "file").write_text("kept")
    code, table, shown = said(*words)
    assert (code, table) == (2, "")
    assert len(shown.splitlines()) == 1
    assert shown.startswith("libration papers: ")
    assert line in shown
    assert os.listdir(tmp_path) == ["file"]
    assert (tmp_path / "file").read_text() == "kept"


@pytest.mark.parametrize(
    ("module", "paper", "name"),
    [
        ("scipy.integrate", "horsley", "SciPy"),
        ("scipy.integrate", "salas", "SciPy"),
        ("matplotlib.figure", "lima", "matplotlib"),
    ],
)
def test_missing_package(said, tmp_path, monkeypatch, module, paper, name):
    monkeypatch.setitem(sys.modules, module, None)
    code, _, line = said(paper)
    assert code == 2
    assert line == f"libration papers: --out = out: needs {name}: pip install 'libration[papers]'"
    assert os.listdir(tmp_path) == []


def test_a_figure_that_cannot_be_drawn_leaves_nothing(said, tmp_path, monkeypatch):
    def fail(self, files):
        raise RuntimeError("no ink")

    monkeypatch.setattr(papers.Picture, "save", fail)
    with pytest.raises(RuntimeError, match="no ink"):
        said("lima")
    assert os.listdir(tmp_path) == []
