"""What `libration duffing` and `cubic-quintic` take for the force of a spring: plain coefficients, or a mass and stiffnesses with units."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from libration.cli.backbone import backbone, several, starts
from libration.cli.help import Topic
from libration.cli.oscillator import OscillatorOptions, plain_numbers, required, show
from libration.cli.parser import Refusal, Value, refusal
from libration.cli.quantities import (
    CUBIC,
    FORCE,
    LENGTH,
    MASS,
    NUMBERS,
    QUADRATIC,
    QUINTIC,
    SPEED,
    STIFFNESS,
    Dimension,
    plain,
    quantity,
)

if TYPE_CHECKING:
    from libration import CubicQuintic, Duffing

MECHANICAL = {
    "mass": ("MASS", MASS, "mass, such as 1e-11kg: then what follows, u in m"),
    "stiffness": ("STIFFNESS", STIFFNESS, "linear stiffness, such as 10N/m"),
    "quadratic": ("STIFFNESS", QUADRATIC, "quadratic stiffness, such as 1e6N/m2 (default 0)"),
    "cubic": ("STIFFNESS", CUBIC, "cubic stiffness, such as 1e12N/m3 (default 0)"),
    "quintic": ("STIFFNESS", QUINTIC, "quintic stiffness, such as 1e23N/m5 (default 0)"),
    "force": ("FORCE", FORCE, "constant force, such as 1nN (default 0)"),
}
STATED = Topic(
    "masses and stiffnesses",
    text="""\
With --mass and stiffnesses the coefficients are those over the mass, --u0 takes a length and --velocity0 a velocity
with units, and every frequency is in Hz.""",
)


@dataclass(frozen=True)
class Spring:
    """A kind of spring: the beginning of the names of its functions of arrays, the mechanical option of each coefficient, examples."""

    family: str
    names: Mapping[str, str]
    more: Mapping[str, str]
    plain: str
    u0: str
    stated: str

    def of(self) -> dict[str, str]:
        """The mechanical option of each coefficient."""
        return {**self.names, **self.more}


def mechanical_options(spring: Spring) -> list[Value]:
    """The options of a mass and the stiffnesses that a spring has."""
    used = {"mass", *spring.of().values()}
    return [
        Value(f"--{name}", meta, text, "a mass on a spring")
        for name, (meta, _, text) in MECHANICAL.items()
        if name in used
    ]


def run_spring(options: OscillatorOptions, spring: Spring, kind: "type[Duffing] | type[CubicQuintic]") -> None:
    """Solve what the words ask for: one motion, or those from several displacements."""
    mechanical = any(getattr(options, name, None) is not None for name in MECHANICAL)
    force = stated(options, spring) if mechanical else plainly(options, spring)
    length, speed, unit = (LENGTH, SPEED, "m") if mechanical else (NUMBERS, NUMBERS, "")
    u0 = options.u0 or ""
    velocity0 = 0.0 if options.velocity0 is None else number("--velocity0", options.velocity0, speed)
    if several(u0):
        backbone(options, spring.family, starts(u0, length), velocity0, force, unit)
    else:
        show(options, kind, {"u0": number("--u0", u0, length), "velocity0": velocity0, **force}, unit)


def number(option: str, text: str, dimension: Dimension) -> float:
    """A quantity, or a number without a unit where it has no dimension; or a Refusal."""
    return plain(option, text) if dimension is NUMBERS else quantity(option, text, dimension)


def plainly(options: OscillatorOptions, spring: Spring) -> dict[str, float]:
    """The coefficients as plain numbers, or a Refusal."""
    u0 = "0.1:2:20" if several(options.u0) else spring.u0
    required(options, (*spring.names, "u0"), f"{spring.plain} --u0 {u0}")
    return plain_numbers(options, spring.of())


def stated(options: OscillatorOptions, spring: Spring) -> dict[str, float]:
    """The coefficients from a mass and stiffnesses, or a Refusal."""
    of = spring.of()
    for name, other in of.items():
        if getattr(options, name) is not None:
            raise Refusal(f"--{name} and a mass with stiffnesses: give one of both; beside --mass it is --{other}")
    required(options, ("mass", "stiffness", "u0"), spring.stated)
    found = {
        name: quantity(f"--{name}", text, dimension)
        for name, (_, dimension, _) in MECHANICAL.items()
        if (text := getattr(options, name, None)) is not None
    }
    mass = found["mass"]
    if not mass > 0.0:
        raise refusal("--mass", getattr(options, "mass", ""), "must be above 0")
    return dict.fromkeys(spring.names, 0.0) | {
        name: found[other] / mass for name, other in of.items() if other in found
    }
