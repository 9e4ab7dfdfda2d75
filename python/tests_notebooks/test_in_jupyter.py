"""The notebooks as Jupyter reads them, cell by cell in a kernel, and the apps in marimo. Run by `make test-notebooks`."""

import importlib.util
from pathlib import Path

import jupytext
import pytest
from nbclient import NotebookClient

ROOT = Path(__file__).resolve().parents[2] / "notebooks"
VIEW = "application/vnd.jupyter.widget-view+json"


def outputs(notebook):
    return [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]


@pytest.mark.parametrize("path", sorted(ROOT.glob("*.py")), ids=lambda each: each.stem)
def test_a_notebook_runs_in_a_kernel(path):
    notebook = jupytext.read(path)
    NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": str(ROOT)}}).execute()
    assert not [each for each in outputs(notebook) if each.output_type == "error"]
    assert any(each.output_type == "stream" for each in outputs(notebook))


def test_a_pendulum_shows_itself_as_the_lab():
    notebook = jupytext.read(ROOT / "first_swing.py")
    NotebookClient(notebook, timeout=600, kernel_name="python3").execute()
    shown = [each.data for each in outputs(notebook) if each.output_type == "execute_result"]
    assert any({VIEW, "text/html", "text/plain"} <= set(each) for each in shown)


@pytest.mark.parametrize("path", sorted((ROOT / "apps").glob("*.py")), ids=lambda each: each.stem)
def test_an_app_runs_in_marimo(path):
    place = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(place)
    place.loader.exec_module(module)
    shown, defined = module.app.run()
    assert "mo" in defined and any(each is not None for each in shown)
