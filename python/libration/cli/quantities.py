"""Quantities with units, as typed: `170deg`, `25 cm`, `1,5m`, `3min`, `1e-3`.

The decimal text is multiplied by an exact (or, with pi, a 100-digit) factor in decimal arithmetic and rounded
once: `25cm` is the double 0.25 and `180deg` the double nearest to pi. A number without a unit is in
the first unit.

A comma between two digits is a decimal comma where one value is asked for; where several may be given they are
separated by commas or by semicolons, and only between semicolons is it a decimal comma.
"""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Context, Decimal, DecimalException

from libration.cli.parser import Refusal, quoted, refusal, shown
from libration.cli.streams import note

# 100 digits after the point (OEIS A000796); a quotient with a hundred digits leaves one rounding to a double.
PI = Decimal("3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679")
# Each matches from the start of a stripped text, and in one way only: the time is linear in its length.
NUMBER = re.compile(r"([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?![0-9.,])")
NOT_FINITE = re.compile(r"[+-]?(?:inf|infinity|nan)\b", re.IGNORECASE)
COMMA = re.compile(r"([+-]?[0-9]++),([0-9]++(?:[eE][+-]?[0-9]++)?)(?![0-9.,])")
NO_WHOLE = re.compile(r"([+-]?),([0-9]++)(?![.,])")
# As thousands are written in English: 1,500 is 1500 there, and 1.5 where the comma is decimal.
THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}(?![0-9eE])")
BETWEEN_DIGITS = re.compile(r"(?<=[0-9]),(?=[0-9])")


@dataclass(frozen=True)
class Dimension:
    """A kind of quantity: its name in the plural, its units as factors of the first, and other spellings of them."""

    plural: str
    units: dict[str, Decimal]
    also: dict[str, Decimal]

    def factor(self, unit: str) -> Decimal | None:
        """The factor of a unit, None for an unknown one."""
        unit = spelled(unit)
        return self.units.get(unit, self.also.get(unit))


# Letters that look alike, as keyboards and spreadsheets write them: the degree sign, the ordinal of Portuguese and
# Spanish, the ring above; the micro sign and the Greek mu; raised digits and a raised minus.
LETTERS = str.maketrans({"\xba": "°", "\u02da": "°", "\u03bc": "µ", "²": "2", "³": "3", "⁵": "5", "¹": "1", "⁻": "-"})


def spelled(unit: str) -> str:
    """A unit as the tables spell it: `m/s2` for `m/s²`, `m/s^2`, `m/s**2` and `m / s2`."""
    unit = unit.translate(LETTERS).replace("**", "").replace("^", "")
    return "/".join(part.strip() for part in unit.split("/"))


LONG = Context(prec=100)
ONE = Decimal(1)
DEGREE = LONG.divide(PI, Decimal(180))
TURN = LONG.multiply(PI, Decimal(2))
GON = LONG.divide(PI, Decimal(200))
PER_MINUTE = LONG.divide(TURN, Decimal(60))
MILLI = Decimal("0.001")
MICRO = Decimal("0.000001")
INCH = Decimal("0.0254")
FOOT = Decimal("0.3048")


def names(factor: Decimal, *spellings: str) -> dict[str, Decimal]:
    """One factor under several names."""
    return dict.fromkeys(spellings, factor)


ANGLE = Dimension(
    "angles",
    {"rad": ONE, "deg": DEGREE, "turn": TURN},
    names(DEGREE, "°", "degree", "degrees")
    | names(ONE, "radian", "radians")
    | names(TURN, "turns", "rev")
    | {"mrad": MILLI, "gon": GON},
)
LENGTH = Dimension(
    "lengths",
    {"m": ONE, "cm": Decimal("0.01"), "mm": MILLI, "km": Decimal(1000), "in": INCH, "ft": FOOT},
    names(ONE, "meter", "meters", "metre", "metres")
    | names(MICRO, "µm", "um")
    | names(Decimal("1e-9"), "nm")
    | names(INCH, "inch", "inches")
    | names(FOOT, "foot", "feet"),
)
TIME = Dimension(
    "times",
    {"s": ONE, "ms": MILLI, "min": Decimal(60), "h": Decimal(3600)},
    names(ONE, "sec", "secs", "second", "seconds")
    | names(MICRO, "µs", "us")
    | names(MILLI, "msec")
    | names(Decimal(60), "minute", "minutes")
    | names(Decimal(3600), "hr", "hour", "hours"),
)
GRAVITY = Dimension(
    "accelerations",
    {"m/s2": ONE, "N/kg": ONE, "cm/s2": Decimal("0.01"), "ft/s2": FOOT},
    names(Decimal("0.01"), "Gal") | names(Decimal("0.00001"), "mGal") | names(ONE, "m s-2"),
)
FREQUENCY = Dimension(
    "angular frequencies",
    {"rad/s": ONE, "1/s": ONE, "deg/s": DEGREE, "Hz": TURN},
    names(DEGREE, "°/s", "degrees/s") | names(ONE, "s-1", "rad/sec"),
)
VELOCITY = Dimension(
    "angular velocities",
    {"rad/s": ONE, "deg/s": DEGREE, "turn/s": TURN, "rpm": PER_MINUTE},
    names(DEGREE, "°/s", "degrees/s") | names(ONE, "1/s", "s-1", "rad/sec") | names(TURN, "turns/s", "rev/s"),
)
NUMBERS = Dimension("plain numbers", {"": ONE}, {})
MASS = Dimension(
    "masses",
    {"kg": ONE, "g": MILLI, "mg": MICRO, "µg": Decimal("1e-9"), "ng": Decimal("1e-12"), "pg": Decimal("1e-15")},
    names(Decimal("1e-9"), "ug"),
)
STIFFNESS = Dimension("stiffnesses", {"N/m": ONE, "mN/m": MILLI, "kN/m": Decimal(1000), "N/mm": Decimal(1000)}, {})
QUADRATIC = Dimension("quadratic stiffnesses", {"N/m2": ONE}, {})
CUBIC = Dimension("cubic stiffnesses", {"N/m3": ONE}, {})
QUINTIC = Dimension("quintic stiffnesses", {"N/m5": ONE}, {})
FORCE = Dimension("forces", {"N": ONE, "mN": MILLI, "µN": MICRO, "nN": Decimal("1e-9")}, {"uN": MICRO})
SPEED = Dimension("velocities", {"m/s": ONE, "mm/s": MILLI, "µm/s": MICRO}, {"um/s": MICRO})
# Units that mean different things to different people, or have a name in other languages, and what to write instead.
INSTEAD = {"grad": "; it is a degree in some languages and pi/200 in others: write deg or gon"} | dict.fromkeys(
    ("grau", "graus", "grado", "grados", "grade", "grades"), "; write deg"
)
PI_NAMED = re.compile(r"pi|\u03c0", re.IGNORECASE)


def quantity(
    option: str, text: str, dimension: Dimension, *, above: float | None = None, least: float | None = None
) -> float:
    """The double nearest to a quantity, or a Refusal.

    An angle without a unit that is larger than a turn is taken, and a line on the standard error says as what.

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
    if dimension is ANGLE and abs(value) > math.tau and not has_unit(text):
        warn_of_radians(option, text, value)
    return value


def quantities(option: str, text: str, dimension: Dimension) -> list[float]:
    """The quantities of a list, or a Refusal.

    Parameters
    ----------
    option : str
        The option's name, for the refusal.
    text : str
        What was typed: values separated by commas, or by semicolons.
    dimension : Dimension
        What each must be.

    Returns
    -------
    list of float
        In the dimension's first unit, in the order typed.

    Examples
    --------
    >>> from libration.cli.quantities import LENGTH, quantities
    >>> quantities("--length", "1m,25cm", LENGTH)
    [1.0, 0.25]
    >>> quantities("--length", "1,5m; 0,25m", LENGTH)
    [1.5, 0.25]
    """
    if ";" in text:
        pieces = text.split(";")
    else:
        pieces = text.split(",")
    if ";" not in text and BETWEEN_DIGITS.search(text):
        reason = "a comma between digits may separate values or be decimal"
        raise refusal(option, text, f"{reason}; write {' or '.join(map(shown, unmistakable(text, pieces, dimension)))}")
    if not text.strip():
        raise refusal(
            option, text, f"has no value; {dimension.plural} look like 1.5 or 1.5{next(iter(dimension.units))}"
        )
    if not all(piece.strip() for piece in pieces):
        raise refusal(option, text, "has an empty place between its separators")
    return [quantity(option, piece, dimension) for piece in pieces]


def unmistakable(text: str, pieces: Sequence[str], dimension: Dimension) -> list[str]:
    """How to write a list with a comma between digits: a unit after each value, or a point in place of the comma.

    A value without a unit has that of the last one; angles that are large without one are meant in degrees.
    """
    read = [parts(piece) for piece in pieces]
    large = any(number is not None and not unit and abs(float(number)) > math.tau for number, unit in read)
    unit = read[-1][1] or ("deg" if dimension is ANGLE and large else next(iter(dimension.units)))
    apart = ",".join(piece if has_unit(piece) else f"{piece.strip()}{unit}" for piece in pieces)
    if not unit:
        # A shell takes a semicolon that is not in quotes for the end of the command.
        apart = f"'{';'.join(map(str.strip, pieces))}'"
    decimal = BETWEEN_DIGITS.sub(".", text)
    return [apart, decimal] if all(parts(piece)[0] for piece in decimal.split(",")) else [apart]


def warn_of_radians(option: str, text: str, value: float) -> None:
    """One line on the standard error: how an angle without a unit was taken."""
    rest = math.remainder(value, math.tau)
    turns = round((value - rest) / math.tau)
    whole = "1 whole turn" if turns == 1 else f"{turns:.6g} whole turns"
    note(
        f"{option} = {shown(text)}: taken as {value:.6g} rad, {whole} and "
        f"{math.degrees(rest):.4g} deg; for degrees write {shown(text.strip())}deg"
    )


def plain(option: str, text: str) -> float:
    """The double nearest to a plain number, or a Refusal."""
    if has_unit(text):
        raise refusal(option, text, "must be a plain number, without a unit")
    return quantity(option, text, NUMBERS)


def whole(option: str, text: str, least: int, most: int) -> int:
    """A whole number of a range, or a Refusal."""
    number = plain(option, text)
    if not (number.is_integer() and least <= number <= most):
        raise refusal(option, text, f"must be a whole number from {least} to {most}")
    return int(number)


def parts(text: str) -> tuple[str | None, str]:
    """The number at the start of a text, with a decimal point, None if there is none, and what follows it."""
    text = text.replace("\N{MINUS SIGN}", "-").strip()
    if found := NUMBER.match(text):
        return found[1], text[found.end() :].lstrip()
    if found := COMMA.match(text):
        return f"{found[1]}.{found[2]}", text[found.end() :].lstrip()
    return None, text


def split(option: str, text: str, dimension: Dimension) -> tuple[str, Decimal]:
    """The number of a quantity, as typed, and the factor of its unit, or a Refusal."""
    number, unit = parts(text)
    bare = text.replace("\N{MINUS SIGN}", "-").strip()
    if comma := NO_WHOLE.match(bare):
        raise refusal(option, text, f"has a decimal comma after no digit; write {shown(f'{comma[1]}0.{comma[2]}')}")
    if THOUSANDS.match(bare) and number is not None:
        point, none = f"{number}{unit}", f"{number.replace('.', '')}{unit}"
        raise refusal(option, text, f"may have a decimal comma or one after the thousands; write {point} or {none}")
    if NOT_FINITE.match(bare):
        raise refusal(option, text, "must be a finite number")
    first = next(iter(dimension.units))
    if number is None and dimension is NUMBERS:
        raise refusal(option, text, "is not a number; numbers look like 1.5 or 2e-3")
    if number is None:
        hint = "; pi is 180deg or 0.5turn" if dimension is ANGLE and PI_NAMED.search(bare) else ""
        raise refusal(
            option, text, f"is not a number with a unit; {dimension.plural} look like 1.5 or 1.5{first}{hint}"
        )
    factor = dimension.factor(unit) if unit else ONE
    if factor is None:
        raise unknown_unit(option, text, unit, dimension)
    return number, factor


def unknown_unit(option: str, text: str, unit: str, dimension: Dimension) -> Refusal:
    """The refusal of a unit, with the one that may be meant."""
    meant = next((each for each in dimension.units if each and each.lower() == unit.lower()), None)
    hint = f"; did you mean {meant}?" if meant else ""
    if dimension is ANGLE:
        hint = INSTEAD.get(unit.lower(), "; pi is 180deg or 0.5turn" if PI_NAMED.search(unit) else hint)
    takes = ", ".join(dimension.units)
    return refusal(option, text, f"unknown unit {quoted(unit)}; {dimension.plural} take {takes}{hint}")


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
