"""The notebooks are Python files: each runs from end to end, with what it asserts. In Jupyter and marimo: `make test-notebooks`."""

import ast
import re
import runpy
from pathlib import Path

import matplotlib
import pytest

ROOT = Path(__file__).resolve().parents[2] / "notebooks"
NOTEBOOKS = sorted(ROOT.glob("*.py"))
APPS = sorted((ROOT / "apps").glob("*.py"))


@pytest.fixture
def unseen():
    """Pictures that nobody sees, and that are gone afterwards."""
    from matplotlib import pyplot

    with matplotlib.rc_context():
        pyplot.switch_backend("agg")
        yield
        pyplot.close("all")


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda each: each.stem)
def test_a_notebook_runs(notebook, unseen, capsys):
    runpy.run_path(str(notebook))
    assert capsys.readouterr().out


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda each: each.stem)
def test_a_notebook_is_one_to_jupytext(notebook):
    text = notebook.read_text(encoding="utf-8")
    assert text.startswith("# ---\n# jupyter:\n") and "format_name: percent" in text
    marks = re.findall(r"^# %%.*$", text, re.MULTILINE)
    assert len(marks) > 5 and set(marks) == {"# %%", "# %% [markdown]"}


def test_there_are_four_notebooks_and_two_apps():
    assert len(NOTEBOOKS) == 4 and len(APPS) == 2


@pytest.mark.parametrize("app", APPS, ids=lambda each: each.stem)
def test_an_app_defines_what_its_cells_take(app):
    tree = ast.parse(app.read_text(encoding="utf-8"))
    cells = [each for each in tree.body if isinstance(each, ast.FunctionDef)]
    given = {
        name.id for cell in cells for end in cell.body[-1:] for name in ast.walk(end) if isinstance(name, ast.Name)
    }
    assert len(cells) > 3
    assert {argument.arg for cell in cells for argument in cell.args.args} <= given
