"""What there is to know of an orbit, through the Python door: passages, action and angle, derivatives, series."""

import math
import pickle

import dask.array
import numpy as np
import pandas
import pytest
import xarray
from bits import same

import libration
from libration import Pendulum

STATES = [(1.0, 0.0), (0.0, 1.0), (-2.0, -0.5), (3.0, 0.2), (0.5, -3.0), (7.0, 4.0), (0.0, 2.0), (0.0, 0.0)]


def test_times_are_where_the_motion_passes():
    pendulum = Pendulum(1.0, length=1.0, gravity=9.8)
    times = pendulum.times(0.5, 0.0, 20.0)
    assert times.dtype == np.float64
    assert len(times) == 2 * math.floor(20.0 / pendulum.period) + 1 + (20.0 % pendulum.period > times[1])
    assert np.allclose(pendulum.theta(times), 0.5, rtol=1e-15)
    assert np.array_equal(pendulum.times(0.5, 5, np.float64(6.0)), times[(times >= 5) & (times <= 6)])
    assert np.array_equal(pendulum.times(1.0, 0, pendulum.period), [0.0, pendulum.period])
    assert len(Pendulum(0.0).times(0.0, 0.0, 1.0)) == 0


def test_turning_times():
    pendulum = Pendulum(2.0, 0.3)
    times = pendulum.turning_times(0.0, 3 * pendulum.period)
    assert len(times) == 6
    assert np.abs(pendulum.velocity(times)).max() < 1e-14
    assert len(Pendulum(0.0, 3.0).turning_times(0.0, 100.0)) == 0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (("x", 0.0, 1.0), "theta = 'x': must be one real number, a Python or NumPy scalar"),
        ((math.inf, 0.0, 1.0), "theta = inf: must be finite"),
        ((0.5, 1.0, 0.0), "stop = 0.0: must be not before start, 1.0"),
        ((0.5, math.nan, 0.0), "start = NaN: must be a number"),
        ((0.5, 0.0, 1e9), f"passages from start to stop = {2e9 / Pendulum(1.0).period:.0f}: must be at most 10000000"),
    ],
)
def test_bad_intervals(call, message):
    with pytest.raises(ValueError) as caught:
        Pendulum(1.0).times(*call)
    assert str(caught.value) == message


def test_extremes():
    assert Pendulum(1.0).extremes == (-1.0, 1.0)
    assert Pendulum(13.0).extremes[1] == 13.0
    assert Pendulum(0.0, 3.0).extremes == (-math.inf, math.inf)
    assert Pendulum(0.0, 2.0).extremes == (-math.pi, math.pi)
    assert Pendulum(0.0).extremes == (0.0, 0.0)
    low, high = Pendulum(3.0, omega2=-1.0).extremes
    assert low == 3.0 and abs(high - (2 * math.pi - 3.0)) < 1e-15


def test_action_and_phase_make_the_orbit():
    for theta0, velocity0 in [(1.0, 0.0), (0.3, -1.2), (-2.0, 0.5), (0.5, -3.0), (7.0, 4.0)]:
        pendulum = Pendulum(theta0, velocity0, length=2.0)
        turning = pendulum.regime == "rotation"
        direction = np.sign(pendulum.frequency) if turning else 0
        again = Pendulum.from_action_phase(pendulum.action, pendulum.phase(0.0), direction=direction, length=2.0)
        shift = again.theta0 - theta0 if turning else math.remainder(again.theta0 - theta0, 2 * math.pi)
        assert abs(shift) < 1e-13 and abs(again.velocity0 - velocity0) < 1e-13
        assert again.omega2 == pendulum.omega2
        assert abs(pendulum.frequency) == pytest.approx(2 * math.pi / pendulum.period, rel=1e-15)


# Angle from pi, velocity and turning angle by mpmath with 40 digits beyond the smallest, for omega2 = -3.
SWINGS_ABOUT_PI = [
    (1e-157, 0.5, 1.6291304043964061452e-79, 5.1651542598252717513e-79, 3.3980884896942449e-79),
    (1e-31, 1.0, 2.8593928678873941735e-16, 3.1800367030274443466e-16, 3.3980884896942452e-16),
    (1e-12, -2.0, -9.7710367395142831942e-7, -7.7453653638141562675e-7, 1.0745699318235742e-6),
    (0.25, 2.5, 0.32531846614886524195, -0.73718025198528796156, 0.54142234484055757),
]


@pytest.mark.parametrize(("action", "phase", "angle", "velocity", "theta_max"), SWINGS_ABOUT_PI)
def test_a_swing_about_pi_is_as_narrow_as_theta0_can_be(action, phase, angle, velocity, theta_max):
    pendulum = Pendulum.from_action_phase(action, phase, omega2=-3.0)
    ulp = math.ulp(math.pi)
    # pi - math.pi = 1.2246467991473532e-16.
    assert abs((pendulum.theta0 - math.pi) - 1.2246467991473532e-16 - angle) <= ulp
    assert abs(pendulum.velocity0 - velocity) <= 4 * math.ulp(theta_max * pendulum.omega0)
    allowed = pendulum.omega0 * (4.4e-16 * theta_max + 2e-31) + 4 * math.ulp(action)
    assert abs(pendulum.action - action) <= allowed


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"action": 3.0}, "action = 3.0: must be below 8 omega0/pi in libration"),
        ({"action": 1.0, "direction": 1}, "action = 1.0: must be above 4 omega0/pi in rotation"),
        ({"action": -1.0}, "action = -1.0: must be finite and not negative"),
        ({"action": 1.0, "direction": 2}, "direction = 2.0: must be 0, 1 or -1"),
        ({"action": 1.0, "omega0": -1.0}, "omega0 = -1.0: must be finite and not negative"),
        ({"action": "a"}, "action = 'a': must be one real number, a Python or NumPy scalar"),
    ],
)
def test_bad_actions(arguments, message):
    with pytest.raises(ValueError) as caught:
        Pendulum.from_action_phase(phase=0.0, **arguments)
    assert str(caught.value) == message


def test_subclasses_are_made_in_kind():
    class Bob(Pendulum):
        pass

    assert type(Bob.from_action_phase(1.0, 0.0)) is Bob
    assert pickle.loads(pickle.dumps(Pendulum(1.0))).action == Pendulum(1.0).action


def test_arrays_are_their_scalars():
    theta, velocity = np.array(STATES).T
    omega0 = np.linspace(0.5, 2.0, len(STATES))
    t = np.linspace(-3.0, 40.0, 5)[:, None]
    pendulums = [Pendulum(a, b, omega0=c) for a, b, c in zip(theta, velocity, omega0, strict=True)]
    # Rows with states of their own: the digits of a call with the state alone, those of an orbit within both promises.
    for function, name in [(libration.action, "action"), (libration.frequency, "frequency")]:
        rows = function(theta, velocity, omega0)
        assert same(rows, np.array([function(*state) for state in zip(theta, velocity, omega0, strict=True)]))
        one = np.array([getattr(p, name) for p in pendulums])
        assert np.all(np.abs(rows - one) <= 8 * np.spacing(np.abs(one)))
    rows = libration.phase(theta, velocity, omega0)
    assert same(rows, np.array([libration.phase(*state) for state in zip(theta, velocity, omega0, strict=True)]))
    one = np.array([p.phase(0.0) for p in pendulums])
    assert np.array_equal(np.isnan(rows), np.isnan(one))
    known = ~np.isnan(one)
    assert np.all(np.abs(rows - one)[known] <= 8 * np.spacing(np.maximum(np.abs(one[known]), np.pi)))
    slopes = libration.sensitivities(t, theta, velocity, omega0)
    assert slopes.shape == (5, len(STATES), 2, 3)
    for i, pendulum in enumerate(pendulums):
        alone = libration.sensitivities(t[:, 0], [theta[i]], [velocity[i]], omega0[i])
        assert same(slopes[:, i], alone)
        state = theta[i], velocity[i], omega0[i]
        assert same(libration.sensitivities(t[:, 0], *state), pendulum.sensitivities(t[:, 0]))
        assert same(libration.sensitivities(float(t[2, 0]), *state), pendulum.sensitivities(float(t[2, 0])))
        kappa = np.sqrt(pendulum.energy_ratio)
        angle = np.pi if np.isnan(pendulum.theta_max) else pendulum.theta_max
        scales = np.array([angle or 1.0, 2 * omega0[i] * kappa or omega0[i], omega0[i]])
        changes, apart = (
            pendulum.sensitivities(t[:, 0]) * scales,
            np.abs(slopes[:, i] - pendulum.sensitivities(t[:, 0])),
        )
        assert np.all(apart * scales <= 2e-12 * np.abs(changes).max(axis=-1, keepdims=True))
    # A bad element is NaN alone.
    assert np.isnan(libration.action([1.0, np.nan, 1.0])).tolist() == [False, True, False]
    assert np.isnan(libration.phase(1.0, 0.0, [1.0, -1.0])).tolist() == [False, True]
    action, phase = libration.action(theta[:3], velocity[:3]), libration.phase(theta[:3], velocity[:3])
    back, speed = libration.from_action_phase(action, phase)
    assert np.allclose(back, theta[:3], atol=1e-13) and np.allclose(speed, velocity[:3], atol=1e-13)
    assert np.isnan(libration.from_action_phase([1.0, 3.0, 1.0], 0.0, direction=[0, 0, 0.5])[0]).tolist() == [
        False,
        True,
        True,
    ]


def test_out_and_where():
    out = np.full(3, 9.0)
    libration.action([1.0, 2.0, 3.0], out=out, where=[True, False, True])
    assert out[1] == 9.0 and out[0] == libration.action(1.0)
    assert np.isnan(libration.frequency([1.0, 2.0], where=[True, False])).tolist() == [False, True]
    phase = np.empty(2)
    assert Pendulum(1.0).phase(np.array([0.0, 1.0]), out=phase) is phase


def test_sensitivities_are_derivatives_of_the_motion():
    t, state = 3.7, np.array([1.2, 0.4, 1.5])
    exact = Pendulum(state[0], state[1], omega0=state[2]).sensitivities(t)

    def motion(point):
        return np.array(Pendulum(point[0], point[1], omega0=point[2]).motion(t))

    for j in range(3):
        step = np.eye(3)[j] * 1e-5
        slope = (
            8 * (motion(state + step) - motion(state - step)) - motion(state + 2 * step) + motion(state - 2 * step)
        ) / 12e-5
        assert np.allclose(exact[:, j], slope, rtol=1e-8, atol=1e-9)


def test_sensitivities_are_the_jacobian_of_advance():
    theta, velocity = np.array([0.1, 2.0, -1.0]), np.array([0.0, 0.5, 4.0])
    slopes = libration.sensitivities(0.8, theta, velocity)
    step = 1e-6
    above, below = libration.advance(theta + step, velocity, 0.8), libration.advance(theta - step, velocity, 0.8)
    for i in range(2):
        assert np.allclose(slopes[:, i, 0], (above[i] - below[i]) / (2 * step), rtol=1e-7)
    assert np.allclose(np.linalg.det(slopes[..., :2]), 1.0, rtol=1e-13)


def test_sensitivities_of_other_arrays():
    pendulum, t = Pendulum(1.0, 0.3), np.linspace(0.0, 4.0, 6)
    expected = pendulum.sensitivities(t)
    lazy = pendulum.sensitivities(dask.array.from_array(t, chunks=4))
    assert lazy.shape == (6, 2, 3) and same(lazy.compute(), expected)
    labelled = pendulum.sensitivities(xarray.DataArray(t, dims="t"))
    assert labelled.dims == ("t", "of", "by") and same(labelled.values, expected)
    assert float(labelled.sel(of="velocity", by="omega0")[3]) == expected[3, 1, 2]


def test_sensitivities_keep_what_their_times_carry():
    pendulum = Pendulum(1.0)
    masked = pendulum.sensitivities(np.ma.array([1.0, 2.0, 3.0], mask=[False, True, False]))
    assert masked.mask[:, 0, 0].tolist() == [False, True, False]
    times = dask.array.from_array(np.arange(5.0), chunks=2)
    assert same(pendulum.sensitivities(times[times > 1]).compute(), pendulum.sensitivities([2.0, 3.0, 4.0]))
    assert pendulum.sensitivities(xarray.Variable("a", [1.0, 2.0])).dims == ("a", "of", "by")
    assert same(pendulum.sensitivities(pandas.Index([1.0, 2.0])), pendulum.sensitivities([1.0, 2.0]))
    with pytest.raises(ValueError) as caught:
        pendulum.sensitivities(xarray.DataArray([1.0], dims="by"))
    assert str(caught.value) == "an argument has the dimension by: must not be one of of, by, the new ones"


def test_second_derivatives():
    t, state = 2.3, np.array([1.2, -0.4, 1.5])
    exact = Pendulum(state[0], state[1], omega0=state[2]).second_sensitivities([t, 5.0])
    assert exact.shape == (2, 2, 3, 3)
    assert np.array_equal(exact, exact.swapaxes(-1, -2))

    def slopes(point):
        return Pendulum(point[0], point[1], omega0=point[2]).sensitivities(t)

    for k in range(3):
        step = np.eye(3)[k] * 1e-5
        slope = (slopes(state + step) - slopes(state - step)) / 2e-5
        assert np.allclose(exact[0, :, :, k], slope, rtol=1e-7, atol=1e-8)
    assert np.isnan(Pendulum(0.0).second_sensitivities(1.0)).all()
    labelled = Pendulum(1.2).second_sensitivities(xarray.DataArray([t], dims="t"))
    assert labelled.dims == ("t", "of", "by", "and_by")


def test_series():
    pendulum = Pendulum(2.5, omega0=2.0)
    series = pendulum.fourier(41)
    assert isinstance(series, libration.Fourier) and len(series.theta) == len(series.velocity) == 41
    t = np.linspace(0.0, 5.0, 50)
    j = np.arange(1, 42)
    phase = pendulum.phase(t)[:, None] * j
    assert np.allclose((np.sin(phase) * series.theta).sum(axis=1), pendulum.theta(t), atol=1e-12)
    assert np.allclose((np.cos(phase) * series.velocity).sum(axis=1), pendulum.velocity(t), atol=1e-11)
    assert Pendulum(2.5).distortion == pytest.approx(pendulum.distortion)
    # Arrays have a kernel of their own, within the same promise.
    assert libration.harmonic_distortion(2.5) == pytest.approx(Pendulum(2.5).distortion, rel=1e-15)
    assert libration.harmonic_distortion([0.0, 1.0]).shape == (2,)
    assert np.isnan(Pendulum(0.0, 2.0).fourier(3).theta).all()
    for n, message in [
        (0, "n = 0: must be from 1 to 10000000"),
        (-5, "n = -5: must be from 1 to 10000000"),
        (1.5, "n = 1.5: must be a whole number"),
        (True, "n = True: must be a whole number"),
        (10**30, "n = an integer beyond 64 bits: must be in range"),
        (np.zeros((3, 3)), "n = an array of shape (3, 3): must be a whole number"),
    ]:
        with pytest.raises(ValueError) as caught:
            pendulum.fourier(n)
        assert str(caught.value) == message


def test_late_harmonics_of_a_fast_swing():
    """Their angles are below every double and their velocities are not; mpmath at 60 digits."""
    series = Pendulum(1.0, omega0=1e300).fourier(10**7)
    for j, truth in ((301, 7.55978009089553526e31), (501, 1.39049250475905518e-147), (601, 5.963461188840489e-237)):
        assert abs(series.velocity[j - 1] / truth - 1) < 1e-15
        assert (series.theta[j - 1] == 0) == (j > 400)
    assert len(series.velocity) == len(series.theta) == 10**7
    assert not series.velocity[720:].any()
    assert not series.theta[720:].any()
