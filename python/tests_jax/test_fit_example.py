"""The fit of examples/fit.py in a small form: the numbers that the signal was made of come back, and the picture is drawn."""

import runpy
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

SCRIPT = runpy.run_path(str(Path(__file__).resolve().parents[2] / "examples/fit.py"))


def test_the_numbers_of_the_bunch_come_back():
    value, slopes = SCRIPT["model"](2000)
    seen = SCRIPT["measured"](20_000)
    found, errors, squares = SCRIPT["fit"](seen, value, slopes)
    assert np.abs((found - SCRIPT["TRUE"]) / errors).max() < 4
    assert np.all(errors < [0.01, 0.01, 0.001, 0.003])
    assert squares[0] > 100 and squares[-1] < 1.3 and len(squares) < 30
    # The derivatives are those of the signal.
    for place, step in enumerate((1e-3, 1e-3, 1e-4, 1e-3)):
        change = step * np.eye(4)[place]
        by_difference = (value(found + change) - value(found - change)) / (2 * step)
        exact = slopes(found)[:, place]
        assert np.abs(by_difference - exact).max() < 1e-2 * np.abs(exact).max()


def test_the_picture_is_drawn():
    figure = Figure(figsize=SCRIPT["SIZE"], layout="constrained", dpi=40)
    SCRIPT["draw"](figure, n=50, most=20)
    figure.draw_without_rendering()
    assert all(axes.has_data() and axes.get_xlabel() for axes in figure.axes)
