"""What `libration ensemble` is asked for: the tables of a SPEC in TOML, checked whole before anything is written.

A specification is plain numbers and texts, so that it goes to any worker; its canonical text is JSON with sorted keys and with
every default filled in, and the store keeps its SHA-256. Two files that ask for the same have the same text.
"""

import hashlib
import json
import math
import tomllib
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np

from .._arrays import Floats
from .._scalars import count, real, shown
from ._bunch import bunch, positive
from ._reduce import Plan, histogram_bins

# What can be stored: units and meaning; of every time, and of the motion as a whole.
AT_TIMES = {
    "theta": ("rad", "angle from the bottom"),
    "velocity": ("rad s-1", "angular velocity"),
}
OF_MOTION = {
    "theta0": ("rad", "initial angle from the bottom"),
    "velocity0": ("rad s-1", "initial angular velocity"),
    "omega0": ("rad s-1", "angular frequency of small swings"),
    "action": ("rad2 s-1", "action per unit inertia"),
    "frequency": ("rad s-1", "mean angular frequency"),
    "energy_ratio": ("1", "energy over that at the top"),
}
TABLES = {
    "states": "",
    "time": "t from to count",
    "output": "variables chunk",
    "reduce": "moments histogram",
}
BUNCH = "distribution n seed sigma_theta action temperature energy_ratio omega0 matched rotations quiet".split()
GRID = "theta0 velocity0 omega0".split()
SPAN = "from to count".split()
# If no size is given, values of one variable in a chunk, some MB, and particles; more where only sums are kept, for the files of a
# chunk take as long as tens of thousands of particles.
VALUES, PARTICLES, SUMMED = 2**21, 2**18, 2**20
# Values of an axis.
LONGEST = 10**6


class Specification(NamedTuple):
    """An ensemble, its times, and what is kept of it."""

    title: str
    bunch: dict[str, Any] | None
    axes: tuple[tuple[float, ...], ...]
    omega0: float
    particles: int
    times: tuple[float, ...]
    variables: tuple[str, ...]
    chunk: int
    plan: Plan | None
    canonical: str

    @property
    def chunks(self) -> int:
        """How many chunks there are."""
        return -(-self.particles // self.chunk)

    @property
    def samples(self) -> int:
        """How many states are evaluated: particles by times."""
        return self.particles * len(self.times)

    @property
    def digest(self) -> str:
        """SHA-256 of the canonical text."""
        return hashlib.sha256(self.canonical.encode()).hexdigest()

    def region(self, number: int) -> slice:
        """The particles of a chunk."""
        return slice(number * self.chunk, min((number + 1) * self.chunk, self.particles))

    def states(self, region: slice) -> tuple[Floats, Floats, Any]:
        """Angles, velocities and omega0 of a part of the particles at t = 0."""
        if self.bunch is not None:
            theta, velocity = bunch(region.stop - region.start, first=region.start, **self.bunch)
            return theta, velocity, self.omega0
        shape = [len(axis) for axis in self.axes]
        places = np.unravel_index(np.arange(region.start, region.stop), shape)
        theta, velocity, omega0 = (np.array(axis)[place] for axis, place in zip(self.axes, places, strict=True))
        return theta, velocity, omega0


def specification(text: str) -> Specification:
    """The specification of a text in TOML, or a ValueError of one line: key, value, what is allowed."""
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"is no TOML: {error}") from None
    except RecursionError:
        raise ValueError("is no SPEC: its lists are nested too deeply") from None
    _known("", tables, ["title", *TABLES])
    title = tables.get("title", "ensemble of pendulums")
    if not isinstance(title, str) or not title.strip():
        raise ValueError(f"title = {shown(title)}: must be a text")
    for name, keys in TABLES.items():
        if not isinstance(tables.get(name, {}), dict):
            raise ValueError(f"{name} = {shown(tables[name])}: must be a table, [{name}]")
        if keys:
            _known(f"[{name}] ", tables.get(name, {}), keys.split())
    for name in ("states", "time"):
        if name not in tables:
            raise ValueError(f"[{name}] is missing: must be there; see docs/ensembles.md")
    states = tables["states"]
    bunch_of, axes, omega0, particles = _bunch(states) if "distribution" in states else _grid(states)
    times = _times(tables["time"])
    plan = _plan(tables["reduce"], times, omega0) if "reduce" in tables else None
    variables = _variables(tables.get("output", {}), plan)
    chunk = _chunk(tables.get("output", {}), particles, len(times), PARTICLES if variables else SUMMED)
    asked = {
        "title": title,
        "states": bunch_of or {name: _stated(states.get(name), axis) for name, axis in zip(GRID, axes, strict=True)},
        "n": particles,
        "time": _stated(tables["time"].get("t", tables["time"]), times),
        "variables": variables,
        "chunk": chunk,
        # The order of the quantities is that of the dimensions.
        "reduce": plan and {"moments": plan.moments, "histogram": list(plan.bins.items())},
    }
    canonical = json.dumps(asked, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return Specification(title, bunch_of, axes, omega0 or math.nan, particles, times, variables, chunk, plan, canonical)


def _known(table: str, given: dict[str, Any], known: list[str]) -> None:
    """Refuses a key that there is not, with the nearest one."""
    for name, value in given.items():
        if name not in known:
            near = get_close_matches(name, known, n=1)
            hint = f"did you mean {near[0]}?" if near else f"must be of {', '.join(known)}"
            what = f"[{name}]" if isinstance(value, dict) and not table else f"{name} = {shown(value)}"
            raise ValueError(f"{table}{what}: there is no such key; {hint}")


def _bunch(given: dict[str, Any]) -> tuple[dict[str, Any], tuple[tuple[float, ...], ...], float, int]:
    """The arguments of `bunch` without its number of particles, and that number."""
    _known("[states] ", given, BUNCH)
    for name in ("n", "seed"):
        if name not in given:
            raise ValueError(f"[states] {name} is missing: must be a whole number")
    arguments = {name: value for name, value in given.items() if name != "n"}
    try:
        particles = count("n", given["n"])
        if particles < 1:
            raise ValueError(f"n = {particles}: must be positive")
        arguments["omega0"] = positive("omega0", arguments.get("omega0", 1.0))
        bunch(0, first=0, **arguments)
    except (ValueError, TypeError) as error:
        raise ValueError(f"[states] {error}") from None
    whole = ("seed", "distribution", "matched", "rotations", "quiet")
    for name in ("matched", "rotations", "quiet"):
        arguments.setdefault(name, name == "matched")
    arguments = {name: value if name in whole else float(value) for name, value in arguments.items()}
    return arguments, (), float(arguments["omega0"]), particles


def _grid(given: dict[str, Any]) -> tuple[None, tuple[tuple[float, ...], ...], float | None, int]:
    """The axes of a grid, and how many starts it has."""
    if "theta0" not in given:
        raise ValueError("[states] is neither: must have distribution, a bunch, or theta0, a grid")
    _known("[states] ", given, GRID)
    axes = tuple(_axis(f"[states] {name}", given.get(name, 1.0 if name == "omega0" else 0.0)) for name in GRID)
    for value in axes[2]:
        if value <= 0.0:
            raise ValueError(f"[states] omega0 = {value!r}: must be positive")
    return None, axes, axes[2][0] if len(axes[2]) == 1 else None, math.prod(map(len, axes))


def _axis(name: str, value: Any) -> tuple[float, ...]:
    """A number, a list of numbers, or as many as wanted from one to another."""
    if isinstance(value, dict):
        _known(f"{name} ", value, SPAN)
        for each in SPAN:
            if each not in value:
                raise ValueError(f"{name} {each} is missing: must have from, to and count")
        first, last = (_finite(f"{name} {each}", value[each]) for each in SPAN[:2])
        many = count(f"{name} count", value["count"])
        if not 1 <= many <= LONGEST:
            raise ValueError(f"{name} count = {many}: must be from 1 to {LONGEST}")
        if not math.isfinite(last - first):
            raise ValueError(f"{name} = {shown(value)}: must have ends within the doubles of each other")
        return tuple(np.linspace(first, last, many).tolist())
    if isinstance(value, list):
        if not value:
            raise ValueError(f"{name} = []: must have a number")
        if len(value) > LONGEST:
            raise ValueError(f"{name} has {len(value)} numbers: must have no more than {LONGEST}")
        return tuple(_finite(name, each) for each in value)
    return (_finite(name, value),)


def _stated(given: Any, axis: tuple[float, ...]) -> Any:
    """An axis as short as it was given."""
    if isinstance(given, dict):
        return {"from": float(given["from"]), "to": float(given["to"]), "count": len(axis)}
    return axis


def _finite(name: str, value: Any) -> float:
    if not isinstance(value, int | float):
        raise ValueError(f"{name} = {shown(value)}: must be one real number")
    number = real(name, value)
    if not math.isfinite(number):
        raise ValueError(f"{name} = {number!r}: must be finite")
    return number


def _times(given: dict[str, Any]) -> tuple[float, ...]:
    """The times, listed or from one to another."""
    if "t" in given and any(each in given for each in SPAN):
        raise ValueError(f"[time] t = {shown(given['t'])}: must be alone, or be left out beside from, to and count")
    if isinstance(given.get("t"), dict):
        raise ValueError(f"[time] t = {shown(given['t'])}: must be numbers")
    return _axis("[time] t" if "t" in given else "[time]", given.get("t", given))


def _plan(given: dict[str, Any], times: tuple[float, ...], omega0: float | None) -> Plan:
    moments = given.get("moments", 2)
    if not isinstance(moments, int) or isinstance(moments, bool) or moments not in (0, 1, 2):
        raise ValueError(f"[reduce] moments = {shown(moments)}: must be 0, 1 or 2")
    if omega0 is None:
        raise ValueError("[states] omega0: must be one number beside [reduce], which sums over all particles")
    try:
        bins = histogram_bins(given.get("histogram"))
    except (ValueError, TypeError) as error:
        raise ValueError(f"[reduce] {error}") from None
    return Plan(times, omega0, moments, bins, {})


def _variables(given: dict[str, Any], plan: Plan | None) -> tuple[str, ...]:
    """What is stored of each particle."""
    known = [*AT_TIMES, *OF_MOTION]
    wanted = given.get("variables", list(AT_TIMES) if plan is None else [])
    if not isinstance(wanted, list) or any(each not in known for each in wanted) or len(set(wanted)) < len(wanted):
        raise ValueError(f"[output] variables = {shown(wanted)}: must be a list of {', '.join(known)}, each once")
    if not wanted and plan is None:
        raise ValueError("[output] variables = []: must have one, where there is no [reduce]")
    return tuple(name for name in known if name in wanted)


def _chunk(given: dict[str, Any], particles: int, times: int, most: int) -> int:
    """Particles of a chunk: as given, or of some MB; all times of a particle are in one."""
    if "chunk" not in given:
        return min(particles, most, max(1, VALUES // times))
    size = count("[output] chunk", given["chunk"])
    if not 1 <= size <= 2**31:
        raise ValueError(f"[output] chunk = {size}: must be from 1 to 2**31 particles")
    return min(particles, size)
