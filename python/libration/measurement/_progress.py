"""The steps of a fit for the bar that is shown while it takes long: the record, the step, and how many steps are left."""

import contextlib
from collections.abc import Callable, Iterator
from typing import TypeAlias

from .. import _core
from .._bar import bar

Told: TypeAlias = Callable[[str], None]
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
    with bar(len(STEPS) * len(names), wanted) as advance:
        if advance is None:
            yield None
            return
        begun, shown = 0, [short(name) for name in names]

        def told(step: str) -> None:
            nonlocal begun
            begun += step == STEPS[0]
            done = max(begun - 1, 0)
            words = f"{shown[min(done, len(shown) - 1)]}: {WORDS.get(step, step)}"
            advance(done * len(STEPS) + STEPS.index(step), words)

        yield told
