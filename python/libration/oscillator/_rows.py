"""Duffing and cubic-quintic oscillators element by element: arrays of starts, coefficients and times.

Of the motions the call decides: a start and coefficients without dimensions are one oscillator, those with dimensions rows with
motions of their own. Source: as for `Duffing` and `CubicQuintic`.
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import Any, overload

import numpy as np

from .. import _core
from .._arrays import Floats, Labelled, Mask, Real, Scalar
from .._dispatch import Words, apply, has_dimensions
from .._labels import Result
from .._messages import explained
from ._knowledge import PHASE
from ._oscillator import MOTION, OscillatorRegime

PERIOD = Result("period", "s", "period")
FREQUENCY = Result("frequency", "rad/s", "mean angular frequency")
ACTION = Result("action", None, "action per unit mass")
ESCAPES = Result("escape_time_backward", "s", "escape behind"), Result("escape_time", "s", "escape ahead")
REGIME = Result("regime", None, "kind of motion")
_WORDS = Words(_core.duffing_regime, [regime.value for regime in OscillatorRegime])


@overload
def duffing_motion(
    t: Scalar,
    u0: Scalar,
    velocity0: Scalar = 0.0,
    p: Scalar = 1.0,
    q: Scalar = 1.0,
    *,
    r: Scalar = 0.0,
    c: Scalar = 0.0,
    out: None = None,
    where: bool = True,
) -> tuple[np.float64, np.float64]: ...
@overload
def duffing_motion(
    t: Real,
    u0: Real,
    velocity0: Real = 0.0,
    p: Real = 1.0,
    q: Real = 1.0,
    *,
    r: Real = 0.0,
    c: Real = 0.0,
    out: tuple[Floats, Floats] | None = None,
    where: Mask = True,
) -> tuple[Floats, Floats]: ...
@overload
def duffing_motion(
    t: Real | Labelled,
    u0: Real | Labelled,
    velocity0: Real | Labelled = 0.0,
    p: Real | Labelled = 1.0,
    q: Real | Labelled = 1.0,
    *,
    r: Real | Labelled = 0.0,
    c: Real | Labelled = 0.0,
    out: tuple[Labelled, Labelled] | None = None,
    where: Mask = True,
) -> tuple[Labelled, Labelled]: ...
@explained
def duffing_motion(
    t: Any,
    u0: Any,
    velocity0: Any = 0.0,
    p: Any = 1.0,
    q: Any = 1.0,
    *,
    r: Any = 0.0,
    c: Any = 0.0,
    out: Any = None,
    where: Any = True,
) -> Any:
    """Displacement and velocity of Duffing oscillators at the times `t`: ``(u, velocity)``.

    The solution of u'' + p u + r u**2 + q u**3 = c from the state (u0, velocity0) at t = 0, element by element.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN beyond an escape, and more than 2**53 half periods away.
    u0 : scalar or array
        Initial displacement, finite.
    velocity0 : scalar or array, default 0.0
        Initial velocity, finite.
    p, q : scalar or array, default 1.0
        Coefficients of the linear and the cubic force per unit mass, finite.
    r, c : scalar or array, default 0.0
        Coefficient of the quadratic force, and the constant one, finite.
    out : pair of ndarray, optional
        Where to put the results.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        A bad element gives NaN there and nowhere else. Dask and xarray arrays give their like, and stay lazy.

    Notes
    -----
    Error promised: that of `Duffing.u` and `Duffing.velocity`. Where neither the start nor a coefficient has dimensions, an oscillator
    is set up once and the digits are those of its methods. Else every element is computed from its own start, at vector speed; its
    digits do not depend on shape, order, strides or chunks. Source: DLMF 22.13(iii), 22.8.

    Examples
    --------
    >>> import libration
    >>> u, velocity = libration.duffing_motion(1.0, [0.5, 1.0, 2.0], 0.0, 1.0, -1.0)
    >>> print(u.round(6))
    [3.17963000e-01 1.00000000e+00 1.31264107e+03]
    """
    start = u0, velocity0, p, q, r, c
    kernel = _core.duffing_motion if _one_oscillator(*start) else _core.duffing_rows
    return apply(kernel, t, *start, results=MOTION, out=out, where=where)


def _one_oscillator(*start: Any) -> bool:
    """Whether neither the start nor a coefficient has dimensions."""
    return not any(type(each) is not float and has_dimensions(each) for each in start)


@explained
def cubic_quintic_motion(t: Any, u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """Displacement and velocity of cubic-quintic oscillators at the times `t`: ``(u, velocity)``.

    The solution of u'' + p u + q u**3 + s u**5 = 0 from the state (u0, velocity0) at t = 0, element by element.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN beyond an escape, and more than 2**53 half periods away.
    u0 : scalar or array
        Initial displacement, finite.
    velocity0 : scalar or array, default 0.0
        Initial velocity, finite.
    p, q, s : scalar or array
        Coefficients of the linear, the cubic and the quintic force per unit mass, finite.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        A bad element gives NaN there and nowhere else. Dask and xarray arrays give their like, and stay lazy.

    Notes
    -----
    Error promised: that of `CubicQuintic.u` and `CubicQuintic.velocity`. Where neither the start nor a coefficient has dimensions, an
    oscillator is set up once and the digits are those of its methods. Else every element is computed from its own start, at vector
    speed; its digits do not depend on shape, order, strides or chunks. Source: DLMF 22.13(iii), 22.8.

    Examples
    --------
    >>> import libration
    >>> libration.cubic_quintic_motion(1.0, [0.5, 1.0], p=1.0, q=1.0, s=1.0)[0].round(6)
    array([0.217924, 0.041949])
    """
    start = u0, velocity0, p, q, s
    kernel = _core.cubic_quintic_motion if _one_oscillator(*start) else _core.cubic_quintic_rows
    return apply(kernel, t, *start, results=MOTION)


@explained
def duffing_period(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, r: Any = 0.0, c: Any = 0.0) -> Any:
    """Period of Duffing oscillators, element by element: what `Duffing.period` is.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, r, c : scalar or array
        As for `Duffing`.

    Returns
    -------
    float64 or array of the broadcast shape
        In s; infinite where the motion does not repeat, NaN where an element is bad.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 19.8.5.

    Examples
    --------
    >>> import libration
    >>> libration.duffing_period([0.5, 1.0, 2.0], p=1.0, q=0.1).round(6)
    array([6.22514 , 6.060657, 5.516852])
    """
    return apply(_core.duffing_period, u0, velocity0, p, q, r, c, results=(PERIOD,))


@explained
def duffing_frequency(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, r: Any = 0.0, c: Any = 0.0) -> Any:
    """Mean angular frequency of Duffing oscillators, element by element: what `Duffing.frequency` is.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, r, c : scalar or array
        As for `Duffing`.

    Returns
    -------
    float64 or array of the broadcast shape
        In rad/s; 0 on a separatrix, NaN for a motion that does not stay.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: 2 pi over the period.

    Examples
    --------
    >>> import libration
    >>> libration.duffing_frequency([0.5, 1.0, 2.0], p=1.0, q=0.1).round(6)
    array([1.009324, 1.036717, 1.138908])
    """
    return apply(_core.duffing_frequency, u0, velocity0, p, q, r, c, results=(FREQUENCY,))


@explained
def duffing_action(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, r: Any = 0.0, c: Any = 0.0) -> Any:
    """Action of Duffing oscillators, element by element: what `Duffing.action` is.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, r, c : scalar or array
        As for `Duffing`.

    Returns
    -------
    float64 or array of the broadcast shape
        Per unit mass; NaN for a motion that does not stay.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: Parseval's sum of the Fourier series.

    Examples
    --------
    >>> import libration
    >>> libration.duffing_action([1.0, 2.0], p=1.0, q=1.0).round(6)
    array([0.636922, 3.73264 ])
    """
    return apply(_core.duffing_action, u0, velocity0, p, q, r, c, results=(ACTION,))


@explained
def duffing_phase(u: Any, velocity: Any = 0.0, *, p: Any, q: Any, r: Any = 0.0, c: Any = 0.0) -> Any:
    """Phase of Duffing oscillators in the states (u, velocity), element by element: what ``Duffing.phase(0)`` is.

    Parameters
    ----------
    u, velocity : scalar or array
        State, finite.
    p, q, r, c : scalar or array
        As for `Duffing`.

    Returns
    -------
    float64 or array of the broadcast shape
        In rad, in (-pi, pi]; NaN where the motion does not repeat.

    Notes
    -----
    Error promised: 4 ulp of pi. Source: DLMF 22.19(i).

    Examples
    --------
    >>> import libration
    >>> libration.duffing_phase([1.0, 0.0], [0.0, 1.0], p=1.0, q=1.0).round(6)
    array([ 0.      , -1.570796])
    """
    return apply(_core.duffing_phase, 0.0, u, velocity, p, q, r, c, results=(PHASE,))


@explained
def duffing_regime(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, r: Any = 0.0, c: Any = 0.0) -> Any:
    """Kind of motion of Duffing oscillators, element by element, as the words of `OscillatorRegime`.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, r, c : scalar or array
        As for `Duffing`.

    Returns
    -------
    str or array of the broadcast shape
        The word, decided without error for the doubles passed; empty where an element is bad.

    Examples
    --------
    >>> import libration
    >>> print(*libration.duffing_regime([0.0, 1.2, 2.0], p=-1.0, q=1.0, r=0.1))
    rest well libration
    """
    return apply(_WORDS, u0, velocity0, p, q, r, c, results=(REGIME,))


@explained
def duffing_escape_times(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, r: Any = 0.0, c: Any = 0.0) -> Any:
    """When Duffing oscillators come from infinity and escape to it, element by element: ``(backward, ahead)``.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, r, c : scalar or array
        As for `Duffing`.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        In s: below 0 or -inf, and above 0 or inf.

    Notes
    -----
    Error promised: 1e-14 relative, plus 2**-100 of its condition. Source: a pole of the motion, DLMF 22.4(i).

    Examples
    --------
    >>> import libration
    >>> libration.duffing_escape_times([1.1, 0.5], p=1.0, q=-1.0)[1].round(6)
    array([2.58573,     inf])
    """
    return apply(_core.duffing_escape_times, u0, velocity0, p, q, r, c, results=ESCAPES)
