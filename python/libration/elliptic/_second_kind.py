"""Jacobi's epsilon and zeta functions: the integral of the second kind in the argument u.

Source: DLMF 22.16(ii), 22.16(iii).
"""

from typing import Any

from ._parameter import function
from ._signatures import of_u

_JACOBI_EPSILON = function("jacobi_epsilon", "Jacobi's epsilon function")
_JACOBI_ZETA = function("jacobi_zeta", "Jacobi's zeta function")


@of_u
def jacobi_epsilon(
    u: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Jacobi's epsilon function, E(am u).

    epsilon(u | m) is the integral of dn**2 from 0 to u: Legendre's integral of the second kind in the argument u.

    Parameters
    ----------
    u : scalar or array
        Argument, any real number.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2): any finite real number, abs(k) <= 1e150; else NaN.
        Or the nome, abs(q) <= 0.985.
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
    Error promised: 3 (ulp + 2**-100 of the condition in u and the parameter). Source: DLMF 22.16.14, 22.16.17, 22.16.20.

    Examples
    --------
    >>> import libration
    >>> f"{libration.jacobi_epsilon(1.0, m=0.5):.8f} {libration.jacobi_epsilon(1.0, m=2.0):.8f}"
    '0.87227528 0.58904863'
    """
    return _JACOBI_EPSILON.of((u,), m, mc, k, out, where, q)


@of_u
def jacobi_zeta(
    u: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
) -> Any:
    """Jacobi's zeta function, the periodic part of epsilon.

    zeta(u | m) = epsilon(u | m) - u E/K, odd and of period 2 K; tanh(u) at m = 1.

    Parameters
    ----------
    u : scalar or array
        Argument, any real number; more than 2**100 half periods give NaN.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2); above m = 1 NaN. Or the nome, abs(q) <=
        0.985.
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
    Error promised: 3 (ulp + 2**-100 of the condition in u and the parameter), next to the zeros too. Source: DLMF 22.16.32.

    Examples
    --------
    >>> import libration
    >>> f"{libration.jacobi_zeta(1.0, m=0.5):.8f}"
    '0.14380199'
    """
    return _JACOBI_ZETA.of((u,), m, mc, k, out, where, q)
