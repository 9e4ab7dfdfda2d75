"""What a run will take: memory, bytes, and seconds from a trial of some chunks, before anything is written where it will stand."""

import time
from typing import Any, NamedTuple

from ._reduce import BLOCK, histogram_cells
from ._specification import AT_TIMES, Specification
from ._store import size_bytes, trial, written

# Bytes of a process before its first chunk: a worker with NumPy and Zarr; what leads them; and with xarray for the sums.
WORKER, LEADER, LEADER_OF_SUMS = 70 * 10**6, 70 * 10**6, 150 * 10**6
# Bytes a particle: its number, place and state; a sample with what Zarr holds of it; the columns of a sum, of a block alone.
STATE, SAMPLE, SUM = 48, 24, 100
# Samples of a trial chunk, and how many are timed; the fastest counts.
TRIAL, REPEATS = 2**17, 3
# Sizes and numbers of workers of the table.
SAMPLES, WORKERS = (10**9, 10**12), (100, 10_000)


class Pace(NamedTuple):
    """Seconds of one core and bytes of the store a sample."""

    seconds: float
    bytes: float


def chunk_bytes(spec: Specification) -> int:
    """The largest memory of one chunk at work."""
    times = len(spec.times)
    samples = times if any(name in AT_TIMES for name in spec.variables) else min(1, len(spec.variables))
    particles = spec.chunk * (STATE + SAMPLE * samples)
    if spec.plan is None:
        return particles
    return particles + SUM * min(BLOCK, spec.chunk) + 3 * 8 * times * histogram_cells(spec.plan)


def memory_bytes(spec: Specification, workers: int | None) -> int:
    """The largest memory of a run by so many processes, or by this one alone."""
    leader = LEADER if spec.plan is None else LEADER_OF_SUMS
    return leader + (chunk_bytes(spec) if workers is None else workers * (WORKER + chunk_bytes(spec)))


def pace(spec: Specification, version: str) -> Pace:
    """The pace of a chunk on one core, from a trial in a temporary folder."""
    particles = min(spec.chunk, max(1, TRIAL // len(spec.times)))
    with trial(spec, version, particles) as (path, few):
        # The first one loads and opens.
        written(path, few, 0)
        taken = []
        for _ in range(REPEATS):
            # Of all threads: a worker has one, whatever this process has.
            begun = time.process_time()
            written(path, few, 0)
            taken.append(time.process_time() - begun)
    return Pace(min(taken) / few.samples, size_bytes(spec) / spec.samples)


def outlook(at: Pace, workers: int) -> list[dict[str, Any]]:
    """Larger runs of the same kind, on these workers and on more."""
    numbers = [workers, *(each for each in WORKERS if each > workers)]
    return [
        {"samples": samples, "workers": each, "seconds": samples * at.seconds / each, "bytes": samples * at.bytes}
        for samples in SAMPLES
        for each in numbers
    ]
