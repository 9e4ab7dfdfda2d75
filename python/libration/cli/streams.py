"""The standard streams when they are narrow, closed or full, and signals that end the command after its cleaning up."""

import contextlib
import os
import signal
import sys


class Ended(BaseException):
    """A signal asked the command to end; files half written are removed on the way out."""

    def __init__(self, number):
        super().__init__(number)
        self.code = 128 + number


@contextlib.contextmanager
def ending():
    """Turn the signals that would kill at once into `Ended`, the first of them; restore them afterwards."""

    def end(number, _frame):
        for each in caught:
            signal.signal(each, signal.SIG_IGN)
        raise Ended(number)

    caught = []
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # What is ignored, as by nohup, or handled by a caller stays so; threads have no signals (ValueError).
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
def printable():
    """Let the standard streams write `\\xe9` for what their encoding has no letter for."""
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


def occupy():
    """Put nothing in the place of closed standard streams, so that no file we open is taken for one."""
    with contextlib.suppress(OSError):
        while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
            pass
        os.close(number)


def refused(prog, reason, code=2):
    """One line on the standard error, if there is one, and the exit code."""
    if sys.stderr is not None:
        try:
            print(f"{prog}: {' '.join(reason.split())}", file=sys.stderr, flush=True)
        except (OSError, ValueError):
            drop(sys.stderr)
    return code


def drop(stream):
    """Let the interpreter's last flush of a stream go nowhere: the reader is gone, or the disk is full."""
    try:
        with open(os.devnull, "w") as nowhere:
            os.dup2(nowhere.fileno(), stream.fileno())
    except (OSError, ValueError, AttributeError):
        pass
