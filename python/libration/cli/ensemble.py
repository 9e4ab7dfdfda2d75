"""`libration ensemble`: an ensemble of any size into a store of Zarr, by any number of processes, that goes on after any end.

The SPEC is checked whole, and memory and room are compared with what there is, before anything is written.
"""

import contextlib
import os
import shutil
import tempfile
import time
from collections.abc import Generator, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from libration.cli.files import Json, strict
from libration.cli.help import Topic
from libration.cli.language import say, told
from libration.cli.memory import available_bytes, bytes_text, duration
from libration.cli.offers import files, folders
from libration.cli.parser import Flag, Options, Refusal, Value, Word, command, refusal, shown
from libration.cli.streams import Ended, note
from libration.cli.summary import print_lines, print_table

if TYPE_CHECKING:
    from libration.ensemble._specification import Specification

DESCRIPTION = """\
Makes an ensemble of pendulums as SPEC.toml says, moves it to every time in one exact step, and keeps states, sums and
histograms in a store of Zarr, which xarray opens. After any end, a kill too, --resume goes on, to the same bytes; one
process, many, or the parts of a job array give the same bytes."""

TOPICS = (
    Topic(
        "the SPEC",
        (
            ("title", "a text"),
            (
                "[states]",
                "distribution, n, seed and a width, as of libration.ensemble.bunch; or theta0, velocity0, omega0",
            ),
            ("[time]", "t, a list; or from, to and count"),
            ("[output]", "variables (theta, velocity, action ...) and chunk, particles at a time"),
            ("[reduce]", "moments (0 to 2), and histogram, by quantity [low, high, bins]"),
        ),
        "docs/ensembles.md describes every key, and examples/ has files to begin with.",
    ),
    Topic(
        "parts of a job array",
        text="""\
--part K/N does the chunks K, K + N, K + 2N and so on in this process, K from 1 to N. The parts fill one store, which the
first makes; the last to end joins the sums. With --resume each goes on where it was.
""",
    ),
)
EXAMPLES = (
    "libration ensemble bunch.toml --dry-run",
    "libration ensemble bunch.toml --out run.zarr --resume",
    "libration ensemble bunch.toml --out run.zarr --part 3/50 --resume",
    "libration ensemble bunch.toml --out run.zarr --scheduler tcp://node1:8786",
)
SUFFIX = ".zarr"
MOST_WORKERS = 4096


class EnsembleOptions(Options):
    """The options of `libration ensemble`, as typed."""

    spec: str | None
    out: str | None
    resume: bool
    scheduler: str | None
    part: str | None
    workers: str | None
    dry_run: bool
    json: bool


class Hands(NamedTuple):
    """Who does which chunks: processes of this machine, a part in this process, or a scheduler."""

    workers: int | None
    part: tuple[int, int] | None
    scheduler: str | None

    @property
    def words(self) -> str:
        """For people."""
        if self.scheduler is not None:
            return f"the workers of {self.scheduler}"
        if self.workers is None:
            k, n = self.part or (1, 1)
            return f"part {k} of {n}, in this process"
        return "1 process" if self.workers == 1 else f"{self.workers} processes"


def run(options: EnsembleOptions) -> None:
    """Check what the words and the SPEC ask for; write the store, or say what it would take."""
    hands = who(options)
    spec = specified(options.spec)
    needed(spec, hands)
    if options.dry_run:
        return foreseen(spec, hands, options)
    if options.out is None:
        raise Refusal("missing --out, such as --out run.zarr; --dry-run works without")
    path = target(options.out)
    memory = bounded(spec, hands)
    with scheduler(hands) as client:
        numbers = begun(path, spec, options, hands)
        if not options.json:
            print_lines(asked(spec, hands, memory))
            print(end="", flush=True)
        start = time.monotonic()
        complete = done(path, spec, numbers, hands, client, str(options.out))
        seconds = time.monotonic() - start
    answer: dict[str, Json] = {"out": options.out, "chunks": spec.chunks, "chunks_written": len(numbers)}
    answer |= {"complete": complete, "seconds": seconds, **sizes(spec), "memory_bytes": memory}
    if options.json:
        print(strict(answer))
        return
    words = told(f"{len(numbers)} of {spec.chunks} chunks in {duration(seconds)}")
    rest = "" if complete else told(f"; {of_chunks(path, spec)} are there, the rest is for the other parts")
    print_lines([("done", words + rest), ("written", options.out)])


@contextlib.contextmanager
def scheduler(hands: Hands) -> Iterator[Any]:
    """The client of the scheduler that is asked for, if one is."""
    if hands.scheduler is None:
        yield None
        return
    from libration.ensemble._workers import LostWorker, connected

    try:
        with connected(hands.scheduler) as client:
            yield client
    except LostWorker as error:
        raise refusal("--scheduler", hands.scheduler, str(error)) from error


def who(options: EnsembleOptions) -> Hands:
    """The hands that are asked for."""
    given = {"--scheduler": options.scheduler, "--part": options.part, "--workers": options.workers}
    names = [name for name, value in given.items() if value is not None]
    if len(names) > 1 and not (options.dry_run and names == ["--scheduler", "--workers"]):
        raise Refusal(f"{names[0]} and {names[1]}: give one of the two")
    if options.part is not None:
        k, slash, n = options.part.partition("/")
        if not slash or not whole(k) or not whole(n) or not 1 <= int(k) <= int(n):
            raise refusal("--part", options.part, "must be K/N, whole numbers with K from 1 to N, such as 3/50")
        return Hands(None, (int(k), int(n)), None)
    if options.workers is not None and not (whole(options.workers) and 1 <= int(options.workers) <= MOST_WORKERS):
        raise refusal("--workers", options.workers, f"must be a whole number from 1 to {MOST_WORKERS}")
    return Hands(int(options.workers) if options.workers else cores(), None, options.scheduler)


def whole(text: str) -> bool:
    """Whether a text is a whole number that is not too long."""
    return text.isascii() and text.isdigit() and len(text) <= 9


def cores() -> int:
    """The cores of this process."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def specified(path: str | None) -> "Specification":
    """The specification of a file."""
    if path is None:
        raise Refusal("missing SPEC.toml: what the ensemble is, such as bunch.toml; see libration ensemble --help")
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except (OSError, ValueError) as error:
        reason = "is no text in UTF-8" if isinstance(error, UnicodeError) else getattr(error, "strerror", None) or error
        raise Refusal(f"{shown(path)}: cannot be read: {reason}") from error
    from libration.ensemble._specification import specification

    try:
        return specification(text)
    except (ValueError, ImportError) as error:
        raise Refusal(f"{shown(path)}: {error}") from error


def needed(spec: "Specification", hands: Hands) -> None:
    """Refuse what is asked for without the packages that it takes."""
    from libration.ensemble._sweep import needs

    wanted = ["zarr", *["xarray"] * (spec.plan is not None), *["distributed"] * (hands.scheduler is not None)]
    try:
        for package in wanted:
            needs(package, "libration ensemble")
    except ImportError as error:
        raise Refusal(str(error).partition(": ")[2]) from error


def target(out: str) -> str:
    """The path of the store."""
    if not out.rstrip(os.sep + (os.altsep or "")).lower().endswith(SUFFIX) or "\0" in out:
        raise refusal("--out", out, f"must end in {SUFFIX}")
    path = os.path.realpath(out)
    if not os.path.isdir(os.path.dirname(path)):
        raise refusal("--out", out, f"cannot be written: there is no directory {os.path.dirname(path)}")
    return path


def begun(path: str, spec: "Specification", options: EnsembleOptions, hands: Hands) -> list[int]:
    """Make the store or find it as it was left; the chunks that are to be done."""
    from libration import __version__
    from libration.ensemble import _store

    out, mine = str(options.out), False
    try:
        if not os.path.lexists(path):
            room(path, spec, out)
            try:
                _store.created(path, spec, __version__)
                mine = True
            except OSError:
                # Two may begin at once: the one that comes second finds the store of the first.
                if not os.path.isdir(path):
                    raise
        if not mine and not options.resume and hands.part is None:
            raise refusal("--out", out, "exists already; --resume goes on with it, or give another name")
        _store.checked(path, spec, __version__)
        if options.resume:
            _store.swept(path, spec, hands.part or (0, 1))
        k, n = hands.part or (0, 1)
        return [number for number in _store.missing(path, spec) if number % n == k % n]
    except _store.Foreign as error:
        raise refusal("--out", out, str(error)) from error
    except OSError as error:
        raise refusal("--out", out, f"cannot be written: {error.strerror or error}") from error


def room(path: str, spec: "Specification", out: str) -> None:
    """Refuse a store that the disk has no room for."""
    from libration.ensemble._store import size_bytes

    free, wanted = shutil.disk_usage(os.path.dirname(path)).free, size_bytes(spec)
    if wanted > free:
        raise refusal("--out", out, f"needs {bytes_text(wanted)}, and {bytes_text(free)} are free there")


def bounded(spec: "Specification", hands: Hands) -> int:
    """The memory that a run may take; refused if there is not so much."""
    from libration.ensemble._estimate import memory_bytes

    # Those of a scheduler are on other machines.
    memory, available = memory_bytes(spec, 0 if hands.scheduler else hands.workers), available_bytes()
    if memory > available:
        by = told("a smaller [output] chunk") + told(" or fewer --workers") * (hands.workers is not None)
        raise Refusal(
            f"needs up to {bytes_text(memory)} of memory, and {bytes_text(available)} are available; give {by}"
        )
    return memory


def done(path: str, spec: "Specification", numbers: list[int], hands: Hands, client: Any, out: str) -> bool:
    """Do the chunks, then join the sums; whether the store is complete."""
    from libration._bar import bar
    from libration.ensemble import _store, _workers

    work: Generator[int, None, None]
    if client is not None:
        work = _workers.by_scheduler(path, spec, numbers, client)
    elif hands.workers is None:
        work = _workers.by_this_process(path, spec, numbers)
    else:
        work = _workers.by_processes(path, spec, numbers, hands.workers)
    try:
        with bar(len(numbers), True) as advance, contextlib.closing(work):
            for count, _ in enumerate(work, 1):
                if advance is not None:
                    advance(count, told(f"chunk {count} of {len(numbers)}"))
        return _store.finished(path, spec)
    except BaseException as error:
        # The workers are gone, and with them who would rename what they began; but another run may be at work.
        if not isinstance(error, FileNotFoundError):
            with contextlib.suppress(OSError):
                _store.swept(path, spec, hands.part or (0, 1))
        reason = ended(error, hands, out)
        if reason is None:
            raise
        far = f"{reason}; {of_chunks(path, spec)} are done, and --resume goes on"
        if isinstance(error, KeyboardInterrupt | Ended):
            note(far, "libration ensemble")
            raise
        raise Refusal(far) from error


def ended(error: BaseException, hands: Hands, out: str) -> str | None:
    """Why the work came to an end, for people; None for what is no matter of the work."""
    from libration.ensemble._workers import LostWorker

    if isinstance(error, KeyboardInterrupt | Ended):
        return "interrupted" if isinstance(error, KeyboardInterrupt) else "asked to end"
    if isinstance(error, LostWorker):
        return f"--scheduler = {hands.scheduler}: {error}" if hands.scheduler else str(error)
    if isinstance(error, MemoryError):
        return "not enough memory; give fewer --workers, or begin again with a smaller [output] chunk"
    if isinstance(error, FileNotFoundError):
        return (
            f"--out = {shown(out)}: what was being written was taken away; is another run at work on the same chunks?"
        )
    if isinstance(error, OSError):
        return f"--out = {shown(out)}: cannot be written: {error.strerror or error}"
    return None


def of_chunks(path: str, spec: "Specification") -> str:
    """How far a store is."""
    from libration.ensemble._store import missing

    return f"{spec.chunks - len(missing(path, spec))} of {spec.chunks} chunks"


def sizes(spec: "Specification") -> dict[str, Json]:
    """Numbers of a run."""
    from libration.ensemble._store import size_bytes

    return {
        "particles": spec.particles,
        "times": len(spec.times),
        "samples": spec.samples,
        "bytes": size_bytes(spec),
        "chunk_particles": spec.chunk,
    }


def asked(spec: "Specification", hands: Hands, memory: int) -> list[tuple[str, str]]:
    """What will be done, for people."""
    from libration.ensemble import _estimate, _store

    each = f"{bytes_text(_estimate.chunk_bytes(spec))} a chunk at work"
    times = len(spec.times)
    return [
        ("samples", f"{spec.samples}: {spec.particles} particles at {times} {told('time' if times == 1 else 'times')}"),
        ("store", f"{bytes_text(_store.size_bytes(spec))} in {spec.chunks} chunks of {spec.chunk} particles"),
        ("work", hands.words),
        (
            "memory",
            told(f"up to {bytes_text(memory)} here, {each}") + told(" on each thread there") * bool(hands.scheduler),
        ),
    ]


def foreseen(spec: "Specification", hands: Hands, options: EnsembleOptions) -> None:
    """Print what a run would take."""
    from libration import __version__
    from libration.ensemble._estimate import chunk_bytes, memory_bytes, outlook, pace

    if options.out is not None:
        target(options.out)
    memory = memory_bytes(spec, 0 if hands.scheduler else hands.workers)
    workers = hands.part[1] if hands.part else hands.workers or 1
    try:
        at = pace(spec, __version__)
    except OSError as error:
        raise Refusal(f"the trial in {tempfile.gettempdir()}: cannot be written: {error.strerror or error}") from error
    seconds, table = spec.samples * at.seconds / workers, outlook(at, workers)
    if options.json:
        answer: dict[str, Any] = {**sizes(spec), "chunks": spec.chunks, "workers": workers, "memory_bytes": memory}
        answer |= {"chunk_memory_bytes": chunk_bytes(spec), "seconds": seconds, "seconds_per_sample": at.seconds}
        print(strict(answer | {"outlook": table}))
        return
    took = f"{duration(seconds)} on {workers} {told('worker' if workers == 1 else 'workers')}, {at.seconds * 1e9:.0f} ns a sample of one core"
    print_lines([*asked(spec, hands, memory), ("time", took)])
    say("\nlarger runs of this kind, if disks keep up")
    rows = [
        [
            f"{each['samples']:.0e}".replace("e+", "e"),
            str(each["workers"]),
            duration(each["seconds"]),
            bytes_text(each["bytes"]),
        ]
        for each in table
    ]
    print_table(["samples", "workers", "time", "store"], rows)


WORK, RESULTS = "the work", "the results"
COMMAND = command(
    "ensemble",
    DESCRIPTION,
    run,
    EnsembleOptions,
    short="millions and billions of pendulums into a store of Zarr, by any number of processes",
    parameters=[
        Word("spec", "SPEC.toml", "what the ensemble is: see below (required)", WORK, offered=files),
        Value("--workers", "N", "processes of this machine (default: one a core)", WORK),
        Value("--part", "K/N", "the part K of N of a job array, in this process", WORK),
        Value("--scheduler", "ADDRESS", "a scheduler of Dask, tcp://host:8786, whose workers reach --out", WORK),
        Value("--out", "FOLDER", "write the store to a .zarr folder", RESULTS, offered=folders),
        Flag("--resume", "go on with a store that is not complete, or begin it", RESULTS),
        Flag("--dry-run", "print memory, bytes and seconds after a short trial, and write nothing", RESULTS),
        Flag("--json", "print one JSON object", RESULTS),
    ],
    usage=["libration ensemble", "SPEC.toml", "--out FOLDER", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
