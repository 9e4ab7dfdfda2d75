"""The promised times of single calls: an instant, a set-up, the import, the help, a table. Run: python bench/run_calls.py

Each is the best of many on a machine that does nothing else; ends with an error where a promise is not kept.
"""

import math
import os
import resource
import subprocess
import sys
import tempfile
import time
import timeit

import numpy as np

from libration import Pendulum
from libration.cli.files import write_csv

PENDULUM = Pendulum(3.0, 0.1, length=1.0)
PAGES = (["--help"], ["solve", "--help"], ["period", "--help"], ["compare", "--help"])


def best(work, number: int) -> float:
    """Shortest mean time of one call in seconds."""
    return min(timeit.repeat(work, number=number, repeat=20)) / number


def imports(package: str) -> float:
    """Seconds of a process that imports a package and nothing else."""
    begin = time.perf_counter()
    subprocess.run([sys.executable, "-c", f"import {package}"], check=True)
    return time.perf_counter() - begin


def processor(words: list[str]) -> float:
    """Seconds of processor of one command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-m", "libration", *words], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def table() -> float:
    """Seconds of processor that write a million rows of four columns."""
    values = np.random.default_rng(0).standard_normal(10**6)
    columns = [(name, "s", values) for name in "abcd"]
    begin = time.process_time()
    with tempfile.TemporaryFile() as file:
        write_csv(file, [("period", math.pi, "s")], columns)
    return time.process_time() - begin


def promises() -> dict[str, tuple[float, float]]:
    """What is measured and what is promised, by what it is, in seconds; the import as a ratio."""
    found = {}
    for method in ("theta", "velocity", "motion", "turns"):
        call = getattr(PENDULUM, method)
        found[f"Pendulum.{method} of one instant"] = best(lambda call=call: call(1.234), 2000), 2e-6
    found["set-up of a Pendulum"] = best(lambda: Pendulum(3.0, 0.1, length=1.0), 500), 10e-6
    pairs = [(imports("libration"), imports("numpy")) for _ in range(15)]
    found["import, by the import of NumPy"] = min(a for a, _ in pairs) / min(b for _, b in pairs), 1.5
    for words in PAGES:
        found["libration " + " ".join(words)] = min(processor(words) for _ in range(3)), 0.3
    found["a table of a million rows"] = table(), 5.0
    return found


def main() -> int:
    os.environ["COLUMNS"] = "80"
    broken = 0
    for what, (measured, promised) in promises().items():
        broken += measured > promised
        verdict = "holds" if measured <= promised else "does not hold"
        print(f"{what:34} {measured:9.3g}, at most {promised:g}: {verdict}")
    return int(broken > 0)


if __name__ == "__main__":
    sys.exit(main())
