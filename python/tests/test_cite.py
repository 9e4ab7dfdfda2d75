"""One references.bib: every entry whole, what CITATION.cff says, and both forms of every reference."""

import re
from pathlib import Path

import pytest

import libration
from libration._cite import entries
from libration.cli import main
from libration.cli.cite import NAMES

ROOT = Path(__file__).parents[2]


def test_every_entry_is_read_whole():
    text = Path(libration.__file__).with_name("references.bib").read_text(encoding="utf-8")
    assert len(entries()) == text.count("@") and tuple(entries()) == NAMES
    assert sum(len(fields) for _, fields in entries().values()) == text.count(" = {") + 1
    for _, fields in entries().values():
        assert {"author", "title"} <= set(fields)


def test_the_software_has_the_version_that_runs():
    assert f"version {libration.__version__}" in libration.cite()
    assert f"  version = {{{libration.__version__}}},\n" in libration.cite(form="bibtex")


def test_it_says_what_the_citation_file_says():
    said = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    titles = [
        title.strip('"')
        for title in re.findall(r"^ *title: (.*)$|^  - type: \w+\n    title: (.*)$", said, re.MULTILINE)
        for title in title
        if title
    ]
    assert len(titles) == 4
    ours = [fields["title"] for _, fields in entries().values()]
    assert [title for title in titles if title not in ours] == []


@pytest.mark.parametrize("name", NAMES)
def test_both_forms(name):
    line, entry = libration.cite(name), libration.cite(name, form="bibtex")
    assert line.endswith(".") and "\n" not in line and not set("{}") & set(line)
    assert entry.startswith("@") and entry.count("{") == entry.count("}") and entry.endswith("}")
    for field in entries()[name][1].values():
        assert field.strip("{}").replace("--", "–") in line


def test_several_and_all():
    assert libration.cite("lima2019", "dlmf").splitlines() == [libration.cite("lima2019"), libration.cite("dlmf")]
    assert libration.cite("all", "dlmf").splitlines() == [libration.cite(name) for name in NAMES]
    assert libration.cite("all", form="bibtex").count("@") == len(NAMES)


def test_refusals():
    with pytest.raises(
        ValueError, match=r"^name = 'lima': must be all or one of libration, .*; did you mean lima2019\?$"
    ):
        libration.cite("lima")
    with pytest.raises(ValueError, match=r"^form = 'ris': must be text or bibtex$"):
        libration.cite(form="ris")


def test_from_the_shell(capsys):
    assert main(["cite"]) == 0
    assert capsys.readouterr().out == libration.cite() + "\n"
    assert main(["cite", "all", "--bibtex"]) == 0
    assert capsys.readouterr().out == libration.cite("all", form="bibtex") + "\n"
    assert main(["cite", "lama"]) == 2
    assert capsys.readouterr().err.startswith("libration cite: name = 'lama': must be all or one of ")
