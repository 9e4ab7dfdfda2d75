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
        found = None
        for name in given:
            if given[name] is not None:
                if found is not None:
                    raise _several(given)
                found = name
        if found is None:
            raise _several(given)
        return apply(self.ufuncs[found], *arguments, given[found], results=self.results, out=out, where=where)


def _several(given: dict[str, Any]) -> ValueError:
    """The error of none of the keywords, or of more than one."""
    *others, last = given
    named = " and ".join(name for name in given if given[name] is not None) or "none"
    return ValueError(f"exactly one of {', '.join(others)} and {last} must be given, not {named}")


def function(name: str, meaning: str, keywords: tuple[str, ...] = ("m", "mc", "k")) -> Function:
    """A function of one result, a number without units."""
    return Function(name, Result(name, "1", meaning), keywords=keywords)
