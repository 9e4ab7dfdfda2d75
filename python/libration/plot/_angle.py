"""The angle of a pendulum over time: exact, with the linear solution and the turning angle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from ._axes import given_or_new, named, once
from ._language import ENGLISH, Language
from ._style import EXACT, FEW, LINEAR, angle_ticks, finite, first_swings, part_of, quiet

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Without instants: this many periods.
PERIODS = 2.0
# Of a motion without a period, this many radians of omega0 t; without a force, this many seconds.
PHASE, SECONDS = 12.0, 10.0


def angle_axes(
    pendulum: Any, t: Any, ax: Any, *, linear: bool, turning: bool, lang: str, style: dict[str, Any]
) -> Axes:
    """Draw theta(t) into axes of the user or new ones, and return them."""
    say = Language(lang)
    t = np.array([0.0, span(pendulum)]) if t is None else finite(t)
    axes, new = given_or_new(ax)
    style = {"label": state_text(pendulum, say)} | style
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        draw_curves(axes, pendulum, t, linear=linear, turning=turning, say=say, style=style)
    say.ticks(axes)
    named(axes, new)
    return axes


def span(pendulum: Any) -> float:
    """How long a motion is drawn if nobody says."""
    if math.isfinite(pendulum.period):
        return float(PERIODS * pendulum.period)
    return float(PHASE / pendulum.omega0) if pendulum.omega0 else SECONDS


def state_text(pendulum: Any, say: Language) -> str:
    """The initial state in rad, as the label of a curve."""
    text = rf"$\theta_0$ = {say.number(pendulum.theta0)} rad"
    if pendulum.velocity0:
        text += rf", $\dot\theta_0$ = {say.number(pendulum.velocity0)} rad/s"
    return text


def headline(pendulum: Any, say: Language = ENGLISH) -> str:
    """Initial state, regime and period in one line."""
    start = state_text(pendulum, say)
    if not pendulum.velocity0:
        start += r", $\dot\theta_0$ = 0"
    period = say.number(pendulum.period)
    regime = str(pendulum.regime)
    if regime == "separatrix":
        return say.word("{start}: separatrix, the top is approached and never reached", start=start)
    if regime == "rotation":
        return say.word("{start}: rotation, one turn in {period} s", start=start, period=period)
    if regime == "rest":
        if pendulum.omega0 == 0:
            return say.word("{start}: rest, without a force", start=start)
        return say.word("{start}: rest, small swings would take {period} s", start=start, period=period)
    angle = degrees_text(pendulum.theta_max, pendulum, say)
    if pendulum.omega2 < 0:
        angle = say.word("{angle} from π", angle=angle)
    words = "{start}: libration, period {period} s, turning angle {angle}"
    return say.word(words, start=start, period=period, angle=angle)


def draw_angle(axes: Any, pendulum: Any, t: np.ndarray, say: Language = ENGLISH) -> None:
    """The left panel of a saved picture: theta over t."""
    style = {"color": EXACT, "lw": 2, "label": say.word("exact")}
    quiet(axes)
    draw_curves(axes, pendulum, t, linear=True, turning=True, say=say, style=style)
    say.ticks(axes)
    named(axes, new=True)


def draw_curves(
    axes: Any, pendulum: Any, t: np.ndarray, *, linear: bool, turning: bool, say: Language, style: dict[str, Any]
) -> None:
    """The curves, the instants if they are few, and the axes."""
    first, last = t.min(), t.max()
    if first == last:
        first, last = sorted((0.0, first))
    scale = time_scale(pendulum)
    end = last
    last = first_swings(first, end, scale)
    # Two instants are the ends of a range.
    t = t[(t <= last) & (len(t) != 2)]
    fine = np.linspace(first, last, int(np.clip(200 * (last - first) / scale, 600, 20_000)))
    color = style.get("color", style.get("c"))
    if last > first:
        color = axes.plot(fine, pendulum.theta(fine), **style)[0].get_color()
        if linear and pendulum.omega2 > 0:
            theta = _core.AngleFormula("linear").of(pendulum._orbit).theta(fine)
            label = once(axes, say.word("linear"))
            axes.plot(fine, theta, color=LINEAR, lw=1.3, ls=(0, (5, 3)), label=label, zorder=2.1)
        axes.margins(x=0)
    if 0 < t.size <= FEW:
        label = once(axes, say.word("instants"))
        axes.plot(t, pendulum.theta(t), "o", ms=4, color=color, label=label, clip_on=False)
    axes.set_xlabel(part_of("t [s]", first, last, first, end, say))
    axes.set_ylabel(r"$\theta$ [rad]")
    angle_ticks(axes.yaxis, *axes.get_ylim())
    if turning and pendulum.regime == "libration" and last > first:
        draw_turning_angles(axes, pendulum, say)


def draw_turning_angles(axes: Any, pendulum: Any, say: Language) -> None:
    """Thin lines at both turning angles, with the degrees at the right end of the upper one."""
    for theta in pendulum.extremes:
        axes.axhline(theta, color=LINEAR, lw=0.8, ls=(0, (1, 2)), zorder=1.5)
    text = degrees_text(pendulum.extremes[1], pendulum, say)
    place = {"xytext": (4, 0), "textcoords": "offset points", "va": "center", "fontsize": "small", "color": "#555555"}
    at = (1.0, pendulum.extremes[1])
    axes.annotate(text, at, xycoords=axes.get_yaxis_transform(), annotation_clip=False, **place)


def degrees_text(theta: float, pendulum: Any, say: Language) -> str:
    """An angle in degrees, with the digits that tell a turning angle from the top."""
    degrees = math.degrees(theta)
    if pendulum.omega2 >= 0 and pendulum.regime == "libration" and abs(abs(degrees) - 180) < 0.1:
        return top_text(pendulum, say)
    return f"{say.number(degrees, 4)}°"


def top_text(pendulum: Any, say: Language) -> str:
    """A turning angle next to the top: 179.999°, or its distance from 180° where a double has no more digits."""
    # The complement has the digits that 180 - theta_max has not.
    below = 2 * math.degrees(math.asin(math.sqrt(pendulum.energy_ratio_c)))
    if below < 1e-7:
        return f"180° − {say.number(below, 2)}°"
    digits = 1 - math.floor(math.log10(below))
    return f"{say.decimal(f'{180 - below:.{digits}f}'.rstrip('0'))}°"


def time_scale(pendulum: Any) -> float:
    """The time in which the angle changes: the small-swing period, or one turn if that is shorter."""
    times = [pendulum.period]
    if pendulum.omega0 > 0:
        times.append(2 * np.pi / pendulum.omega0)
    return float(min(times))
