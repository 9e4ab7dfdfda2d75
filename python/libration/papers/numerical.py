"""The numerical solutions of the papers: SciPy's odeint at its default tolerances, as Horsley runs it.

SciPy is needed only here (`pip install 'libration[papers]'`).
"""

import numpy as np


def odeint_theta(t, theta0, velocity0, omega0):
    """The angle of the pendulum by scipy.integrate.odeint, defaults kept, at the instants t that begin at 0."""
    from scipy.integrate import odeint  # type: ignore[import-untyped]

    def derivative(state, _t):
        theta, velocity = state
        return velocity, -(omega0**2) * np.sin(theta)

    return odeint(derivative, (theta0, velocity0), t)[:, 0]
