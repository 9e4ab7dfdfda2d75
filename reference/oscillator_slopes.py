"""Writes vectors/oscillator_slopes.csv: derivatives of motion, period, action and escape times by start and coefficients.

u'' + p u + r u^2 + q u^3 + s u^5 = c. The linearised equation goes along with the Taylor series (force_taylor.py); the periods'
derivatives follow from the return after a period, the actions' from means of powers of u over it. NaN: by a coefficient that the
oscillator does not have (s with r and c, or r and c with s), where nothing repeats or escapes, and by q of an escape
without fourth power, which is infinite. Run: python oscillator_slopes.py
"""

from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction

import exact
import mpmath as mp
import oscillator_action_inputs
from exact import agreement, decimal, mpf, real
from general_oscillator import PLACE, OrbitStates, ScaledOrbit, columns_of

NAME = "oscillator_slopes.csv"
LETTERS = "prqsc"
INPUTS = ["u0", "velocity0", *LETTERS, "t"]
BY = ["u0", "velocity0", *LETTERS]
OF = ("u", "velocity", "period", "action", "escape", "escape_backward")
HEADER = ["id", "stratum", *INPUTS, "regime", *(f"d{name}_d{x}" for name in OF for x in BY)]
DIGITS = 25


def of_letters(coefficients):
    """The letters of Duffing's oscillator, or of the cubic-quintic one."""
    return "pqs" if coefficients["s"] else "prqc"


def slopes(orbit, time, letters):
    """Lists of derivatives by u0, velocity0 and the letters, one for each of OF, in scaled units."""
    by = columns_of(letters)
    bits = 260
    for _ in range(9):
        with mp.workprec(bits + 150):
            try:
                rough = OrbitStates(orbit, [time], by, 2.2, bits, column_bits=130)
                fine = OrbitStates(orbit, [time], by, 1.8, bits + 60, column_bits=170)
            except ArithmeticError:
                bits += bits // 2  # too few for the integration to meet the quadrature
                continue
            found = [all_slopes(way, time, len(by)) for way in (rough, fine)]
            if all(same(a, b) for a, b in zip(*found, strict=True)):
                u, v, period, *escapes = found[1]
                break
        bits += bits // 2
    else:
        raise ArithmeticError("two precisions do not agree")
    action = [mp.nan] * len(by)
    if orbit.periodic():
        rate = 2 * mp.pi / fine.T
        action = [-real(orbit.acceleration) / rate, real(orbit.v0) / rate]
        for letter in letters:
            power, side = PLACE[letter]
            moved = real(orbit.u0) ** (power + 1) - orbit.mean_power(power + 1, 200)
            action.append(side * moved / (power + 1) / rate)
    elif orbit.regime == "rest":
        action = [mpf(0)] * len(by)
    if len(orbit.P) == 4:
        escapes = [[mp.nan if x == "q" else d for x, d in zip(("", "", *letters), e, strict=True)] for e in escapes]
    return [u, v, period, action, *escapes]


def same(rough, fine):
    """Whether two lists of derivatives agree; what is nothing beside the others becomes 0 in the second."""
    sizes = [abs(d) for d in fine if mp.isfinite(d)]
    least = max(sizes, default=mpf(0)) * mpf(10) ** -45
    agreeing = True
    for k, (a, b) in enumerate(zip(rough, fine, strict=True)):
        if abs(a) < least and abs(b) < least:
            fine[k] = mpf(0)
        elif agreement(a, b) > mpf(10) ** -28:
            agreeing = False
    return agreeing


def all_slopes(fine, time, count):
    columns = fine.states[time][1:]
    none = [mp.nan] * count
    forward, backward = fine.by_escape
    return [
        [d for d, _ in columns],
        [d for _, d in columns],
        list(fine.by_period or none),
        list(forward or none),
        [-d for d in backward] if backward else none,
    ]


def row(inputs):
    """One row of the file from its input columns."""
    given = {name: float.fromhex(inputs[name]) for name in INPUTS}
    coefficients = {letter: given[letter] for letter in LETTERS}
    start = Fraction(given["u0"]), Fraction(given["velocity0"])
    letters = of_letters(coefficients)
    whole = ScaledOrbit(start, {letter: given[letter] for letter in letters}, [Fraction(given["t"])])
    with mp.workprec(400):
        found = slopes(whole.orbit, whole.times[0], letters)
        unit, second = whole.u_unit, whole.t_unit
        of_unit = dict(zip(OF, (unit, unit / second, second, unit**2 / second, second, second), strict=True))
        by_unit = {"u0": unit, "velocity0": unit / second}
        by_unit |= {letter: unit ** (1 - PLACE[letter][0]) / second**2 for letter in letters}
        texts = []
        for name, derivatives in zip(OF, found, strict=True):
            known = dict(zip(["u0", "velocity0", *letters], derivatives, strict=True))
            for x in BY:
                d = known.get(x, mp.nan)
                texts.append("nan" if mp.isnan(d) else decimal(d * of_unit[name] / by_unit[x], DIGITS))
    return [*(inputs[name] for name in ("id", "stratum", *INPUTS)), whole.orbit.regime, *texts]


def inputs():
    return oscillator_action_inputs.slope_rows("os", INPUTS)


def all_rows(inputs):
    with ProcessPoolExecutor() as pool:
        yield from pool.map(row, inputs)


if __name__ == "__main__":
    exact.write(NAME, HEADER, all_rows(inputs()))
