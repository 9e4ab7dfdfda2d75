"""The standard streams when their encoding lacks letters, or they are closed or full; signals that end the command."""

import contextlib
import os
import signal
import sys
from collections.abc import Iterator
from types import FrameType
from typing import NoReturn, TextIO

from libration.cli.language import Told, told


class Ended(BaseException):
    """A signal asked the command to end; unfinished files are removed before it does."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.code = 128 + number


@contextlib.contextmanager
def ending() -> Iterator[None]:
    """Raise `Ended` for the first signal that would end the process at once; restore the handlers afterwards."""

    def end(number: int, _frame: FrameType | None) -> NoReturn:
        for each in caught:
            signal.signal(each, signal.SIG_IGN)
        raise Ended(number)

    caught: list[signal.Signals] = []
    for name in ("SIGTERM", "SIGHUP"):
        number: signal.Signals | None = getattr(signal, name, None)
        # A signal that is ignored, as by nohup, or handled by the caller stays so; only the main thread may set handlers.
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            with contextlib.suppress(ValueError):
                signal.signal(number, end)
                caught.append(number)
    try:
        yield
    finally:
        for number in caught:
            signal.signal(number, signal.SIG_DFL)


@contextlib.contextmanager
def printable() -> Iterator[None]:
    """Let the standard streams write `\\xe9` for a letter that their encoding lacks."""
    occupy()
    streams = [(each, each.errors) for each in (sys.stdout, sys.stderr) if hasattr(each, "reconfigure")]
    for stream, _ in streams:
        with contextlib.suppress(OSError, ValueError):
            stream.reconfigure(errors="backslashreplace")
    try:
        yield
    finally:
        for stream, errors in streams:
            with contextlib.suppress(OSError, ValueError):
                stream.reconfigure(errors=errors)


def occupy() -> None:
    """Open the null device for each closed standard stream, so that no file opened later takes its number."""
    with contextlib.suppress(OSError):
        while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
            pass
        os.close(number)


def refused(prog: str, reason: str, code: int = 2) -> int:
    """One line on the standard error, if there is one, and the exit code."""
    note(reason, prog)
    return code


def note(text: str, prog: str = "libration") -> None:
    """One line on the standard error, if there is one."""
    said = text if isinstance(text, Told) else told(" ".join(text.split()))
    if sys.stderr is not None:
        try:
            print(f"{prog}: {' '.join(said.split())}", file=sys.stderr, flush=True)
        except (OSError, ValueError):
            drop(sys.stderr)


def drop(stream: TextIO) -> None:
    """Send the interpreter's last flush of a stream to the null device: the reader is gone, or the disk is full."""
    try:
        with open(os.devnull, "w") as null:
            os.dup2(null.fileno(), stream.fileno())
    except (OSError, ValueError, AttributeError):
        pass
