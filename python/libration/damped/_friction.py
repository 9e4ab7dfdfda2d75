"""The friction of a pendulum per unit inertia."""

from typing import Any, Self

from .. import _core
from .._immutable import Immutable
from .._messages import explained
from .._scalars import real


class Friction(Immutable):
    """Friction 2 linear theta' + quadratic abs(theta') theta' + dry z, per unit inertia.

    z is the sign of theta'. With `presliding` it is the state of Dahl's law, z' = (theta' - abs(theta') z)/presliding: after a turn
    dry friction changes sign over an angle of about `presliding`, not at once.

    Parameters
    ----------
    linear : scalar, default 0.0
        In 1/s, finite: the rate at which small swings decay. Below 0 it drives the motion.
    quadratic : scalar, default 0.0
        In 1/rad, finite. Below 0 it drives the motion.
    dry : scalar, default 0.0
        In rad/s**2, finite and >= 0: torque over inertia.
    presliding : scalar, default 0.0
        In rad: 0, or finite and at least 1e-10.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Does not change; hashable, and equal where all four are. Source: Squire, Am. J. Phys. 54 (1986) 984; Dahl, AIAA J. 14
    (1976) 1675.

    Examples
    --------
    >>> import libration
    >>> libration.Friction(linear=0.02, dry=0.01)
    Friction(linear=0.02, quadratic=0.0, dry=0.01, presliding=0.0)
    """

    __slots__ = ("_terms",)

    _terms: tuple[float, float, float, float]

    @explained
    def __new__(cls, *, linear: float = 0.0, quadratic: float = 0.0, dry: float = 0.0, presliding: float = 0.0) -> Self:
        terms = real("linear", linear), real("quadratic", quadratic), real("dry", dry), real("presliding", presliding)
        _core.check_friction(terms)
        self = super().__new__(cls)
        object.__setattr__(self, "_terms", terms)
        return self

    @property
    def linear(self) -> float:
        """Linear coefficient in 1/s, as given, without error."""
        return self._terms[0]

    @property
    def quadratic(self) -> float:
        """Quadratic coefficient in 1/rad, as given, without error."""
        return self._terms[1]

    @property
    def dry(self) -> float:
        """Dry friction in rad/s**2, as given, without error."""
        return self._terms[2]

    @property
    def presliding(self) -> float:
        """Angle of presliding in rad, as given, without error."""
        return self._terms[3]

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (), dict(zip(("linear", "quadratic", "dry", "presliding"), self._terms, strict=True))
