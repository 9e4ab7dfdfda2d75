"""Numerical solutions by name: what a first program, or SciPy as it comes, makes of the pendulum.

`solve_ivp` and `odeint` are SciPy's, with its defaults; the others are the core's (core/src/approx/numerical.rs), where
`rk45` is `solve_ivp` once more, step by step, for those without SciPy.
"""

from __future__ import annotations

import importlib
import importlib.util
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, overload

import numpy as np

from .. import _core
from .._arrays import Array, Floats, Labelled, Scalar
from .._dispatch import Elementwise, apply
from .._messages import explained
from .._scalars import real
from ..pendulum import Pendulum
from ._angle import THETA, AngleError
from ._named import moving
from ._registry import Registry

# SciPy's answer is asked for at this many instants a period, as a student asks for a smooth curve.
INSTANTS = 1000
# A fixed step beyond this count is refused: the arrays would fill the memory.
MOST_STEPS = 5_000_000
MOST_PERIODS = 10_000
NUMBER = re.compile(r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
SCIPY = {
    "solve_ivp": "Dormand-Prince 5(4) at rtol 1e-3 and atol 1e-6, the defaults of scipy.integrate.solve_ivp",
    "odeint": "LSODA at rtol and atol 1.49e-8, the defaults of scipy.integrate.odeint",
}


@dataclass(frozen=True)
class NumericalFormula:
    """A numerical scheme by name: one of steps of H s, such as `rk4:H`, or `rk45`, `solve_ivp`, `odeint`.

    Of steps of H s are `euler:H`, `euler-cromer:H`, `verlet:H` and `rk4:H`.

    Parameters
    ----------
    name : str
        Such as ``rk4:0.025``. Steps are positive decimal numbers in s; the name is kept with the shortest that is the
        same double.

    Raises
    ------
    ValueError
        In one line: the name and what is allowed, the nearest known names first.

    Examples
    --------
    >>> from libration import Pendulum, approx
    >>> euler = approx.numerical("euler:0.01")
    >>> f"{euler.of(Pendulum(1.0)).error(1).relative:.4f}"
    '0.0315'
    """

    name: str

    def __post_init__(self) -> None:
        _, colon, step = self.name.partition(":")
        if self.scheme not in SCHEMES and self.scheme not in SCIPY:
            near = ", ".join(nearest(numerical.names, self.name))
            raise ValueError(f"numerical solution = {self.name!r}: must be one of {near}")
        if self.scheme not in STEPPED and colon and (self.scheme in SCIPY or self.scheme in SCHEMES):
            raise ValueError(f"numerical solution = {self.name!r}: must be {self.scheme} without a step")
        if self.scheme in STEPPED:
            if not (NUMBER.fullmatch(step) and 0 < self.step < math.inf):
                allowed = f"{self.scheme}:H with a step H > 0 in s, as {self.scheme}:0.01"
                raise ValueError(f"numerical solution = {self.name!r}: must be {allowed}")
            object.__setattr__(self, "name", f"{self.scheme}:{self.step!r}".removesuffix(".0"))

    @property
    def scheme(self) -> str:
        """The name without its step."""
        return self.name.partition(":")[0]

    @property
    def step(self) -> float:
        """The step in s; NaN where there is none."""
        return float(self.name.partition(":")[2] or math.nan)

    @property
    def formula(self) -> str:
        """What it does, in one line."""
        return SCHEMES[self.scheme][0] if self.scheme in SCHEMES else SCIPY[self.scheme]

    @property
    def source(self) -> str:
        """Who says so, with the order of the scheme."""
        return SCHEMES[self.scheme][1] if self.scheme in SCHEMES else f"SciPy, scipy.integrate.{self.scheme}"

    @explained
    def of(self, pendulum: Pendulum) -> NumericalSolution:
        """The numerical solution for one pendulum.

        Parameters
        ----------
        pendulum : Pendulum
            The motion to solve for.

        Returns
        -------
        NumericalSolution

        Raises
        ------
        ValueError
            If it is no pendulum.
        ImportError
            For SciPy's, if SciPy is missing.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> f"{approx.numerical('rk4:0.1').of(Pendulum(1.0)).theta(2.0):.6f}"
        '-0.306200'
        """
        moving(pendulum)
        if self.scheme in SCIPY and importlib.util.find_spec("scipy") is None:
            raise ImportError(f"{self.name}: needs SciPy: pip install 'libration[papers]'")
        return NumericalSolution(self, pendulum)


@dataclass(frozen=True)
class NumericalSolution:
    """What a numerical scheme makes of one pendulum; from `NumericalFormula.of`.

    Parameters
    ----------
    formula : NumericalFormula
        The scheme.
    pendulum : Pendulum
        The motion.

    Examples
    --------
    >>> from libration import Pendulum, approx
    >>> solution = approx.numerical("euler-cromer:0.01").of(Pendulum(1.0))
    >>> f"{solution.error().relative:.1e}"
    '4.8e-03'
    """

    formula: NumericalFormula
    pendulum: Pendulum

    @overload
    def theta(self, t: Scalar) -> np.float64: ...
    @overload
    def theta(self, t: Array) -> Floats: ...
    @overload
    def theta(self, t: Labelled) -> Labelled: ...
    @explained
    def theta(self, t: Any) -> Any:
        """Angle at the times `t`.

        Parameters
        ----------
        t : scalar or array
            Time in s, finite and not negative. Between steps of fixed length the cubic through both states is taken, in a
            step of `rk45` its interpolant. As in SciPy its last step ends at the last of the times.

        Returns
        -------
        float64 or array of the shape of `t`
            Angle in rad. Dask, xarray and pandas arrays give their like.

        Raises
        ------
        ValueError
            In one line, for times that are not finite or negative.

        Notes
        -----
        Error promised: none; it is what is measured. Source: `NumericalFormula.source`.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> approx.numerical("euler:0.1").of(Pendulum(1.0)).theta([0.0, 2.0]).round(6)
        array([ 1.      , -0.320161])
        """
        return apply(Elementwise(self._theta), t, results=(THETA,))

    @explained
    def error(self, periods: float = 1.0) -> AngleError:
        """Largest difference from the exact motion, at the steps themselves or at 1,000 instants a period.

        Parameters
        ----------
        periods : float, default 1
            From 0, not included, to 10,000; of a turn each in rotation.

        Returns
        -------
        AngleError

        Raises
        ------
        ValueError
            If the number of periods is out of range; on the separatrix, which has no period.

        Notes
        -----
        Error promised: none; the exact motion is that of `Pendulum.theta`. Source: Lima 2019, section 4.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> f"{approx.numerical('rk4:0.1').of(Pendulum(1.0)).error(10).relative:.1e}"
        '2.1e-05'
        """
        t, theta = course(self, real("periods", periods))
        difference = np.abs(theta - self.pendulum.theta(t))
        where = int(np.nanargmax(difference)) if not np.isnan(difference).all() else 0
        largest, theta_max = float(difference[where]), self.pendulum.theta_max
        return AngleError(largest, largest / theta_max if theta_max else 0.0, float(t[where]), math.nan)

    @explained
    def over_the_top(self, periods: float = 1.0) -> float:
        """When a swing is carried over the top, which the exact one never reaches; NaN if it is not.

        Parameters
        ----------
        periods : float, default 1
            How long to look, as in `error`.

        Returns
        -------
        float
            Time in s; NaN in rotation, and where it stays below the top.

        Examples
        --------
        >>> from libration import Pendulum, approx
        >>> f"{approx.numerical('euler:0.1').of(Pendulum(3.0)).over_the_top(10):.4f}"
        '6.5322'
        """
        if self.pendulum.regime != "libration":
            return math.nan
        t, theta = course(self, real("periods", periods))
        bottom = sum(self.pendulum.extremes) / 2
        beyond = np.abs(theta - bottom) > math.pi
        if not beyond.any():
            return math.nan
        after = int(np.argmax(beyond))
        sides = np.abs(theta[after - 1 : after + 1] - bottom)
        return float(np.interp(math.pi, sides, t[after - 1 : after + 1]))

    def _theta(self, t: np.ndarray) -> np.ndarray:
        wrong = t[~(np.isfinite(t) & (t >= 0))]
        if wrong.size:
            raise ValueError(
                f"t = {float(wrong[0])!r}: must be finite and not negative, for a solution that begins at 0"
            )
        rising, place = np.unique(t, return_inverse=True)
        return self._rising(rising)[place] if rising.size else t

    def _instants(self, periods: float) -> np.ndarray:
        """The instants at which it is compared."""
        last = checked_span(periods, self.pendulum)
        if self.formula.scheme not in STEPPED:
            return np.linspace(0.0, last, math.ceil(INSTANTS * periods) + 1)
        t = self.formula.step * np.arange(self._steps(last) + 1)
        # The last step may end beyond.
        return np.append(t[t < last], last)

    def _steps(self, last: float) -> int:
        """How many steps there are to a time."""
        count = last / self.formula.step
        if count > MOST_STEPS:
            raise ValueError(f"{self.formula.name} = {count:.3g} steps: must be at most {MOST_STEPS:,} steps")
        return max(math.ceil(count), 1)

    def _rising(self, t: np.ndarray) -> np.ndarray:
        """Angle at times that rise."""
        pendulum, scheme, until = self.pendulum, self.formula.scheme, float(t[-1])
        if scheme in SCIPY:
            start = pendulum.theta0, pendulum.velocity0
            return scipy_solution(scheme, start, pendulum.omega2, t)
        step = self.formula.step if scheme in STEPPED else None
        theta: np.ndarray = _core.NumericalSolution(scheme, step, pendulum._orbit, until).theta(t)
        return theta


SCHEMES: dict[str, tuple[str, str]] = {name: (formula, source) for name, formula, source, _ in _core.schemes()}
STEPPED = frozenset(name for name, _, _, stepped in _core.schemes() if stepped)
USUAL = {"euler": "0.01", "euler-cromer": "0.01", "verlet": "0.01", "rk4": "0.025"}
PATTERNS = [f"{name}:H" if name in STEPPED else name for name in SCHEMES]
numerical = Registry(NumericalFormula, [*PATTERNS, *SCIPY], USUAL)


def nearest(patterns: Iterable[str], wanted: str) -> list[str]:
    """Names with what follows their colon, those most like a wanted one first."""
    from difflib import SequenceMatcher

    base = wanted.partition(":")[0].lower()
    return sorted(patterns, key=lambda each: -SequenceMatcher(None, each.partition(":")[0], base).ratio())


@lru_cache(maxsize=1)
def course(solution: NumericalSolution, periods: float) -> tuple[np.ndarray, np.ndarray]:
    """Instants and angles over so many periods; the last are kept: a table asks both for the top and for the error."""
    t = solution._instants(periods)
    return t, solution._rising(t)


def checked_span(periods: float, pendulum: Pendulum) -> float:
    """The time of so many periods, in s."""
    if not 0 < periods <= MOST_PERIODS:
        raise ValueError(f"periods = {periods!r}: must be above 0 and at most {MOST_PERIODS}")
    last = periods * pendulum.period
    if not math.isfinite(last):
        raise ValueError(f"period = {pendulum.period}: must be finite for an error over periods")
    return last


def scipy_solution(name: str, start: tuple[float, float], omega2: float, t: np.ndarray) -> np.ndarray:
    """SciPy's answer with its own tolerances."""
    integrate = importlib.import_module("scipy.integrate")

    def slopes(_t: float, state: np.ndarray) -> tuple[float, float]:
        return state[1], -omega2 * math.sin(state[0])

    from_start = t if t[0] == 0 else np.append(0.0, t)
    if from_start.size == 1:
        return np.array(start[:1])
    if name == "odeint":
        theta: np.ndarray = integrate.odeint(slopes, start, from_start, tfirst=True)[:, 0]
    else:
        theta = integrate.solve_ivp(slopes, (0.0, float(t[-1])), start, t_eval=from_start).y[0]
    return theta[-t.size :]
