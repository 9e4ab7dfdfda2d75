"""The parameter by exactly one keyword: ``m``, its complement ``mc = 1 - m``, the modulus ``k`` or the nome ``q``."""

from typing import Any

from .. import _core
from .._dispatch import PLAIN, apply
from .._labels import Result

# Which keyword is the only one that is not None, by whether each of m, mc, k and q is None.
ONLY = {tuple(other != index for other in range(4)): index for index in range(4)}


class Function:
    """A function with a ufunc for each keyword, which calls the one that was given."""

    def __init__(self, name: str, *results: Result, keywords: tuple[str, ...] = ("m", "mc", "k", "q")) -> None:
        self.keywords = keywords
        self.ufuncs: tuple[Any, ...] = tuple(
            getattr(_core, f"{name}_{keyword}", None) for keyword in ("m", "mc", "k", "q")
        )
        self.results = results

    def of(self, arguments: tuple[Any, ...], m: Any, mc: Any, k: Any, out: Any, where: Any, q: Any) -> Any:
        """The function of ``arguments`` and of the one of ``m``, ``mc``, ``k`` and ``q`` that is not None."""
        index = ONLY.get((m is None, mc is None, k is None, q is None))
        if index is None:
            *others, last = self.keywords
            given = {"m": m, "mc": mc, "k": k, "q": q}
            named = " and ".join(name for name in self.keywords if given[name] is not None) or "none"
            raise ValueError(f"exactly one of {', '.join(others)} and {last} must be given, not {named}")
        operands = (*arguments, (m, mc, k, q)[index])
        # What `apply` does first; a call more would cost a tenth of the time of one value.
        if where is True and PLAIN.issuperset(map(type, operands)):
            ufunc = self.ufuncs[index]
            return ufunc(*operands) if out is None else ufunc(*operands, out=out)
        return apply(self.ufuncs[index], *operands, results=self.results, out=out, where=where)


def function(name: str, meaning: str, keywords: tuple[str, ...] = ("m", "mc", "k", "q")) -> Function:
    """A function of one result, a number without units."""
    return Function(name, Result(name, "1", meaning), keywords=keywords)
