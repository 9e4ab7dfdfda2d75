"""The three papers by name."""

import difflib

WORKS = ("salas", "lima", "horsley")


def chosen(work: str | None) -> tuple[str, ...]:
    """The paper of that name, all three without one, or a ValueError that names the nearest first."""
    if work is None:
        return WORKS
    if work not in WORKS:
        near = difflib.get_close_matches(work.lower(), WORKS, n=3, cutoff=0.0)
        raise ValueError(f"unknown paper {work!r}: must be {near[0]}, {near[1]} or {near[2]}")
    return (work,)
