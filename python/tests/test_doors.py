"""Same digits whatever the shape: scalar, array, order, stride, length, thread and set-up change no bit."""

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pandas
import pytest
from bits import ORBITS, all_same, same

import libration
from libration import Pendulum

METHODS = ["theta", "velocity", "motion", "turns"]
LENGTHS = [1, 100, 5000]

orbits = pytest.mark.parametrize("orbit", ORBITS.values(), ids=ORBITS)
methods = pytest.mark.parametrize("method", METHODS)


def pendulum_of(orbit):
    theta0, velocity0, omega0 = orbit
    return Pendulum(theta0, velocity0, omega0=omega0)


def times(count, seed=7):
    """Times of every size, zero and both signs among them."""
    random = np.random.default_rng(seed)
    spread = random.normal(size=count) * 10.0 ** random.integers(-8, 9, size=count)
    spread[: count // 10] = 0.0
    return spread


def states(count, seed=8):
    """States of every regime."""
    random = np.random.default_rng(seed)
    return random.uniform(-9, 9, count), random.normal(0, 2, count), random.uniform(0, 2, count)


def each(function, *columns):
    """The loop over the elements, every argument as an array of length 1, put together again."""
    rows = [function(*(column[i : i + 1] for column in columns)) for i in range(len(columns[0]))]
    if isinstance(rows[0], tuple):
        return tuple(np.concatenate(part) for part in zip(*rows, strict=True))
    return np.concatenate(rows)


def test_same_sees_one_bit():
    assert not same(np.array([1.0, 2.0]), np.array([1.0, math.nextafter(2.0, 3.0)]))
    assert not same(0.0, -0.0)
    assert not same(np.array([1.0]), np.array([[1.0]]))
    assert not same(1.0, math.nan)
    assert not same(np.array([1]), np.array([1.0]))
    assert not all_same((1.0, 2.0), (1.0, 3.0))
    assert same(math.nan, -math.nan)


@orbits
@methods
def test_scalar_calls_are_the_array(orbit, method):
    call = getattr(pendulum_of(orbit), method)
    t = times(300)
    rows = [call(float(value)) for value in t]
    expected = tuple(map(np.array, zip(*rows, strict=True))) if isinstance(rows[0], tuple) else np.array(rows)
    assert all_same(call(t), expected)
    assert all_same(
        call(np.float64(t[-1])), call(t[-1:])[0] if method in METHODS[:2] else tuple(part[0] for part in call(t[-1:]))
    )


@orbits
def test_motion_is_theta_and_velocity(orbit):
    pendulum, t = pendulum_of(orbit), times(300)
    assert all_same(pendulum.motion(t), (pendulum.theta(t), pendulum.velocity(t)))
    assert all_same(libration.motion(t, *orbit), pendulum.motion(t))
    columns = [np.full(300, value) for value in orbit]
    pair = libration.theta(t, *columns), libration.velocity(t, *columns)
    assert all_same(libration.motion(t, *columns), pair)


@orbits
def test_functions_of_scalar_orbits_take_the_path_of_the_class(orbit):
    t = times(300)
    assert same(libration.theta(t, *orbit), pendulum_of(orbit).theta(t))
    zero_dimensions = [np.array(value) for value in orbit]
    assert same(libration.theta(t, *zero_dimensions), pendulum_of(orbit).theta(t))
    assert same(libration.velocity(t[0], *orbit), pendulum_of(orbit).velocity(float(t[0])))


@methods
@pytest.mark.parametrize("length", LENGTHS)
def test_length_order_and_stride_of_one_orbit(method, length):
    call = getattr(Pendulum(3.0, 0.1, omega0=1.3), method)
    t = times(length)
    expected = call(t)

    def parts(result):
        return result if isinstance(result, tuple) else (result,)

    spread = np.zeros(3 * length)
    spread[::3] = t
    assert all_same(call(spread[::3]), expected)
    for part, whole in zip(parts(call(t[::-1])), parts(expected), strict=True):
        assert same(part, whole[::-1])
    square = np.stack([t, t[::-1]])
    for order in "CF":
        for part, whole in zip(parts(call(np.array(square, order=order))), parts(expected), strict=True):
            assert same(part, np.stack([whole, whole[::-1]]))
    assert all_same(tuple(p[:1] for p in parts(call(t[:1]))), tuple(p[:1] for p in parts(expected)))
    assert all_same(call(np.array(t, dtype=">f8")), expected)
    unaligned = np.frombuffer(b"\0" + t.tobytes(), dtype=np.uint8)[1:].view(np.float64)
    assert not unaligned.flags.aligned
    assert all_same(call(unaligned), expected)


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("function", [libration.theta, libration.velocity, libration.motion, libration.advance])
def test_rows_with_states_of_their_own(function, length):
    columns = times(length), *states(length)
    if function is libration.advance:
        columns = columns[1], columns[2], columns[0], columns[3]
    expected = each(function, *columns)
    assert all_same(function(*columns), expected)
    backwards = function(*(column[::-1] for column in columns))
    forwards = backwards[::-1] if isinstance(backwards, np.ndarray) else tuple(p[::-1] for p in backwards)
    assert all_same(forwards, expected)


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("order", "CF")
def test_theta_of_a_table_is_the_loop_over_its_elements(length, order):
    t, th0 = times(7), states(length)[0]
    table = libration.theta(t[:, None], th0)
    loop = np.stack([each(libration.theta, np.full(length, instant), th0) for instant in t])
    assert same(table, loop)
    full_t, full_th0 = (np.array(side, order=order) for side in np.broadcast_arrays(t[:, None], th0))
    assert same(libration.theta(full_t, full_th0), table)
    assert same(libration.theta(t, th0[:, None]), table.T)
    out = np.empty((7, length), order=order)
    assert libration.theta(t[:, None], th0, out=out) is out
    assert same(out, table)


@orbits
def test_a_kept_set_up_changes_nothing(orbit):
    t, other = times(50), (0.3, 0.2, 0.9)
    alone = libration.theta(t, *(np.full(50, value) for value in orbit))
    mixed = [np.repeat([a, b], [50, 50]) for a, b in zip(orbit, other, strict=True)]
    shuffle = np.random.default_rng(3).permutation(100)
    result = libration.theta(np.tile(t, 2)[shuffle], *(column[shuffle] for column in mixed))
    back = np.empty(100)
    back[shuffle] = result
    assert same(back[:50], alone)


def test_threads_share_nothing_that_matters():
    t = times(20000)

    def work(orbit):
        return [pendulum_of(orbit).theta(t) for _ in range(5)]

    expected = [pendulum_of(orbit).theta(t) for orbit in ORBITS.values()]
    with ThreadPoolExecutor(8) as pool:
        for results, one in zip(pool.map(work, ORBITS.values()), expected, strict=True):
            assert all(same(result, one) for result in results)


@pytest.mark.parametrize("keyword", ["m", "mc", "k"])
def test_elliptic_functions(keyword):
    u, given = times(200) % 50.0, np.random.default_rng(5).uniform(0.0, 1.0, 200)
    jacobi = libration.jacobi(u, **{keyword: given})
    assert all_same(tuple(jacobi), tuple(each(lambda *c: tuple(libration.jacobi(c[0], **{keyword: c[1]})), u, given)))
    for name in ("incomplete_f", "incomplete_e"):
        function = getattr(libration, name)
        assert same(function(u, **{keyword: given}), each(lambda *c, f=function: f(c[0], **{keyword: c[1]}), u, given))
    for name in ("complete_k", "complete_e", "nome"):
        function = getattr(libration, name)
        expected = each(lambda c, f=function: f(**{keyword: c}), given)
        assert same(function(**{keyword: given}), expected)
        assert same(function(**{keyword: np.repeat(given, 3)}), np.repeat(expected, 3))
        assert same(function(**{keyword: float(given[0])}), np.float64(expected[0]))
    table = libration.jacobi(u[:, None], **{keyword: given[:5]})
    assert table.sn.shape == (200, 5)
    assert same(table.am[:, 3], libration.jacobi(u, **{keyword: np.full(200, given[3])}).am)
    # One parameter for all has a path of its own: decision 5.
    assert np.allclose(table.am[:, 3], libration.jacobi(u, **{keyword: given[3]}).am, rtol=1e-15, atol=0)


def test_out():
    pendulum, t = Pendulum(3.0), times(100)
    for method in ("theta", "velocity"):
        out = np.full(200, 7.0)
        assert getattr(pendulum, method)(t, out=out[::2]).base is out
        assert same(out[::2], getattr(pendulum, method)(t))
        assert np.all(out[1::2] == 7.0)
    pair = np.empty(100), np.empty(100)
    results = libration.motion(t, 3.0, out=pair)
    assert results[0] is pair[0]
    assert results[1] is pair[1]
    assert all_same(pair, pendulum.motion(t))
    four = tuple(np.empty(100) for _ in range(4))
    assert libration.jacobi(t, m=0.5, out=four).am is four[3]
    assert all_same(four, tuple(libration.jacobi(t, m=0.5)))
    single = np.empty(100)
    libration.complete_k(m=np.linspace(0, 1, 100), out=single)
    assert same(single, libration.complete_k(m=np.linspace(0, 1, 100)))
    zero_dimensions = np.empty(())
    pendulum.theta(2.0, out=zero_dimensions)
    assert zero_dimensions[()] == pendulum.theta(2.0)


def test_an_output_may_be_an_input():
    t = times(500)
    expected = Pendulum(3.0).theta(t)
    in_place = t.copy()
    Pendulum(3.0).theta(in_place, out=in_place)
    assert same(in_place, expected)
    shifted = np.concatenate([t, [0.0]])
    Pendulum(3.0).theta(shifted[:-1], out=shifted[1:])
    assert same(shifted[1:], expected)
    backwards = t.copy()
    Pendulum(3.0).theta(backwards, out=backwards[::-1])
    assert same(backwards[::-1], expected)


@pytest.mark.parametrize("crossed", [False, True])
def test_advance_in_place(crossed):
    theta, velocity, omega0 = states(500)
    expected = libration.advance(theta, velocity, 0.7, omega0)
    a, b = theta.copy(), velocity.copy()
    out = (b, a) if crossed else (a, b)
    libration.advance(a, b, 0.7, omega0, out=out)
    assert all_same(out, expected)


def test_where_without_out_is_nan_elsewhere():
    t, chosen = times(60).reshape(3, 20), np.arange(20) % 3 == 0
    for function in (libration.theta, libration.velocity):
        result = function(t, 1.0, where=chosen)
        assert same(result, np.where(chosen, function(t, 1.0), math.nan))
    for part, whole in zip(libration.motion(t, 1.0, where=chosen), libration.motion(t, 1.0), strict=True):
        assert same(part, np.where(chosen, whole, math.nan))
    for part, whole in zip(libration.jacobi(t, m=0.3, where=chosen), libration.jacobi(t, m=0.3), strict=True):
        assert same(part, np.where(chosen, whole, math.nan))
    assert np.isnan(libration.theta(1.0, 1.0, where=False))
    assert type(libration.theta(1.0, 1.0, where=np.True_)) is np.float64
    assert libration.theta(1.0, 1.0, where=chosen).shape == (20,)


@pytest.mark.parametrize("wrap", [np.ma.MaskedArray, pandas.Series], ids=["masked array", "pandas"])
def test_where_keeps_the_type_that_the_ufunc_gives(wrap):
    t, chosen = np.append(times(19), -0.0), np.arange(20) % 3 == 0
    calls = [
        lambda argument, **keywords: (libration.theta(argument, 3.0, **keywords),),
        lambda argument, **keywords: (libration.theta(1.0, argument, **keywords),),
        lambda argument, **keywords: libration.motion(argument, 3.0, 0.1, **keywords),
        lambda argument, **keywords: libration.jacobi(argument, m=0.5, **keywords),
        lambda argument, **keywords: (libration.nome(m=argument, **keywords),),
    ]
    for call in calls:
        for part, whole in zip(call(wrap(t), where=chosen), call(wrap(t)), strict=True):
            assert type(part) is type(whole) is wrap
            assert same(np.asarray(part), np.where(chosen, np.asarray(whole), math.nan))


def test_where_keeps_mask_and_index():
    chosen = np.array([True, True, False])
    masked = libration.theta(np.ma.MaskedArray([0.0, 1.0, 2.0], [True, False, False]), 3.0, where=chosen)
    assert masked.mask.tolist() == [True, False, False]
    assert list(libration.theta(pandas.Series([0.0, 1.0, 2.0], list("abc")), 3.0, where=chosen).index) == list("abc")


@orbits
def test_where_is_nan_on_every_orbit(orbit):
    for part in (*libration.motion(times(20), *orbit, where=False), *libration.advance(*orbit, where=[False])):
        assert np.isnan(part).all()


def test_where_with_out_keeps_the_rest():
    t, chosen = times(20), np.arange(20) % 3 == 0
    out = np.arange(20.0)
    libration.theta(t, 1.0, out=out, where=chosen)
    assert same(out, np.where(chosen, libration.theta(t, 1.0), np.arange(20.0)))
    theta, velocity = np.full(20, 1.0), np.full(20, 0.5)
    libration.advance(theta, velocity, 1.0, out=(theta, velocity), where=chosen)
    after = libration.advance(1.0, 0.5, 1.0)
    assert all_same((theta, velocity), (np.where(chosen, after[0], 1.0), np.where(chosen, after[1], 0.5)))


def test_casting():
    pendulum = Pendulum(3.0)
    whole = np.arange(5)
    for kind in (np.int8, np.uint16, np.int64, np.float16, np.float32, bool):
        assert same(pendulum.theta(whole.astype(kind)), pendulum.theta(whole.astype(kind).astype(float)))
    assert same(pendulum.theta([0, 1, 2]), pendulum.theta(np.array([0.0, 1.0, 2.0])))
    assert same(libration.theta([0, 1], [1, 2]), libration.theta(np.array([0.0, 1.0]), np.array([1.0, 2.0])))
    narrow = np.empty(5, np.float32)
    pendulum.theta(whole, out=narrow)
    assert same(narrow, pendulum.theta(whole).astype(np.float32))
    with pytest.raises(TypeError):
        pendulum.theta(whole, out=np.empty(5, np.int64))


def test_empty():
    empty = np.empty((3, 0))
    assert Pendulum(3.0).theta(empty).shape == (3, 0)
    assert [part.shape for part in Pendulum(3.0).turns(empty)] == [(3, 0), (3, 0)]
    assert [part.shape for part in libration.advance(empty, empty, 1.0)] == [(3, 0), (3, 0)]
    assert libration.theta([], 1.0, where=[]).shape == (0,)
    assert libration.jacobi([], m=0.5).sn.shape == (0,)
