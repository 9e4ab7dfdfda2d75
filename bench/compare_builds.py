"""Two builds of libration, before and after a change: the time of every kernel and the bits of every result.

    python bench/compare_builds.py OLD_PYTHON NEW_PYTHON [--only TEXT] [--rounds 9] [--pairs 3] [--limit 1.03]

OLD_PYTHON and NEW_PYTHON are interpreters whose `libration` is to be compared. A pair is one worker process for each of
them; both are asked in turn, with the order swapped in every round, and a ratio is formed within a round. Pairs are
started anew, because the place of code and data in memory changes with the process. A line shows medians over all rounds
of all pairs. Times are CPU times on one thread. Exit status 1 if a ratio is above the limit or if a bit differs.

A case whose ratio is above the limit is measured again with three times the rounds, and the second measurement counts.
"""

import argparse
import gc
import itertools
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

SLOT = 0.012  # seconds


def worker(folder: str) -> None:
    """Answer lines `[name, repeats]` on the input: with 0 repeats save the result and answer 0, else answer the seconds of a
    call, the mean over the repeats."""
    import libration

    sys.path.append(str(Path(__file__).parent))  # last, so that nothing of bench/ hides a package
    from cases.kernels import attributes, calls

    timed, compared = calls(libration), attributes(libration)
    print(json.dumps([libration.__version__, libration.__file__, list(timed), list(compared)]), flush=True)
    gc.disable()
    for line in sys.stdin:
        name, repeats = json.loads(line)
        call = timed.get(name) or compared[name]
        if not repeats:
            result = call()
            result = result.period if "set-up" in name else result
            np.savez(f"{folder}/result.npz", *map(np.asarray, result if isinstance(result, tuple) else (result,)))
        turns = itertools.repeat(None, repeats)
        begun = time.process_time_ns()
        for _ in turns:
            call()
        taken = (time.process_time_ns() - begun) / 1e9
        gc.collect()
        print(taken / max(repeats, 1), flush=True)


def interpreter(named: str) -> str:
    """The whole path of an interpreter; links stay, because they tell Python its environment."""
    found = shutil.which(named)
    if found is None:
        raise SystemExit(f"no interpreter {named}")
    return os.path.abspath(found)


class Build:
    """A worker process of one of the two builds."""

    def __init__(self, python: str, folder: str) -> None:
        self.folder = Path(folder)
        self.folder.mkdir(exist_ok=True)
        command = [
            interpreter(python),
            "-P",
            __file__,
            "--worker",
            folder,
        ]  # -P: bench/ is not the first place of imports
        environment = {**os.environ, "LIBRATION_NUM_THREADS": "1"}
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment, cwd=folder
        )
        self.version, self.file, self.timed, self.compared = self.answer()

    def answer(self):
        """What the worker says next."""
        line = self.process.stdout.readline()
        if not line:
            raise SystemExit(f"{self.folder.name} build: the worker ended: see its message above")
        return json.loads(line)

    def seconds(self, name: str, repeats: int = 0) -> float:
        """Seconds of a call; without `repeats` its result is saved instead."""
        self.process.stdin.write(json.dumps([name, repeats]) + "\n")
        self.process.stdin.flush()
        return self.answer()

    def result(self) -> list[np.ndarray]:
        """The result saved last."""
        with np.load(self.folder / "result.npz") as held:
            return [held[name] for name in held.files]

    def close(self) -> None:
        """End the worker."""
        self.process.stdin.close()
        self.process.wait()


def difference(old: list[np.ndarray], new: list[np.ndarray]) -> str:
    """`same`, or how many values differ and by how many units in the last place at most; NaN equals NaN."""
    if [(a.dtype, a.shape) for a in old] != [(b.dtype, b.shape) for b in new]:
        return "types or shapes differ"
    count, total, worst = 0, 0, 0
    for a, b in zip(old, new, strict=True):
        if a.dtype.kind == "c":
            a, b = a.view(float), b.view(float)
        unequal = a != b
        if a.dtype.kind == "f":
            bits = [x.reshape(-1).view(np.int64).astype(object) for x in (a, b)]
            unequal = (bits[0] != bits[1]) & ~(np.isnan(a) & np.isnan(b)).reshape(-1)
            places = [np.where(x < 0, -(x + 2**63), x) for x in bits]  # ordered as the doubles are
            worst = max([worst, *abs(places[0] - places[1])[unequal]])
        count, total = count + int(np.sum(unequal)), total + a.size
    if not count:
        return "same"
    kind = f", {float(worst):.3g} ulp" if worst else ", sign of zero" if old[0].dtype.kind in "fc" else ""
    return f"{count:,} of {total:,} differ{kind}"


def measured(pair: tuple[Build, Build], name: str, rounds: int) -> list[tuple[float, float]]:
    """Seconds per call of both builds, round by round; the one that begins changes every round."""
    repeats = max(1, round(SLOT / max(min(build.seconds(name, 2) for build in pair), 1e-8)))
    found = []
    for index in range(rounds):
        order = pair if index % 2 else pair[::-1]
        taken = {id(build): build.seconds(name, repeats) for build in order}
        found.append(tuple(taken[id(build)] for build in pair))
    return found


def medians(times: list[tuple[float, float]]) -> tuple[float, float, float]:
    """Median seconds of both builds, and the median of the ratios new / old of the rounds."""
    old, new = zip(*times, strict=True)
    return statistics.median(old), statistics.median(new), statistics.median(b / a for a, b in times)


def main() -> int:
    """Print the table; 1 if a ratio is above the limit or a bit differs."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", help="interpreter of the build before")
    parser.add_argument("new", help="interpreter of the build after")
    parser.add_argument("--only", default="", help="cases whose name holds this text")
    parser.add_argument("--rounds", type=int, default=9, help="rounds of a pair of processes")
    parser.add_argument("--pairs", type=int, default=3, help="pairs of processes")
    parser.add_argument("--limit", type=float, default=1.03, help="largest ratio new / old allowed")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:

        def started() -> tuple[Build, Build]:
            return Build(options.old, f"{folder}/old"), Build(options.new, f"{folder}/new")

        def times(names: list[str], rounds: int) -> dict[str, list]:
            found = {name: [] for name in names}
            for _ in range(options.pairs if names else 0):
                pair = started()
                for name in names:
                    found[name] += measured(pair, name, rounds)
                for build in pair:
                    build.close()
            return found

        pair = started()
        for build in pair:
            print(f"{build.folder.name}: libration {build.version}, {build.file}")
        timed = [name for name in pair[0].timed if options.only in name]
        bits = {}
        for name in [*timed, *(name for name in pair[0].compared if options.only in name)]:
            for build in pair:
                build.seconds(name)
            bits[name] = difference(*(build.result() for build in pair))
        for build in pair:
            build.close()
        found = times(timed, options.rounds)
        again = [name for name in timed if medians(found[name])[2] > options.limit]
        found |= times(again, 3 * options.rounds)
    print(f"{'case':44s} {'old, µs':>10s} {'new, µs':>10s} {'new / old':>9s}  bits")
    slow = []
    for name, verdict in bits.items():
        if name not in found:
            print(f"{name:44s} {'':31s}  {verdict}")
            continue
        old, new, ratio = medians(found[name])
        slow += [name] if ratio > options.limit else []
        mark = " slower" if ratio > options.limit else ""
        print(f"{name:44s} {old * 1e6:10.3f} {new * 1e6:10.3f} {ratio:9.3f}  {verdict}{mark}")
    unequal = [name for name, verdict in bits.items() if verdict != "same"]
    ratios = [medians(held)[2] for held in found.values()] or [1.0]
    print(
        f"{len(found)} calls: median ratio {statistics.median(ratios):.3f}, largest {max(ratios):.3f}, limit {options.limit:g}"
    )
    print(f"slower than the limit: {', '.join(slow) or 'none'}")
    print(f"bits differ: {', '.join(unequal) or 'nowhere'}")
    return bool(slow or unequal)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--worker"]:
        worker(sys.argv[2])
    else:
        sys.exit(main())
