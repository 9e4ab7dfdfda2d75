"""The picture of a pendulum's motion: theta(t) with the linear solution, and the phase portrait with the separatrix."""

from typing import Any, overload

import numpy as np

from .._arrays import Array, Floats, Labelled, Scalar
from ..approx import angle
from ..pendulum import Pendulum
from ._style import (
    EXACT,
    FAINT,
    FEW,
    LINEAR,
    SEPARATRIX,
    angle_ticks,
    finite,
    first_swings,
    legend,
    number,
    part_of,
    quiet,
    save,
)

# Orbits of other energies: their energy ratios.
LEVELS = (0.05, 0.2, 0.45, 0.75, 1.4, 2.0)
# Below this energy ratio an orbit is too small to see and is enlarged in a corner.
SMALL = 0.01


@overload
def linear_theta(pendulum: Pendulum, t: Scalar) -> np.float64: ...
@overload
def linear_theta(pendulum: Pendulum, t: Array) -> Floats: ...
@overload
def linear_theta(pendulum: Pendulum, t: Labelled) -> Labelled: ...
def linear_theta(pendulum: Pendulum, t: Any) -> Any:
    """The linear solution theta0 cos(omega0 t) + velocity0 / omega0 sin(omega0 t).

    With the exact frequency: the phase has all its digits after any number of swings.

    Parameters
    ----------
    pendulum : Pendulum
        Initial state and frequency; without a force the solution is theta0 + velocity0 t.
    t : array_like
        Instants, s. More than 2**53 half swings give NaN, as in `Pendulum.theta`.

    Returns
    -------
    ndarray
        Angle, rad.

    Raises
    ------
    ValueError
        If omega2 < 0: there the linear solution about theta = 0 grows and is no swing.

    Examples
    --------
    >>> from libration import Pendulum
    >>> from libration.plot import linear_theta
    >>> f"{linear_theta(Pendulum(3.0, omega0=2.0), 1e6):.6f}"
    '2.265027'
    """
    if pendulum.omega2 < 0:
        raise ValueError(f"omega2 = {pendulum.omega2!r}: must not be negative for a linear solution that swings")
    return angle("linear").of(pendulum).theta(t)


def plot_motion(pendulum: Pendulum, t: Any, path: Any, *, form: str | None = None) -> None:
    """Draw theta(t) beside the phase portrait and save the picture.

    Left: the exact angle over the range of `t` with the linear solution, and a dot at each instant if they are few.
    Right: velocity over omega0 against the angle, wrapped to one turn, with the separatrix, the whole orbit (thin),
    the part of it that the range of `t` covers (strong), and orbits of other energies (faint).

    Parameters
    ----------
    pendulum : Pendulum
        The motion.
    t : array_like
        Instants, s, in any order; at least one.
    path : str, path or binary file
        Where to save.
    form : str, optional
        `png` or `svg`; by default the ending of `path`.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If there is no finite instant; it or an OverflowError if the motion is too large for an axis (about 1e150).

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration import Pendulum
    >>> from libration.plot import plot_motion
    >>> picture = BytesIO()
    >>> plot_motion(Pendulum(3.0, length=1.0), [0.0, 10.0], picture, form="png")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    t = finite(t)
    panels = (lambda axes: draw_angle(axes, pendulum, t)), (lambda axes: draw_portrait(axes, pendulum, t))
    save(path, form, lambda: headline(pendulum), *panels)


def headline(pendulum: Pendulum) -> str:
    """Initial state, regime and period in one line."""
    speed = f"{number(pendulum.velocity0)} rad/s" if pendulum.velocity0 else "0"
    start = rf"$\theta_0$ = {number(pendulum.theta0)} rad, $\dot\theta_0$ = {speed}: "
    period = f"{number(pendulum.period)} s"
    regime = str(pendulum.regime)
    if regime == "separatrix":
        return start + "separatrix, the top is approached and never reached"
    if regime == "rotation":
        return start + f"rotation, one turn in {period}"
    if regime == "rest":
        return start + ("rest, without a force" if pendulum.omega0 == 0 else f"rest, small swings would take {period}")
    degrees = f"{number(np.degrees(pendulum.theta_max), 4)}°" + (" from π" if pendulum.omega2 < 0 else "")
    return start + f"libration, period {period}, turning angle {degrees}"


def draw_angle(axes: Any, pendulum: Pendulum, t: np.ndarray) -> None:
    """The left panel: theta over t."""
    first, last = t.min(), t.max()
    if first == last:
        first, last = sorted((0.0, first))
    scale = time_scale(pendulum)
    end = last
    last = first_swings(first, end, scale)
    t = t[t <= last]
    unit = part_of("t [s]", first, last, first, end)
    fine = np.linspace(first, last, int(np.clip(200 * (last - first) / scale, 600, 20_000)))
    theta = pendulum.theta(fine)
    if last > first:
        axes.plot(fine, theta, color=EXACT, lw=2, label="exact")
        if pendulum.omega2 > 0:
            linear = linear_theta(pendulum, fine)
            axes.plot(fine, linear, color=LINEAR, lw=1.3, ls=(0, (5, 3)), label="linear")
        axes.set_xlim(first, last)
    if t.size <= FEW:
        axes.plot(t, pendulum.theta(t), "o", ms=4, color=EXACT, label="instants", clip_on=False)
    axes.set_xlabel(unit)
    axes.set_ylabel(r"$\theta$ [rad]")
    quiet(axes)
    angle_ticks(axes.yaxis, *axes.get_ylim())
    legend(axes)


def time_scale(pendulum: Pendulum) -> float:
    """The time in which the angle changes: the small-swing period, or one turn if that is shorter."""
    times = [pendulum.period]
    if pendulum.omega0 > 0:
        times.append(2 * np.pi / pendulum.omega0)
    return min(times)


def draw_portrait(axes: Any, pendulum: Pendulum, t: np.ndarray) -> None:
    """The right panel: velocity / omega0 over theta, on one turn around the stable equilibrium."""
    free = pendulum.omega0 == 0
    omega0 = 1.0 if free else pendulum.omega0
    bottom = np.pi if pendulum.omega2 < 0 else 0.0
    velocity0 = pendulum.velocity0 / omega0
    ratio = pendulum.energy_ratio
    if not free:
        others = [level for level in LEVELS if abs(level - ratio) > 0.1]
        for level in others:
            label = "other energies" if level == others[0] else None
            draw_level(axes, level, bottom, color=FAINT, lw=0.9, label=label)
        draw_level(axes, 1.0, bottom, color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label="separatrix", zorder=3)
    if ratio > 0 and np.isfinite(ratio) and np.isfinite(pendulum.period):
        draw_level(axes, ratio, bottom, sign=np.sign(velocity0) if ratio > 1 else 0, color=EXACT, lw=0.9)
    where, velocity = covered(pendulum, t, omega0, bottom)
    axes.plot(where, velocity, color=EXACT, lw=1.6, label="this motion")
    axes.plot(where[:1], velocity[:1], "o", ms=6, color=EXACT, label=f"t = {number(t.min(), 7)} s", clip_on=False)
    fastest = np.nanmax(np.abs(velocity), initial=abs(velocity0) if free else 2 * np.sqrt(ratio))
    height = 1.12 * max(0.1 if free else 2.2, fastest)
    axes.set(xlim=(bottom - np.pi, bottom + np.pi), ylim=(-height, height))
    axes.set_xlabel(r"$\theta$ wrapped to one turn [rad]")
    axes.set_ylabel(r"$\dot\theta$ [rad/s]" if free else r"$\dot\theta\,/\,\omega_0$ [rad]")
    quiet(axes)
    angle_ticks(axes.xaxis, *axes.get_xlim())
    legend(axes)
    if 0 < ratio < SMALL:
        draw_enlarged(axes, np.sqrt(ratio), where - bottom, velocity)


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


def covered(pendulum: Pendulum, t: np.ndarray, omega0: float, bottom: float) -> tuple[np.ndarray, np.ndarray]:
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


def draw_enlarged(axes: Any, k: float, where: np.ndarray, velocity: np.ndarray) -> None:
    """An orbit too small to see, enlarged in a corner."""
    inset = axes.inset_axes((0.8, 0.75, 0.2, 0.25))
    draw_level(inset, k * k, 0.0, color=EXACT, lw=0.9)
    inset.plot(where, velocity, color=EXACT, lw=2)
    inset.plot(where[:1], velocity[:1], "o", ms=5, color=EXACT)
    inset.set(xlim=(-2.8 * k, 2.8 * k), ylim=(-2.8 * k, 2.8 * k), xticks=[], yticks=[])
    inset.text(0, 0, f"enlarged\n±{number(2 * k, 3)}", fontsize=7, color="#555555", ha="center", va="center")
    for side in inset.spines.values():
        side.set_color("#cccccc")
