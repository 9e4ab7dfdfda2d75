"""The store of a run: a group of Zarr that any number of processes fill, chunk by chunk, and that a kill leaves whole.

A chunk of particles is one task: its states, all variables, whole chunks of Zarr written by Zarr itself, and last one byte of
`parts/done`. Zarr writes a chunk beside its place and renames it, so there is never a half of one; a kill leaves files `*.partial`
and chunks without their byte, which are written again, to the same bytes. Nothing is compressed, so no byte depends on a codec.
Sums are kept by chunk in `parts` and joined in the order of the chunks, whoever made them.
"""

import contextlib
import os
import secrets
import shutil
import warnings
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from .._arrays import NDArray
from ..pendulum import action, energy_ratio, frequency, motion
from ._reduce import Sums, histogram_cells, joined, nothing, sums_at, sums_dataset
from ._specification import AT_TIMES, OF_MOTION, Specification

# All-NaN chunks are written too: a chunk that is not there would be computed for ever.
CONFIG: Any = {"write_empty_chunks": True}
DIGEST, VERSION, CANONICAL = "libration_spec_sha256", "libration_version", "libration_spec"
# Chunks whose sums are read at a time.
WAVE = 1024
# count, two means, three products.
MOMENTS = 6
PARTS = "parts"


class Foreign(ValueError):
    """A folder that is no store of this run."""


def created(path: str, spec: Specification, version: str) -> None:
    """Makes the store without its values, or nothing at all: the folder appears at once, by renaming."""
    import zarr

    folder, name = os.path.split(path)
    beside = os.path.join(folder, f".{name}.{secrets.token_hex(6)}.part")
    attributes = {
        "Conventions": "CF-1.11",
        "title": spec.title,
        "source": f"libration {version}",
        VERSION: version,
        DIGEST: spec.digest,
        CANONICAL: spec.canonical,
    }
    try:
        root = zarr.create_group(beside, attributes=attributes)
        _arrays(root, spec)
        with warnings.catch_warnings():
            # Of one file in place of many xarray is told by itself; Zarr warns that its third format does not have it yet.
            warnings.simplefilter("ignore")
            zarr.consolidate_metadata(beside)
        os.rename(beside, path)
    except BaseException:
        shutil.rmtree(beside, ignore_errors=True)
        raise


def _arrays(root: Any, spec: Specification) -> None:
    """The arrays of a store, by name, with units."""

    def array(group: Any, name: str, shape: Any, chunks: Any, dtype: Any, fill: Any, **about: Any) -> Any:
        return group.create_array(
            name, shape=shape, chunks=chunks, dtype=dtype, fill_value=fill, compressors=None, filters=None, **about
        )

    times, words = len(spec.times), AT_TIMES | OF_MOTION
    t: Any = {"dimension_names": ["t"], "attributes": {"units": "s", "long_name": "time since the start"}}
    array(root, "t", (times,), (times,), "<f8", np.nan, config=CONFIG, **t)[:] = np.array(spec.times)
    for name in spec.variables:
        units, long_name = words[name]
        about = {"units": units, "long_name": long_name}
        more = ("t",) if name in AT_TIMES else ()
        shape, chunks = ((each, times)[: 1 + len(more)] for each in (spec.particles, spec.chunk))
        array(root, name, shape, chunks, "<f8", np.nan, dimension_names=["particle", *more], attributes=about)
    parts = root.create_group(PARTS)
    array(parts, "done", (spec.chunks,), (1,), "|u1", 0)
    if spec.plan is None:
        return
    array(parts, "moments", (spec.chunks, times, MOMENTS), (1, times, MOMENTS), "<f8", np.nan)
    cells = histogram_cells(spec.plan)
    if cells:
        array(parts, "histogram", (spec.chunks, times, cells), (1, times, cells), "<i8", 0)
    for name, each in _dataset(spec, [nothing(spec.plan)] * times).variables.items():
        if name != "t":
            # Counts are 0 and the rest NaN until every chunk is there.
            fill = 0 if each.dtype.kind == "i" else np.nan
            told: Any = {"dimension_names": list(each.dims), "attributes": dict(each.attrs)}
            made = array(root, name, each.shape, each.shape, each.dtype, fill, config=CONFIG, **told)
            if name in each.dims:
                made[...] = each.values


def _dataset(spec: Specification, sums: list[Sums]) -> Any:
    assert spec.plan is not None
    return sums_dataset(spec.plan, sums, np.array(spec.times))


def checked(path: str, spec: Specification, version: str) -> None:
    """Refuses, untouched, what is not a store of this specification and version."""
    import zarr

    try:
        attributes = dict(zarr.open_group(path, mode="r").attrs)
    except PermissionError:
        raise
    except (OSError, ValueError, KeyError):
        attributes = {}
    if DIGEST not in attributes:
        raise Foreign("is no store of libration ensemble, and stays as it is; give another name")
    if attributes.get(VERSION) != version:
        raise Foreign(f"was begun by libration {attributes.get(VERSION)}, and this is {version}; give another name")
    if attributes[DIGEST] != spec.digest:
        raise Foreign("was begun with another SPEC; give that one, or another name")


def missing(path: str, spec: Specification) -> list[int]:
    """The chunks without their byte."""
    try:
        # A byte is a file, and a listing is faster than as many readings; a chunk of Zarr is there or is not.
        there = {int(name) for name in os.listdir(os.path.join(path, PARTS, "done", "c")) if name.isdigit()}
    except FileNotFoundError:
        there = set()
    return [number for number in range(spec.chunks) if number not in there]


def swept(path: str, spec: Specification, part: tuple[int, int] = (0, 1)) -> None:
    """Removes what killed writers left: files `*.partial` of the chunks k = K mod N, for others are at work on the rest."""
    k, n = part
    for leftover in Path(path).glob("**/*.partial"):
        below = leftover.relative_to(path).parts
        place = below[below.index("c") + 1] if "c" in below else ""
        number = place.partition(".")[0]
        if n == 1 or (number.isdigit() and int(number) % n == k % n):
            leftover.unlink(missing_ok=True)
    if n == 1:
        folder, name = os.path.split(path)
        for beside in Path(folder).glob(f".{name}.*.part"):
            shutil.rmtree(beside, ignore_errors=True)


def _opened(path: str, spec: Specification) -> dict[str, Any]:
    """The arrays that chunks are written to, by name."""
    names = [*spec.variables, f"{PARTS}/done"]
    if spec.plan is not None:
        names += [f"{PARTS}/moments"] + [f"{PARTS}/histogram"] * bool(spec.plan.bins)
    return {name: _array(f"{path}/{name}", spec.digest) for name in names}


@lru_cache(maxsize=32)
def _array(path: str, _digest: str) -> Any:
    """An array to write to, opened once by a worker; a store of another specification is another array."""
    import zarr

    # What `open_array` itself is told of it counts for a new array alone.
    return zarr.open_array(path, mode="r+").with_config(CONFIG)


def written(path: str, spec: Specification, number: int) -> int:
    """One task: the states of a chunk, everything kept of them, and last its byte."""
    arrays, region = _opened(path, spec), spec.region(number)
    theta0, velocity0, omega0 = spec.states(region)
    for name, values in _variables(spec, theta0, velocity0, omega0):
        arrays[name][region] = values
    if spec.plan is not None:
        sums = [sums_at(theta0, velocity0, time, spec.plan) for time in spec.times]
        moments = [[each.particles, *each.mean, *each.products] for each in sums]
        arrays[f"{PARTS}/moments"][number : number + 1] = np.array([moments])
        if spec.plan.bins:
            arrays[f"{PARTS}/histogram"][number : number + 1] = np.array([[each.histogram for each in sums]])
    arrays[f"{PARTS}/done"][number : number + 1] = np.ones(1, dtype=np.uint8)
    return number


def _variables(spec: Specification, theta0: Any, velocity0: Any, omega0: Any) -> Iterator[tuple[str, NDArray[Any]]]:
    """The variables of a chunk, by name."""
    if any(name in AT_TIMES for name in spec.variables):
        column = omega0[:, None] if np.ndim(omega0) else omega0
        states = motion(np.array(spec.times), theta0[:, None], velocity0[:, None], column)
        yield from ((name, each) for name, each in zip(AT_TIMES, states, strict=True) if name in spec.variables)
    known = {"action": action, "frequency": frequency, "energy_ratio": energy_ratio}
    given = {"theta0": theta0, "velocity0": velocity0, "omega0": np.broadcast_to(omega0, theta0.shape)}
    for name in spec.variables:
        if name in OF_MOTION:
            yield name, given[name] if name in given else known[name](theta0, velocity0, omega0)


def finished(path: str, spec: Specification) -> bool:
    """Whether every chunk is there; if so, joins the sums in the order of the chunks."""
    if missing(path, spec):
        return False
    if spec.plan is not None:
        found = _dataset(spec, _joined(path, spec))
        for name, each in found.variables.items():
            if name not in each.dims:
                _array(f"{path}/{name}", spec.digest)[...] = each.values
    return True


def _joined(path: str, spec: Specification) -> list[Sums]:
    """The sums over all chunks, one after the other."""
    assert spec.plan is not None
    arrays, bins = _opened(path, spec), bool(spec.plan.bins)
    sums = [nothing(spec.plan) for _ in spec.times]
    for wave in range(0, spec.chunks, WAVE):
        moments = np.asarray(arrays[f"{PARTS}/moments"][wave : wave + WAVE])
        counts: Any = np.asarray(arrays[f"{PARTS}/histogram"][wave : wave + WAVE]) if bins else None
        for place, of_chunk in enumerate(moments):
            for time, row in enumerate(of_chunk):
                histogram = counts[place, time] if bins else 0
                sums[time] = joined(sums[time], Sums(int(row[0]), row[1:3], row[3:], histogram, []))
    return sums


def size_bytes(spec: Specification) -> int:
    """Bytes of the values that a run writes."""
    whole = spec.chunks * spec.chunk
    count = sum(whole * (len(spec.times) if name in AT_TIMES else 1) for name in spec.variables)
    if spec.plan is not None:
        count += spec.chunks * len(spec.times) * (MOMENTS + histogram_cells(spec.plan))
    return 8 * count + spec.chunks


@contextlib.contextmanager
def trial(spec: Specification, version: str, particles: int) -> Iterator[tuple[str, Specification]]:
    """A store of the first particles in a folder for a while, to see how long a chunk takes."""
    import tempfile

    few = spec._replace(particles=particles, chunk=particles)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "trial.zarr")
        created(path, few, version)
        yield path, few
