"""The error of an answer: the largest |got - reference| / max(|reference|, scale) over a sample of the inputs.

scale is the largest angle (velocity) of the orbit, pi in rotation. So an angle near zero is measured by the size of the swing,
and an angle of many turns by its own size. One unit in the last place is 1.1e-16 to 2.2e-16 here. An answer that is not
finite has an infinite error.
"""

import math
import subprocess
import sys
from pathlib import Path

import numpy as np

SAMPLE = 200


def reference_values(theta0, velocity0, t) -> np.ndarray:
    """Rows theta_hi, theta_lo, velocity_hi, velocity_lo for broadcast inputs, from reference_values.py."""
    rows = np.broadcast(theta0, velocity0, t)
    asked = "\n".join(" ".join(float(value).hex() for value in row) for row in rows)
    script = Path(__file__).with_name("reference_values.py")
    answer = subprocess.run([sys.executable, str(script)], input=asked, text=True, capture_output=True, check=True)
    lines = answer.stdout.splitlines()
    if len(lines) != rows.size:
        raise SystemExit(f"{script}: {len(lines)} answers to {rows.size} inputs")
    return np.array([[float.fromhex(word) for word in line.split()] for line in lines]).T


def error(got, hi, lo, scale) -> float:
    """The largest relative error; `got`, `hi`, `lo` are arrays of the same length."""
    got = np.asarray(got, dtype=float)
    if got.shape != hi.shape:
        raise ValueError(f"{got.shape} answers to {hi.shape} inputs")
    if not np.all(np.isfinite(got)):
        return math.inf
    return float(np.max(np.abs((got - hi) - lo) / np.maximum(np.abs(hi), scale)))


class Reference:
    """Reference values at a sample of the inputs, which measure whole answers.

    Parameters
    ----------
    theta0, velocity0, t : float or array
        All inputs of the comparison, omega0 = 1.
    indices : array of int
        Which of them are compared.
    """

    def __init__(self, theta0, velocity0, t, indices: np.ndarray) -> None:
        inputs = [np.broadcast_to(value, np.shape(t))[indices] for value in (theta0, velocity0, t)]
        self.indices = indices
        self.rows = reference_values(*inputs)
        s, half = np.sin(inputs[0] / 2), inputs[1] / 2
        kappa = np.hypot(s, half)
        angle = np.where(kappa < 1, 2 * np.arcsin(np.minimum(kappa, 1)), math.pi)
        turned = np.abs(inputs[0] - np.remainder(inputs[0] + math.pi, 2 * math.pi) + math.pi)
        self.scales = angle + turned, 2 * kappa

    def errors(self, answer: tuple) -> list[float]:
        """One error per output of the answer (theta, or theta and velocity)."""
        found = []
        for place, got in enumerate(answer):
            hi, lo = self.rows[2 * place : 2 * place + 2]
            found.append(error(np.asarray(got).reshape(-1)[self.indices], hi, lo, self.scales[place]))
        return found
