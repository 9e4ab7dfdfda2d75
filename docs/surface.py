"""The public surface of the package, read from the package itself: names, signatures, docstrings, places.

    PYTHONPATH=python python docs/surface.py     prints it as JSON, in the order of the reference

A member is a function, a class, or a method or property of a class. Fields of named tuples and values of enums are told
of with their class.
"""

import importlib
import inspect
import json
import os
import subprocess
import sys
from pathlib import Path

# The rooms in the order of the pages; what one has shown is not shown again.
ROOMS = (
    "pendulum",
    "damped",
    "measurement",
    "oscillator",
    "elliptic",
    "",
    "ensemble",
    "jax",
    "approx",
    "plot",
    "papers",
)


def surface(root: Path) -> dict[str, dict]:
    """The surface of the package under root/python, by the name of each member."""
    environment = {**os.environ, "PYTHONPATH": str(root / "python")}
    run = subprocess.run([sys.executable, __file__], env=environment, capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def sections(docstring: str) -> dict[str, str]:
    """A numpydoc docstring by its sections; what stands before the first is `Summary`."""
    parts, name = {"Summary": []}, "Summary"
    lines = docstring.splitlines()
    for number, line in enumerate(lines):
        if set(line) == {"-"}:
            continue
        if number + 1 < len(lines) and lines[number + 1] and set(lines[number + 1]) == {"-"}:
            name = line
            parts[name] = []
        else:
            parts[name].append(line)
    return {name: "\n".join(lines).strip("\n") for name, lines in parts.items()}


def members() -> dict[str, dict]:
    """Every public member of the package that is imported here."""
    shown, found = set(), {}
    top = importlib.import_module("libration")
    for room in ROOMS:
        try:
            module = importlib.import_module(f"libration.{room}".rstrip("."))
        except ModuleNotFoundError:
            continue
        for name in getattr(module, "__all__", ()):
            # A function that keeps its results is told as the function itself.
            value = inspect.unwrap(getattr(module, name))
            if name.startswith("__") or id(value) in shown:
                continue
            shown.add(id(value))
            # `approx.period` is another one than `period`.
            short = name in top.__all__ and inspect.unwrap(getattr(top, name)) is value
            prefix, place = ("", "libration") if short else (f"{room}.", f"libration.{room}")
            if inspect.isclass(value):
                told = {name: member(value, name)}
                told |= {f"{name}.{own}": member(what, own, value) for own, what in attributes(value)}
            elif inspect.isfunction(value):
                told = {prefix + name: member(value, name)}
            else:
                told = {prefix + name: registry(value, name)}
            home = {"room": room or "top", "path": f"{place}.{name}"}
            found |= {each: home | what for each, what in told.items()}
    return found


def registry(value: object, name: str) -> dict:
    """A table of named formulas, which is an object and not a function."""
    told = member(type(value), name)
    entries = ", ".join(f"`{each}`" for each in getattr(value, "names", ()))
    return told | {"kind": "registry", "doc": f"{told['doc'].partition(chr(10))[0]}\n\nIts entries: {entries}."}


def attributes(kind: type) -> list[tuple[str, object]]:
    """Methods and properties of a class and of the classes of the package that it is made from."""
    seen = {}
    for base in reversed(kind.__mro__):
        if base.__module__.partition(".")[0] == kind.__module__.partition(".")[0]:
            seen |= {name: what for name, what in vars(base).items() if not name.startswith("_")}
    return [(name, what) for name, what in seen.items() if asked(what)]


def asked(what: object) -> bool:
    """Whether an attribute is a method or a property, and no field."""
    return isinstance(what, property | classmethod | staticmethod) or inspect.isfunction(what)


def member(what: object, name: str, owner: type | None = None) -> dict:
    """What the pages say of a member."""
    function = what.fget if isinstance(what, property) else getattr(what, "__func__", what)
    parameters = []
    if not isinstance(what, property):
        try:
            parameters = list(inspect.signature(function).parameters.values())
        except (TypeError, ValueError):
            parameters = []
        if owner is not None and not isinstance(what, staticmethod):
            parameters = parameters[1:]
    function = inspect.unwrap(getattr(function, "func", function))
    file = Path(inspect.getsourcefile(function))
    bare = [parameter.replace(annotation=inspect.Parameter.empty) for parameter in parameters]
    return {
        "kind": "property" if isinstance(what, property) else "class" if inspect.isclass(what) else "function",
        "signature": f"{name}{inspect.Signature(bare)}" if not isinstance(what, property) else name,
        "arguments": [parameter.name for parameter in bare],
        "doc": inspect.getdoc(function) or "",
        "place": f"python/{file.relative_to(Path(sys.modules['libration'].__file__).parents[1]).as_posix()}::{function.__qualname__}",
    }


if __name__ == "__main__":
    print(json.dumps(members()))
