"""Reference values of bunches that depend on the action alone: the rms angle by the scale; writes vectors/bunches.csv. Run: python bunches.py.

Density in phase space by x = J/scale, J the action over omega0: `waterbag` 1 for x < 1, `parabolic` 1 - x for x < 1, `gaussian` exp(-x) up
to the separatrix, J = 8/pi. With m the energy ratio, dJ = (4/pi) K(m) dm, and theta = 2 asin(sqrt(m) sin a) on the orbit,

    rms**2 = int f(J) int_0^(pi/2) theta**2/sqrt(1 - m sin(a)**2) da dm / int f(J) K(m) dm,

by tanh-sinh quadrature in both, at two precisions that agree to 19 digits. Columns: stratum, scale (hex), rms as hi + lo.
"""

import csv

import exact
import mpmath as mp
from exact import mpf

NAME = "bunches.csv"
HEADER = "stratum scale rms_hi rms_lo".split()
SCALES = {
    "waterbag": (2.0**-20, 0.1, 1.5, 2.5),
    "parabolic": (2.0**-20, 0.1, 1.5, 2.5),
    "gaussian": (2.0**-20, 0.1, 1.0, 10.0),
}
# Where exp(-x) is below 1e-26.
LAST = 60


def inputs():
    for shape, scales in SCALES.items():
        for scale in scales:
            yield {"stratum": shape, "scale": scale.hex()}


def action(m):
    """Over omega0; a small one cancels as m does."""
    with mp.extradps(10):
        return 8 / mp.pi * (mp.ellipe(m) - (1 - m) * mp.ellipk(m))


def energy_ratio(last):
    """That of an action; 1 from the separatrix on."""
    if last >= 8 / mp.pi:
        return mpf(1)
    low, high = mpf(0), mpf(1)
    for _ in range(int(mp.mp.prec) + 10):
        middle = (low + high) / 2
        low, high = (middle, high) if action(middle) < last else (low, middle)
    return low


def density(shape, x):
    return {"waterbag": lambda: mpf(1), "parabolic": lambda: 1 - x, "gaussian": lambda: mp.exp(-x)}[shape]()


def squares(m):
    """Integral of theta**2 over a quarter of a swing, in times of omega0."""

    def at(a):
        return (2 * mp.asin(mp.sqrt(m) * mp.sin(a))) ** 2 / mp.sqrt(1 - m * mp.sin(a) ** 2)

    return mp.quad(at, [0, mp.pi / 2])


def rms(shape, scale, digits):
    """The rms angle, to some digits less."""
    with mp.workdps(digits):
        scale = mpf(scale)
        top = energy_ratio(scale * LAST if shape == "gaussian" else scale)

        def over(weight):
            return mp.quad(
                lambda m: density(shape, action(m) / scale) * weight(m), [0, *(top / 4**k for k in (3, 2, 1, 0))]
            )

        return mp.sqrt(over(squares) / over(mp.ellipk))


def row(given):
    shape, scale = given["stratum"], float.fromhex(given["scale"])
    value, again = rms(shape, scale, 24), rms(shape, scale, 28)
    with mp.workdps(40):
        if exact.agreement(value, again) > mpf(10) ** -19:
            raise SystemExit(f"reference: {shape} {scale}: two precisions do not agree to 19 digits")
        return [shape, given["scale"], *exact.hi_lo(+again)]


if __name__ == "__main__":
    with (exact.VECTORS / NAME).open("w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(HEADER)
        for given in inputs():
            out.writerow(row(given))
