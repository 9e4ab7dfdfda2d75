"""Carlson's symmetric elliptic integrals R_F, R_C, R_D and R_J of real arguments.

Every integral of a square root of a polynomial of degree three or four is made of them, without cases. Source: DLMF
19.16(i).
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from typing import Any, overload

import numpy as np

from .. import _core
from .._arrays import Floats, Labelled, Mask, Real, Scalar
from .._dispatch import apply
from .._labels import Result
from .._messages import explained

RF = Result("carlson_rf", "1", "Carlson's integral R_F")
RC = Result("carlson_rc", "1", "Carlson's integral R_C")
RD = Result("carlson_rd", "1", "Carlson's integral R_D")
RJ = Result("carlson_rj", "1", "Carlson's integral R_J")


@overload
def carlson_rf(x: Scalar, y: Scalar, z: Scalar, *, out: None = None, where: bool = True) -> np.float64: ...
@overload
def carlson_rf(x: Real, y: Real, z: Real, *, out: Floats | None = None, where: Mask = True) -> Floats: ...
@overload
def carlson_rf(
    x: Real | Labelled, y: Real | Labelled, z: Real | Labelled, *, out: Labelled | None = None, where: Mask = True
) -> Labelled: ...
@explained
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
    Error promised: 3 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.16.1.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rf(1.0, 2.0, 3.0):.8f}"
    '0.72694594'
    """
    return apply(_core.carlson_rf, x, y, z, results=(RF,), out=out, where=where)


@overload
def carlson_rc(x: Scalar, y: Scalar, *, out: None = None, where: bool = True) -> np.float64: ...
@overload
def carlson_rc(x: Real, y: Real, *, out: Floats | None = None, where: Mask = True) -> Floats: ...
@overload
def carlson_rc(
    x: Real | Labelled, y: Real | Labelled, *, out: Labelled | None = None, where: Mask = True
) -> Labelled: ...
@explained
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
    Error promised: 3 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.2.17, 19.2.20.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rc(1.0, -2.0):.8f}"
    '0.38017300'
    """
    return apply(_core.carlson_rc, x, y, results=(RC,), out=out, where=where)


@overload
def carlson_rd(x: Scalar, y: Scalar, z: Scalar, *, out: None = None, where: bool = True) -> np.float64: ...
@overload
def carlson_rd(x: Real, y: Real, z: Real, *, out: Floats | None = None, where: Mask = True) -> Floats: ...
@overload
def carlson_rd(
    x: Real | Labelled, y: Real | Labelled, z: Real | Labelled, *, out: Labelled | None = None, where: Mask = True
) -> Labelled: ...
@explained
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
    Error promised: 3 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.16.5.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rd(1.0, 2.0, 3.0):.8f}"
    '0.29046028'
    """
    return apply(_core.carlson_rd, x, y, z, results=(RD,), out=out, where=where)


@overload
def carlson_rj(x: Scalar, y: Scalar, z: Scalar, p: Scalar, *, out: None = None, where: bool = True) -> np.float64: ...
@overload
def carlson_rj(x: Real, y: Real, z: Real, p: Real, *, out: Floats | None = None, where: Mask = True) -> Floats: ...
@overload
def carlson_rj(
    x: Real | Labelled,
    y: Real | Labelled,
    z: Real | Labelled,
    p: Real | Labelled,
    *,
    out: Labelled | None = None,
    where: Mask = True,
) -> Labelled: ...
@explained
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
    Error promised: 3 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.16.2, 19.20.14.

    Examples
    --------
    >>> import libration
    >>> f"{libration.carlson_rj(1.0, 2.0, 3.0, -4.0):.8f}"
    '-0.23786769'
    """
    return apply(_core.carlson_rj, x, y, z, p, results=(RJ,), out=out, where=where)
