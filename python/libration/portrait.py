"""Pictures of the nonlinear springs: u(t), and the phase portrait with its separatrices.

matplotlib is needed only here (`pip install 'libration[plot]'`), as in plot.py, whose quiet style is kept.
"""

import math
from typing import Any

import numpy as np

from .oscillator import Oscillator
from .plot import EXACT, FAINT, FEW, SEPARATRIX, finite, legend, number, quiet, save

# Displacements of an escape are drawn up to this multiple of where it starts or turns.
FAR = 4.0


def plot_oscillator(oscillator: Oscillator, t: Any, path: Any, *, form: str | None = None) -> None:
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
    >>> from libration import Duffing
    >>> from libration.portrait import plot_oscillator
    >>> picture = BytesIO()
    >>> plot_oscillator(Duffing(1.0, p=-1.0, q=1.0), [0.0, 10.0], picture, form="png")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    t = finite(t)
    panels = (lambda axes: draw_displacement(axes, oscillator, t)), (lambda axes: draw_portrait(axes, oscillator))
    save(path, form, lambda: headline(oscillator), *panels)


def headline(oscillator):
    """Equation, regime and what goes with it in one line."""
    coefficients = ", ".join(f"{name} = {number(getattr(oscillator, name))}" for name in oscillator._names)
    start = f"{coefficients}, u(0) = {number(oscillator.u0)}, u'(0) = {number(oscillator.velocity0)}: "
    regime = str(oscillator.regime)
    if math.isfinite(oscillator.period):
        return f"{start}{regime}, period {number(oscillator.period)} s"
    ends = [end for end in (oscillator.escape_time_backward, oscillator.escape_time) if math.isfinite(end)]
    if ends:
        return f"{start}{regime} at t = {' and '.join(f'{number(end)} s' for end in ends)}"
    return start + regime


def reach(oscillator):
    """Half the width of the picture: the orbit if it is bounded, else some way on its way out."""
    marks = [abs(oscillator.u0), *(abs(end) for end in oscillator.range if math.isfinite(end))]
    marks += [abs(each) for each in equilibria(oscillator)]
    widest = max(marks, default=0.0) or 1.0
    bounded = all(math.isfinite(end) for end in oscillator.range)
    return (1.25 if bounded else FAR / 2) * widest


def polynomial(oscillator):
    """Coefficients of the force over u, rising powers of u**2."""
    return [getattr(oscillator, name) for name in oscillator._names]


def equilibria(oscillator):
    """Displacements other than 0 at which the force is 0."""
    squares = np.roots(polynomial(oscillator)[::-1]) if any(polynomial(oscillator)[1:]) else np.empty(0)
    return [sign * math.sqrt(s.real) for s in squares if abs(s.imag) < 1e-9 * abs(s) and s.real > 0 for sign in (-1, 1)]


def barriers(oscillator):
    """Energies at rest on the unstable equilibria, rising: those of the separatrices."""
    stiffness = polynomial(oscillator)
    tops = [
        u
        for u in [0.0, *equilibria(oscillator)]
        if sum((2 * k + 1) * c * u ** (2 * k) for k, c in enumerate(stiffness)) < 0
    ]
    return sorted({float(potential(oscillator, u)) for u in tops})


def potential(oscillator, u):
    """Energy at rest at u."""
    return sum(c * u ** (2 * k + 2) / (2 * k + 2) for k, c in enumerate(polynomial(oscillator)))


def draw_displacement(axes, oscillator, t):
    """The left panel: u over t."""
    first, last = t.min(), t.max()
    if first == last:
        first, last = sorted((0.0, first))
    fine = np.linspace(first, last, 4000)
    u = oscillator.u(fine)
    far = FAR * reach(oscillator) / 2
    if last > first:
        axes.plot(fine, np.where(np.abs(u) < far, u, np.nan), color=EXACT, lw=2, label="exact")
        axes.set_xlim(first, last)
    if t.size <= FEW:
        axes.plot(t, oscillator.u(t), "o", ms=4, color=EXACT, label="instants")
    label = "escape"
    for end in (oscillator.escape_time_backward, oscillator.escape_time):
        if first <= end <= last:
            axes.axvline(end, color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label=label)
            label = None
    axes.set_xlabel("t [s]")
    axes.set_ylabel("u")
    quiet(axes)
    legend(axes)


def draw_portrait(axes, oscillator):
    """The right panel: velocity over displacement, by the levels of the energy."""
    width = reach(oscillator)
    grid = np.linspace(-width, width, 801)
    depth = potential(oscillator, grid)
    own = oscillator.energy
    tops = barriers(oscillator)
    rest = [float(potential(oscillator, each)) for each in [0.0, *equilibria(oscillator)]]
    lowest = depth.min()
    if not all(math.isfinite(end) for end in oscillator.range):
        lowest = min(depth[np.abs(grid) < width / 2].min(), *rest)
    kinetic = max(own - lowest, max(rest) - lowest, 1e-300)
    height = 1.35 * math.sqrt(2 * kinetic)
    speed = np.linspace(-height, height, 601)
    energy = depth[None, :] + speed[:, None] ** 2 / 2
    low, high = energy.min(), energy.max()
    faint = [low + (high - low) * part for part in (0.02, 0.06, 0.12, 0.22, 0.35, 0.5, 0.7)]
    axes.contour(grid, speed, energy, levels=faint, colors=FAINT, linewidths=0.9, linestyles="solid")
    saddles = [level for level in tops if low < level < high]
    if saddles:
        axes.contour(grid, speed, energy, levels=saddles, colors=SEPARATRIX, linewidths=1.1, linestyles="dashed")
    fine = along(oscillator, width)
    axes.plot(*fine, color=EXACT, lw=2, label="this motion")
    axes.plot([oscillator.u0], [oscillator.velocity0], "o", ms=6, color=EXACT, label="t = 0 s")
    if saddles:
        axes.plot([], [], color=SEPARATRIX, lw=1.1, ls=(0, (5, 3)), label="separatrix")
    axes.set(xlim=(-width, width), ylim=(-height, height))
    axes.set_xlabel("u")
    axes.set_ylabel(r"$\dot u$")
    quiet(axes)
    legend(axes)


def along(oscillator, width):
    """The whole orbit, as far as the picture shows it."""
    back, ahead = oscillator.escape_time_backward, oscillator.escape_time
    scale = oscillator.period
    if not math.isfinite(scale):
        pull = max(abs(c) * width ** (2 * k) for k, c in enumerate(polynomial(oscillator)))
        scale = 40 / math.sqrt(pull) if pull else 10 * width / (abs(oscillator.velocity0) or 1.0)
    start = max(back, -scale)
    stop = min(ahead, scale)
    # Denser towards the ends, where an escape runs away.
    part = 0.5 - 0.5 * np.cos(np.linspace(0, np.pi, 6000))
    u, velocity = oscillator.motion(start + (stop - start) * part)
    inside = np.abs(u) <= 1.05 * width
    return np.where(inside, u, np.nan), np.where(inside, velocity, np.nan)
