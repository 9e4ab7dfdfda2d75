"""Forces p u + r u^2 + q u^3 - c with wanted equilibria, and starts of a wanted energy.

A force is (p, r, q, c). Used by helmholtz_duffing_inputs.py.
"""

from fractions import Fraction

from oscillator_inputs import root


def potential(u, force):
    """Twice the potential energy."""
    u, p, r, q, c = map(Fraction, (u, *force))
    return p * u**2 + 2 * r * u**3 / 3 + q * u**4 / 2 - 2 * c * u


def through(draw, u0, force, level):
    """The orbit through u0 with 2E = level."""
    return u0, draw.sign() * root(level - potential(u0, force)), *force


def equilibria(draw, q, places):
    """Coefficients with the force q (u - a) (u - b) (u - c), rounded."""
    a, b, c = places
    return q * (a * b + a * c + b * c), -q * (a + b + c), q, q * a * b * c


def spread(draw):
    """Three ascending places of either sign with gaps of order 1."""
    low = draw.sign() * draw.number(-3, 2)
    middle = low + draw.number(-1, 1)
    return low, middle, middle + draw.number(-1, 1)
