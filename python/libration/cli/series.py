"""A series of the user, measured or computed elsewhere: instants and angles of a text file beside the exact motion."""

import math
import os
import re
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from libration.cli.parser import refusal, shown
from libration.cli.quantities import ANGLE
from libration.cli.streams import note
from libration.cli.times import INSTANTS, ColumnKind, TextFile, file_column

if TYPE_CHECKING:
    from libration import Pendulum
    from libration._arrays import Floats
    from libration.approx._angle import AngleError

# A name that ends so is a file.
ENDINGS = (".csv", ".txt", ".tsv", ".dat")
# In the name of a column, what stands before or in a unit.
WITH_UNIT = re.compile(r"[\[(_]|rad")
ANGLES = ColumnKind("angles", ("theta", "angle", "\N{GREEK SMALL LETTER THETA}"), 1, ANGLE)


@dataclass(frozen=True)
class SeriesName:
    """The name of a series, as the formulas have theirs."""

    name: str


@dataclass(frozen=True, eq=False)
class Series:
    """The angles of a series at its own instants, which rise, and the exact ones beside them."""

    formula: SeriesName
    pendulum: "Pendulum"
    instants: "Floats"
    given: "Floats"

    @cached_property
    def differences(self) -> "Floats":
        """The series minus the exact angle at its own instants."""
        found: Floats = self.given - self.pendulum.theta(self.instants)
        return found

    def difference(self, t: "Floats") -> "Floats":
        """The series minus the exact angle: at its instants as it is, between them interpolated, NaN outside."""
        import numpy as np

        found: Floats = np.interp(t, self.instants, self.differences, left=np.nan, right=np.nan)
        return found

    def theta(self, t: "Floats") -> "Floats":
        """The exact angle plus the difference of the series."""
        found: Floats = self.pendulum.theta(t) + self.difference(t)
        return found

    def error(self, periods: float) -> "AngleError":
        """The largest difference at its instants in so many periods, and the end of the series if that comes before."""
        import numpy as np

        from libration.approx._angle import AngleError

        last = periods * self.pendulum.period
        inside = (self.instants >= 0) & (self.instants <= last)
        undefined = math.nan if self.instants[-1] >= last * (1 - 1e-12) else float(self.instants[-1])
        if not inside.any():
            return AngleError(math.nan, math.nan, math.nan, undefined)
        t = self.instants[inside]
        size = np.abs(self.differences[inside])
        where = int(np.argmax(size))
        return AngleError(float(size[where]), float(size[where]) / self.pendulum.theta_max, float(t[where]), undefined)


def is_series(name: str) -> bool:
    """Whether a name of --with is a file."""
    return os.path.splitext(name)[1].lower() in ENDINGS


def series(path: str, motion: "Pendulum") -> Series:
    """The series of a file, or a Refusal."""
    import numpy as np

    file = TextFile("--with", path)
    (t, _), (theta, name) = file_column(file, None, INSTANTS), file_column(file, None, ANGLES)
    back = np.flatnonzero(np.diff(t) <= 0)
    if back.size:
        first = int(back[0])
        raise refusal("--with", path, f"instants must rise, and {t[first + 1]:g} s follows {t[first]:g} s")
    largest = float(np.abs(theta).max())
    if motion.regime == "libration" and largest > math.tau and not WITH_UNIT.search(name):
        note(
            f"--with = {shown(path)}: angles up to {largest:.4g} are taken as rad; for degrees the header says theta [deg]"
        )
    return Series(SeriesName(path), motion, t, theta)
