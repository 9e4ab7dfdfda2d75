"""When a pendulum with friction is at an angle, when it turns back, and when it rests."""

from .._arrays import Floats, Intervals
from .._scalars import real
from ._set_up import SetUp


class Events(SetUp):
    """The part of a `DampedPendulum` that finds times."""

    __slots__ = ()

    def times(self, theta: float, start: float, stop: float) -> Floats:
        """All times from `start` to `stop`, both included, at which the angle is `theta`.

        Parameters
        ----------
        theta : scalar
            Angle in rad, finite; the unwrapped one. Where the pendulum rests, only the beginning of the rest counts.
        start, stop : scalar
            Ends of the interval in s, start <= stop, where the motion gets.

        Returns
        -------
        ndarray of float64
            The times in s, rising.

        Raises
        ------
        ValueError
            In one line: the argument, its value and what is allowed, and where the motion ends.

        Notes
        -----
        Error promised: the motion at each time is at `theta` within 2 ulp of the largest angle plus what an ulp of the time makes
        of it. Source: roots of the series of a step.

        Examples
        --------
        >>> import libration
        >>> libration.DampedPendulum(1.0, friction=libration.Friction(dry=0.1)).times(0.5, 0.0, 12.0).round(6)
        array([1.206325, 6.133164, 7.066391])
        """
        return self._damped.times(real("theta", theta), real("start", start), real("stop", stop))

    def turning_times(self, start: float, stop: float) -> Floats:
        """All times from `start` to `stop`, both included, at which the pendulum turns back.

        A start from rest counts, a stop by dry friction does not.

        Parameters
        ----------
        start, stop : scalar
            Ends of the interval in s, start <= stop, where the motion gets.

        Returns
        -------
        ndarray of float64
            The times in s, rising.

        Raises
        ------
        ValueError
            As for `times`.

        Notes
        -----
        Error promised: 2 ulp, plus 2**-57 of the condition. Source: roots of the series of a step.

        Examples
        --------
        >>> import libration
        >>> libration.DampedPendulum(1.0, friction=libration.Friction(dry=0.1)).turning_times(0.0, 12.0).round(6)
        array([0.      , 3.314487, 6.554389, 9.745163])
        """
        return self._damped.turning_times(real("start", start), real("stop", stop))

    def rests(self, start: float, stop: float) -> Intervals:
        """The intervals between `start` and `stop` over which dry friction holds the pendulum.

        Parameters
        ----------
        start, stop : scalar
            Ends in s, start <= stop, where the motion gets.

        Returns
        -------
        tuple of pairs of float
            Beginning and end of each rest in s, cut at `start` and `stop`.

        Raises
        ------
        ValueError
            As for `times`.

        Notes
        -----
        Error promised: 2 ulp, plus 2**-57 of the condition. Source: the balance of the pull with dry friction.

        Examples
        --------
        >>> import libration
        >>> libration.DampedPendulum(1.0, friction=libration.Friction(dry=0.25)).rests(0.0, 20.0)
        ((6.51513234221915, 20.0),)
        """
        return tuple(self._damped.rests(real("start", start), real("stop", stop)))

    def decrements(self, start: float, stop: float) -> tuple[Floats, Floats]:
        """Logarithmic decrements from turn to turn of one side, a period apart: ``(times, decrements)``.

        ln(theta_n/theta_(n+2)) of the turning angles between `start` and `stop`.

        Parameters
        ----------
        start, stop : scalar
            Ends in s, start <= stop, where the motion gets.

        Returns
        -------
        pair of ndarray of float64
            Times in s of the later turns, and the decrements; NaN where the angles differ in sign.

        Raises
        ------
        ValueError
            As for `times`.

        Notes
        -----
        Error: what that of the angles makes of it. Source: definition of the logarithmic decrement.

        Examples
        --------
        >>> import libration
        >>> times, decrements = libration.DampedPendulum(1.0, friction=libration.Friction(linear=0.01)).decrements(0.0, 20.0)
        >>> decrements.round(6)
        array([0.070232, 0.069685, 0.069186, 0.068728, 0.068309])
        """
        times, decrements = self._damped.decrements(real("start", start), real("stop", stop))
        return times, decrements
