"""`libration cubic-quintic`: the motion of u'' + p u + q u^3 + s u^5 = 0, as `libration duffing`."""

from libration.cli.backbone import SEVERAL
from libration.cli.mechanical import STATED, Spring, mechanical_options, run_spring
from libration.cli.oscillator import TOPICS, OscillatorOptions, oscillator_options
from libration.cli.parser import command

DESCRIPTION = """\
The exact motion of the cubic-quintic oscillator u'' + p u + q u^3 + s u^5 = 0 from any start: with one well,
two or three, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {
    "p": "coefficient of the linear force",
    "q": "coefficient of the cubic force",
    "s": "coefficient of the quintic force",
}
SPRING = Spring(
    "cubic_quintic",
    names={"p": "stiffness", "q": "cubic", "s": "quintic"},
    more={},
    plain="--p 1 --q -0.5 --s 0.1",
    u0="1",
    stated="--mass 1e-11kg --stiffness 10N/m --cubic 1e12N/m3 --quintic 1e23N/m5 --u0 1um",
)


class CubicQuinticOptions(OscillatorOptions):
    """The options of `libration cubic-quintic`."""

    p: str | None
    q: str | None
    s: str | None
    mass: str | None
    stiffness: str | None
    cubic: str | None
    quintic: str | None


def run(options: CubicQuinticOptions) -> None:
    """Solve what the words ask for."""
    from libration import CubicQuintic

    run_spring(options, SPRING, CubicQuintic)


COMMAND = command(
    "cubic-quintic",
    DESCRIPTION,
    run,
    CubicQuinticOptions,
    short="the same with a fifth power, + s u^5",
    parameters=[*oscillator_options(COEFFICIENTS), *mechanical_options(SPRING)],
    usage=["libration cubic-quintic", "--p P", "--q Q", "--s S", "--u0 U0", "[options]"],
    topics=(*TOPICS, STATED, SEVERAL),
    examples=(
        "libration cubic-quintic --p 1 --q -0.5 --s 0.1 --u0 1",
        "libration cubic-quintic --p 1 --q -4 --s 3 --u0 1.2 --plot wells.png",
        "libration cubic-quintic --p 1 --q -0.5 --s 0.1 --u0 0.1:2:20",
        "libration cubic-quintic --p 1 --q -0.5 --s 0.1 --u0 0:2:500 --plot backbone.png",
        "libration cubic-quintic --mass 1e-11kg --stiffness 10N/m --quintic 1e23N/m5 --u0 1um",
    ),
)
