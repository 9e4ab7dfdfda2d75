"""What cubic-quintic oscillators know element by element: arrays of starts and coefficients. Source: as for `CubicQuintic`."""

from __future__ import annotations

from typing import Any

from .. import _core
from .._dispatch import Words, apply
from .._messages import explained
from ._knowledge import PHASE
from ._oscillator import OscillatorRegime
from ._rows import ACTION, ESCAPES, FREQUENCY, PERIOD, REGIME

_WORDS = Words(_core.cubic_quintic_regime, [regime.value for regime in OscillatorRegime])


@explained
def cubic_quintic_period(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """Period of cubic-quintic oscillators, element by element: what `CubicQuintic.period` is.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, s : scalar or array
        As for `CubicQuintic`, finite.

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
    >>> libration.cubic_quintic_period([0.5, 1.0, 2.0], p=1.0, q=1.0, s=1.0).round(6)
    array([5.678205, 4.123945, 1.748108])
    """
    return apply(_core.cubic_quintic_period, u0, velocity0, p, q, s, results=(PERIOD,))


@explained
def cubic_quintic_frequency(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """Mean angular frequency of cubic-quintic oscillators, element by element: what `CubicQuintic.frequency` is.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, s : scalar or array
        As for `CubicQuintic`, finite.

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
    >>> libration.cubic_quintic_frequency([0.5, 1.0, 2.0], p=1.0, q=1.0, s=1.0).round(6)
    array([1.106544, 1.523586, 3.594277])
    """
    return apply(_core.cubic_quintic_frequency, u0, velocity0, p, q, s, results=(FREQUENCY,))


@explained
def cubic_quintic_action(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """Action of cubic-quintic oscillators, element by element: what `CubicQuintic.action` is.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, s : scalar or array
        As for `CubicQuintic`, finite.

    Returns
    -------
    float64 or array of the broadcast shape
        Per unit mass; NaN for a motion that does not stay.

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: the trapezoidal rule for an analytic integrand.

    Examples
    --------
    >>> import libration
    >>> libration.cubic_quintic_action([1.0, 2.0], p=1.0, q=1.0, s=1.0).round(6)
    array([0.720253, 6.532465])
    """
    return apply(_core.cubic_quintic_action, u0, velocity0, p, q, s, results=(ACTION,))


@explained
def cubic_quintic_phase(u: Any, velocity: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """Phase of cubic-quintic oscillators in the states (u, velocity), element by element: what ``CubicQuintic.phase(0)`` is.

    Parameters
    ----------
    u, velocity : scalar or array
        State, finite.
    p, q, s : scalar or array
        As for `CubicQuintic`, finite.

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
    >>> libration.cubic_quintic_phase([1.0, 0.0], [0.0, 1.0], p=1.0, q=1.0, s=1.0).round(6)
    array([ 0.      , -1.570796])
    """
    return apply(_core.cubic_quintic_phase, 0.0, u, velocity, p, q, s, results=(PHASE,))


@explained
def cubic_quintic_regime(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """Kind of motion of cubic-quintic oscillators, element by element, as the words of `OscillatorRegime`.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, s : scalar or array
        As for `CubicQuintic`, finite.

    Returns
    -------
    str or array of the broadcast shape
        The word, decided without error for the doubles passed; empty where an element is bad.

    Examples
    --------
    >>> import libration
    >>> print(*libration.cubic_quintic_regime([0.0, 1.2, 2.0], p=-1.0, q=1.0, s=0.0))
    rest well libration
    """
    return apply(_WORDS, u0, velocity0, p, q, s, results=(REGIME,))


@explained
def cubic_quintic_escape_times(u0: Any, velocity0: Any = 0.0, *, p: Any, q: Any, s: Any) -> Any:
    """When cubic-quintic oscillators come from infinity and escape to it, element by element: ``(backward, ahead)``.

    Parameters
    ----------
    u0, velocity0 : scalar or array
        Start, finite.
    p, q, s : scalar or array
        As for `CubicQuintic`, finite.

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
    >>> libration.cubic_quintic_escape_times([1.1, 0.5], p=1.0, q=-1.0, s=0.0)[1].round(6)
    array([2.58573,     inf])
    """
    return apply(_core.cubic_quintic_escape_times, u0, velocity0, p, q, s, results=ESCAPES)
