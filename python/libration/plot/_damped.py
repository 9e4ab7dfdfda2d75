"""The pictures of a pendulum with friction and torque: the angle, the phase portrait, which spirals, and the energy."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ..damped._laws import averaged_turning_angle
from ..damped._torque import Torque
from ..pendulum import Pendulum
from ._angle import state_text
from ._axes import given_or_new, named, once
from ._language import ENGLISH, Language
from ._portrait import SMALL, draw_enlarged, draw_others
from ._style import DOTTED, EXACT, FAINT, FEW, LINEAR, SEPARATRIX, angle_ticks, finite, quiet

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Without instants: this many periods of small swings; without a force, this many seconds.
SWINGS, SECONDS = 10, 10.0
# The motion without friction is drawn up to this number of swings: beyond, it would hide the other.
BESIDE = 12
# Points of a curve for each turn, swing or period of the torque, and the least and the largest number of them.
FINE, LEAST, MOST = 150, 600, 60_000
# Points of an envelope, and rests that are marked.
POINTS, RESTS = 100, 50


def damped_angle_axes(
    pendulum: Any, t: Any, ax: Any, *, undamped: bool, envelope: bool, lang: str, style: dict[str, Any]
) -> Axes:
    """Draw theta(t) into axes of the user or new ones, and return them."""
    say = Language(lang)
    t = span(pendulum) if t is None else finite(t)
    axes, new = given_or_new(ax)
    style = {"label": state_text(pendulum, say)} | style
    draw_curves(axes, pendulum, t, undamped=undamped, envelope=envelope, say=say, style=style)
    say.ticks(axes)
    named(axes, new)
    return axes


def damped_phase_axes(pendulum: Any, t: Any, ax: Any, *, others: bool, lang: str, style: dict[str, Any]) -> Axes:
    """Draw the phase portrait into axes of the user or new ones, and return them."""
    say = Language(lang)
    t = span(pendulum) if t is None else finite(t)
    axes, new = given_or_new(ax, (6.4, 4.8))
    style = {"label": state_text(pendulum, say)} | style
    draw_spiral(axes, pendulum, t, others=others, say=say, style=style)
    say.ticks(axes)
    named(axes, new)
    return axes


def damped_energy_axes(pendulum: Any, t: Any, ax: Any, *, lang: str, style: dict[str, Any]) -> Axes:
    """Draw the energy into axes of the user or new ones, and return them."""
    say = Language(lang)
    t = span(pendulum) if t is None else finite(t)
    axes, new = given_or_new(ax)
    style = {"label": state_text(pendulum, say)} | style
    fine = curve(pendulum, t)
    axes.plot(fine, pendulum.energy(fine), **style)
    top = 2 * abs(pendulum.omega2)
    if axes.get_ylim()[1] > top > 0:
        label = once(axes, say.word("separatrix"))
        axes.axhline(top, color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label=label, zorder=1.5)
    axes.margins(x=0)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("t [s]")
    axes.set_ylabel(say.word("energy per unit inertia [rad²/s²]"))
    say.ticks(axes)
    named(axes, new)
    return axes


def draw_damped_angle(axes: Any, pendulum: Any, t: np.ndarray, say: Language = ENGLISH) -> None:
    """The left panel of a saved picture."""
    quiet(axes)
    style = {"color": EXACT, "lw": 1.8, "label": say.word("this motion")}
    draw_curves(axes, pendulum, t, undamped=True, envelope=True, say=say, style=style)
    say.ticks(axes)
    named(axes, new=True)


def draw_damped_portrait(axes: Any, pendulum: Any, t: np.ndarray, say: Language = ENGLISH) -> None:
    """The right panel of a saved picture."""
    quiet(axes)
    style = {"color": EXACT, "lw": 1.4, "label": say.word("this motion")}
    draw_spiral(axes, pendulum, t, others=True, say=say, style=style)
    say.ticks(axes)
    named(axes, new=True)


def damped_headline(pendulum: Any, say: Language = ENGLISH) -> str:
    """Initial state, friction and torque in one line, by their symbols."""
    start = state_text(pendulum, say)
    if not pendulum.velocity0:
        start += r", $\dot\theta_0$ = 0"
    friction, terms = pendulum.friction, []
    for symbol, value, unit in (
        ("γ", friction.linear, " s⁻¹"),
        ("β", friction.quadratic, ""),
        ("μ", friction.dry, " s⁻²"),
        ("δ", friction.presliding, " rad"),
    ):
        if value:
            terms.append(f"{symbol} = {say.number(value)}{unit}")
    if torque := torque_text(pendulum.torque, say):
        terms.append(f"τ = {torque} s⁻²")
    return f"{start}: {', '.join(terms)}" if terms else start


def torque_text(torque: Torque, say: Language) -> str:
    """The torque as a formula; empty without one."""
    given = torque._arguments()[1]
    parts = [say.number(given["constant"])] if given["constant"] else []
    if given["amplitude"]:
        phase = f" + {say.number(given['phase'])}" if given["phase"] else ""
        parts.append(f"{say.number(given['amplitude'])} cos({say.number(given['frequency'])} t{phase})")
    if "samples" in given:
        parts.append("τ(t)")
    return " + ".join(parts).replace("+ −", "− ")


def span(pendulum: Any) -> np.ndarray:
    """The instants that are drawn if nobody says."""
    return np.array([0.0, SWINGS * math.tau / pendulum.omega0 if pendulum.omega0 else SECONDS])


def curve(pendulum: Any, t: np.ndarray) -> np.ndarray:
    """Instants of a smooth curve over the range of t, as far as the motion gets."""
    first, last = t.min(), t.max()
    if first == last:
        first, last = sorted((0.0, first))
    rough = np.linspace(first, last, LEAST)
    velocity = pendulum.velocity(rough)
    rates = [pendulum.omega0, float(np.nanmax(np.abs(velocity), initial=0.0))]
    rates.append(abs(pendulum.torque._arguments()[1]["frequency"]))
    count = min(max(FINE * (last - first) * max(rates) / math.tau, LEAST), MOST)
    fine = np.linspace(first, last, int(count))
    reached: np.ndarray = fine[np.isfinite(pendulum.theta(fine))]
    return reached if reached.size else fine[:1]


def draw_curves(
    axes: Any,
    pendulum: Any,
    t: np.ndarray,
    *,
    undamped: bool,
    envelope: bool,
    say: Language,
    style: dict[str, Any],
) -> None:
    """The angle, what it would be without friction, the envelope in the mean, the rests and the axes."""
    fine = curve(pendulum, t)
    color = axes.plot(fine, pendulum.theta(fine), **style)[0].get_color()
    if 0 < t.size <= FEW and t.size != 2:
        label = once(axes, say.word("instants"))
        axes.plot(t, pendulum.theta(t), "o", ms=4, color=color, label=label, clip_on=False)
    free = pendulum.torque == Torque()
    swings = np.ptp(fine) * pendulum.omega0 / math.tau
    if undamped and free and 0 < swings <= BESIDE:
        exact = Pendulum(pendulum.theta0, pendulum.velocity0, **pendulum._frequency)
        label = once(axes, say.word("without friction"))
        axes.plot(fine, exact.theta(fine), color=LINEAR, lw=1.0, ls=(0, (5, 3)), label=label, zorder=1.8)
        if str(exact.regime) == "rotation":
            # It turns for ever, and the damped motion would be flat beside it.
            axes.set_ylim(*room(pendulum.theta(fine)))
    if envelope and free:
        draw_envelope(axes, pendulum, fine, say)
    draw_rests(axes, pendulum, fine, say)
    axes.margins(x=0)
    axes.set_xlabel("t [s]")
    axes.set_ylabel(r"$\theta$ [rad]")
    angle_ticks(axes.yaxis, *axes.get_ylim())


def room(values: np.ndarray) -> tuple[float, float]:
    """The range of values with a margin."""
    low, high = float(values.min()), float(values.max())
    margin = 0.06 * (high - low) or 1.0
    return low - margin, high + margin


def draw_envelope(axes: Any, pendulum: Any, fine: np.ndarray, say: Language) -> None:
    """The turning angle in the mean, from the first turn on, on both sides."""
    friction = pendulum.friction
    if pendulum.omega2 <= 0 or min(friction.linear, friction.quadratic) < 0 or fine[0] < 0:
        return
    turning = pendulum.turning_times(float(fine[0]), float(fine[-1]))
    if not turning.size or friction == type(friction)():
        return
    n, angle = pendulum.turns(float(turning[0]))
    times = np.linspace(turning[0], fine[-1], POINTS)
    given: Any = pendulum._frequency
    size = averaged_turning_angle(abs(float(angle)), times - turning[0], friction, **given)
    size = np.where(size > 0, size, np.nan)
    label: str | None = once(axes, say.word("envelope in the mean"))
    for side in (1, -1):
        axes.plot(times, math.tau * n + side * size, color=SEPARATRIX, lw=1.1, ls=DOTTED, label=label, zorder=2.2)
        label = None


def draw_rests(axes: Any, pendulum: Any, fine: np.ndarray, say: Language) -> None:
    """A grey band where dry friction holds the pendulum."""
    label: str | None = once(axes, say.word("held by dry friction"))
    for begin, end in pendulum.rests(float(fine[0]), float(fine[-1]))[:RESTS]:
        axes.axvspan(begin, end, color=FAINT, alpha=0.6, lw=0, label=label, zorder=0.5)
        label = None


def draw_spiral(axes: Any, pendulum: Any, t: np.ndarray, *, others: bool, say: Language, style: dict[str, Any]) -> None:
    """The path in the phase plane, its start, the separatrix and orbits of other energies, and the axes."""
    free = pendulum.omega0 == 0
    omega0 = 1.0 if free else pendulum.omega0
    bottom = math.pi if pendulum.omega2 < 0 else 0.0
    fine = curve(pendulum, t)
    theta, velocity = pendulum.motion(fine)
    velocity = velocity / omega0
    ratios = np.sin((theta - bottom) / 2) ** 2 + (velocity / 2) ** 2
    height = axes.get_ylim()[1] if axes.lines else 0.0
    # A second motion in the same axes needs no second background.
    if others and not free and say.word("separatrix") not in axes.get_legend_handles_labels()[1]:
        draw_others(axes, float(ratios[0]), bottom, say)
    where, velocity = gaps(theta, velocity, bottom)
    color = axes.plot(where, velocity, **style)[0].get_color()
    label = once(axes, f"t = {say.number(fine[0], 7)} s")
    axes.plot(where[:1], velocity[:1], "o", ms=6, color=color, label=label, clip_on=False)
    height = max(height, 1.12 * max(0.1 if free else 2.2, float(np.nanmax(np.abs(velocity)))))
    axes.set(xlim=(bottom - math.pi, bottom + math.pi), ylim=(-height, height))
    axes.set_xlabel(say.word("θ wrapped to one turn [rad]"))
    axes.set_ylabel(r"$\dot\theta$ [rad/s]" if free else r"$\dot\theta\,/\,\omega_0$ [rad]")
    angle_ticks(axes.xaxis, *axes.get_xlim())
    largest = float(ratios.max())
    if not free and 0 < largest < SMALL:
        draw_enlarged(axes, math.sqrt(largest), where - bottom, velocity, color, say)


def gaps(theta: np.ndarray, velocity: np.ndarray, bottom: float) -> tuple[np.ndarray, np.ndarray]:
    """Angles wrapped to one turn around the bottom, with a gap at each jump, and the velocities beside them."""
    wrapped = theta
    if np.abs(theta - bottom).max(initial=0) > math.pi:
        wrapped = np.mod(theta - bottom + math.pi, math.tau) - math.pi + bottom
    jumps = np.flatnonzero(np.abs(np.diff(wrapped)) > math.pi) + 1
    return np.insert(wrapped, jumps, np.nan), np.insert(velocity, jumps, np.nan)
