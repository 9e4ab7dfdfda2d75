"""Reference values for action, mean frequency, phase and Fourier amplitudes; writes vectors/action.csv.

Every sixth row of inputs/pendulum.csv. The action is a difference of Legendre's integrals (Landau & Lifshitz, section 49; DLMF 19.5),
the amplitudes come from the nome (DLMF 22.11) and the phase from Carlson's R_F (orbit.py); the condition numbers are
central differences at many more digits. `amplitude_j` is that of sin(j phase) in theta, NaN where nothing repeats;
`distortion` is the root of the sum of amplitude_j^2 over j >= 2, over amplitude_1. Run: python action.py (a minute).
"""

from fractions import Fraction

import exact
import mpmath as mp
import orbit
from exact import agreed, decimal, hi_lo, mpf, real

NAME = "action.csv"
INPUTS = "id stratum theta0 velocity0 omega2 t".split()
HARMONICS = (1, 2, 3, 10)
OUTPUTS = ["action", "frequency", "phase", *(f"amplitude_{j}" for j in HARMONICS), "distortion"]
HEADER = [*INPUTS, "regime", *(f"{name}_{part}" for name in OUTPUTS for part in ("hi", "lo"))]
HEADER += [f"cond_{name}" for name in OUTPUTS]
EVERY = 6


def nome(m, mc):
    return mp.exp(-mp.pi * mp.elliprf(0, m, 1) / mp.elliprf(0, mc, 1))


def series(regime, m, mc):
    """amplitude(j) of sin(j phase), j >= 1."""
    if regime == "libration":
        q = nome(m, mc)
        return lambda j: 8 * mp.sqrt(q) ** j / (j * (1 + q**j)) if j % 2 else mpf(0)
    q = nome(1 / m, -mc / m)
    return lambda j: 4 * q**j / (j * (1 + q ** (2 * j)))


def distortion(amplitude):
    total, j = mpf(0), 2
    while True:
        term = amplitude(j) ** 2 + amplitude(j + 1) ** 2
        total += term
        ahead = amplitude(j + 2) ** 2 + amplitude(j + 3) ** 2
        # The terms fall at least as fast as these two.
        if ahead == 0 or ahead / (1 - ahead / term) < total * mp.eps:
            return mp.sqrt(total) / amplitude(1)
        j += 2


def values(theta0, velocity0, omega2, t):
    """regime and the OUTPUTS."""
    angle, v, time = real(theta0), real(velocity0), real(t)
    nothing = [mpf(0)] * (len(HARMONICS) + 1)
    if omega2 == 0:
        still = "rest" if v == 0 else "rotation"
        return still, [abs(v), v, angle + v * time if v else mpf(0), *nothing]
    regime, n, omega, s, c, x, m, mc = orbit.start(theta0, velocity0, omega2)
    if regime == "separatrix":
        return regime, [8 * omega / mp.pi, mpf(0), mp.nan, *[mp.nan] * len(nothing)]
    if regime == "rest":
        return regime, [mpf(0), omega, omega * time, *nothing]
    arc = s * mp.elliprf(x * x, m * c * c, m)
    if regime == "libration":
        K = mp.ellipk(m)
        tau = arc if x >= 0 else (mp.sign(s) or 1) * 2 * K - arc
        # (E - mc K)/m is a hypergeometric function, whose series does not cancel where m is small.
        share = m * mp.pi / 4 * mp.hyp2f1(0.5, 0.5, 2, m) if m < 0.5 else mp.ellipe(m) - mc * K
        action = 8 * omega / mp.pi * share
        rate = mp.pi * omega / (2 * K)
        phase = mp.pi * (tau + omega * time) / (2 * K)
    else:
        inner, root, side = 1 / m, mp.sqrt(m), mp.sign(x)
        K = mp.ellipk(inner)
        action = 4 * omega / mp.pi * root * mp.ellipe(inner)
        rate = side * mp.pi * omega * root / K
        phase = 2 * mp.pi * n + (mp.pi if omega2 < 0 else 0) + mp.pi * root * (arc + side * omega * time) / K
    amplitude = series(regime, m, mc)
    turned = [(-1) ** j if regime == "rotation" and omega2 < 0 else 1 for j in HARMONICS]
    amplitudes = [sign * amplitude(j) for sign, j in zip(turned, HARMONICS, strict=True)]
    return regime, [action, rate, phase, *amplitudes, distortion(amplitude)]


def conditions(given):
    """sum |x d/dx| of each output, by central differences."""
    totals = [mpf(0)] * len(OUTPUTS)
    for i, value in enumerate(given):
        if value == 0:
            continue
        sides = []
        for sign in (1, -1):
            moved = list(given)
            moved[i] = value * (1 + sign * Fraction(1, 2**120))
            sides.append(values(*moved)[1])
        totals = [
            total + abs(above - below) * mpf(2) ** 119 for total, above, below in zip(totals, *sides, strict=True)
        ]
    return totals


def row(inputs):
    """One row of the file from its input columns."""
    given = [Fraction(float.fromhex(inputs[name])) for name in INPUTS[2:]]

    def evaluate():
        regime, leads = values(*given)
        return regime, leads, []

    regime, leads, _ = agreed(evaluate, orbit.first_digits(*given))
    with mp.workdps(orbit.first_digits(*given) + 60):
        slopes = [mpf(0)] * len(OUTPUTS) if regime in ("separatrix", "rest") else conditions(given)
    with mp.workdps(60):
        pairs = [word for lead in leads for word in hi_lo(lead)]
        return [*(inputs[name] for name in INPUTS), regime, *pairs, *(decimal(+slope, 6) for slope in slopes)]


def inputs():
    return exact.read(exact.ROOM / "inputs" / "pendulum.csv")[::EVERY]


if __name__ == "__main__":
    exact.write(NAME, HEADER, map(row, inputs()))
