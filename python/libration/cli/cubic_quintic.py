"""`libration cubic-quintic`: the motion of u'' + p u + q u^3 + s u^5 = 0, as `libration duffing`."""

from libration.cli.backbone import SEVERAL, backbone, several, starts
from libration.cli.oscillator import TOPICS, OscillatorOptions, oscillator_options, plain_numbers, required, solve
from libration.cli.parser import command
from libration.cli.quantities import NUMBERS, plain

DESCRIPTION = """\
The exact motion of the cubic-quintic oscillator u'' + p u + q u^3 + s u^5 = 0 from any start: with one well,
two or three, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {
    "p": "coefficient of the linear force",
    "q": "coefficient of the cubic force",
    "s": "coefficient of the quintic force",
}


def run(options: OscillatorOptions) -> None:
    """Solve what the words ask for."""
    from libration import CubicQuintic

    if options.u0 is not None and several(options.u0):
        required(options, COEFFICIENTS, "--p 1 --q -0.5 --s 0.1 --u0 0.1:2:20")
        force = plain_numbers(options, COEFFICIENTS)
        velocity0 = 0.0 if options.velocity0 is None else plain("--velocity0", options.velocity0)
        return backbone(options, "cubic_quintic", starts(options.u0, NUMBERS), velocity0, force, "")
    return solve(options, CubicQuintic, list(COEFFICIENTS), "--p 1 --q -0.5 --s 0.1 --u0 1")


COMMAND = command(
    "cubic-quintic",
    DESCRIPTION,
    run,
    OscillatorOptions,
    short="the same with a fifth power, + s u^5",
    parameters=oscillator_options(COEFFICIENTS),
    usage=["libration cubic-quintic", "--p P", "--q Q", "--s S", "--u0 U0", "[options]"],
    topics=(*TOPICS, SEVERAL),
    examples=(
        "libration cubic-quintic --p 1 --q -0.5 --s 0.1 --u0 1",
        "libration cubic-quintic --p 1 --q -4 --s 3 --u0 1.2 --plot wells.png",
        "libration cubic-quintic --p 1 --q -0.5 --s 0.1 --u0 0.1:2:20",
        "libration cubic-quintic --p 1 --q -0.5 --s 0.1 --u0 0:2:500 --plot backbone.png",
    ),
)
