"""The twelve forms c1 pq(Omega t + c2 | m) of solutions of u'' + p u + q u**3 = 0."""

from typing import Any, Self

import numpy as np

from .. import _core
from .._immutable import Immutable
from .._scalars import real
from ._oscillator import OscillatorRegime


class DuffingForm(Immutable):
    """One of the twelve forms u = c1 pq(Omega t + c2 | m) of solutions of u'' + p u + q u**3 = 0.

    Omega and m follow from p and q c1**2; where they are not real the form is refused, with its domain.

    Parameters
    ----------
    form : str
        Two letters of s, c, d, n: one of sn cn dn ns nc nd sc cs sd ds cd dc.
    c1 : scalar
        Factor of the function, finite.
    c2 : scalar, default 0.0
        Argument at t = 0, finite.
    p, q : scalar
        Coefficients of the linear and the cubic force per unit mass, finite.

    Raises
    ------
    ValueError
        In one line: the form with its numbers, and where it is real.

    Notes
    -----
    Beyond a pole the form goes on as pq does; the motion of an oscillator ends there. Source: Salas 2019 gives nine of
    them; ns, cs and ds are ours. DLMF 22.13(iii).

    Examples
    --------
    >>> import libration
    >>> form = libration.DuffingForm("cn", 1.0, p=1.0, q=1.0)
    >>> f"{form.rate:.6f} {form.m:.6f} {form.u(1.0):.6f}"
    '1.414214 0.250000 0.233692'
    """

    __slots__ = ("_form", "_given")

    _form: _core.DuffingForm
    _given: tuple[Any, ...]

    def __new__(cls, form: str, c1: float, c2: float = 0.0, *, p: float, q: float) -> Self:
        numbers = real("p", p), real("q", q), real("c1", c1), real("c2", c2)
        self = super().__new__(cls)
        object.__setattr__(self, "_form", _core.DuffingForm(str(form), *numbers))
        object.__setattr__(self, "_given", (str(form), *numbers))
        return self

    def u(self, t: Any) -> Any:
        """Displacement at the times `t`, an array of their shape or a float64.

        NaN for times that are not finite. Error promised: 4 ulp, plus 2**-100 of the condition. Source: DLMF 22.2.10.
        """
        return self.motion(t)[0]

    def velocity(self, t: Any) -> Any:
        """Velocity at the times `t`, an array of their shape or a float64.

        NaN for times that are not finite. Error promised: 4 ulp, plus 2**-100 of the condition. Source: DLMF 22.13(i).
        """
        return self.motion(t)[1]

    def motion(self, t: Any) -> Any:
        """Displacement and velocity at the times `t`, together: two arrays of their shape, or two float64.

        NaN for times that are not finite. Error promised: that of `u` and of `velocity`. Source: DLMF 22.13(i).
        """
        times = np.asarray(t, dtype=float)
        u, velocity = self._form.motion(times.ravel())
        return u.reshape(times.shape)[()], velocity.reshape(times.shape)[()]

    @property
    def rate(self) -> float:
        """Omega, in 1/s. Error promised: 2 ulp. Source: the table of core/src/duffing/forms.rs."""
        return self._form.rate

    @property
    def m(self) -> float:
        """Parameter of the elliptic function. Error promised: 2 ulp. Source: the table of core/src/duffing/forms.rs."""
        return self._form.parameter[0]

    @property
    def mc(self) -> float:
        """Complement 1 - m, computed directly. Error promised: 2 ulp. Source: the table of core/src/duffing/forms.rs."""
        return self._form.parameter[1]

    @staticmethod
    def table() -> dict[str, list[OscillatorRegime]]:
        """Which form serves which regimes, found by trying every form over a grid of p and q c1**2.

        Examples
        --------
        >>> import libration
        >>> print(*libration.DuffingForm.table()["dn"])
        rest well homoclinic
        """
        return {name: [OscillatorRegime(each) for each in regimes] for name, regimes in _core.DuffingForm.table()}

    def _arguments(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        form, p, q, c1, c2 = self._given
        return (form, c1, c2), {"p": p, "q": q}
