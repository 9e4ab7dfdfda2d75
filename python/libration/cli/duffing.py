"""`libration duffing`: the motion of u'' + p u + r u^2 + q u^3 = c at many instants, its summary, a table and a plot."""

from libration.cli.backbone import SEVERAL
from libration.cli.mechanical import STATED, Spring, mechanical_options, run_spring
from libration.cli.oscillator import TOPICS, OscillatorOptions, oscillator_options
from libration.cli.parser import command

DESCRIPTION = """\
The exact motion of the Duffing oscillator u'' + p u + r u^2 + q u^3 = c from any start: hardening or softening, with one
well or two, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {"p": "coefficient of the linear force", "q": "coefficient of the cubic force"}
MORE = {"r": "coefficient of the quadratic force", "c": "constant force"}
SPRING = Spring(
    "duffing",
    names={"p": "stiffness", "q": "cubic"},
    more={"r": "quadratic", "c": "force"},
    plain="--p 1 --q 0.5",
    u0="2",
    stated="--mass 1e-11kg --stiffness 10N/m --cubic 1e12N/m3 --u0 1um",
)


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

    run_spring(options, SPRING, Duffing)


COMMAND = command(
    "duffing",
    DESCRIPTION,
    run,
    DuffingOptions,
    short="the nonlinear spring u'' + p u + r u^2 + q u^3 = c, as solve",
    parameters=[*oscillator_options(COEFFICIENTS, MORE), *mechanical_options(SPRING)],
    usage=["libration duffing", "--p P", "--q Q", "--u0 U0", "[options]"],
    topics=(*TOPICS, STATED, SEVERAL),
    examples=(
        "libration duffing --p 1 --q 0.5 --u0 2",
        "libration duffing --p -1 --q 1 --u0 1.4 --until 40s --plot wells.png",
        "libration duffing --p 1 --q -1 --u0 1.1 --out escape.csv",
        "libration duffing --p 1 --q 0.2 --r 0.5 --u0 1 --plot beam.png",
        "libration duffing --p 1 --q 0.2 --r 0.5 --u0 0.1:1:10",
        "libration duffing --p 1 --q 0.1 --u0 0:2:500 --plot backbone.png",
        "libration duffing --mass 1e-11kg --stiffness 10N/m --cubic 1e12N/m3 --u0 0.5um,1um",
    ),
)
