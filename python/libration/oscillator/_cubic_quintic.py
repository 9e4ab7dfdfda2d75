"""The cubic-quintic oscillator u'' + p u + q u**3 + s u**5 = 0, exact for any start.

Its square is an elliptic function of time: with v = 1/u**2, v'**2 is a cubic in v, whose roots give Legendre's normal form.
"""

from typing import TYPE_CHECKING, Self

from .. import _core
from .._immutable import Elsewhere
from .._messages import explained
from .._scalars import real
from ._oscillator import Oscillator


class CubicQuintic(Oscillator):
    """The oscillator u'' + p u + q u**3 + s u**5 = 0, exact for every sign, start and energy.

    With one well, two or three; its square is an elliptic function of time, whatever the roots of the energy's polynomial.

    Parameters
    ----------
    u0 : scalar
        Initial displacement, finite.
    velocity0 : scalar, default 0.0
        Initial velocity, finite.
    p, q, s : scalar
        Coefficients of the linear, cubic and quintic force per unit mass, finite, of any sign.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    An oscillator does not change; it is hashable, and a pickle rebuilds it bit for bit. Source: Legendre's normal forms of
    ``v'**2 = 4 C(v)`` with ``v = 1/u**2`` and the cubic C; Belendez et al. 2016 for release from rest.

    Examples
    --------
    >>> import libration
    >>> spring = libration.CubicQuintic(1.0, p=1.0, q=-0.5, s=0.1)
    >>> print(spring.regime, f"{spring.period:.6f}")
    libration 7.603173
    """

    __slots__ = ()

    _oscillator: _core.CubicQuintic

    # Hidden from type checkers, so that they are errors there too.
    if not TYPE_CHECKING:
        alpha = Elsewhere("p")
        beta = Elsewhere("q")
        gamma = Elsewhere("s")

    _names = ("p", "q", "s")
    _kernels = (_core.cubic_quintic_u, _core.cubic_quintic_velocity, _core.cubic_quintic_motion)

    @explained
    def __new__(cls, u0: float, velocity0: float = 0.0, *, p: float, q: float, s: float) -> Self:
        given = real("p", p), real("q", q), real("s", s)
        return cls._made(_core.CubicQuintic(real("u0", u0), real("velocity0", velocity0), *given))

    @property
    def p(self) -> float:
        """Coefficient of the linear force, as given, without error."""
        return self._given[2]

    @property
    def q(self) -> float:
        """Coefficient of the cubic force, as given, without error."""
        return self._given[3]

    @property
    def s(self) -> float:
        """Coefficient of the quintic force, as given, without error."""
        return self._given[4]
