"""NumPy, Dask, xarray and xarray over Dask: every function takes them, gives their like, and computes nothing early."""

import subprocess
import sys

import dask
import dask.array
import numpy as np
import pytest
import xarray
from bits import all_same

import libration
from libration import Pendulum

T = np.linspace(-20.0, 20.0, 60).reshape(4, 15)
THETA0 = np.linspace(-4.0, 4.0, 15)
PENDULUM = Pendulum(0.0, 2.1, length=0.7)

CALLS = {
    "Pendulum.theta": PENDULUM.theta,
    "Pendulum.velocity": PENDULUM.velocity,
    "Pendulum.motion": PENDULUM.motion,
    "Pendulum.turns": PENDULUM.turns,
    "theta of one orbit": lambda t: libration.theta(t, 3.0, 0.1, 1.1),
    "velocity of one orbit": lambda t: libration.velocity(t, 3.0, 0.1, 1.1),
    "motion of one orbit": lambda t: libration.motion(t, 3.0, 0.1, 1.1),
    "theta": lambda t: libration.theta(t, t / 7, 0.1),
    "velocity": lambda t: libration.velocity(t, t / 7, 0.1),
    "motion": lambda t: libration.motion(t, t / 7, 0.1),
    "theta where": lambda t: libration.theta(t, 3.0, where=t > 0),
    "motion where": lambda t: libration.motion(t, t / 7, where=t > 0),
    "advance": lambda t: libration.advance(t, 0.3, 1.5, 1.1),
    "jacobi m": lambda t: libration.jacobi(t, m=0.8),
    "jacobi mc": lambda t: libration.jacobi(0.7, mc=t),
    "jacobi k": lambda t: libration.jacobi(t, k=t / 40),
    "incomplete_f": lambda t: libration.incomplete_f(t, m=0.8),
    "incomplete_e": lambda t: libration.incomplete_e(t, mc=0.8),
    "complete_k": lambda t: libration.complete_k(m=t),
    "complete_e": lambda t: libration.complete_e(mc=t),
    "nome": lambda t: libration.nome(k=t / 40),
}

calls = pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)


def parts(result):
    return tuple(result) if isinstance(result, tuple) else (result,)


def never(*arguments, **keywords):
    raise AssertionError("computed early")


def lazily(call, argument):
    """The parts of a call during which Dask may compute nothing."""
    with dask.config.set(scheduler=never):
        return parts(call(argument))


def test_never_is_reached_when_something_computes():
    with pytest.raises(AssertionError, match="computed early"):
        lazily(lambda array: array.compute(), dask.array.from_array(T))


@calls
def test_dask(call):
    results = lazily(call, dask.array.from_array(T, chunks=(2, 4)))
    for result, expected in zip(results, parts(call(T)), strict=True):
        assert isinstance(result, dask.array.Array)
        assert (result.dtype, result.shape, result.chunks) == (expected.dtype, expected.shape, ((2, 2), (4, 4, 4, 3)))
        assert all_same(result.compute(), expected)


@calls
def test_xarray(call):
    labels = {"time": np.arange(4), "place": np.arange(15)}
    results = parts(call(xarray.DataArray(T, labels, ("time", "place"))))
    for result, expected in zip(results, parts(call(T)), strict=True):
        assert isinstance(result, xarray.DataArray)
        assert (result.dims, list(result.coords)) == (("time", "place"), ["time", "place"])
        assert all_same(result.values, expected)


@calls
def test_xarray_over_dask(call):
    lazy = xarray.DataArray(dask.array.from_array(T, chunks=(2, 4)), dims=("time", "place"))
    for result, expected in zip(lazily(call, lazy), parts(call(T)), strict=True):
        assert isinstance(result, xarray.DataArray)
        assert isinstance(result.data, dask.array.Array)
        assert result.dims == ("time", "place")
        assert all_same(result.values, expected)


@pytest.mark.parametrize("call", [CALLS["Pendulum.theta"], CALLS["Pendulum.motion"]], ids=["theta", "motion"])
def test_xarray_datasets_and_variables(call):
    dataset = xarray.Dataset({"t": (("time", "place"), T)})
    for result, expected in zip(parts(call(dataset)), parts(call(T)), strict=True):
        assert isinstance(result, xarray.Dataset)
        assert all_same(result["t"].values, expected)
    for result, expected in zip(parts(call(dataset["t"].variable)), parts(call(T)), strict=True):
        assert all_same(result.values, expected)


def test_broadcasting_by_name():
    t = xarray.DataArray(T[0], dims="time")
    theta0 = xarray.DataArray(THETA0, dims="place")
    expected = libration.motion(T[0][:, None], THETA0)
    theta = libration.theta(t, theta0)
    assert theta.dims == ("time", "place")
    assert all_same(theta.values, expected[0])
    for result, whole in zip(libration.motion(t, theta0), expected, strict=True):
        assert result.dims == ("time", "place")
        assert all_same(result.values, whole)
    for result, whole in zip(libration.motion(t, theta0.chunk(place=4)), expected, strict=True):
        assert all_same(result.values, whole)


def test_broadcasting_and_different_chunks_in_dask():
    t = dask.array.from_array(T[0][:, None], chunks=4)
    theta0 = dask.array.from_array(THETA0, chunks=6)
    for argument in (theta0, THETA0):
        for result, whole in zip(
            lazily(lambda x, a=argument: libration.motion(x, a), t),
            libration.motion(T[0][:, None], THETA0),
            strict=True,
        ):
            assert all_same(result.compute(), whole)
    same_length = dask.array.from_array(T[0], chunks=5), dask.array.from_array(THETA0, chunks=6)
    for result, whole in zip(libration.motion(*same_length), libration.motion(T[0], THETA0), strict=True):
        assert all_same(result.compute(), whole)


@pytest.mark.parametrize("wrap", [dask.array.from_array, xarray.DataArray], ids=["dask", "xarray"])
def test_orbit_arguments_without_dimensions_are_one_orbit(wrap):
    expected = Pendulum(3.0, 0.1, omega0=1.1).motion(T)
    orbit = [wrap(np.array(value)) for value in (3.0, 0.1, 1.1)]
    for result, whole in zip(lazily(lambda t: libration.motion(t, *orbit), wrap(T)), expected, strict=True):
        assert all_same(np.asarray(result), whole)


def test_chunks_change_no_bit():
    t = np.linspace(-1e5, 1e5, 5000)
    expected = PENDULUM.motion(t)
    for chunk in (1, 7, 1000, 5000):
        piece = t[:50] if chunk == 1 else t
        for result, whole in zip(PENDULUM.motion(dask.array.from_array(piece, chunks=chunk)), expected, strict=True):
            assert all_same(result.compute(scheduler="threads"), whole[: len(piece)])


@pytest.mark.parametrize("method", ["theta", "motion"])
@pytest.mark.parametrize("kept", [True, False])
def test_attributes_follow_the_option_of_xarray(method, kept):
    t = xarray.DataArray(T, dims=("time", "place"), attrs={"source": "clock", "units": "s", "long_name": "time"})
    with xarray.set_options(keep_attrs=kept):
        for result in parts(getattr(PENDULUM, method)(t)):
            own = {"units": "rad" if result.name == "theta" else "rad/s", "long_name": result.long_name}
            assert result.attrs == (own | {"source": "clock"} if kept else own)
            assert result.long_name != "time"


def test_out_with_dask_is_left_to_dask():
    out = dask.array.zeros((4, 15), chunks=(2, 4))
    PENDULUM.theta(dask.array.from_array(T, chunks=(2, 4)), out=out)
    assert all_same(out.compute(), PENDULUM.theta(T))


def test_neither_library_is_imported_for_numpy():
    code = (
        "import sys, numpy, libration; p = libration.Pendulum(3.0); t = numpy.arange(3.0); p.motion(t); p.turns(t);"
        "libration.motion(t, t, where=t > 1); libration.jacobi(t, m=0.5); print({'dask', 'xarray'} & set(sys.modules))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "set()"


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
def test_a_matrix_of_numpy_gives_an_array_with_further_axes():
    t = np.matrix([[0.5, 1.5], [2.5, 3.5]])
    found = libration.sensitivities(t, 1.0)
    assert type(found) is np.ndarray
    assert all_same(found, libration.sensitivities(np.asarray(t), 1.0))
    assert PENDULUM.second_sensitivities(t).shape == (2, 2, 2, 3, 3)
