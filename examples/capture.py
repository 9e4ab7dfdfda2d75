"""Adiabatic capture: a beam without bunches is taken into buckets that grow slowly.

Without a voltage the action of a particle is |velocity|. A slow change keeps it until the bucket has grown to the particle: half of
the area inside the separatrix, 2 pi 4 omega0/pi, is then 2 pi |velocity|. From there on the particle swings, with the action of both
halves, 2 |velocity|. So of a beam whose velocities are Gaussian, s rms, the share

    erf(4 omega0/(pi s sqrt(2)))

is in the bucket, and the distribution of the actions is known too. What is not slow misses both. Here omega0 grows from 0.02 to 1
so that it changes by the same share in each swing: 1/omega0 falls evenly with time.

Run: python examples/capture.py; docs/ensembles-examples.md shows the picture.
Source: Lee, Accelerator Physics (2019), section 3.IV; Cary, Escande & Tennyson, Phys. Rev. A 34 (1986), 4256.
"""

import math

import numpy as np
from scipy.special import erf, ndtri

import libration
from libration import ensemble

# Of the picture, in inches.
SIZE = (13.5, 4.8)
FIRST, LAST = 0.02, 1.0
SPREAD = 0.8
# Of the ramps and of a step, in units of 1/omega0 at the end.
DURATIONS, STEP = (50.0, 500.0, 5000.0), 0.25


def beam(n):
    """Particles at all phases, Gaussian in the velocity: evenly spread points of the unit square."""
    number = np.arange(1, n + 1)
    return math.tau * ((number * 0.7548776662466927) % 1) - math.pi, SPREAD * ndtri((number - 0.5) / n)


def ramp(duration):
    """omega0 in the middle of each step."""
    steps = round(duration / STEP)
    return 1 / np.linspace(1 / FIRST, 1 / LAST, 2 * steps + 1)[1::2]


def captured(duration, n, looks=30):
    """omega0 at some times of a ramp, the share of the beam that swings then, and the states at its end."""
    omega0, (theta, velocity) = ramp(duration), beam(n)
    marks = np.unique(np.append(np.searchsorted(omega0, np.linspace(FIRST, LAST, looks)), len(omega0)))
    theta, velocity, _ = ensemble.track(theta, velocity, STEP, omega0, steps=len(omega0), record=list(marks))
    now = np.append(omega0, LAST)[marks]
    share = np.mean(libration.energy_ratio(theta, velocity, now[:, None]) < 1, axis=1)
    return now, share, (theta[-1], velocity[-1])


def law(omega0):
    """The share that swings after a slow ramp."""
    return erf(4 * omega0 / (math.pi * SPREAD * math.sqrt(2)))


def actions(state, n):
    """Of the captured particles: |velocity| of the beam, and the action at the end."""
    _, velocity = beam(n)
    inside = libration.energy_ratio(*state, LAST) < 1
    return np.abs(velocity[inside]), libration.action(state[0][inside], state[1][inside], LAST)


def draw(figure, n=5_000, durations=DURATIONS):
    """Phase space after the slowest ramp, the captured share, and the actions."""
    space, shares, kept = figure.subplots(1, 3, width_ratios=(1.1, 1, 1))
    colors = ("#c44601", "#00805e", "#0072b2")
    for duration, color in zip(durations, colors, strict=True):
        omega0, share, state = captured(duration, n)
        shares.plot(omega0, share, "o", ms=4, color=color, label=f"in {duration / math.tau:.0f} periods")
        before, after = actions(state, n)
        kept.plot(before, after, ".", ms=1.5, color=color, rasterized=True)
    _, velocity = beam(n)
    dots = space.scatter(*state, s=1.5, c=np.abs(velocity), cmap="viridis", vmax=2 * SPREAD, rasterized=True)
    figure.colorbar(dots, ax=space, location="top", shrink=0.9, aspect=34, pad=0.02, extend="max").set_label(
        "|velocity| in the beam", fontsize=9.5
    )
    angle = np.linspace(-math.pi, math.pi, 400)
    for side in (1, -1):
        space.plot(angle, side * 2 * LAST * np.cos(angle / 2), color="black", ls="--", lw=1.2)
    space.set(xlim=(-math.pi, math.pi), ylim=(-3, 3), xlabel="θ", ylabel="velocity over ω₀ at the end")

    omega0 = np.linspace(0, LAST, 200)
    shares.plot(omega0, law(omega0), color="black", lw=1.2, label="slow, by the formula")
    shares.set(xlim=(0, LAST), ylim=(0, 1), xlabel="ω₀ over that at the end", ylabel="share of the beam that swings")
    shares.set_title("Capture while ω₀ grows", loc="left", fontsize=11)
    shares.legend(fontsize=9, loc="lower right")
    edge = 8 * LAST / math.pi
    kept.plot([0, edge / 2], [0, edge], color="black", lw=1.2, label="twice |velocity|")
    kept.set(xlim=(0, 0.65 * edge), ylim=(0, edge), xlabel="|velocity| in the beam", ylabel="action in the bucket")
    kept.set_title("Actions after it", loc="left", fontsize=11)
    kept.legend(fontsize=9, loc="lower right")


if __name__ == "__main__":
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    draw(figure)
    figure.savefig("capture.png")
