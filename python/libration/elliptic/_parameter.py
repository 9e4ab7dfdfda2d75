"""The parameter by exactly one keyword: ``m``, its complement ``mc = 1 - m``, the modulus ``k`` or the nome ``q``.

For Jacobi's functions a parameter without dimensions is set up once for all arguments, and one with dimensions is answered row by
row, as all other functions are. The call decides, so a value does not depend on chunks.
"""

from typing import Any

from .. import _core
from .._dispatch import PLAIN, apply, has_dimensions
from .._labels import Result

# Which keyword is the only one that is not None, by whether each of m, mc, k and q is None.
ONLY = {tuple(other != index for other in range(4)): index for index in range(4)}


class Function:
    """A function with a ufunc for each keyword, which calls the one that was given: of one parameter, or of rows of them."""

    def __init__(self, name: str, *results: Result, keywords: tuple[str, ...] = ("m", "mc", "k", "q")) -> None:
        self.keywords = keywords
        self.ufuncs = _ufuncs(name)
        rows = _ufuncs(f"{name}_rows")
        self.rows = rows if any(rows) else None
        self.results = results

    def of(self, arguments: tuple[Any, ...], m: Any, mc: Any, k: Any, out: Any, where: Any, q: Any) -> Any:
        """The function of ``arguments`` and of the one of ``m``, ``mc``, ``k`` and ``q`` that is not None."""
        index = ONLY.get((m is None, mc is None, k is None, q is None))
        if index is None:
            *others, last = self.keywords
            given = {"m": m, "mc": mc, "k": k, "q": q}
            named = " and ".join(name for name in self.keywords if given[name] is not None) or "none"
            raise ValueError(f"exactly one of {', '.join(others)} and {last} must be given, not {named}")
        parameter = (m, mc, k, q)[index]
        ufunc = self.ufuncs[index]
        if self.rows is not None and type(parameter) is not float and has_dimensions(parameter):
            ufunc = self.rows[index]
        operands = (*arguments, parameter)
        # What `apply` does first; a call more would cost a tenth of the time of one value.
        if where is True and PLAIN.issuperset(map(type, operands)):
            return ufunc(*operands) if out is None else ufunc(*operands, out=out)
        return apply(ufunc, *operands, results=self.results, out=out, where=where)


def _ufuncs(name: str) -> tuple[Any, ...]:
    """The ufunc of each keyword, None where there is none."""
    return tuple(getattr(_core, f"{name}_{keyword}", None) for keyword in ("m", "mc", "k", "q"))


def function(name: str, meaning: str, keywords: tuple[str, ...] = ("m", "mc", "k", "q")) -> Function:
    """A function of one result, a number without units."""
    return Function(name, Result(name, "1", meaning), keywords=keywords)
