"""A bunch in a stationary bucket: the tune, the action and the phase of each of a million particles, in three calls.

The phase of a particle against the wave is a pendulum's angle theta; its velocity stands for the momentum. omega0 = 2 pi 65 Hz is the
synchrotron frequency at the middle, and 8 omega0/pi the action of the separatrix. The bunch arrives late and too fast.
Picture: docs/pictures.py. Source: Lee, Accelerator Physics (2019), section 3.II.
"""

import math

import numpy as np

import libration

OMEGA0 = math.tau * 65.0
EDGE = 8 * OMEGA0 / math.pi


def bunch(count):
    """Angles in rad and velocities in rad/s of particles, Gaussian in both."""
    theta, velocity = np.random.default_rng(65).normal(size=(2, count))
    return 0.55 + 0.85 * theta, OMEGA0 * (0.45 + 0.75 * velocity)


def mean_of(values, theta, velocity, edges):
    """The mean of values in the cells of a grid over (theta, velocity), NaN where there is no particle."""
    counts, _, _ = np.histogram2d(theta, velocity, edges)
    sums, _, _ = np.histogram2d(theta, velocity, edges, weights=values)
    return np.where(counts > 0, sums / np.maximum(counts, 1), np.nan).T


def draw_bucket(figure, quiet, colors, count=1_000_000):
    """Phase space colored by the tune, the actions, and the phases over the actions."""
    theta, velocity = bunch(count)
    tune = libration.frequency(theta, velocity, OMEGA0) / math.tau
    action = libration.action(theta, velocity, OMEGA0) / EDGE
    phase = libration.phase(theta, velocity, OMEGA0)

    space, actions, phases = figure.subplots(1, 3, width_ratios=(1.25, 1, 1.1))
    inside = np.sin(theta / 2) ** 2 + (velocity / (2 * OMEGA0)) ** 2 < 1
    height = velocity / (2 * OMEGA0)
    edges = (np.linspace(-math.pi, math.pi, 361), np.linspace(-1.45, 1.45, 331))
    degrees = np.degrees(edges[0])
    outside, _, _ = np.histogram2d(theta[~inside], height[~inside], edges)
    gray = np.where(outside.T > 0, 1.0, np.nan)
    space.pcolormesh(degrees, edges[1], gray, cmap="Greys", vmin=0, vmax=4, rasterized=True)
    image = mean_of(tune[inside], theta[inside], height[inside], edges)
    mesh = space.pcolormesh(degrees, edges[1], image, cmap="viridis", vmin=25, vmax=65, rasterized=True)
    angle = np.linspace(-math.pi, math.pi, 400)
    for side in (1, -1):
        space.plot(np.degrees(angle), side * np.cos(angle / 2), color=colors["edge"], lw=1.4, ls=colors["dashes"])
    bar = figure.colorbar(mesh, ax=space, location="top", shrink=0.9, aspect=34, pad=0.02, extend="min")
    bar.set_label("tune in Hz", fontsize=9.5)
    bar.outline.set_visible(False)
    space.set(xlim=(-180, 180), ylim=(-1.45, 1.45), xticks=range(-180, 181, 90))
    space.set_xlabel("phase against the wave in degrees")
    space.set_ylabel("momentum over the height of the bucket")

    bins = np.linspace(0, 1, 101)
    actions.hist(action[inside], bins, weights=np.full(inside.sum(), 1e5 / count), color=colors["bunch"], alpha=0.85)
    actions.set(xlim=(0, 1), ylim=(0, None))
    actions.set_xlabel("action over that of the separatrix")
    actions.set_ylabel("particles in 100 000, by 1 %", color=colors["bunch"])
    curve = np.linspace(0.0, 1.0 - 1e-6, 500)
    state = libration.from_action_phase(curve * EDGE, 0.5 * math.pi, OMEGA0)
    tunes = actions.twinx()
    tunes.plot(curve, libration.frequency(*state, OMEGA0) / math.tau, color=colors["tune"], lw=1.8)
    tunes.set(ylim=(0, 70))
    tunes.set_ylabel("tune in Hz", color=colors["tune"])
    actions.set_title("Actions, and the tune over them", loc="left", fontsize=11)

    edges = (np.linspace(-math.pi, math.pi, 181), np.linspace(0, 1, 141))
    counts, _, _ = np.histogram2d(phase[inside], action[inside], edges)
    shares = np.where(counts > 0, counts, np.nan).T * (1e6 / count)
    phases.pcolormesh(np.degrees(edges[0]), edges[1], shares, cmap="magma_r", rasterized=True)
    phases.set(xlim=(-180, 180), ylim=(0, 1), xticks=range(-180, 181, 90))
    phases.set_xlabel("phase of the motion in degrees")
    phases.set_ylabel("action over that of the separatrix")
    phases.set_title("Phases, over the actions: dark where many", loc="left", fontsize=11)
    for axes in (space, actions, phases):
        quiet(axes)
    tunes.spines["top"].set_visible(False)
