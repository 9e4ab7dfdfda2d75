"""`libration.fit`: from measurements to omega0, g or the length, with the friction and an honest uncertainty."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from .. import _core
from .._scalars import real, shown
from ._columns import ARRAYS, Given, measure, of_source, stated_of
from ._result import Fit

# Shape, and mass, distance of the centre and size with their uncertainties.
MeasuredPart: TypeAlias = tuple[str, tuple[float, float], tuple[float, float], tuple[float, float]]
MODELS = ("auto", *_core.friction_models())


def fit(
    source: Any,
    values: Any = None,
    *,
    length: Any = None,
    gravity: Any = None,
    parts: Sequence[tuple[Any, ...]] = (),
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
) -> Fit:
    """Fit a pendulum with friction to measurements: omega0, and g from the length or the length from g.

    theta'' + 2 linear theta' + quadratic abs(theta') theta' + dry sgn(theta') + omega0**2 sin(theta - offset) = 0

    No start values are needed. The state, the rest and omega0 are always free; friction terms are added while the record asks for
    them.

    Parameters
    ----------
    source : path, data frame, array_like of shape (n,), or (t, values)
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
    Econometrica 55 (1987) 703). A record that is no pendulum's has a verdict that says so: see `Fit.stands`. Ctrl-C ends it.

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
    if model not in MODELS:
        raise ValueError(f"model = {shown(model)}: must be one of {', '.join(MODELS)}")
    known_length = None if length is None else measure("length", length)
    known_gravity = None if gravity is None else measure("gravity", gravity)
    if known_length and known_gravity:
        raise ValueError("length and gravity: give one of the two; the motion holds g/length alone")
    known_parts = [measured_part(each) for each in parts]
    stated = stated_of(columns, units, None if rate is None else real("rate", rate), run, known_length)
    given = of_source(source, values, quantity, stated)
    return fit_given(
        given,
        length=known_length,
        gravity=known_gravity,
        parts=known_parts,
        model=model,
        window=window,
        scale_u=scale_u,
        clock_u=clock_u,
        free_scale=free_scale,
        bootstrap=bootstrap,
    )


def fit_given(
    given: Given,
    *,
    length: tuple[float, float] | None = None,
    gravity: tuple[float, float] | None = None,
    parts: Sequence[MeasuredPart] = (),
    model: str = "auto",
    window: tuple[float, float] | None = None,
    scale_u: float = 0.0,
    clock_u: float = 0.0,
    free_scale: bool = False,
    bootstrap: int = 0,
) -> Fit:
    """The fit of columns, with what is known as pairs."""
    span = None if window is None else (real("window[0]", window[0]), real("window[1]", window[1]))
    try:
        found = _core.fit_columns(
            given.kind,
            given.columns,
            length,
            gravity,
            list(parts),
            None if model == "auto" else model,
            span,
            (real("scale_u", scale_u), real("clock_u", clock_u)),
            bool(free_scale),
            (int(bootstrap), 0, 1),
        )
    except ValueError as error:
        raise ValueError(str(error) if given.name == ARRAYS else f"{given.name}: {error}") from None
    return Fit(given, *found)


def measured_part(given: Any) -> MeasuredPart:
    """A part of a rigid pendulum, or a ValueError."""
    if not isinstance(given, tuple | list) or len(given) != 4 or not isinstance(given[0], str):
        raise ValueError(f"parts: {shown(given)} must be (shape, mass, distance, size)")
    shape, mass, distance, size = given
    return shape, measure("mass", mass), measure("distance", distance), measure("size", size)
