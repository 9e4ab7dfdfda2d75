"""`libration.fit`: from measurements to omega0, g or the length, with the friction and an honest uncertainty."""

from collections.abc import Mapping, Sequence
from typing import Any

from .. import _core
from .._scalars import real
from ._columns import ARRAYS, Given, of_source, stated_of
from ._known import Known, known_of
from ._progress import told_steps
from ._result import Fit


def fit(
    source: Any,
    values: Any = None,
    *,
    length: Any = None,
    gravity: Any = None,
    parts: Sequence[tuple[Any, ...]] = (),
    bob: Any = None,
    wire: float | None = None,
    fluid: Any = "air",
    without: str | Sequence[str] = (),
    model: str = "auto",
    quantity: str = "angle",
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    rate: float | None = None,
    run: int | None = None,
    window: tuple[float, float] | None = None,
    scale_u: float = 0.0,
    clock_u: float = 0.0,
    free_scale: bool = False,
    bootstrap: int = 0,
    monte_carlo: int = 0,
    seed: int = 1,
    progress: bool = False,
) -> Fit:
    """Fit a pendulum with friction to measurements: omega0, and g from the length or the length from g.

    theta'' + 2 linear theta' + quadratic abs(theta') theta' + dry sgn(theta') + omega0**2 sin(theta - offset) = 0

    No start values are needed. The state, the rest and omega0 are always free; friction terms are added while the record asks for
    them. Several records of one pendulum, or of several lengths, are for `fit_together`.

    Parameters
    ----------
    source : path, data frame, array_like of shape (n,) or (n, 2), or (t, values)
        A file of measurements; a table of pandas or Polars; or times in s, with `values` beside them.
    values : array_like of shape (n,), optional
        What was measured at these times, in SI units; values that are not finite are left out.
    length : scalar or (value, u), optional
        The equivalent length in m with its standard uncertainty; gives g.
    gravity : scalar or (value, u), optional
        The local g in m/s**2; gives the length. Not beside `length`: the motion holds g/length alone.
    parts : sequence of (shape, mass, distance, size), optional
        A rigid pendulum in place of `length`: "rod", "ball", "disc" or "point"; mass in kg; distance of its centre below the pivot in
        m; length of a rod or radius of a ball or a disc in m, 0 for a point. Each number may be (value, u).
    bob : scalar or (radius, mass), optional
        Radius in m, and mass in kg, of a ball on a thread, to whose centre the length goes: its size, its buoyancy and the fluid that
        it takes along are corrected.
    wire : scalar, optional
        Mass of the thread or wire in kg, for its correction.
    fluid : {"air", "water"} or (density, viscosity)
        In kg/m**3 and m**2/s; air and water of 20 degrees Celsius.
    without : str or sequence of str, optional
        Corrections that are not made, only tabulated: "bob size", "wire mass", "buoyancy", "added mass".
    model : {"auto", "none", "linear", "quadratic", "dry", "presliding"}
        The friction; each has the terms of those before it. "auto" chooses by Schwarz's criterion.
    quantity : {"angle", "velocity", "acceleration", "gate", "swings"}
        What `values` are: rad, rad/s, m/s**2 along the path; or periods in s at the times, or at the angles, of `source`.
    columns, units : mapping, optional
        Names of columns, and their units, by what they are: time, angle, velocity, acceleration, x, y, period. For files and tables.
    rate : scalar, optional
        Samples in a second, for a file without times.
    run : int, optional
        Which of several runs in a file, from 1.
    window : (float, float), optional
        The times in s that are fitted; by default from the release to the stop.
    scale_u, clock_u : scalar, default 0.0
        Relative standard uncertainties of the angle's scale and of the clock.
    free_scale : bool, default False
        Whether the scale of the angle is fitted too.
    bootstrap : int, default 0
        Resamplings of the block bootstrap, a check of the uncertainty.
    monte_carlo : int, default 0
        Draws of the Monte Carlo propagation, from 100: the interval that holds 95 % of g, of the length or of omega0.
    seed : int, default 1
        Of the random numbers of both.
    progress : bool, default False
        Whether a bar is shown on the standard error of a terminal while the fit takes long, where rich is installed.

    Returns
    -------
    Fit

    Raises
    ------
    ValueError
        In one line: what, which value or line, and what is allowed.
    OSError
        If the file cannot be read.

    Notes
    -----
    Accuracy: the minimum to 1e-8 of the cost; the uncertainties after JCGM 100:2008, robust to correlated residuals (Newey and West,
    Econometrica 55 (1987) 703); the draws after JCGM 101:2008. Corrections: Nelson and Olsson, Am. J. Phys. 54 (1986) 112; a tenth of
    each is taken as its uncertainty. A record that is no pendulum's has a verdict that says so: see `Fit.stands`. Ctrl-C ends it.

    Examples
    --------
    >>> import numpy as np
    >>> import libration
    >>> t = np.linspace(0.0, 20.0, 400)
    >>> theta = libration.DampedPendulum(1.0, length=0.8, friction=libration.Friction(linear=0.02)).theta(t)
    >>> theta += np.random.default_rng(1).normal(0.0, 0.01, t.size)
    >>> found = libration.fit(t, theta, length=(0.8, 0.001))
    >>> print(found.model, found.g)
    linear 9.807 ± 0.012
    """
    known = known_of(
        length=length,
        gravity=gravity,
        parts=parts,
        bob=bob,
        wire=wire,
        fluid=fluid,
        without=without,
        model=model,
        window=window,
        scale_u=scale_u,
        clock_u=clock_u,
        free_scale=free_scale,
        bootstrap=bootstrap,
        monte_carlo=monte_carlo,
        seed=seed,
    )
    stated = stated_of(columns, units, None if rate is None else real("rate", rate), run, known["length"])
    return fit_given(of_source(source, values, quantity, stated), known, progress)


def fit_given(given: Given, known: Known, progress: bool = False) -> Fit:
    """The fit of columns, with what is known."""
    try:
        with told_steps([given.name], progress) as told:
            found = _core.fit_columns((given.kind, given.columns), known, told)
    except ValueError as error:
        raise ValueError(str(error) if given.name == ARRAYS else f"{given.name}: {error}") from None
    return Fit(given, *found)
