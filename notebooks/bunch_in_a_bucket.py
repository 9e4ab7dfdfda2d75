# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # A bunch in a bucket
#
# Particles in a stationary bucket of a synchrotron are pendulums. One that arrives displaced smears out: each particle has its own tune.
# Every state below is one exact step from the start, however many turns away.
#
# `pip install 'libration[plot]' scipy`.

# %%
import matplotlib.pyplot as plt
import numpy as np

from libration import ensemble

ring = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
print(f"synchrotron tune {ring.qs:.5f}, height {ring.height:.3e}")

# %% [markdown]
# A Gaussian bunch that is displaced by a radian, in the pendulum's own units: angle, and velocity over omega0.

# %%
import libration

bunch = np.random.default_rng(65).normal(scale=0.25, size=(2, 20_000))
theta0, velocity0 = 1.0 + bunch[0], bunch[1]

# %%
figure, axes = plt.subplots(1, 3, figsize=(11, 3.6), sharex=True, sharey=True)
states = {}
for ax, periods in zip(axes, (0, 10, 100), strict=True):
    states[periods] = libration.motion(2 * np.pi * periods, theta0, velocity0, 1.0)
    ax.plot(*states[periods], ",")
    ax.set_title(f"{periods} periods of small swings")
    ax.set_xlabel("θ [rad]")
label = axes[0].set_ylabel("velocity / omega0")

# %% [markdown]
# The action of each particle stays what it was; the mean of the angles goes to zero as the bunch fills its ring.

# %%
before, after = (libration.action(*states[periods], 1.0) for periods in (0, 100))
means = [abs(states[periods][0].mean()) for periods in states]
print(f"actions changed by {np.abs(after - before).max():.1e}; means of the angle {[f'{each:.3f}' for each in means]}")
assert np.abs(after - before).max() < 1e-12 and means[2] < 0.1 * means[0]

# %% [markdown]
# The tune of a particle falls with its amplitude. That is why the bunch smears.

# %%
amplitude = np.radians([1.0, 60.0, 120.0])
print((ring.tune(amplitude) / ring.qs).round(4).tolist())
