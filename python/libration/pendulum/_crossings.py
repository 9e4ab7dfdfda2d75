"""When an orbit is at an angle, and when it turns back."""

import numpy as np

from .._arrays import Floats
from .._messages import explained
from .._scalars import real, shown
from ._constants import Constants


class Crossings(Constants):
    """The part of a `Pendulum` that finds times."""

    __slots__ = ()

    @explained
    def times(self, theta: float, start: float, stop: float, *, every_turn: bool = False) -> Floats:
        """All times from `start` to `stop`, both included, at which the angle is `theta`.

        In libration modulo 2 pi: 30 degrees is passed whatever turn the pendulum hangs in. In rotation and on the
        separatrix the angle is the unwrapped one, and passed once at most, unless every turn is asked for.

        Parameters
        ----------
        theta : scalar
            Angle in rad, finite; in rotation within 2**52 turns of `theta0`. A turning angle, also as `theta_max` and `extremes` round it, is passed once a swing.
        start, stop : scalar
            Ends of the interval in s, start <= stop, in libration and for every turn within 2**53 half periods.
        every_turn : bool, default False
            Whether a rotation's angle counts modulo 2 pi as well: all tops of it are ``times(math.pi, ..., every_turn=True)``.

        Returns
        -------
        ndarray of float64
            The times in s, rising; empty at rest, and where the motion does not get.

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed; for more than 10 million passages, how many.

        Notes
        -----
        Error promised: the motion at each time is at `theta` within 4 ulp of the largest angle plus what an ulp of the
        time makes of it. Source: DLMF 19.25.5, 22.15(ii).

        Examples
        --------
        >>> import libration
        >>> libration.Pendulum(1.0).times(0.5, 0.0, 7.0).round(6)
        array([1.126844, 5.573131])
        >>> libration.Pendulum(0.0, 3.0).times(3.0, 0.0, 7.0, every_turn=True).round(6)
        array([1.143165, 3.556055, 5.968945])
        """
        if not isinstance(every_turn, bool | np.bool):
            raise ValueError(f"every_turn = {shown(every_turn)}: must be True or False")
        return self._orbit.times(real("theta", theta), real("start", start), real("stop", stop), bool(every_turn))

    @explained
    def turning_times(self, start: float, stop: float) -> Floats:
        """All times from `start` to `stop`, both included, at which the pendulum turns back.

        Parameters
        ----------
        start, stop : scalar
            Ends of the interval in s, start <= stop, within 2**53 half periods.

        Returns
        -------
        ndarray of float64
            The times in s, rising; empty at rest, in rotation and on the separatrix.

        Raises
        ------
        ValueError
            As for `times`.

        Notes
        -----
        Error promised: 4 ulp. Source: DLMF 22.4(i).

        Examples
        --------
        >>> import libration
        >>> libration.Pendulum(1.0).turning_times(0.0, 10.0).round(6)
        array([0.      , 3.349988, 6.699976])
        """
        return self._orbit.turning_times(real("start", start), real("stop", stop))
