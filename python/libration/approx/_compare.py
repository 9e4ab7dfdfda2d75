"""Approximations and numerical solutions beside the exact motion: their largest errors, as a table and as a picture."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

from .._scalars import real, shown
from ..pendulum import Pendulum
from ._angle import AngleApproximation, AngleError, angle
from ._named import moving
from ._numerical import NumericalSolution, checked_span, nearest, numerical

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Solution: TypeAlias = AngleApproximation | NumericalSolution


@dataclass(frozen=True)
class Comparison:
    """Solutions of one pendulum beside the exact one, over a number of periods; from `compare`.

    Printed, it is a table: the largest error of each in rad and in percent of the turning angle, when it occurs in
    periods, and where a solution is undefined or goes over the top.

    Parameters
    ----------
    pendulum : Pendulum
        The motion.
    periods : float
        How many periods of it are compared.
    solutions : tuple
        The `AngleApproximation` or `NumericalSolution` of each name, in the order asked for.
    largest : tuple
        The largest error of each, an `AngleError`.

    Examples
    --------
    >>> from libration import Pendulum, approx
    >>> print(approx.compare(Pendulum(1.5), ["harmonic", "fourier:2"]))
    libration, T = 7.30086 s, theta_max = 1.5 rad
    over 1 period  largest error [rad]  [% of theta_max]   at t/T
    harmonic                   0.03135              2.09  0.15439
    fourier:2                 0.002714            0.1809        0
    """

    pendulum: Pendulum
    periods: float
    solutions: tuple[Solution, ...]
    # Follows from the others; NaN is not equal to itself.
    largest: tuple[AngleError, ...] = field(compare=False, repr=False)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the solutions, in their order."""
        return tuple(each.formula.name for each in self.solutions)

    @property
    def errors(self) -> dict[str, AngleError]:
        """The largest error of each solution by its name."""
        return dict(zip(self.names, self.largest, strict=True))

    def __str__(self) -> str:
        return table(self)

    def plot(self, ax: Axes | None = None, *, lang: str = "en") -> Axes:
        """Draw the angles; in a new figure with the errors below them.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw the angles alone; by default both panels in a new figure. Axes that are given keep their look,
            and no setting is changed.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

        Returns
        -------
        Axes
            Those of the angles. Time is in periods; of more than twelve the first twelve are drawn.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        ValueError
            If `ax` or `lang` is none of those.

        Examples
        --------
        >>> from matplotlib.figure import Figure
        >>> from libration import Pendulum, approx
        >>> ax = approx.compare(Pendulum(1.5), ["linear", "fourier:2"]).plot(Figure().subplots())
        >>> [text.get_text() for text in ax.get_legend().get_texts()]
        ['exact', 'linear', 'fourier:2']
        """
        from ..plot._comparison import comparison_axes

        return comparison_axes(self.pendulum, named_solutions(self), self.periods, ax, lang)

    def plot_error(self, ax: Axes | None = None, *, lang: str = "en") -> Axes:
        """Draw the errors; their size on a logarithmic axis where they span decades.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

        Returns
        -------
        Axes
            Those drawn into: errors in percent of the turning angle, in rotation in rad, over time in periods.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        ValueError
            If `ax` or `lang` is none of those.

        Examples
        --------
        >>> from matplotlib.figure import Figure
        >>> from libration import Pendulum, approx
        >>> ax = approx.compare(Pendulum(1.5), ["linear", "fourier:8"]).plot_error(Figure().subplots())
        >>> ax.get_yscale()
        'log'
        """
        from ..plot._comparison import error_axes

        return error_axes(self.pendulum, named_solutions(self), self.periods, ax, lang)


def compare(pendulum: Pendulum, names: Iterable[str] = ("linear", "harmonic"), *, periods: float = 1) -> Comparison:
    """Approximations and numerical solutions by name beside the exact motion.

    Parameters
    ----------
    pendulum : Pendulum
        The motion; a libration or a rotation.
    names : iterable of str
        Names of `libration.approx.angle` and `libration.approx.numerical`, as ``"fourier:4"``, ``"rk4:0.025"``.
    periods : float, default 1
        Over how many periods, up to 10,000; in rotation turns.

    Returns
    -------
    Comparison

    Raises
    ------
    ValueError
        In one line: a name that is not known or comes twice, a formula that is not written for the motion, or a motion
        without a period or at rest.
    ImportError
        For SciPy's solutions, if SciPy is missing.

    Notes
    -----
    Error promised: that of `AngleApproximation.error` and `NumericalSolution.error`. Source: Lima 2019, section 4.

    Examples
    --------
    >>> from libration import Pendulum, approx
    >>> made = approx.compare(Pendulum(1.5), ["linear", "harmonic", "fourier:4"], periods=10)
    >>> f"{made.errors['harmonic'].relative:.4f}"
    '0.0209'
    """
    periods = real("periods", periods)
    checked_span(periods, moving(pendulum))
    if pendulum.regime == "rest":
        raise ValueError(f"pendulum = {pendulum!r}: must move; it is at rest")
    if isinstance(names, str):
        raise ValueError(f"names = {names!r}: must be a list of names, as [{names!r}]")
    if not isinstance(names, Iterable) or not (names := tuple(names)):
        raise ValueError(f"names = {shown(names)}: must be a list of at least one name, as ['linear']")
    made = tuple(solution(name, pendulum) for name in names)
    found = [each.formula.name for each in made]
    for name in found:
        if found.count(name) > 1:
            raise ValueError(f"names: must differ; {name} comes twice")
    return Comparison(pendulum, periods, made, tuple(each.error(periods) for each in made))


def solution(name: str, pendulum: Pendulum) -> Solution:
    """One solution by its name."""
    known = {pattern.partition(":")[0] for pattern in numerical.names}
    patterns = (*angle.names, *numerical.names)
    base = name.partition(":")[0] if isinstance(name, str) else name
    if base in known:
        return numerical(name).of(pendulum)
    if base not in {pattern.partition(":")[0] for pattern in angle.names}:
        near = ", ".join(nearest(patterns, name) if isinstance(name, str) else patterns)
        raise ValueError(f"names: {name!r}: must be one of {near}")
    return angle(name).of(pendulum)


def named_solutions(comparison: Comparison) -> list[tuple[str, Solution]]:
    """The solutions with their names, as the pictures take them."""
    return list(zip(comparison.names, comparison.solutions, strict=True))


def table(comparison: Comparison) -> str:
    """The numbers as lines."""
    pendulum, periods = comparison.pendulum, comparison.periods
    swings = math.isfinite(pendulum.theta_max)
    turning = f", theta_max = {pendulum.theta_max:.6g} rad" if swings else ""
    over = f"over {periods:g} {'period' if periods == 1 else 'periods'}"
    heads = [over, "largest error [rad]", *(["[% of theta_max]"] if swings else []), "at t/T"]
    rows = [[name, *cells(error, pendulum, swings)] for name, error in comparison.errors.items()]
    widths = [max(map(len, column)) for column in zip(heads, *rows, strict=True)]
    lines = [
        "  ".join(
            [row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:], strict=True))]
        )
        for row in (heads, *rows)
    ]
    pairs = zip(comparison.solutions, comparison.largest, strict=True)
    said = ["", *(remark(made, error, comparison) for made, error in pairs)]
    body = [(line + more).rstrip() for line, more in zip(lines, said, strict=True)]
    return "\n".join([f"{pendulum.regime}, T = {pendulum.period:.6g} s{turning}", *body])


def cells(error: AngleError, pendulum: Pendulum, swings: bool) -> list[str]:
    """One error as text."""
    if math.isnan(error.difference):
        return ["undefined", *(["-"] if swings else []), "-"]
    percent = [f"{100 * error.relative:.4g}"] if swings else []
    return [f"{error.difference:.4g}", *percent, f"{error.t / pendulum.period:.5g}"]


def remark(made: Solution, error: AngleError, comparison: Comparison) -> str:
    """Where a solution is undefined, and when it goes over the top."""
    said = []
    if not math.isnan(error.undefined_from):
        said.append(f"undefined from t/T = {error.undefined_from / comparison.pendulum.period:.5g}")
    top = made.over_the_top(comparison.periods) if isinstance(made, NumericalSolution) else math.nan
    if not math.isnan(top):
        said.append(f"goes over the top at t = {top:.4g} s")
    return "  " + "; ".join(said) if said else ""
