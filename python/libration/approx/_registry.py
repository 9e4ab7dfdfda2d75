"""A table of named formulas: called with a name it gives the formula, gone through it gives one formula an entry."""

from collections.abc import Callable, Iterator
from typing import Any, Generic, TypeVar

from .._immutable import public_names
from .._scalars import shown

Formula = TypeVar("Formula")


class Registry(Generic[Formula]):
    """A table of named formulas.

    Called with a name (``"linear"``, ``"fourier:4"``) it gives that formula, or a ``ValueError`` that names the nearest
    entries first. Gone through, it gives one formula an entry, with a usual N where the entry takes one.

    Parameters
    ----------
    make : callable
        Makes a formula of a name and of the options that the call takes.
    patterns : sequence of str
        The entries: ``name`` or ``name:N``.
    usual : dict
        N of the entries that take one, when they are gone through; and options, as a pair of N and a dict.

    Examples
    --------
    >>> from libration import approx
    >>> approx.angle("fourier:4").name
    'fourier:4'
    >>> approx.angle.names[:3]
    ('linear', 'harmonic', 'fourier:N')
    """

    def __init__(self, make: Callable[..., Formula], patterns: Any, usual: dict[str, Any]) -> None:
        self._make = make
        self._patterns = tuple(patterns)
        self._usual = usual

    @property
    def names(self) -> tuple[str, ...]:
        """What may be asked for: ``name``, ``name:N`` with a whole number, or ``name:H`` with a step in s."""
        return self._patterns

    def __call__(self, name: str, **options: Any) -> Formula:
        if not isinstance(name, str):
            raise ValueError(f"name = {shown(name)}: must be one of {', '.join(self._patterns)}")
        # What is no Unicode is shown, like any other name that is not known.
        return self._make(name.encode("utf-8", "backslashreplace").decode(), **options)

    def __iter__(self) -> Iterator[Formula]:
        for pattern in self._patterns:
            name, takes, _ = pattern.partition(":")
            order = self._usual[name] if takes else None
            order, options = order if isinstance(order, tuple) else (order, {})
            yield self._make(f"{name}:{order}" if takes else name, **options)

    def __len__(self) -> int:
        return len(self._patterns)

    def __dir__(self) -> list[str]:
        return public_names(self)

    def __repr__(self) -> str:
        return f"<Registry of {', '.join(self._patterns)}>"
