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
# # Why does my integrator disagree?
#
# `solve_ivp` with its defaults sends a pendulum over the top that swings for ever. The exact motion shows it, and when.
#
# `pip install 'libration[plot]' scipy`.

# %%
import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp

from libration import Pendulum

pendulum = Pendulum(3.0, length=1.0, gravity=9.8)
t = np.linspace(0.0, 30.0, 601)
exact = pendulum.theta(t)


def right_side(_t, state):
    return [state[1], -9.8 * np.sin(state[0])]


def solved(**options):
    return solve_ivp(right_side, (0.0, 30.0), [3.0, 0.0], t_eval=t, **options).y[0]


# %% [markdown]
# The defaults have a relative tolerance of 1e-3. That is a tolerance of each step, not of the end.

# %%
default = solved()
over = t[np.argmax(np.abs(default) > np.pi)]
print(f"over the top after {over:.2f} s; the exact angle is never more than {np.abs(exact).max():.6f} rad")
assert 0 < over < 15 and np.abs(exact).max() <= 3.0

# %% [markdown]
# Smaller tolerances give smaller errors, and every error grows with time. On logarithmic axes a straight line is a power of the time.

# %%
errors = {}
figure, axes = plt.subplots()
for rtol in (1e-3, 1e-6, 1e-9, 1e-12):
    errors[rtol] = np.abs(solved(rtol=rtol, atol=rtol, method="DOP853") - exact)
    axes.loglog(t[1:], errors[rtol][1:], label=f"rtol {rtol:.0e}")
axes.set_xlabel("t [s]")
axes.set_ylabel("error [rad]")
legend = axes.legend()

# %%
ends = [errors[rtol][-100:].max() for rtol in errors]
print("largest error of the last five seconds:", [f"{each:.0e}" for each in ends])
assert ends[1] > ends[2] > ends[3]

# %% [markdown]
# An integrator that keeps the energy in the mean, as the Verlet method, has another error: its phase. `approx.compare` has them side by side.

# %%
from libration import approx

for name, step in (("euler-cromer", 0.01), ("verlet", 0.01), ("rk4", 0.01)):
    error = approx.numerical(f"{name}:{step}").of(pendulum).error(5.0)
    print(f"{name:13} {error.difference:.2e} rad in five periods")
