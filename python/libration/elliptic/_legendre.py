"""Legendre's elliptic integrals of the three kinds, complete and incomplete, and Heuman's lambda.

Source: DLMF 19.2(ii); Byrd & Friedman 150.03 for Heuman's lambda.
"""

from typing import Any

from ._parameter import function
from ._signatures import of_n, of_n_and_phi, of_parameter, of_phi

_COMPLETE_K = function("complete_k", "complete elliptic integral of the first kind")
_COMPLETE_E = function("complete_e", "complete elliptic integral of the second kind")
_COMPLETE_PI = function("complete_pi", "complete elliptic integral of the third kind")
_INCOMPLETE_F = function("incomplete_f", "incomplete elliptic integral of the first kind")
_INCOMPLETE_E = function("incomplete_e", "incomplete elliptic integral of the second kind")
_INCOMPLETE_PI = function("incomplete_pi", "incomplete elliptic integral of the third kind")
_HEUMAN_LAMBDA = function("heuman_lambda", "Heuman's lambda function")


@of_parameter
def complete_k(
    *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Legendre's complete elliptic integral of the first kind, K.

    K(m) is the integral of 1/sqrt(1 - m sin(x)**2) from 0 to pi/2, a quarter period of sn.

    Parameters
    ----------
    m, mc, k, q : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2). m = 1 gives inf, above 1 NaN. Or the nome,
        abs(q) <= 0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.8, 19.8.5.

    Examples
    --------
    >>> import libration
    >>> f"{libration.complete_k(m=0.5):.8f} {libration.complete_k(mc=1e-300):.8f}"
    '1.85407468 346.77405831'
    """
    return _COMPLETE_K.of((), m, mc, k, out, where, q)


@of_parameter
def complete_e(
    *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Legendre's complete elliptic integral of the second kind, E.

    E(m) is the integral of sqrt(1 - m sin(x)**2) from 0 to pi/2.

    Parameters
    ----------
    m, mc, k, q : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2). Above m = 1: NaN. Or the nome, abs(q) <=
        0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.8, 19.25.1.

    Examples
    --------
    >>> import libration
    >>> f"{libration.complete_e(m=0.5):.8f}"
    '1.35064388'
    """
    return _COMPLETE_E.of((), m, mc, k, out, where, q)


@of_n
def complete_pi(
    n: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Legendre's complete elliptic integral of the third kind, Pi(n).

    Pi(n | m) is the integral of 1/((1 - n sin(x)**2) sqrt(1 - m sin(x)**2)) from 0 to pi/2, for n > 1 Cauchy's principal
    value.

    Parameters
    ----------
    n : scalar or array
        Characteristic, any real number; n = 1 gives inf. The sign is that of DLMF, where n = alpha**2.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter < 1, its complement 1 - m > 0, or the modulus (m = k**2). m = 1 gives inf, -inf for n > 1; above 1
        NaN. Or the nome, abs(q) <= 0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 (ulp + 2**-100 of the condition in n and the parameter). Source: DLMF 19.2.8, 19.6.5, 19.25.2.

    Examples
    --------
    >>> import libration
    >>> f"{libration.complete_pi(0.3, m=0.5):.8f} {libration.complete_pi(3.0, m=0.5):.8f}"
    '2.25037682 -0.19298821'
    """
    return _COMPLETE_PI.of((n,), m, mc, k, out, where, q)


@of_phi
def incomplete_f(
    phi: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Legendre's incomplete elliptic integral of the first kind, F.

    F(phi | m) is the integral of 1/sqrt(1 - m sin(x)**2) from 0 to phi, the inverse of the amplitude.

    Parameters
    ----------
    phi : scalar or array
        Amplitude in rad, any real number while m < 1; beyond pi/2 infinite at m = 1.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2, abs(k) <= 1e150). NaN where m sin(x)**2 exceeds 1 on
        the way. Or the nome, abs(q) <= 0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.4, 19.25.5.

    Examples
    --------
    >>> import libration
    >>> f"{libration.incomplete_f(1.0, m=0.5):.8f}"
    '1.08321677'
    """
    return _INCOMPLETE_F.of((phi,), m, mc, k, out, where, q)


@of_phi
def incomplete_e(
    phi: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Legendre's incomplete elliptic integral of the second kind, E(phi).

    E(phi | m) is the integral of sqrt(1 - m sin(x)**2) from 0 to phi.

    Parameters
    ----------
    phi : scalar or array
        Amplitude in rad, any real number while m <= 1.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2, abs(k) <= 1e150). NaN where m sin(x)**2 exceeds 1 on
        the way. Or the nome, abs(q) <= 0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 ulp. Source: DLMF 19.2.5, 19.25.9 to 19.25.11.

    Examples
    --------
    >>> import libration
    >>> f"{libration.incomplete_e(1.0, m=0.5):.8f}"
    '0.92732988'
    """
    return _INCOMPLETE_E.of((phi,), m, mc, k, out, where, q)


@of_n_and_phi
def incomplete_pi(
    n: Any, phi: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Legendre's incomplete elliptic integral of the third kind, Pi(n; phi).

    Pi(n; phi | m) is the integral of 1/((1 - n sin(x)**2) sqrt(1 - m sin(x)**2)) from 0 to phi, Cauchy's principal value
    where n sin(x)**2 passes 1.

    Parameters
    ----------
    n : scalar or array
        Characteristic, any real number. The sign is that of DLMF, where n = alpha**2.
    phi : scalar or array
        Amplitude in rad, any real number while m < 1; beyond pi/2 infinite at m = 1 and at n = 1.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2, abs(k) <= 1e150). NaN where m sin(x)**2 exceeds 1 on
        the way. Or the nome, abs(q) <= 0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 (ulp + 2**-100 of the condition in all arguments). Source: DLMF 19.2.7, 19.7.8 to 19.7.10, 19.25.14.

    Examples
    --------
    >>> import libration
    >>> f"{libration.incomplete_pi(0.3, 1.0, m=0.5):.8f}"
    '1.19232544'
    """
    return _INCOMPLETE_PI.of((n, phi), m, mc, k, out, where, q)


@of_phi
def heuman_lambda(
    phi: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Heuman's lambda function, Lambda_0(phi).

    Lambda_0(phi | m) = 2/pi (E(m) F(phi | 1 - m) + K(m) (E(phi | 1 - m) - F(phi | 1 - m))): odd in phi, 1 at pi/2, and
    growing by 2 with every pi. The solid angle of a disc is made of it.

    Parameters
    ----------
    phi : scalar or array
        Angle in rad, any real number.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter in [0, 1], its complement 1 - m, or the modulus (m = k**2); else NaN. The sine at m = 0 up to pi/2, 2
        phi/pi at m = 1. Or the nome, abs(q) <= 0.985.
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
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 3 (ulp + 2**-100 of the condition in phi and the parameter). Source: Byrd & Friedman, Handbook of
    Elliptic Integrals, 150.03; Abramowitz & Stegun 17.4.39.

    Examples
    --------
    >>> import libration
    >>> f"{libration.heuman_lambda(1.0, m=0.5):.8f}"
    '0.74740064'
    """
    return _HEUMAN_LAMBDA.of((phi,), m, mc, k, out, where, q)
