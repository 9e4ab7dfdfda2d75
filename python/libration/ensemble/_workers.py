"""Who writes the chunks of a store: this process, processes of this machine, or the workers of a scheduler of Dask.

Each gives the numbers of chunks as they are done, and ends its work where its generator is closed. A worker has one chunk at a time,
so memory is bounded by workers times chunks. It ends by itself as soon as the process that began it is gone, whatever ended that:
nobody writes to a store after its run.
"""

import contextlib
import importlib
import os
import signal
import threading
from collections.abc import Generator, Iterator, Sequence
from concurrent.futures import CancelledError
from itertools import islice
from multiprocessing import connection, get_context, parent_process, resource_tracker
from typing import Any

from .. import _core
from ._specification import Specification
from ._store import written

# Threads of the numerical libraries of a worker: as many workers as cores share them. And for the memory of glibc: columns of a chunk
# are taken from what the last chunk gave back, in place of new pages from the system, which take more than a quarter of the time.
ENVIRONMENT = {
    "LIBRATION_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "MALLOC_MMAP_THRESHOLD_": str(2**25),
    "MALLOC_TRIM_THRESHOLD_": str(2**29),
}
# Chunks that wait at a thread of a scheduler's worker, so that it is never idle.
WAITING = 2
ANSWER = "10s"


class LostWorker(Exception):
    """A worker ended before its chunk was done, or a scheduler does not answer."""


def by_this_process(path: str, spec: Specification, numbers: Sequence[int]) -> Generator[int, None, None]:
    """One chunk after the other, here."""
    for number in numbers:
        yield written(path, spec, number)


def by_processes(path: str, spec: Specification, numbers: Sequence[int], workers: int) -> Generator[int, None, None]:
    """By processes of this machine, each with a chunk at a time."""
    pipes: dict[Any, Any] = {}
    left = iter(numbers)
    try:
        with _inherited():
            for _ in range(min(workers, len(numbers))):
                here, there = get_context("spawn").Pipe()
                process = get_context("spawn").Process(target=_worker, args=(there, path, spec), daemon=True)
                process.start()
                there.close()
                pipes[here] = process
        for here in pipes:
            _asked(here, next(left))
        for _ in numbers:
            number, here = _answer(pipes)
            following = next(left, None)
            if following is not None:
                _asked(here, following)
            yield number
    finally:
        # What a worker leaves in the middle of a chunk is written again.
        for process in pipes.values():
            process.kill()
        for here, process in pipes.items():
            process.join()
            here.close()


def _asked(here: Any, number: int) -> None:
    """Gives a worker its next chunk; that it is gone, its pipe tells as the next answer."""
    with contextlib.suppress(BrokenPipeError, ConnectionResetError):
        here.send(number)


def _answer(pipes: dict[Any, Any]) -> tuple[int, Any]:
    """The next chunk that is done, and the pipe of its worker."""
    here: Any = connection.wait(list(pipes))[0]
    try:
        found = here.recv()
    except (EOFError, ConnectionResetError):
        pipes[here].join()
        code = pipes[here].exitcode
        how = f"killed by signal {-code}" if code < 0 else f"ended with code {code}"
        raise LostWorker(f"a worker was lost, {how}") from None
    if isinstance(found, BaseException):
        raise found
    return found, here


@contextlib.contextmanager
def _inherited() -> Iterator[None]:
    """What processes that begin inside have from the start: one thread each, and no interest in Ctrl-C, which is for us."""
    if os.name == "posix":
        # Elsewhere there is none. It unblocks the signal as it begins, so it comes first.
        resource_tracker.ensure_running()
    before = {name: os.environ.get(name) for name in ENVIRONMENT}
    os.environ.update(ENVIRONMENT)
    # Blocked, and not ignored: a Ctrl-C of this moment still reaches us.
    mask = getattr(signal, "pthread_sigmask", None)
    old = mask(signal.SIG_BLOCK, {signal.SIGINT}) if mask else set()
    try:
        yield
    finally:
        for name, value in before.items():
            os.environ.pop(name) if value is None else os.environ.update({name: value})
        if mask:
            mask(signal.SIG_SETMASK, old)


def _worker(pipe: Any, path: str, spec: Specification) -> None:
    """A process: chunks by number, until nobody asks."""
    with contextlib.suppress(ValueError, OSError):
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_attendance, daemon=True).start()
    with contextlib.suppress(EOFError, OSError):
        while True:
            number = pipe.recv()
            try:
                pipe.send(written(path, spec, number))
            except Exception as error:
                pipe.send(_plain(error))


def _attendance() -> None:
    """Ends this process at once when that which began it is gone."""
    began = parent_process()
    if began is not None:
        connection.wait([began.sentinel])
        os._exit(1)


def _plain(error: Exception) -> Exception:
    """An error that can be sent."""
    if isinstance(error, OSError):
        return OSError(error.errno, error.strerror or str(error))
    return MemoryError() if isinstance(error, MemoryError) else RuntimeError(repr(error))


@contextlib.contextmanager
def connected(address: str) -> Iterator[Any]:
    """A client of a scheduler of Dask, whose workers have this library, and one thread of it each."""
    import logging

    distributed: Any = importlib.import_module("distributed")
    quiet = logging.getLogger("distributed")
    level = quiet.level
    quiet.setLevel(logging.CRITICAL)
    client: Any = None
    try:
        try:
            client = distributed.Client(address, timeout=ANSWER, set_as_default=False)
        except (OSError, ValueError, TypeError) as error:
            raise LostWorker("no scheduler of Dask answers there") from error
        if not client.nthreads():
            raise LostWorker("the scheduler has no workers")
        # A variable of the environment is read when the library is loaded; this sets it for C and Rust.
        client.run(os.putenv, "LIBRATION_NUM_THREADS", "1")
        _same_version(client)
        yield client
    finally:
        if client is not None:
            with contextlib.suppress(Exception):
                client.close(timeout=2)
        quiet.setLevel(level)


def by_scheduler(path: str, spec: Specification, numbers: Sequence[int], client: Any) -> Generator[int, None, None]:
    """By the workers of a scheduler of Dask."""
    distributed: Any = importlib.import_module("distributed")
    left, done = iter(numbers), distributed.as_completed(loop=client.loop)
    futures: set[Any] = set()
    try:
        for number in islice(left, WAITING * sum(client.nthreads().values())):
            _submitted(client, done, futures, path, spec, number)
        for future in done:
            futures.discard(future)
            number = future.result()
            following = next(left, None)
            if following is not None:
                _submitted(client, done, futures, path, spec, following)
            yield number
    except (distributed.KilledWorker, CancelledError) as error:
        raise LostWorker("a worker was lost, or the scheduler") from error
    finally:
        with contextlib.suppress(Exception):
            client.cancel(list(futures), force=True)


def _same_version(client: Any) -> None:
    """Refuses workers whose library may have other digits."""
    try:
        versions = client.run(version)
    except Exception as error:
        raise LostWorker(f"a worker cannot load libration, {error!r}") from error
    for worker, other in versions.items():
        if other != version():
            raise LostWorker(f"the worker {worker} has libration {other}, and this is {version()}")


def version() -> str:
    """That of the library, where it is called."""
    return str(_core.__version__)


def _submitted(client: Any, done: Any, futures: set[Any], path: str, spec: Specification, number: int) -> None:
    """Gives one chunk to the scheduler."""
    future = client.submit(written, path, spec, number, key=f"libration-{spec.digest[:16]}-{number}", pure=False)
    futures.add(future)
    done.add(future)
