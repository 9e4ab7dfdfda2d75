"""The exact solutions as the papers give them, slips mended: Salas (22), (23), (24) and Juchem Neto's formula.

They are kept as they stand, arctan and arcsin included, in plain double: right where the authors may use them, and
wrong or without a value where `libration.theta` goes on (see _limit.py). Each takes arrays of times and states.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..elliptic import carlson_rf, dc, jacobi, jacobi_complex, nc, sc


def salas_22(t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0) -> Any:
    """Salas (22): the angle through Jacobi's functions of the imaginary argument i omega0 t.

    theta = 2 arctan((tan(theta0/2) cn - i x sec(theta0/2)**2 dn sn) / (1 + (x**2 sec(theta0/2)**2 - 1) sn**2)) with
    x = velocity0/(2 omega0) and parameter cos(theta0/2)**2 - x**2, which is the complement of that of (23).

    Parameters
    ----------
    t : scalar or array
        Time in s.
    theta0 : scalar or array
        Initial angle in rad, below pi in absolute value.
    velocity0, omega0 : scalar or array
        Initial angular velocity and angular frequency of small swings in rad/s.

    Returns
    -------
    float64 or array of the broadcast shape
        Angle in rad between -pi and pi: right in libration and on the separatrix; whole turns are lost in rotation, and
        where theta0 is beyond pi. NaN where the arithmetic ends.

    Notes
    -----
    No error is promised: plain double. Source: Salas (22).

    Examples
    --------
    >>> from libration.papers import salas_22
    >>> f"{salas_22(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    t, theta0, velocity0, omega0 = _doubles(t=t, theta0=theta0, velocity0=velocity0, omega0=omega0)
    with np.errstate(all="ignore"):
        half, rate = theta0 / 2, velocity0 / (2 * omega0)
        m = np.cos(half) ** 2 - rate**2
        sn, cn, dn = jacobi_complex(1j * np.asarray(omega0 * t), m=m)
        above = np.tan(half) * cn - 1j * rate / np.cos(half) ** 2 * dn * sn
        below = 1 + (rate**2 / np.cos(half) ** 2 - 1) * sn**2
        return 2 * np.arctan((above / below).real)


def salas_23(t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0) -> Any:
    """Salas (23): the angle through Jacobi's functions of omega0 t.

    theta = 2 arctan((tan(theta0/2) cn + x sec(theta0/2)**2 dn sn) / (1 - x**2 sec(theta0/2)**2 sn**2)) with
    x = velocity0/(2 omega0) and parameter m = sin(theta0/2)**2 + x**2.

    Parameters
    ----------
    t : scalar or array
        Time in s.
    theta0 : scalar or array
        Initial angle in rad, below pi in absolute value.
    velocity0, omega0 : scalar or array
        Initial angular velocity and angular frequency of small swings in rad/s.

    Returns
    -------
    float64 or array of the broadcast shape
        Angle in rad between -pi and pi: right in libration and on the separatrix; whole turns are lost in rotation, and
        where theta0 is beyond pi. NaN where the arithmetic ends.

    Notes
    -----
    No error is promised: plain double. Source: Salas (23).

    Examples
    --------
    >>> from libration.papers import salas_23
    >>> f"{salas_23(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    t, theta0, velocity0, omega0 = _doubles(t=t, theta0=theta0, velocity0=velocity0, omega0=omega0)
    with np.errstate(all="ignore"):
        half, rate = theta0 / 2, velocity0 / (2 * omega0)
        sn, cn, dn, _ = jacobi(omega0 * t, m=np.sin(half) ** 2 + rate**2)
        above = np.tan(half) * cn + rate / np.cos(half) ** 2 * dn * sn
        below = 1 - rate**2 / np.cos(half) ** 2 * sn**2
        return 2 * np.arctan(above / below)


def salas_24(t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0) -> Any:
    """Salas (24): the angle through nc, dc and sc of omega0 t.

    theta = 2 arctan(2 omega0 (omega0 sin(theta0) nc + velocity0 dc sc) / (c + (c - velocity0**2) sc**2)) with
    c = 2 omega0**2 (1 + cos(theta0)) and the parameter m of (23).

    Parameters
    ----------
    t : scalar or array
        Time in s.
    theta0 : scalar or array
        Initial angle in rad, of any size.
    velocity0, omega0 : scalar or array
        Initial angular velocity and angular frequency of small swings in rad/s.

    Returns
    -------
    float64 or array of the broadcast shape
        Angle in rad between -pi and pi: right in libration; whole turns are lost in rotation, and where theta0 is
        beyond pi. NaN where the arithmetic ends: at the poles of nc, and late on the separatrix.

    Notes
    -----
    No error is promised: plain double. Source: Salas (24).

    Examples
    --------
    >>> from libration.papers import salas_24
    >>> f"{salas_24(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    t, theta0, velocity0, omega0 = _doubles(t=t, theta0=theta0, velocity0=velocity0, omega0=omega0)
    with np.errstate(all="ignore"):
        u = omega0 * t
        m = (2 * (1 - np.cos(theta0)) + velocity0**2 / omega0**2) / 4
        above = 2 * omega0 * (omega0 * np.sin(theta0) * nc(u, m=m) + velocity0 * dc(u, m=m) * sc(u, m=m))
        rest = 2 * omega0**2 * (1 + np.cos(theta0))
        return 2 * np.arctan(above / (rest + (rest - velocity0**2) * sc(u, m=m) ** 2))


def juchem_neto(t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0) -> Any:
    """Juchem Neto's formula as Horsley gives it in (3), with its two slips mended.

    theta = 2 arcsin(gamma0 k sn(F(arcsin(1/gamma0) | gamma0**2 k**2) + H omega0 t | gamma0**2 k**2)) with
    k = abs(sin(theta0/2)), whose square Horsley calls k, gamma0**2 = 1 + velocity0**2 / (4 omega0**2 k**2), and
    H = 1 for velocity0 > 0, else -1.

    Parameters
    ----------
    t : scalar or array
        Time in s.
    theta0 : scalar or array
        Initial angle in rad, between 0 and pi, both excluded.
    velocity0, omega0 : scalar or array
        Initial angular velocity and angular frequency of small swings in rad/s.

    Returns
    -------
    float64 or array of the broadcast shape
        Angle in rad between -pi and pi: right for 0 < theta0 < pi in libration and on the separatrix. For theta0 < 0 it
        is the motion from -theta0; in rotation the arcsin folds it back at every second passage over the top, which
        is wrong modulo 2 pi too; at theta0 = 0 it is NaN.

    Notes
    -----
    No error is promised: plain double. Source: Horsley (3), after J. P. Juchem Neto, arXiv 1007.4026.

    Examples
    --------
    >>> from libration.papers import juchem_neto
    >>> f"{juchem_neto(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    t, theta0, velocity0, omega0 = _doubles(t=t, theta0=theta0, velocity0=velocity0, omega0=omega0)
    with np.errstate(all="ignore"):
        half, rate = theta0 / 2, velocity0 / (2 * omega0)
        k = np.abs(np.sin(half))
        gamma0 = np.sqrt(1 + (rate / k) ** 2)
        m = (gamma0 * k) ** 2
        # F of an arcsine by DLMF 19.25.5: the two squares that cancel at the top are known without subtraction.
        start = carlson_rf(rate**2 / m, np.cos(half) ** 2, 1.0) / gamma0
        sense = np.where(rate > 0, 1.0, -1.0)
        sn = jacobi(start + sense * omega0 * t, m=m).sn
        # At the top gamma0 k sn is 1, give or take its rounding.
        return 2 * np.arcsin(np.clip(gamma0 * k * sn, -1, 1))


def _doubles(**arguments: Any) -> Iterator[Any]:
    """The arguments as doubles of NumPy, whose arithmetic overflows to infinity and divides by zero as IEEE 754 says."""
    for name, value in arguments.items():
        try:
            yield np.asarray(value, dtype=float)[()]
        except OverflowError:
            raise ValueError(f"{name} = an integer beyond the doubles: must be finite") from None
