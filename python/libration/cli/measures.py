"""Measures as typed: a quantity with its standard uncertainty, `0.650±0.010 m`, `65 +- 1 cm`, `0.650(10)m`."""

import re

from libration.cli.parser import refusal
from libration.cli.quantities import Dimension, has_unit, parts, quantity

BETWEEN = re.compile(r"\s*(?:±|\+/-|\+-|\\pm)\s*")
IN_DIGITS = re.compile(r"([0-9]+(?:[.,]([0-9]+))?)\(([0-9]+)\)(.*)")


def measured(
    option: str, text: str, dimension: Dimension, *, above: float | None = None, least: float | None = None
) -> tuple[float, float]:
    """The value and its standard uncertainty in the dimension's first unit, or a Refusal.

    Parameters
    ----------
    option, text : str
        The option and what was typed.
    dimension : Dimension
        What it must be.
    above, least : float, optional
        The value must be greater than `above`, or at least `least`.

    Returns
    -------
    (float, float)
        The uncertainty is 0 where none was typed.

    Examples
    --------
    >>> from libration.cli.measures import measured
    >>> from libration.cli.quantities import LENGTH
    >>> measured("--length", "65.0±1.0cm", LENGTH)
    (0.65, 0.01)
    >>> measured("--length", "0.650(10)", LENGTH)
    (0.65, 0.01)
    """
    stripped = text.strip()
    if found := IN_DIGITS.fullmatch(stripped):
        number, decimals, last, unit = found[1], found[2] or "", found[3], found[4]
        spread = f"{last}e-{len(decimals)}"
        return (
            quantity(option, number + unit, dimension, above=above, least=least),
            quantity(option, spread + unit, dimension, least=0.0),
        )
    value, *spreads = BETWEEN.split(stripped)
    if len(spreads) > 1 or (spreads and not spreads[0]):
        raise refusal(option, text, "must be one value, or a value with its standard uncertainty, such as 0.650±0.010")
    if not spreads:
        return quantity(option, value, dimension, above=above, least=least), 0.0
    spread = spreads[0]
    if spread.endswith("%"):
        found_value = quantity(option, value, dimension, above=above, least=least)
        share = quantity(option, spread[:-1], Dimension("percents", dict(dimension.units), {}), least=0.0)
        return found_value, abs(found_value) * share / 100
    # One unit may stand for both, behind the uncertainty.
    if not has_unit(value) and has_unit(spread):
        value += parts(spread)[1]
    elif has_unit(value) and not has_unit(spread):
        spread += parts(value)[1]
    return (
        quantity(option, value, dimension, above=above, least=least),
        quantity(option, spread, dimension, least=0.0),
    )
