"""The Duffing oscillator u'' + p u + r u**2 + q u**3 = c, exact for any start, and its link to the pendulum.

It is set up once from its state at t = 0 and answers at any time up to an escape to infinity, which may be near.
Source: Salas 2019, (2) to (10), corrected; DLMF 22.13(iii).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self

from .. import _core
from .._immutable import Elsewhere
from .._messages import explained
from .._scalars import real, shown
from ..pendulum import Pendulum
from ._knowledge import OscillatorKnowledge


class Duffing(OscillatorKnowledge):
    """The oscillator u'' + p u + r u**2 + q u**3 = c, exact for every sign, start and energy.

    Hardening (q > 0), softening (q < 0), with one well or two, symmetric or not; released, pushed, on a separatrix or escaping to
    infinity in finite time. The regime is that of the doubles passed: which side of a separatrix they lie on is decided without rounding.

    Parameters
    ----------
    u0 : scalar
        Initial displacement, finite.
    velocity0 : scalar, default 0.0
        Initial velocity, finite.
    p, q : scalar
        Coefficients of the linear and the cubic force per unit mass, finite, of any sign.
    r : scalar, default 0.0
        Coefficient of the quadratic force per unit mass, finite, of any sign.
    c : scalar, default 0.0
        Constant force per unit mass, finite, of any sign: a bias.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    An oscillator does not change; it is hashable, and a pickle rebuilds it bit for bit. A pendulum is one of these: see
    `of_pendulum`. Source: Salas 2019, (2) to (10), corrected; DLMF 22.13(iii).

    Examples
    --------
    >>> import libration
    >>> spring = libration.Duffing(1.0, p=-1.0, q=1.0)
    >>> print(spring.regime, spring.range)
    rest (1.0, 1.0)
    >>> f"{libration.Duffing(2.0, p=1.0, q=-1.0).escape_time:.6f}"
    '1.001077'
    >>> beam = libration.Duffing(1.0, p=1.0, q=0.2, r=0.5)
    >>> print(f"{beam.u(1.0):.6f} {beam.period:.6f} {beam.range[0]:.6f}")
    0.300027 6.262978 -1.401980
    """

    __slots__ = ()

    _oscillator: _core.Duffing

    # Hidden from type checkers, so that they are errors there too.
    if not TYPE_CHECKING:
        alpha = Elsewhere("p")
        beta = Elsewhere("q")

    _names = ("p", "q", "r", "c")
    _kernels = (_core.duffing_u, _core.duffing_velocity, _core.duffing_motion)
    _phase = _core.duffing_phase
    _sensitivities = _core.duffing_sensitivities

    @explained
    def __new__(cls, u0: float, velocity0: float = 0.0, *, p: float, q: float, r: float = 0.0, c: float = 0.0) -> Self:
        force = real("p", p), real("q", q), real("r", r), real("c", c)
        return cls._made(_core.Duffing(real("u0", u0), real("velocity0", velocity0), *force))

    @classmethod
    @explained
    def from_energy(
        cls,
        energy: float,
        u0: float = 0.0,
        *,
        p: float,
        q: float,
        r: float = 0.0,
        c: float = 0.0,
        direction: float = 1,
    ) -> Self:
        """Oscillator that starts at `u0` with this energy.

        Parameters
        ----------
        energy : scalar
            Half the square of the velocity plus p u**2/2 + r u**3/3 + q u**4/4 - c u, finite and at least the latter at `u0`.
        u0 : scalar, default 0.0
            Initial displacement, finite.
        p, q, r, c : scalar
            As for `Duffing`.
        direction : 1 or -1, default 1
            Whether it starts upwards or downwards.

        Returns
        -------
        Duffing

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
        >>> spring = libration.Duffing.from_energy(0.75, p=1.0, q=1.0)
        >>> print(f"{spring.velocity0:.6f} {spring.range[1]:.6f}")
        1.224745 1.000000
        """
        force = real("p", p), real("q", q), real("r", r), real("c", c)
        given = real("energy", energy), real("u0", u0), real("direction", direction)
        start = _core.duffing_from_energy(*given, force)
        return cls(*start, p=force[0], q=force[1], r=force[2], c=force[3])

    @classmethod
    @explained
    def from_action_phase(
        cls,
        action: float,
        phase: float,
        *,
        p: float,
        q: float,
        r: float = 0.0,
        c: float = 0.0,
        about: float | None = None,
    ) -> Self:
        """Oscillator with this action and, at t = 0, this phase: the inverse of `action` and `phase`.

        Parameters
        ----------
        action : scalar
            Finite and not negative: that of a motion about one stable equilibrium or, above them, about all.
        phase : scalar
            In rad, finite.
        p, q, r, c : scalar
            As for `Duffing`, with a stable equilibrium.
        about : scalar, optional
            Next to the stable equilibrium that is meant; not needed where there is one only.

        Returns
        -------
        Duffing

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed.

        Notes
        -----
        Error promised: the action comes back within 1e-13. Source: Newton's method, dJ/dE = 1/frequency.

        Examples
        --------
        >>> import libration
        >>> spring = libration.Duffing.from_action_phase(0.5, 1.0, p=1.0, q=1.0)
        >>> print(f"{spring.action:.6f} {spring.phase(0.0):.6f}")
        0.500000 1.000000
        """
        force = real("p", p), real("q", q), real("r", r), real("c", c)
        place = None if about is None else real("about", about)
        start = _core.duffing_from_action_phase(real("action", action), real("phase", phase), place, force)
        return cls(*start, p=force[0], q=force[1], r=force[2], c=force[3])

    @classmethod
    @explained
    def of_pendulum(cls, pendulum: Pendulum) -> Self:
        """Oscillator of u = tan(theta/2) for a pendulum: p = omega0**2 (1 - 2 m), q = 2 omega0**2 (1 - m), m the energy ratio.

        A libration is a hardening spring, the separatrix the linear one with p < 0, and a rotation escapes whenever the pendulum
        is at the top: there u is infinite, and one motion of u is one turn. Each of the four numbers is rounded once, so
        an orbit a rounding error from the separatrix may become its neighbour.

        Parameters
        ----------
        pendulum : Pendulum

        Returns
        -------
        Duffing

        Raises
        ------
        ValueError
            If p or q is beyond the doubles.

        Notes
        -----
        Error promised: 1 ulp of each of the four numbers. Source: Salas 2019, (5), (8), (11).

        Examples
        --------
        >>> import math
        >>> import libration
        >>> spring = libration.Duffing.of_pendulum(libration.Pendulum(2.0))
        >>> f"{2 * math.atan(spring.u(1.0)):.6f} {libration.Pendulum(2.0).theta(1.0):.6f}"
        '1.532728 1.532728'
        """
        if not isinstance(pendulum, Pendulum):
            raise ValueError(f"pendulum = {shown(pendulum)}: must be a Pendulum")
        start = pendulum.theta0, pendulum.velocity0
        u0, velocity0, p, q = _core.duffing_of_pendulum(*start, **pendulum._frequency)
        return cls(u0, velocity0, p=p, q=q)

    @property
    def pendulum(self) -> tuple[float, Pendulum] | None:
        """The pendulum that moves alike, and what u is measured in: ``u = scale * tan(theta/2)``; None where there is none.

        There is none at E = 0, in wells, for a softening spring in libration or outside of its barrier with E >= 0, for
        Delta = p**2 + 4 q E <= 0, and without a cubic force. Error promised: 1 ulp of each of its numbers. Source: Salas
        2019, (5), (8), (10) with its dots put right.
        """
        found = _core.pendulum_of_duffing(self._oscillator)
        if found is None:
            return None
        scale, theta0, velocity0, omega2 = found
        return scale, Pendulum(theta0, velocity0, omega2=omega2)

    @property
    def p(self) -> float:
        """Coefficient of the linear force, as given, without error."""
        return self._given[2]

    @property
    def q(self) -> float:
        """Coefficient of the cubic force, as given, without error."""
        return self._given[3]

    @property
    def r(self) -> float:
        """Coefficient of the quadratic force, as given, without error."""
        return self._given[4]

    @property
    def c(self) -> float:
        """Constant force, as given, without error."""
        return self._given[5]

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        positional, given = super()._arguments()
        if given["r"] == given["c"] == 0.0:
            del given["r"], given["c"]
        return positional, given
