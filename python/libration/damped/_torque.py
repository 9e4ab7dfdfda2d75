"""The torque that drives a pendulum, per unit inertia."""

from __future__ import annotations

from typing import Any, Self, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Labelled, Scalar
from .._dispatch import Elementwise, apply, numbers
from .._immutable import Immutable
from .._labels import Result
from .._messages import explained
from .._scalars import real, shown

TORQUE = Result("torque", "rad/s**2", "torque per unit inertia")


class Torque(Immutable):
    """Torque constant + amplitude cos(frequency t + phase) + samples, per unit inertia.

    Parameters
    ----------
    constant : scalar, default 0.0
        In rad/s**2, finite.
    amplitude : scalar, default 0.0
        In rad/s**2, finite.
    frequency : scalar, default 0.0
        Angular frequency in rad/s, finite.
    phase : scalar, default 0.0
        In rad at t = 0, finite.
    samples : pair of arrays, optional
        Times in s, rising, at least two, and as many values in rad/s**2. The motion is NaN outside of them; t = 0 must lie among
        them.
    interpolation : {"lines", "steps", "cubics"}
        What the torque is between samples: straight lines; the last sample; cubic polynomials whose slope at a sample is that of
        the parabola through it and its neighbours.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Does not change; hashable, and equal where all arguments are. The polynomials are taken without error.

    Examples
    --------
    >>> import libration
    >>> libration.Torque(constant=0.5, amplitude=2.0, frequency=3.0).at([0.0, 1.0]).round(6)
    array([ 2.5     , -1.479985])
    >>> f"{libration.Torque(samples=([0.0, 1.0, 3.0], [0.0, 2.0, 4.0])).at(2.0)}"
    '3.0'
    """

    __slots__ = ("_interpolation", "_samples", "_terms")

    _terms: tuple[float, float, float, float]
    _samples: tuple[tuple[float, ...], tuple[float, ...]] | None
    _interpolation: str

    @explained
    def __new__(
        cls,
        *,
        constant: float = 0.0,
        amplitude: float = 0.0,
        frequency: float = 0.0,
        phase: float = 0.0,
        samples: tuple[Any, Any] | None = None,
        interpolation: str = "lines",
    ) -> Self:
        names = {"constant": constant, "amplitude": amplitude, "frequency": frequency, "phase": phase}
        self = super().__new__(cls)
        object.__setattr__(self, "_terms", tuple(real(name, value) for name, value in names.items()))
        object.__setattr__(self, "_samples", None if samples is None else _columns(samples))
        object.__setattr__(self, "_interpolation", str(interpolation))
        _core.torque_at(*self._operands(), np.empty(0))
        return self

    @overload
    def at(self, t: Scalar) -> np.float64: ...
    @overload
    def at(self, t: Array) -> Floats: ...
    @overload
    def at(self, t: Labelled) -> Labelled: ...
    def at(self, t: Any) -> Any:
        """Torque at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s. Not finite, and outside of the samples, gives NaN.

        Returns
        -------
        float64 or array of the shape of `t`
            In rad/s**2. Dask, xarray and pandas arrays give their like.

        Examples
        --------
        >>> import libration
        >>> f"{libration.Torque(amplitude=2.0, frequency=3.0).at(1.0):.6f}"
        '-1.979985'
        """
        return apply(Elementwise(lambda times: _core.torque_at(*self._operands(), times)), t, results=(TORQUE,))

    def _operands(self) -> tuple[tuple[float, ...], tuple[np.ndarray, np.ndarray, str] | None]:
        """What the core makes this torque of."""
        if self._samples is None:
            return self._terms, None
        times, values = map(np.array, self._samples)
        return self._terms, (times, values, self._interpolation)

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        given: dict[str, Any] = dict(zip(("constant", "amplitude", "frequency", "phase"), self._terms, strict=True))
        if self._samples is not None:
            given |= {"samples": self._samples, "interpolation": self._interpolation}
        return (), given

    def _identity(self) -> tuple[Any, ...]:
        return (*self._terms, self._samples, self._interpolation if self._samples else "")


def _columns(samples: Any) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Times and values as tuples of floats, so that they do not change."""
    try:
        times, values = samples
    except (TypeError, ValueError):
        raise ValueError(f"samples = {shown(samples)}: must be a pair of times and values") from None
    columns = []
    for name, column in (("times", times), ("values", values)):
        try:
            array = np.asarray(numbers(column))
        except (TypeError, ValueError):
            raise ValueError(f"{name} of samples = {shown(column)}: must be real numbers") from None
        if array.ndim != 1:
            raise ValueError(f"{name} of samples = {shown(column)}: must have one dimension")
        columns.append(tuple(array.tolist()))
    return columns[0], columns[1]
