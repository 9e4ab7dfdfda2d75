"""Check of vectors/action.csv: action and amplitudes from samples of the motion.

The trapezoidal rule over one period converges like the nome to the power of the number of samples: action is the mean of
velocity^2 over the frequency (which is 2 pi over the period), an amplitude the discrete Fourier transform of the angle. Only for orbits whose
nome is not too large; the tests check the other rows by identities.
"""

from fractions import Fraction

import action
import mpmath as mp
import orbit
from exact import mpf, rational, real

SAMPLES = 128
AGREE = mpf(10) ** -25


def measured(row):
    """action, frequency and amplitudes of a row by samples, None where they would not converge."""
    theta0, velocity0, omega2 = (Fraction(float.fromhex(row[name])) for name in ("theta0", "velocity0", "omega2"))
    if row["regime"] not in ("libration", "rotation") or omega2 == 0:
        return None
    with mp.workdps(60):
        _, _, _, _, _, _, m, mc = orbit.start(theta0, velocity0, omega2)
        if abs(mc) < 0.05 or m < 1e-4 or m > 100 or abs(theta0) > 3:
            return None
        period = orbit.period(row["regime"], mp.sqrt(real(abs(omega2))), m, mc)
        frequency = 2 * mp.pi / period * (-1 if row["regime"] == "rotation" and velocity0 < 0 else 1)
        # The phase at t = 0 from the column of the phase at t.
        phase = mpf(float.fromhex(row["phase_hi"])) + mpf(float.fromhex(row["phase_lo"]))
        start = phase - frequency * real(Fraction(float.fromhex(row["t"])))
        angles, speeds, phases = [], [], []
        for i in range(SAMPLES):
            t = rational(period * i / SAMPLES)
            _, leads, _ = orbit.evaluate(theta0, velocity0, omega2, t)
            phases.append(start + frequency * real(t))
            angles.append(leads[0] - (phases[-1] if row["regime"] == "rotation" else mpf(0)))
            speeds.append(leads[1])
        values = {
            "action": sum(v * v for v in speeds) / SAMPLES / abs(frequency),
            "frequency": frequency,
        }
        for j in action.HARMONICS:
            wave = sum(a * mp.sin(j * p) for a, p in zip(angles, phases, strict=True))
            values[f"amplitude_{j}"] = 2 * wave / SAMPLES
        return values


def wrong(row):
    """The columns of a row that the samples contradict."""
    with mp.workdps(60):
        found = []
        for name, value in (measured(row) or {}).items():
            stored = mpf(float.fromhex(row[f"{name}_hi"])) + mpf(float.fromhex(row[f"{name}_lo"]))
            scale = abs(mpf(float.fromhex(row["amplitude_1_hi"]))) if "amplitude" in name else abs(stored)
            if abs(value - stored) > AGREE * scale:
                found.append(name)
        return found
