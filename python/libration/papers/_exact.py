"""The exact solutions as the papers give them, errors corrected: Salas (22), (23), (24) and Juchem Neto's formula.

They keep the form of the papers, with its arctan or arcsin, in double arithmetic. They are right where the authors may
use them. Elsewhere they are wrong or have no value, and `libration.theta` is right (see _limit.py).
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any, overload

import numpy as np

from .._arrays import Floats, Labelled, Real, Scalar
from .._dispatch import apply
from .._labels import Result, like
from .._messages import explained
from ..elliptic import carlson_rf, dc, jacobi, jacobi_complex, nc, sc

ARGUMENTS = ("t", "theta0", "velocity0", "omega0")
THETA = Result("theta", "rad", "angle by the formula of a paper")


class Formula:
    """A formula of arrays of doubles for t, theta0, velocity0 and omega0, with what `apply` asks of a ufunc."""

    nout = 1
    types = ("dddd->d",)

    def __init__(self, formula: Callable[[Floats, Floats, Floats, Floats], Floats]) -> None:
        self.formula = formula

    def __call__(self, *arguments: Any) -> Any:
        given = [doubles(name, value) for name, value in zip(ARGUMENTS, arguments, strict=True)]
        # The doubles overflow to infinity and divide by zero as IEEE 754 says.
        with np.errstate(all="ignore"):
            if not any(hasattr(each, "iloc") or isinstance(each, np.ma.MaskedArray) for each in given):
                return self.formula(*given)
            # A sum has the labels or the mask that belong to all arguments. Adding -0.0 gives them to each argument and
            # changes no number, not even the sign of a zero.
            total = reduce(np.add, given)
            masked = isinstance(total, np.ma.MaskedArray)
            minus_zero = np.full(total.shape, -0.0)
            labelled = minus_zero if masked else like(total, minus_zero)
            plain = [np.asarray(np.add(each, labelled)) for each in given]
            values = self.formula(*plain)
        return np.ma.array(values, mask=np.ma.getmaskarray(total)) if masked else like(total, values)


def doubles(name: str, value: Any) -> Any:
    """An argument as doubles of NumPy; the labels of pandas and the mask of NumPy stay."""
    try:
        if hasattr(value, "iloc"):
            return like(value, value.to_numpy(dtype=float, na_value=np.nan))
        if isinstance(value, np.ma.MaskedArray):
            return value.astype(float)
        return np.asarray(value, dtype=float)[()]
    except OverflowError:
        raise ValueError(f"{name} = an integer beyond the doubles: must be finite") from None


@overload
def salas_22(t: Scalar, theta0: Scalar, velocity0: Scalar = 0.0, omega0: Scalar = 1.0) -> np.float64: ...
@overload
def salas_22(t: Real, theta0: Real, velocity0: Real = 0.0, omega0: Real = 1.0) -> Floats: ...
@overload
def salas_22(
    t: Real | Labelled,
    theta0: Real | Labelled,
    velocity0: Real | Labelled = 0.0,
    omega0: Real | Labelled = 1.0,
) -> Labelled: ...
@explained
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
        where theta0 is beyond pi. NaN where the arithmetic ends. Dask, xarray and pandas arrays give their like.

    Notes
    -----
    No error is promised: plain double. Source: Salas (22).

    Examples
    --------
    >>> from libration.papers import salas_22
    >>> f"{salas_22(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    return apply(Formula(_salas_22), t, theta0, velocity0, omega0, results=(THETA,))


def _salas_22(t: Floats, theta0: Floats, velocity0: Floats, omega0: Floats) -> Floats:
    half, rate = theta0 / 2, velocity0 / (2 * omega0)
    m = np.cos(half) ** 2 - rate**2
    sn, cn, dn = jacobi_complex(1j * np.asarray(omega0 * t), m=m)
    above = np.tan(half) * cn - 1j * rate / np.cos(half) ** 2 * dn * sn
    below = 1 + (rate**2 / np.cos(half) ** 2 - 1) * sn**2
    theta: Floats = 2 * np.arctan((above / below).real)
    return theta


@overload
def salas_23(t: Scalar, theta0: Scalar, velocity0: Scalar = 0.0, omega0: Scalar = 1.0) -> np.float64: ...
@overload
def salas_23(t: Real, theta0: Real, velocity0: Real = 0.0, omega0: Real = 1.0) -> Floats: ...
@overload
def salas_23(
    t: Real | Labelled,
    theta0: Real | Labelled,
    velocity0: Real | Labelled = 0.0,
    omega0: Real | Labelled = 1.0,
) -> Labelled: ...
@explained
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
        where theta0 is beyond pi. NaN where the arithmetic ends. Dask, xarray and pandas arrays give their like.

    Notes
    -----
    No error is promised: plain double. Source: Salas (23).

    Examples
    --------
    >>> from libration.papers import salas_23
    >>> f"{salas_23(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    return apply(Formula(_salas_23), t, theta0, velocity0, omega0, results=(THETA,))


def _salas_23(t: Floats, theta0: Floats, velocity0: Floats, omega0: Floats) -> Floats:
    half, rate = theta0 / 2, velocity0 / (2 * omega0)
    sn, cn, dn, _ = jacobi(omega0 * t, m=np.sin(half) ** 2 + rate**2)
    above = np.tan(half) * cn + rate / np.cos(half) ** 2 * dn * sn
    below = 1 - rate**2 / np.cos(half) ** 2 * sn**2
    theta: Floats = 2 * np.arctan(above / below)
    return theta


@overload
def salas_24(t: Scalar, theta0: Scalar, velocity0: Scalar = 0.0, omega0: Scalar = 1.0) -> np.float64: ...
@overload
def salas_24(t: Real, theta0: Real, velocity0: Real = 0.0, omega0: Real = 1.0) -> Floats: ...
@overload
def salas_24(
    t: Real | Labelled,
    theta0: Real | Labelled,
    velocity0: Real | Labelled = 0.0,
    omega0: Real | Labelled = 1.0,
) -> Labelled: ...
@explained
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
        beyond pi. NaN where the arithmetic ends: at the poles of nc, and late on the separatrix. Dask, xarray and pandas arrays give their like.

    Notes
    -----
    No error is promised: plain double. Source: Salas (24).

    Examples
    --------
    >>> from libration.papers import salas_24
    >>> f"{salas_24(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    return apply(Formula(_salas_24), t, theta0, velocity0, omega0, results=(THETA,))


def _salas_24(t: Floats, theta0: Floats, velocity0: Floats, omega0: Floats) -> Floats:
    u = omega0 * t
    m = (2 * (1 - np.cos(theta0)) + velocity0**2 / omega0**2) / 4
    above = 2 * omega0 * (omega0 * np.sin(theta0) * nc(u, m=m) + velocity0 * dc(u, m=m) * sc(u, m=m))
    rest = 2 * omega0**2 * (1 + np.cos(theta0))
    theta: Floats = 2 * np.arctan(above / (rest + (rest - velocity0**2) * sc(u, m=m) ** 2))
    return theta


@overload
def juchem_neto(t: Scalar, theta0: Scalar, velocity0: Scalar = 0.0, omega0: Scalar = 1.0) -> np.float64: ...
@overload
def juchem_neto(t: Real, theta0: Real, velocity0: Real = 0.0, omega0: Real = 1.0) -> Floats: ...
@overload
def juchem_neto(
    t: Real | Labelled,
    theta0: Real | Labelled,
    velocity0: Real | Labelled = 0.0,
    omega0: Real | Labelled = 1.0,
) -> Labelled: ...
@explained
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
        is wrong modulo 2 pi too; at theta0 = 0 it is NaN. Dask, xarray and pandas arrays give their like.

    Notes
    -----
    No error is promised: plain double. Source: Horsley (3), after J. P. Juchem Neto, arXiv 1007.4026.

    Examples
    --------
    >>> from libration.papers import juchem_neto
    >>> f"{juchem_neto(2.0, 1.0, 0.5):.9f}"
    '0.291045357'
    """
    return apply(Formula(_juchem_neto), t, theta0, velocity0, omega0, results=(THETA,))


def _juchem_neto(t: Floats, theta0: Floats, velocity0: Floats, omega0: Floats) -> Floats:
    half, rate = theta0 / 2, velocity0 / (2 * omega0)
    k = np.abs(np.sin(half))
    gamma0 = np.sqrt(1 + (rate / k) ** 2)
    m = (gamma0 * k) ** 2
    # F of an arcsine by DLMF 19.25.5: the two squares that cancel at the top are known without subtraction.
    start = carlson_rf(rate**2 / m, np.cos(half) ** 2, 1.0) / gamma0
    sense = np.where(rate > 0, 1.0, -1.0)
    sn = jacobi(start + sense * omega0 * t, m=m).sn
    # At the top gamma0 k sn is 1, give or take its rounding.
    theta: Floats = 2 * np.arcsin(np.clip(gamma0 * k * sn, -1, 1))
    return theta
