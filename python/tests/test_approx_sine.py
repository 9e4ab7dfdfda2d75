"""The polynomials for the sine: printed figures to the printed digit, the truth, what is best, refusals."""

import csv
import math
import pickle
from functools import cache
from math import radians
from pathlib import Path

import numpy as np
import pytest
from test_approx_period import printed

from libration import approx

ROOT = Path(__file__).resolve().parents[2]

# Salas 2 and 3: turning angle in degrees, largest absolute error, largest relative error in %.
FIGURES = [
    ("salas-2", 70, "0.01814", "1.931"),
    ("salas-2", 90, ".", "6.7"),
    ("salas-2", 120, ".", "32.8"),
    ("salas-3", 90, ".", "0.581"),
    ("salas-3", 120, "0.02372", "2.739"),
    ("salas-3", 150, "0.103", "."),
    ("salas-3", 180, "0.374", "."),
]


def wrong_figures(spoil=1.0):
    found = []
    for name, degrees, absolute, relative in FIGURES:
        error = approx.sine(name).error(radians(degrees))
        for value, text in ((error.absolute, absolute), (100 * error.relative, relative)):
            if text != "." and not printed(value * spoil, text):
                found.append((name, degrees, value, text))
    return found


def test_salas_to_the_printed_digit():
    assert wrong_figures() == []
    assert wrong_figures(1.01)
    assert approx.sine("salas-2").coefficients.tolist() == [1.0, -40 / 243]
    assert approx.sine("salas-3").coefficients.tolist() == [1.0, -40 / 243, 1 / 131]
    # At the ends of their ranges the error is largest; inside the first rises to 4.7e-5 at 22.1 degrees.
    assert approx.sine("salas-2").error(radians(70)).at == radians(70)
    inside = approx.sine("salas-2").error(radians(25.0))
    assert printed(inside.absolute, "4.7e-5") and printed(math.degrees(inside.at), "22.1")
    # The force of the first turns over at 81.5 degrees and vanishes at 141.2.
    slope = np.polynomial.Polynomial([1, 0, -3 * 40 / 243]).roots()[1]
    assert printed(math.degrees(slope), "81.5")
    assert printed(math.degrees(math.sqrt(243 / 40)), "141.2")
    assert abs(approx.sine("salas-2").value(math.sqrt(243 / 40))) < 1e-15
    # The second has no zero but 0: no top.
    assert np.all(approx.sine("salas-3").value(np.linspace(0.01, 100, 5000)) > 0)
    assert printed((40 / 243) ** 2 - 4 / 131, "-0.00344")


def test_the_truth():
    with (ROOT / "reference/vectors/approx_sine.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 849
    ulps = {"coefficient": 1, "value": 1, "absolute": 2, "relative": 2, "at": 64, "relative_at": 64}

    @cache
    def answer(name, text, quantity, argument):
        formula = approx.sine(name, **({"phi_max": float.fromhex(text)} if text else {}))
        return formula.error(argument) if quantity == "error" else getattr(formula, quantity)

    def measured(row):
        of, argument = (row["formula"], row["range"]), float.fromhex(row["argument"])
        match row["quantity"]:
            case "coefficient":
                return answer(*of, "coefficients", None)[int(argument) // 2]
            case "value":
                return answer(*of, "value", None)(argument)
            case quantity:
                return getattr(answer(*of, "error", argument), quantity)

    def worst(spoil):
        largest = 0.0
        for row in rows:
            hi, lo = (float.fromhex(row[f"value_{word}"]) for word in ("hi", "lo"))
            far = abs((measured(row) * spoil - hi) - lo) / (ulps[row["quantity"]] * math.ulp(hi))
            largest = max(largest, far if far == far else math.inf)
        return largest

    assert worst(1.0) <= 1.0
    assert worst(1 + 1e-15) > 1.0


@pytest.mark.parametrize("order", [1, 3, 5, 7, 9])
@pytest.mark.parametrize("phi_max", [radians(70), 2 * math.pi / 3, math.pi])
def test_no_polynomial_of_the_degree_is_better(order, phi_max):
    best = approx.sine(f"best:{order}", phi_max=phi_max)
    least = best.error(phi_max).absolute
    # Chebyshev: as many alternating peaks of one height as coefficients, and one.
    grid = np.linspace(0, phi_max, 20001)[1:]
    difference = best.value(grid) - np.sin(grid)
    peaks, sign = [], 0.0
    for value in difference:
        if value * sign > 0:
            peaks[-1] = max(peaks[-1], abs(value))
        else:
            peaks.append(abs(value))
            sign = value
    assert len(peaks) == len(best.coefficients) + 1
    assert np.allclose(peaks, least, rtol=1e-5, atol=3e-16)
    # Neither of Salas's is, nor Taylor's, nor one moved a little.
    for name in ("salas-2", "salas-3", f"taylor:{order}"):
        other = approx.sine(name)
        if len(other.coefficients) == len(best.coefficients):
            assert other.error(phi_max).absolute > 1.5 * least
    powers = grid[:, None] ** np.arange(1, order + 1, 2)
    for k in range(len(best.coefficients)):
        for step in (1e-3, -1e-3):
            moved = best.coefficients
            moved[k] += step
            assert np.max(np.abs(powers @ moved - np.sin(grid))) > least * (1 + 1e-6)


def test_errors_stay_right_where_doubles_have_none():
    # The first term that Taylor's leaves out; of which the best one takes all but 1/2^10.
    error = approx.sine("taylor:9").error(1e-3)
    assert math.isclose(error.absolute, 1e-33 / math.factorial(11), rel_tol=1e-7)
    best = approx.sine("best:9", phi_max=1e-3).error(1e-3)
    assert math.isclose(best.absolute, error.absolute / 2**10, rel_tol=1e-6)
    # Beyond pi the sine vanishes and the polynomial does not.
    beyond = approx.sine("salas-3").error(4.0)
    assert (beyond.relative, beyond.relative_at) == (math.inf, math.pi)


def test_ranges():
    for name in ("salas-2", "salas-3", "taylor:7"):
        formula = approx.sine(name)
        for bound in (1e-20, 1e-6, 0.01, 1.0):
            [(low, high)] = formula.ranges(bound)
            assert low == 0.0 < high < 2 * math.pi
            assert formula.error(high).absolute <= bound * (1 + 1e-15) < formula.error(high * (1 + 1e-9)).absolute
    best = approx.sine("best:5", phi_max=0.1)
    least = best.error(0.1).absolute
    assert best.ranges(0.99 * least)[0][1] < 0.05 and best.ranges(1.01 * least)[0][1] > 0.1
    assert approx.sine("taylor:99").ranges(1e-3) == ((0.0, 2 * math.pi),)


def test_every_entry_says_what_it_is():
    assert approx.sine.names[:3] == ("salas-2", "salas-3", "taylor:N") and len(approx.sine) == len(approx.sine.names)
    for formula in approx.sine:
        assert formula.formula and formula.source and formula.pattern in approx.sine.names
        again = pickle.loads(pickle.dumps(formula))
        assert again == formula and hash(again) == hash(formula) and repr(again) == repr(formula)
        assert np.array_equal(again.coefficients, formula.coefficients)
    assert repr(approx.sine("best:5", phi_max=2.0)) == "SineFormula('best:5', phi_max=2.0)"
    assert approx.sine("best:5", phi_max=2.0) != approx.sine("best:5", phi_max=2.5)
    assert isinstance(approx.sine("salas-2").value(1), float)
    assert approx.sine("salas-2").value(np.ones((2, 3))).shape == (2, 3)
    assert math.isnan(approx.sine("salas-2").value(math.inf)) and math.isnan(approx.sine("salas-2").value(math.nan))
    for formula in approx.sine:
        assert np.array_equal(formula.value(-np.arange(9.0)), -formula.value(np.arange(9.0)))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: approx.sine("taylor:4"), 'sine = "taylor:4": must be taylor:N with an odd N from 1 to 99'),
        (lambda: approx.sine("taylor:0"), 'sine = "taylor:0": must be taylor:N with a whole N from 1 to 99'),
        (lambda: approx.sine("best:1000000", phi_max=1.0), "must be best:N with a whole N from 1 to 21"),
        (lambda: approx.sine("best:5"), "phi_max = none: must be given for best:N"),
        (lambda: approx.sine("best:5", phi_max=0.0), "phi_max = 0.0: must be above 0 and at most 2 pi"),
        (lambda: approx.sine("salas-2", phi_max=1.0), "phi_max = 1.0: must be left out but for best:N"),
        (lambda: approx.sine("salas"), 'sine = "salas": must be one of salas-2, salas-3, '),
        (lambda: approx.sine("salas-2").error(-1), "phi_max = -1.0: must be above 0 and at most 2 pi"),
        (lambda: approx.sine("salas-2").ranges(math.nan), "bound = NaN: must be finite and at least 1e-30"),
    ],
)
def test_refusals_are_one_line(call, message):
    with pytest.raises(ValueError) as error:
        call()
    assert message in str(error.value) and "\n" not in str(error.value)
