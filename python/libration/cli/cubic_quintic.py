"""`libration cubic-quintic`: the motion of u'' + alpha u + beta u^3 + gamma u^5 = 0, as `libration duffing`."""

from libration.cli.oscillator import TOPICS, OscillatorOptions, oscillator_options, solve
from libration.cli.parser import command

DESCRIPTION = """\
The exact motion of the cubic-quintic oscillator u'' + alpha u + beta u^3 + gamma u^5 = 0 from any start: with one well,
two or three, on a separatrix, or escaping to infinity in finite time."""
COEFFICIENTS = {
    "alpha": "coefficient of the linear force",
    "beta": "coefficient of the cubic force",
    "gamma": "coefficient of the quintic force",
}


def run(options: OscillatorOptions) -> None:
    """Solve what the words ask for."""
    from libration import CubicQuintic

    solve(options, CubicQuintic, list(COEFFICIENTS), "--alpha 1 --beta -0.5 --gamma 0.1 --u0 1")


COMMAND = command(
    "cubic-quintic",
    DESCRIPTION,
    run,
    OscillatorOptions,
    short="the same with a fifth power, + gamma u^5",
    parameters=oscillator_options(COEFFICIENTS),
    usage=["libration cubic-quintic", "--alpha ALPHA", "--beta BETA", "--gamma GAMMA", "--u0 U0", "[options]"],
    topics=TOPICS,
    examples=(
        "libration cubic-quintic --alpha 1 --beta -0.5 --gamma 0.1 --u0 1",
        "libration cubic-quintic --alpha 1 --beta -4 --gamma 3 --u0 1.2 --plot wells.png",
    ),
)
