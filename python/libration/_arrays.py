"""What functions take and give, as type checkers see it: numbers give `float64`, arrays give arrays, labels stay."""

from collections.abc import Sequence
from typing import Any, Protocol, TypeAlias, TypeVar

import numpy as np

Number = TypeVar("Number", bound=np.generic)
# That of numpy.typing, whose import takes as long as a tenth of this package.
NDArray: TypeAlias = np.ndarray[tuple[Any, ...], np.dtype[Number]]

Scalar: TypeAlias = float | np.floating[Any] | np.integer[Any]
Array: TypeAlias = (
    NDArray[np.floating[Any] | np.integer[Any] | np.bool]
    | Sequence[Scalar]
    | Sequence[Sequence[Scalar]]
    | Sequence[NDArray[Any]]
)
Real: TypeAlias = Scalar | Array
Complex: TypeAlias = complex | np.complexfloating[Any, Any] | NDArray[np.number[Any] | np.bool] | Sequence[complex]
Floats: TypeAlias = NDArray[np.float64]
Mask: TypeAlias = Any
Intervals: TypeAlias = tuple[tuple[float, float], ...]


class Named(Protocol):
    """An array of xarray."""

    @property
    def dims(self) -> Any: ...


class Indexed(Protocol):
    """A series or a table of pandas."""

    @property
    def iloc(self) -> Any: ...


class Chunked(Protocol):
    """An array of Dask."""

    @property
    def chunks(self) -> Any: ...


Labelled = TypeVar("Labelled", bound=Named | Indexed | Chunked)
# What can hold a matrix an element: a series of pandas cannot.
Stacked = TypeVar("Stacked", bound=Named | Chunked)
