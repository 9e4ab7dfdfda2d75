"""The figures of the papers: what each carries, which curves it holds, and that the same picture is the same file."""

import io
import math
import re
import warnings

import numpy as np
import pytest
from matplotlib.figure import Figure

from libration import Pendulum, papers
from libration.papers.salas._figures import EXAMPLE2
from libration.plot import linear_theta

PICTURES = {picture.name: picture for picture in papers.pictures()}
NAMES = [
    *(f"salas-{number}" for number in range(1, 8)),
    *(f"lima-{number}" for number in range(1, 5)),
    *("horsley-1", "horsley-2", "horsley-3", "horsley-phase-space", "horsley-ellipse"),
]
DRAWINGS = {"salas-1", "lima-1", "horsley-1"}


@pytest.fixture(scope="module")
def figures():
    """Every picture, drawn once."""
    drawn = {}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name, picture in PICTURES.items():
            drawn[name] = Figure(layout="constrained")
            picture.draw(drawn[name])
    return drawn


def curves(axes):
    """The labelled curves of a panel."""
    return {line.get_label(): line.get_data() for line in axes.get_lines() if not line.get_label().startswith("_")}


def test_one_picture_for_every_printed_figure():
    assert list(PICTURES) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_what_every_figure_carries(name, figures):
    picture = PICTURES[name]
    work = {"salas": "Salas 2019", "lima": "Lima 2019", "horsley": "Horsley 2025"}[name.partition("-")[0]]
    assert picture.title
    assert work in picture.caption
    axes = figures[name].axes
    if name in DRAWINGS:
        letters = {text.get_text() for text in axes[0].texts}
        assert {r"$m$"} <= letters
        assert letters & {r"$\varphi$", r"$\theta$"}
        return
    assert axes[-1].get_xlabel()
    assert any(each.get_legend() for each in axes)
    if name != "horsley-ellipse":
        assert all(each.get_ylabel() for each in axes)


@pytest.mark.parametrize(
    ("number", "theta0", "order"), [(2, math.pi / 3, 1), (3, math.pi / 2, 2), (4, 7 * math.pi / 8, 4)]
)
def test_lima_draws_the_deviations_he_states(number, theta0, order, figures):
    upper, lower = figures[f"lima-{number}"].axes
    drawn = curves(upper)
    assert list(drawn) == ["exact", "harmonic, (17)", f"Fourier, (22), {order} term{'s' * (order > 1)}"]
    shares, theta = drawn["exact"]
    assert np.array_equal(theta, Pendulum(theta0).theta(shares * Pendulum(theta0).period))
    harmonic, fourier = (np.max(np.abs(line.get_ydata())) for line in lower.get_lines()[1:])
    stated = {2: (0.9413, 1.9513), 3: (2.3289, 0.2269), 4: (12.3427, 0.3989)}[number]
    assert (harmonic, fourier) == pytest.approx(stated, abs=2e-4)


def test_horsley_draws_his_two_solutions(figures):
    for name, theta0 in (("horsley-2", 0.4), ("horsley-3", 3.0)):
        pendulum = Pendulum(theta0, length=1.0, gravity=9.8)
        drawn = curves(figures[name].axes[0])
        t, numerical = drawn["nonlinear (odeint)"]
        assert (len(t), t[0], t[-1]) == (500, 0.0, 10.0)
        assert np.max(np.abs(numerical - pendulum.theta(t))) < 1e-4
        assert np.array_equal(drawn["linear"][1], linear_theta(pendulum, t))


def test_salas_draws_the_turns_that_his_arctan_loses(figures):
    drawn = curves(figures["salas-4"].axes[0])
    t, angle = drawn["exact"]
    assert np.array_equal(angle, Pendulum(*EXAMPLE2).theta(t))
    assert angle[-1] > 8 * math.pi
    assert np.nanmax(np.abs(drawn["(23) as printed"][1])) <= math.pi


def test_example_3_is_that_of_the_text(figures):
    t, angle = curves(figures["salas-5"].axes[0])["exact"]
    assert angle[0] == math.pi / 2
    assert t[-1] == pytest.approx(2 * 7.41629870920549, rel=1e-14)


def test_the_point_on_the_ellipse_is_the_chord_of_the_pendulum(figures):
    left, middle, _ = figures["horsley-ellipse"].axes
    x = next(line for line in left.get_lines() if line.get_linewidth() == 3).get_xdata()[1]
    chord = next(line for line in middle.get_lines() if line.get_linewidth() == 3)
    length = math.hypot(*np.diff(chord.get_xdata()), *np.diff(chord.get_ydata()))
    assert length == pytest.approx(2 * math.sin(math.pi / 3) * x, rel=1e-12)


def test_the_same_picture_is_the_same_file_and_says_what_it_is():
    def saved():
        files = {"svg": io.BytesIO(), "png": io.BytesIO()}
        PICTURES["lima-2"].save(files)
        return files["svg"].getvalue(), files["png"].getvalue()

    first = saved()
    assert first == saved()
    svg = first[0].decode()
    assert "Periodic approximations, θ₀ = π/3 = 60°, N = 1" in re.search("<title>(.*?)</title>", svg)[1]
    assert PICTURES["lima-2"].caption in svg
    assert first[1].startswith(b"\x89PNG")
    assert PICTURES["lima-2"].caption.encode() in first[1]


def test_unknown_paper():
    with pytest.raises(ValueError, match="unknown paper 'lina': must be lima"):
        papers.pictures("lina")
