"""Tracking: the exact motion step by step, kicks of the right order, wrapped angles with their turns, and what is refused."""

import math

import numpy as np
import pytest

import libration
from libration.ensemble import bunch, track
from libration.ensemble._schemes import DRIFTS, KICKS, TIMES

THETA, VELOCITY = bunch(3000, distribution="thermal", temperature=2.0, rotations=True, seed=1)
KICKED = {"kick": lambda theta, step: 1e-2 * np.cos(3 * theta)}


def gap(first, second):
    """The largest distance of wrapped angles."""
    apart = np.asarray(first) - np.asarray(second)
    return np.abs(apart - math.tau * np.round(apart / math.tau)).max()


def same(first, second):
    return all(a.tobytes() == b.tobytes() and a.dtype == b.dtype for a, b in zip(first, second, strict=True))


def test_many_steps_are_the_motion():
    theta, velocity, turns = track(THETA, VELOCITY, 0.3, 2.0, steps=200)
    true, speed = libration.motion(60.0, THETA, VELOCITY, 2.0)
    # An error of a step grows as the motion does, without bound next to the separatrix.
    near = np.abs(libration.energy_ratio_c(THETA, VELOCITY, 2.0)) < 1e-3
    assert np.abs(theta + math.tau * turns - true)[~near].max() < 1e-10
    assert np.abs(velocity - speed)[~near].max() < 1e-10
    assert (-math.pi <= theta).all() and (theta <= math.pi).all() and turns.dtype == np.int64
    assert np.abs(turns).max() > 5
    assert np.abs(theta - true).max() > 1.0, "an angle that is not wrapped must show"


def test_actions_are_kept():
    theta, velocity = bunch(2000, distribution="gaussian", sigma_theta=0.8, seed=2, omega0=0.03)
    before = libration.action(theta, velocity, 0.03)
    after = track(theta, velocity, 1.0, 0.03, steps=3000)
    assert np.abs(libration.action(*after[:2], 0.03) / before - 1).max() < 1e-12
    assert (
        np.abs(
            libration.action(*track(theta, velocity, 1.0, 0.03, steps=300, kick=lambda *_: 1e-6)[:2], 0.03) / before - 1
        ).max()
        > 1e-6
    )


@pytest.mark.parametrize("scheme", ["exact", "order8"])
@pytest.mark.parametrize("kick", [{}, KICKED])
def test_any_way_to_take_the_steps_is_the_same_bit_for_bit(scheme, kick):
    options = {"scheme": scheme, **kick}
    whole = track(THETA, VELOCITY, 0.3, steps=20, **options)
    middle = track(THETA, VELOCITY, 0.3, steps=8, **options)
    theta, velocity, turns = track(middle[0], middle[1], 0.3, steps=12, **options)
    assert same(whole, (theta, velocity, turns + middle[2]))
    recorded = track(THETA, VELOCITY, 0.3, steps=20, record=4, **options)
    assert [each.shape for each in recorded] == [(6, 3000)] * 3
    assert same([each[-1] for each in recorded], whole) and same([each[2] for each in recorded], middle)
    chosen = track(THETA, VELOCITY, 0.3, steps=20, record=[8, 20], **options)
    assert same([each[0] for each in chosen], middle) and same([each[1] for each in chosen], whole)
    some = track(THETA[5:9], VELOCITY[5:9], 0.3, steps=20, **options)
    assert same(some, [each[5:9] for each in whole])
    one = track(float(THETA[5]), float(VELOCITY[5]), 0.3, steps=20, **options)
    assert all(np.shape(each) == () and each == column[5] for each, column in zip(one, whole, strict=True))
    square = track(THETA.reshape(50, 60), VELOCITY.reshape(50, 60), 0.3, steps=20, **options)
    assert same([each.ravel() for each in square], whole)
    by_step = track(THETA, VELOCITY, np.full(20, 0.3), np.ones(20), phase=np.zeros(20), steps=20, **options)
    assert same(by_step, whole)
    own = THETA.copy(), VELOCITY.copy(), np.empty(3000, dtype=np.int64)
    assert all(a is b for a, b in zip(track(*own[:2], 0.3, steps=20, out=own, **options), own, strict=True))
    assert same(own, whole)
    apart = tuple(np.empty((3000, 2), dtype=each.dtype)[:, 0] for each in whole)
    track(THETA, VELOCITY, 0.3, steps=20, out=apart, **options)
    assert same([each.copy() for each in apart], whole)


def test_blocks_are_the_whole():
    from libration.ensemble import _track

    many = _track.BLOCK + 5
    theta, velocity = bunch(many, distribution="gaussian", sigma_theta=0.8, seed=1)
    whole = track(theta, velocity, 0.3, steps=2, record=1)
    last = track(theta[-9:], velocity[-9:], 0.3, steps=2, record=1)
    assert same([each[:, -9:].copy() for each in whole], last)


def test_a_composition_of_order_eight():
    assert len(DRIFTS) == 15 and len(KICKS) == 16
    assert abs(math.fsum(DRIFTS) - 1) < 1e-15 and abs(math.fsum(KICKS) - 1) < 1e-15 and abs(TIMES[-1] - 1) < 1e-15
    # The condition of order 3 and 5 of a symmetric composition.
    assert abs(math.fsum(each**3 for each in DRIFTS)) < 1e-14 and abs(math.fsum(each**5 for each in DRIFTS)) < 1e-14
    theta0, velocity0 = [0.3, 1.0, 2.0], [0.5, 0.2, -0.4]
    true = libration.motion(6.0, theta0, velocity0)[0]
    errors = [gap(track(theta0, velocity0, 6.0 / n, steps=n, scheme="order8")[0], true) for n in (10, 20)]
    assert 2**7.5 < errors[0] / errors[1] < 2**9.5
    assert errors[1] < 1e-8


def wave(theta, step):
    """A kick that depends on time too: a second harmonic that grows, for steps of 0.1."""
    return -0.1 * 0.2 * (1 + 0.05 * step) * np.sin(2 * theta)


def test_kicks_are_of_second_order_and_of_eighth():
    def end(steps, scheme):
        scale = 60 / steps
        return track(
            [0.3, 1.0, 2.0],
            [0.5, 0.2, -0.4],
            0.1 * scale,
            steps=steps,
            scheme=scheme,
            kick=lambda theta, step: scale * wave(theta, step * scale),
        )[0]

    true = end(240, "order8")
    errors = [gap(end(steps, "exact"), true) for steps in (60, 120)]
    assert 3.5 < errors[0] / errors[1] < 4.5 and errors[0] < 1e-2
    assert gap(end(120, "order8"), true) < 1e-12
    errors = [gap(end(steps, "order8"), true) for steps in (15, 30)]
    assert errors[0] / errors[1] > 2**7.5


def test_a_torque_is_that_of_a_damped_pendulum():
    steps, dt = 200, 0.1
    true = libration.DampedPendulum(0.5, torque=libration.Torque(constant=0.3)).theta(steps * dt)
    theta, _, turns = track(0.5, 0.0, dt, steps=steps, scheme="order8", kick=lambda theta, step: 0.3 * dt)
    assert abs(theta + math.tau * turns - true) < 1e-10


def test_a_moved_bottom_and_frequencies_of_their_own():
    theta, velocity, _ = track(1.0, 0.5, 0.7, 1.5, phase=0.25, steps=1)
    true = libration.motion(0.7, 0.75, 0.5, 1.5)
    assert abs(theta - 0.25 - true[0]) < 1e-15 and abs(velocity - true[1]) < 1e-15
    ramp = np.linspace(1.0, 2.0, 50)
    theta, velocity = 1.0, 0.5
    for omega0 in ramp:
        theta, velocity = libration.advance(theta, velocity, 0.1, omega0)
    found = track(1.0, 0.5, 0.1, ramp, steps=50)
    assert (found[0], found[1]) == (theta, velocity)
    assert gap(track(1.0, 0.5, 0.1, ramp, steps=50, scheme="order8")[0], theta) < 1e-10
    free = track(1.0, 2.0, 0.1, 0.0, steps=100, scheme="order8")
    assert abs(free[0] + math.tau * free[2] - 21.0) < 1e-12


def test_kicks_see_all_particles_wrapped_and_in_their_shape():
    seen = []

    def kick(theta, step):
        seen.append((theta.shape, float(np.abs(theta).max()), step))
        with pytest.raises(ValueError, match="read-only"):
            theta[...] = 0.0
        return 0.01 * theta.mean()

    track(THETA.reshape(50, 60), VELOCITY.reshape(50, 60), 0.3, steps=3, kick=kick)
    assert [step for *_, step in seen] == [0, 1, 2, 3]
    assert all(shape == (50, 60) and largest <= math.pi for shape, largest, _ in seen)


def test_turns_at_the_ends_of_the_range():
    edges = [math.nextafter(sign * n * math.pi, to) for sign in (-1, 1) for n in (1, 2, 3, 5) for to in (-99, 0, 99)]
    many = np.random.default_rng(1).uniform(-1e6, 1e6, 10_000)
    given = np.concatenate([edges, [-math.pi, math.pi, 3 * math.pi, 7.0, -0.0], many])
    theta, _, turns = track(given, 0.0, 1.0, steps=0)
    assert (np.abs(theta) <= math.pi).all()
    whole, angle = libration.turns(0.0, given, 0.0)
    # A rounding from an end both countings are right.
    far = np.abs(np.abs(angle) - math.pi) > 1e-14
    assert np.array_equal(turns[far], whole[far]) and np.abs(theta - angle)[far].max() < 1e-9
    assert np.abs(theta + math.tau * turns - given).max() < 1e-9
    assert turns[edges.index(math.nextafter(-math.pi, -99))] == -1
    inside = np.abs(given) <= math.pi
    assert np.array_equal(theta[inside], given[inside])


@pytest.mark.parametrize("scheme", ["exact", "order8"])
def test_bad_elements_are_nan_there_and_nowhere_else(scheme):
    states = [1.0, math.nan, math.inf, 1e300, 2.0], [1.0, 1.0, 1.0, 1.0, math.inf]
    theta, velocity, turns = track(*states, 0.1, steps=3, scheme=scheme, record=1)
    assert np.isnan(theta[:, 1:]).all() and np.isnan(velocity[:, 1:]).all() and not turns.any()
    alone = track(1.0, 1.0, 0.1, steps=3, scheme=scheme)
    assert (theta[-1, 0], velocity[-1, 0]) == alone[:2]
    lost = track([1.0, 2.0], 0.0, 0.1, steps=9, scheme=scheme, kick=lambda theta, step: np.array([0.0, 1e308]))
    assert np.isfinite(lost[0][0]) and np.isnan(lost[0][1]) and lost[2][1] == 0


def test_masked_and_empty():
    theta = np.ma.array([1.0, 2.0], mask=[False, True])
    assert np.isnan(track(theta, 0.0, 0.1, steps=1)[0]).tolist() == [False, True]
    assert [each.shape for each in track([], [], 0.1, steps=4, record=2)] == [(3, 0)] * 3


READ_ONLY = np.zeros(1)
READ_ONLY.flags.writeable = False
WHOLE = np.zeros(1, dtype=np.int64)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"steps": -1}, "steps = -1: must not be negative"),
        ({"steps": 2.5}, "steps = 2.5: must be a whole number"),
        ({"dt": [0.1, 0.2]}, "dt of shape (2,): must be one number, or one for each of 3 steps"),
        ({"dt": math.nan}, "dt = nan: must be finite"),
        ({"omega0": -1.0}, "omega0 = -1.0: must not be negative"),
        ({"phase": [[0.0]]}, "phase of shape (1, 1): must be one number"),
        ({"phase": "a"}, "phase = 'a': must be real numbers"),
        ({"theta": "a"}, "theta = 'a': must be real numbers"),
        ({"theta": [1.0, 2.0], "velocity": [1.0, 2.0, 3.0]}, "shapes of theta (2,), velocity (3,): must be equal"),
        ({"kick": 1.0}, "kick = 1.0: must be a function of the angles and the step"),
        ({"kick": lambda theta, step: "a"}, "kick(theta, 0) = 'a': must be real numbers"),
        ({"kick": lambda theta, step: np.zeros(4)}, "kick(theta, 0) of shape (4,): must have the shape of theta, (1,)"),
        ({"scheme": "rk4"}, "scheme = 'rk4': must be exact or order8"),
        ({"record": 0}, "record = 0: must be positive, or numbers of steps"),
        ({"record": [2, 1]}, "record = [2, 1]: must grow, from 0 or later to 3, the last step, or earlier"),
        ({"record": [4]}, "record = [4]: must grow"),
        ({"record": "a"}, "record = 'a': must be a whole number"),
        (
            {"steps": 10**17, "record": 1},
            "states of shape (100000000000000001, 1): must fit into memory, 24 bytes each",
        ),
        ({"out": (1, 2, 3)}, "out must be a tuple of three arrays: theta, velocity, turns"),
        ({"out": (np.zeros(1),) * 3}, "out has an array of float64: must be float64, float64 and int64"),
        (
            {"out": (np.zeros(2), np.zeros(2), WHOLE)},
            "out has an array of shape (2,): must have the shape of the result",
        ),
        ({"out": (READ_ONLY, np.zeros(1), WHOLE)}, "out has an array that is read-only: must be writable"),
    ],
)
def test_bad_input_is_one_line(arguments, said):
    given = {"theta": [1.0], "velocity": [0.0], "dt": 0.1, "steps": 3} | arguments
    with pytest.raises((ValueError, TypeError)) as caught:
        track(**given)
    assert str(caught.value).startswith(said) and "\n" not in str(caught.value)


def test_an_error_of_a_kick_is_its_own():
    with pytest.raises(TypeError, match="can only concatenate"):
        track([1.0], [0.0], 0.1, steps=3, kick=lambda theta, step: "a" + 1)
