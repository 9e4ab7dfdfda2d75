"""One thread against two: a process for each, because LIBRATION_NUM_THREADS is read once, at import.

Both processes are asked in turn, so that a slow minute is slow for both. The other one waits on its input and uses no
processor. Such a process is this module, run with `-m measurement.threads CASE COUNT` in bench/: one line in, seconds per
call out.
"""

import os
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import numpy as np
from cases.orbits import BY_NAME, states, times
from rivals.ours import MOTION, THETA

import libration

BENCH = Path(__file__).resolve().parents[1]
TEN_MILLION = 10**7
MILLION = 10**6
ACTIONS = "their actions"
ROUNDS = 9


def answer(case: str, count: int) -> None:
    """Prepare the work, then time one call (after an untimed one) for every line of the input."""
    if case in BY_NAME:
        call = THETA.orbit(BY_NAME[case], times(BY_NAME[case], count, 10))
    else:
        theta, velocity, t = states(count)
        action = partial(libration.action, theta, velocity, out=np.empty(count))
        call = action if case == ACTIONS else MOTION.states(theta, velocity, t)
    call()
    print("ready", flush=True)
    for _ in sys.stdin:
        call()
        begun = time.perf_counter_ns()
        call()
        print((time.perf_counter_ns() - begun) / 1e9, flush=True)


def started(case: str, count: int, threads: int) -> subprocess.Popen:
    """A process whose work is prepared."""
    command = [sys.executable, "-m", "measurement.threads", case, str(count)]
    environment = {**os.environ, "LIBRATION_NUM_THREADS": str(threads)}
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, env=environment, cwd=BENCH)
    if process.stdout.readline().strip() != "ready":
        raise SystemExit(f"{' '.join(command)}: no answer")
    return process


def compare(names: list[str]) -> list[dict]:
    """Seconds per call with one thread and with two, round by round, for orbits by name and for own states."""
    found = []
    for case, count in [*((name, TEN_MILLION) for name in names), ("states of their own", MILLION), (ACTIONS, MILLION)]:
        processes = {str(threads): started(case, count, threads) for threads in (1, 2)}
        seconds = {threads: [] for threads in processes}
        for _ in range(ROUNDS):
            for threads, process in processes.items():
                process.stdin.write("\n")
                process.stdin.flush()
                seconds[threads].append(float(process.stdout.readline()))
        for process in processes.values():
            process.stdin.close()
            process.wait()
        found.append({"case": case, "count": count, "seconds": seconds})
        print(f"  {case}", {threads: f"{min(taken) * 1e3:.1f} ms" for threads, taken in seconds.items()}, flush=True)
    return found


if __name__ == "__main__":
    answer(sys.argv[1], int(sys.argv[2]))
