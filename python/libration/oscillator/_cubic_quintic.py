"""The cubic-quintic oscillator u'' + p u + q u**3 + s u**5 = 0, exact for any start.

Its square is an elliptic function of time: with v = 1/u**2, v'**2 is a cubic in v, whose roots give Legendre's normal form.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Self

from .. import _core
from .._immutable import Elsewhere
from .._messages import explained
from .._scalars import real
from ._knowledge import OscillatorKnowledge


class CubicQuintic(OscillatorKnowledge):
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
    _phase = _core.cubic_quintic_phase
    _sensitivities = _core.cubic_quintic_sensitivities

    @explained
    def __new__(cls, u0: float, velocity0: float = 0.0, *, p: float, q: float, s: float) -> Self:
        given = real("p", p), real("q", q), real("s", s)
        return cls._made(_core.CubicQuintic(real("u0", u0), real("velocity0", velocity0), *given))

    @classmethod
    @explained
    def from_energy(cls, energy: float, u0: float = 0.0, *, p: float, q: float, s: float, direction: float = 1) -> Self:
        """Oscillator that starts at `u0` with this energy.

        Parameters
        ----------
        energy : scalar
            Half the square of the velocity plus p u**2/2 + q u**4/4 + s u**6/6, finite and at least the latter at `u0`.
        u0 : scalar, default 0.0
            Initial displacement, finite.
        p, q, s : scalar
            As for `CubicQuintic`.
        direction : 1 or -1, default 1
            Whether it starts upwards or downwards.

        Returns
        -------
        CubicQuintic

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: 1 ulp of `velocity0`. Source: the first integral of the equation.

        Examples
        --------
        >>> import libration
        >>> spring = libration.CubicQuintic.from_energy(0.75, p=1.0, q=1.0, s=0.0)
        >>> print(f"{spring.velocity0:.6f} {spring.range[1]:.6f}")
        1.224745 1.000000
        """
        force = real("p", p), real("q", q), real("s", s)
        given = real("energy", energy), real("u0", u0), real("direction", direction)
        return cls(*_core.cubic_quintic_from_energy(*given, force), p=force[0], q=force[1], s=force[2])

    @classmethod
    @explained
    def from_action_phase(
        cls, action: float, phase: float, *, p: float, q: float, s: float, about: float | None = None
    ) -> Self:
        """Oscillator with this action and, at t = 0, this phase: the inverse of `action` and `phase`.

        Parameters
        ----------
        action : scalar
            Finite and not negative: that of a motion about one stable equilibrium or, above them, about all.
        phase : scalar
            In rad, finite.
        p, q, s : scalar
            As for `CubicQuintic`, with a stable equilibrium.
        about : scalar, optional
            Next to the stable equilibrium that is meant; not needed where there is one only.

        Returns
        -------
        CubicQuintic

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: the action comes back within 1e-13; of a swing far smaller than the displacement, at its ends, within what
        rounding the displacement makes of it. Source: Newton's method, dJ/dE = 1/frequency.

        Examples
        --------
        >>> import libration
        >>> spring = libration.CubicQuintic.from_action_phase(0.5, 1.0, p=1.0, q=-4.0, s=3.0, about=1.0)
        >>> print(f"{spring.action:.6f} {spring.phase(0.0):.6f}")
        0.500000 1.000000
        """
        force = real("p", p), real("q", q), real("s", s)
        place = None if about is None else real("about", about)
        start = _core.cubic_quintic_from_action_phase(real("action", action), real("phase", phase), place, force)
        return cls(*start, p=force[0], q=force[1], s=force[2])

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
