"""A fit by gradient: omega0, the kick and the length of a bunch, from the mean that a pickup sees of it.

The signal is the mean of sin(theta) over a kicked bunch, which is lost as the bunch smears (filamentation.py), with noise. The model is
that mean over 2,000 particles: angle displacement + sigma x, velocity kick + omega0 sigma y, (x, y) Gaussian and evenly spread.
libration.jax moves each exactly and gives the exact derivatives of the mean by the four numbers; SciPy's least squares take them.

Run: python examples/fit.py; docs/ensembles-examples.md shows the picture. A first call compiles for some seconds.
Source: Bradbury et al., JAX (2018); Branch, Coleman & Li, SIAM J. Sci. Comput. 21 (1999), 1.
"""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
from scipy.optimize import least_squares, minimize

import libration
from libration import ensemble
from libration.jax import motion

# Of the picture, in inches.
SIZE = (13.5, 4.6)
NAMES = ("displacement", "kick", "omega0", "sigma")
TRUE = np.array([0.7, 0.5, 1.0, 0.25])
GUESS = np.array([0.5, 0.3, 1.01, 0.35])
NOISE, TIMES = 0.01, np.linspace(0.0, 60.0, 121)


def particles(n, seed):
    """Evenly spread points of a Gaussian of rms 1 in two dimensions."""
    return ensemble.bunch(n, distribution="gaussian", sigma_theta=1.0, seed=seed, matched=False, quiet=True)


def states(of, x, y):
    """Angles and velocities of the particles of a bunch with these four numbers."""
    displacement, kick, omega0, sigma = of
    return displacement + sigma * x, kick + omega0 * sigma * y


def measured(n=50_000):
    """The signal, of many more and of other particles, and its noise."""
    theta, velocity = states(TRUE, *particles(n, seed=7))
    # Sums over the bunch, one time after the other.
    mean = [np.sin(libration.theta(t, theta, velocity, TRUE[2])).mean() for t in TIMES]
    return np.array(mean) + NOISE * np.random.default_rng(7).normal(size=len(TIMES))


def signal(of, x, y, times):
    """The mean over the particles (x, y), a function of JAX."""
    theta, _ = motion(times[:, None], *states(of, x, y), of[2], digits="short")
    return jnp.sin(theta).mean(axis=1)


def model(n=2000):
    """The signal of four numbers, and its derivatives by them: two functions that are compiled at their first call."""
    # As arguments: what is a constant of a compiled function is computed by the compiler, slowly.
    given = [jnp.asarray(each, jnp.float32) for each in (*particles(n, seed=1), TIMES)]
    compiled = jax.jit(signal), jax.jit(jax.jacfwd(signal))
    return tuple(partial(called, function, given) for function in compiled)


def called(function, given, of):
    """A compiled function of four numbers, as doubles of NumPy."""
    return np.asarray(function(jnp.asarray(of, jnp.float32), *given), float)


def fit(seen, value, slopes):
    """The four numbers, their standard errors, and the squares of the misfit in the order of the evaluations."""
    squares = []

    def misfit(of):
        found = (value(of) - seen) / NOISE
        squares.append(np.mean(found**2))
        return found

    found = least_squares(misfit, GUESS, jac=lambda of: slopes(of) / NOISE, x_scale=(0.1, 0.1, 0.01, 0.1), ftol=1e-5)
    errors = np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)))
    return found.x, errors, np.array(squares)


def without_gradient(seen, value, most):
    """The squares of the misfit by Nelder's and Mead's simplex, which takes values alone."""
    squares = []

    def misfit(of):
        squares.append(np.mean((value(of) - seen) ** 2) / NOISE**2)
        return squares[-1]

    minimize(misfit, GUESS, method="Nelder-Mead", options={"maxfev": most})
    return np.array(squares)


def draw(figure, n=2000, most=250):
    """The signal with its fit, and the misfit over the evaluations."""
    curves, misfits = figure.subplots(1, 2, width_ratios=(1.6, 1))
    seen, (value, slopes) = measured(), model(n)
    found, errors, squares = fit(seen, value, slopes)
    curves.plot(TIMES, value(GUESS), color="#8a8a8a", ls="--", lw=1.2, label="first guess")
    curves.plot(TIMES, value(found), color="#0072b2", lw=1.6, label="fit")
    curves.plot(TIMES, seen, ".", ms=4.5, color="#c44601", label="measured")
    curves.set(xlim=(0, TIMES[-1]), xlabel="t in s", ylabel="mean of sin θ")
    told = ", ".join(f"{name} {a:.4f}({e * 1e4:.0f})" for name, a, e in zip(NAMES, found, errors, strict=True))
    curves.set_title(told, loc="left", fontsize=11)
    curves.legend(fontsize=9, loc="upper right", ncols=3)

    simplex = without_gradient(seen, value, most)
    misfits.loglog(1 + np.arange(len(squares)), squares, "o-", ms=4, color="#0072b2", label="least squares by gradient")
    steps = 1 + np.arange(len(simplex))
    misfits.loglog(steps, np.minimum.accumulate(simplex), color="#c44601", lw=1.4, label="simplex, values alone")
    misfits.set(xlabel="evaluations of the bunch", ylabel="mean square misfit over the noise")
    misfits.set_title("From the first guess to the fit", loc="left", fontsize=11)
    misfits.legend(fontsize=9)


if __name__ == "__main__":
    from matplotlib.figure import Figure

    figure = Figure(figsize=SIZE, layout="constrained")
    draw(figure)
    figure.savefig("fit.png")
