"""One call of a ufunc on NumPy, pandas, Dask or xarray arguments, or on xarray over Dask.

NumPy, and every array type that implements ``__array_ufunc__`` for several outputs (pandas among them), is called
directly. Dask refuses ufuncs of several outputs, so its arrays go through ``apply_gufunc``; xarray's go through
``apply_ufunc``. No library is imported unless one of its arrays is an argument. Nothing is computed early.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from ._advice import has_units
from ._labels import Result, like, named
from ._units import plain

PLAIN = {float, int, bool, np.float64, np.ndarray, type(None)}
LIBRARIES = ("xarray", "dask.array", "pandas")


class Elementwise:
    """A function of arrays of doubles, of any one shape, with what `apply` asks of a ufunc.

    It answers one array of as many doubles, or a tuple of ``nout``; what is masked stays masked. `argument` is the name of what it takes.
    """

    def __init__(self, function: Callable[[np.ndarray], Any], nout: int = 1, argument: str = "t") -> None:
        self.function = function
        self.argument = argument
        self.nout = nout
        self.types = ("d->" + nout * "d",)

    def __call__(self, argument: Any) -> Any:
        if has_units(argument):
            # What NumPy would make of it are the numbers in whatever unit it has.
            try:
                argument = plain(self.argument, argument)
            except ValueError as error:
                raise TypeError(str(error)) from None
        values = numbers(argument)
        answers = self.function(np.ascontiguousarray(np.ma.filled(values, np.nan)).ravel())
        shaped = tuple(
            self._like(argument, values, each.reshape(values.shape))
            for each in (answers if self.nout > 1 else (answers,))
        )
        return shaped if self.nout > 1 else shaped[0]

    @staticmethod
    def _like(argument: Any, values: Any, answers: np.ndarray) -> Any:
        if isinstance(values, np.ma.MaskedArray):
            return np.ma.array(answers, mask=values.mask)
        return like(argument, answers) if values.ndim else answers[()]


class Words:
    """The ufunc of a regime with words in the place of its numbers, with what `apply` asks of a ufunc."""

    nout = 1

    def __init__(self, kernel: Any, words: list[str]) -> None:
        self.kernel = kernel
        # The last is that of what is no number.
        self.words = np.array([*words, ""])
        self.types = ("d" * kernel.nin + "->U",)
        self.dtypes = (self.words.dtype,)

    def __call__(self, *operands: Any) -> Any:
        codes = self.kernel(*operands)
        places = np.asarray(codes)
        words = self.words[np.where(np.isnan(places), -1, places).astype(int)]
        if isinstance(codes, np.ma.MaskedArray):
            return np.ma.array(words, mask=codes.mask)
        return like(codes, words) if places.ndim else words


def numbers(argument: Any) -> Any:
    """An argument as an array of doubles; text, None, complex numbers and quantities with units are refused, not converted."""
    if has_units(argument):
        raise TypeError(f"{argument!r}: must be real numbers without units")
    if hasattr(argument, "iloc"):
        # The missing values of pandas.
        argument = argument.to_numpy(dtype=float, na_value=np.nan)
    values = np.asanyarray(argument)
    if values.dtype.kind not in "biuf":
        raise TypeError(f"{argument!r}: must be real numbers")
    return values.astype(float)


def apply(ufunc: Any, *arguments: Any, results: tuple[Result, ...] = (), out: Any = None, where: Any = True) -> Any:
    """Call ``ufunc`` on ``arguments``; what ``where`` masks is NaN unless ``out`` is given."""
    if where is True:
        for argument in arguments:
            if type(argument) not in PLAIN:
                break
        else:
            return ufunc(*arguments) if out is None else ufunc(*arguments, out=out)
    if where is None:
        raise ValueError("where = None: must be True, False or an array of them")
    given = arguments if where is True else (*arguments, where)
    library = array_library(given)
    if out is not None:
        return ufunc(*arguments, out=out, where=where)
    if library is None:
        return ufunc(*arguments) if where is True else _masked(ufunc, *given)
    if library == "dask.array":
        return _dask(ufunc, given, where is not True)
    if library == "xarray":
        found = _xarray(ufunc, given, where is not True)
    else:
        found = ufunc(*arguments) if where is True else _masked(ufunc, *given)
    if not results:
        return found
    return named(found, *results) if ufunc.nout == 1 else tuple(map(named, found, results))


def has_dimensions(argument: Any) -> bool:
    """Whether an argument is more than one number; a dataset of xarray, which has no shape, where it has dimensions."""
    sizes = getattr(argument, "sizes", None)
    return bool(np.ndim(argument) if sizes is None else sizes)


def array_library(arguments: tuple[Any, ...]) -> str | None:
    """The library whose arrays are among the arguments, ``None`` for NumPy alone; xarray takes those of Dask in."""
    found: dict[str, Any] = {}
    for argument in arguments:
        if type(argument) in PLAIN:
            continue
        library = _library(type(argument))
        if library is None:
            continue
        first = found.setdefault(library, argument)
        # A series and a table of pandas have no common index.
        if library == "pandas" and np.ndim(first) != np.ndim(argument):
            raise TypeError(_apart(first, argument))
    if "pandas" in found and len(found) > 1:
        raise TypeError(_apart(*found.values()))
    return next((library for library in LIBRARIES if library in found), None)


def _library(kind: type[Any]) -> str | None:
    """The library that a class comes from, or that a class of the user's is made from."""
    for base in kind.__mro__:
        for library in LIBRARIES:
            if base.__module__ == library or base.__module__.startswith(f"{library}."):
                return library
    return None


def _apart(first: Any, second: Any, *_: Any) -> str:
    words = [f"{type(each).__module__.partition('.')[0]} {type(each).__name__}" for each in (first, second)]
    return f"{words[0]} and {words[1]} do not go together: give both as one of the two, or as NumPy arrays"


def _masked(ufunc: Any, *given: Any) -> Any:
    first, *others, where = given
    chosen = np.asarray(where)
    if chosen.size and chosen.dtype != bool:
        raise ValueError(f"where of dtype {chosen.dtype}: must be True, False or an array of them")
    # A NaN among the arguments is a NaN in every result, and a sum keeps the type of the argument: pandas, masked
    # arrays. Adding -0.0 changes no number, not even the sign of a zero.
    return ufunc(np.add(first, np.where(chosen, -0.0, np.nan)), *others)


def _dask(ufunc: Any, given: tuple[Any, ...], masked: bool) -> Any:
    # Neither library has types of its own for these.
    import dask.array as dask_array

    library: Any = dask_array
    arrays = [library.asarray(argument) for argument in given]
    most = max(array.ndim for array in arrays)
    labelled = [(array, tuple(range(most - array.ndim, most))) for array in arrays]
    _, arrays = library.unify_chunks(*(item for pair in labelled for item in pair))
    kinds = ufunc.types[0].partition("->")[2]
    dtypes = getattr(ufunc, "dtypes", None) or [np.dtype(kind) for kind in kinds]
    return library.apply_gufunc(
        partial(_masked, ufunc) if masked else ufunc,
        ",".join(["()"] * len(arrays)) + "->" + ",".join(["()"] * ufunc.nout),
        *arrays,
        output_dtypes=dtypes if ufunc.nout > 1 else dtypes[0],
    )


def _xarray(ufunc: Any, given: tuple[Any, ...], masked: bool) -> Any:
    import xarray

    def rows(*arrays: Any) -> Any:
        return apply(ufunc, *arrays[:-1], where=arrays[-1]) if masked else apply(ufunc, *arrays)

    # As for NumPy's own functions on xarray objects: attributes stay unless the user's option says otherwise.
    options: Any = xarray
    keep = options.get_options()["keep_attrs"]
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

        variable: Any = xarray.Variable
        if isinstance(part[0], xarray.Variable):
            return variable.concat(part, name)
        return xarray.concat(part, variable(name, list(labels)))
    if library == "dask.array":
        import dask.array as dask_array

        stack: Any = dask_array.stack
        return stack(part, axis=axis, allow_unknown_chunksizes=True)
    if any(isinstance(each, np.ma.MaskedArray) for each in part):
        return np.ma.stack(part, axis=axis)
    # NumPy's stack of np.matrix, which has never more than two dimensions, writes beyond its memory.
    return np.stack([np.asarray(each) for each in part], axis=axis)


def unindexed(argument: Any) -> Any:
    """A labelled index of pandas as an array: it does not take ufuncs of several outputs."""
    return np.asarray(argument) if hasattr(argument, "to_frame") and not hasattr(argument, "iloc") else argument
