"""A bar on the standard error while a fit takes long: the record, the step, and how many steps are left.

rich draws it; without rich, or where nobody sees it, there is none. It comes after half a second and leaves nothing behind.
"""

import contextlib
import importlib
import sys
import threading
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

from .. import _core

Told: TypeAlias = Callable[[str], None]
# Before it, nobody waits.
DELAY = 0.5
STEPS = tuple(_core.fit_steps())
WORDS = {
    "start": "swings",
    "window": "release and stop",
    "none": "no friction",
    "linear": "linear friction",
    "quadratic": "and quadratic",
    "dry": "and dry",
    "presliding": "and presliding",
}


def short(name: str) -> str:
    """The name of a file without its folder, of 30 letters at most."""
    name = name.replace("\\", "/").rpartition("/")[2] or name
    return name if len(name) <= 30 else f"{name[:12]}...{name[-15:]}"


@contextlib.contextmanager
def told_steps(names: list[str], wanted: bool) -> Iterator[Told | None]:
    """What the core tells its steps to, or None where no bar is shown."""
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
    bar = progress.Progress(
        progress.TextColumn("{task.description}", markup=False),
        progress.BarColumn(),
        progress.TextColumn("{task.percentage:>3.0f} %"),
        progress.TimeElapsedColumn(),
        console=console.Console(file=stream),
        transient=True,
    )
    task = bar.add_task("", total=len(STEPS) * len(names))
    later = threading.Timer(DELAY, bar.start)
    later.daemon = True
    begun, shown = 0, [short(name) for name in names]

    def told(step: str) -> None:
        nonlocal begun
        begun += step == STEPS[0]
        done = max(begun - 1, 0)
        bar.update(
            task,
            completed=done * len(STEPS) + STEPS.index(step),
            description=f"{shown[min(done, len(shown) - 1)]}: {WORDS.get(step, step)}",
        )

    later.start()
    try:
        yield told
    finally:
        later.cancel()
        later.join()
        bar.stop()
