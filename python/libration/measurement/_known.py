"""What is known beside the measurements, as the core takes it: length or g, parts, bob and fluid, friction model, resampling."""

from collections.abc import Sequence
from typing import Any, TypeAlias

from .. import _core
from .._scalars import real, shown
from ._columns import measure

Pair: TypeAlias = tuple[float, float]
# Shape, and mass, distance of the centre and size with their uncertainties.
MeasuredPart: TypeAlias = tuple[str, Pair, Pair, Pair]
Known: TypeAlias = dict[str, Any]

MODELS = ("auto", *_core.friction_models())
CORRECTIONS = ("bob size", "wire mass", "buoyancy", "added mass")
# Density in kg/m**3 and kinematic viscosity in m**2/s at 20 degrees (CRC Handbook, 97th edition, 6-1 and 6-17).
FLUIDS = {"air": (1.204, 1.516e-5), "water": (998.2, 1.0034e-6)}
# Of draws and of resamplings: fewer say nothing about 2.5 % on either side.
LEAST_DRAWS, LEAST_RESAMPLINGS = 100, 10
MOST = 10_000_000


def known_of(
    *,
    length: Any = None,
    gravity: Any = None,
    parts: Sequence[Any] = (),
    bob: Any = None,
    wire: Any = None,
    fluid: Any = "air",
    without: Any = (),
    model: str = "auto",
    window: Any = None,
    scale_u: Any = 0.0,
    clock_u: Any = 0.0,
    free_scale: bool = False,
    bootstrap: Any = 0,
    monte_carlo: Any = 0,
    seed: Any = 1,
) -> Known:
    """The dictionary of the core, or an error of one line."""
    if model not in MODELS:
        raise ValueError(f"model = {shown(model)}: must be one of {', '.join(MODELS)}")
    if length is not None and gravity is not None:
        raise ValueError("length and gravity: give one of the two; the motion holds g/length alone")
    return {
        "length": None if length is None else measure("length", length),
        "gravity": None if gravity is None else measure("gravity", gravity),
        "parts": parts_of(parts),
        "bob": (*bob_of(bob), None if wire is None else real("wire", wire)),
        "fluid": fluid_of(fluid),
        "without": without_of(without),
        "model": None if model == "auto" else model,
        "window": None if window is None else window_of(window),
        "scale_u": real("scale_u", scale_u),
        "clock_u": real("clock_u", clock_u),
        "free_scale": bool(free_scale),
        "bootstrap": count_of("bootstrap", bootstrap, LEAST_RESAMPLINGS),
        "monte_carlo": count_of("monte_carlo", monte_carlo, LEAST_DRAWS),
        "seed": count_of("seed", seed, 0),
    }


def parts_of(parts: Any) -> list[MeasuredPart]:
    """Parts of a rigid pendulum, or a ValueError."""
    if isinstance(parts, str) or not hasattr(parts, "__iter__"):
        raise ValueError(f"parts = {shown(parts)}: must be a sequence of (shape, mass, distance, size)")
    return [measured_part(each) for each in parts]


def measured_part(given: Any) -> MeasuredPart:
    """A part of a rigid pendulum, or a ValueError."""
    if not isinstance(given, tuple | list) or len(given) != 4 or not isinstance(given[0], str):
        raise ValueError(f"parts: {shown(given)} must be (shape, mass, distance, size)")
    shape, mass, distance, size = given
    return shape, measure("mass", mass), measure("distance", distance), measure("size", size)


def bob_of(bob: Any) -> tuple[float | None, float | None]:
    """Radius and mass of a bob, of which the mass may be missing."""
    if bob is None:
        return None, None
    if not isinstance(bob, tuple | list):
        return real("bob", bob), None
    if len(bob) != 2:
        raise ValueError(f"bob = {shown(bob)}: must be a radius in m, or (radius, mass in kg)")
    return real("radius of bob", bob[0]), None if bob[1] is None else real("mass of bob", bob[1])


def fluid_of(fluid: Any) -> Pair:
    """Density and viscosity of a fluid by its name, or as they are given."""
    if isinstance(fluid, str) and fluid in FLUIDS:
        return FLUIDS[fluid]
    if isinstance(fluid, tuple | list) and len(fluid) == 2:
        return real("density of fluid", fluid[0]), real("viscosity of fluid", fluid[1])
    raise ValueError(
        f"fluid = {shown(fluid)}: must be air, water, or (density in kg/m**3, kinematic viscosity in m**2/s)"
    )


def without_of(without: Any) -> list[str]:
    """Names of corrections that are not made."""
    names = [without] if isinstance(without, str) or not hasattr(without, "__iter__") else list(without)
    for name in names:
        if name not in CORRECTIONS:
            raise ValueError(f"without = {shown(name)}: must be one of {', '.join(CORRECTIONS)}")
    return names


def window_of(window: Any) -> Pair:
    """The times that are fitted."""
    if not isinstance(window, tuple | list) or len(window) != 2:
        raise ValueError(f"window = {shown(window)}: must be (from, to) in s")
    return real("window[0]", window[0]), real("window[1]", window[1])


def count_of(name: str, given: Any, least: int) -> int:
    """A whole number, 0 or from `least`."""
    number = real(name, given)
    if not number.is_integer() or not (number == 0 or least <= number <= MOST):
        allowed = f"0 or from {least} to {MOST}" if least else f"from 0 to {MOST}"
        raise ValueError(f"{name} = {shown(given)}: must be a whole number, {allowed}")
    return int(number)
