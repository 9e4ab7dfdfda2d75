"""The lab's texts of code, run: what a text prints, beside what the core has for the same start.

The texts are those of lab/tests/snippets.json, which lab/tests/code.test.ts holds equal to what the page gives.
"""

import json
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import libration

SNIPPETS: list[dict[str, Any]] = json.loads(
    (Path(__file__).parents[2] / "lab/tests/snippets.json").read_text(encoding="utf-8")
)
NAMES = [
    f"{one['kind']}-{one['start']['theta0']:.4g}-{one['start']['velocity0']:.4g}-{one['start']['length']:g}"
    for one in SNIPPETS
]


def printed(snippet: dict[str, Any], code: str, command: list[str], suffix: str) -> str:
    """What an interpreter prints for a text."""
    return run("\n".join(snippet["texts"][code]) + "\n", command, suffix)


def run(text: str, command: list[str], suffix: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / f"pendulum{suffix}"
        script.write_text(text, encoding="utf-8")
        done = subprocess.run([*command, str(script)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def wanted(snippet: dict[str, Any]) -> tuple[float | None, np.ndarray]:
    """The period, and rows of time, angle and velocity, from the core."""
    start, times = snippet["start"], np.array(snippet["times"], dtype=float)
    if snippet["kind"] == "rest":
        return None, np.column_stack([times, np.full_like(times, start["theta0"]), np.zeros_like(times)])
    if snippet["kind"] == "separatrix":
        # The unit pendulum with velocity 2 is on it exactly; the time from the bottom is where its angle is the start's.
        omega0 = np.sqrt(start["gravity"] / start["length"])
        unit = libration.Pendulum(0.0, np.copysign(2.0, start["velocity0"]))
        (begun,) = unit.times(start["theta0"], -50.0, 50.0)
        theta, velocity = unit.motion(begun + omega0 * times)
        return np.inf, np.column_stack([times, theta, omega0 * velocity])
    pendulum = libration.Pendulum(**start)
    return pendulum.period, np.column_stack([times, *pendulum.motion(times)])


def difference(output: str, snippet: dict[str, Any]) -> float:
    """Largest difference of what is printed from the core; infinite where something else is printed than should be."""
    period, rows = wanted(snippet)
    words = [line.split() for line in output.split("\n") if line != ""]
    found = np.array([[float(word) for word in line] for line in words if line[0] != "period"])
    periods = [float(line[1]) for line in words if line[0] == "period"]
    if found.shape != rows.shape or len(periods) != (period is not None):
        return np.inf
    largest = float(np.max(np.abs(found - rows)))
    if period is None or (np.isinf(period) and periods == [period]):
        return largest if np.isfinite(largest) else np.inf
    both = max(largest, abs(periods[0] / period - 1))
    return both if np.isfinite(both) else np.inf
