"""Carlson's symmetric elliptic integrals R_F, R_C, R_D and R_J of real arguments.

Every integral of a square root of a polynomial of degree three or four is made of them, without cases. Source: DLMF
19.16(i).
"""

from typing import Any

from .. import _core
from .._dispatch import apply


def carlson_rf(x: Any, y: Any, z: Any, *, out: Any = None, where: Any = True) -> Any:
    """Carlson's symmetric elliptic integral R_F.

    R_F(x, y, z) is half the integral of 1/sqrt((t + x)(t + y)(t + z)) over t > 0; the integral of the first kind.

    Parameters
    ----------
    x, y, z : scalars or arrays
        Not negative; two zeros give inf, an infinity 0, below zero NaN.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.16.1.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rf(1.0, 2.0, 3.0):.8f}"
    '0.72694594'
    """
    return apply(_core.carlson_rf, x, y, z, out=out, where=where)


def carlson_rc(x: Any, y: Any, *, out: Any = None, where: Any = True) -> Any:
    """Carlson's symmetric elliptic integral R_C.

    R_C(x, y) = R_F(x, y, y) is half the integral of 1/((t + y) sqrt(t + x)) over t > 0: arctangents and logarithms. For
    y < 0 Cauchy's principal value.

    Parameters
    ----------
    x : scalar or array
        Not negative, else NaN.
    y : scalar or array
        Any real number; 0 gives inf. An infinite argument gives 0.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.2.17, 19.2.20.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rc(1.0, -2.0):.8f}"
    '0.38017300'
    """
    return apply(_core.carlson_rc, x, y, out=out, where=where)


def carlson_rd(x: Any, y: Any, z: Any, *, out: Any = None, where: Any = True) -> Any:
    """Carlson's symmetric elliptic integral R_D.

    R_D(x, y, z) = R_J(x, y, z, z) is 3/2 of the integral of (t + z)**(-3/2)/sqrt((t + x)(t + y)) over t > 0; the integral
    of the second kind.

    Parameters
    ----------
    x, y, z : scalars or arrays
        Not negative; x = y = 0 or z = 0 gives inf, an infinity 0, below zero NaN.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.16.5.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rd(1.0, 2.0, 3.0):.8f}"
    '0.29046028'
    """
    return apply(_core.carlson_rd, x, y, z, out=out, where=where)


def carlson_rj(x: Any, y: Any, z: Any, p: Any, *, out: Any = None, where: Any = True) -> Any:
    """Carlson's symmetric elliptic integral R_J.

    R_J(x, y, z, p) is 3/2 of the integral of 1/((t + p) sqrt((t + x)(t + y)(t + z))) over t > 0; the integral of the third
    kind. For p < 0 Cauchy's principal value.

    Parameters
    ----------
    x, y, z : scalars or arrays
        Not negative; two zeros give inf (NaN for p < 0), below zero NaN.
    p : scalar or array
        Any real number; 0 gives inf. An infinite argument gives 0.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.16.2, 19.20.14.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rj(1.0, 2.0, 3.0, -4.0):.8f}"
    '-0.23786769'
    """
    return apply(_core.carlson_rj, x, y, z, p, out=out, where=where)
