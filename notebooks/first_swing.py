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
# # The first swing
#
# A pendulum of one metre is released at 150 degrees. Where is it after seven seconds, and how long does a swing take?
#
# `pip install 'libration[plot,widget]'`. With anywidget the last line of the next cell is the lab, to drag; without it, a drawing.

# %%
from libration import Pendulum

pendulum = Pendulum.degrees(150.0, length=1.0)
pendulum

# %% [markdown]
# The angle at one instant, in degrees, and the period. Both are exact to the last digits.

# %%
import math

print(f"after 7 s {math.degrees(pendulum.theta(7.0)):.6f} degrees, period {pendulum.period:.9f} s")

# %% [markdown]
# Small swings would take 2 pi sqrt(L/g). How much longer is this one?

# %%
small = 2 * math.pi / pendulum.omega0
print(f"{small:.6f} s, and {100 * (pendulum.period / small - 1):.1f} % longer")

# %% [markdown]
# The longer the swing, the more it stays near the top. The dashed line is the linear solution.

# %%
axes = pendulum.plot()

# %% [markdown]
# The period is the first quarter four times. Here the claim is checked: after a period the pendulum is where it was.

# %%
assert abs(pendulum.theta(pendulum.period) - pendulum.theta(0.0)) < 1e-12
assert pendulum.theta(pendulum.period / 4) < 1e-12

# %% [markdown]
# To try: at which angle is the period twice that of small swings? `Pendulum.from_period` answers.

# %%
twice = Pendulum.from_period(2 * small, length=1.0)
print(f"{math.degrees(twice.theta_max):.4f} degrees")
assert abs(twice.period / small - 2) < 1e-12
