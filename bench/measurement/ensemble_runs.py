"""Whole runs of `libration ensemble`: states into Zarr beside np.save, 10**8 states summed, and kills at random moments.

Memory is the largest sum over all processes of the proportional set size (PSS), looked at twenty times a second; seconds of the
processor are those of all of them.
"""

import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import psutil

COMMAND = [sys.executable, "-m", "libration", "ensemble"]
BEAM = '[states]\ndistribution = "gaussian"\nn = {n}\nseed = 1\nsigma_theta = 0.8\n'
TEN_TIMES = BEAM + "[time]\nfrom = 0\nto = 9\ncount = 10\n[output]\n"
KILLED = (
    TEN_TIMES + "variables = ['theta', 'velocity']\nchunk = 1_000\n[reduce]\nhistogram = {{theta = [-3.2, 3.2, 64]}}\n"
)
STORED = TEN_TIMES + "variables = ['theta']\n"
SUMMED = BEAM + "[time]\nt = 10.0\n[reduce]\nhistogram = {{theta = [-3.2, 3.2, 128], velocity = [-2.5, 2.5, 96]}}\n"
KILLS = 20


def content(folder: Path) -> dict[str, bytes]:
    """Every file with its bytes."""
    return {str(each.relative_to(folder)): each.read_bytes() for each in folder.rglob("*") if each.is_file()}


def asked(folder: Path, text: str, n: int) -> str:
    """The path of a SPEC."""
    path = folder / "spec.toml"
    path.write_text(text.format(n=n))
    return str(path)


def started(spec: str, out: Path) -> tuple[subprocess.Popen[bytes], float]:
    """A run, and when its store appeared."""
    words = [*COMMAND, spec, "--out", str(out), "--json"]
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    while run.poll() is None and not out.exists():
        time.sleep(0.002)
    return run, time.perf_counter()


def killed(folder: Path) -> dict:
    """Kills of all processes at moments drawn evenly from the length of a straight run, each followed by a resumed run."""
    spec = asked(folder, KILLED, 400_000)
    run, begun = started(spec, folder / "straight.zarr")
    assert run.wait() == 0
    whole = time.perf_counter() - begun
    true, chance = content(folder / "straight.zarr"), random.Random()
    found = {"kills": KILLS, "seconds": whole, "alike": 0, "partial": 0, "without a byte": 0, "done": []}
    for kill in range(KILLS):
        out = folder / f"{kill}.zarr"
        run, _ = started(spec, out)
        time.sleep(chance.uniform(0.0, whole))
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        done = len(list((out / "parts" / "done" / "c").glob("[0-9]*"))) if out.exists() else 0
        written = len(list((out / "theta" / "c").glob("*/0"))) if out.exists() else 0
        found["partial"] += len(list(out.rglob("*.partial")))
        found["without a byte"] += written - done
        found["done"].append(done)
        subprocess.run([*COMMAND, spec, "--out", str(out), "--resume", "--json"], check=True, capture_output=True)
        found["alike"] += content(out) == true
        shutil.rmtree(out)
    return found


def watched(words: list[str]) -> dict:
    """Seconds, seconds of the processor, and the largest memory in bytes of a command with its processes."""
    before, begun, over = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter(), threading.Event()
    run, largest = subprocess.Popen(words, stdout=subprocess.DEVNULL), [0.0]

    def watch() -> None:
        while not over.wait(0.05):
            total = 0.0
            try:
                for each in [psutil.Process(run.pid), *psutil.Process(run.pid).children(recursive=True)]:
                    total += each.memory_full_info().pss
            except psutil.Error:
                continue
            largest[0] = max(largest[0], total)

    watcher = threading.Thread(target=watch, daemon=True)
    watcher.start()
    assert run.wait() == 0
    over.set()
    watcher.join()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"seconds": time.perf_counter() - begun, "processor": processor, "memory": largest[0]}


def summed(folder: Path, n: int = 10**8) -> dict:
    """States summed by two workers, in place of kept."""
    spec = asked(folder, SUMMED, n)
    words = [*COMMAND, spec, "--out", str(folder / "sums.zarr"), "--workers", "2"]
    return {"states": n, **watched(words)}


def stored(folder: Path, n: int = 10**7, turns: int = 7) -> dict:
    """Particles at ten times by Zarr's chunks, and the same bytes by np.save, one after the other."""
    from libration.ensemble import _store
    from libration.ensemble._specification import specification

    spec = specification(STORED.format(n=n))
    states = np.random.default_rng(1).normal(size=(spec.chunk, 10))
    whole = np.concatenate([states] * spec.chunks)[: spec.particles]
    taken: dict[str, list[list[float]]] = {"zarr": [], "np.save": []}
    for turn in range(turns):
        path = str(folder / f"stored{turn}.zarr")
        _store.created(path, spec, "bench")
        arrays = _store._opened(path, spec)
        one, mark = np.ones(1, dtype=np.uint8), arrays["parts/done"]
        for name, held in taken.items():
            begun, processor = time.perf_counter(), time.process_time()
            if name == "zarr":
                for number in range(spec.chunks):
                    region = spec.region(number)
                    arrays["theta"][region] = whole[region]
                    mark[number : number + 1] = one
            else:
                np.save(folder / "stored.npy", whole)
            held.append([time.perf_counter() - begun, time.process_time() - processor])
        shutil.rmtree(path)
        (folder / "stored.npy").unlink()
    return {"bytes": whole.nbytes, "chunks": spec.chunks, **taken}
