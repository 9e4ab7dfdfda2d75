"""`libration duffing`: the motion of u'' + p u + r u^2 + q u^3 = c at many instants, its summary, a table and a plot."""

from libration.cli.backbone import SEVERAL, backbone, several, starts
from libration.cli.oscillator import (
    TOPICS,
    OscillatorOptions,
    oscillator_options,
    plain_numbers,
    required,
    show,
    solve,
)
from libration.cli.parser import Refusal, Value, command, refusal
from libration.cli.quantities import (
    CUBIC,
    FORCE,
    LENGTH,
    MASS,
    NUMBERS,
    QUADRATIC,
    SPEED,
    STIFFNESS,
    quantity,
)

DESCRIPTION = """\
The exact motion of the Duffing oscillator u'' + p u + r u^2 + q u^3 = c from any start: hardening or softening, with one
well or two, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {"p": "coefficient of the linear force", "q": "coefficient of the cubic force"}
MORE = {"r": "coefficient of the quadratic force", "c": "constant force"}

MECHANICAL = {
    "mass": ("MASS", MASS, "mass, such as 1e-11kg: then what follows, u in m"),
    "stiffness": ("STIFFNESS", STIFFNESS, "linear stiffness, such as 10N/m"),
    "quadratic": ("STIFFNESS", QUADRATIC, "quadratic stiffness, such as 1e6N/m2 (default 0)"),
    "cubic": ("STIFFNESS", CUBIC, "cubic stiffness, such as 1e12N/m3 (default 0)"),
    "force": ("FORCE", FORCE, "constant force, such as 1nN (default 0)"),
}
OF = {"p": "stiffness", "q": "cubic", "r": "quadratic", "c": "force"}


class DuffingOptions(OscillatorOptions):
    """The options of `libration duffing`."""

    p: str | None
    q: str | None
    r: str | None
    c: str | None
    mass: str | None
    stiffness: str | None
    quadratic: str | None
    cubic: str | None
    force: str | None


def run(options: DuffingOptions) -> None:
    """Solve what the words ask for."""
    from libration import Duffing

    mechanical = [name for name in MECHANICAL if getattr(options, name) is not None]
    if not mechanical and not several(options.u0):
        return solve(options, Duffing, list(COEFFICIENTS), "--p 1 --q 0.5 --u0 2", list(MORE))
    force = stated(options) if mechanical else plainly(options)
    length, speed = (LENGTH, SPEED) if mechanical else (NUMBERS, NUMBERS)
    if options.u0 is None:
        raise Refusal("missing --u0")
    velocity0 = 0.0 if options.velocity0 is None else quantity("--velocity0", options.velocity0, speed)
    if several(options.u0):
        unit = "m" if mechanical else ""
        return backbone(options, "duffing", starts(options.u0, length), velocity0, force, unit)
    return show(options, Duffing, {"u0": quantity("--u0", options.u0, length), "velocity0": velocity0, **force})


def plainly(options: DuffingOptions) -> dict[str, float]:
    """The coefficients as plain numbers, or a Refusal."""
    required(options, COEFFICIENTS, "--p 1 --q 0.5 --u0 0.1:2:20")
    return plain_numbers(options, OF)


def stated(options: DuffingOptions) -> dict[str, float]:
    """The coefficients from a mass and stiffnesses, or a Refusal."""
    for name, other in OF.items():
        if getattr(options, name) is not None:
            raise Refusal(f"--{name} and a mass with stiffnesses: give one of both; beside --mass it is --{other}")
    required(options, ("mass", "stiffness"), "--mass 1e-11kg --stiffness 10N/m --cubic 1e12N/m3 --u0 1um")
    found = {
        name: quantity(f"--{name}", text, dimension)
        for name, (_, dimension, _) in MECHANICAL.items()
        if (text := getattr(options, name)) is not None
    }
    mass = found["mass"]
    if not mass > 0.0:
        raise refusal("--mass", options.mass or "", "must be above 0")
    return {"p": 0.0, "q": 0.0} | {name: found[other] / mass for name, other in OF.items() if other in found}


COMMAND = command(
    "duffing",
    DESCRIPTION,
    run,
    DuffingOptions,
    short="the nonlinear spring u'' + p u + r u^2 + q u^3 = c, as solve",
    parameters=[
        *oscillator_options(COEFFICIENTS, MORE),
        *(Value(f"--{name}", meta, text, "a mass on a spring") for name, (meta, _, text) in MECHANICAL.items()),
    ],
    usage=["libration duffing", "--p P", "--q Q", "--u0 U0", "[options]"],
    topics=(*TOPICS, SEVERAL),
    examples=(
        "libration duffing --p 1 --q 0.5 --u0 2",
        "libration duffing --p -1 --q 1 --u0 1.4 --until 40s --plot wells.png",
        "libration duffing --p 1 --q -1 --u0 1.1 --out escape.csv",
        "libration duffing --p 1 --q 0.2 --r 0.5 --u0 1 --plot beam.png",
        "libration duffing --p 1 --q 0.2 --r 0.5 --u0 0.1:1:10",
        "libration duffing --p 1 --q 0.1 --u0 0:2:500 --plot backbone.png",
    ),
)
