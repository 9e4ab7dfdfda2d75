"""The formulas of the period: printed tables to the printed digit, the truth, ranges, refusals."""

import csv
import math
import pickle
from collections import Counter
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from libration import Pendulum, approx, complete_k

ROOT = Path(__file__).resolve().parents[2]

# The table as it was first worked out had three other last digits; mpmath says what stands here.
MISPRINTED = [("ganley-parwani", 170, 100, "-10.688"), ("agm:1", 179, 100, "-49.176"), ("agm:5", 150, 1, "-3e-25")]

# Errors in % against the exact period, at turning angles in degrees; "0" is what rounds to 0.0000.
DEGREES = (10, 30, 60, 90, 120, 150, 170, 179)
EXACT = "1.001907 1.017409 1.073182 1.180341 1.372881 1.762204 2.439363 3.901065"
PERCENT = {
    "linear": "-0.190 -1.711 -6.819 -15.279 -27.160 -43.253 -59.006 -74.366",
    "bernoulli": "-0.0003 -0.027 -0.433 -2.214 -7.191 -18.944 -36.450 -58.729",
    "series:4": "0 -0.0005 -0.031 -0.367 -2.173 -9.399 -25.074 -49.985",
    "kidd-fogg": "0.0001 0.0075 0.129 0.751 3.011 11.544 38.860 174.407",
    "molina": "0.0000 0.0035 0.061 0.355 1.436 5.577 18.842 79.327",
    "ganley-parwani": "0 -0.0005 -0.011 -0.078 -0.428 -2.442 -10.687 -35.118",
    "lima-arun": "0 0.0025 0.043 0.249 0.977 3.485 9.579 22.611",
    "agm:1": "-0.0001 -0.0075 -0.129 -0.743 -2.881 -9.841 -24.584 -49.175",
    "agm:2": "0 0 0 -0.0014 -0.022 -0.282 -2.255 -14.236",
    "cromer": "-11.67 -11.09 -9.23 -6.537 -3.574 -1.089 -0.141 -0.0016",
    "salas-26": "0 -0.0006 -0.042 -0.545 -3.537 -15.397 -35.983 -59.721",
    "salas-27": "0 0 -0.0002 -0.017 -0.423 -5.720 -24.503 -52.051",
    "salas-28": "0 0 0 -0.0005 -0.049 -2.091 -17.294 -46.847",
}

# Relative errors at 30, 60, 90, 120, 150, 170, 179 degrees, and where 0.1 % is passed first, in degrees: tenths are cut
# off, whole degrees rounded. "." is not printed.
RELATIVE = {
    "linear": "-1.7e-2 -6.8e-2 -1.5e-1 -2.7e-1 -4.3e-1 -5.9e-1 -7.4e-1 7.2",
    "bernoulli": "-2.7e-4 -4.3e-3 -2.2e-2 -7.2e-2 -1.9e-1 -3.6e-1 -5.9e-1 41.6",
    "series:4": "-4.9e-6 -3.1e-4 -3.7e-3 -2.2e-2 -9.4e-2 . . 72.6",
    "series:8": "-2.2e-9 -2.3e-6 -1.4e-4 -2.6e-3 -2.9e-2 . . 109.3",
    "denman": "2.4e-5 3.7e-4 1.7e-3 3.5e-3 -7.3e-3 -8.9e-2 -3.4e-1 77.7",
    "kidd-fogg": "7.5e-5 1.3e-3 7.5e-3 3.0e-2 1.2e-1 3.9e-1 1.7 56.4",
    "molina": "3.5e-5 6.1e-4 3.5e-3 1.4e-2 5.6e-2 1.9e-1 7.9e-1 67.4",
    "ganley-parwani": "-5.3e-6 -1.1e-4 -7.8e-4 -4.3e-3 -2.4e-2 -1.1e-1 -3.5e-1 94.2",
    "lima-arun": "2.5e-5 4.3e-4 2.5e-3 9.8e-3 3.5e-2 9.6e-2 2.3e-1 73.1",
    "agm:1": "-7.5e-5 -1.3e-3 -7.4e-3 -2.9e-2 -9.8e-2 -2.5e-1 -4.9e-1 56.4",
    "belendez": "-1.4e-9 -4.2e-7 -1.4e-5 -2.2e-4 -2.8e-3 -2.3e-2 -1.4e-1 138.0",
    "agm:3": "-5e-19 -4e-14 -5e-11 -1.2e-8 -2.0e-6 -1.3e-4 -6.3e-3 176.0",
    "agm:4": ". . -6e-22 -3e-17 -1e-12 -4e-9 -1e-5 179.9",
    "agm:5": ". . . . -2e-25 -5e-18 -3e-11 .",
    "cromer": "-1.1e-1 -9.2e-2 -6.5e-2 -3.6e-2 -1.1e-2 -1.4e-3 -1.6e-5 .",
    "chachiyo": "8.9e-6 1.3e-4 5.6e-4 1.3e-3 1.7e-3 8.1e-4 5.3e-5 .",
    "salas-26": ". . . . . . . 69",
    "salas-27": ". . . . . . . 106",
    "salas-28": "-6e-13 -1.2e-8 -5.1e-6 -4.9e-4 -2.1e-2 -1.7e-1 -4.7e-1 125",
}


def printed(value, text):
    """Whether a value, rounded to the digits of a text, is that text."""
    digits, _, power = text.partition("e")
    places = len(digits.partition(".")[2]) - int(power or 0)
    unit = 10.0**-places if text != "0" else 1e-4
    return abs(value - float(text)) <= 0.5 * unit * (1 + 1e-9)


def wrong_percent(of=lambda value: value):
    """The entries of both tables that are not what is printed, for errors that `of` may spoil."""
    found = []
    for name, line in PERCENT.items():
        values = 100 * of(approx.period(name).error(np.radians(DEGREES)))
        found += [
            (name, degrees, float(value), text)
            for degrees, value, text in zip(DEGREES, values, line.split(), strict=True)
            if not printed(value, text)
        ]
    return found


def wrong_relative(of=lambda value: value):
    found = []
    for name, line in RELATIVE.items():
        formula = approx.period(name)
        *texts, passed = line.split()
        values = of(formula.error(np.radians(DEGREES[1:])))
        found += [
            (name, degrees, float(value), text)
            for degrees, value, text in zip(DEGREES[1:], values, texts, strict=True)
            if text != "." and not printed(value, text)
        ]
        if passed != ".":
            end = math.degrees(formula.ranges(0.001)[0][1])
            cut = math.floor(10 * end) / 10 if "." in passed else end
            if not printed(cut, passed):
                found.append((name, "ranges", end, passed))
    return found


def test_the_table_in_percent_to_the_printed_digit():
    for value, text in zip(approx.period("exact").ratio(np.radians(DEGREES)), EXACT.split(), strict=True):
        assert printed(value, text), text
    assert wrong_percent() == []
    assert wrong_percent(lambda value: value * 1.02) and wrong_percent(np.negative)


def test_the_table_of_relative_errors_to_the_printed_digit():
    assert wrong_relative() == []
    assert wrong_relative(lambda value: value * 1.1) and wrong_relative(np.negative)


def test_the_digits_that_were_misprinted_are_not_ours():
    for name, degrees, factor, text in MISPRINTED:
        assert not printed(factor * approx.period(name).error(math.radians(degrees)), text)


def test_the_ranges_of_the_sources():
    def largest(name, low, high):
        return float(np.max(np.abs(approx.period(name).error(m=np.linspace(low, high, 4001)))))

    # Pade approximants in m on the ranges that Salas offers them for, in %.
    for name, low, high, text in (
        ("salas-26", 0, 1 / 3, "0.1161"),
        ("salas-26", -1 / 3, 0, "0.0454"),
        ("salas-27", 0, 3 / 4, "0.4230"),
        ("salas-27", -3 / 4, 0, "0.00679"),
    ):
        assert printed(100 * largest(name, low, high), text), (name, low, high)
    salas_28 = approx.period("salas-28")
    for m, text in ((0.75, "-0.049"), (0.9, "-0.94"), (0.95, "-3.3"), (0.99, "-15"), (0.999, "-33"), (-1.0, "0.00059")):
        assert printed(100 * salas_28.error(m=m), text), m
    assert salas_28.error(m=1.0) == -1.0
    # How far it is good to 1 %, and to 3, 6 and 12 digits.
    for bound, text in ((1e-2, "0.9029"), (1e-3, "0.7894"), (1e-6, "0.4206"), (1e-12, "0.0721")):
        [(_, end)] = salas_28.ranges(bound)
        assert printed(math.sin(end / 2) ** 2, text), bound
    for n, degrees in ((26, "70.5"), (27, "120.0"), (28, "180.0")):
        assert printed(math.degrees(approx.period(f"salas-{n}").stated_range[1]), degrees)
    # Chachiyo's is within 0.17 % everywhere; Cromer's is meant for the top.
    assert 0.0016 < np.max(np.abs(approx.period("chachiyo").error(np.linspace(0, math.pi, 20001)))) < 0.00175
    [(low, high)] = approx.period("cromer").ranges(0.001)
    assert math.degrees(low) > 171 and high == math.pi
    # Ganley's own words: to 0.001 up to 100 degrees, to 5 % up to 160.
    [(_, end)] = approx.period("ganley-parwani").ranges(0.05)
    assert 160 < math.degrees(end) < 161


def test_ranges_are_where_the_error_keeps_the_bound():
    rng = np.random.default_rng(6)
    near = 10.0 ** rng.uniform(-9, 0, 2000)
    angles = np.concatenate([near, math.pi - near, rng.uniform(0, math.pi, 2000)])
    for formula in approx.period:
        errors = np.abs(formula.error(angles))
        for bound in (0.1, 1e-2, 1.7e-3, 1e-4, 1e-8, 1e-14, 1e-20):
            ranges = formula.ranges(bound)
            inside = np.zeros(angles.shape, bool)
            for low, high in ranges:
                inside |= (low <= angles) & (angles <= high)
                ends = np.array([end for end in (low, high) if 0 < end < math.pi])
                assert np.all(np.abs(formula.error(ends)) <= bound)
            assert np.array_equal(inside, errors <= bound), (formula.name, bound)
            assert all(a[1] < b[0] for a, b in pairwise(ranges))


def test_the_truth():
    with (ROOT / "reference/vectors/approx_period.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    # Every formula on the same arguments, however many formulas there are.
    counts = Counter(row["formula"] for row in rows)
    assert set(counts.values()) == {75} and {row["given"] for row in rows} == {"theta_max", "m", "mc"}
    assert {name.partition(":")[0] for name in counts} == {name.partition(":")[0] for name in approx.period.names}

    def worst(spoil):
        largest = 0.0
        for row in rows:
            formula = approx.period(row["formula"])
            argument = {row["given"]: float.fromhex(row["argument"])}
            for got, name, floor in (
                (formula.ratio(**argument), "ratio", 0.0),
                (formula.error(**argument), "error", 1.1e-44),
            ):
                hi, lo = (float.fromhex(row[f"{name}_{word}"]) for word in ("hi", "lo"))
                if math.isfinite(hi):
                    far = abs((got * spoil - hi) - lo) / (math.ulp(hi) + floor)
                else:
                    far = 0.0 if got == hi or (math.isnan(got) and math.isnan(hi)) else math.inf
                largest = max(largest, far if far == far else math.inf)
        return largest

    assert worst(1.0) <= 1.0
    assert worst(1 + 1e-15) > 1.0


def test_a_pendulum_has_the_period_of_its_swing():
    exact, salas = approx.period("exact"), approx.period("salas-26")
    for pendulum in (Pendulum(3.0), Pendulum(0.5, 1.7, length=0.3), Pendulum(1e-170), Pendulum(3.0, omega2=-2.0)):
        assert math.isclose(exact.period(pendulum), pendulum.period, rel_tol=1e-15)
        assert salas.quarter_period(pendulum) == salas.period(pendulum) / 4
        linear = approx.period("linear").period(pendulum)
        assert math.isclose(linear * pendulum.omega0, 2 * math.pi, rel_tol=1e-15)
    assert math.isnan(exact.period(Pendulum(0.0, 2.1)))
    assert exact.period(Pendulum(0.0, 2.0)) == math.inf
    assert salas.period(Pendulum(0.0, 2.0)) == pytest.approx(2 * math.pi * 11 / 7)
    # The fourth of Salas, (25), is the exact quarter period K.
    assert math.isclose(exact.quarter_period(Pendulum(1.5)), complete_k(m=math.sin(0.75) ** 2), rel_tol=1e-15)


def test_every_entry_says_what_it_is():
    names = [formula.name for formula in approx.period]
    assert len(names) == len(approx.period) == len(set(names)) == len(approx.period.names)
    assert approx.period.names[:3] == ("linear", "bernoulli", "series:N")
    for formula in approx.period:
        assert formula.formula and formula.source and formula.pattern in approx.period.names
        assert formula == approx.period(formula.name) == pickle.loads(pickle.dumps(formula))
        assert hash(formula) == hash(approx.period(formula.name))
        assert math.isnan(formula.error(m=-0.5)) == ("m < 0" in formula.undefined)
        if formula.stated_range:
            low, high = formula.stated_range
            assert 0 <= low < high <= math.pi and formula.stated
    assert repr(approx.period("agm:3")) == "PeriodFormula('agm:3')"
    with pytest.raises(AttributeError):
        approx.period("linear").name = "other"


def test_shapes_and_what_is_outside():
    formula = approx.period("denman")
    assert isinstance(formula.ratio(1), float)
    grid = np.linspace(0, 3, 12).reshape(3, 4)
    assert formula.ratio(grid.T).shape == (4, 3) and formula.error([]).shape == (0,)
    assert formula.ratio(grid)[1, 2] == formula.ratio(grid[1, 2])
    for theta_max in (-0.1, 3.15, math.nan, math.inf):
        assert math.isnan(formula.ratio(theta_max)) and math.isnan(formula.error(theta_max))
    for m in (1.1, math.nan, -math.inf):
        assert math.isnan(approx.period("exact").ratio(m=m))
    # 180 degrees as a double is not the top: there every formula has a value.
    assert all(math.isfinite(formula.error(math.pi)) for formula in approx.period)
    assert approx.period("exact").ratio(m=1.0) == math.inf
    assert [approx.period(name).error(m=1.0) for name in ("agm:3", "bernoulli")] == [-1.0, -1.0]
    assert math.isnan(approx.period("kidd-fogg").error(m=1.0))


def test_the_complement_is_the_same_swing_and_has_the_digits_next_to_the_top():
    for formula in approx.period:
        for answer in (formula.ratio, formula.error):
            for m in (0.0, 0.25, 0.75, -3.0):
                assert np.array_equal(answer(m=m), answer(mc=1 - m), equal_nan=True)
    # K = L + (L - 1) mc/4 with L = ln(4/sqrt(mc)), next to the top.
    leading = math.log(4e15)
    assert approx.period("exact").ratio(mc=1e-30) == pytest.approx(2 / math.pi * leading, rel=1e-14)
    assert math.isnan(approx.period("exact").ratio(mc=-1e-300))
    assert approx.period("cromer").error(mc=1e-30) == pytest.approx(-(leading - 1) / (4 * leading) * 1e-30, rel=1e-12)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: approx.period("agm:0"), 'period = "agm:0": must be agm:N with a whole N from 1 to 8'),
        (lambda: approx.period("series:3"), 'period = "series:3": must be series:N with an even N from 2 to 200'),
        (lambda: approx.period("series:1000000"), "must be series:N with a whole N from 2 to 200"),
        (lambda: approx.period("belendes"), 'period = "belendes": must be one of belendez, '),
        (lambda: approx.period("exact").ratio(), "exactly one of theta_max, m, mc must be given, not none"),
        (
            lambda: approx.period("exact").error(1.0, m=0.2),
            "exactly one of theta_max, m, mc must be given, not theta_max and m",
        ),
        (lambda: approx.period("exact").ranges(0), "bound = 0.0: must be finite and at least 1e-30"),
        (lambda: approx.period("exact").ranges([0.1]), "bound = [0.1]: must be one real number"),
    ],
)
def test_refusals_are_one_line(call, message):
    with pytest.raises(ValueError) as error:
        call()
    assert message in str(error.value) and "\n" not in str(error.value)
