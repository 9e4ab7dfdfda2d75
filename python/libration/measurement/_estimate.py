"""A value with its standard uncertainty and the parts of it, written to two digits of the uncertainty (GUM 7.2.6)."""

import math
from collections.abc import Mapping
from importlib import import_module
from typing import Any, NamedTuple


class Estimate(NamedTuple):
    """A measured or fitted value with its standard uncertainty.

    Printed, it is rounded to two digits of the uncertainty: ``9.810 ± 0.012``.

    Parameters
    ----------
    value : float
    u : float
        Combined standard uncertainty, k = 1.
    statistical, model, calibration : float
        The parts of `u`, which are added in squares: noise, with its correlation in time; the choice of a model and what it leaves
        out; length, scale of the angle and clock.

    Examples
    --------
    >>> import libration
    >>> print(libration.Estimate(9.8104, 0.0123))
    9.810 ± 0.012
    """

    value: float
    u: float
    statistical: float = 0.0
    model: float = 0.0
    calibration: float = 0.0

    @property
    def expanded(self) -> float:
        """Expanded uncertainty, k = 2, which covers some 95 %, without error."""
        return 2.0 * self.u

    def ufloat(self) -> Any:
        """The value for the package `uncertainties`, which propagates it on.

        Returns
        -------
        uncertainties.UFloat

        Raises
        ------
        ImportError
            Without that package.

        Examples
        --------
        >>> import libration
        >>> estimate = libration.Estimate(9.8104, 0.0123)
        >>> estimate.ufloat()  # doctest: +SKIP
        9.8104+/-0.0123
        """
        try:
            uncertainties = import_module("uncertainties")
        except ModuleNotFoundError as error:
            raise ImportError("ufloat needs uncertainties: pip install uncertainties") from error
        return uncertainties.ufloat(self.value, self.u)

    def __str__(self) -> str:
        return rounded(self.value, self.u)


def rounded(value: float, u: float) -> str:
    """`9.810 ± 0.012`: both to the second digit of the uncertainty; the value alone where there is none."""
    if not (math.isfinite(value) and math.isfinite(u)):
        return "not known"
    if u <= 0:
        return f"{value:.6g}"
    places = 1 - math.floor(math.log10(u))
    # 0.0996 is 0.10, of two digits too.
    places = 1 - math.floor(math.log10(round(u, places)))
    if places > 12 or max(abs(value), u) >= 1e7 or max(abs(value), u) < 1e-4:
        power = math.floor(math.log10(max(abs(value), u)))
        return f"({rounded(value / 10.0**power, u / 10.0**power)})e{power}" if power else f"{value:.6g} ± {u:.2g}"
    places = max(places, 0)
    # What is 0 to these digits has no sign.
    return f"{round(value, places) + 0.0:.{places}f} ± {u:.{places}f}"


def estimate(found: Mapping[str, Any] | None) -> Estimate | None:
    """An estimate of the door's dictionary; NaN where a number is missing."""
    if found is None:
        return None
    return Estimate(*(math.nan if found[name] is None else float(found[name]) for name in Estimate._fields))
