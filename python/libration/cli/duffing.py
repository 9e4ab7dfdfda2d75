"""`libration duffing`: the motion of u'' + p u + r u^2 + q u^3 = c at many instants, its summary, a table and a plot."""

from libration.cli.oscillator import TOPICS, OscillatorOptions, oscillator_options, solve
from libration.cli.parser import command

DESCRIPTION = """\
The exact motion of the Duffing oscillator u'' + p u + r u^2 + q u^3 = c from any start: hardening or softening, with one
well or two, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {"p": "coefficient of the linear force", "q": "coefficient of the cubic force"}
MORE = {"r": "coefficient of the quadratic force", "c": "constant force"}


def run(options: OscillatorOptions) -> None:
    """Solve what the words ask for."""
    from libration import Duffing

    solve(options, Duffing, list(COEFFICIENTS), "--p 1 --q 0.5 --u0 2", list(MORE))


COMMAND = command(
    "duffing",
    DESCRIPTION,
    run,
    OscillatorOptions,
    short="the nonlinear spring u'' + p u + r u^2 + q u^3 = c, as solve",
    parameters=oscillator_options(COEFFICIENTS, MORE),
    usage=["libration duffing", "--p P", "--q Q", "--u0 U0", "[options]"],
    topics=TOPICS,
    examples=(
        "libration duffing --p 1 --q 0.5 --u0 2",
        "libration duffing --p -1 --q 1 --u0 1.4 --until 40s --plot wells.png",
        "libration duffing --p 1 --q -1 --u0 1.1 --out escape.csv",
        "libration duffing --p 1 --q 0.2 --r 0.5 --u0 1 --plot beam.png",
    ),
)
