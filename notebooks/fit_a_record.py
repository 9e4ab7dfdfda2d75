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
# # Fit a record
#
# A record of angles against times, as a video tracker or a phone gives it: what is g, how sure is it, and what speaks against it?
#
# `pip install 'libration[fit]'`. Here the record is made, from a pendulum with friction and noise of a tenth of a degree, so that the truth is known.

# %%
import math

import numpy as np

import libration

truth = libration.DampedPendulum(math.radians(40.0), length=0.8, gravity=9.79, friction=libration.Friction(linear=0.02))
t = np.arange(0.0, 40.0, 1 / 30)
noise = np.random.default_rng(7).normal(scale=math.radians(0.1), size=t.size)
angle = truth.theta(t) + noise

# %% [markdown]
# One call. The length has an uncertainty, and nothing has a start value.

# %%
found = libration.fit(t, angle, quantity="angle", length=(0.8, 0.0005))
print(found)

# %% [markdown]
# The truth lies within the uncertainty that is stated, k = 2.

# %%
assert found.stands
assert abs(found.g.value - 9.79) < 2 * found.g.u
print(f"g = {found.g} m/s^2")

# %%
figure = found.plot()

# %% [markdown]
# Of a file it is `libration.fit("swing.csv", length=(0.8, 0.0005))`; in the shell `libration fit swing.csv --length 0.8000±0.0005 --report fit.html`.
