"""The results of three papers about the pendulum, checked: Salas 2019, Lima 2019, Horsley 2025.

`salas_22`, `salas_23`, `salas_24` and `juchem_neto` are their exact solutions, corrected; `limits` lists where they fail.
`errata` lists every wrong line with its correction and a check that only the correction passes. `claims` lists every
numerical claim with the value measured here. `pictures` draws every figure. Their approximations are in `libration.approx`.

Examples
--------
>>> from libration import papers
>>> f"{papers.salas_23(1.0, 1.0):.9f} {papers.salas_23(7.0, 1.0, 3.0):.9f}"
'0.600085366 1.634282841'
"""

from ._claim import Claim, Verdict
from ._erratum import Erratum, Kind
from ._exact import juchem_neto, salas_22, salas_23, salas_24
from ._limit import Limit, limits
from ._picture import Picture
from ._works import claims, errata, pictures

__all__ = [
    "Claim",
    "Erratum",
    "Kind",
    "Limit",
    "Picture",
    "Verdict",
    "claims",
    "errata",
    "juchem_neto",
    "limits",
    "pictures",
    "salas_22",
    "salas_23",
    "salas_24",
]


def __dir__() -> list[str]:
    return __all__
