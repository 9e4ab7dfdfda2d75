"""The phase portrait of a pendulum: velocity over omega0 against the angle, on one turn around the stable equilibrium."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._angle import state_text, time_scale
from ._axes import given_or_new, named, once
from ._language import ENGLISH, Language
from ._style import EXACT, FAINT, SEPARATRIX, angle_ticks, finite, quiet

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Orbits of other energies: their energy ratios.
LEVELS = (0.05, 0.2, 0.45, 0.75, 1.4, 2.0)
# Below this energy ratio an orbit is too small to see and is enlarged in a corner.
SMALL = 0.01
# On the separatrix, this many radians of omega0 t on both sides; without a force, this many seconds.
PHASE, SECONDS = 12.0, 10.0


def phase_axes(pendulum: Any, t: Any, ax: Any, *, others: bool, lang: str, style: dict[str, Any]) -> Axes:
    """Draw the phase portrait into axes of the user or new ones, and return them."""
    say = Language(lang)
    t = whole_orbit(pendulum) if t is None else finite(t)
    axes, new = given_or_new(ax, (6.4, 4.8))
    style = {"label": state_text(pendulum, say)} | style
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        draw_orbits(axes, pendulum, t, others=others, say=say, style=style)
    say.ticks(axes)
    named(axes, new)
    return axes


def whole_orbit(pendulum: Any) -> np.ndarray:
    """From the start once around; on the separatrix from one end to the other."""
    if np.isfinite(pendulum.period):
        return np.array([0.0, pendulum.period])
    long = PHASE / pendulum.omega0 if pendulum.omega0 else SECONDS
    return np.array([-long, long])


def draw_portrait(axes: Any, pendulum: Any, t: np.ndarray, say: Language = ENGLISH) -> None:
    """The right panel of a saved picture."""
    quiet(axes)
    style = {"color": EXACT, "lw": 1.8, "label": say.word("this motion")}
    draw_orbits(axes, pendulum, t, others=True, say=say, style=style)
    say.ticks(axes)
    named(axes, new=True)


def draw_orbits(axes: Any, pendulum: Any, t: np.ndarray, *, others: bool, say: Language, style: dict[str, Any]) -> None:
    """The orbit, its start, the separatrix and orbits of other energies, and the axes."""
    free = pendulum.omega0 == 0
    omega0 = 1.0 if free else pendulum.omega0
    bottom = np.pi if pendulum.omega2 < 0 else 0.0
    velocity0 = pendulum.velocity0 / omega0
    ratio = pendulum.energy_ratio
    height = axes.get_ylim()[1] if axes.lines else 0.0
    # A second motion in the same axes needs no second background.
    if others and not free and say.word("separatrix") not in axes.get_legend_handles_labels()[1]:
        draw_others(axes, ratio, bottom, say)
    where, velocity = covered(pendulum, t, omega0, bottom)
    color = axes.plot(where, velocity, **style)[0].get_color()
    if ratio > 0 and np.isfinite(ratio) and np.isfinite(pendulum.period):
        draw_level(axes, ratio, bottom, sign=np.sign(velocity0) if ratio > 1 else 0, color=color, lw=0.9)
    label = once(axes, f"t = {say.number(t.min(), 7)} s")
    axes.plot(where[:1], velocity[:1], "o", ms=6, color=color, label=label, clip_on=False)
    fastest = np.nanmax(np.abs(velocity), initial=abs(velocity0) if free else 2 * np.sqrt(ratio))
    height = max(height, 1.12 * max(0.1 if free else 2.2, fastest))
    axes.set(xlim=(bottom - np.pi, bottom + np.pi), ylim=(-height, height))
    axes.set_xlabel(say.word("θ wrapped to one turn [rad]"))
    axes.set_ylabel(r"$\dot\theta$ [rad/s]" if free else r"$\dot\theta\,/\,\omega_0$ [rad]")
    angle_ticks(axes.xaxis, *axes.get_xlim())
    if 0 < ratio < SMALL:
        draw_enlarged(axes, np.sqrt(ratio), where - bottom, velocity, color, say)


def draw_others(axes: Any, ratio: float, bottom: float, say: Language) -> None:
    """The background: orbits of other energies, and the separatrix between swings and turns."""
    others = [level for level in LEVELS if abs(level - ratio) > 0.1]
    for level in others:
        label = say.word("other energies") if level == others[0] else None
        draw_level(axes, level, bottom, color=FAINT, lw=0.9, label=label, zorder=1.5)
    draw_level(axes, 1.0, bottom, color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label=say.word("separatrix"), zorder=3)


def draw_level(axes: Any, ratio: float, bottom: float, sign: float = 0, **style: Any) -> None:
    """The orbit of an energy ratio k^2: a closed curve below 1, one or two branches from there on."""
    if ratio < 1:
        turn = np.linspace(0, 2 * np.pi, 400)
        k = np.sqrt(ratio)
        axes.plot(bottom + 2 * np.arcsin(k * np.sin(turn)), 2 * k * np.cos(turn), **style)
        return
    angle = np.linspace(-np.pi, np.pi, 400)
    velocity = 2 * np.sqrt(ratio - np.sin(angle / 2) ** 2)
    for branch in (1, -1):
        if sign in (0, branch):
            axes.plot(bottom + angle, branch * velocity, **style)
            style.pop("label", None)


def covered(pendulum: Any, t: np.ndarray, omega0: float, bottom: float) -> tuple[np.ndarray, np.ndarray]:
    """The part of the orbit that the range of t covers, on one turn around the bottom, with a gap at each jump."""
    first = t.min()
    span = min(t.max() - first, pendulum.period)
    count = int(np.clip(200 * span / time_scale(pendulum), 6000, 100_000)) if span > 0 else 1
    theta, velocity = pendulum.motion(first + span * np.linspace(0, 1, count))
    wrapped = theta
    if np.nanmax(np.abs(theta - bottom), initial=0) > np.pi:
        wrapped = np.mod(theta - bottom + np.pi, 2 * np.pi) - np.pi + bottom
    velocity = velocity / omega0
    jumps = np.flatnonzero(np.abs(np.diff(wrapped)) > np.pi) + 1
    return np.insert(wrapped, jumps, np.nan), np.insert(velocity, jumps, np.nan)


def draw_enlarged(axes: Any, k: float, where: np.ndarray, velocity: np.ndarray, color: Any, say: Language) -> None:
    """An orbit too small to see, enlarged in a corner."""
    inset = axes.inset_axes((0.8, 0.75, 0.2, 0.25))
    draw_level(inset, k * k, 0.0, color=color, lw=0.9)
    inset.plot(where, velocity, color=color, lw=2)
    inset.plot(where[:1], velocity[:1], "o", ms=5, color=color)
    inset.set(xlim=(-2.8 * k, 2.8 * k), ylim=(-2.8 * k, 2.8 * k), xticks=[], yticks=[])
    text = f"{say.word('enlarged')}\n±{say.number(2 * k, 3)}"
    inset.text(0, 0, text, fontsize=7, color="#555555", ha="center", va="center")
    for side in inset.spines.values():
        side.set_color("#cccccc")
