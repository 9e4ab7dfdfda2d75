"""Jacobi's functions sn, cn, dn together: with the amplitude for real u, and for complex u.

Source: DLMF 22.2, 22.8.1 to 22.8.3, 22.16(i), 22.17.
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from typing import Any, Generic, NamedTuple, TypeVar, overload

import numpy as np

from .._arrays import Complex, Floats, Labelled, Mask, NDArray, Real, Scalar
from .._labels import Result
from .._messages import explained
from ._complex import Joined, parts
from ._parameter import Function

Value = TypeVar("Value")


class JacobiValues(NamedTuple, Generic[Value]):
    """The values sn, cn, dn and am of `jacobi`, in this order.

    Examples
    --------
    >>> from libration import elliptic
    >>> sn, cn, dn, am = elliptic.jacobi(1.0, m=0.5)
    >>> f"{am:.6f}"
    '0.932315'
    """

    sn: Value
    cn: Value
    dn: Value
    am: Value


class JacobiComplexValues(NamedTuple, Generic[Value]):
    """The values sn, cn and dn of `jacobi_complex`, in this order.

    Examples
    --------
    >>> from libration import elliptic
    >>> elliptic.jacobi_complex(1j, m=0.5)._fields
    ('sn', 'cn', 'dn')
    """

    sn: Value
    cn: Value
    dn: Value


_SN = Result("sn", "1", "Jacobi's elliptic function sn")
_CN = Result("cn", "1", "Jacobi's elliptic function cn")
_DN = Result("dn", "1", "Jacobi's elliptic function dn")
_JACOBI = Function("jacobi", _SN, _CN, _DN, Result("am", "rad", "Jacobi's amplitude"))


@overload
def jacobi(
    u: Scalar,
    *,
    m: Scalar | None = None,
    mc: Scalar | None = None,
    k: Scalar | None = None,
    q: Scalar | None = None,
    out: None = None,
    where: bool = True,
) -> JacobiValues[np.float64]: ...
@overload
def jacobi(
    u: Real,
    *,
    m: Real | None = None,
    mc: Real | None = None,
    k: Real | None = None,
    q: Real | None = None,
    out: tuple[Floats, Floats, Floats, Floats] | None = None,
    where: Mask = True,
) -> JacobiValues[Floats]: ...
@overload
def jacobi(
    u: Real | Labelled,
    *,
    m: Real | Labelled | None = None,
    mc: Real | Labelled | None = None,
    k: Real | Labelled | None = None,
    q: Real | Labelled | None = None,
    out: tuple[Labelled, Labelled, Labelled, Labelled] | None = None,
    where: Mask = True,
) -> JacobiValues[Labelled]: ...
@explained
def jacobi(
    u: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> JacobiValues[Any]:
    """Jacobi's elliptic functions and amplitude, together: ``(sn, cn, dn, am)`` of u.

    am(u | m) is the integral of dn from 0 to u; sn = sin(am), cn = cos(am), dn**2 = 1 - m sn**2. For m < 1 the
    amplitude grows on without jumps, at m = 1 it is the gudermannian, for m > 1 it is bounded.

    Parameters
    ----------
    u : scalar or array
        Argument, any real number; more than 2**100 half periods give NaN. Infinite: the limits at m = 1, NaN
        elsewhere.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2): any finite real number, abs(k) <= 1e150; else NaN.
        Or the nome, abs(q) <= 0.985.
    out : four ndarrays, optional
        Where to put the results.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    JacobiValues
        The four values, float64 or arrays of the broadcast shape. Dask and xarray arrays give their like.

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 (ulp + 2**-100 abs(u d/du)) for each of the four. Source: DLMF 22.2, 22.16(i), 22.17(i).

    Examples
    --------
    >>> import libration
    >>> values = libration.jacobi(1.0, m=0.5)
    >>> print(f"{values.sn:.6f} {values.cn:.6f} {values.dn:.6f} {values.am:.6f}")
    0.803002 0.595977 0.823161 0.932315
    """
    return JacobiValues(*_JACOBI.of((u,), m, mc, k, out, where, q))


_JACOBI_COMPLEX = Function("jacobi_complex", _SN, _CN, _DN)
_JACOBI_COMPLEX.ufuncs = tuple(map(Joined, _JACOBI_COMPLEX.ufuncs))


@overload
def jacobi_complex(
    u: complex | np.complexfloating[Any, Any],
    *,
    m: Scalar | None = None,
    mc: Scalar | None = None,
    k: Scalar | None = None,
    q: Scalar | None = None,
    out: None = None,
    where: bool = True,
) -> JacobiComplexValues[np.complex128]: ...
@overload
def jacobi_complex(
    u: Complex,
    *,
    m: Real | None = None,
    mc: Real | None = None,
    k: Real | None = None,
    q: Real | None = None,
    out: tuple[NDArray[np.complex128], NDArray[np.complex128], NDArray[np.complex128]] | None = None,
    where: Mask = True,
) -> JacobiComplexValues[NDArray[np.complex128]]: ...
@overload
def jacobi_complex(
    u: Complex | Labelled,
    *,
    m: Real | Labelled | None = None,
    mc: Real | Labelled | None = None,
    k: Real | Labelled | None = None,
    q: Real | Labelled | None = None,
    out: tuple[Labelled, Labelled, Labelled] | None = None,
    where: Mask = True,
) -> JacobiComplexValues[Labelled]: ...
@explained
def jacobi_complex(
    u: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> JacobiComplexValues[Any]:
    """Jacobi's elliptic functions of a complex argument, together: ``(sn, cn, dn)`` of u.

    Doubly periodic for real m other than 0 and 1: sn, for 0 < m < 1, by 4 K and 2i K(1 - m).

    Parameters
    ----------
    u : scalar or array
        Argument, any complex number; real or imaginary part beyond 2**100 half periods give NaN.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2): any finite real number, abs(k) <= 1e150; else NaN.
        Or the nome, abs(q) <= 0.985.
    out : three ndarrays, optional
        Where to put the results, complex.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    JacobiComplexValues
        The three values, complex128 or arrays of the broadcast shape. Dask and xarray arrays give their like.

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 (ulp + 2**-100 of the condition in all arguments) for the real and the imaginary part of each. A
    pole, if a double ever meets one, has an infinite real part and NaN beside it. Source: DLMF 22.8.1 to 22.8.3, 22.17.

    Examples
    --------
    >>> import libration
    >>> values = libration.jacobi_complex(1 + 0.5j, m=0.5)
    >>> print(f"{values.sn:.6f} {values.cn:.6f} {values.dn:.6f}")
    0.891000+0.239754j 0.618716-0.345266j 0.805834-0.132547j
    """
    return JacobiComplexValues(*_JACOBI_COMPLEX.of(parts(u), m, mc, k, out, where, q))
