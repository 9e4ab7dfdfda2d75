"""One row of the claims: a number a paper prints, the number measured here, and whether the two agree.

A row states its verdict, and the measured value must support it. `reproduced`: the value lies in the interval that the
printed number allows. `corrected`: it does not, and lies in that of the correction. `not reproducible`: the row gives a
reason.
"""

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum


class Verdict(StrEnum):
    """The result of the check of a claim; a member compares equal to its string.

    Examples
    --------
    >>> from libration.papers import Verdict
    >>> Verdict.CORRECTED == "corrected"
    True
    """

    REPRODUCED = "reproduced"
    CORRECTED = "corrected"
    NOT_REPRODUCIBLE = "not reproducible"


Interval = tuple[float, float]


@dataclass(frozen=True)
class Claim:
    """A numerical claim of a paper, with the value measured here.

    Parameters
    ----------
    work, place : str
        Paper, and where in it.
    claim : str
        The claim in our words.
    printed : str
        The printed value.
    allows : pair of float, optional
        The measured values for which the printed number is right.
    measured : callable, optional
        Returns the measured value; None if the claim cannot be reproduced.
    shown : str
        Format of the measured value, with its unit.
    corrected : pair of float, optional
        The measured values for which the correction is right; None if the claim is reproduced.
    reason : str
        Why a claim cannot be reproduced, or a remark on the number.

    Examples
    --------
    >>> from libration.papers import claims
    >>> row = next(row for row in claims("lima") if row.printed == "0.6 %")
    >>> print(row.ours, row.verdict, row.stands)
    0.6069 % reproduced True
    """

    work: str
    place: str
    claim: str
    printed: str
    allows: Interval | None = None
    measured: Callable[[], float] | None = None
    shown: str = "{:.4g}"
    corrected: Interval | None = None
    reason: str = ""

    @functools.cached_property
    def value(self) -> float:
        """The measured value; NaN if there is none."""
        return math.nan if self.measured is None else float(self.measured())

    @property
    def ours(self) -> str:
        """The measured value as text; empty if there is none."""
        return "" if self.measured is None else self.shown.format(self.value)

    @property
    def verdict(self) -> Verdict:
        """The verdict that the row states."""
        if self.measured is None:
            return Verdict.NOT_REPRODUCIBLE
        return Verdict.REPRODUCED if self.corrected is None else Verdict.CORRECTED

    @property
    def stands(self) -> bool:
        """Whether the measured value supports the verdict, or a reason is given where there is no value."""
        if self.measured is None:
            return bool(self.reason)
        if self.allows is None:
            return False
        right = within(self.value, self.allows)
        return right if self.corrected is None else not right and within(self.value, self.corrected)


def within(value: float, interval: Interval) -> bool:
    """Whether a value lies in a closed interval; NaN lies in none."""
    return interval[0] <= value <= interval[1]


def rounded(text: str) -> Interval:
    """The values that round to a printed decimal number: half a unit of its last place on both sides."""
    half = 0.5 * 10.0 ** -len(text.partition(".")[2])
    return float(text) - half, float(text) + half
