"""Jacobi's theta functions of real argument and real nome, and the nome.

The four differ in their series alone, so one template serves them. Source: DLMF 20.2(i), 22.2.1.
"""

from typing import TYPE_CHECKING, Any

from .. import _core
from .._dispatch import apply
from .._labels import Result
from ._parameter import function
from ._signatures import of_nome, of_parameter, of_z

if TYPE_CHECKING:
    from ._signatures import OfZ

_NOME = function("nome", "nome")


@of_parameter
def nome(*, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True) -> Any:
    """Nome q = exp(-pi K(1 - m)/K(m)) of the theta functions.

    Parameters
    ----------
    m, mc, k, q : scalar or array, exactly one of them
        Parameter <= 1, its complement 1 - m >= 0, or the modulus (m = k**2). Above m = 1: NaN; below 0 the nome is
        negative. Or the nome, abs(q) <= 0.985.
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
    Error promised: 3 ulp. Source: DLMF 22.2.1.

    Examples
    --------
    >>> import libration
    >>> f"{libration.nome(m=0.5):.8f}"
    '0.04321392'
    """
    return _NOME.of((), m, mc, k, out, where, q)


_FROM_NOME = Result("m", "1", "parameter"), Result("mc", "1", "complement of the parameter")


@of_nome
def from_nome(q: Any, *, out: Any = None, where: Any = True) -> Any:
    """Parameter m and its complement 1 - m of the nome q: ``(m, mc)``.

    The inverse of `nome`: m = (theta2/theta3)**4, 1 - m = (theta4/theta3)**4 of z = 0. Both are given because the smaller
    of them has digits that the other has not.

    Parameters
    ----------
    q : scalar or array
        Nome, -1 < q <= 1, negative for m < 0; else NaN.
    out : pair of ndarray, optional
        Where to put the results.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the shape of `q`

    Notes
    -----
    Error promised: 3 (ulp + 2**-100 of the condition in q). Source: DLMF 22.2.2, 20.7.3.

    Examples
    --------
    >>> import libration
    >>> m, mc = libration.from_nome(0.1)
    >>> m.round(9), mc.round(9), libration.nome(m=m).round(9)
    (np.float64(0.802403298), np.float64(0.197596702), np.float64(0.1))
    """
    return apply(_core.from_nome, q, results=_FROM_NOME, out=out, where=where)


_DOCUMENT = """Jacobi's theta function theta_{index}(z, q).

    {series}

    Parameters
    ----------
    z : scalar or array
        Argument in rad, any finite real number.
    q, m, mc, k : scalar or array, exactly one of them
        Nome {nome}; or what makes it: parameter, {parameter}, complement 1 - m, modulus (m = k**2). Else NaN.
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
        Unless exactly one of `q`, `m`, `mc` and `k` is given.

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in z and the keyword), next to the zeros and for q next to 1 too.
    Source: DLMF {source}.

    Examples
    --------
    >>> import libration
    >>> f"{{libration.theta{index}(1.0, q=0.1):.8f}}"
    '{example}'
    """

# index: series, DLMF, theta(1, q = 0.1)
_THETAS = {
    1: ("2 sum over n >= 0 of (-1)**n q**((n + 1/2)**2) sin((2 n + 1) z).", "20.2.1", "0.94479959"),
    2: ("2 sum over n >= 0 of q**((n + 1/2)**2) cos((2 n + 1) z).", "20.2.2", "0.59653467"),
    3: ("1 + 2 sum over n >= 1 of q**(n**2) cos(2 n z).", "20.2.3", "0.91663991"),
    4: ("1 + 2 sum over n >= 1 of (-1)**n q**(n**2) cos(2 n z).", "20.2.4", "1.08309864"),
}


def _theta(index: int) -> "OfZ":
    """The function of one index."""
    theta_of = function(f"theta{index}", f"Jacobi's theta function {index}", ("q", "m", "mc", "k"))
    series, source, example = _THETAS[index]

    def theta(
        z: Any,
        *,
        q: Any = None,
        m: Any = None,
        mc: Any = None,
        k: Any = None,
        out: Any = None,
        where: Any = True,
    ) -> Any:
        return theta_of.of((z,), m, mc, k, out, where, q)

    theta.__name__ = theta.__qualname__ = f"theta{index}"
    theta.__doc__ = _DOCUMENT.format(
        index=index,
        series=series,
        source=source,
        example=example,
        nome="in [0, 1)" if index < 3 else "in (-1, 1)",
        parameter="in [0, 1)" if index < 3 else "below 1",
    )
    return of_z(theta)


theta1 = _theta(1)
theta2 = _theta(2)
theta3 = _theta(3)
theta4 = _theta(4)
