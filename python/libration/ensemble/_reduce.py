"""Sums over ensembles of any size: counts, moments, histograms and means, chunk by chunk, without the states being kept.

Each chunk of particles is made, moved to each of the times in one exact step, summed, and forgotten. The sums of the chunks are
joined in the order of the chunks, so that every bit of the result is the same for any number of workers; it depends on the size of a
chunk. Source: Chan, Golub & LeVeque, Am. Stat. 37 (1983), 242, for means and squares of two parts.
"""

import importlib
import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from .. import _core
from .._arrays import Floats
from .._dispatch import numbers
from .._messages import explained
from .._scalars import count, real, shown
from ..pendulum import action, frequency, motion
from ._bunch import positive
from ._schemes import wrap
from ._sweep import needs

# What can be counted, its units and its meaning.
QUANTITIES = {
    "theta": ("rad", "angle in [-pi, pi)"),
    "velocity": ("rad s-1", "angular velocity"),
    "action": ("rad2 s-1", "action per unit inertia"),
    "frequency": ("rad s-1", "mean angular frequency"),
    "energy_ratio": ("1", "energy over that at the top"),
}
# Chunks at a time: as many results wait to be joined. Particles of a block.
WAVE, BLOCK = 64, 2**13
MOMENTS = ("theta_mean", "velocity_mean", "theta_variance", "velocity_variance", "covariance")
RESULTS = ("count", *MOMENTS, "histogram", "outside", "t")


class Plan(NamedTuple):
    """What is asked of every chunk."""

    times: tuple[float, ...]
    omega0: float
    moments: int
    bins: dict[str, tuple[float, float, int]]
    means: dict[str, Callable[[Floats, Floats], Any]]


class Sums(NamedTuple):
    """What is known of some particles at one time: means of angle and velocity, and sums of products of what is left."""

    particles: int
    mean: Floats
    products: Floats
    histogram: Any
    totals: list[Any]


@explained
def reduce(
    states: Any,
    *,
    n: int | None = None,
    t: Any = 0.0,
    omega0: float = 1.0,
    moments: int = 2,
    histogram: Mapping[str, tuple[float, float, int]] | None = None,
    mean: Mapping[str, Callable[[Floats, Floats], Any]] | None = None,
    chunk: int = 2**17,
    workers: int | None = None,
) -> Any:
    """Counts, moments, histograms and means of an ensemble at some times, as a data set of xarray; states are not kept.

    Parameters
    ----------
    states : function or pair of array
        ``states(n, first=first)`` gives the angles and velocities of particles `first` to ``first + n - 1`` at t = 0, as
        ``functools.partial(bunch, distribution=..., seed=...)`` does; or all of them, as a pair of arrays of one dimension.
    n : int, optional
        How many particles; needed for a function.
    t : scalar or array of one dimension, default 0.0
        Times in s.
    omega0 : scalar, default 1.0
        Angular frequency of small swings in rad/s, positive.
    moments : {0, 1, 2}, default 2
        1 for the means of angle and velocity, 2 for their variances and covariance too, over n and not n - 1.
    histogram : dict, optional
        By quantity ``(low, high, bins)``: equal bins of [low, high), of all quantities together. The quantities are theta,
        velocity, action, frequency and energy_ratio.
    mean : dict, optional
        By name a function ``f(theta, velocity)`` of the states of some particles, real or complex, one number for each; its mean
        over all particles is given.
    chunk : int, default 131072
        Particles at a time. The last bits of sums depend on it.
    workers : int, optional
        Threads at work; by default the client of dask.distributed that is active, or a thread a core. The result does not depend
        on it.

    Returns
    -------
    xarray.Dataset
        Over the dimension `t`, if it has one: `count` of the particles that are finite, which the rest is of; `theta_mean`,
        `velocity_mean`, `theta_variance`, `velocity_variance`, `covariance`; `histogram` over `theta_bin` and so on, whose coordinates
        are the middles of the bins, and `outside`, how many are in none; and the means by name. Angles are in [-pi, pi).

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.
    ImportError
        Without xarray or Dask.

    Notes
    -----
    Memory: some 40 bytes a particle of the chunks at work, and 64 results of chunks. Source: Chan, Golub & LeVeque, Am. Stat. 37
    (1983), 242.

    Examples
    --------
    >>> from functools import partial
    >>> from libration import ensemble
    >>> beam = partial(ensemble.bunch, distribution="gaussian", sigma_theta=0.8, seed=1)
    >>> sums = ensemble.reduce(beam, n=300_000, t=[0.0, 1e6], histogram={"theta": (-3.2, 3.2, 64)})
    >>> print((sums.theta_variance**0.5).values.round(2), int(sums.histogram[0].sum()))
    [0.8 0.8] 300000
    """
    needs("xarray", "reduce")
    needs("dask", "reduce")
    source, total = _source(states, n)
    size = _positive("chunk", chunk)
    threads = None if workers is None else _positive("workers", workers)
    times = np.ma.filled(numbers(t), np.nan)
    if times.ndim > 1 or not times.size:
        raise ValueError(f"t of shape {times.shape}: must be a number, or an array of one dimension and not empty")
    if isinstance(moments, bool) or moments not in (0, 1, 2):
        raise ValueError(f"moments = {shown(moments)}: must be 0, 1 or 2")
    plan = Plan(
        tuple(times.ravel().tolist()), positive("omega0", omega0), moments, histogram_bins(histogram), _means(mean)
    )
    parts = [(first, min(size, total - first)) for first in range(0, total, size)]
    sums = [nothing(plan) for _ in plan.times]
    delayed: Any = importlib.import_module("dask")
    pace = {} if threads is None else {"scheduler": "threads", "num_workers": threads}
    for wave in range(0, len(parts), WAVE):
        tasks = [
            delayed.delayed(of_chunk, pure=False)(source, first, many, plan)
            for first, many in parts[wave : wave + WAVE]
        ]
        for found in delayed.compute(*tasks, **pace):
            sums = [joined(one, other) for one, other in zip(sums, found, strict=True)]
    return sums_dataset(plan, sums, times)


def of_chunk(source: Any, first: int, many: int, plan: Plan) -> list[Sums]:
    """The sums of one chunk at each of the times."""
    if isinstance(source, tuple):
        theta0, velocity0 = (each[first : first + many] for each in source)
    else:
        given = source(many, first=first)
        pair = tuple(map(np.asarray, given)) if isinstance(given, tuple | list) else ()
        if len(pair) != 2 or any(each.shape != (many,) or each.dtype.kind not in "biuf" for each in pair):
            raise ValueError(f"states({many}, first={first}): must give two arrays of {many} real numbers")
        theta0, velocity0 = (each.astype(float) for each in pair)
    return [sums_at(theta0, velocity0, time, plan) for time in plan.times]


def sums_at(theta0: Floats, velocity0: Floats, time: float, plan: Plan) -> Sums:
    """The sums of a chunk at one time, block by block: columns of a block stay in the cache."""
    sums = nothing(plan)
    counts, sums = sums.histogram, sums._replace(histogram=0)
    for begin in range(0, theta0.size, BLOCK):
        block = slice(begin, begin + BLOCK)
        sums = joined(sums, _of_block(theta0[block], velocity0[block], time, plan, counts))
    return sums._replace(histogram=counts)


def _of_block(theta0: Floats, velocity0: Floats, time: float, plan: Plan, counts: Any) -> Sums:
    """The sums of a block but for its histogram, which is added to `counts`."""
    theta, velocity = motion(time, theta0, velocity0, plan.omega0) if time else (theta0.copy(), velocity0)
    wrap(theta, np.zeros(theta.size, dtype=np.int64))
    found: Any = _core.moments(theta, velocity)
    if found is None:
        good = np.isfinite(theta) & np.isfinite(velocity)
        theta, velocity = theta[good], velocity[good]
        found = _core.moments(theta, velocity)
    mean, products = map(np.array, found)
    many = theta.size
    totals = []
    for name, function in plan.means.items():
        values = np.asarray(function(theta, velocity))
        if values.shape != theta.shape or values.dtype.kind not in "biufc":
            raise ValueError(
                f"mean {name!r} gives {values.dtype} of shape {values.shape}: must give a number for each of {many}"
            )
        totals.append(np.sum(values))
    if plan.bins:
        columns = [_quantity(name, theta, velocity, plan.omega0) for name in plan.bins]
        _core.histogram(columns, list(plan.bins.values()), counts)
    return Sums(many, mean, products, 0, totals)


def _quantity(name: str, theta: Floats, velocity: Floats, omega0: float) -> Any:
    if name == "action":
        return action(theta, velocity, omega0)
    if name == "frequency":
        return frequency(theta, velocity, omega0)
    if name == "energy_ratio":
        return np.sin(0.5 * theta) ** 2 + (velocity / (2.0 * omega0)) ** 2
    return theta if name == "theta" else velocity


def joined(one: Sums, other: Sums) -> Sums:
    """The sums of two parts together."""
    many = one.particles + other.particles
    if not other.particles:
        return one._replace(histogram=one.histogram + other.histogram)
    part = other.particles / many
    apart = other.mean - one.mean
    crossed = np.array([apart[0] * apart[0], apart[0] * apart[1], apart[1] * apart[1]])
    products = one.products + other.products + crossed * (one.particles * part)
    totals = [first + second for first, second in zip(one.totals, other.totals, strict=True)]
    return Sums(many, one.mean + apart * part, products, one.histogram + other.histogram, totals)


def histogram_cells(plan: Plan) -> int:
    """How many numbers of particles a histogram has: those of the bins, and that of the rest."""
    return math.prod(bins for _, _, bins in plan.bins.values()) + 1 if plan.bins else 0


def nothing(plan: Plan) -> Sums:
    """The sums of no particle."""
    cells = histogram_cells(plan)
    return Sums(0, np.zeros(2), np.zeros(3), np.zeros(cells, dtype=np.int64) if cells else 0, [0.0] * len(plan.means))


def sums_dataset(plan: Plan, sums: list[Sums], times: Floats) -> Any:
    """The results by name, with units."""
    import xarray

    dims = ("t",) if times.ndim else ()
    many = np.array([each.particles for each in sums], dtype=np.int64)
    over = np.where(many > 0, many, 1)
    found: dict[str, Any] = {"count": (many, "1", "particles that are finite")}
    for place, name in enumerate(("theta", "velocity") if plan.moments else ()):
        units, words = QUANTITIES[name]
        found[f"{name}_mean"] = np.array([each.mean[place] for each in sums]), units, f"mean of the {words}"
    if plan.moments > 1:
        products = np.array([each.products for each in sums]).reshape(-1, 3) / over[:, None]
        found["theta_variance"] = products[:, 0], "rad2", "variance of the angle"
        found["covariance"] = products[:, 1], "rad2 s-1", "covariance of angle and angular velocity"
        found["velocity_variance"] = products[:, 2], "rad2 s-2", "variance of the angular velocity"
    for place, name in enumerate(plan.means):
        found[name] = np.array([each.totals[place] for each in sums]) / over, None, f"mean of {name}"
    variables = {}
    for name, (values, units, words) in found.items():
        if name != "count":
            values = np.where(many > 0, values, np.nan)
        attributes = {"long_name": words} if units is None else {"units": units, "long_name": words}
        variables[name] = dims, values.reshape(times.shape), attributes
    coordinates: dict[str, Any] = {"t": (dims, times, {"units": "s", "long_name": "time since the start"})}
    if plan.bins:
        shape = [bins for _, _, bins in plan.bins.values()]
        counts = np.array([each.histogram for each in sums]).reshape(len(sums), -1)
        whole = counts[:, :-1].reshape(*times.shape, *shape)
        variables["histogram"] = (
            (*dims, *(f"{name}_bin" for name in plan.bins)),
            whole,
            {"units": "1", "long_name": "particles"},
        )
        variables["outside"] = (
            dims,
            counts[:, -1].reshape(times.shape),
            {"units": "1", "long_name": "particles in no bin"},
        )
        for name, (low, high, bins) in plan.bins.items():
            middles = low + (high - low) * ((np.arange(bins) + 0.5) / bins)
            units, words = QUANTITIES[name]
            told = {"units": units, "long_name": f"middle of the bin of the {words}", "low": low, "high": high}
            coordinates[f"{name}_bin"] = f"{name}_bin", middles, told
    return xarray.Dataset(
        variables, coordinates, {"Conventions": "CF-1.11", "title": "sums over an ensemble of pendulums"}
    )


def _source(states: Any, n: Any) -> tuple[Any, int]:
    """Where the states come from, and how many they are."""
    if callable(states):
        if n is None:
            raise ValueError("n = None: must be given where states is a function")
        return states, _positive("n", n)
    if not isinstance(states, tuple | list) or len(states) != 2:
        raise TypeError(f"states = {shown(states)}: must be a function of n and first, or a pair of arrays")
    try:
        pair = tuple(np.ascontiguousarray(np.ma.filled(numbers(each), np.nan)) for each in states)
    except TypeError as error:
        raise TypeError(f"states: {error}") from None
    if pair[0].ndim != 1 or pair[0].shape != pair[1].shape:
        raise ValueError(
            f"states of shapes {pair[0].shape} and {pair[1].shape}: must be two arrays of one dimension and length"
        )
    if n is not None and count("n", n) != pair[0].size:
        raise ValueError(f"n = {n}: must be the length of the arrays, {pair[0].size}, or be left out")
    return pair, pair[0].size


def _positive(name: str, value: Any) -> int:
    whole = count(name, value)
    if whole < 1:
        raise ValueError(f"{name} = {whole}: must be positive")
    return whole


def histogram_bins(histogram: Any) -> dict[str, tuple[float, float, int]]:
    """The bins of each quantity."""
    if histogram is not None and not isinstance(histogram, Mapping):
        raise TypeError(f"histogram = {shown(histogram)}: must be a dict of (low, high, bins) by quantity")
    found = {}
    for name, each in (histogram or {}).items():
        if name not in QUANTITIES:
            raise ValueError(f"histogram has {shown(name)}: must be of {', '.join(QUANTITIES)}")
        if not isinstance(each, tuple | list) or len(each) != 3:
            raise ValueError(f"histogram of {name} = {shown(each)}: must be (low, high, bins)")
        low, high = (real(f"{name} {end}", value) for end, value in zip(("low", "high"), each[:2], strict=True))
        bins = _positive(f"{name} bins", each[2])
        if not (low < high and math.isfinite(high - low)):
            raise ValueError(f"histogram of {name} = {shown(each)}: must have finite ends, low below high")
        found[name] = low, high, bins
    if math.prod(bins for _, _, bins in found.values()) > 10**8:
        raise ValueError(f"histogram = {shown(histogram)}: must have no more than 10**8 bins in all")
    return found


def _means(mean: Any) -> dict[str, Callable[[Floats, Floats], Any]]:
    """The functions whose means are asked for."""
    if mean is not None and not isinstance(mean, Mapping):
        raise TypeError(f"mean = {shown(mean)}: must be a dict of functions by name")
    for name, function in (mean or {}).items():
        if not isinstance(name, str) or not callable(function):
            raise TypeError(f"mean has {shown(name)}: {shown(function)}: must be functions by name")
        if name in RESULTS or name.endswith("_bin"):
            raise ValueError(f"mean has {name!r}: must not be the name of another result")
    return dict(mean or {})
