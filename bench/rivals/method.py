"""What every rival gives: the same three kinds of work.

orbit(orbit, t)                    one orbit at many times
states(theta0, velocity0, t)       states of their own, a time each
advance(theta, velocity, dt)       states of their own, dt later

A preparation does what its users do once (compile, allocate the output). It returns a call without arguments, which does
the work from the initial state and returns (theta,) or (theta, velocity). What is not installed raises `NotAvailable`.
"""

from collections.abc import Callable
from dataclasses import dataclass

Call = Callable[[], tuple]


class NotAvailable(Exception):
    """A rival that this machine does not have; the page says so."""


class Refused(Exception):
    """Work that a rival cannot do: a regime, an order of times, a tolerance."""


@dataclass(frozen=True)
class Method:
    """One method of doing the work.

    Parameters
    ----------
    name : str
        As the page calls it.
    orbit, states, advance : callable, optional
        The preparations; None for work that this method does not do.
    any_order : bool
        Whether times may come unsorted.
    """

    name: str
    orbit: Callable[..., Call] | None = None
    states: Callable[..., Call] | None = None
    advance: Callable[..., Call] | None = None
    any_order: bool = True
