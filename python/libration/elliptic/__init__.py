"""Elliptic functions and integrals of any real parameter, by exactly one of four keywords.

``m`` is the parameter, ``mc = 1 - m`` its complement, ``k`` the modulus with m = k**2, ``q`` the nome: nobody passes one for
another unnoticed, and `mc` keeps its digits where m is next to 1.

- ``jacobi``: sn, cn, dn and am together; ``jacobi_complex``: sn, cn, dn of a complex argument
- ``sn cn dn ns nc nd sc cs sd ds cd dc``, of complex arguments too, and their inverses ``arcsn`` to ``arcdc``
- ``jacobi_epsilon``, ``jacobi_zeta``; ``theta1`` to ``theta4``, ``nome``, ``from_nome``
- ``complete_k``, ``complete_e``, ``complete_pi``, ``incomplete_f``, ``incomplete_e``, ``incomplete_pi``, ``heuman_lambda``
- ``carlson_rf``, ``carlson_rc``, ``carlson_rd``, ``carlson_rj``

Source: DLMF chapters 19, 20 and 22.

Examples
--------
>>> from libration import elliptic
>>> f"{elliptic.sc(elliptic.arcsc(0.25, mc=1e-300), mc=1e-300):.8f}"
'0.25000000'
"""

from typing import TYPE_CHECKING, Any

from .._messages import no_member
from ._carlson import carlson_rc, carlson_rd, carlson_rf, carlson_rj
from ._glaisher import (
    arccd,
    arccn,
    arccs,
    arcdc,
    arcdn,
    arcds,
    arcnc,
    arcnd,
    arcns,
    arcsc,
    arcsd,
    arcsn,
    cd,
    cn,
    cs,
    dc,
    dn,
    ds,
    nc,
    nd,
    ns,
    sc,
    sd,
    sn,
)
from ._jacobi import JacobiComplexValues, JacobiValues, jacobi, jacobi_complex
from ._legendre import (
    complete_e,
    complete_k,
    complete_pi,
    heuman_lambda,
    incomplete_e,
    incomplete_f,
    incomplete_pi,
)
from ._second_kind import jacobi_epsilon, jacobi_zeta
from ._theta import from_nome, nome, theta1, theta2, theta3, theta4

__all__ = [
    "JacobiComplexValues",
    "JacobiValues",
    "arccd",
    "arccn",
    "arccs",
    "arcdc",
    "arcdn",
    "arcds",
    "arcnc",
    "arcnd",
    "arcns",
    "arcsc",
    "arcsd",
    "arcsn",
    "carlson_rc",
    "carlson_rd",
    "carlson_rf",
    "carlson_rj",
    "cd",
    "cn",
    "complete_e",
    "complete_k",
    "complete_pi",
    "cs",
    "dc",
    "dn",
    "ds",
    "from_nome",
    "heuman_lambda",
    "incomplete_e",
    "incomplete_f",
    "incomplete_pi",
    "jacobi",
    "jacobi_complex",
    "jacobi_epsilon",
    "jacobi_zeta",
    "nc",
    "nd",
    "nome",
    "ns",
    "sc",
    "sd",
    "sn",
    "theta1",
    "theta2",
    "theta3",
    "theta4",
]


def __dir__() -> list[str]:
    return __all__


# Hidden from type checkers, so that a name that does not exist is an error there too.
if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        """Python asks here for what it has not found."""
        raise no_member(__name__, name)
