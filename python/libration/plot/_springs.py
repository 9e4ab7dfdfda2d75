"""The picture of a nonlinear spring's motion: u(t), and the phase portrait with its separatrices."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from .._scalars import shown
from ..oscillator._oscillator import Oscillator
from ._axes import named
from ._displacement import seen
from ._language import ENGLISH, Language
from ._potential import barriers, coefficients, equilibria, potential, reach, scaled
from ._style import EXACT, FAINT, FEW, SEPARATRIX, finite, part_of, quiet, save


def plot_oscillator(
    oscillator: Oscillator,
    t: Any,
    path: Any,
    *,
    form: str | None = None,
    title: str | None = None,
    dpi: float = 100,
    lang: str = "en",
) -> None:
    """Draw u(t) beside the phase portrait and save the picture.

    Left: the displacement over the range of `t`, a dashed line at each escape, and a dot at each instant if they are few.
    Right: velocity against displacement, the orbit (strong), the separatrices (dashed) and other energies (faint).

    Parameters
    ----------
    oscillator : Duffing or CubicQuintic
        The motion.
    t : array_like
        Instants, s, in any order; at least one.
    path : str, path or binary file
        Where to save.
    form : str, optional
        `png` or `svg`; by default the ending of `path`. The text of an SVG is text.
    title : str, optional
        The line above the picture; by default it says the equation, the start and the regime. An empty one leaves it out.
    dpi : scalar, default 100
        Dots per inch of a PNG of 12 by 5 inches, from 20 to 1200.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If there is no finite instant, or `dpi` or `lang` is none of those; it or an OverflowError if the motion is too
        large for an axis (about 1e150).

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration import Duffing
    >>> from libration.plot import plot_oscillator
    >>> picture = BytesIO()
    >>> plot_oscillator(Duffing(1.0, p=-1.0, q=1.0), [0.0, 10.0], picture, form="png")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    if not hasattr(oscillator, "u0"):
        raise ValueError(f"oscillator = {shown(oscillator)}: must be a Duffing or a CubicQuintic")
    t, say = finite(t), Language(lang)
    panels = (
        lambda axes: draw_displacement(axes, oscillator, t, say),
        lambda axes: draw_portrait(axes, oscillator, say),
    )
    save(path, form, headline(oscillator, say) if title is None else title, *panels, dpi=dpi)


def headline(oscillator: Oscillator, say: Language = ENGLISH) -> str:
    """Equation, regime and what goes with it in one line."""
    given = ", ".join(f"{letter} = {say.number(value)}" for letter, value in coefficients(oscillator))
    start = f"{given}, u(0) = {say.number(oscillator.u0)}, u′(0) = {say.number(oscillator.velocity0)}"
    regime = say.word(str(oscillator.regime))
    if math.isfinite(oscillator.period):
        words = "{start}: {regime}, period {period} s"
        return say.word(words, start=start, regime=regime, period=say.number(oscillator.period))
    ends = [end for end in (oscillator.escape_time_backward, oscillator.escape_time) if math.isfinite(end)]
    if len(ends) == 2:
        first, second = map(say.number, ends)
        both = say.word("{first} s and {second} s", first=first, second=second)
        return say.word("{start}: {regime} at t = {ends}", start=start, regime=regime, ends=both)
    if ends:
        return say.word("{start}: {regime} at t = {ends}", start=start, regime=regime, ends=f"{say.number(ends[0])} s")
    return f"{start}: {regime}"


def draw_displacement(axes: Any, oscillator: Oscillator, t: np.ndarray, say: Language = ENGLISH) -> None:
    """The left panel: u over t, as far as it is in the picture."""
    first, last = t.min(), t.max()
    if first == last:
        first, last = sorted((0.0, first))
    fine, u = seen(oscillator, first, last)
    axes.set_xlabel(part_of("t [s]", fine[0], fine[-1], first, last, say))
    if last > first:
        axes.plot(fine, u, color=EXACT, lw=2, label=say.word("exact"))
        axes.set_xlim(fine[0], fine[-1])
    t = t[(fine[0] <= t) & (t <= fine[-1])]
    if 0 < t.size <= FEW:
        axes.plot(t, oscillator.u(t), "o", ms=4, color=EXACT, label=say.word("instants"))
    label: str | None = say.word("escape")
    for end in (oscillator.escape_time_backward, oscillator.escape_time):
        if fine[0] <= end <= fine[-1]:
            axes.axvline(end, color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label=label)
            label = None
    axes.set_ylabel("u")
    quiet(axes)
    say.ticks(axes)
    named(axes, new=True)


def draw_portrait(axes: Any, oscillator: Oscillator, say: Language = ENGLISH) -> None:
    """The right panel: velocity over displacement, by the levels of the energy.

    Displacements count in units of the picture's half width and velocities in what the largest force makes of it, so
    that no energy leaves the range of the doubles.
    """
    width = reach(oscillator)
    stiffness, rate = scaled(oscillator, width)
    grid = np.linspace(-1, 1, 801)
    depth = potential(stiffness, grid)
    resting = [0.0, *(u / width for u in equilibria(oscillator))]
    energies = [float(potential(stiffness, x)) for x in resting]
    own = (oscillator.velocity0 / width / rate) ** 2 / 2 + potential(stiffness, oscillator.u0 / width)
    lowest = depth.min()
    if not all(math.isfinite(end) for end in oscillator.range):
        lowest = min(depth[np.abs(grid) < 0.5].min(), *energies)
    height = 1.35 * math.sqrt(2 * max(own - lowest, max(energies) - lowest, 1e-12))
    speed = np.linspace(-height, height, 601)
    energy = depth[None, :] + speed[:, None] ** 2 / 2
    low, high = energy.min(), energy.max()
    faint = [low + (high - low) * part for part in (0.02, 0.06, 0.12, 0.22, 0.35, 0.5, 0.7)]
    scale = grid * width, speed * (width * rate), energy
    axes.contour(*scale, levels=faint, colors=FAINT, linewidths=0.9, linestyles="solid")
    saddles = [level for level in barriers(stiffness, resting) if low < level < high]
    if saddles:
        axes.contour(*scale, levels=saddles, colors=SEPARATRIX, linewidths=1.1, linestyles="dashed")
    axes.plot(*along(oscillator, width), color=EXACT, lw=2, label=say.word("this motion"))
    axes.plot([oscillator.u0], [oscillator.velocity0], "o", ms=6, color=EXACT, label="t = 0 s")
    if saddles:
        axes.plot([], [], color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label=say.word("separatrix"))
    axes.plot([], [], color=FAINT, lw=0.9, label=say.word("other energies"))
    axes.set(xlim=(-width, width), ylim=(scale[1][0], scale[1][-1]))
    axes.set_xlabel("u")
    axes.set_ylabel(r"$\dot u$")
    quiet(axes)
    say.ticks(axes)
    named(axes, new=True)


def along(oscillator: Oscillator, width: float) -> tuple[np.ndarray, np.ndarray]:
    """The whole orbit, as far as the picture shows it."""
    back, ahead = oscillator.escape_time_backward, oscillator.escape_time
    scale = oscillator.period if math.isfinite(oscillator.period) else 40 / scaled(oscillator, width)[1]
    start = max(back, -scale)
    stop = min(ahead, scale)
    # Denser towards the ends, where an escape runs away.
    part = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, 6000))
    u, velocity = oscillator.motion(start + (stop - start) * part)
    inside = np.abs(u) <= 1.05 * width
    return np.where(inside, u, np.nan), np.where(inside, velocity, np.nan)
