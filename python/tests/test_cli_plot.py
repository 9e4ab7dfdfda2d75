"""The picture: what is drawn, for every regime, without leaving a trace in matplotlib's global state."""

import io
import math
import subprocess
import sys
import warnings

import mpmath
import numpy as np
import pytest
from matplotlib.figure import Figure

from libration import Pendulum
from libration.cli import main
from libration.plot import linear_theta, plot_motion
from libration.plot._angle import draw_angle, headline
from libration.plot._portrait import covered, draw_portrait
from libration.plot._style import angle_ticks, pi_text

MOTIONS = {
    "libration": (Pendulum(3.0, length=1.0, gravity=9.8), np.linspace(0, 10, 500)),
    "rotation": (Pendulum(0.3, -2.6), np.linspace(0, 20, 300)),
    "fast": (Pendulum(0.0, 50.0), np.linspace(0, 10, 300)),
    "separatrix": (Pendulum(0.0, 2.0), np.linspace(-6, 1000, 300)),
    "near": (Pendulum(math.pi), np.linspace(0, 300, 300)),
    "tiny": (Pendulum(1e-7), np.linspace(0, 20, 300)),
    "rest": (Pendulum(0.0), np.linspace(0, 1, 3)),
    "hanging": (Pendulum(2.5, omega2=-4.0), np.linspace(0, 8, 200)),
    "free": (Pendulum(1.0, 2.0, omega0=0.0), np.linspace(0, 8, 20)),
    "one": (Pendulum(1.0), [2.0]),
    "zero": (Pendulum(1.0), [0.0]),
    "unsorted": (Pendulum(1.0), [1e6, 1e6 + 20, 1e6 + 5, math.nan]),
    "lost": (Pendulum(1.0), [1e300, 2e300]),
}


@pytest.fixture
def axes():
    """An empty panel."""
    return Figure(figsize=(6, 5)).subplots()


def labelled(axes):
    """The curves that the legend names."""
    return {line.get_label(): line for line in axes.get_lines() if not line.get_label().startswith("_")}


@pytest.mark.parametrize("name", MOTIONS)
def test_every_motion_is_drawn(name):
    pendulum, t = MOTIONS[name]
    picture = io.BytesIO()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plot_motion(pendulum, t, picture, form="png")
    head = picture.getvalue()
    assert head.startswith(b"\x89PNG")
    assert (int.from_bytes(head[16:20]), int.from_bytes(head[20:24])) == (1200, 500)


def test_left_panel_holds_the_exact_and_the_linear_curve(axes):
    pendulum, t = MOTIONS["libration"]
    draw_angle(axes, pendulum, t)
    curves = labelled(axes)
    assert set(curves) == {"exact", "linear"}
    fine, theta = curves["exact"].get_data()
    assert (fine[0], fine[-1]) == (0.0, 10.0)
    assert np.array_equal(theta, pendulum.theta(fine))
    assert np.allclose(curves["linear"].get_ydata(), 3 * np.cos(pendulum.omega0 * fine), atol=1e-13)
    assert "[s]" in axes.get_xlabel()
    assert "[rad]" in axes.get_ylabel()


def test_few_instants_are_dots_and_many_swings_are_cut(axes):
    draw_angle(axes, Pendulum(1.0), np.linspace(0, 5, 7))
    assert len(labelled(axes)["instants"].get_xdata()) == 7
    other = Figure().subplots()
    draw_angle(other, Pendulum(1.0), np.linspace(0, 5000, 700))
    assert other.get_xlabel() == "t [s], the first 126 of 5000 s"


def test_right_panel_holds_the_orbit_and_the_separatrix(axes):
    pendulum, t = MOTIONS["libration"]
    draw_portrait(axes, pendulum, t)
    curves = labelled(axes)
    assert {"separatrix", "this motion", "other energies"} < set(curves)
    where, velocity = curves["this motion"].get_data()
    energy = np.sin(where / 2) ** 2 + (velocity / 2) ** 2
    assert np.allclose(energy, pendulum.energy_ratio, rtol=1e-12)
    where, velocity = curves["separatrix"].get_data()
    assert np.allclose(np.abs(velocity), 2 * np.cos(where / 2), atol=1e-12)


@pytest.mark.parametrize(
    ("pendulum", "said"),
    [
        (Pendulum(3.0, length=1.0, gravity=9.8), "3 rad, 0: libration, period 5.1607 s, turning angle 171.9°"),
        (Pendulum(0.3, -2.6), "0.3 rad, −2.6 rad/s: rotation, one turn in 2.95385 s"),
        (Pendulum(0.0, 2.0), "0 rad, 2 rad/s: separatrix, the top is approached and never reached"),
        (Pendulum(0.0), "0 rad, 0: rest, small swings would take 6.28319 s"),
        (Pendulum(0.5, omega0=0.0), "0.5 rad, 0: rest, without a force"),
        (Pendulum(2.5, omega2=-4.0), "2.5 rad, 0: libration, period 3.22438 s, turning angle 36.76° from π"),
    ],
)
def test_headline(pendulum, said):
    assert headline(pendulum).replace(r"$\theta_0$ = ", "").replace(r"$\dot\theta_0$ = ", "") == said


def test_rotation_wraps_without_a_line_across():
    pendulum = Pendulum(0.3, 2.6)
    where, velocity = covered(pendulum, np.linspace(0, 50, 9), 1.0, 0.0)
    kept = ~np.isnan(where)
    assert np.abs(where[kept]).max() <= math.pi
    steps = np.abs(np.diff(where))
    assert np.nanmax(steps) < 0.1
    assert np.isnan(steps).sum() >= 2
    assert np.allclose(np.sin(where[kept] / 2) ** 2 + (velocity[kept] / 2) ** 2, pendulum.energy_ratio, rtol=1e-12)


def test_the_hanging_side_is_centred(axes):
    draw_portrait(axes, *MOTIONS["hanging"])
    assert axes.get_xlim() == (0.0, 2 * math.pi)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (math.pi, "π"),
        (-math.pi, "−π"),
        (math.pi / 2, "π/2"),
        (-3 * math.pi / 4, "−3π/4"),
        (3 * math.pi / 2, "3π/2"),
        (20 * math.pi, "20π"),
    ],
)
def test_ticks_in_words(value, text):
    assert pi_text(value) == text


@pytest.mark.parametrize(("high", "multiples"), [(0.01, False), (1.0, True), (3.0, True), (1e3, True), (1e12, False)])
def test_ticks_are_multiples_of_pi_where_sensible(axes, high, multiples):
    axes.set_ylim(-high, high)
    angle_ticks(axes.yaxis, -high, high)
    labels = [label.get_text() for label in axes.get_yticklabels()]
    assert any("π" in label for label in labels) == multiples
    assert len(labels) < 15


def linear_truth(theta0, velocity0, omega2, t):
    """The linear solution to 60 digits."""
    with mpmath.workdps(60):
        omega0 = mpmath.sqrt(omega2())
        phase = omega0 * mpmath.mpf(t)
        return theta0 * mpmath.cos(phase) + mpmath.mpf(velocity0) / omega0 * mpmath.sin(phase)


def linear_error(got, theta0, velocity0, omega2, t):
    """Its error in ulp, the ulp of 2**-30 of the largest angle at least."""
    with mpmath.workdps(60):
        truth = linear_truth(theta0, velocity0, omega2, t)
        largest = mpmath.hypot(theta0, velocity0 / mpmath.sqrt(omega2()))
        return float(abs(got - truth) / math.ulp(float(max(abs(truth), largest * mpmath.mpf(2) ** -30))))


LINEAR = {
    "Horsley": ((3.0, 0.0), {"length": 1.0, "gravity": 9.8}, lambda: mpmath.mpf(9.8)),
    "both": ((3.0, -0.7), {"length": 0.3}, lambda: mpmath.mpf(9.80665) / mpmath.mpf(0.3)),
    "small": ((1e-9, 1e-9), {"omega0": 1.3}, lambda: mpmath.mpf(1.3) ** 2),
    "squared": ((0.0, 5.0), {"omega2": 2.0}, lambda: mpmath.mpf(2.0)),
    "slow": ((1.0, 1e-150), {"omega0": 1e-150}, lambda: mpmath.mpf(1e-150) ** 2),
    "large": ((1e200, 1e300), {"omega0": 3.0}, lambda: mpmath.mpf(9)),
}


@pytest.mark.parametrize("name", LINEAR)
def test_linear_solution_has_its_digits_after_many_swings(name):
    state, given, omega2 = LINEAR[name]
    pendulum = Pendulum(*state, **given)
    t = np.array([0.0, 0.25, 1.0, -7.5, 1e6, 1e6 + 0.3, 1e13, -1e13])
    for got, instant in zip(linear_theta(pendulum, t).tolist(), t.tolist(), strict=True):
        assert linear_error(got, *state, omega2, instant) <= 4


def test_the_phase_of_one_double_is_refused():
    """The sibling: the formula in doubles is right at first and wrong after many swings."""
    state, _, omega2 = LINEAR["Horsley"]
    errors = [linear_error(3 * math.cos(math.sqrt(9.8) * t), *state, omega2, t) for t in (0.25, 1e6, 1e13)]
    assert errors[0] <= 4
    assert min(errors[1:]) > 1e3


@pytest.mark.filterwarnings("error")
def test_linear_solution_at_the_ends_of_the_range():
    t = np.array([0.0, 0.25, 1.0])
    assert linear_theta(Pendulum(3.0, 0.5, omega0=0.0), t).tolist() == [3.0, 3.125, 3.5]
    assert linear_theta(Pendulum(0.0, 0.5, omega0=1e-300), t).tolist() == [0.0, 0.125, 0.5]
    assert linear_theta(Pendulum(0.0), t).tolist() == [0.0, 0.0, 0.0]
    assert linear_theta(Pendulum(5e-324), 0.0) == 5e-324
    assert linear_theta(Pendulum(0.0, 1e308, omega0=0.0), 1e10) == math.inf
    assert np.isnan(linear_theta(Pendulum(1.0), [1e300, math.nan, math.inf])).all()
    with pytest.raises(ValueError, match=r"^omega2 = -1\.0: must not be negative"):
        linear_theta(Pendulum(1.0, omega2=-1.0), t)


def test_settings_of_a_session_are_kept():
    import matplotlib

    with matplotlib.rc_context({"text.usetex": True, "lines.linewidth": 7.0}):
        before = dict(matplotlib.rcParams)
        picture = io.BytesIO()
        plot_motion(Pendulum(1.0), [0.0, 1.0], picture, form="png")
        assert dict(matplotlib.rcParams) == before
    assert picture.getvalue().startswith(b"\x89PNG")


def test_no_instant_is_refused():
    with pytest.raises(ValueError, match="finite instant"):
        plot_motion(Pendulum(1.0), [math.nan], io.BytesIO(), form="png")


def test_svg_is_the_same_each_time(tmp_path):
    for name in ("a.svg", "b.svg"):
        plot_motion(*MOTIONS["libration"], tmp_path / name)
    first, second = ((tmp_path / name).read_text() for name in ("a.svg", "b.svg"))
    assert first.startswith("<?xml")
    assert len(first) == len(second)
    assert "<dc:date>" not in first


def test_pyplot_is_never_loaded(tmp_path):
    code = """if True:
        import io, sys
        from libration import Pendulum
        from libration.plot import plot_motion
        plot_motion(Pendulum(1.0), [0.0, 1.0], io.BytesIO(), form="png")
        sys.exit("matplotlib.pyplot" in sys.modules)
    """
    assert subprocess.run([sys.executable, "-c", code], cwd=tmp_path).returncode == 0


def test_too_large_a_motion_is_refused_in_one_line(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for velocity0 in ("1e300", "1e308"):
        words = ["solve", "--theta0", "1", "--velocity0", velocity0, "--omega0", "1", "--plot", "a.png"]
        assert main(words) == 2
        said = "libration solve: --plot = a.png: cannot be drawn: the motion is too large for an axis\n"
        assert capsys.readouterr().err == said
    assert list(tmp_path.iterdir()) == []
