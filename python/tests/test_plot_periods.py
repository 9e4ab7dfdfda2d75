"""The picture of the formulas of the period: every formula is a curve of its own, and a turning angle is marked."""

import math

import numpy as np
import pytest
from matplotlib.figure import Figure

from libration import approx
from libration.approx._period import listed
from libration.plot import plot_period, plot_periods
from libration.plot._language import ENGLISH
from libration.plot._periods import draw_periods, families, mark


def curves(axes):
    """The curves that have a name."""
    return {line.get_label().partition(" = ")[0]: line for line in axes.lines if line.get_label()[0] != "_"}


@pytest.mark.parametrize("theta_max", [None, 2.6, [0.5, 1.0, 2.6]])
def test_every_formula_is_drawn_once(theta_max):
    figure = Figure()
    draw_periods(figure, theta_max)
    ratios, *errors = figure.axes
    assert set(curves(ratios)) == {"exact"}
    drawn = [name for axes in errors for name in curves(axes)]
    # belendez is the same curve as agm:2 and shares its entry.
    assert sorted(drawn) == sorted({formula.name for formula in listed()} - {"belendez"})
    degrees, error = curves(errors[2])["lima-arun"].get_data()
    assert np.array_equal(error, np.abs(approx.period("lima-arun").error(np.radians(degrees))))
    marks = [[line.get_xdata()[0] for line in axes.lines if len(line.get_xdata()) == 2] for axes in figure.axes]
    marked = [] if theta_max is None else np.degrees(np.atleast_1d(theta_max)).tolist()
    assert marks == [marked] * len(figure.axes)
    assert [text.get_text() for text in ratios.texts][1:] == [f"{degrees:.4g}°" for degrees in marked]


def test_no_two_curves_of_a_panel_look_alike():
    figure = Figure()
    draw_periods(figure, None)
    for axes in figure.axes[1:]:
        looks = {(line.get_color(), str(line._dash_pattern)) for line in curves(axes).values()}
        dashes = {str(line._dash_pattern) for line in curves(axes).values()}
        assert len(looks) == len(dashes) == len(curves(axes)) >= 3


def test_names_stand_within_their_panel_and_apart():
    figure = Figure(figsize=(12, 7.4), layout="constrained")
    draw_periods(figure, None)
    figure.draw_without_rendering()
    for axes in figure.axes[1:]:
        boxes = [text.get_window_extent() for text in axes.texts]
        frame = axes.get_window_extent()
        assert len(boxes) == len(curves(axes))
        for number, box in enumerate(boxes):
            assert frame.x0 <= box.x0 < box.x1 <= frame.x1
            assert frame.y0 <= box.y0 < box.y1 <= frame.y1
            assert not any(box.overlaps(other) for other in boxes[number + 1 :])


def test_a_formula_without_a_family_has_a_panel(monkeypatch):
    monkeypatch.delitem(families.__globals__["FAMILIES"], "logarithms")
    assert {formula.name for formula in families()["other formulas"]} == {"lima-arun", "cromer", "chachiyo"}


def test_marks_that_are_near_each_other_have_lines_of_their_own():
    axes = Figure().subplots()
    mark(axes, np.radians([15.0, 5.0, 10.0, 60.0]), ENGLISH)
    assert [(text.get_text(), text.xyann[1]) for text in axes.texts] == [
        ("5°", -2),
        ("10°", -14),
        ("15°", -26),
        ("60°", -2),
    ]


@pytest.mark.parametrize("theta_max", [7.0, -0.1, math.nan, [1.0, math.inf], "1", [None]])
def test_turning_angles_that_are_refused(theta_max):
    with pytest.raises(ValueError, match=r"^theta_max = "):
        plot_period(Figure().subplots(), theta_max=theta_max)


def test_it_is_saved(tmp_path):
    plot_periods(tmp_path / "periods.svg", theta_max=1.0)
    assert (tmp_path / "periods.svg").read_text(encoding="utf-8").count("<path") > 20
