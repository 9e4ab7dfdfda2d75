"""One call of a ufunc on NumPy, Dask or xarray arguments, or on xarray over Dask.

NumPy, and every array type that implements ``__array_ufunc__`` for several outputs (pandas among them), is called
directly. Dask refuses ufuncs of several outputs, so its arrays go through ``apply_gufunc``; xarray's go through
``apply_ufunc``. Neither library is imported unless one of its arrays is an argument. Nothing is computed early.
"""

from functools import partial
from typing import Any

import numpy as np

PLAIN = {float, int, bool, np.float64, np.ndarray, type(None)}


def apply(ufunc: np.ufunc, *arguments: Any, out: Any = None, where: Any = True) -> Any:
    """Call ``ufunc`` on ``arguments``; what ``where`` masks is NaN unless ``out`` is given."""
    if where is None:
        raise ValueError("where = None: must be True, False or an array of them")
    if out is not None:
        return ufunc(*arguments, out=out, where=where)
    given = arguments if where is True else (*arguments, where)
    library = array_library(given)
    if library == "xarray":
        return _xarray(ufunc, given, where is not True)
    if library == "dask":
        return _dask(ufunc, given, where is not True)
    if where is True:
        return ufunc(*arguments)
    return _masked(ufunc, *given)


def array_library(arguments: tuple[Any, ...]) -> str | None:
    """``"xarray"`` if any argument is xarray's, else ``"dask"`` if any is Dask's, else ``None``."""
    found = None
    for argument in arguments:
        if type(argument) in PLAIN:
            continue
        for base in type(argument).__mro__:
            if base.__module__.startswith("xarray.core."):
                return "xarray"
            if base.__module__.startswith("dask.array."):
                found = "dask"
    return found


def _masked(ufunc: np.ufunc, *given: Any) -> Any:
    first, *others, where = given
    chosen = np.asarray(where)
    if chosen.size and chosen.dtype != bool:
        raise ValueError(f"where of dtype {chosen.dtype}: must be True, False or an array of them")
    # A NaN among the arguments is a NaN in every result, and a sum keeps the type of the argument: pandas, masked
    # arrays. Adding -0.0 changes no number, not even the sign of a zero.
    return ufunc(np.add(first, np.where(chosen, -0.0, np.nan)), *others)


def _dask(ufunc: np.ufunc, given: tuple[Any, ...], masked: bool) -> Any:
    from dask.array import apply_gufunc, asarray, unify_chunks

    arrays = [asarray(argument) for argument in given]
    most = max(array.ndim for array in arrays)
    labelled = [(array, tuple(range(most - array.ndim, most))) for array in arrays]
    _, arrays = unify_chunks(*(item for pair in labelled for item in pair))
    kinds = ufunc.types[0].partition("->")[2]
    dtypes = [np.dtype(kind) for kind in kinds]
    return apply_gufunc(
        partial(_masked, ufunc) if masked else ufunc,
        ",".join(["()"] * len(arrays)) + "->" + ",".join(["()"] * ufunc.nout),
        *arrays,
        output_dtypes=dtypes if ufunc.nout > 1 else dtypes[0],
    )


def _xarray(ufunc: np.ufunc, given: tuple[Any, ...], masked: bool) -> Any:
    import xarray

    def rows(*arrays: Any) -> Any:
        return apply(ufunc, *arrays[:-1], where=arrays[-1]) if masked else apply(ufunc, *arrays)

    # As for NumPy's own functions on xarray objects: attributes stay unless the user's option says otherwise.
    keep = xarray.get_options()["keep_attrs"]
    return xarray.apply_ufunc(
        rows,
        *given,
        output_core_dims=[[]] * ufunc.nout,
        dask="allowed",
        keep_attrs=True if keep == "default" else keep,
    )


def tensor(results: tuple[Any, ...], axes: dict[str, tuple[str, ...]]) -> Any:
    """The results of a ufunc as one array with further axes, the last running fastest; xarray's have their names."""
    library = array_library(results)
    taken = set(axes).intersection(getattr(results[0], "dims", ()))
    if taken:
        names = ", ".join(sorted(taken))
        raise ValueError(f"an argument has the dimension {names}: must not be one of {', '.join(axes)}, the new ones")
    stacked = list(results)
    for depth, (name, labels) in enumerate(reversed(axes.items())):
        width = len(labels)
        parts = [stacked[first : first + width] for first in range(0, len(stacked), width)]
        stacked = [_stack(library, part, -1 - depth, name, labels) for part in parts]
    [whole] = stacked
    return whole.transpose(..., *axes) if library == "xarray" else whole


def _stack(library: str | None, part: list[Any], axis: int, name: str, labels: tuple[str, ...]) -> Any:
    """Arrays of one shape side by side along a new axis."""
    if library == "xarray":
        import xarray

        if isinstance(part[0], xarray.Variable):
            return xarray.Variable.concat(part, name)
        return xarray.concat(part, xarray.Variable(name, list(labels)))
    if library == "dask":
        from dask.array import stack

        return stack(part, axis=axis, allow_unknown_chunksizes=True)
    masked = any(isinstance(each, np.ma.MaskedArray) for each in part)
    return (np.ma.stack if masked else np.stack)(part, axis=axis)


def unindexed(argument: Any) -> Any:
    """A labelled index of pandas as an array: it does not take ufuncs of several outputs."""
    return np.asarray(argument) if hasattr(argument, "to_frame") and not hasattr(argument, "iloc") else argument
