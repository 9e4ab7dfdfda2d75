"""g from one period by the exact law, and the normal g of a place."""

from typing import Any

from .. import _core
from .._scalars import real
from ._columns import measure
from ._estimate import Estimate


def gravity_of_period(period: Any, length: Any, *, swing: Any = 0.0) -> Estimate:
    """g of a pendulum from its period, by the exact law of large swings.

    g = length (P/period)**2, where P = 4 K(sin(swing/2)) is the exact period at omega0 = 1.

    Parameters
    ----------
    period : scalar or (value, u)
        In s, greater than 0, with its standard uncertainty.
    length : scalar or (value, u)
        The equivalent length in m, greater than 0.
    swing : scalar or (value, u), default 0.0
        The turning angle in rad, below pi in size; 0 for small swings.

    Returns
    -------
    Estimate
        g in m/s**2. Its uncertainty combines the three (GUM 5.1); that of the swing is half the difference between its two ends.

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
    """
    (value, u), _, _ = _core.gravity_of_period(
        measure("period", period), measure("length", length), measure("swing", swing)
    )
    return Estimate(value, u, calibration=u)


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
