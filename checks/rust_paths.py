"""The paths written in a Rust file: the braces of a `use` multiplied out, comments, strings and unit tests left out."""

import re
from pathlib import Path

from tree import code_lines

WORD = re.compile(r"\s*(\{|\*|[A-Za-z_]\w*)")
NEXT = re.compile(r"\s*(?:as\s+\w+)?\s*,?\s*(\})?")
PUBLIC = re.compile(r"\bpub(?:\([^)]*\))?\s+use\s+([^;]*);")
MODULE = re.compile(r'(?:#\[path = "(\w+)\.rs"\]\s*)?(?:pub(?:\([^)]*\))?\s+)?\bmod\s+(\w+);')


def tree(text: str, at: int = 0, before: tuple = ()) -> tuple[list[tuple], int]:
    """The paths of the `use` tree or expression that begins at a place, and where it ends."""
    while found := WORD.match(text, at):
        at = found.end()
        if found[1] == "{":
            several, after = [], NEXT.match(text, at)
            while not after[1] and after.end() < len(text):
                more, at = tree(text, after.end(), before)
                several, after = several + more, NEXT.match(text, at)
            return several, after.end()
        before = (*before, found[1])
        if not text.startswith("::", at):
            break
        at += 2
    return [before], at


def source(path: Path) -> str:
    text = "\n".join(line for _, line in code_lines(path, "//"))
    return re.split(r"#\[cfg\(test\)\]\s*mod ", text)[0]


def modules(text: str) -> dict[str, list[str]]:
    """The modules that a file declares, each with the names of the files that may hold it."""
    found = {}
    for file, name in MODULE.findall(text):
        found.setdefault(name, []).append(file or name)
    return found


def exported(text: str) -> list[tuple]:
    """The paths of every `pub use`."""
    return [path for use in PUBLIC.findall(text) for path in tree(use)[0]]


def used(text: str) -> set[tuple]:
    """Every other path from `crate`, `super`, `self` or a module declared here."""
    own = modules(text)
    text = re.sub(r'"(?:[^"\\]|\\.)*"', '""', PUBLIC.sub("", text))
    starts = re.compile(rf"(?<![\w:])(?:{'|'.join(['crate', 'super', 'self', *own])})\s*::")
    found = {path for start in starts.finditer(text) for path in tree(text, start.start())[0]}
    return {(file, *path[1:]) for path in found for file in own.get(path[0], path[:1])}
