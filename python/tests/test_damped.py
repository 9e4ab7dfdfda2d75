"""The pendulum with friction and torque: the truth, arrays, times, identity, and what is refused."""

import copy
import csv
import itertools
import math
import pickle
import threading
from pathlib import Path

import numpy as np
import pytest
import xarray

import libration
from libration import DampedPendulum, Friction, Pendulum, Torque

VECTORS = Path(__file__).resolve().parents[2] / "reference/vectors"
TERMS = ("linear", "quadratic", "dry", "presliding")
PARTS = ("constant", "amplitude", "frequency", "phase")


def rows(name, count):
    with open(VECTORS / name, newline="") as file:
        found = list(csv.DictReader(file))
    assert len(found) == count
    return found


def given(row):
    """The pendulum of a row."""
    number = {name: float.fromhex(row[name]) for name in ("theta0", "velocity0", "omega2", *TERMS, *PARTS)}
    torque = {name: number.pop(name) for name in PARTS}
    if row["samples"]:
        times = [0.375 * i - 3 for i in range(400)]
        values = [((i * 7) % 11 - 5) / 16 for i in range(400)]
        torque = {"samples": (times, values), "interpolation": row["samples"]}
    friction = Friction(**{name: number.pop(name) for name in TERMS})
    return DampedPendulum(**number, friction=friction, torque=Torque(**torque))


def worst(spoil=lambda theta, velocity: (theta, velocity)):
    """The largest error in ulps of the largest value, eased by 2**-57 of the condition."""
    largest = 0.0
    for row in rows("damped.csv", 350):
        found = spoil(*given(row).motion(float.fromhex(row["t"])))
        for name, value in zip(("theta", "velocity"), found, strict=True):
            unit = math.ulp(float(row[f"scale_{name}"])) + float(row[f"cond_{name}"]) * 2.0**-57
            hi, lo = float.fromhex(row[f"{name}_hi"]), float.fromhex(row[f"{name}_lo"])
            error = abs((value - hi) - lo) / unit
            largest = max(largest, math.inf if math.isnan(error) else error)
    return largest


def test_truth():
    assert worst() <= 2.0


def test_a_spoiled_truth_is_found():
    assert worst(lambda theta, velocity: (theta, -velocity)) > 2.0
    assert worst(lambda theta, velocity: (theta + 2e-15 * velocity, velocity)) > 2.0


def test_true_derivatives():
    by = "theta0 velocity0 omega2 linear quadratic dry presliding constant amplitude frequency phase".split()
    for row in rows("damped_slopes.csv", 88):
        pendulum = given(row)
        found = pendulum.sensitivities(float.fromhex(row["t"]))
        rate = max(1.0, pendulum.omega0)
        powers = np.array([0, 1, 2, 1, 0, 2, 0, 2, 2, 1, 0])
        for i, name in enumerate(("theta", "velocity")):
            truth = np.array([float(row[f"d{name}_d{each}"]) for each in by])
            assert np.array_equal(np.isnan(truth), np.isnan(found[i]))
            change = np.abs(truth) * rate**powers
            error = np.abs(found[i] - truth) * rate**powers
            assert np.nanmax(error) <= 1e-12 * np.nanmax(change), row["id"]


FRICTION = Friction(linear=0.02, quadratic=0.05, dry=0.03)
DRIVEN = DampedPendulum(
    0.5, 0.2, omega2=2.0, friction=FRICTION, torque=Torque(constant=0.2, amplitude=1.5, frequency=0.8)
)


def test_arrays_are_their_scalars():
    t = np.linspace(-1.0, 40.0, 60).reshape(3, 20)
    theta, velocity = DRIVEN.motion(t)
    n, angle = DRIVEN.turns(t)
    assert theta.shape == velocity.shape == n.shape == angle.shape == DRIVEN.energy(t).shape == t.shape
    assert n.dtype == np.int64
    assert DRIVEN.sensitivities(t).shape == (3, 20, 2, 11)
    for i in np.ndindex(t.shape):
        at = float(t[i])
        assert (DRIVEN.theta(at), DRIVEN.velocity(at)) == DRIVEN.motion(at) == (theta[i], velocity[i])
        assert (DRIVEN.energy(at), *DRIVEN.turns(at)) == (DRIVEN.energy(t)[i], n[i], angle[i])
        assert np.array_equal(DRIVEN.sensitivities(at), DRIVEN.sensitivities(t)[i], equal_nan=True)
    assert np.array_equal(DRIVEN.theta(t), theta)
    assert np.array_equal(DRIVEN.theta(t[:, ::-2]), theta[:, ::-2])
    assert type(DRIVEN.theta(1.0)) is np.float64
    assert type(DRIVEN.turns(1)[0]) is np.int64
    assert np.allclose(2 * math.pi * n + angle, theta, rtol=1e-14)
    assert np.allclose(DRIVEN.energy(t), velocity**2 / 2 + 2 * (1 - np.cos(theta)), rtol=1e-12)


def test_what_was_asked_before_changes_nothing():
    late, early = (DampedPendulum(1.0, friction=FRICTION) for _ in range(2))
    whole = late.theta(np.linspace(0.0, 90.0, 500))
    assert [early.theta(t) for t in np.linspace(0.0, 90.0, 500)] == whole.tolist()


def test_labels_stay():
    t = xarray.DataArray([0.0, 1.0], dims="time", coords={"time": [0.0, 1.0]})
    theta = DRIVEN.theta(t)
    assert theta.dims == ("time",)
    assert theta.attrs["units"] == "rad"
    assert DRIVEN.sensitivities(t).dims == ("time", "of", "by")


def test_nothing_takes_or_gives():
    t = np.linspace(-100.0, 100.0, 301)
    for start in ((1.0, 0.0), (3.0, 0.5), (0.0, 3.0)):
        free, exact = DampedPendulum(*start, omega2=2.0), Pendulum(*start, omega2=2.0)
        assert np.array_equal(free.theta(t), exact.theta(t))
        assert np.array_equal(free.velocity(t), exact.velocity(t))
        ours, theirs = free.sensitivities(t), exact.sensitivities(t)
        assert np.allclose(ours[..., :2], theirs[..., :2], rtol=1e-9, atol=1e-9)
        assert np.allclose(ours[..., 2] * 2 * exact.omega0, theirs[..., 2], rtol=1e-9, atol=1e-9)


def test_times():
    pendulum = DampedPendulum(1.0, friction=Friction(dry=0.1))
    for t in pendulum.times(0.5, 0.0, 40.0):
        assert abs(pendulum.theta(t) - 0.5) < 1e-14
    turning = pendulum.turning_times(0.0, 40.0)
    assert turning[0] == 0.0
    # Each half swing takes the same off cos theta - cos a as dry friction's work.
    angles = pendulum.theta(turning)
    for a, b in itertools.pairwise(angles):
        assert abs(math.cos(b) - math.cos(a) - 0.1 * (abs(a) + abs(b))) < 1e-14
    [(begin, end)] = pendulum.rests(0.0, 40.0)
    assert end == 40.0
    assert pendulum.motion(begin + 1) == (pendulum.theta(40.0), 0.0)
    times, decrements = DampedPendulum(1e-4, friction=Friction(linear=0.01)).decrements(0.0, 30.0)
    assert len(times) == len(decrements) > 5
    assert np.allclose(decrements, 0.02 * math.pi / math.sqrt(1 - 1e-4), rtol=1e-7)


def test_torque():
    torque = Torque(constant=0.5, amplitude=2.0, frequency=3.0, phase=0.25)
    t = np.linspace(-5.0, 5.0, 11)
    assert np.allclose(torque.at(t), 0.5 + 2 * np.cos(3 * t + 0.25), rtol=1e-14)
    parabola = Torque(samples=(t, t * t), interpolation="cubics")
    assert abs(parabola.at(2.3) - 2.3**2) < 1e-14
    assert math.isnan(parabola.at(6.0))
    assert parabola == Torque(samples=(t.tolist(), (t * t).tolist()), interpolation="cubics")


def test_identity():
    pendulum = DampedPendulum(1.0, length=2.0, friction=FRICTION, torque=Torque(samples=([-1.0, 9.0], [0.0, 1.0])))
    duplicates = [copy.copy(pendulum), copy.deepcopy(pendulum), pickle.loads(pickle.dumps(pendulum))]
    names = {"DampedPendulum": DampedPendulum, "Friction": Friction, "Torque": Torque}
    for twin in [*duplicates, eval(repr(pendulum), names)]:
        assert (twin, hash(twin), twin.theta(5.0)) == (pendulum, hash(pendulum), pendulum.theta(5.0))
    assert pendulum.omega2 == 9.80665 / 2
    assert abs(pendulum.omega0 - math.sqrt(9.80665 / 2)) < 1e-15
    assert (pendulum.theta0, pendulum.velocity0, pendulum.friction) == (1.0, 0.0, FRICTION)
    assert pendulum != DampedPendulum(1.0, length=2.0, friction=FRICTION)
    with pytest.raises(AttributeError):
        pendulum.theta0 = 2.0


def test_what_is_not_reached_is_nan():
    samples = Torque(samples=([-1.0, 9.0], [0.0, 1.0]))
    assert np.isnan(DampedPendulum(1.0, torque=samples).theta([-1.5, 5.0, 9.5, math.nan, math.inf])).tolist() == [
        True, False, True, True, True,
    ]  # fmt: skip
    soft = DampedPendulum(1.0, friction=Friction(dry=0.1, presliding=0.01))
    assert np.isnan(soft.velocity([-0.1, 0.0, 0.1])).tolist() == [True, False, False]
    driven = DampedPendulum(0.0, 3.0, omega0=0.0, friction=Friction(quadratic=-0.5))
    assert np.isnan(driven.velocity([0.6, 0.7])).tolist() == [False, True]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Friction(linear=math.nan), "linear = NaN: must be finite"),
        (lambda: Friction(dry=-1), "dry = -1.0: must be finite and not negative"),
        (lambda: Friction(dry="1"), "dry = '1': must be one real number, a Python or NumPy scalar"),
        (lambda: Friction(dry=1, presliding=1e-30), "presliding = 1e-30: must be 0, or finite and at least 1e-10"),
        (lambda: Torque(amplitude=math.inf), "amplitude = inf: must be finite"),
        (lambda: Torque(samples=3), "samples = 3: must be a pair of times and values"),
        (lambda: Torque(samples=([0, 1], ["a", "b"])), "values of samples = ['a', 'b']: must be real numbers"),
        (lambda: Torque(samples=([0, 1], [[1], [2]])), "values of samples = [[1], [2]]: must have one dimension"),
        (lambda: Torque(samples=([0, 1], [1])), "number of torque values = 1: must be as many as the times, 2"),
        (lambda: Torque(samples=([1, 0], [1, 1])), "torque time = 0.0: must be later than the one before it"),
        (
            lambda: Torque(samples=([0, 1], [1, 1]), interpolation="spline"),
            "interpolation = spline: must be one of steps, lines, cubics",
        ),
        (lambda: DampedPendulum(math.inf), "theta0 = inf: must be finite"),
        (lambda: DampedPendulum(1.0, friction=0.1), "friction = 0.1: must be a Friction"),
        (lambda: DampedPendulum(1.0, torque=0.1), "torque = 0.1: must be a Torque"),
        (lambda: DampedPendulum(1.0, omega0=1, length=1), "frequency = omega0 = 1.0, length = 1.0"),
        (lambda: DampedPendulum(1.0, torque=Torque(samples=([1, 2], [0, 0]))), "first torque time = 1.0"),
        (lambda: DRIVEN.times(math.nan, 0, 1), "theta = NaN: must be finite"),
        (lambda: DRIVEN.turning_times(2, 1), "stop = 1.0: must be not before start, 2.0"),
        (lambda: DRIVEN.rests(0, math.inf), "stop = inf: must be finite"),
        (
            lambda: DampedPendulum(0, 3, omega0=0, friction=Friction(quadratic=-0.5)).turning_times(0, 1),
            "where the motion grows without bound",
        ),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError) as refused:
        call()
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


def test_threads_share_a_pendulum():
    pendulum = DampedPendulum(2.0, friction=FRICTION)
    truth = DampedPendulum(2.0, friction=FRICTION).theta(np.linspace(0, 200, 2001))
    found = [None] * 8

    def ask(i):
        found[i] = pendulum.theta(np.linspace(0, 25.0 * (i + 1), 250 * (i + 1) + 1))

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for part in found:
        assert np.array_equal(part, truth[: len(part)])


def test_the_package_holds_it():
    assert libration.damped.DampedPendulum is DampedPendulum
