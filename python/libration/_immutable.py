"""Objects that do not change: set once, equal when made of the same numbers, and rebuilt from them bit for bit."""

from inspect import getattr_static
from typing import Any, NoReturn, Self


class Elsewhere:
    """An attribute of other books: its error names the one of this package.

    Unlike ``__getattr__``, which makes every attribute of a class slower, it costs nothing until it is asked for.
    """

    def __init__(self, meant: str) -> None:
        self.meant = meant
        self.__doc__ = f"Not here; see `{meant}`."

    def __set_name__(self, kind: type[Any], name: str) -> None:
        self.name = name

    def __get__(self, thing: object, kind: type[Any]) -> Self:
        if thing is None:
            return self
        raise AttributeError(f"a {kind.__name__} has no attribute {self.name!r}: did you mean {self.meant}?")


class Immutable:
    """An object whose attributes are set once, by the way it is made.

    A class says in `_arguments` what makes it again: equality, hash, repr, copies and pickles follow from it. A subclass
    of a user adds attributes, but no number: it is equal to what it was made from, and a pickle does not call its
    constructor, whose arguments may be others.
    """

    __slots__ = ("__weakref__",)

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """The positional and the keyword arguments that make it again."""
        raise NotImplementedError

    def _identity(self) -> tuple[Any, ...]:
        """What equality and hash go by."""
        positional, keyword = self._arguments()
        return (*positional, *keyword.values())

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change: cannot set {name}")

    def __delattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"a {type(self).__name__} does not change: cannot delete {name}")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Immutable) or _maker(type(self)) is not _maker(type(other)):
            return NotImplemented
        return self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __repr__(self) -> str:
        positional, keyword = self._arguments()
        shown = [repr(value) for value in positional] + [f"{name}={value!r}" for name, value in keyword.items()]
        return f"{type(self).__name__}({', '.join(shown)})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _rebuilt, (type(self), *self._arguments()), getattr(self, "__dict__", None) or None

    def __dir__(self) -> list[str]:
        return public_names(self)


def public_names(thing: object) -> list[str]:
    """The attributes of an object that are meant for users."""
    names = [name for name in object.__dir__(thing) if not name.startswith("_")]
    return [name for name in names if not isinstance(getattr_static(type(thing), name, None), Elsewhere)]


def _maker(kind: type[Any]) -> type[Any]:
    """The class of this package that a class is, or is made from."""
    return next(base for base in kind.__mro__ if base.__module__.partition(".")[0] == __package__)


def _rebuilt(kind: type[Any], positional: tuple[Any, ...], keyword: dict[str, Any]) -> Any:
    """What a pickle or a copy makes."""
    return _maker(kind).__new__(kind, *positional, **keyword)
