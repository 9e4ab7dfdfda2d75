"""Filamentation: what happens to a bunch after its voltage has jumped, and to one that was kicked.

Each particle keeps its action and goes round at a frequency of its own. So a bunch that does not fit its bucket is wound up into a
spiral. Its mean square angle goes to the mean over the phases of each action. The mean of a kicked bunch is lost too, which is often
called Landau damping: of a small Gaussian bunch, sigma rad rms, displaced by z sigma, where omega = omega0 (1 - a**2/16),

    |mean of theta + i velocity/omega0| = z sigma exp(-z**2/2 u**2/(1 + u**2))/(1 + u**2),    u = sigma**2 omega0 t/8.

Run: python examples/filamentation.py; docs/ensembles-examples.md shows the picture.
Source: Meller, Chao, Peterson, Peggs & Furman, Decoherence of Kicked Beams, SSC-N-360 (1987); Lee, Accelerator Physics (2019), section 3.II.
"""

import math

import numpy as np

import libration
from libration import ensemble

# Of the picture, in inches.
SIZE = (13.5, 4.6)
# The bunch was matched to a bucket of this frequency; after the jump of the voltage omega0 is 1.
BEFORE = 0.6
SIGMA, KICK = 0.15, 2.0


def jumped(n, first=0):
    """A parabolic bunch of the bucket before the jump."""
    return ensemble.bunch(n, distribution="parabolic", sigma_theta=0.85, omega0=BEFORE, seed=1, quiet=True, first=first)


def kicked(n, first=0):
    """A small Gaussian bunch displaced by KICK times its rms angle."""
    theta, velocity = ensemble.bunch(n, distribution="gaussian", sigma_theta=SIGMA, seed=1, quiet=True, first=first)
    return theta + KICK * SIGMA, velocity


def rms_angle(t, n):
    """Rms angle of the bunch at times after the jump."""
    return np.sqrt(ensemble.reduce(jumped, n=n, t=t).theta_variance.values)


def rms_in_the_end(n, phases=64):
    """Rms angle when every particle may be anywhere on its orbit."""
    action = libration.action(*jumped(n))
    theta, _ = libration.from_action_phase(action[:, None], math.tau * np.arange(phases) / phases)
    return math.sqrt(np.mean(theta**2))


def centroid(t, n):
    """Size of the mean of theta + i velocity of the kicked bunch."""
    sums = ensemble.reduce(kicked, n=n, t=t, mean={"centroid": lambda theta, velocity: theta + 1j * velocity})
    return np.abs(sums.centroid.values)


def centroid_law(t):
    """The same by the formula."""
    u = SIGMA**2 * t / 8
    return KICK * SIGMA * np.exp(-0.5 * KICK**2 * u**2 / (1 + u**2)) / (1 + u**2)


def draw(figure, n=200_000, dense=1_000_000, times=401):
    """Phase space after the jump, its rms angle, and the mean of the kicked bunch."""
    space, widths, means = figure.subplots(1, 3, width_ratios=(1.15, 1, 1))
    theta, velocity = libration.motion(80.0, *jumped(dense))
    edges = np.linspace(-2.6, 2.6, 401), np.linspace(-2.0, 2.0, 401)
    counts, _, _ = np.histogram2d(theta, velocity, edges)
    space.pcolormesh(*edges, np.where(counts > 0, counts, np.nan).T, cmap="magma_r", vmin=0, rasterized=True)
    angle = np.linspace(-math.pi, math.pi, 400)
    for side in (1, -1):
        space.plot(angle, side * 2 * np.cos(angle / 2), color="#c44601", ls="--", lw=1.3)
    space.set(xlim=(-2.6, 2.6), ylim=(-2.0, 2.0), xlabel="θ", ylabel="velocity over ω₀")
    space.set_title("13 periods after the voltage jumped", loc="left", fontsize=11)

    t = np.linspace(0, 120, times)
    widths.plot(t / math.tau, rms_angle(t, n), color="#0072b2", lw=1.2, label=f"{n:,} particles".replace(",", " "))
    end = rms_in_the_end(min(n, 20_000))
    widths.axhline(end, color="#c44601", ls="--", lw=1.3, label="every phase as likely")
    widths.set(xlim=(0, 120 / math.tau), xlabel="periods of small swings", ylabel="rms angle in rad")
    widths.set_title("Filamentation", loc="left", fontsize=11)
    widths.legend(fontsize=9, loc="upper right")

    t = np.geomspace(20, 6_000, times // 8)
    means.loglog(t / math.tau, centroid(t, dense) / (KICK * SIGMA), "o", ms=4, color="#0072b2", label="exact motion")
    means.loglog(t / math.tau, centroid_law(t) / (KICK * SIGMA), color="#c44601", lw=1.3, label="the formula")
    means.set(xlabel="periods of small swings", ylabel="mean of θ + i θ̇/ω₀ over that at the start")
    means.set_title(f"A bunch of {SIGMA} rad kicked by {KICK:g} rms", loc="left", fontsize=11)
    means.legend(fontsize=9)


if __name__ == "__main__":
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    draw(figure)
    figure.savefig("filamentation.png")
