"""Inputs of the stratum `ends`: parameters and arguments at the ends of the range of doubles, for every file of the
elliptic functions and integrals.

The largest and the smallest doubles, squares of moduli below the range, exact ends of the range of an inverse, angles
of more than 2^113 turns.
"""

import math
import sys
from fractions import Fraction

import mpmath as mp
from elliptic import parameters
from exact import real

MOST, LEAST = sys.float_info.max, 5e-324
FAR = 2.0**120  # further out the steps of the conditions pass a period
BELOW, ABOVE = math.nextafter(1.0, 0.0), math.nextafter(1.0, 2.0)
PARAMETERS = [
    *(("m", x) for x in (-MOST, -1e300, -1e66, -LEAST, 0.5, LEAST, 1e-310, 1e66, MOST)),
    *(("mc", x) for x in (MOST, LEAST, 2.0**-108, -LEAST, -1e-16)),
    *(("k", x) for x in (LEAST, 1e-162, -1e-155, 1e150)),
]
# The second route of epsilon is a quadrature that takes minutes for m > 1.
MODERATE = [(given, parameter) for given, parameter in PARAMETERS if parameters(given, parameter)[0] <= 1]


def value(x):
    return x if isinstance(x, str) else float(x).hex()


def quarter(given, parameter):
    """K for m < 1, K(1/m)/sqrt(m) for m > 1."""
    m, mc = parameters(given, parameter)
    with mp.workdps(60):
        return float(mp.elliprf(0, real(mc), 1) if m < 1 else mp.elliprf(0, real(-mc / m), 1) / mp.sqrt(real(m)))


def last_angle(m):
    """The double below the end of the domain of F, and a little less, for m > 1."""
    with mp.workdps(400):
        end = float(mp.asin(1 / mp.sqrt(real(m))))
    return [math.nextafter(end, 0), end * (1 - 1e-10)]


def of_real(shares, parameters_taken=PARAMETERS):
    for given, parameter in parameters_taken:
        K = quarter(given, parameter)
        yield from ({"given": given, "parameter": parameter, "u": share * K} for share in shares)
    yield {"given": "m", "parameter": -1e66, "u": LEAST}


def complete():
    yield from ({"given": given, "parameter": parameter} for given, parameter in PARAMETERS)


def incomplete():
    for given, parameter in PARAMETERS:
        m, _ = parameters(given, parameter)
        angles = last_angle(m) if m > 1 else [1e-155, 1.3, math.pi / 2, 3.0, 2.0**116]
        yield from ({"given": given, "parameter": parameter, "phi": phi} for phi in [LEAST, *angles])
    for m, phi in ((0.5, 1e300), (-5e-324, MOST), (0.0, -MOST), (-1e16, 1e300), (-1e308, 1.3), (-3.5e295, 1.5707963)):
        yield {"given": "m", "parameter": m, "phi": phi}


def inverse():
    names = [p + q for p in "scdn" for q in "scdn" if p != q]
    for given, parameter, root in (
        *(("mc", 2.0**-108, 2.0**-54), ("mc", 2.0**108, 2.0**54), ("m", 2.0**108, 2.0**54), ("mc", 2.0**-4, 2.0**-2)),
        *(("mc", -(2.0**-108), 2.0**-54), ("m", -(2.0**108), 2.0**54), ("k", 1e-155, 1e-155)),
    ):
        for name in names:
            if name == "sd" and given == "m":
                continue  # next to its first pole; ds has the same digits
            ends = (
                root,
                1 / root,
                math.nextafter(root, 0),
                math.nextafter(1 / root, 0),
                math.nextafter(root, math.inf),
            )
            yield from ({"function": name, "given": given, "parameter": parameter, "x": x} for x in ends)
    for given, parameter in (("m", -MOST), ("m", MOST), ("mc", LEAST)):
        for name in names:
            for x in () if name == "sd" and parameter == MOST else (0.5, -1e-300, 1e155, MOST):
                yield {"function": name, "given": given, "parameter": parameter, "x": x}


def theta():
    for given, parameter in PARAMETERS:
        if parameters(given, parameter)[0] < 1:
            for z in (LEAST, 0.7, math.pi / 2, 2.0**116, FAR):
                yield {"given": given, "parameter": parameter, "z": z}
    for q in (LEAST, 1e-310, BELOW, -LEAST, -BELOW):
        yield from ({"given": "q", "parameter": q, "z": z} for z in (1e-300, 0.7, math.pi / 2, FAR))


def heuman():
    for given, parameter in PARAMETERS:
        if 0 <= parameters(given, parameter)[0] <= 1:
            for phi in (LEAST, 1.3, math.pi / 2, 2.0**116, -FAR):
                yield {"given": given, "parameter": parameter, "phi": phi}


def carlson():
    sizes = (0.0, LEAST, 1.0, MOST)
    for x in sizes:
        for y in sizes[1:]:
            yield {"function": "rc", "x": x, "y": y}
            for z in sizes[1:]:
                if x <= y <= z:
                    yield {"function": "rf", "x": x, "y": y, "z": z}
                if x <= y:
                    yield {"function": "rd", "x": x, "y": y, "z": z}
                for p in (LEAST, 1e16, MOST):
                    if x <= y <= z:
                        yield {"function": "rj", "x": x, "y": y, "z": z, "p": p}


def third_kind():
    # The second route is an integral to the digits of n^2 m: further out a row takes minutes.
    characteristics = (-1e16, -1.0, LEAST, BELOW, ABOVE, 2.0, 1e16)
    taken = [("m", -1e16), ("m", 0.5), ("m", 1e16), ("mc", 2.0**-108), ("mc", -1e-16), ("k", 1e-10)]
    for given, parameter in taken:
        m, _ = parameters(given, parameter)
        angles = last_angle(m) if m > 1 else [3e-8, math.pi / 2 - 1.5e-8, 2.0**116]
        for i, n in enumerate(characteristics):
            row = {"given": given, "parameter": parameter, "n": n}
            if m < 1:
                yield {"function": "complete_pi", **row, "phi": 0.0}
            yield {"function": "incomplete_pi", **row, "phi": angles[i % len(angles)]}
    for mc, n in ((-1e-16, ABOVE), (1e-16, ABOVE), (-(2.0**-53), 1 + 2.0**-51), (2.0**-53, 1 + 2.0**-40)):
        with mp.workdps(60):
            pole = float(mp.asin(1 / mp.sqrt(real(Fraction(n)))))
        for phi in (math.nextafter(pole, 0), math.nextafter(pole, 2), pole + 1e-9):
            if mc > 0 or phi <= last_angle(1 - Fraction(mc))[0]:
                yield {"function": "incomplete_pi", "given": "mc", "parameter": mc, "n": n, "phi": phi}


def complex_arguments():
    for given, parameter in PARAMETERS:
        K = quarter(given, parameter)
        for re, im in ((0.3, 0.2), (1e-3, 0.9), (0.5, 0.0), (0.0, 0.5)):
            yield {"given": given, "parameter": parameter, "re": re * K, "im": im * K}


FILES = {
    "jacobi.csv": lambda: of_real((0.3, 1.0, 1e-10, 1e6)),
    "glaisher.csv": lambda: of_real((0.3, 1.0, 1e6)),
    "second_kind.csv": lambda: of_real((0.3, 1.0, 1e-10, 1e6), MODERATE),
    "complete.csv": complete,
    "incomplete.csv": incomplete,
    "inverse_jacobi.csv": inverse,
    "theta_functions.csv": theta,
    "heuman.csv": heuman,
    "carlson.csv": carlson,
    "third_kind.csv": third_kind,
    "jacobi_complex.csv": complex_arguments,
}


def rows(name):
    """The rows of one file; an argument that the function does not have is 0."""
    missing = {x: 0.0 for x in "xyzp"} if name == "carlson.csv" else {}
    for cells in FILES.get(name, tuple)():
        cells = {**{"function": cells["function"]}, **missing, **cells} if "function" in cells else cells
        yield {"stratum": "ends"} | {key: value(x) for key, x in cells.items()}
