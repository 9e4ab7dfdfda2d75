"""Over all bit patterns of a double: only constructors raise, only ValueError; NaN only where it is documented."""

import math
import pickle
import struct

import numpy as np
import pytest
from bits import all_same, same
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import libration
from libration import Pendulum

pytestmark = pytest.mark.filterwarnings("error", "ignore:theta0 = .* is in radians:UserWarning")

settings.register_profile("doors", deadline=None, max_examples=500, derandomize=True, database=None)
settings.load_profile("doors")

LIMIT = 2.0**53


def double(bits):
    return struct.unpack("<d", struct.pack("<Q", bits))[0]


patterns = st.integers(0, 2**64 - 1).map(double)
doubles = st.one_of(patterns, st.floats(), st.floats(-10.0, 10.0))
rows = st.lists(st.tuples(doubles, doubles, doubles, doubles), min_size=1, max_size=8)
frequencies = st.dictionaries(st.sampled_from(["omega0", "omega2", "length", "gravity"]), doubles, max_size=3)


def built(theta0, velocity0, frequency):
    """The pendulum, or None where the constructor refuses in one line that names an argument."""
    try:
        return Pendulum(theta0, velocity0, **frequency)
    except ValueError as refusal:
        message = str(refusal)
        assert "\n" not in message
        assert any(name in message for name in ("theta0", "velocity0", *frequency))
        return None


@given(doubles, doubles, frequencies)
def test_constructor_refuses_exactly_what_is_outside(theta0, velocity0, frequency):
    pendulum = built(theta0, velocity0, frequency)
    finite = all(map(math.isfinite, (theta0, velocity0, *frequency.values())))
    alone = len({"omega0", "omega2", "length"} & set(frequency)) <= 1
    inside = frequency.get("omega0", 0.0) >= 0 and frequency.get("length", 1.0) > 0
    attached = "gravity" not in frequency or "length" in frequency
    assert (pendulum is not None) == (finite and alone and inside and attached)


@given(doubles, doubles, frequencies, doubles)
@example(3.0, 0.0, {"omega0": 5e-324}, 1e300)
@example(1e308, 1e308, {"length": 5e-324, "gravity": 1e308}, 1.0)
@example(0.0, 5e-324, {}, 0.0)
def test_attributes_and_methods(theta0, velocity0, frequency, t):
    pendulum = built(theta0, velocity0, frequency)
    assume(pendulum is not None)
    assert pendulum.regime in ("rest", "libration", "separatrix", "rotation")
    assert pendulum.period > 0
    assert pendulum.energy >= 0
    assert pendulum.energy_ratio >= 0
    assert math.isnan(pendulum.theta_max) == (pendulum.regime == "rotation")
    assert not math.isnan(pendulum.energy_ratio_c)
    assert eval(repr(pendulum), {"Pendulum": Pendulum}) == pendulum
    assert pickle.loads(pickle.dumps(pendulum)) == pendulum

    theta, velocity = pendulum.motion(t)
    n, angle = pendulum.turns(t)
    assert all_same((theta, velocity), (pendulum.theta(t), pendulum.velocity(t)))
    column = np.array([t, t])
    for scalar, array in ((theta, pendulum.theta(column)), (angle, pendulum.turns(column)[1])):
        assert same(array, np.array([scalar, scalar]))
    # Rest and the separatrix have no limit; theta0 + velocity0 t, left by a negligible force, may do without one.
    unforced = abs(velocity0) >= 2.0**100 * pendulum.omega0
    periods = {"rest": math.inf, "libration": 0.5 * LIMIT, "separatrix": math.inf, "rotation": 0.5 * LIMIT}
    limit = periods[pendulum.regime] * pendulum.period
    if math.isnan(t) or (abs(t) > 1.001 * limit and not unforced):
        assert all(map(math.isnan, (theta, velocity, angle)))
        assert n == 0
    elif abs(t) < 0.999 * limit:
        assert not math.isnan(theta)
        assert not math.isnan(velocity)
        if abs(theta) < 5.79e19:
            assert -math.pi <= angle <= math.pi
        elif abs(theta) > 5.8e19:
            # More turns than an int64 counts.
            assert math.isnan(angle) and n == 0


@given(rows)
def test_a_row_does_not_depend_on_its_neighbours(table):
    columns = [np.array(column) for column in zip(*table, strict=True)]
    with np.errstate(all="raise"):
        for function in (libration.theta, libration.velocity, libration.motion, libration.advance):
            whole = np.array(function(*columns))
            for i in range(len(table)):
                alone = np.array(function(*(column[i : i + 1] for column in columns)))
                assert same(whole[..., i : i + 1], alone)


@given(st.tuples(doubles, doubles, doubles, doubles))
def test_the_paths_agree_about_nan(row):
    t, theta0, velocity0, omega0 = row
    one = libration.motion(t, theta0, velocity0, omega0)
    own = libration.motion([t], [theta0], [velocity0], [omega0])
    for left, right in zip(one, own, strict=True):
        assert math.isnan(left) == math.isnan(right[0])
    bad = not all(map(math.isfinite, (theta0, velocity0, omega0))) or omega0 < 0
    assert not bad or all(map(math.isnan, one))


@given(doubles, doubles, st.sampled_from(["m", "mc", "k"]))
def test_elliptic_functions(u, parameter, keyword):
    with np.errstate(all="raise"):
        values = libration.jacobi(u, **{keyword: parameter})
        quarter = libration.complete_k(**{keyword: parameter})
        integral = libration.complete_e(**{keyword: parameter})
        nome = libration.nome(**{keyword: parameter})
        libration.incomplete_f(u, **{keyword: parameter})
        libration.incomplete_e(u, **{keyword: parameter})
    bounded = abs(u) <= 1e6 and abs(parameter) <= 1e3
    assert all(math.isfinite(value) for value in values) or not bounded
    assert math.isfinite(u) or not math.isnan(u) or all(map(math.isnan, values))
    real = {"m": parameter <= 1, "mc": parameter >= 0, "k": abs(parameter) <= 1}[keyword]
    if math.isfinite(parameter):
        assert [math.isnan(value) for value in (quarter, integral, nome)] == [not real] * 3
    else:
        assert all(map(math.isnan, values))
    if bounded:
        assert abs(values.sn) <= 1
        assert abs(values.cn) <= 1
