"""One row of the errata: what a paper prints, what it should print, and a check that only the correction passes.

A check takes a form (a function, a number or a text) and returns its residual, which is 0 if the equation of the row
holds. The residual of the corrected form is within the tolerance, that of the printed form is not.
"""

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Generic, Protocol, TypeAlias, TypeVar

import numpy as np

from .._arrays import Array, Floats

# What a check takes: a function, a number or a text.
Form = TypeVar("Form")
# A quantity over time.
Motion: TypeAlias = Callable[[Floats], Floats]


class StateFormula(Protocol):
    """A formula for the angle of the pendulum with omega0 = 1 from its initial state."""

    def __call__(self, t: Floats, theta0: float, velocity0: float) -> Floats: ...


class Kind(StrEnum):
    """The origin of an erratum; a member compares equal to its string.

    Examples
    --------
    >>> from libration.papers import Kind
    >>> Kind.PAPER == "error of the paper"
    True
    """

    TEXT = "slip of the text at hand"
    PAPER = "error of the paper"
    OPEN = "cannot be told apart"


@dataclass(frozen=True)
class Erratum(Generic[Form]):
    """One wrong line of a paper, with its correction and a check that only the correction passes.

    Parameters
    ----------
    work, place : str
        Paper and equation.
    printed, corrected : str
        The line in both versions.
    why : str
        The reason.
    kind : Kind
        An error of our text of the paper, an error of the paper, or undecided between the two.
    measure : str
        What the residual is, with its unit.
    tolerance : float
        The largest residual that passes.
    check : callable
        Takes a form and returns its residual; NaN if the form has no value.
    printed_form, corrected_form : object
        What the check takes, in both versions.

    Examples
    --------
    >>> from libration.papers import errata
    >>> row = next(row for row in errata() if row.place == "(25)")
    >>> print(row.holds(row.corrected_form), row.holds(row.printed_form), f"{row.printed_residual:.4f}")
    True False 0.7500
    """

    work: str
    place: str
    printed: str
    corrected: str
    why: str
    kind: Kind
    measure: str
    tolerance: float
    check: Callable[[Form], float]
    printed_form: Form
    corrected_form: Form

    def residual(self, form: Form) -> float:
        """The residual of a form: 0 if the equation holds for it.

        Parameters
        ----------
        form : object
            What the check takes.

        Returns
        -------
        float
            The residual, as `measure` says; NaN if the form has no value.

        Examples
        --------
        >>> from libration.papers import errata
        >>> row = next(row for row in errata() if row.place == "historical development")
        >>> print(row.residual(13), row.residual(14))
        1.0 0.0
        """
        with np.errstate(all="ignore"):
            return float(self.check(form))

    @functools.cached_property
    def printed_residual(self) -> float:
        """The residual of the printed form."""
        return self.residual(self.printed_form)

    @functools.cached_property
    def corrected_residual(self) -> float:
        """The residual of the corrected form."""
        return self.residual(self.corrected_form)

    def holds(self, form: Form) -> bool:
        """Whether a form passes the check.

        Parameters
        ----------
        form : object
            What the check takes.

        Returns
        -------
        bool
            Whether the residual is at most `tolerance`; False for a form without a value.

        Examples
        --------
        >>> from libration.papers import errata
        >>> row = next(row for row in errata() if row.place == "historical development")
        >>> print(row.holds(13), row.holds(14))
        False True
        """
        return self.residual(form) <= self.tolerance


# Central difference of eighth order for a second derivative (Fornberg 1988, table 1), and its step. For
# rates near 1 the error of the formula is 1e-15 and that of rounding 1e-12.
WEIGHTS = np.array([-1 / 560, 8 / 315, -1 / 5, 8 / 5, -205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560])
STEP = 0.02
# States of the pendulum with omega0 = 1 from which the checks start: theta0 in rad, velocity0 in rad/s.
STATES = ((1.0, 0.5), (0.3, -0.9), (2.2, 0.2))


def largest(values: Array) -> float:
    """The largest absolute value; NaN if there is one."""
    return float(np.max(np.abs(np.asarray(values, dtype=float))))


def second_derivative(u: Motion, t: Floats) -> Floats:
    """u''(t) from values of u alone."""
    found: Floats = u(np.asarray(t)[:, None] + STEP * np.arange(-4, 5)) @ WEIGHTS / STEP**2
    return found


def duffing_force(p: float, q: float) -> Motion:
    """The force p u + q u**3 of the Duffing equation u'' + p u + q u**3 = 0, as a function of u."""

    def force(u: Floats) -> Floats:
        against: Floats = p * u + q * u**3
        return against

    return force


def motion_residual(u: Motion, force: Motion, t: Floats) -> float:
    """The largest |u'' + force(u)| over the instants t."""
    return largest(second_derivative(u, t) + force(u(np.asarray(t))))


def pendulum_residual(form: StateFormula, states: Sequence[tuple[float, float]] = STATES) -> float:
    """The largest |theta'' + sin(theta)| of form(t, theta0, velocity0), or the largest error of its initial state."""
    t = np.linspace(0.1, 3.0, 30)
    beside = STEP * np.array([-1.0, 1.0])
    found = []
    for theta0, velocity0 in states:
        motion = functools.partial(form, theta0=theta0, velocity0=velocity0)
        found.append(motion_residual(motion, np.sin, t))
        # The velocity at 0 by the central difference. The error of that is a sixth of the jerk times the square of the step.
        slope = (motion(beside)[1] - motion(beside)[0]) / (2 * STEP)
        jerk = -math.cos(theta0) * velocity0
        found += [motion(np.zeros(1))[0] - theta0, (slope - jerk * STEP**2 / 6 - velocity0) * STEP]
    return largest(found)
