"""A fit: the data with the fitted curve, the residuals below; and the period of each swing against its size."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .._scalars import shown
from ._axes import given_or_new, named
from ._language import ENGLISH, Language
from ._style import BLACK, EXACT, LINEAR, SEPARATRIX, head, legend, part_of, quiet, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Of a longer record the first of so many periods are drawn above; the residuals are of all.
PERIODS = 12.0
# More dots than these are one raster in an SVG.
MANY_DOTS = 2500
# More dots than these, of twelve periods, hide the curve below them.
DENSE = 400
# Fewer samples in a period do not show its turns.
LEAST_SAMPLES = 8.0
# The curve between the samples must pass them within this part of the swing.
NEAR = 2e-3
WORDS = {"angle": "angle [degrees]", "velocity": "angular velocity [rad/s]", "acceleration": "acceleration [m/s²]"}


def plot_fit(
    fit: Any, path: Any, *, form: str | None = None, title: str | None = None, dpi: float = 100, lang: str = "en"
) -> None:
    """Draw a fit and save the picture: the data with the fitted curve, and the residuals below.

    Of a long record the first twelve periods are drawn above, and the residuals of all of it below. Into axes of your own:
    `Fit.plot`.

    Parameters
    ----------
    fit : Fit
        What `libration.fit` has found.
    path : str, path or binary file
        Where to save.
    form : str, optional
        `png` or `svg`; by default the ending of `path`.
    title : str, optional
        The line above the picture; by default it says the result. An empty one leaves it out.
    dpi : scalar, default 100
        Dots per inch of a PNG of 9 by 6.5 inches, from 20 to 1200.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If `fit` is no Fit, or `dpi`, `form` or `lang` is none of those.

    Examples
    --------
    >>> from io import BytesIO
    >>> import libration
    >>> from libration.plot import plot_fit
    >>> found = libration.fit([0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847], quantity="swings")
    >>> picture = BytesIO()
    >>> plot_fit(found, picture, form="png", lang="es")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    if not hasattr(fit, "residuals"):
        raise ValueError(f"fit = {shown(fit)}: must be a Fit, which libration.fit makes")
    say = Language(lang)

    def draw(figure: Any) -> None:
        draw_both(figure, fit, say)
        head(figure, headline(fit, say) if title is None else title)

    save_figure({form: path}, (9, 6.5), draw, dpi=dpi)


def headline(fit: Any, say: Language = ENGLISH) -> str:
    """The result in one line."""
    if not fit.stands:
        return say.word("Not a result: a verdict speaks against it")
    parts = [f"$\\omega_0$ = {fit.omega0} rad/s"]
    if fit.g is not None and fit.length is not None:
        parts += [f"$g$ = {fit.g} m/s²", f"$\\ell$ = {fit.length} m"]
    return say.decimal("; ".join(parts))


def fit_axes(fit: Any, ax: Any, lang: str) -> Axes:
    """Draw data and curve into axes of the user, or both panels into a new figure; return those of the data."""
    say = Language(lang)
    axes, new = given_or_new(ax, (7.5, 5.6))
    if new:
        figure = axes.figure
        axes.remove()
        draw_both(figure, fit, say)
        return figure.axes[0]
    draw_data(axes, fit, say)
    say.ticks(axes)
    named(axes, new)
    return axes


def draw_both(figure: Any, fit: Any, say: Language) -> None:
    """Data with the curve above, residuals below."""
    upper, lower = figure.subplots(2, 1, height_ratios=(1.7, 1))
    for axes in (upper, lower):
        quiet(axes)
    draw_data(upper, fit, say)
    draw_residuals(lower, fit, say)
    say.ticks(upper, lower)
    legend(upper)


def is_table(fit: Any) -> bool:
    """Whether periods stand against swings."""
    return bool(fit._given.kind == "swings")


def abscissa(fit: Any) -> np.ndarray:
    """Times in s, or swings in degrees."""
    if not is_table(fit):
        times: np.ndarray = fit.t
        return times
    left_out = {row for each in fit.dropped for row in each.get("rows", ())}
    swings = np.abs(np.asarray(fit._given.columns[0]))
    kept = np.array([row not in left_out for row in range(swings.size)], dtype=bool)
    found: np.ndarray = np.degrees(swings[kept])
    return found


def factor(fit: Any) -> float:
    """From the unit of the record to that of the picture."""
    return math.degrees(1.0) if fit._given.kind == "angle" else 1.0


def draw_data(axes: Any, fit: Any, say: Language) -> None:
    """The samples as dots and the curve through them."""
    x, unit = abscissa(fit), factor(fit)
    order = np.argsort(x, kind="stable")
    x, measured, fitted = x[order], unit * fit.measured[order], unit * (fit.measured - fit.residuals)[order]
    shown_to = x[-1]
    if fit._given.kind in WORDS:
        shown_to = min(shown_to, x[0] + PERIODS * 2 * math.pi / fit.omega0.value)
    part = x <= shown_to
    dots = {"marker": "o", "ms": 2.6 if part.sum() > 200 else 4.0, "ls": "none", "mew": 0, "zorder": 3}
    axes.plot(
        x[part], measured[part], color=SEPARATRIX, alpha=0.75, label=say.word("measured"), rasterized=part.sum() > MANY_DOTS, **dots
    )  # fmt: skip
    at, curve = between(fit, x[part], fitted[part], unit)
    # Dots that touch each other would hide it.
    dense = part.sum() > DENSE
    axes.plot(at, curve, color=EXACT, lw=1.0 if dense else 1.4, label=say.word("fitted"), zorder=4 if dense else 2)
    if is_table(fit):
        axes.set_xlabel(say.word("turning angle θmax [degrees]"))
        axes.set_ylabel(say.word("period [s]"))
        return
    axes.set_xlabel(part_of("t [s]", x[0], shown_to, x[0], x[-1], say, 3))
    axes.set_ylabel(say.word(WORDS.get(fit._given.kind, "period [s]")))
    axes.margins(x=0.01)


def between(fit: Any, x: np.ndarray, fitted: np.ndarray, unit: float) -> tuple[np.ndarray, np.ndarray]:
    """The fitted curve between the samples too, where the motion passes them; else at the samples."""
    if fit._given.kind not in ("angle", "velocity") or x.size < 2:
        return x, fitted
    fine = np.linspace(x[0], x[-1], 2400)
    scale = unit * (1.0 if fit.scale is None else fit.scale.value)
    offset = unit * (0.0 if fit.offset is None else fit.offset.value)
    try:
        motion = fit.motion()
        curve, at_samples = (
            offset
            + scale * np.asarray((motion.theta if fit._given.kind == "angle" else motion.velocity)(t - fit.state_time))
            for t in (fine, x)
        )
    except (ValueError, ArithmeticError):
        return x, fitted
    if not np.abs(at_samples - fitted).max() <= NEAR * np.ptp(fitted):
        return x, fitted
    return fine, curve


def draw_residuals(axes: Any, fit: Any, say: Language) -> None:
    """Measured less fitted, of all samples."""
    x, residuals = abscissa(fit), fit.residuals
    periods = fit._given.kind in ("gate", "swings")
    unit = 1000.0 if periods else factor(fit)
    dots = {"ms": 2.0 if x.size > 200 else 4.0, "mew": 0, "rasterized": x.size > MANY_DOTS}
    axes.axhline(0.0, color=BLACK, lw=0.8)
    axes.plot(x, unit * residuals, "o", color=SEPARATRIX, alpha=0.6, **dots)
    axes.set_xlabel(say.word("turning angle θmax [degrees]") if is_table(fit) else "t [s]")
    kind = "ms" if periods else {"angle": "degrees", "velocity": "rad/s", "acceleration": "m/s²"}[fit._given.kind]
    axes.set_ylabel(say.word("residual [{unit}]", unit=say.word("degrees") if kind == "degrees" else kind))
    axes.margins(x=0.01)


def swings_of(fit: Any) -> tuple[np.ndarray, np.ndarray]:
    """Of a record of angles: half the distance between the turns of each period, in rad, and the period in s."""
    empty = np.empty(0), np.empty(0)
    if fit._given.kind != "angle" or fit.to_dict()["diagnostics"]["samples_per_period"] < LEAST_SAMPLES:
        return empty
    t, y = fit.t, fit.measured - fit.offset.value
    usual = 2 * math.pi / fit.omega0.value
    up = np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))
    if up.size < 2:
        return empty
    # Several crossings of one passage are noise: their mean is the passage.
    crossed = t[up] - y[up] * (t[up + 1] - t[up]) / (y[up + 1] - y[up])
    groups = np.split(np.arange(up.size), np.flatnonzero(np.diff(crossed) > usual / 4) + 1)
    times = np.array([crossed[group].mean() for group in groups])
    rows = np.searchsorted(t, times)
    sizes = np.array([np.ptp(y[first:last]) / 2 for first, last in itertools.pairwise(rows)])
    periods = np.diff(times)
    # A gap of the record is no period.
    whole = (periods > 0.7 * usual) & (periods < 1.4 * np.median(periods))
    return sizes[whole], periods[whole]


def draw_swings(axes: Any, fit: Any, say: Language) -> bool:
    """Period against swing, with the exact curve and the constant of small swings; whether there was anything to draw."""
    from ..pendulum import Pendulum

    sizes, periods = swings_of(fit)
    if sizes.size < 3:
        return False
    quiet(axes)
    axes.plot(np.degrees(sizes), periods, "o", ms=3, mew=0, color=SEPARATRIX, alpha=0.6, label=say.word("measured"))
    most = min(1.05 * float(sizes.max()), 3.14)
    angles = np.linspace(0.0, most, 120)
    exact = [Pendulum(float(angle), omega0=fit.omega0.value).period for angle in angles]
    axes.plot(np.degrees(angles), exact, color=EXACT, lw=1.6, label=say.word("exact"))
    axes.axhline(exact[0], color=LINEAR, lw=1.2, ls=(0, (5, 3)), label=say.word("linear"))
    axes.set_xlabel(say.word("turning angle θmax [degrees]"))
    axes.set_ylabel(say.word("period [s]"))
    say.ticks(axes)
    legend(axes)
    return True
