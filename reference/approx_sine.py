"""Reference values for the polynomials in place of the sine; writes vectors/approx_sine.csv. Run: python approx_sine.py.

The best polynomial solves, with its peaks, the equations of Chebyshev's alternation: error +-E and slope 0 at every
inner peak. Newton's method solves for all unknowns at once, from a short range up to the wanted one. A grid then confirms that
no error between the peaks is larger, which proves that the polynomial is best. Largest errors are zeros of the slope, by bisection.
Columns: quantity (`coefficient` of phi^argument, `value` at phi = argument, the largest errors `absolute` and
`relative` for |phi| <= argument and where they are, `at` and `relative_at`), formula, the range of a best one
(phi_max), argument, value as hi + lo.
"""

import math
from fractions import Fraction
from functools import cache

import exact
import mpmath as mp
from exact import mpf, real

NAME = "approx_sine.csv"
HEADER = "quantity formula range argument value_hi value_lo".split()
DIGITS = 200


def polynomial(coefficients, phi, slope=False):
    """c_0 phi + c_1 phi^3 + ..., or its derivative."""
    weights = [(2 * k + 1 if slope else 1) * c for k, c in enumerate(coefficients)]
    return mp.polyval(weights[::-1], phi * phi) * (1 if slope else phi)


def error(coefficients, phi):
    return polynomial(coefficients, phi) - mp.sin(phi)


def slope(coefficients, phi):
    return polynomial(coefficients, phi, True) - mp.cos(phi)


def curvature(coefficients, phi):
    bent = [2 * k * (2 * k + 1) * c for k, c in enumerate(coefficients)]
    return mp.fsum(c * phi ** (2 * k - 1) for k, c in enumerate(bent) if k) + mp.sin(phi)


def newton(coefficients, peaks, level, end):
    """Alternation at the inner peaks and at the end of the range; the solution, to the working precision."""
    count = len(coefficients)
    for _ in range(60):
        points = [*peaks, end]
        size = 2 * count + 1
        matrix, right = mp.zeros(size), mp.zeros(size, 1)
        for i, phi in enumerate(points):
            sign = (-1) ** (count - i)
            for k in range(count):
                matrix[i, k] = phi ** (2 * k + 1)
            matrix[i, count] = -sign
            right[i] = sign * level - error(coefficients, phi)
            if i < count:
                matrix[i, count + 1 + i] = slope(coefficients, phi)
                for k in range(count):
                    matrix[count + 1 + i, k] = (2 * k + 1) * phi ** (2 * k)
                matrix[count + 1 + i, count + 1 + i] = curvature(coefficients, phi)
                right[count + 1 + i] = -slope(coefficients, phi)
        step = mp.lu_solve(matrix, right)
        coefficients = [c + step[k] for k, c in enumerate(coefficients)]
        level += step[count]
        peaks = [phi + step[count + 1 + i] for i, phi in enumerate(peaks)]
        if abs(step[count]) < abs(level) * mpf(10) ** -60:
            return coefficients, peaks, level
    raise ArithmeticError("Newton's method does not end")


@cache
def best(order, text):
    """Coefficients of the best polynomial, proved on a grid."""
    count = (order + 1) // 2
    with mp.workdps(DIGITS):
        end = real(Fraction(float.fromhex(text)))
        at = min(end, mpf(1) / 4)
        taylor = [(-1) ** k / mp.factorial(2 * k + 1) for k in range(count)]
        peaks = [at * mp.sin(mp.pi * (2 * i + 1) / (2 * (order + 2))) for i in range(count)]
        # Chebyshev's polynomial times the first term left out, for a start.
        first = (-1) ** count * at ** (order + 2) / mp.factorial(order + 2) / mpf(2) ** (order + 1)
        powers = mp.taylor(lambda x: mp.chebyt(order + 2, x), 0, order)
        start = [c - first * powers[2 * k + 1] * at ** -(2 * k + 1) for k, c in enumerate(taylor)]
        found = newton(start, peaks, -first, at)
        while at < end:
            wider = min(end, at * mpf(9) / 8)
            found = newton(found[0], [phi * wider / at for phi in found[1]], found[2], wider)
            at = wider
        coefficients, peaks, level = found
        assert all(0 < a < b for a, b in zip(peaks, [*peaks[1:], end], strict=True))
        steps = 40 * count
        assert all(
            abs(error(coefficients, end * i / steps)) <= abs(level) * (1 + mpf(10) ** -50) for i in range(1, steps + 1)
        ), (order, text)
        return coefficients


def coefficients_of(formula, text):
    name, _, order = formula.partition(":")
    if name == "best":
        return best(int(order), text)
    if name == "taylor":
        return [(-1) ** k / mp.factorial(2 * k + 1) for k in range((int(order) + 1) // 2)]
    return [mpf(1), mpf(-40) / 243, mpf(1) / 131][: int(name[-1])]


def largest(value, change, end, start):
    """The largest value on [0, end] and where: at the end, at a zero of the slope, or what it starts with."""
    steps = 240
    # Squares of sines are denser towards the end, as the peaks are.
    points = [end * mp.sin(mp.pi * i / (2 * steps)) for i in range(1, steps + 1)]
    candidates = [(start, mpf(0)), (abs(value(end)), end)]
    signs = [mp.sign(change(phi)) for phi in points]
    for i in range(steps - 1):
        if signs[i] * signs[i + 1] < 0:
            place = mp.findroot(change, (points[i], points[i + 1]), solver="anderson", tol=mpf(10) ** -(2 * DIGITS))
            candidates.append((abs(value(place)), place))
    return max(candidates)


@cache
def errors(formula, text, argument):
    """absolute, at, relative, relative_at for |phi| <= argument."""
    with mp.workdps(2 * DIGITS):
        c, end = coefficients_of(formula, text), real(argument)
        absolute, at = largest(lambda phi: error(c, phi), lambda phi: slope(c, phi), end, mpf(0))
        relative, relative_at = largest(
            lambda phi: error(c, phi) / mp.sin(phi),
            lambda phi: slope(c, phi) * mp.sin(phi) - error(c, phi) * mp.cos(phi),
            end,
            abs(c[0] - 1),
        )
        return {"absolute": absolute, "at": at, "relative": relative, "relative_at": relative_at}


def row(inputs):
    quantity, formula, text = (inputs[name] for name in HEADER[:3])
    argument = Fraction(float.fromhex(inputs["argument"]))
    with mp.workdps(DIGITS):
        if quantity == "coefficient":
            value = coefficients_of(formula, text)[int(argument) // 2]
        elif quantity == "value":
            value = polynomial(coefficients_of(formula, text), real(argument))
        else:
            value = errors(formula, text, argument)[quantity]
        return [*(inputs[name] for name in HEADER[:4]), *exact.hi_lo(value)]


def inputs():
    """Salas's two, Taylor's and the best ones; on ranges that are theirs and on others."""
    degrees = [math.radians(x) for x in (22, 70, 81, 90, 120, 150, 180)]
    cases = [(formula, "", degrees) for formula in ("salas-2", "salas-3")]
    cases += [(f"taylor:{n}", "", [0.01, 0.7, 2.0, math.pi]) for n in (1, 3, 5, 9, 15, 21, 45)]
    for end in (0.01, 1.0, 2 * math.pi / 3, math.pi, 4.0):
        cases += [(f"best:{n}", end.hex(), [x for x in (end, end / 2, 3.1) if x < 3.2]) for n in (3, 5, 9, 15, 21)]
    cases.append(("best:1", (2.0).hex(), [2.0, 3.0]))
    for formula, text, ends in cases:
        count = {"salas-2": 2, "salas-3": 3}.get(formula) or (int(formula.partition(":")[2]) + 1) // 2
        for k in range(count):
            yield {"quantity": "coefficient", "formula": formula, "range": text, "argument": float(2 * k + 1).hex()}
        for phi in (-0.5, 1e-300, 1e-9, 0.3, 1.7, 3.1, 30.0):
            yield {"quantity": "value", "formula": formula, "range": text, "argument": phi.hex()}
        for end in ends:
            for quantity in ("absolute", "at", "relative", "relative_at"):
                if quantity == "at" and text and end <= float.fromhex(text):
                    continue  # all peaks of a best one in its own range are as large
                yield {"quantity": quantity, "formula": formula, "range": text, "argument": end.hex()}


if __name__ == "__main__":
    exact.write(NAME, HEADER, (row(given) for given in inputs()))
