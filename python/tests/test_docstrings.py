"""Every public docstring says what numpydoc and a reader need: summary, arguments, results, error, source, example."""

import doctest
import inspect
import re
import runpy
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
READ = runpy.run_path(str(ROOT / "docs/surface.py"))
MEMBERS = READ["members"]()
ROWS = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))
PROMISES = {each for name, row in ROWS.items() if "error_max_ulp" in row for each in [name, *row.get("members", [])]}
# In the order that numpydoc asks for.
ORDER = ["Summary", "Parameters", "Returns", "Raises", "Notes", "Examples"]
TOLD = {name: member for name, member in MEMBERS.items() if member["kind"] != "registry"}
# What saves a file returns nothing.
SAVING = ("plot.plot_", "Picture.save")

members = pytest.mark.parametrize("name", TOLD)


def findings(name, member):
    """What is missing or wrong in one docstring."""
    doc = member["doc"]
    parts = READ["sections"](doc)
    first = parts["Summary"].partition("\n\n")[0]
    found = []
    if not first.endswith((".", ":", "``.")) or "\n" in first:
        found.append("the summary is not one line with a full stop")
    if [part for part in ORDER if part in parts] != list(parts):
        found.append(f"sections {', '.join(parts)}")
    if re.search(r"^\s*-{3,}\s*$\n\s*$", doc, re.MULTILINE):
        found.append("a section is empty")
    # A title directly below text, or an underline of another length, is read as text by numpydoc.
    lines = doc.splitlines()
    for number, line in enumerate(lines[1:], 1):
        if line.strip() and set(line.strip()) == {"-"}:
            if len(line) != len(lines[number - 1]) or (number > 1 and lines[number - 2].strip()):
                found.append(f"section {lines[number - 1]}")
    told = [
        each.strip().lstrip("*")
        for line in parts.get("Parameters", "").splitlines()
        if line and not line.startswith(" ") and " : " in line
        for each in line.partition(" : ")[0].split(",")
    ]
    fields = member["kind"] == "class" and "Parameters" not in parts
    if member["kind"] != "property" and not fields and sorted(told) != sorted(member["arguments"]):
        found.append(f"arguments {told}, not {member['arguments']}")
    if member["kind"] == "function" and "Returns" not in parts and not name.startswith(SAVING):
        found.append("no Returns")
    if member["kind"] != "property" and not doctest.DocTestParser().get_examples(parts.get("Examples", "")):
        found.append("no example")
    if name in PROMISES and member["kind"] != "class":
        found += [f"no `{word}`" for word in ("Error promised", "Source:") if word not in doc]
    return found


@members
def test_docstring(name):
    assert findings(name, TOLD[name]) == []


def test_every_room_is_read():
    assert {"Pendulum.theta", "Duffing.u", "elliptic.sn", "PeriodFormula.ratio", "plot.plot_periods"} <= set(TOLD)
    assert {"papers.salas_23", "papers.claims", "Erratum.holds", "Picture.save", "Limit.given"} <= set(TOLD)


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda doc: doc.replace("Parameters\n", "Parameter\n"), "section"),
        (lambda doc: doc.replace("\n\nReturns", "\nReturns"), "section Returns"),
        (lambda doc: doc.replace("theta0 : scalar", "theta_0 : scalar"), "arguments"),
        (lambda doc: doc.replace("Returns\n-------", ""), "no Returns"),
        (lambda doc: doc.replace(">>>", ">>"), "no example"),
        (lambda doc: doc.replace("Source:", "From"), "no `Source:`"),
        (lambda doc: doc.replace("Error promised", "Error"), "no `Error promised`"),
        (lambda doc: doc.replace(".\n\n", "\n\n", 1), "the summary"),
    ],
)
def test_a_spoiled_docstring_is_found(spoil, said):
    theta = TOLD["theta"]
    found = findings("theta", theta | {"doc": inspect.cleandoc(spoil(theta["doc"]))})
    assert any(said in line for line in found), found
