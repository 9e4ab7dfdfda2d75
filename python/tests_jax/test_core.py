"""The core's own bits within JAX: every row of the truth's inputs, transformations, and what is refused.

What the bits are worth is measured where the core is: these are compared with those of the NumPy functions.
"""

import ctypes
import math
import threading

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from inputs import period_slopes, rows, states_of_periods

import libration
from libration import _core
from libration.jax import _core_functions, advance, motion, period


@pytest.fixture(autouse=True)
def float64():
    with jax.enable_x64(True):
        yield


def states(count):
    rng = np.random.default_rng(3)
    return [rng.uniform(*ends, count) for ends in ((-100, 100), (-30, 30), (-3, 3), (0.5, 2))]


def same(found, expected):
    return all(np.array_equal(*pair, equal_nan=True) for pair in zip(found, expected, strict=True))


def test_values_have_the_cores_bits():
    given = rows(np.float64).T
    t, theta, velocity, omega0 = given
    assert len(t) > 1600
    assert same(motion(*given, digits="core"), libration.motion(*given))
    assert not same(motion(np.nextafter(t, np.inf), *given[1:], digits="core"), libration.motion(*given))
    assert same(advance(theta, velocity, t, omega0, digits="core"), libration.advance(theta, velocity, t, omega0))
    assert same([period(*given[1:], digits="core")], [libration.period(*given[1:])])


def test_bits_do_not_depend_on_shape_transformation_or_thread():
    given = states(60_000)
    expected = libration.motion(*given)
    core = jax.jit(lambda *each: motion(*each, digits="core"))
    assert same(core(*given), expected)
    table = [each.reshape(300, 200) for each in given]
    assert same([each.ravel() for each in core(*table)], expected)
    for axis in (0, 1):
        found = jax.vmap(jax.vmap(core), in_axes=axis, out_axes=axis)(*table)
        assert same([each.ravel() for each in found], expected)
    few = [each[:3] for each in given]
    one_by_one = [core(*each) for each in zip(*few, strict=True)]
    assert same(np.array(one_by_one).T, [each[:3] for each in expected])
    turned = jax.vmap(lambda t: motion(t, 1.0, digits="core"))(given[0][:9])
    assert same(turned, libration.motion(given[0][:9], np.array([1.0])))
    found = [None] * 4

    def call(place):
        with jax.enable_x64(True):
            found[place] = core(*given)

    threads = [threading.Thread(target=call, args=(place,)) for place in range(len(found))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(same(each, expected) for each in found)


def test_a_scan_is_the_steps():
    def step(state, _):
        return advance(*state, 0.2, 1.2, digits="core"), state[0]

    last, passed = jax.lax.scan(step, (jnp.float64(1.0), jnp.float64(0.3)), length=50)
    state = 1.0, 0.3
    for angle in passed:
        assert angle == state[0]
        state = libration.advance(*state, 0.2, 1.2)
    assert same(last, state)


def test_derivatives_are_the_cores_next_to_the_separatrix_too():
    given = rows(np.float64)
    expected = libration.sensitivities(*given.T)
    finite = np.isfinite(expected).all((1, 2)) & (np.abs(given).max(1) < 1e9)
    near = np.abs(libration.energy_ratio_c(*given.T[1:])) < 1e-6
    assert finite.sum() > 1400 and (finite & near).sum() > 100
    given, expected = given[finite], expected[finite]

    def of_start(*each):
        return jnp.stack(motion(*each, digits="core"))

    forward = jax.jit(jax.vmap(jax.jacfwd(of_start, argnums=(0, 1, 2, 3))))(*given.T)
    backward = jax.jit(jax.vmap(jax.jacrev(of_start, argnums=(0, 1, 2, 3))))(*given.T)
    assert np.array_equal(np.stack(forward[1:], -1), expected)
    theta, velocity = libration.motion(*given.T)
    force = -(given[:, 3] ** 2) * np.sin(theta)
    assert np.array_equal(forward[0][:, 0], velocity)
    assert (np.abs(forward[0][:, 1] - force) <= 1e-15 * given[:, 3] ** 2).all()
    for one, other in zip(forward, backward, strict=True):
        assert np.array_equal(one, other)


def test_a_step_has_derivatives():
    t, theta, velocity, omega0 = states(200)
    by_state = jax.vmap(jax.jacfwd(lambda *each: jnp.stack(advance(*each, digits="core")), argnums=(0, 1, 3)))
    found = np.stack(by_state(theta, velocity, t, omega0), -1)
    assert np.array_equal(found, libration.sensitivities(t, theta, velocity, omega0))


def test_periods_have_derivatives_next_to_the_separatrix_too():
    given = states_of_periods()
    slopes = jax.jit(jax.vmap(jax.grad(lambda *each: period(*each, digits="core"), argnums=(0, 1, 2))))
    expected = np.array([period_slopes(*state) for state in zip(*given, strict=True)]).T
    weights = np.abs(expected).max(0)
    complement = np.abs(libration.energy_ratio_c(*given))
    assert (complement < 1e-6).sum() >= 3
    assert (np.abs(slopes(*given) - expected) / weights).max() < 1e-14
    assert (np.abs(slopes(given[0] * (1 + 1e-9), *given[1:]) - expected) / weights).max() > 1e-14


def test_bad_elements_are_nan_and_nothing_else_is():
    inf, nan = math.inf, math.nan
    given = np.array([[1, 1, 0, 1], [inf, 1, 0, 1], [1, inf, 0, 1], [1, 1, nan, 1], [1, 1, 0, -1]])
    assert np.isfinite(motion(*given.T, digits="core")).tolist() == [[True] + [False] * 4] * 2
    assert motion(np.ones((0, 3)), 1.0, digits="core")[0].shape == (0, 3)


def test_where_the_core_does_not_run_is_one_line():
    with pytest.raises(
        TypeError, match=r'^t is float32, but digits="core" is for float64: pass float64, or digits="full"$'
    ):
        motion(np.float32(1.0), 1.0, digits="core")
    with (
        jax.enable_x64(False),
        pytest.raises(TypeError, match=r'^digits="core" is for float64, but JAX computes in float32'),
    ):
        period(1.0, digits="core")
    traced = jax.jit(jax.vmap(lambda t: motion(t, 1.0, digits="core"))).trace(np.ones(3))
    traced.lower(lowering_platforms=("cpu",))
    for platform in ("cuda", "rocm", "tpu"):
        line = rf'^digits="core" runs on CPUs and not on {platform}: pass digits="full" there$'
        with pytest.raises(NotImplementedError, match=line):
            traced.lower(lowering_platforms=(platform,))


def test_an_xla_that_does_not_take_the_functions_is_one_line(monkeypatch):
    monkeypatch.setitem(_core_functions.RESULTS, "nothing", 1)
    monkeypatch.setattr(_core_functions, "period", lambda *given: _core_functions._called("nothing", *given, *given)[0])
    with pytest.raises(
        RuntimeError, match=r'^digits="core" does not run on this jaxlib, [\d.]+: pass digits="full" \('
    ) as told:
        _core_functions.ready.__wrapped__()
    assert "libration_nothing" in str(told.value) and "\n" not in str(told.value)


def test_wrong_buffers_are_one_line():
    def asked(given, shape=(3,)):
        results = (jax.ShapeDtypeStruct(shape, np.float64),) * 2
        return jax.block_until_ready(jax.ffi.ffi_call("libration_motion", results)(*given))

    asked([np.ones(3)] * 4)
    for given, line in (
        ([np.ones(3, np.float32)] * 4, "libration: arguments must be float64"),
        ([np.ones(3)] * 3, "libration: 3 arguments, must be 4"),
        ([np.ones(4)] * 4, "libration: all arguments and results must have one shape"),
    ):
        with pytest.raises(jax.errors.JaxRuntimeError, match=f"^INVALID_ARGUMENT: {line}\n"):
            asked(given)


class Xla:
    """The interface of the foreign functions by hand, in words of 64 bits: what a handler answers to a frame."""

    def __init__(self, version=(0, 3)):
        pointer = ctypes.pythonapi.PyCapsule_GetPointer
        pointer.restype, pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
        address = pointer(_core.xla_motion, b"xla._CUSTOM_CALL_TARGET")
        self.handler = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p)(address)
        self.create = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.POINTER(ctypes.c_uint64))(self.created)
        create = ctypes.cast(self.create, ctypes.c_void_p).value
        self.api = self.words(56, 0, 24, 0, version[0] + (version[1] << 32), 0, create)
        self.message = None

    @staticmethod
    def words(*values):
        return (ctypes.c_uint64 * len(values))(*values)

    def created(self, arguments):
        self.message = ctypes.cast(arguments[2], ctypes.c_char_p).value.decode()
        return 1

    def call(self, extension=0, size=160, buffers=40, stage=3):
        frame = self.words(size, extension, ctypes.addressof(self.api), 0, stage, *2 * (buffers, 0, 0, 0, 0), *5 * (0,))
        return self.handler(ctypes.addressof(frame)), self.message


def test_the_version_is_told_and_another_one_is_refused():
    xla = Xla()
    told = xla.words(36, 24, 0, 99, 99, 99)
    question = xla.words(32, 1, 0, ctypes.addressof(told))
    assert xla.call(ctypes.addressof(question)) == (None, None)
    assert list(told) == [36, 24, 0, 3 << 32, 99 >> 32 << 32, 0]
    # Before version 0.3 there is no last word.
    old = Xla((0, 2))
    told = xla.words(36, 24, 0, 99, 99, 99)
    question = xla.words(32, 1, 0, ctypes.addressof(told))
    assert old.call(ctypes.addressof(question)) == (None, None) and told[5] == 99
    line = "libration: the {} is not that of XLA's foreign functions 0.3: a newer libration is needed"
    told[0] = 24
    assert Xla().call(ctypes.addressof(question)) == (1, line.format("question for the version"))
    assert Xla().call(size=80) == (1, line.format("call"))
    assert Xla().call(buffers=48) == (1, line.format("call"))
    assert Xla().call(stage=1) == (1, "libration: no handler of stage 1")
    assert Xla().call() == (1, "libration: 0 arguments, must be 4")
