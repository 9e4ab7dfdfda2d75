"""The registry of approximations of the angle: entries, refusals, errors, ranges, and the door itself."""

import csv
import math
import pickle
from pathlib import Path

import numpy as np
import pytest

from libration import Pendulum, approx
from libration.approx import AngleApproximation, AngleError, AngleFormula

ROOT = Path(__file__).resolve().parents[2]


def error(name, pendulum, periods=1):
    return approx.angle(name).of(pendulum).error(periods)


# ------------------------------------------------------------------------------------------------ the registry


def test_every_entry_says_what_it_is():
    names = [formula.name for formula in approx.angle]
    with (ROOT / "reference/vectors/approx_angle.csv").open(newline="") as file:
        true = {row["formula"].partition(":")[0] for row in csv.DictReader(file)}
    assert {name.partition(":")[0] for name in names} == true
    assert " ".join(names[:4]) == "linear harmonic fourier:4 fourier-theta:4"
    assert [formula.pattern for formula in approx.angle] == list(approx.angle.names)
    assert len(approx.angle) == len(names) == len(set(names))
    for formula in approx.angle:
        assert formula.formula
        assert formula.source
        assert formula.stated_range is None or formula.stated
        made = formula.of(Pendulum(0.5, 0.1, omega0=2.0))
        assert abs(made.difference(0.2)) < 2e-3
        assert 0 < made.error().difference < 200


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("fourier:0", 'formula = "fourier:0": must be fourier:N with a whole N from 1 to 500'),
        ("fourier:1000000", 'formula = "fourier:1000000": must be fourier:N with a whole N from 1 to 500'),
        ("taylor", 'formula = "taylor": must be taylor:N with a whole N from 1 to 200'),
        ("linear:2", 'formula = "linear:2": must be linear without a number'),
        ("fourrier:4", 'formula = "fourrier:4": must be one of fourier:N, '),
        ("harmonics", 'formula = "harmonics": must be one of harmonic, '),
    ],
)
def test_names_are_refused_in_one_line(name, line):
    with pytest.raises(ValueError) as refusal:
        approx.angle(name)
    assert str(refusal.value).startswith(line)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("name", "pendulum", "line"),
    [
        ("harmonic", Pendulum(0.0, 3.0), "regime = rotation: must be libration for harmonic"),
        ("fourier:2", Pendulum(0.0, 2.0), "regime = separatrix: must be libration for fourier:2"),
        ("small-m-bounded", Pendulum(1.0, 2.0), "regime = rotation: must be libration for small-m-bounded"),
        ("fourier-theta:1", Pendulum(0, 2), "regime = separatrix: must be libration or rotation for fourier-theta:1"),
        ("cubic", Pendulum(1, omega2=-4), "omega2 = -4.0: must be positive for cubic, which is about theta = 0"),
        ("small-m", Pendulum(1, 1, omega0=0), "omega0 = 0.0: must be large beside the velocity for small-m"),
    ],
)
def test_motions_are_refused_in_one_line(name, pendulum, line):
    with pytest.raises(ValueError) as refusal:
        approx.angle(name).of(pendulum)
    assert str(refusal.value) == line


def test_searches_are_refused_in_one_line():
    made = approx.angle("linear").of(Pendulum(1.0))
    for periods in (0, -1.0, 10_001, math.nan):
        with pytest.raises(ValueError, match=r"periods = .*: must be above 0 and at most 10000$"):
            made.error(periods)
    with pytest.raises(ValueError, match=r"bound = 0\.0: must be finite and positive"):
        approx.angle("linear").ranges(0)
    with pytest.raises(ValueError, match="regime = separatrix: must be libration or rotation"):
        approx.angle("linear").of(Pendulum(0.0, 2.0)).error()


def test_at_rest_and_without_a_force_every_formula_is_exact():
    for formula in approx.angle:
        made = formula.of(Pendulum(0.0))
        assert (made.theta(3.0), made.difference(3.0), *made.error(5)[:3]) == (0.0, 0.0, 0.0, 0.0, 0.0)
        assert math.isnan(made.error().undefined_from)
    free = Pendulum(1.0, 2.0, omega0=0.0)
    for name in ("linear", "fourier-theta:2", "cubic", "cubic-quintic", "taylor:3"):
        assert approx.angle(name).of(free).theta([0.0, 1.5]).tolist() == [1.0, 4.0]


def test_the_top_of_the_doubles_is_a_libration_like_any_other():
    pendulum = Pendulum(math.pi)
    assert error("fourier-theta:4", pendulum).difference > 0.5
    assert error("fourier:3", pendulum).undefined_from == 0.0
    assert math.isinf(error("cubic", pendulum).difference)
    assert approx.angle("trigonometric").of(pendulum).theta(0.0) == math.pi


# ------------------------------------------------------------------------------------------------ errors and ranges


def brute(made, periods):
    """The largest |difference| on a grid, and on one a thousand times as fine around the largest one there."""
    end = periods * made.pendulum.period
    t = np.linspace(0, end, 40_001)
    top = t[np.nanargmax(np.abs(made.difference(t)))]
    t = np.linspace(max(0.0, top - end / 40_000), min(end, top + end / 40_000), 2_001)
    return np.nanmax(np.abs(made.difference(t)))


@pytest.mark.parametrize("formula", list(approx.angle), ids=lambda formula: formula.name)
@pytest.mark.parametrize("pendulum", [Pendulum(1.2), Pendulum(-2.0, 0.3, omega0=3.0), Pendulum(3.1, 0.01)], ids=repr)
def test_the_largest_error_is_that_of_a_fine_grid(formula, pendulum):
    made = formula.of(pendulum)
    found = made.error(3)
    if math.isinf(found.difference):
        assert np.isnan(made.theta(found.t * (1 + 1e-9)))
        return
    grid = brute(made, 3)
    # A grid misses what is next to the end of an arcsine.
    near = 0.05 if not math.isnan(found.undefined_from) else 1e-9
    assert grid * (1 - 1e-12) <= found.difference <= grid * (1 + near)
    assert abs(made.difference(found.t)) == found.difference
    assert found.relative == found.difference / pendulum.theta_max


def test_errors_of_rotations_count_turns():
    made = approx.angle("fourier-theta:2").of(Pendulum(0.3, -3.0))
    found = made.error()
    assert math.isnan(found.relative)
    assert found.difference == pytest.approx(brute(made, 1), rel=1e-6)


@pytest.mark.parametrize(
    ("name", "bound", "periods"),
    [("linear", 0.01, 1), ("harmonic", 0.05, 1), ("fourier:3", 0.01, 1), ("trigonometric", 0.01, 10)],
)
def test_ranges_end_where_the_error_does(name, bound, periods):
    found = approx.angle(name).ranges(bound, periods)
    assert found[0][0] == 0.0
    for low, high in found:
        assert 0 <= low < high <= math.pi
        for end, inward in ((low, 1), (high, -1)):
            if 0 < end < math.pi:
                assert error(name, Pendulum(end + inward * 1e-6), periods).relative <= bound * (1 + 1e-5)
                beyond = error(name, Pendulum(end - inward * 1e-6), periods)
                assert beyond.relative > bound * (1 - 1e-5) or not math.isnan(beyond.undefined_from)


def test_ranges_of_everything_and_of_nothing():
    assert approx.angle("linear").ranges(3.0) == ((0.0, math.pi),)
    assert approx.angle("taylor:2").ranges(0.01) == ()


# ------------------------------------------------------------------------------------------------ the door


def truth(row, name):
    return float.fromhex(row[f"{name}_hi"])


def door_errors(spoil=1.0):
    """How many answers differ from the truth by more than 1e-9 of their scale; the core's tests hold the last digits."""
    with (ROOT / "reference/vectors/approx_angle.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) > 500
    wrong = 0
    for row in rows:
        theta0, velocity0, omega2, t = (float.fromhex(row[name]) for name in ("theta0", "velocity0", "omega2", "t"))
        made = approx.angle(row["formula"]).of(Pendulum(theta0, velocity0, omega2=omega2))
        got, expected = made.theta(t) * spoil, truth(row, "theta")
        allowed = 1e-9 * float(row["scale"]) + 2.0**-50 * float(row["cond_theta"])
        wrong += not (abs(got - expected) <= allowed or (math.isnan(got) and math.isnan(expected)))
    return wrong


def test_truth():
    assert door_errors() == 0


def test_a_spoiled_angle_is_found():
    assert door_errors(1 + 1e-6) > 100


def test_shapes_and_types():
    made = approx.angle("harmonic").of(Pendulum(1.0))
    t = np.arange(12.0).reshape(3, 4)[:, ::2]
    for method in (made.theta, made.difference):
        assert method(t).shape == (3, 2)
        assert method(t)[1, 1] == method(t[1, 1])
        assert type(method(1)) is np.float64
        assert method([]).shape == (0,)
        assert np.isnan(method([math.nan, math.inf, 1e300])).all()


def test_formulas_and_approximations_are_values():
    formula = approx.angle("fourier:4")
    made = formula.of(Pendulum(1.0, length=2.0))
    assert formula == AngleFormula("fourier:04")
    assert formula != approx.angle("fourier:5")
    assert len({formula, AngleFormula("fourier:4")}) == 1
    written = eval(repr(made), {"AngleFormula": AngleFormula, "Pendulum": Pendulum})
    for twin in (pickle.loads(pickle.dumps(made)), written):
        assert isinstance(twin, AngleApproximation)
        assert twin.theta(1.5) == made.theta(1.5)
        assert (twin.formula, twin.pendulum) == (formula, made.pendulum)
    assert isinstance(made.error(), AngleError)
    with pytest.raises(AttributeError, match="does not change"):
        formula.name = "linear"


def test_the_linear_period_is_that_of_small_swings():
    for pendulum in (Pendulum(3.0, -0.7, length=0.3), Pendulum(1e200, 1e300, omega0=3.0), Pendulum(1e-300, omega2=2.0)):
        assert approx.angle("linear").of(pendulum).period == pytest.approx(2 * math.pi / pendulum.omega0, rel=1e-15)


def test_periods():
    pendulum = Pendulum(2.0, 0.1)
    for formula in approx.angle:
        period = formula.of(pendulum).period
        if formula.pattern in ("small-m", "taylor:N"):
            assert math.isnan(period)
        elif formula.pattern in ("harmonic", "fourier:N", "fourier-theta:N", "small-m-bounded"):
            assert period == pendulum.period
        else:
            t = np.array([0.3, 1.7])
            made = formula.of(pendulum)
            assert np.allclose(made.theta(t), made.theta(t + period), rtol=1e-12)
    assert math.isnan(approx.angle("cubic").of(Pendulum(2.6)).period)


def test_errors_against_the_turning_angle():
    angles = np.radians([[60.0, 90.0], [170.0, 0.0], [180.1, math.nan]])
    found = approx.angle("fourier:2").error(angles)
    assert found.shape == (3, 2)
    assert found[0, 1] == error("fourier:2", Pendulum(angles[0, 1])).relative
    assert np.isfinite(found).tolist() == [[True, True], [False, False], [False, False]]
    assert isinstance(approx.angle("harmonic").error(1.0, periods=3), np.float64)
