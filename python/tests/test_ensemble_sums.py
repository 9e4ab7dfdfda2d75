"""Grids and sums: the same bits with chunks as without and for any number of workers, lazy until asked, with names and units."""

import math
import subprocess
import sys
from functools import partial

import dask
import dask.array
import numpy as np
import pytest
import xarray

import libration
from libration.ensemble import bunch, reduce, sweep

GRID = {
    "theta0": np.linspace(-3.0, 3.0, 7),
    "velocity0": [0.0, 1.0, math.nan],
    "omega0": np.array([1, 2]),
    "t": np.linspace(0.0, 9.0, 11),
}
PARTICLES = {
    "theta0": xarray.DataArray(
        [0.1, 0.2, 3.0], dims="particle", coords={"particle": [5, 6, 7]}, attrs={"source": "me"}
    ),
    "velocity0": xarray.DataArray([1.0, 2.0, 3.0], dims="particle"),
    "t": [0.0, 1.0],
}
BEAM = partial(bunch, distribution="thermal", temperature=0.8, rotations=True, seed=1)


@pytest.mark.parametrize("chunks", [1, 3, "auto", {"t": 4}, {"theta0": 2, "omega0": 1, "t": 5}], ids=str)
def test_chunks_are_the_whole_bit_for_bit(chunks):
    whole, cut = sweep(**GRID), sweep(**GRID, chunks=chunks)
    assert dask.is_dask_collection(cut) and all(dask.is_dask_collection(each.data) for each in cut.values())
    if chunks == 3:
        assert cut.theta.chunks == ((3, 3, 1), (3,), (2,), (3, 3, 3, 2))
    computed = cut.compute()
    assert computed.identical(whole)
    assert all(computed[name].values.tobytes() == whole[name].values.tobytes() for name in whole)
    theta0, velocity0, omega0, t = np.ix_(*GRID.values())
    theta, velocity = libration.motion(t, theta0, velocity0, omega0)
    assert whole.theta.values.tobytes() == theta.tobytes() and whole.velocity.values.tobytes() == velocity.tobytes()


def test_nothing_is_computed_early():
    huge = sweep(theta0=np.linspace(0, 3, 10**5), t=np.linspace(0, 1, 10**5), chunks=2000)
    assert huge.theta.nbytes == 8 * 10**10
    assert float(huge.theta[0, 5]) == 0.0


def test_names_units_and_coordinates():
    grid = sweep(**GRID)
    assert dict(grid.sizes) == {"theta0": 7, "velocity0": 3, "omega0": 2, "t": 11}
    units = {
        "theta0": "rad",
        "velocity0": "rad s-1",
        "omega0": "rad s-1",
        "t": "s",
        "theta": "rad",
        "velocity": "rad s-1",
    }
    assert {name: grid[name].attrs["units"] for name in units} == units
    assert all(grid[name].attrs["long_name"] for name in units) and grid.attrs["Conventions"].startswith("CF-")
    for name, values in GRID.items():
        assert np.array_equal(grid[name], values, equal_nan=True)
    one = sweep(theta0=1.0, t=GRID["t"])
    assert np.array_equal(one.theta, libration.Pendulum(1.0).theta(GRID["t"]))
    assert sweep(theta0=1.0, t=GRID["t"], chunks=4).compute().identical(one)
    assert sweep(theta0=1.0, t=2.0).theta.dims == ()
    assert sweep(theta0=[], t=[1.0], chunks=2).theta.shape == (0, 1)


def test_arrays_of_xarray_keep_their_dimensions():
    pairs = sweep(**PARTICLES)
    assert dict(pairs.sizes) == {"particle": 3, "t": 2} and pairs.particle.values.tolist() == [5, 6, 7]
    assert pairs.theta0.attrs["source"] == "me" and "source" not in pairs.theta.attrs
    assert np.array_equal(pairs.theta[2], libration.theta([0.0, 1.0], np.full(2, 3.0), 3.0))
    assert sweep(**PARTICLES, chunks=2).compute().identical(pairs)
    lazy = PARTICLES | {"theta0": PARTICLES["theta0"].chunk(1)}
    assert dask.is_dask_collection(sweep(**lazy)) and np.array_equal(sweep(**lazy).theta, pairs.theta)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"theta0": "a"}, "theta0 = 'a': must be real numbers"),
        ({"theta0": [[1.0]]}, "theta0 of shape (1, 1): must be a number, an array of one dimension, or a DataArray"),
        ({"theta0": 1j}, "theta0 = 1j: must be real numbers"),
        ({"theta0": xarray.DataArray(["a"], dims="x")}, "theta0 is an array of <U1: must be real numbers"),
        ({"chunks": 0}, "chunks = 0 along theta0: must be a positive whole number or 'auto'"),
        ({"chunks": True}, "chunks = True along theta0: must be"),
        ({"chunks": "1MB"}, "chunks = '1MB' along theta0: must be"),
        ({"chunks": {"x": 1}}, "chunks has 'x': must be of the dimensions theta0"),
        (PARTICLES | {"velocity0": PARTICLES["velocity0"][:2]}, "velocity0 has 2 elements along particle: must have 3"),
        (
            PARTICLES | {"velocity0": PARTICLES["velocity0"].assign_coords(particle=[1, 2, 3])},
            "velocity0 has other labels along particle: must have those of the others",
        ),
        (
            {"theta0": xarray.DataArray([1.0], dims="theta")},
            "theta0 has a dimension or coordinate theta: must not be the name of a result",
        ),
    ],
)
def test_bad_grids_are_one_line(arguments, said):
    with pytest.raises((ValueError, TypeError)) as caught:
        sweep(**{"theta0": [1.0], "t": 1.0} | arguments)
    assert str(caught.value).startswith(said) and "\n" not in str(caught.value)


ASKED = {
    "t": [0.0, 5.0, 1e5],
    "histogram": {"theta": (-3.2, 3.2, 16), "action": (0.0, 3.0, 8)},
    "mean": {"bunching": lambda theta, velocity: np.exp(1j * theta), "fast": lambda theta, velocity: velocity > 1},
}


def same(first, second):
    assert first.identical(second)
    return all(first[name].values.tobytes() == second[name].values.tobytes() for name in first)


def test_any_number_of_workers_gives_the_same_bytes():
    sums = [reduce(BEAM, n=70_001, chunk=1003, workers=workers, **ASKED) for workers in (1, 2, 5, None)]
    assert all(same(each, sums[0]) for each in sums)
    assert same(reduce(BEAM(70_001), chunk=1003, **ASKED), sums[0])
    other = reduce(BEAM, n=70_001, chunk=70_001, **ASKED)
    assert (
        np.array_equal(other.histogram, sums[0].histogram) and abs(other.theta_mean - sums[0].theta_mean).max() < 1e-14
    )


def test_sums_are_those_of_the_states():
    theta0, velocity0 = BEAM(50_000)
    sums = reduce(BEAM, n=50_000, chunk=7000, **ASKED)
    assert sums["count"].values.tolist() == [50_000] * 3
    for place, time in enumerate(ASKED["t"]):
        _, theta = libration.turns(time, theta0, velocity0)
        velocity = libration.velocity(time, theta0, velocity0)
        at = sums.isel(t=place)
        # Angles of rotations are rounded before whole turns are taken from them: a few 1e-11 each at the last time.
        assert abs(at.theta_mean - theta.mean()) < 1e-12 and abs(at.velocity_mean - velocity.mean()) < 1e-14
        assert abs(at.theta_variance / theta.var() - 1) < 1e-11
        assert abs(at.velocity_variance / velocity.var() - 1) < 1e-12
        assert abs(at.covariance - np.cov(theta, velocity, bias=True)[0, 1]) < 1e-12
        assert abs(at.theta_mean - theta.mean() - 1e-6) > 1e-12, "a spoiled mean must show"
        assert abs(at.bunching - np.exp(1j * theta).mean()) < 1e-12 and abs(at.fast - (velocity > 1).mean()) < 1e-13
        edges = [np.linspace(-3.2, 3.2, 17), np.linspace(0.0, 3.0, 9)]
        counts = np.histogram2d(theta, libration.action(theta, velocity), edges)[0]
        assert np.abs(at.histogram - counts).sum() <= 2
        assert int(at.histogram.sum() + at.outside) == 50_000
    assert np.allclose(sums.theta_bin, -3.0 + 0.4 * np.arange(16)) and sums.action_bin.attrs["high"] == 3.0
    assert sums.t.attrs["units"] == "s" and sums.covariance.attrs["units"] == "rad2 s-1"


def test_quantities_and_the_ends_of_bins():
    theta, velocity = np.array([0.0, 0.25, 0.5, 0.75, 1.0, math.nextafter(1.0, 0.0)]), np.zeros(6)
    counts = reduce((theta, velocity), histogram={"theta": (0.0, 1.0, 4)})
    assert counts.histogram.values.tolist() == [1, 1, 1, 2] and int(counts.outside) == 1
    for name, function in (
        ("action", libration.action),
        ("frequency", libration.frequency),
        ("energy_ratio", libration.energy_ratio),
    ):
        known = function(theta, velocity, 2.0)
        counts = reduce((theta, velocity), omega0=2.0, histogram={name: (0.0, 2.5, 50)})
        assert np.array_equal(counts.histogram, np.histogram(known, np.linspace(0.0, 2.5, 51))[0])
    assert "theta_mean" not in reduce((theta, velocity), moments=0) and "covariance" not in reduce(
        (theta, velocity), moments=1
    )


def test_a_large_mean_leaves_the_variance_its_digits():
    velocity = 1e8 + BEAM(50_000)[1]
    found = reduce((np.zeros(50_000), velocity), chunk=1000)
    assert abs(found.velocity_variance / np.var(velocity - 1e8) - 1) < 1e-9


def test_bad_particles_are_left_out():
    theta, velocity = BEAM(1000)
    theta[:5], velocity[7] = math.nan, math.inf
    found = reduce((theta, velocity), t=[0.0, 3.0, math.nan])
    assert found["count"].values.tolist() == [994, 994, 0] and math.isnan(found.theta_mean[2])
    good = np.isfinite(theta) & np.isfinite(velocity)
    assert float(found.theta_mean[0]) == reduce((theta[good], velocity[good])).theta_mean
    assert int(reduce(([], []), histogram={"theta": (0, 1, 2)})["count"]) == 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"states": BEAM}, "n = None: must be given where states is a function"),
        ({"states": 1.0}, "states = 1.0: must be a function of n and first, or a pair of arrays"),
        ({"states": ("a", "b")}, "states: 'a': must be real numbers"),
        (
            {"states": ([1.0], [1.0, 2.0])},
            "states of shapes (1,) and (2,): must be two arrays of one dimension and length",
        ),
        ({"states": lambda n, first: (1, 2), "n": 4}, "states(4, first=0): must give two arrays of 4 real numbers"),
        ({"n": 4}, "n = 4: must be the length of the arrays, 2, or be left out"),
        ({"states": BEAM, "n": 0}, "n = 0: must be positive"),
        ({"moments": 3}, "moments = 3: must be 0, 1 or 2"),
        ({"moments": True}, "moments = True: must be 0, 1 or 2"),
        ({"t": []}, "t of shape (0,): must be a number, or an array of one dimension and not empty"),
        ({"omega0": 0.0}, "omega0 = 0.0: must be positive and finite"),
        ({"chunk": 0}, "chunk = 0: must be positive"),
        ({"workers": 1.5}, "workers = 1.5: must be a whole number"),
        ({"histogram": [1]}, "histogram = [1]: must be a dict of (low, high, bins) by quantity"),
        (
            {"histogram": {"x": (0, 1, 2)}},
            "histogram has 'x': must be of theta, velocity, action, frequency, energy_ratio",
        ),
        ({"histogram": {"theta": (0, 1)}}, "histogram of theta = (0, 1): must be (low, high, bins)"),
        ({"histogram": {"theta": (1, 0, 2)}}, "histogram of theta = (1, 0, 2): must have finite ends, low below high"),
        ({"histogram": {"theta": (0, 1, 0)}}, "theta bins = 0: must be positive"),
        ({"histogram": {"theta": (0, "a", 1)}}, "theta high = 'a': must be one real number"),
        (
            {"histogram": {"theta": (0, 1, 10**9)}},
            "histogram = {'theta': (0, 1, 1000000000)}: must have no more than 10**8",
        ),
        ({"mean": [abs]}, "mean = [<built-in function abs>]: must be a dict of functions by name"),
        ({"mean": {"count": abs}}, "mean has 'count': must not be the name of another result"),
        ({"mean": {"x": 1.0}}, "mean has 'x': 1.0: must be functions by name"),
        (
            {"mean": {"x": lambda theta, velocity: 1.0}},
            "mean 'x' gives float64 of shape (): must give a number for each of 2",
        ),
    ],
)
def test_bad_sums_are_one_line(arguments, said):
    with pytest.raises((ValueError, TypeError)) as caught:
        reduce(**{"states": ([1.0, 2.0], [0.0, 0.0])} | arguments)
    assert str(caught.value).startswith(said) and "\n" not in str(caught.value)


def test_nothing_heavy_is_imported_before_it_is_needed():
    program = "import sys, libration; libration.ensemble.bunch(3, distribution='gaussian', sigma_theta=0.5, seed=1)\n"
    program += "print([name for name in ('scipy', 'xarray', 'dask', 'pandas', 'matplotlib') if name in sys.modules])"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"


@pytest.mark.parametrize(
    ("call", "said"),
    [
        ("ensemble.sweep(theta0=1.0, t=1.0)", "sweep: needs xarray"),
        ("ensemble.reduce(([1.0], [0.0]))", "reduce: needs xarray"),
        ("ensemble.bunch(3, distribution='thermal', temperature=1.0, seed=1)", "distribution = 'thermal': needs SciPy"),
    ],
)
def test_what_is_missing_is_named(call, said):
    program = "import importlib.util, sys\nfrom libration import ensemble\n"
    program += "importlib.util.find_spec = lambda name: None\n" + call
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert run.stderr.splitlines()[-1] == f"ImportError: {said}: pip install 'libration[ensemble]'"
