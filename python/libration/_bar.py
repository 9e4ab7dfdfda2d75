"""A bar on the standard error while something takes long: what is done, how much of it, and for how long.

rich draws it; without rich, or where nobody sees it, there is none. It comes after half a second and leaves nothing behind.
"""

import contextlib
import importlib
import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

# How much is done, and in words what is done now.
Advance: TypeAlias = Callable[[int, str], None]
# Before it, nobody waits.
DELAY = 0.5


@contextlib.contextmanager
def bar(total: int, wanted: bool) -> Iterator[Advance | None]:
    """What is told how much of `total` is done, or None where no bar is shown."""
    stream = sys.stderr
    if not wanted or stream is None or not stream.isatty():
        yield None
        return
    try:
        progress: Any = importlib.import_module("rich.progress")
        console: Any = importlib.import_module("rich.console")
    except ModuleNotFoundError:
        yield None
        return
    shown = progress.Progress(
        progress.TextColumn("{task.description}", markup=False),
        progress.BarColumn(),
        progress.TextColumn("{task.percentage:>3.0f} %"),
        progress.TimeElapsedColumn(),
        console=console.Console(file=stream),
        transient=True,
    )
    task = shown.add_task("", total=total)
    later = threading.Timer(DELAY, shown.start)
    later.daemon = True

    def advance(done: int, words: str) -> None:
        shown.update(task, completed=done, description=words)

    later.start()
    try:
        yield advance
    finally:
        later.cancel()
        later.join()
        shown.stop()
