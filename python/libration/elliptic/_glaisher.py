"""Glaisher's twelve functions pq(u | m) = pr/qr, of complex u too, and their inverses arcpq(x | m): one table, two templates.

p and q are letters of s, c, d, n, and sn, cn, dn, nn = 1 the functions above and below the line. Source: DLMF 22.2.10,
22.15.
"""

from typing import TYPE_CHECKING, Any

from .._labels import Result
from ._complex import Joined, is_complex, parts
from ._parameter import Function, function
from ._signatures import of_any_u, of_x

if TYPE_CHECKING:
    from ._signatures import OfAnyU, OfX

_FUNCTION = """Jacobi's elliptic function {name}(u | m) = {quotient}.

    {nature}

    Parameters
    ----------
    u : scalar or array
        Argument, any real or complex number; more than 2**100 half periods give NaN. Infinite: the limit at m = 1 of a real
        one, NaN elsewhere.
    m, mc, k, q : scalar or array, exactly one of them
        Parameter, its complement 1 - m, or the modulus (m = k**2): any finite real number, abs(k) <= 1e150; else NaN.
        Or the nome, abs(q) <= 0.985.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the broadcast shape, complex128 where `u` is complex

    Raises
    ------
    ValueError
        Unless exactly one of `m`, `mc`, `k` and `q` is given.

    Notes
    -----
    Error promised: 5 (ulp + 2**-100 of the condition in u and the parameter), next to zeros and poles too; of a complex one
    for the real and the imaginary part each. An exact pole of a complex u is infinite in the real part, with NaN beside it.
    Source: DLMF {source}, 22.8.1 to 22.8.3, 22.17.

    Examples
    --------
    >>> from libration import elliptic
    >>> f"{{elliptic.{name}(1.0, m=0.5):.8f}}"
    '{example}'
    """

_INVERSE = """Inverse of Jacobi's elliptic function {name}: the u with {name}(u | m) = x on the principal branch.

    {branch}

    Parameters
    ----------
    x : scalar or array
        Value of {name}: {domain}; else NaN.
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
    Error promised: 5 (ulp + 2**-100 of the condition in x and the parameter); at an end of the range, where the
    condition is infinite, 5 ulp. Source: DLMF {source}, 19.25.28 to 19.25.34.

    Examples
    --------
    >>> from libration import elliptic
    >>> f"{{elliptic.arc{name}({x}, m=0.5):.8f}}"
    '{example}'
    """

_ODD = "Odd in u."
_POLE = "Odd in u, with a pole at 0: {name}(0.0) is inf, {name}(-0.0) is -inf."
_EVEN = "Even in u, 1 at 0."
_LEAST = "The least u >= 0{range}."
_AROUND = "Odd in x: u in [-K, K] for m < 1, in [-K(1/m)/k, K(1/m)/k] for m > 1."

# name: the function for u = 1, m = 0.5; of the inverse the real domain, an x and its u for m = 0.5; equations of both.
_TABLE = {
    "sn": ("sin(am u)", "0.80300182", "abs(x) <= 1, abs(x) <= 1/k for m > 1", 0.5, "0.53562273", "22.2.4", "22.15.12"),
    "cn": (
        "cos(am u)",
        "0.59597657",
        "-1 <= x <= 1, for m >= 1 sqrt(1 - 1/m) <= x <= 1",
        0.5,
        "1.14242906",
        "22.2.5",
        "22.15.13",
    ),
    "dn": (
        "d(am u)/du",
        "0.82316100",
        "between 1 and sqrt(1 - m), -1 <= x <= 1 for m > 1",
        0.8,
        "1.09967548",
        "22.2.6",
        "22.15.14",
    ),
    "ns": ("1/sn", "1.24532718", "abs(x) >= 1, abs(x) >= k for m > 1", 2.0, "0.53562273", "22.2.4", "22.15.21"),
    "nc": (
        "1/cn",
        "1.67791832",
        "abs(x) >= 1, for m >= 1 1 <= x <= 1/sqrt(1 - 1/m)",
        2.0,
        "1.14242906",
        "22.2.5",
        "22.15.19",
    ),
    "nd": (
        "1/dn",
        "1.21482917",
        "between 1 and 1/sqrt(1 - m), abs(x) >= 1 for m > 1",
        1.2,
        "0.95789780",
        "22.2.6",
        "22.15.17",
    ),
    "sc": (
        "sn/cn",
        "1.34737147",
        "any real number, abs(x) <= 1/sqrt(m - 1) for m > 1",
        0.5,
        "0.47198952",
        "22.2.9",
        "22.15.20",
    ),
    "cs": (
        "cn/sn",
        "0.74218582",
        "any real number, abs(x) >= sqrt(m - 1) for m > 1",
        0.5,
        "1.21904616",
        "22.2.9",
        "22.15.23",
    ),
    "sd": (
        "sn/dn",
        "0.97551004",
        "abs(x) <= 1/sqrt(1 - m), any real number for m >= 1",
        0.5,
        "0.50078638",
        "22.2.7",
        "22.15.16",
    ),
    "ds": (
        "dn/sn",
        "1.02510477",
        "abs(x) >= sqrt(1 - m), any real number for m >= 1",
        2.0,
        "0.50078638",
        "22.2.7",
        "22.15.22",
    ),
    "cd": ("cn/dn", "0.72400972", "-1 <= x <= 1, abs(x) >= 1 for m > 1", 0.5, "1.31845194", "22.2.8", "22.15.15"),
    "dc": ("dn/cn", "1.38119692", "abs(x) >= 1, -1 <= x <= 1 for m > 1", 2.0, "1.31845194", "22.2.8", "22.15.18"),
}


def _function(name: str) -> "OfAnyU":
    """pq of the table."""
    pq_of = function(name, f"Jacobi's elliptic function {name}")
    complex_of = Function(f"{name}_complex", Result(name, "1", f"Jacobi's elliptic function {name}"))
    complex_of.ufuncs = tuple(map(Joined, complex_of.ufuncs))
    quotient, example, *_, source, _ = _TABLE[name]

    def pq(
        u: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
    ) -> Any:
        if is_complex(u):
            return complex_of.of(parts(u), m, mc, k, out, where, q)
        return pq_of.of((u,), m, mc, k, out, where, q)

    nature = _ODD if name[0] == "s" else _POLE.format(name=name) if name[1] == "s" else _EVEN
    pq.__name__ = pq.__qualname__ = name
    pq.__doc__ = _FUNCTION.format(name=name, quotient=quotient, nature=nature, source=source, example=example)
    return of_any_u(pq)


def _inverse(name: str) -> "OfX":
    """arcpq of the table."""
    arcpq_of = function(f"arc{name}", f"inverse of Jacobi's elliptic function {name}")
    _, _, domain, x, example, _, source = _TABLE[name]

    def arcpq(
        x: Any, *, m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True
    ) -> Any:
        return arcpq_of.of((x,), m, mc, k, out, where, q)

    branch = _AROUND if "s" in name else _LEAST.format(range=": in [0, K] for m < 1" if name in ("dn", "nd") else "")
    arcpq.__name__ = arcpq.__qualname__ = f"arc{name}"
    arcpq.__doc__ = _INVERSE.format(name=name, branch=branch, domain=domain, x=x, source=source, example=example)
    return of_x(arcpq)


sn = _function("sn")
cn = _function("cn")
dn = _function("dn")
ns = _function("ns")
nc = _function("nc")
nd = _function("nd")
sc = _function("sc")
cs = _function("cs")
sd = _function("sd")
ds = _function("ds")
cd = _function("cd")
dc = _function("dc")
arcsn = _inverse("sn")
arccn = _inverse("cn")
arcdn = _inverse("dn")
arcns = _inverse("ns")
arcnc = _inverse("nc")
arcnd = _inverse("nd")
arcsc = _inverse("sc")
arccs = _inverse("cs")
arcsd = _inverse("sd")
arcds = _inverse("ds")
arccd = _inverse("cd")
arcdc = _inverse("dc")
