"""From measurements to g: the values, their uncertainties, verdicts, what is taken and what is refused."""

import math

import numpy as np
import pandas
import pytest

import libration
from libration import DampedPendulum, Estimate, Fit, Friction, fit

T = np.linspace(0.0, 24.0, 600)


def record(theta0=1.2217304763960306, length=0.8, sigma=0.01, seed=3, t=T, **friction):
    """A release from rest, from 70 degrees, where g = 9.81, with noise."""
    motion = DampedPendulum(theta0, length=length, gravity=9.81, friction=Friction(**(friction or {"linear": 0.02})))
    return motion.theta(t) + np.random.default_rng(seed).normal(0.0, sigma, t.size)


@pytest.fixture(scope="module")
def found():
    return fit(T, record(), length=(0.8, 0.001))


def test_g_with_its_budget(found):
    assert isinstance(found, Fit)
    assert found.model == "linear"
    assert abs(found.g.value - 9.81) < 3 * found.g.statistical
    assert found.g.u == pytest.approx(0.0124, abs=0.0006)
    assert found.g.calibration == pytest.approx(9.81 * 0.001 / 0.8, rel=1e-3)
    assert found.g.statistical == pytest.approx(0.002, abs=0.001)
    assert found.friction["linear"].value == pytest.approx(0.02, abs=5 * found.friction["linear"].u)
    assert found.stands
    assert found.sentence().startswith("g = 9.8")


@pytest.mark.parametrize("seed", range(12))
def test_g_is_right_within_its_uncertainty(seed):
    each = fit(T, record(seed=seed), length=0.8, model="linear").g
    assert abs(each.value - 9.81) < 4 * each.u
    assert 0.0005 < each.u < 0.005


def test_length_from_gravity():
    found = fit(T, record(), gravity=(9.81, 0.0))
    assert abs(found.length.value - 0.8) < 4 * found.length.u
    assert found.g.value == 9.81
    assert found.sentence().startswith("length = 0.80")


def test_omega0_alone():
    found = fit(T, record())
    assert found.g is None and found.length is None
    assert found.omega0.value == pytest.approx(math.sqrt(9.81 / 0.8), abs=4 * found.omega0.u)
    assert found.sentence().startswith("omega0 = ")


def test_dry_friction_is_found():
    found = fit(T, record(linear=0.01, dry=0.05))
    assert found.model in ("dry", "presliding")
    assert found.friction["dry"].value == pytest.approx(0.05, abs=0.01)


def test_a_result_hands_out_all_of_it(found):
    told = found.to_dict()
    names = {"model", "rms_deg", "omega0", "g", "length", "offset_deg", "friction", "verdicts", "dropped", "window"}
    assert names <= set(told)
    assert set(told["friction"]["linear"]) == {"value", "u", "expanded", "statistical", "model", "calibration"}
    assert told["rms_deg"] == pytest.approx(math.degrees(found.rms))
    assert found.rms == pytest.approx(0.01, rel=0.1)
    assert found.t.shape == found.measured.shape == found.residuals.shape
    assert found.window == (0.0, 24.0)
    assert found.swing == pytest.approx(math.radians(70), abs=0.01)
    again = found.motion().theta(found.t - found.state_time) + found.offset.value
    assert np.abs(again - (found.measured - found.residuals)).max() < 1e-6
    assert found.verdicts == told["verdicts"]
    assert found.scale is None and found.understood == [] and found.dropped == []
    assert "g " in str(found) and repr(found).startswith("<Fit of arrays: linear")


def test_estimates_are_rounded_to_their_uncertainty():
    assert str(Estimate(9.8104, 0.0123)) == "9.810 ± 0.012"
    assert str(Estimate(9.8104, 0.0996)) == "9.81 ± 0.10"
    assert str(Estimate(1234.5, 67.8)) == "1234 ± 68"
    assert str(Estimate(0.8, 0.0)) == "0.8"
    assert str(Estimate(-1e-6, 0.0088)) == "0.0000 ± 0.0088"
    assert str(Estimate(-0.0001, 0.0088)) == "-0.0001 ± 0.0088"
    assert str(Estimate(math.nan, 0.1)) == "not known"
    assert Estimate(1.0, 0.25).expanded == 0.5


def test_uncertainties_are_handed_out():
    made = Estimate(9.81, 0.012).ufloat()
    assert (made.nominal_value, made.std_dev) == (9.81, 0.012)


def test_values_of_uncertainties_are_taken():
    class Length:
        nominal_value, std_dev = 0.8, 0.001

    assert fit(T, record(), length=Length(), model="linear").g.u == pytest.approx(0.0124, abs=0.0006)


def test_arrays_pairs_and_tables_agree(found):
    theta = record()
    pair = fit((T, theta), length=(0.8, 0.001))
    assert pair.g == found.g
    frame = pandas.DataFrame({"time [s]": T, "theta [rad]": theta})
    table = fit(frame, length=(0.8, 0.001))
    assert table.g.value == pytest.approx(found.g.value, rel=1e-9)
    assert table.understood
    named = fit(frame.set_axis(["a", "b"], axis=1), columns={"time": "a", "angle": "b"}, units={"angle": "rad"})
    assert named.omega0.value == pytest.approx(found.omega0.value, rel=1e-9)


def test_velocities():
    motion = DampedPendulum(1.0, length=0.8, gravity=9.81, friction=Friction(linear=0.02))
    values = motion.velocity(T) + np.random.default_rng(1).normal(0.0, 0.02, T.size)
    found = fit(T, values, quantity="velocity", length=0.8)
    assert found.g.value == pytest.approx(9.81, abs=4 * found.g.u)


def test_a_table_of_periods():
    swings = np.radians([10, 25, 40, 55, 70, 85])
    periods = [libration.Pendulum(each, length=0.8, gravity=9.81).period for each in swings]
    noisy = np.array(periods) + np.array([1, -1, 2, -2, 1, -1]) * 1e-4
    found = fit(swings, noisy, quantity="swings", length=0.8)
    assert found.g.value == pytest.approx(9.81, abs=0.01)
    assert found.offset is None and math.isclose(found.swing, swings[-1], rel_tol=0.05)


def test_a_linear_cosine_is_not_quoted():
    theta = 0.6 * np.exp(-0.01 * T) * np.cos(3.5 * T)
    found = fit(T, theta, length=0.8)
    assert not found.stands
    assert "linear cosine" in found.verdicts[0]
    assert found.sentence().startswith("nothing: ")
    assert "DO NOT QUOTE" in str(found)


def test_a_linear_cosine_with_noise_is_not_quoted():
    theta = 1.0 * np.exp(-0.01 * T) * np.cos(3.5 * T) + np.random.default_rng(0).normal(0.0, 0.005, T.size)
    found = fit(T, theta, length=0.8)
    assert not found.stands
    assert "does not depend on the swing" in found.verdicts[0]


def test_a_wrong_length_is_flagged():
    found = fit(T, record(), length=(0.98, 0.001))
    assert any("the stated length is off" in each for each in found.verdicts)


REFUSED = [
    (dict(length=0.8, gravity=9.8), "give one of the two"),
    (dict(length=-1.0), "length = -1"),
    (dict(length=(1.0, -0.1)), "uncertainty of length = -0.1"),
    (dict(length=(1.0,)), "must be a number or"),
    (dict(length="1 m"), "length = '1 m'"),
    (dict(model="cubic"), "model = 'cubic': must be one of auto, none"),
    (dict(quantity="speed"), "quantity = 'speed': must be one of angle"),
    (dict(window=(3.0, 2.0)), "window = 3 to 2"),
    (dict(window=(1.0, 1.05)), "in the window"),
    (dict(rate=10.0), "not for arrays"),
    (dict(columns={"angle": "a"}), "not for arrays"),
    (dict(scale_u=-1.0), "scale_u = -1"),
    (dict(run="all"), "is for fit_together"),
    (dict(bob=(-0.01, 0.1), length=1.0), "bob radius = -0.01"),
    (dict(bob=(0.01, 0.1, 0.2)), "must be a radius in m"),
    (dict(wire=0.001, length=1.0), "without a bob mass"),
    (dict(bob=(0.1, 1e-4), length=1.0), "a bob that floats"),
    (dict(bob=0.01, parts=[("point", 1.0, 1.0, 0.0)]), "parts and a bob"),
    (dict(fluid="oil"), "fluid = 'oil': must be air, water"),
    (dict(without="friction"), "without = 'friction': must be one of bob size"),
    (dict(monte_carlo=10), "monte_carlo = 10: must be a whole number, 0 or from 100"),
    (dict(bootstrap=2.5), "bootstrap = 2.5: must be a whole number"),
    (dict(parts=3), "parts = 3: must be a sequence of"),
    (dict(parts="rod"), "parts = 'rod': must be a sequence of"),
    (dict(without=3), "without = 3: must be one of bob size"),
    (dict(columns="theta"), "columns = 'theta': must be a mapping"),
    (dict(units=["deg"]), r"units = \['deg'\]: must be a mapping"),
    (dict(columns={"theta": "a"}), "columns: 'theta' must be one of time, angle"),
    (dict(columns={"angle": ""}), "columns: angle = '' must be the name of a column"),
    (dict(units={"angle": 3}), "units: angle = 3 must be the name of a unit"),
    (dict(run="first"), "run = 'first': must be a whole number"),
    (dict(run=1.5), "run = 1.5: must be a whole number"),
    (dict(run=0), "run = 0: must be a whole number from 1"),
]


@pytest.mark.parametrize(("options", "message"), REFUSED)
def test_bad_options(options, message):
    with pytest.raises(ValueError, match=message) as refusal:
        fit(T, record(), **options)
    assert "\n" not in str(refusal.value)


UNFIT = [
    (T, np.full(600, 0.3), "every value is 0.3"),
    (T, np.full(600, np.nan), "0 rows with numbers"),
    (T[:1], [0.3], "at least 8"),
    (T[::-1], record(), "the time falls"),
    (np.zeros(600), record(), "every time is 0"),
    (T, record()[:5], "600 and 5 elements"),
    (T.reshape(2, 300), record(), "one dimension"),
]


@pytest.mark.parametrize(("t", "theta", "message"), UNFIT)
def test_no_record(t, theta, message):
    with pytest.raises(ValueError, match=message):
        fit(t, theta)


def test_no_source():
    with pytest.raises(TypeError, match="must be a path, a data frame, or times"):
        fit(3.0)
    with pytest.raises(TypeError, match="must be real numbers"):
        fit(["a"], ["b"])
    with pytest.raises(TypeError, match="fit_together takes several"):
        fit(["a.csv", "b.csv"])
    with pytest.raises(FileNotFoundError):
        fit("no such file.csv")


@pytest.mark.parametrize(
    ("t", "words"),
    [
        (np.arange("2026-01-01", "2026-01-11", dtype="M8[D]"), r"t: holds dates; must be real numbers, \(t - t\[0\]\)"),
        (np.arange(10).astype("m8[s]"), "t: holds durations; must be real numbers, t / np.timedelta64"),
        (np.arange(10.0) + 0j, "t = an array of shape"),
    ],
)
def test_what_is_no_number_of_seconds(t, words):
    with pytest.raises(TypeError, match=words):
        fit(t, np.zeros(10))


def test_a_mask_leaves_out_what_it_covers():
    covered = np.zeros(T.size, dtype=bool)
    covered[::7] = True
    theta = np.ma.masked_array(np.where(covered, 1e3, record()), mask=covered)
    found = fit(T, theta, model="linear")
    assert found.dropped[0]["count"] == covered.sum()
    again = fit(T, np.where(covered, np.nan, record()), model="linear")
    assert found.omega0 == again.omega0


def test_rows_without_numbers_are_listed():
    theta = record()
    theta[[5, 9]] = np.nan
    found = fit(T, theta, length=0.8)
    assert found.dropped == [{"reason": "no number", "count": 2, "rows": [5, 9]}]
    assert "2 rows: no number (rows 6, 10)" in str(found)


def test_a_rigid_pendulum_of_parts():
    # A uniform rod from its end has two thirds of its length.
    rod = ("rod", (0.3, 0.001), (0.6, 0.001), (1.2, 0.001))
    found = fit(T, record(), parts=[rod], model="linear")
    assert found.length.value == pytest.approx(0.8)
    assert found.g.value == pytest.approx(9.81, abs=4 * found.g.u)
    assert found.g.calibration > 0.005
    with pytest.raises(ValueError, match="must be one of rod, ball, disc, point"):
        fit(T, record(), parts=[("cube", 1.0, 1.0, 1.0)])
    with pytest.raises(ValueError, match=r"must be \(shape, mass, distance, size\)"):
        fit(T, record(), parts=[("rod", 1.0)])


def test_corrections_of_a_bob():
    known = dict(length=0.8, model="linear", bob=(0.02, 0.0027), wire=1e-4)
    t, theta = T, record()
    ideal, with_all = fit(t, theta, length=0.8, model="linear"), fit(t, theta, **known)
    rows = {row["name"]: row for row in with_all.to_dict()["corrections"]}
    # Nelson and Olsson: r^2/5L^2 and half the ratio of the densities; the wire by its twelfth.
    assert rows["bob size"]["relative_period"] == pytest.approx(0.02**2 / (5 * 0.8**2), rel=1e-3)
    density = 0.0027 / (4 / 3 * math.pi * 0.02**3)
    assert rows["buoyancy"]["relative_period"] == pytest.approx(0.5 * 1.204 / density, rel=0.05)
    assert rows["wire mass"]["relative_period"] == pytest.approx(-(1e-4 / 0.0027) / 12, rel=0.05)
    product = math.prod((1 + row["relative_period"]) ** 2 for row in rows.values())
    assert with_all.g.value == pytest.approx(ideal.g.value * product, rel=1e-9)
    assert "buoyancy" in str(with_all) and "corrected: yes" in str(with_all)
    names = ["bob size", "wire mass", "buoyancy", "added mass"]
    without = fit(t, theta, **known, without=names)
    assert without.g.value == pytest.approx(ideal.g.value, rel=1e-12)
    assert "corrected: no" in str(without)
    # In water the bob is slower by far more.
    water = fit(t, theta, length=0.8, model="linear", bob=(0.02, 0.1), fluid="water")
    assert water.g.value > 1.2 * ideal.g.value
    # Without a length there is nothing to correct.
    assert "neither g nor the length" in str(fit(t, theta, bob=(0.02, 0.1), model="linear"))


def test_monte_carlo_draws_the_quoted_interval():
    found = fit(T, record(), length=(0.8, 0.001), model="linear", monte_carlo=4000, seed=5)
    low, high = found.to_dict()["monte_carlo"]
    assert (high - low) / (2 * 1.96 * found.g.u) == pytest.approx(1.0, abs=0.1)
    assert low < found.g.value < high
    assert "Monte Carlo, 95 %" in str(found)
    again = fit(T, record(), length=(0.8, 0.001), model="linear", monte_carlo=4000, seed=5)
    other = fit(T, record(), length=(0.8, 0.001), model="linear", monte_carlo=4000, seed=6)
    assert again.to_dict()["monte_carlo"] == [low, high] != other.to_dict()["monte_carlo"]


def test_the_words_name_the_terms_that_act():
    assert "linear friction" in fit(T, record(), model="linear").sentence()
    assert "without friction" in fit(T, record(linear=0.0), model="none").sentence()
