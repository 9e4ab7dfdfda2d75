"""The tune spread of a bunch: how many particles go round at which frequency, for three bunches of one mean action.

The tune falls with the amplitude from qs to 0 at the edge of the bucket. A swing to theta_max has qs pi/(2 K(m)), m =
sin(theta_max/2)**2, a small one qs (1 - theta_max**2/16). In a matched bunch all phases are as likely, so the distribution of
the tunes is that of the actions. With rho(J) of these, omega0 = 1 and the integrals K and E,

    density over the frequency = rho(J) (dJ/dm)/|domega/dm|,
    dJ/dm = 4 K/pi,    domega/dm = -(pi/2 K**2) (E - (1 - m) K)/(2 m (1 - m)).

Run: python examples/tunes.py; docs/ensembles-examples.md shows the picture.
Source: Lee, Accelerator Physics (2019), section 3.II; DLMF 19.4.1.
"""

import math

import numpy as np

import libration
from libration import elliptic, ensemble

# Of the picture, in inches.
SIZE = (11.5, 4.6)
# Of the separatrix, and the mean of all bunches.
EDGE, MEAN = 8 / math.pi, 0.5
# The action that states the width of a bunch, and the density over the action.
BUNCHES = {
    "waterbag": (2 * MEAN, lambda action: np.where(action < 2 * MEAN, 0.5 / MEAN, 0.0)),
    "parabolic": (3 * MEAN, lambda action: np.maximum(1 - action / (3 * MEAN), 0.0) * 2 / (3 * MEAN)),
    "gaussian": (MEAN, lambda action: np.exp(-action / MEAN) / MEAN / -math.expm1(-EDGE / MEAN)),
}


def frequencies(name, n):
    """Frequencies over omega0 of the particles of a matched bunch."""
    return libration.frequency(*ensemble.bunch(n, distribution=name, action=BUNCHES[name][0], seed=1, quiet=True))


def law(name, m):
    """Frequency over omega0 of swings of the energy ratios m, and the density of the particles there."""
    k, e = elliptic.complete_k(m=m), elliptic.complete_e(m=m)
    slope = math.pi / (2 * k**2) * (e - (1 - m) * k) / (2 * m * (1 - m))
    action = libration.action(0.0, 2 * np.sqrt(m))
    return math.pi / (2 * k), BUNCHES[name][1](action) * 4 * k / math.pi / slope


def draw(figure, n=1_000_000):
    """The tune over the amplitude, and the particles over the tune."""
    swings, spread = figure.subplots(1, 2, width_ratios=(1, 1.3))
    degrees = np.linspace(0, 180, 721)
    angle = np.radians(degrees)
    swings.plot(degrees, libration.frequency(angle, 0.0), color="#0072b2", lw=1.8, label="exact")
    swings.plot(degrees, 1 - angle**2 / 16, color="#c44601", ls="--", lw=1.3, label="1 − θmax²/16")
    swings.set(xlim=(0, 180), ylim=(0, 1.03), xticks=range(0, 181, 45))
    swings.set(xlabel="amplitude θmax in degrees", ylabel="tune over qs")
    swings.set_title("The tune of a swing", loc="left", fontsize=11)
    swings.legend(fontsize=9)

    bins = np.linspace(0.4, 1.0, 121)
    m = 1 - np.geomspace(1e-9, 1, 4001)[:-1]
    for name, color in zip(BUNCHES, ("#0072b2", "#00805e", "#c44601"), strict=True):
        counts, _ = np.histogram(frequencies(name, n), bins)
        spread.stairs(counts / n / np.diff(bins), bins, fill=True, color=color, alpha=0.35)
        spread.plot(*law(name, m), color=color, lw=1.4, label=name)
    spread.set(xlim=(0.4, 1.005), ylim=(0, 17), xlabel="tune over qs", ylabel="share of particles over that of tunes")
    words = f"{n:,} particles".replace(",", " ")
    spread.set_title(f"{words}, and the formula as lines", loc="left", fontsize=11)
    spread.legend(fontsize=9, loc="upper left")


if __name__ == "__main__":
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    draw(figure)
    figure.savefig("tunes.png")
