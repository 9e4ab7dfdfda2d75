"""The parameter by exactly one keyword: ``m``, its complement ``mc = 1 - m``, the modulus ``k`` or the nome ``q``."""

from typing import Any

from .. import _core
from .._dispatch import apply
from .._labels import Result


class Function:
    """A function with a ufunc for each keyword, which calls the one that was given."""

    def __init__(self, name: str, *results: Result, keywords: tuple[str, ...] = ("m", "mc", "k")) -> None:
        self.ufuncs: dict[str, Any] = {keyword: getattr(_core, f"{name}_{keyword}") for keyword in keywords}
        self.results = results

    def __call__(self, *arguments: Any, out: Any, where: Any, **given: Any) -> Any:
        found = [name for name in given if given[name] is not None]
        if len(found) != 1:
            *others, last = given
            named = " and ".join(found) or "none"
            raise ValueError(f"exactly one of {', '.join(others)} and {last} must be given, not {named}")
        name = found[0]
        return apply(self.ufuncs[name], *arguments, given[name], results=self.results, out=out, where=where)


def function(name: str, meaning: str, keywords: tuple[str, ...] = ("m", "mc", "k")) -> Function:
    """A function of one result, a number without units."""
    return Function(name, Result(name, "1", meaning), keywords=keywords)
