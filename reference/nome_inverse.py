"""The parameter of a nome: the inputs of from_nome.csv, and the second route of its check.

family.py has the values, by Arb's theta functions; here the infinite product of DLMF 20.5 (A&S 16.38) serves, in mpmath.
"""

import math
import random

import mpmath as mp
from elliptic_inputs import log_uniform, sign
from exact import real


def nomes():
    rng = random.Random("nomes")
    for stratum, low, high in (("small", -1000, -60), ("unit", -40, -5), ("large", -4, -1)):
        for _ in range(20):
            yield {"stratum": stratum, "q": (sign(rng) * log_uniform(rng, low, high) / 2).hex()}
    for _ in range(20):
        yield {"stratum": "near_one", "q": (sign(rng) * (1 - log_uniform(rng, -9, -3) / 2)).hex()}
    edges = (0.1, 0.0, -0.0, 1.0, -1.0, 1.5, math.exp(-math.pi), 0.044, math.nextafter(0.044, 1), 0.985, -0.985, 0.99)
    for q in (*edges, 0.9999, -0.99, 5e-324, -1e-320, math.nan, math.inf):
        yield {"stratum": "edge", "q": float(q).hex()}


def parameters(q):
    """m = 16 q prod ((1 + q^2n)/(1 + q^(2n - 1)))^8, of any sign of q; 1 - m as a difference at many more digits."""
    with mp.workdps(400 + int(9 / (1 - abs(q))) * (abs(q) > 0.5)):
        x, m, n = real(q), 16 * real(q), 1
        while abs(x) ** (2 * n - 1) > mp.eps:
            m *= ((1 + x ** (2 * n)) / (1 + x ** (2 * n - 1))) ** 8
            n += 1
        return {"m": m, "mc": 1 - m}
