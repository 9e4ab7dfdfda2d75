"""Jacobi's functions sn, cn, dn together: with the amplitude for real u, and for complex u.

Source: DLMF 22.2, 22.8.1 to 22.8.3, 22.16(i), 22.17.
"""

from typing import Any, NamedTuple

import numpy as np

from .._dispatch import apply
from ._parameter import chosen, ufuncs


class JacobiValues(NamedTuple):
    """The four values of `jacobi`, in this order."""

    sn: Any
    cn: Any
    dn: Any
    am: Any


class JacobiComplexValues(NamedTuple):
    """The three values of `jacobi_complex`, in this order."""

    sn: Any
    cn: Any
    dn: Any


_JACOBI = ufuncs("jacobi")


def jacobi(u: Any, *, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True) -> JacobiValues:
    """Jacobi's elliptic functions and amplitude, together: ``(sn, cn, dn, am)`` of u.

    am(u | m) is the integral of dn from 0 to u; sn = sin(am), cn = cos(am), dn**2 = 1 - m sn**2. For m < 1 the
    amplitude grows on without jumps, at m = 1 it is the gudermannian, for m > 1 it is bounded.

    Parameters
    ----------
    u : scalar or array
        Argument, any real number; more than 2**100 half periods give NaN. Infinite: the limits at m = 1, NaN
        elsewhere.
    m, mc, k : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2): any finite real number, abs(k) <= 1e150; else NaN.
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
        Unless exactly one of `m`, `mc` and `k` is given.

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
    ufunc, parameter = chosen(_JACOBI, m=m, mc=mc, k=k)
    return JacobiValues(*apply(ufunc, u, parameter, out=out, where=where))


class _Joined:
    """The ufunc of two real parts as one of complex results, with what `dispatch.apply` asks of a ufunc."""

    nout = 3
    types = ("ddd->DDD",)

    def __init__(self, ufunc: np.ufunc) -> None:
        self.ufunc = ufunc

    def __call__(self, *operands: Any, out: Any = None, where: Any = True) -> Any:
        if out is None:
            parts = self.ufunc(*operands, where=where)
            return tuple(_join(*parts[i : i + 2]) for i in (0, 2, 4))
        self.ufunc(*operands, out=tuple(part for whole in out for part in (whole.real, whole.imag)), where=where)
        return out


def _join(re: Any, im: Any) -> Any:
    """re + 1j im without arithmetic, which would make an infinity NaN."""
    whole = np.empty(np.shape(re), np.complex128)
    whole.real, whole.imag = re, im
    return whole[()]


_JACOBI_COMPLEX: Any = {keyword: _Joined(ufunc) for keyword, ufunc in ufuncs("jacobi_complex").items()}


def jacobi_complex(
    u: Any, *, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True
) -> JacobiComplexValues:
    """Jacobi's elliptic functions of a complex argument, together: ``(sn, cn, dn)`` of u.

    Doubly periodic for real m other than 0 and 1: sn, for 0 < m < 1, by 4 K and 2i K(1 - m).

    Parameters
    ----------
    u : scalar or array
        Argument, any complex number; real or imaginary part beyond 2**100 half periods give NaN.
    m, mc, k : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2): any finite real number, abs(k) <= 1e150; else NaN.
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
        Unless exactly one of `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in all arguments) for the real and the imaginary part of each. A
    pole, if a double ever meets one, has an infinite real part and NaN beside it. Source: DLMF 22.8.1 to 22.8.3, 22.17.

    Examples
    --------
    >>> import libration
    >>> values = libration.jacobi_complex(1 + 0.5j, m=0.5)
    >>> print(f"{values.sn:.6f} {values.cn:.6f} {values.dn:.6f}")
    0.891000+0.239754j 0.618716-0.345266j 0.805834-0.132547j
    """
    ufunc, parameter = chosen(_JACOBI_COMPLEX, m=m, mc=mc, k=k)
    number = u if hasattr(u, "real") else np.asarray(u)
    return JacobiComplexValues(*apply(ufunc, number.real, number.imag, parameter, out=out, where=where))
