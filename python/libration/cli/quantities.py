"""Quantities with units, as typed: `170deg`, `25 cm`, `3min`, `1e-3`.

The decimal text is multiplied by an exact (or, with pi, a 100-digit) factor in decimal arithmetic and rounded
once: `25cm` is the double 0.25 and `180deg` the double nearest to pi. A number without a unit is in
the first unit.
"""

import math
import re
from dataclasses import dataclass
from decimal import Context, Decimal, DecimalException

from libration.cli.parser import quoted, refusal, shown

# 100 digits after the point (OEIS A000796); a quotient with a hundred digits leaves one rounding to a double.
PI = Decimal("3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679")
# Each matches from the start of a stripped text, and in one way only: the time is linear in its length.
NUMBER = re.compile(r"([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?![0-9.,])")
NOT_FINITE = re.compile(r"[+-]?(?:inf|infinity|nan)\b", re.IGNORECASE)
COMMA = re.compile(r"([+-]?[0-9]*+),([0-9]++)(?![.,])")


@dataclass(frozen=True)
class Dimension:
    """A kind of quantity: its name in the plural, and its units as factors of the first."""

    plural: str
    units: dict[str, Decimal]
    also: dict[str, Decimal]

    def factor(self, unit: str) -> Decimal | None:
        """The factor of a unit, None for an unknown one."""
        return self.units.get(unit, self.also.get(unit))


LONG = Context(prec=100)
ONE = Decimal(1)
DEGREE = LONG.divide(PI, Decimal(180))
TURN = LONG.multiply(PI, Decimal(2))

ANGLE = Dimension("angles", {"rad": ONE, "deg": DEGREE, "turn": TURN}, {"°": DEGREE})
LENGTH = Dimension(
    "lengths",
    {
        "m": ONE,
        "cm": Decimal("0.01"),
        "mm": Decimal("0.001"),
        "km": Decimal(1000),
        "in": Decimal("0.0254"),
        "ft": Decimal("0.3048"),
    },
    {},
)
TIME = Dimension("times", {"s": ONE, "ms": Decimal("0.001"), "min": Decimal(60), "h": Decimal(3600)}, {})
GRAVITY = Dimension("accelerations", {"m/s2": ONE, "m/s^2": ONE}, {"m/s²": ONE})
FREQUENCY = Dimension("angular frequencies", {"rad/s": ONE, "1/s": ONE, "deg/s": DEGREE, "Hz": TURN}, {"°/s": DEGREE})
VELOCITY = Dimension("angular velocities", {"rad/s": ONE, "deg/s": DEGREE}, {"°/s": DEGREE})


def quantity(
    option: str, text: str, dimension: Dimension, *, above: float | None = None, least: float | None = None
) -> float:
    """The double nearest to a quantity, or a Refusal.

    Parameters
    ----------
    option : str
        The option's name, for the refusal.
    text : str
        What was typed.
    dimension : Dimension
        What it must be.
    above, least : float, optional
        The value must be greater than `above`, or at least `least`.

    Returns
    -------
    float
        In the dimension's first unit.

    Examples
    --------
    >>> from libration.cli.quantities import ANGLE, LENGTH, quantity
    >>> quantity("--length", "25 cm", LENGTH)
    0.25
    >>> quantity("--theta0", "180deg", ANGLE)
    3.141592653589793
    """
    value = scaled(*split(option, text, dimension))
    if not math.isfinite(value):
        raise refusal(option, text, "is beyond the largest double, 1.8e308")
    if above is not None and not value > above:
        raise refusal(option, text, f"must be greater than {above:g}")
    if least is not None and not value >= least:
        raise refusal(option, text, f"must be {least:g} or greater")
    return value


NUMBERS = Dimension("plain numbers", {"": ONE}, {})


def plain(option: str, text: str) -> float:
    """The double nearest to a plain number, or a Refusal."""
    if has_unit(text):
        raise refusal(option, text, "must be a plain number, without a unit")
    return quantity(option, text, NUMBERS)


def parts(text: str) -> tuple[str | None, str]:
    """The number at the start of a text, None if there is none, and what follows it."""
    text = text.replace("\N{MINUS SIGN}", "-").strip()
    found = NUMBER.match(text)
    return (found[1], text[found.end() :].lstrip()) if found else (None, text)


def split(option: str, text: str, dimension: Dimension) -> tuple[str, Decimal]:
    """The number of a quantity, as typed, and the factor of its unit, or a Refusal."""
    number, unit = parts(text)
    bare = text.replace("\N{MINUS SIGN}", "-").strip()
    if comma := COMMA.match(bare):
        raise refusal(
            option,
            text,
            f"has a decimal comma; write {shown(f'{comma[1]}.{comma[2]}' if comma[1] else f'0.{comma[2]}')}",
        )
    if NOT_FINITE.match(bare):
        raise refusal(option, text, "must be a finite number")
    first, *others = dimension.units
    if number is None:
        raise refusal(option, text, f"is not a number with a unit; {dimension.plural} look like 1.5 or 1.5{first}")
    factor = dimension.factor(unit) if unit else ONE
    if factor is None:
        takes = ", ".join([first, *others])
        raise refusal(option, text, f"unknown unit {quoted(unit)}; {dimension.plural} take {takes}")
    return number, factor


def has_unit(text: str) -> bool:
    """Whether a quantity was typed with a unit."""
    number, unit = parts(text)
    return number is not None and unit != ""


def scaled(number: str, factor: Decimal) -> float:
    """The double nearest to a decimal text times a factor; infinite beyond the largest."""
    if factor == ONE:
        return float(number)
    # Enough digits for the product: without pi it is exact, and float() rounds once.
    context = Context(prec=110 + len(number))
    try:
        return float(context.multiply(Decimal(number), factor))
    except DecimalException:
        return float(number)
