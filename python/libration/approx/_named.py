"""What every named formula knows of itself before it is asked anything."""

from typing import Any, Protocol

from .._immutable import Immutable
from .._scalars import shown
from ..pendulum import Pendulum


class Core(Protocol):
    """The compiled formula behind a named one."""

    @property
    def name(self) -> str: ...
    @property
    def facts(self) -> tuple[str, str, str, str, tuple[float, float] | None, str]: ...


class Named(Immutable):
    """A formula of a registry: its name, its source, and where it is meant to hold."""

    __slots__ = ("_formula",)

    _formula: Core

    @property
    def name(self) -> str:
        """The name that finds it again, with its N."""
        return self._formula.name

    @property
    def pattern(self) -> str:
        """Its entry: the name, with ``:N`` if it takes a number."""
        return self._formula.facts[0]

    @property
    def formula(self) -> str:
        """The formula in one line."""
        return self._formula.facts[1]

    @property
    def source(self) -> str:
        """Author, year and equation."""
        return self._formula.facts[2]

    @property
    def stated(self) -> str:
        """The range its author offers it for, in words; empty where none is stated."""
        return self._formula.facts[3]

    @property
    def stated_range(self) -> tuple[float, float] | None:
        """The same as angles in rad."""
        return self._formula.facts[4]

    @property
    def undefined(self) -> str:
        """Where it has no value, in words."""
        return self._formula.facts[5]

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.name,), {}


def moving(pendulum: Any) -> Pendulum:
    """A pendulum, or the refusal of anything else."""
    if not isinstance(pendulum, Pendulum):
        raise ValueError(f"pendulum = {shown(pendulum)}: must be a Pendulum")
    return pendulum
