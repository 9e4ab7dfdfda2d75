"""Plots into the axes of the user: what is drawn, that nothing else changes, and that three languages have all words."""

import ast
import math
import re
import subprocess
import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure

import libration
from libration import Pendulum, approx, plot
from libration._languages import LANGUAGES
from libration.plot._angle import degrees_text
from libration.plot._comparison import draw_comparison
from libration.plot._language import CATALOGUE, ENGLISH, Language

SWING = Pendulum(3.0, length=1.0, gravity=9.8)
DECAY = libration.DampedPendulum(2.0, friction=libration.Friction(linear=0.05, dry=0.02))
DRAWN = {
    "plot": lambda **given: SWING.plot(**given),
    "plot_phase": lambda **given: SWING.plot_phase(**given),
    "damped": lambda **given: DECAY.plot(**given),
    "damped_phase": lambda **given: DECAY.plot_phase(**given),
    "damped_energy": lambda **given: DECAY.plot_energy(**given),
    "plot_period": lambda **given: plot.plot_period(**given),
    "comparison": lambda **given: approx.compare(SWING, ["linear", "harmonic"]).plot(**given),
    "errors": lambda **given: approx.compare(SWING, ["linear", "harmonic"]).plot_error(**given),
}


@pytest.fixture
def ax():
    """Empty axes of a figure of one's own."""
    return Figure(figsize=(6, 5)).subplots()


def labelled(axes):
    """The curves with a name."""
    return {line.get_label(): line for line in axes.lines if not line.get_label().startswith("_")}


@pytest.mark.parametrize("name", DRAWN)
def test_axes_of_the_user_are_returned_and_keep_their_look(name, ax):
    before = {side: spine.get_visible() for side, spine in ax.spines.items()}
    settings = dict(matplotlib.rcParams)
    assert DRAWN[name](ax=ax) is ax
    assert ax.lines
    assert ax.get_legend() is not None
    assert ax.get_title() == ""
    assert {side: spine.get_visible() for side, spine in ax.spines.items()} == before
    assert dict(matplotlib.rcParams) == settings


def test_no_pyplot_where_axes_are_given(tmp_path):
    code = """if True:
        import sys
        from matplotlib.figure import Figure
        from libration import Pendulum, approx, plot
        ax = Figure().subplots()
        Pendulum(1.0).plot(ax=ax); Pendulum(1.0).plot_phase(Figure().subplots()); plot.plot_period(Figure().subplots())
        approx.compare(Pendulum(1.0)).plot(Figure().subplots())
        sys.exit("matplotlib.pyplot" in sys.modules)
    """
    assert subprocess.run([sys.executable, "-c", code], cwd=tmp_path).returncode == 0


def test_without_axes_there_is_a_new_figure():
    code = """if True:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
        from libration import Pendulum, approx, plot
        made = [Pendulum(1.0).plot(), Pendulum(1.0).plot_phase(), plot.plot_period(), approx.compare(Pendulum(1.0)).plot()]
        assert len(pyplot.get_fignums()) == 4
        assert len(made[-1].figure.axes) == 2
        assert made[-1].figure.axes[0] is made[-1]
    """
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize(
    "call", ["Pendulum(1.0).plot()", "Pendulum(1.0).plot_phase()", "plot.plot_period()", "plot.plot_periods('a.png')"]
)
def test_without_matplotlib_the_line_says_what_to_install(call, tmp_path):
    code = f"""if True:
        import sys
        sys.modules["matplotlib"] = None
        from libration import Pendulum, plot
        try:
            {call}
        except ImportError as error:
            print(error)
    """
    run = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert run.stdout == "a picture needs matplotlib: pip install 'libration[plot]'\n"


def test_the_angle_goes_into_the_axes_of_the_user(ax):
    SWING.plot([0.0, 10.0], ax=ax, color="black", lw=3, label="mine")
    curve = labelled(ax)["mine"]
    t, theta = curve.get_data()
    assert (t[0], t[-1]) == (0.0, 10.0)
    assert np.array_equal(theta, SWING.theta(t))
    assert (curve.get_color(), curve.get_linewidth()) == ("black", 3)
    assert np.array_equal(labelled(ax)["linear"].get_ydata(), plot.linear_theta(SWING, t))
    assert [text.get_text() for text in ax.texts] == ["171.9°"]


def test_several_angles_have_a_colour_each_and_one_linear_label(ax):
    for theta0 in (1.0, 2.0):
        Pendulum(theta0).plot(ax=ax)
    found = labelled(ax)
    assert list(found) == [r"$\theta_0$ = 1 rad", "linear", r"$\theta_0$ = 2 rad"]
    assert len({found[label].get_color() for label in found}) == 3


@pytest.mark.parametrize(
    ("pendulum", "until"),
    [
        (Pendulum(1.0), 2 * Pendulum(1.0).period),
        (Pendulum(0.0, 3.0), 2 * Pendulum(0.0, 3.0).period),
        (Pendulum(0.0, 2.0), 12.0),
        (Pendulum(0.5, omega0=0.0), 10.0),
        (Pendulum(0.0, omega0=2.0), 2 * math.pi),
    ],
)
def test_a_motion_is_drawn_without_instants(pendulum, until, ax):
    pendulum.plot(ax=ax)
    assert ax.lines[0].get_xdata()[-1] == until
    pendulum.plot_phase(Figure().subplots())


def test_two_orbits_share_one_background(ax):
    Pendulum(1.0).plot_phase(ax)
    background = len(ax.lines)
    Pendulum(0.0, 3.0).plot_phase(ax, color="black")
    labels = [line.get_label() for line in ax.lines]
    assert labels.count("separatrix") == 1
    assert len(ax.lines) - background < background
    where, velocity = labelled(ax)[r"$\theta_0$ = 0 rad, $\dot\theta_0$ = 3 rad/s"].get_data()
    kept = np.isfinite(where)
    assert np.allclose(np.sin(where[kept] / 2) ** 2 + (velocity[kept] / 2) ** 2, 2.25, rtol=1e-12)
    assert ax.get_ylim()[1] > 3


def test_chosen_formulas_of_the_period(ax):
    plot.plot_period(ax, formulas=["bernoulli", "agm:1"], theta_max=2.0)
    found = labelled(ax)
    assert list(found) == ["exact", "bernoulli", "agm:1"]
    degrees, ratio = found["bernoulli"].get_data()
    assert np.array_equal(ratio, approx.period("bernoulli").ratio(np.radians(degrees)))
    other = plot.plot_period(Figure().subplots(), formulas=["agm:1"], error=True)
    assert other.get_yscale() == "log"
    with pytest.raises(ValueError, match=r"formulas = 'linear': must be a list of names, as \['linear'\]"):
        plot.plot_period(ax, formulas="linear")


def test_a_comparison_holds_the_errors_of_its_solutions():
    made = approx.compare(Pendulum(3.0), ["harmonic", "fourier:4", "euler:0.1"], periods=2)
    assert made.names == ("harmonic", "fourier:4", "euler:0.1")
    for name, error in made.errors.items():
        registry = approx.numerical if name == "euler:0.1" else approx.angle
        assert error == pytest.approx(registry(name).of(Pendulum(3.0)).error(2), nan_ok=True)
    lines = str(made).splitlines()
    assert lines[0] == "libration, T = 16.1555 s, theta_max = 3 rad"
    assert [line.split()[0] for line in lines[2:]] == list(made.names)
    assert "undefined from t/T = " in lines[3]
    assert "goes over the top at t = " in lines[4]


@pytest.mark.parametrize(
    ("names", "periods", "said"),
    [
        (["harmonik"], 1, "names: 'harmonik': must be one of harmonic, "),
        ([3], 1, "names: 3: must be one of linear, "),
        ([], 1, "names = (): must be a list of at least one name, as ['linear']"),
        (None, 1, "names = None: must be a list of at least one name, as ['linear']"),
        ("harmonic", 1, "names = 'harmonic': must be a list of names, as ['harmonic']"),
        (["linear", "linear"], 1, "names: must differ; linear comes twice"),
        (["linear"], 0, "periods = 0.0: must be above 0 and at most 10000"),
        (["linear"], "2", "periods = '2': must be one real number"),
    ],
)
def test_what_cannot_be_compared(names, periods, said):
    with pytest.raises(ValueError) as caught:
        approx.compare(Pendulum(1.0), names, periods=periods)
    assert str(caught.value).startswith(said)
    assert "\n" not in str(caught.value)


def test_motions_that_cannot_be_compared():
    with pytest.raises(ValueError, match="must move; it is at rest"):
        approx.compare(Pendulum(0.0), ["linear"])
    with pytest.raises(ValueError, match="period = inf: must be finite"):
        approx.compare(Pendulum(0.0, 2.0), ["linear"])
    with pytest.raises(ValueError, match=r"pendulum = 1\.0: must be a Pendulum"):
        approx.compare(1.0, ["linear"])


def test_errors_that_span_decades_are_on_a_logarithmic_axis(ax):
    made = approx.compare(Pendulum(1.0), ["linear", "fourier:6"])
    made.plot_error(ax)
    assert ax.get_yscale() == "log"
    linear = labelled(ax)["linear"].get_ydata()
    assert np.nanmax(linear) == pytest.approx(100 * made.errors["linear"].relative, rel=1e-3)
    low, high = ax.get_ylim()
    assert low < 100 * made.errors["fourier:6"].relative < high
    alike = Figure().subplots()
    approx.compare(Pendulum(1.0), ["harmonic", "fourier:1"]).plot_error(alike)
    assert alike.get_yscale() == "linear"


@pytest.mark.parametrize(
    ("theta0", "said"),
    [
        (math.radians(171.9), "171.9°"),
        (math.radians(179.999), "179.999°"),
        (math.radians(179.95), "179.95°"),
        (math.radians(179.99999), "179.99999°"),
        (math.pi, "180° − 7×10⁻¹⁵°"),
    ],
)
def test_a_turning_angle_is_not_rounded_to_the_top(theta0, said):
    pendulum = Pendulum(theta0)
    assert degrees_text(pendulum.theta_max, pendulum, ENGLISH) == said


def test_every_text_of_the_pictures_is_in_the_catalogue():
    used = set()
    for path in Path(plot.__file__).parent.glob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "say.word" and node.args:
                used |= {each.value for each in ast.walk(node.args[0]) if isinstance(each, ast.Constant)}
    assert len(used) > 20
    assert used <= set(CATALOGUE)
    assert {str(regime) for regime in libration.OscillatorRegime} <= set(CATALOGUE)


@pytest.mark.parametrize("text", CATALOGUE)
def test_translations_are_complete(text):
    assert len(CATALOGUE[text]) == len(LANGUAGES) - 1
    for other in CATALOGUE[text]:
        assert other == other.strip() != ""
        for part in ("start", "period", "angle", "axis", "shown", "all", "regime", "ends", "first", "second"):
            assert other.count(f"{{{part}}}") == text.count(f"{{{part}}}")
        assert ("θmax" in other) == ("θmax" in text)


def test_ticks_have_a_decimal_comma(ax):
    Pendulum(1.0).plot([0.0, 1.0], ax=ax, lang="pt-BR")
    ax.figure.draw_without_rendering()
    assert "0,2" in [label.get_text() for label in ax.get_xticklabels()]
    other = Pendulum(1.0).plot([0.0, 1.0], ax=Figure().subplots())
    other.figure.draw_without_rendering()
    assert "0.2" in [label.get_text() for label in other.get_xticklabels()]


def test_a_long_legend_reads_from_left_to_right():
    names = ["linear", "cubic", "trigonometric", "fourier:2", "small-m"]
    figure = Figure(figsize=(9, 6.5))
    draw_comparison(figure, SWING, [(name, approx.angle(name).of(SWING)) for name in names], 1.0)
    figure.draw_without_rendering()
    texts = figure.axes[0].get_legend().get_texts()
    boxes = {text.get_text(): text.get_window_extent() for text in texts}
    read = sorted(boxes, key=lambda name: (-round(boxes[name].y0), boxes[name].x0))
    assert read == ["exact", *names]


@pytest.mark.parametrize("name", DRAWN)
def test_refusals_of_axes(name, ax):
    with pytest.raises(ValueError, match="ax = 3: must be Axes of matplotlib, or None for a new figure"):
        DRAWN[name](ax=3)
    with pytest.raises(ValueError, match="lang = 'fr': must be en, pt-BR or es"):
        DRAWN[name](ax=ax, lang="fr")
    assert not ax.lines


@pytest.mark.parametrize("name", DRAWN)
@pytest.mark.parametrize("projection", ["3d", "polar"])
def test_axes_of_other_projections_are_refused(name, projection):
    with pytest.raises(ValueError, match=f"must be plain Axes, with x and y; its projection is {projection}"):
        DRAWN[name](ax=Figure().add_subplot(projection=projection))


@pytest.mark.parametrize(
    ("t", "said"),
    [
        ([], "t = []: at least one finite instant"),
        ([math.nan], "t = [nan]: at least one finite instant"),
        ("abc", "t = 'abc': must be real numbers"),
        ([1j], "t = [1j]: must be real numbers"),
        ({1.0, 2.0}, "t = {1.0, 2.0}: must be real numbers; write sorted(t)"),
        ([[1.0], [2.0, 3.0]], "t = [[1.0], [2.0, 3.0]]: must be real numbers"),
        (np.array(["2020-01-01"], dtype="M8[D]"), "t = an array of shape (1,): must be real numbers; write (t - t[0])"),
        (np.array([1j]), "t = an array of shape (1,): must be real numbers; write np.real(t)"),
        (Figure().subplots(), "must be instants; axes are given by ax="),
    ],
)
@pytest.mark.parametrize("draw", [SWING.plot, lambda t, ax: SWING.plot_phase(ax, t=t)])
def test_instants_that_are_refused(draw, t, said, ax):
    with pytest.raises((TypeError, ValueError), match=re.escape(said)):
        draw(t, ax=ax)
    assert ax.lines[:] == []


@pytest.mark.parametrize("lang", ["pt", "PT_br", "pt-BR"])
def test_a_language_in_any_letters(lang, ax):
    SWING.plot(ax=ax, lang=lang)
    assert "linear" in labelled(ax)
    assert Language(lang) == Language("pt-BR")
