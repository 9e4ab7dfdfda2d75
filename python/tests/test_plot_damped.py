"""The pictures of a pendulum with friction and torque: what is drawn, in which axes, and that it is the motion."""

import io
import math

import numpy as np
import pytest
from matplotlib.figure import Figure

from libration import DampedPendulum, Friction, Pendulum, Torque
from libration.damped import averaged_turning_angle
from libration.plot import plot_motion
from libration.plot._damped import damped_headline
from libration.plot._language import Language

DECAY = DampedPendulum(2.0, friction=Friction(linear=0.02, dry=0.05))
FAST = DampedPendulum(0.0, 2.9, friction=Friction(linear=0.03, quadratic=0.02, dry=0.02))
DRIVEN = DampedPendulum(0.5, torque=Torque(constant=0.5, amplitude=0.3, frequency=0.6, phase=-1.0))
MOTIONS = {
    "decay": (DECAY, [0.0, 60.0]),
    "fast": (FAST, [0.0, 75.0]),
    "driven": (DRIVEN, np.linspace(0.0, 40.0, 30)),
    "hanging": (DampedPendulum(2.5, omega2=-4.0, friction=Friction(linear=0.1)), [0.0, 8.0]),
    "free": (DampedPendulum(0.0, 2.0, omega0=0.0, friction=Friction(linear=0.1)), [0.0, 8.0]),
    "rest": (DampedPendulum(0.0, friction=Friction(dry=0.1)), [0.0, 8.0]),
    "one": (DECAY, [2.0]),
    "tiny": (DampedPendulum(1e-3, friction=Friction(quadratic=0.1)), [0.0, 20.0]),
    "before": (DampedPendulum(1.0, friction=Friction(dry=0.1, presliding=0.01)), [-5.0, 20.0]),
    "samples": (DampedPendulum(1.0, torque=Torque(samples=([-1.0, 9.0], [0.0, 1.0]))), [-3.0, 20.0]),
    "driving": (DampedPendulum(0.1, friction=Friction(linear=-0.05)), [0.0, 40.0]),
    "frictionless": (DampedPendulum(1.0), [0.0, 10.0]),
}


@pytest.fixture
def ax():
    return Figure().subplots()


def labelled(axes):
    return {line.get_label(): line for line in axes.lines if not line.get_label().startswith("_")}


@pytest.mark.parametrize("name", MOTIONS)
def test_every_motion_is_drawn(name):
    pendulum, t = MOTIONS[name]
    for form in ("png", "svg"):
        picture = io.BytesIO()
        plot_motion(pendulum, t, picture, form=form, lang="es")
        assert len(picture.getvalue()) > 5000
    assert pendulum.plot_energy(t, ax=Figure().subplots()).lines


def test_the_angle_and_what_stands_beside_it(ax):
    assert DECAY.plot([0.0, 60.0], ax=ax, color="black") is ax
    lines = labelled(ax)
    curve = lines[r"$\theta_0$ = 2 rad"]
    assert np.array_equal(curve.get_ydata(), DECAY.theta(curve.get_xdata()))
    free = lines["without friction"]
    assert np.array_equal(free.get_ydata(), Pendulum(2.0).theta(free.get_xdata()))
    envelope = lines["envelope in the mean"]
    known = np.isfinite(envelope.get_ydata())
    size = averaged_turning_angle(2.0, envelope.get_xdata(), DECAY.friction)
    assert np.array_equal(envelope.get_ydata()[known], size[known])
    [(begin, end)] = DECAY.rests(0.0, 60.0)
    [band] = [patch for patch in ax.patches if patch.get_label() == "held by dry friction"]
    assert (band.get_x(), band.get_x() + band.get_width()) == pytest.approx((begin, end))
    plain = DECAY.plot([0.0, 60.0], ax=Figure().subplots(), undamped=False, envelope=False)
    assert list(labelled(plain)) == [r"$\theta_0$ = 2 rad"]


def test_an_envelope_follows_the_turns_after_whole_turns(ax):
    envelope = labelled(FAST.plot([0.0, 75.0], ax=ax, undamped=False))["envelope in the mean"]
    turning = FAST.turning_times(0.0, 75.0)
    n = FAST.turns(float(turning[0]))[0]
    assert n >= 1
    upper = np.interp(turning, envelope.get_xdata(), envelope.get_ydata() - math.tau * n)
    assert np.nanmax(np.abs(upper - np.abs(FAST.theta(turning) - math.tau * n))[:-2]) < 0.06


def test_the_path_spirals(ax):
    assert DECAY.plot_phase(ax, t=[0.0, 40.0]) is ax
    path = labelled(ax)[r"$\theta_0$ = 2 rad"]
    theta, velocity = path.get_xdata(), path.get_ydata()
    size = np.sin(theta / 2) ** 2 + velocity**2 / 4
    assert np.all(np.diff(size) <= 1e-12) and size[-1] < 0.1 * size[0]
    assert {"separatrix", "other energies"} <= set(labelled(ax))
    FAST.plot_phase(ax, t=[0.0, 20.0])
    assert [line.get_label() for line in ax.lines].count("separatrix") == 1


def test_turns_over_the_top_leave_gaps(ax):
    path = labelled(FAST.plot_phase(ax, t=[0.0, 20.0], label="path"))["path"]
    theta = path.get_xdata()
    assert np.isnan(theta).sum() == 2
    assert np.nanmax(np.abs(theta)) <= math.pi and np.nanmax(np.abs(np.diff(theta))) < 1.0


def test_the_energy_and_the_separatrix(ax):
    assert FAST.plot_energy([0.0, 75.0], ax=ax, label="energy") is ax
    line = labelled(ax)["energy"]
    assert np.array_equal(line.get_ydata(), FAST.energy(line.get_xdata()))
    assert set(labelled(ax)["separatrix"].get_ydata()) == {2.0}
    assert "separatrix" not in labelled(DampedPendulum(0.5).plot_energy(ax=Figure().subplots()))


def test_new_axes_without_instants():
    axes = DRIVEN.plot()
    assert axes.get_xlim() == (0.0, pytest.approx(20 * math.pi))
    from matplotlib import pyplot

    pyplot.close(axes.figure)


@pytest.mark.parametrize(
    ("pendulum", "lang", "said"),
    [
        (DECAY, "en", r"$\theta_0$ = 2 rad, $\dot\theta_0$ = 0: γ = 0.02 s⁻¹, μ = 0.05 s⁻²"),
        (DRIVEN, "es", r"$\theta_0$ = 0,5 rad, $\dot\theta_0$ = 0: τ = 0,5 + 0,3 cos(0,6 t − 1) s⁻²"),
        (DampedPendulum(1.0, 2.0), "en", r"$\theta_0$ = 1 rad, $\dot\theta_0$ = 2 rad/s"),
    ],
)
def test_headline(pendulum, lang, said):
    assert damped_headline(pendulum, Language(lang)) == said


@pytest.mark.parametrize(
    ("call", "error", "line"),
    [
        (lambda: DECAY.plot([math.nan]), ValueError, "t = [nan]: at least one finite instant is needed for a picture"),
        (lambda: DECAY.plot(ax=3), ValueError, "ax = 3: must be Axes of matplotlib, or None for a new figure"),
        (lambda: DECAY.plot_phase(lang="xx"), ValueError, "lang = 'xx': must be en, pt-BR or es"),
        (lambda: DECAY.plot_energy(["a"]), TypeError, "t = ['a']: must be real numbers"),
    ],
)
def test_refusals(call, error, line):
    with pytest.raises(error) as refused:
        call()
    assert str(refused.value).startswith(line)
