"""The Duffing oscillator u'' + p u + q u**3 = 0, exact for any start, and its link to the pendulum.

It is set up once from its state at t = 0 and answers at any time up to an escape to infinity, which may be near.
Of `duffing_motion` the call decides: a start and coefficients without dimensions are one oscillator, those with dimensions rows
with motions of their own. Source: Salas 2019, (2) to (10), corrected; DLMF 22.13(iii).
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Self, overload

import numpy as np

from .. import _core
from .._arrays import Floats, Labelled, Mask, Real, Scalar
from .._dispatch import apply, has_dimensions
from .._immutable import Elsewhere
from .._messages import explained
from .._scalars import real, shown
from ..pendulum import Pendulum
from ._oscillator import MOTION, Oscillator


class Duffing(Oscillator):
    """The oscillator u'' + p u + q u**3 = 0, exact for every sign, start and energy.

    Hardening (q > 0), softening (q < 0), with one well or two; released, pushed, on a separatrix or escaping to infinity in
    finite time. The regime is that of the doubles passed: which side of a separatrix they lie on is decided without rounding.

    Parameters
    ----------
    u0 : scalar
        Initial displacement, finite.
    velocity0 : scalar, default 0.0
        Initial velocity, finite.
    p, q : scalar
        Coefficients of the linear and the cubic force per unit mass, finite, of any sign.

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
    """

    __slots__ = ()

    _oscillator: _core.Duffing

    # Hidden from type checkers, so that they are errors there too.
    if not TYPE_CHECKING:
        alpha = Elsewhere("p")
        beta = Elsewhere("q")

    _names = ("p", "q")
    _kernels = (_core.duffing_u, _core.duffing_velocity, _core.duffing_motion)

    @explained
    def __new__(cls, u0: float, velocity0: float = 0.0, *, p: float, q: float) -> Self:
        return cls._made(_core.Duffing(real("u0", u0), real("velocity0", velocity0), real("p", p), real("q", q)))

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


@overload
def duffing_motion(
    t: Scalar,
    u0: Scalar,
    velocity0: Scalar = 0.0,
    p: Scalar = 1.0,
    q: Scalar = 1.0,
    *,
    out: None = None,
    where: bool = True,
) -> tuple[np.float64, np.float64]: ...
@overload
def duffing_motion(
    t: Real,
    u0: Real,
    velocity0: Real = 0.0,
    p: Real = 1.0,
    q: Real = 1.0,
    *,
    out: tuple[Floats, Floats] | None = None,
    where: Mask = True,
) -> tuple[Floats, Floats]: ...
@overload
def duffing_motion(
    t: Real | Labelled,
    u0: Real | Labelled,
    velocity0: Real | Labelled = 0.0,
    p: Real | Labelled = 1.0,
    q: Real | Labelled = 1.0,
    *,
    out: tuple[Labelled, Labelled] | None = None,
    where: Mask = True,
) -> tuple[Labelled, Labelled]: ...
@explained
def duffing_motion(
    t: Any, u0: Any, velocity0: Any = 0.0, p: Any = 1.0, q: Any = 1.0, *, out: Any = None, where: Any = True
) -> Any:
    """Displacement and velocity of Duffing oscillators at the times `t`: ``(u, velocity)``.

    The solution of u'' + p u + q u**3 = 0 from the state (u0, velocity0) at t = 0, element by element.

    Parameters
    ----------
    t : scalar or array
        Time in s. NaN beyond an escape, and more than 2**53 half periods away.
    u0 : scalar or array
        Initial displacement, finite.
    velocity0 : scalar or array, default 0.0
        Initial velocity, finite.
    p, q : scalar or array, default 1.0
        Coefficients of the linear and the cubic force per unit mass, finite.
    out : pair of ndarray, optional
        Where to put the results.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    pair of float64 or of arrays of the broadcast shape
        A bad element gives NaN there and nowhere else. Dask and xarray arrays give their like, and stay lazy.

    Notes
    -----
    Error promised: that of `Duffing.u` and `Duffing.velocity`. Where neither the start nor a coefficient has dimensions, an oscillator
    is set up once and the digits are those of its methods. Else every element is computed from its own start, at vector speed; its
    digits do not depend on shape, order, strides or chunks. Source: DLMF 22.13(iii), 22.8.

    Examples
    --------
    >>> import libration
    >>> u, velocity = libration.duffing_motion(1.0, [0.5, 1.0, 2.0], 0.0, 1.0, -1.0)
    >>> print(u.round(6))
    [3.17963000e-01 1.00000000e+00 1.31264107e+03]
    """
    kernel = _core.duffing_motion if _one_oscillator(u0, velocity0, p, q) else _core.duffing_rows
    return apply(kernel, t, u0, velocity0, p, q, results=MOTION, out=out, where=where)


def _one_oscillator(*start: Any) -> bool:
    """Whether neither the start nor a coefficient has dimensions."""
    return not any(type(each) is not float and has_dimensions(each) for each in start)
