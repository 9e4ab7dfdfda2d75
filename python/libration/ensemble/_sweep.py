"""Motions over a grid of starts, frequencies and times, as a data set with names, units and coordinates.

Arguments without names of their own each give a dimension, and the grid is their product; arrays of xarray keep their dimensions, so
that those which share one go together. Over chunks the work is Dask's, and done when it is asked for. Units are those of the CF
conventions 1.11.
"""

import importlib.util
import math
import warnings
from typing import Any

import numpy as np

from .._dispatch import numbers
from .._messages import explained
from .._scalars import shown
from ..pendulum import motion

# Units and long names.
WORDS = {
    "theta0": ("rad", "initial angle from the bottom"),
    "velocity0": ("rad s-1", "initial angular velocity"),
    "omega0": ("rad s-1", "angular frequency of small swings"),
    "t": ("s", "time since the start"),
    "theta": ("rad", "angle from the bottom"),
    "velocity": ("rad s-1", "angular velocity"),
}


@explained
def sweep(*, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0, t: Any, chunks: Any = None) -> Any:
    """Motions for all combinations of starts, frequencies and times, as a data set of xarray.

    Parameters
    ----------
    theta0 : scalar, array of one dimension or DataArray
        Initial angles in rad.
    velocity0 : scalar, array of one dimension or DataArray, default 0.0
        Initial angular velocities in rad/s.
    omega0 : scalar, array of one dimension or DataArray, default 1.0
        Angular frequencies of small swings in rad/s.
    t : scalar, array of one dimension or DataArray
        Times in s.
    chunks : int, "auto", dict or None, default None
        How many elements of a dimension a chunk holds, of all dimensions or by name; then the variables are arrays of Dask, computed
        when asked for. None computes at once.

    Returns
    -------
    xarray.Dataset
        Variables `theta` and `velocity` over the dimensions `theta0`, `velocity0`, `omega0` and `t`, those of them that are arrays,
        in this order; a DataArray has its own dimensions. A bad element gives NaN there and nowhere else.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.
    ImportError
        Without xarray, or without Dask for chunks.

    Notes
    -----
    The values are those of `motion`, bit for bit, whatever the chunks. Source: CF conventions 1.11, section 3.

    Examples
    --------
    >>> from libration import ensemble
    >>> swings = ensemble.sweep(theta0=[0.5, 1.0, 2.0], omega0=[1.0, 3.0], t=[0.0, 1.0, 2.0, 3.0])
    >>> dict(swings.sizes)
    {'theta0': 3, 'omega0': 2, 't': 4}
    >>> f"{float(swings.theta.sel(theta0=1.0, omega0=3.0, t=2.0)):.6f}"
    '0.798638'
    """
    needs("xarray", "sweep")
    import xarray

    given = {"theta0": theta0, "velocity0": velocity0, "omega0": omega0, "t": t}
    arrays = {name: _labelled(xarray, name, value) for name, value in given.items()}
    sizes = _sizes(arrays)
    if chunks is not None:
        needs("dask", "chunks")
    known = None if chunks is None else _chunks(chunks, sizes)
    # Nothing cannot be cut.
    if known and all(sizes.values()):
        columns = {
            name: _bare(array).chunk({each: known[each] for each in array.dims}) for name, array in arrays.items()
        }
    else:
        columns = {name: _bare(array) for name, array in arrays.items()}
    # Without a dimension among them the start and the frequency are one orbit, with chunks as without.
    with warnings.catch_warnings():
        # That a product of chunked columns has more chunks than each of them, which Dask warns of, is the purpose.
        warnings.filterwarnings("ignore", "Increasing number of chunks")
        try:
            theta, velocity = motion(columns["t"], columns["theta0"], columns["velocity0"], columns["omega0"])
        except MemoryError:
            states = math.prod(sizes.values())
            raise ValueError(
                f"a grid of {states} states: must fit into memory, 16 bytes each; chunks= needs not"
            ) from None
    found = xarray.Dataset({"theta": theta.transpose(*sizes), "velocity": velocity.transpose(*sizes)})
    for array in arrays.values():
        found = found.assign_coords({name: each for name, each in array.coords.items() if name not in found.coords})
    for name, array in arrays.items():
        found = found.assign_coords({name: (array.dims, array.data)})
    for name, (units, words) in WORDS.items():
        found[name].attrs = {**(arrays[name].attrs if name in arrays else {}), "units": units, "long_name": words}
    return found.assign_attrs({"Conventions": "CF-1.11", "title": "motions of the exact pendulum"})


def needs(package: str, what: str) -> None:
    if importlib.util.find_spec(package) is None:
        raise ImportError(f"{what}: needs {package}: pip install 'libration[ensemble]'")


def _labelled(xarray: Any, name: str, value: Any) -> Any:
    """An argument with a name for each of its dimensions."""
    if isinstance(value, xarray.DataArray | xarray.Variable):
        array = value if isinstance(value, xarray.DataArray) else xarray.DataArray(value)
        if array.dtype.kind not in "biuf":
            raise ValueError(f"{name} is an array of {array.dtype}: must be real numbers")
        return array.astype(float)
    plain = np.ma.filled(numbers(value), np.nan)
    if plain.ndim > 1:
        raise ValueError(f"{name} of shape {plain.shape}: must be a number, an array of one dimension, or a DataArray")
    return xarray.DataArray(np.asarray(plain), dims=(name,) if plain.ndim else ())


def _bare(array: Any) -> Any:
    """The array without coordinates, which its own name would be one of."""
    return array.reset_coords(drop=True).drop_vars(array.dims, errors="ignore").rename(None)


def _sizes(arrays: dict[str, Any]) -> dict[Any, int]:
    """The dimensions of all arguments, which have one size and one set of labels each."""
    sizes: dict[Any, int] = {}
    labels: dict[Any, Any] = {}
    for name, array in arrays.items():
        for each, size in array.sizes.items():
            if sizes.setdefault(each, size) != size:
                raise ValueError(f"{name} has {size} elements along {each}: must have {sizes[each]}, as others")
            if each in array.indexes and not labels.setdefault(each, array.indexes[each]).equals(array.indexes[each]):
                raise ValueError(f"{name} has other labels along {each}: must have those of the others")
        for each in (*array.dims, *array.coords):
            if each in ("theta", "velocity"):
                raise ValueError(f"{name} has a dimension or coordinate {each}: must not be the name of a result")
    return sizes


def _chunks(chunks: Any, sizes: dict[Any, int]) -> dict[Any, Any]:
    """How the dimensions are cut."""
    if not isinstance(chunks, dict):
        chunks = dict.fromkeys(sizes, chunks)
    for name, size in chunks.items():
        if name not in sizes:
            raise ValueError(
                f"chunks has {shown(name)}: must be of the dimensions {', '.join(map(str, sizes)) or '(none)'}"
            )
        whole = isinstance(size, int | np.integer) and not isinstance(size, bool)
        if not (size == "auto" if isinstance(size, str) else whole and size >= 1):
            raise ValueError(f"chunks = {shown(size)} along {name}: must be a positive whole number or 'auto'")
    return {name: chunks.get(name, max(size, 1)) for name, size in sizes.items()}
