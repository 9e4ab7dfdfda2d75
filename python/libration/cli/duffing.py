"""`libration duffing`: the motion of u'' + p u + q u^3 = 0 at many instants, its summary, a table and a plot."""

from libration.cli.oscillator import TOPICS, OscillatorOptions, oscillator_options, solve
from libration.cli.parser import command

DESCRIPTION = """\
The exact motion of the Duffing oscillator u'' + p u + q u^3 = 0 from any start: hardening or softening, with one well
or two, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {"p": "coefficient of the linear force", "q": "coefficient of the cubic force"}


def run(options: OscillatorOptions) -> None:
    """Solve what the words ask for."""
    from libration import Duffing

    solve(options, Duffing, list(COEFFICIENTS), "--p 1 --q 0.5 --u0 2")


COMMAND = command(
    "duffing",
    DESCRIPTION,
    run,
    OscillatorOptions,
    short="the nonlinear spring u'' + p u + q u^3 = 0, as solve",
    parameters=oscillator_options(COEFFICIENTS),
    usage=["libration duffing", "--p P", "--q Q", "--u0 U0", "[options]"],
    topics=TOPICS,
    examples=(
        "libration duffing --p 1 --q 0.5 --u0 2",
        "libration duffing --p -1 --q 1 --u0 1.4 --until 40s --plot wells.png",
        "libration duffing --p 1 --q -1 --u0 1.1 --out escape.csv",
    ),
)
