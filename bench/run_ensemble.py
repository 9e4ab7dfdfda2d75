"""Runs of `libration ensemble`: twenty kills at random moments, states into Zarr beside np.save, and 10**8 states summed.

    python bench/run_ensemble.py [kills] [zarr] [sums]

A kill takes the whole group of processes away at a moment drawn evenly from that when the store appears to the end of a straight run;
then one resumed run must give the bytes of the straight one. Memory is the largest sum over all processes of the proportional set
size (PSS), looked at twenty times a second; seconds of the processor are those of all of them.
"""

import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np
import psutil

COMMAND = [sys.executable, "-m", "libration", "ensemble"]
BEAM = '[states]\ndistribution = "gaussian"\nn = {n}\nseed = 1\nsigma_theta = 0.8\n'
KILLED = (
    BEAM
    + "[time]\nfrom = 0\nto = 9\ncount = 10\n[output]\nchunk = 1_000\n[reduce]\nhistogram = {{theta = [-3.2, 3.2, 64]}}\n"
)
KILLED = KILLED.replace("chunk =", 'variables = ["theta", "velocity"]\nchunk =')
STORED = BEAM + "[time]\nfrom = 0\nto = 9\ncount = 10\n[output]\nvariables = ['theta']\n"
SUMMED = BEAM + "[time]\nt = 10.0\n[reduce]\nhistogram = {{theta = [-3.2, 3.2, 128], velocity = [-2.5, 2.5, 96]}}\n"
KILLS = 20


def content(folder: Path) -> dict[str, bytes]:
    return {str(each.relative_to(folder)): each.read_bytes() for each in folder.rglob("*") if each.is_file()}


def asked(folder: Path, text: str, **numbers: int) -> str:
    path = folder / "spec.toml"
    path.write_text(text.format(**numbers))
    return str(path)


def started(spec: str, out: Path) -> tuple[subprocess.Popen[bytes], float]:
    """A run, and when its store appeared."""
    words = [*COMMAND, spec, "--out", str(out), "--json"]
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    while run.poll() is None and not out.exists():
        time.sleep(0.002)
    return run, time.perf_counter()


def kills(folder: Path) -> str:
    """Kills at random moments, each followed by a resumed run."""
    spec = asked(folder, KILLED, n=400_000)
    run, begun = started(spec, folder / "straight.zarr")
    assert run.wait() == 0
    whole = time.perf_counter() - begun
    true, chance, alike, partial, halves, left = content(folder / "straight.zarr"), random.Random(), 0, 0, 0, []
    for kill in range(KILLS):
        out = folder / f"{kill}.zarr"
        run, _ = started(spec, out)
        time.sleep(chance.uniform(0.0, whole))
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        done = len(list((out / "parts" / "done" / "c").glob("[0-9]*"))) if out.exists() else 0
        written = len(list((out / "theta" / "c").glob("*/0"))) if out.exists() else 0
        partial += len(list(out.rglob("*.partial")))
        halves += written - done
        left.append(done)
        subprocess.run([*COMMAND, spec, "--out", str(out), "--resume", "--json"], check=True, capture_output=True)
        alike += content(out) == true
        shutil.rmtree(out)
    return (
        f"{KILLS} kills within {whole:.1f} s: {alike} resumed to the same bytes; they left {partial} files *.partial and {halves}"
        f" chunks without their byte; of 400 chunks were done {sorted(left)}"
    )


def watched(words: list[str]) -> tuple[float, float, float]:
    """Seconds, seconds of the processor, and the largest memory in bytes of a command with its processes."""
    before, begun, largest, over = (
        resource.getrusage(resource.RUSAGE_CHILDREN),
        time.perf_counter(),
        0.0,
        threading.Event(),
    )
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL)

    def watch() -> None:
        nonlocal largest
        while not over.wait(0.05):
            total = 0.0
            for each in [psutil.Process(run.pid), *psutil.Process(run.pid).children(recursive=True)]:
                try:
                    total += each.memory_full_info().pss
                except psutil.Error:
                    continue
            largest = max(largest, total)

    watcher = threading.Thread(target=watch, daemon=True)
    watcher.start()
    assert run.wait() == 0
    over.set()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return time.perf_counter() - begun, processor, largest


def stored(folder: Path) -> str:
    """10**7 particles at ten times by Zarr's chunks, and the same bytes by np.save, one after the other."""
    from libration.ensemble import _store
    from libration.ensemble._specification import specification

    spec = specification(STORED.format(n=10**7))
    states = np.random.default_rng(1).normal(size=(spec.chunk, 10))
    whole = np.concatenate([states] * spec.chunks)[: spec.particles]
    taken: dict[str, list[tuple[float, float]]] = {"zarr": [], "np.save": []}
    for turn in range(7):
        path = str(folder / f"stored{turn}.zarr")
        _store.created(path, spec, "bench")
        arrays = _store._opened(path, spec)
        one, mark = np.ones(1, dtype=np.uint8), arrays["parts/done"]
        for name in taken:
            begun, processor = time.perf_counter(), time.process_time()
            if name == "zarr":
                for number in range(spec.chunks):
                    region = spec.region(number)
                    arrays["theta"][region] = whole[region]
                    mark[number : number + 1] = one
            else:
                np.save(folder / "stored.npy", whole)
            taken[name].append((time.perf_counter() - begun, time.process_time() - processor))
        shutil.rmtree(path)
        (folder / "stored.npy").unlink()
    medians = {name: np.median(each, axis=0) for name, each in taken.items()}
    ratio = medians["zarr"] / medians["np.save"]
    return (
        f"10**7 x 10 ({whole.nbytes / 1e6:.0f} MB) in {spec.chunks} chunks: zarr {medians['zarr'][0]:.2f} s, np.save"
        f" {medians['np.save'][0]:.2f} s, ratio {ratio[0]:.2f}; of the processor {medians['zarr'][1]:.2f} s and"
        f" {medians['np.save'][1]:.2f} s, ratio {ratio[1]:.2f}"
    )


def summed(folder: Path) -> str:
    """10**8 states summed by two workers."""
    spec = asked(folder, SUMMED, n=10**8)
    seconds, processor, largest = watched([*COMMAND, spec, "--out", str(folder / "sums.zarr"), "--workers", "2"])
    return (
        f"10**8 states summed by two workers: {seconds:.1f} s, {processor:.1f} s of the processor ({processor * 10:.0f} ns a state),"
        f" {largest / 1e6:.0f} MB over all processes"
    )


if __name__ == "__main__":
    parts = {"kills": kills, "zarr": stored, "sums": summed}
    for part in sys.argv[1:] or parts:
        with tempfile.TemporaryDirectory() as place:
            print(parts[part](Path(place)), flush=True)
