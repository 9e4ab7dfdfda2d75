"""The picture of the formulas of the period: every formula is a curve of its own, and a turning angle is marked."""

import math

import numpy as np
import pytest
from matplotlib.figure import Figure

from libration import approx
from libration.approx._period import listed
from libration.plot import plot_periods
from libration.plot._periods import draw_periods


@pytest.mark.parametrize("theta_max", [None, 2.6])
def test_every_formula_is_drawn_once(theta_max):
    figure = Figure()
    draw_periods(figure, theta_max)
    upper, lower = figure.axes
    drawn = {line.get_label().partition(" = ")[0]: line for line in upper.lines if line.get_label()[0] != "_"}
    # agm:2 is the same curve as belendez and shares its entry.
    assert set(drawn) == {formula.name for formula in listed()} - {"agm:2"} | {"exact"}
    degrees, ratio = drawn["lima-arun"].get_data()
    assert np.array_equal(ratio, approx.period("lima-arun").ratio(np.radians(degrees)))
    looks = {
        (line.get_color(), str(line.get_linestyle()), line.get_linewidth(), str(line._dash_pattern))
        for line in lower.lines
    }
    assert len({str(look) for look in looks}) == len(drawn) - 1 + (theta_max is not None)
    marks = [line.get_xdata()[0] for line in lower.lines if len(line.get_xdata()) == 2]
    assert marks == ([] if theta_max is None else [math.degrees(theta_max)])


def test_it_is_saved(tmp_path):
    plot_periods(tmp_path / "periods.svg", theta_max=1.0)
    assert (tmp_path / "periods.svg").read_text(encoding="utf-8").count("<path") > 20
