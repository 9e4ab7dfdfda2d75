"""Ensembles step by step: the exact pendulum between kicks, or kicks and drifts of order 8, with whole turns counted.

Without a kick of the user's, blocks of particles stay in the cache from one state that is given to the next: the core takes the steps
of the exact scheme, on all threads. A step of that scheme is half a kick, the flow, half a kick: of second order in the kick, and exact
without one. Source: Wisdom & Holman, Astron. J. 102 (1991), 1528; Hairer,
Lubich & Wanner, Geometric Numerical Integration (2006), II.5.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from .. import _core
from .._arrays import Floats, NDArray
from .._dispatch import numbers
from .._messages import explained
from .._scalars import count, shown
from ._schemes import Kick, exact, order8, wrap

# Particles at a time by kicks and drifts: their columns stay in the second cache.
BLOCK = 2**14


@explained
def track(
    theta: Any,
    velocity: Any,
    dt: Any,
    omega0: Any = 1.0,
    *,
    steps: int,
    phase: Any = 0.0,
    kick: Kick | None = None,
    record: int | Sequence[int] | None = None,
    scheme: str = "exact",
    out: tuple[Floats, Floats, NDArray[np.int64]] | None = None,
) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """States after steps of pendulums that are kicked: ``(theta, velocity, turns)``.

    Each step is theta'' + omega0**2 sin(theta - phase) = 0 over a time `dt`, with the numbers of that step. A kick changes the
    velocities at the ends of the steps: half before a step, half after it.

    Parameters
    ----------
    theta : scalar or array
        Angles in rad; of `velocity`'s shape, or of one that broadcasts to it.
    velocity : scalar or array
        Angular velocities in rad/s.
    dt : scalar or array of `steps`
        Time of a step in s, the same or one a step, of any sign.
    omega0 : scalar or array of `steps`, default 1.0
        Angular frequency of small swings in rad/s, not negative; the same or one a step.
    steps : int
        How many, not negative.
    phase : scalar or array of `steps`, default 0.0
        Angle of the bottom in rad, the same or one a step.
    kick : function, optional
        ``kick(theta, step)``: the change of velocity by a whole step, in rad/s, for the angles of all particles, in [-pi, pi);
        an array of their shape, or a number. `step` is the time in steps from the start: 0, 1 and so on to `steps` in
        the exact scheme; in ``"order8"`` the time of the stage, a fraction, up to 0.1 steps outside of its step. It must not
        change `theta`.
    record : int or sequence of int, optional
        Which states to give: after every so many steps from the start on, or after these numbers of steps, growing. Only the last
        by default.
    scheme : {"exact", "order8"}, default "exact"
        ``"order8"`` splits into kicks and drifts, composed to order 8, for what has no elliptic solution: where the kick is not small.
    out : tuple of three ndarray, optional
        Where to put the results, float64, float64 and int64; ``(theta, velocity)`` themselves go.

    Returns
    -------
    tuple of three ndarray
        Angles in [-pi, pi), angular velocities, and whole turns, int64: the angle not wrapped is theta + 2 pi turns. Of the shape of
        the state, with a first axis for `record`. A bad element is NaN, with 0 turns, there and nowhere else.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.

    Notes
    -----
    Without a kick each step has the error of `advance`: 8 ulp of the largest angle and velocity. A step of ``"order8"`` has an error of
    order dt**9. Steps in two calls are those in one, bit for bit, if `kick` goes by its angles alone. Memory: the states, the
    records, and a block. Source: Wisdom & Holman, Astron. J. 102 (1991), 1528; Suzuki & Umeno (1993).

    Examples
    --------
    >>> from libration import ensemble
    >>> theta, velocity, turns = ensemble.track([0.0, 0.0], [1.0, 3.0], 0.1, steps=100)
    >>> print(theta.round(6), turns)
    [0.114252 1.025388] [0 4]

    A second harmonic, too large for the exact scheme:

    >>> import numpy as np
    >>> wave = lambda theta, step: -0.1 * 0.25 * np.sin(2 * theta)
    >>> theta, _, _ = ensemble.track([0.5, 1.0], 0.0, 0.1, kick=wave, steps=100, scheme="order8")
    >>> theta.round(6)
    array([ 0.385138, -0.208899])
    """
    total = count("steps", steps)
    if total < 0:
        raise ValueError(f"steps = {total}: must not be negative")
    if scheme not in ("exact", "order8"):
        raise ValueError(f"scheme = {shown(scheme)}: must be exact or order8")
    if kick is not None and not callable(kick):
        raise ValueError(f"kick = {shown(kick)}: must be a function of the angles and the step")
    states = [numbers(each) for each in (theta, velocity)]
    shape = np.broadcast_shapes(*(each.shape for each in states))
    marks = _marks(record, total)
    whole = shape if record is None else (len(marks), *shape)
    results = _results(out, whole)
    numbers_of_steps = [
        _by_step(name, value, total) for name, value in (("dt", dt), ("omega0", omega0), ("phase", phase))
    ]
    angles, velocities = (np.array(np.broadcast_to(_plain(each), shape), dtype=float).reshape(-1) for each in states)
    turns = np.zeros(angles.size, dtype=np.int64)
    rows = [each.reshape(len(marks), -1) if each.flags.c_contiguous else None for each in results]
    held = [
        row if row is not None else np.empty((len(marks), angles.size), each.dtype)
        for row, each in zip(rows, results, strict=True)
    ]
    if kick is None and scheme == "exact":
        _exactly(angles, velocities, turns, numbers_of_steps, marks, held)
    else:
        size = max(1, angles.size if kick else BLOCK)
        for begin in range(0, angles.size, size):
            block = slice(begin, begin + size)
            parts = angles[block], velocities[block], turns[block]
            _steps(*parts, numbers_of_steps, kick, scheme, shape, marks, [each[:, block] for each in held])
    for row, own, each in zip(rows, held, results, strict=True):
        if row is None:
            each[...] = own.reshape(whole)
    return results


def _exactly(
    theta: Floats,
    velocity: Floats,
    turns: NDArray[np.int64],
    numbers_of_steps: list[Floats],
    marks: Sequence[int],
    rows: list[Any],
) -> None:
    """All steps without a kick, from mark to mark."""
    wrap(theta, turns)
    before = 0
    for place, mark in enumerate(marks):
        _core.steps(theta, velocity, turns, *(each[before:mark] for each in numbers_of_steps))
        _put(rows, place, theta, velocity, turns)
        before = mark


def _put(rows: list[Any], place: int, theta: Floats, velocity: Floats, turns: NDArray[np.int64]) -> None:
    """A state of all particles as it is given: what is not finite is NaN, without turns."""
    bad = ~(np.isfinite(theta) & np.isfinite(velocity))
    for row, column, nothing in zip(rows, (theta, velocity, turns), (np.nan, np.nan, 0), strict=True):
        row[place] = column
        row[place][bad] = nothing


def _steps(
    theta: Floats,
    velocity: Floats,
    turns: NDArray[np.int64],
    numbers_of_steps: list[Floats],
    kick: Kick | None,
    scheme: str,
    shape: tuple[int, ...],
    marks: Sequence[int],
    rows: list[Any],
) -> None:
    """All steps of one block, with the marked states put into their rows."""
    wrap(theta, turns)
    place = 0
    half: Any = None
    for step in range(marks[-1] + 1):
        if step:
            dt, omega0, phase = (float(each[step - 1]) for each in numbers_of_steps)
            if scheme == "order8":
                order8(theta, velocity, dt, omega0, phase, _stage(theta, velocity, kick, shape, step - 1))
                wrap(theta, turns)
            else:
                if kick:
                    # The kick at the end of a step is that at the start of the next.
                    velocity += 0.5 * _kick(kick, theta, shape, 0) if half is None else half
                exact(theta, velocity, dt, omega0, phase)
                wrap(theta, turns)
                if kick:
                    half = 0.5 * _kick(kick, theta, shape, step)
                    velocity += half
        if step == marks[place]:
            _put(rows, place, theta, velocity, turns)
            place += 1


def _stage(theta: Floats, velocity: Floats, kick: Kick | None, shape: tuple[int, ...], start: int) -> Any:
    """The user's kick as a stage of the composition asks for it."""
    if kick is None:
        return None

    def stage(weight: float, time: float) -> None:
        # Wrapped for the user, and not for the step.
        angles = theta.copy()
        wrap(angles, np.zeros(angles.size, dtype=np.int64))
        velocity[...] += weight * _kick(kick, angles, shape, start + time)

    return stage


def _kick(kick: Any, theta: Floats, shape: tuple[int, ...], time: float) -> Any:
    """What the user's function answers for all particles, as one column or one number."""
    angles = theta.reshape(shape)
    angles.flags.writeable = False
    given = kick(angles, time)
    change = np.asarray(given)
    if change.dtype.kind not in "biuf":
        raise ValueError(f"kick(theta, {time}) = {shown(given)}: must be real numbers")
    if change.ndim and change.shape != shape:
        raise ValueError(f"kick(theta, {time}) of shape {change.shape}: must have the shape of theta, {shape}")
    return change.reshape(-1) if change.ndim else float(change)


def _plain(values: Any) -> Floats:
    return np.ma.filled(values, np.nan) if isinstance(values, np.ma.MaskedArray) else np.asarray(values)


def _by_step(name: str, value: Any, total: int) -> Floats:
    """A number of every step, as an array of `total`."""
    given = _plain(numbers(value))
    if given.shape not in ((), (total,)):
        raise ValueError(f"{name} of shape {given.shape}: must be one number, or one for each of {total} steps")
    if not np.all(np.isfinite(given)):
        raise ValueError(f"{name} = {shown(value)}: must be finite")
    if name == "omega0" and np.any(given < 0.0):
        raise ValueError(f"omega0 = {shown(value)}: must not be negative")
    return np.ascontiguousarray(np.broadcast_to(given, (total,)), dtype=float)


def _marks(record: Any, total: int) -> Sequence[int]:
    """After how many steps a state is given."""
    if record is None:
        return [total]
    if not isinstance(record, Sequence | np.ndarray | range):
        every = count("record", record)
        if every < 1:
            raise ValueError(f"record = {every}: must be positive, or numbers of steps")
        return range(0, total + 1, every)
    marks = [count("record", each) for each in record]
    if not marks or marks[0] < 0 or marks[-1] > total or any(b <= a for a, b in pairwise(marks)):
        raise ValueError(f"record = {shown(record)}: must grow, from 0 or later to {total}, the last step, or earlier")
    return marks


def _results(out: Any, whole: tuple[int, ...]) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """The arrays for the results, new or the user's."""
    kinds = np.dtype(float), np.dtype(float), np.dtype(np.int64)
    if out is None:
        try:
            return np.empty(whole), np.empty(whole), np.empty(whole, np.int64)
        except (MemoryError, ValueError):
            raise ValueError(f"states of shape {whole}: must fit into memory, 24 bytes each") from None
    if not isinstance(out, tuple) or len(out) != 3 or not all(isinstance(each, np.ndarray) for each in out):
        raise TypeError("out must be a tuple of three arrays: theta, velocity, turns")
    for each, kind in zip(out, kinds, strict=True):
        if each.dtype != kind:
            raise TypeError(f"out has an array of {each.dtype}: must be float64, float64 and int64")
        if each.shape != whole:
            raise ValueError(f"out has an array of shape {each.shape}: must have the shape of the result, {whole}")
        if not each.flags.writeable:
            raise ValueError("out has an array that is read-only: must be writable")
    theta, velocity, turns = out
    return theta, velocity, turns
