"""Jacobi's elliptic functions and Legendre's integrals for any real parameter, by exactly one of three keywords.

``m`` is the parameter, ``mc = 1 - m`` its complement, ``k`` the modulus with m = k**2: nobody passes one for another
unnoticed, and `mc` keeps its digits where m is next to 1. Source: DLMF 19.2(ii), 22.2, 22.16(i).
"""

from typing import Any, NamedTuple

import numpy as np

from . import _core
from .dispatch import apply


class JacobiValues(NamedTuple):
    """The four values of `jacobi`, in this order."""

    sn: Any
    cn: Any
    dn: Any
    am: Any


_JACOBI = {"m": _core.jacobi_m, "mc": _core.jacobi_mc, "k": _core.jacobi_k}
_COMPLETE_K = {"m": _core.complete_k_m, "mc": _core.complete_k_mc, "k": _core.complete_k_k}
_COMPLETE_E = {"m": _core.complete_e_m, "mc": _core.complete_e_mc, "k": _core.complete_e_k}
_INCOMPLETE_F = {"m": _core.incomplete_f_m, "mc": _core.incomplete_f_mc, "k": _core.incomplete_f_k}
_INCOMPLETE_E = {"m": _core.incomplete_e_m, "mc": _core.incomplete_e_mc, "k": _core.incomplete_e_k}
_NOME = {"m": _core.nome_m, "mc": _core.nome_mc, "k": _core.nome_k}


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
    ufunc, parameter = _choose(_JACOBI, m, mc, k)
    return JacobiValues(*apply(ufunc, u, parameter, out=out, where=where))


def complete_k(*, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True) -> Any:
    """Legendre's complete elliptic integral of the first kind, K.

    K(m) is the integral of 1/sqrt(1 - m sin(x)**2) from 0 to pi/2, a quarter period of sn.

    Parameters
    ----------
    m, mc, k : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2). m = 1 gives inf, above 1 NaN.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the shape of the keyword's value

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.8, 19.8.5.

    Examples
    --------
    >>> import libration
    >>> f"{libration.complete_k(m=0.5):.8f} {libration.complete_k(mc=1e-300):.8f}"
    '1.85407468 346.77405831'
    """
    ufunc, parameter = _choose(_COMPLETE_K, m, mc, k)
    return apply(ufunc, parameter, out=out, where=where)


def complete_e(*, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True) -> Any:
    """Legendre's complete elliptic integral of the second kind, E.

    E(m) is the integral of sqrt(1 - m sin(x)**2) from 0 to pi/2.

    Parameters
    ----------
    m, mc, k : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2). Above m = 1: NaN.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the shape of the keyword's value

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.8, 19.25.1.

    Examples
    --------
    >>> import libration
    >>> f"{libration.complete_e(m=0.5):.8f}"
    '1.35064388'
    """
    ufunc, parameter = _choose(_COMPLETE_E, m, mc, k)
    return apply(ufunc, parameter, out=out, where=where)


def incomplete_f(phi: Any, *, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True) -> Any:
    """Legendre's incomplete elliptic integral of the first kind, F.

    F(phi | m) is the integral of 1/sqrt(1 - m sin(x)**2) from 0 to phi, the inverse of the amplitude.

    Parameters
    ----------
    phi : scalar or array
        Amplitude in rad, any real number while m < 1; beyond pi/2 infinite at m = 1.
    m, mc, k : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2, abs(k) <= 1e150). NaN where m sin(x)**2 exceeds 1 on
        the way.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.4, 19.25.5.

    Examples
    --------
    >>> import libration
    >>> f"{libration.incomplete_f(1.0, m=0.5):.8f}"
    '1.08321677'
    """
    ufunc, parameter = _choose(_INCOMPLETE_F, m, mc, k)
    return apply(ufunc, phi, parameter, out=out, where=where)


def incomplete_e(phi: Any, *, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True) -> Any:
    """Legendre's incomplete elliptic integral of the second kind, E(phi).

    E(phi | m) is the integral of sqrt(1 - m sin(x)**2) from 0 to phi.

    Parameters
    ----------
    phi : scalar or array
        Amplitude in rad, any real number while m <= 1.
    m, mc, k : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2, abs(k) <= 1e150). NaN where m sin(x)**2 exceeds 1 on
        the way.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.5, 19.25.9 to 19.25.11.

    Examples
    --------
    >>> import libration
    >>> f"{libration.incomplete_e(1.0, m=0.5):.8f}"
    '0.92732988'
    """
    ufunc, parameter = _choose(_INCOMPLETE_E, m, mc, k)
    return apply(ufunc, phi, parameter, out=out, where=where)


def nome(*, m: Any = None, mc: Any = None, k: Any = None, out: Any = None, where: Any = True) -> Any:
    """Nome q = exp(-pi K(1 - m)/K(m)) of the theta functions.

    Parameters
    ----------
    m, mc, k : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2). Above m = 1: NaN; below 0 the nome is
        negative.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the shape of the keyword's value

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 22.2.1.

    Examples
    --------
    >>> import libration
    >>> f"{libration.nome(m=0.5):.8f}"
    '0.04321392'
    """
    ufunc, parameter = _choose(_NOME, m, mc, k)
    return apply(ufunc, parameter, out=out, where=where)


def _choose(ufuncs: dict[str, np.ufunc], m: Any, mc: Any, k: Any) -> tuple[np.ufunc, Any]:
    """The ufunc of the keyword that was given, and its value."""
    given = [(name, value) for name, value in (("m", m), ("mc", mc), ("k", k)) if value is not None]
    if len(given) != 1:
        named = " and ".join(name for name, _ in given) or "none"
        raise ValueError(f"exactly one of m, mc and k must be given, not {named}")
    [(name, value)] = given
    return ufuncs[name], value
