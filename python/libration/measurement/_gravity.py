"""g from one period by the exact law, and the normal g of a place."""

import json
import math
import warnings
from typing import Any

from .. import _core
from .._scalars import real, shown
from ._columns import measure
from ._estimate import Estimate, estimate
from ._known import Pair


def gravity_of_period(period: Any, length: Any, *, swing: Any = 0.0, end: Any = None) -> Estimate:
    """g of a pendulum from its period, by the exact law of large swings.

    g = length (P/period)**2, where P = 4 K(sin(swing/2)) is the exact period at omega0 = 1. Where the swing decays while periods are
    counted, 1/P is its mean over the time in which linear friction brings the swing from the first angle to that at the end.

    Parameters
    ----------
    period : scalar or (value, u)
        In s, greater than 0, with its standard uncertainty.
    length : scalar or (value, u)
        The equivalent length in m, greater than 0.
    swing : scalar or (value, u), default 0.0
        The turning angle in rad, below pi in size; 0 for small swings.
    end : scalar or (value, u), optional
        The turning angle at the end of the count, where the swing decays: both are then above 0, and `period` is the mean.

    Returns
    -------
    Estimate
        g in m/s**2. Its uncertainty combines them (GUM 5.1); that of a swing is half the difference between its two ends.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Source: the period DLMF 22.19.5; the uncertainty JCGM 100:2008, 5.1.

    Examples
    --------
    >>> import math
    >>> import libration
    >>> print(libration.gravity_of_period((2.0218, 0.001), (1.0, 0.001), swing=math.radians(20)))
    9.807 ± 0.014
    >>> swings = {"swing": math.radians(40), "end": math.radians(20)}
    >>> print(libration.gravity_of_period((2.0396, 0.001), (1.0, 0.001), **swings))
    9.810 ± 0.014
    """
    (value, u), _, _ = _core.gravity_of_period(
        measure("period", period),
        measure("length", length),
        measure("swing", swing),
        None if end is None else measure("end", end),
    )
    return Estimate(value, u, calibration=u)


def gravity_of_pivots(periods: Any, distances: Any, *, between: Any = None, swings: Any = (0.0, 0.0)) -> Estimate:
    """g of a reversible pendulum from its periods about two pivots, as Bessel evaluates Kater's.

    8 pi**2/g = (T1**2 + T2**2)/(d1 + d2) + (T1**2 - T2**2)/(d1 - d2), where T are the periods of small swings.

    Parameters
    ----------
    periods : (first, second)
        In s, each a scalar or (value, u).
    distances : (first, second)
        Of the pivots from the centre of mass in m, each a scalar or (value, u).
    between : scalar or (value, u), optional
        The distance between the pivots in m, in place of the second of `distances`: it is measured better.
    swings : (first, second), optional
        Turning angles in rad, each a scalar or (value, u), by which the periods are reduced to those of small swings.

    Returns
    -------
    Estimate
        g in m/s**2; `statistical` is the part of the periods, `calibration` that of the distances.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    A g that is not of this Earth is a UserWarning. Source: F. W. Bessel, Untersuchungen ueber die Laenge des einfachen Secundenpendels (1828).

    Examples
    --------
    >>> import libration
    >>> periods = [(2.0061, 1e-4), (2.0063, 1e-4)]
    >>> print(libration.gravity_of_pivots(periods, [(0.66, 0.002)], between=(1.0001, 1e-5)))
    9.8127 ± 0.0023
    """
    found, grades = _core.gravity_of_pivots(*pivots_of(periods, distances, between, swings), between is not None)
    told = json.loads(found)
    for sentence, _ in zip(told["verdicts"], grades, strict=True):
        warnings.warn(sentence, UserWarning, stacklevel=2)
    made = estimate(told["g"])
    assert made is not None
    return made


def pivots_of(periods: Any, distances: Any, between: Any, swings: Any) -> tuple[list[Pair], list[Pair]]:
    """The periods of small swings, and the distances, as pairs."""
    wanted = 1 if between is not None else 2
    lengths = {"periods": 2, "distances": wanted, "swings": 2}
    for name, given in (("periods", periods), ("distances", distances), ("swings", swings)):
        if not hasattr(given, "__len__") or len(given) not in (lengths[name], 2):
            raise ValueError(f"{name} = {shown(given)}: must be two, of the first and of the second pivot")
    reduced = [small_period(measure("periods", t), measure("swings", a)) for t, a in zip(periods, swings, strict=True)]
    second = distances[1] if between is None else between
    return reduced, [measure("distances", distances[0]), measure("distances" if between is None else "between", second)]


def small_period(period: Pair, swing: Pair) -> Pair:
    """The period of small swings of the same pendulum: that of g and length 1 is as 1/sqrt(g)."""
    (large, u), _, small = _core.gravity_of_period(period, (1.0, 0.0), swing)
    factor = math.sqrt(small / large)
    return period[0] * factor, period[0] * factor * u / (2 * large)


def normal_gravity(latitude: float, height: float = 0.0) -> float:
    """The normal g of a place: that of the ellipsoid WGS 84 by Somigliana's formula, with the height to second order.

    Parameters
    ----------
    latitude : scalar
        Geodetic, in rad, from -pi/2 to pi/2.
    height : scalar, default 0.0
        Above the ellipsoid in m, from -12,000 to 100,000.

    Returns
    -------
    float
        In m/s**2. Local masses move the true g by some 0.0005, seldom by more than 0.002.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Source: NIMA TR 8350.2 (2000), equations 4-1 and 4-3.

    Examples
    --------
    >>> import math
    >>> import libration
    >>> f"{libration.normal_gravity(math.radians(45), 300.0):.5f}"
    '9.80527'
    """
    return _core.normal_gravity(real("latitude", latitude), real("height", height))
