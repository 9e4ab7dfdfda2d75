"""The exact solutions of the papers: right where they hold, wrong or without a value where `limits` says so."""

import itertools
import math
import warnings

import numpy as np
import pandas
import pytest
import xarray

import libration
from libration.papers import juchem_neto, limits, salas_22, salas_23, salas_24

FORMS = [salas_22, salas_23, salas_24, juchem_neto]
T = np.linspace(-20.0, 20.0, 401)
# theta0, velocity0, omega0: librations from 0 < theta0 < pi, where all four hold.
SWINGS = [(0.1, 0.0, 1.0), (1.0, 0.5, 1.0), (1.0, -0.5, 2.0), (2.5, 0.3, 1.0), (3.0, 0.0, 3.13), (0.5, -1.7, 1.0)]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("theta0", "velocity0", "omega0"), SWINGS)
def test_right_where_they_hold(form, theta0, velocity0, omega0):
    reference = libration.theta(T, theta0, velocity0, omega0)
    assert np.max(np.abs(form(T, theta0, velocity0, omega0) - reference)) < 2e-11
    # The angle from another initial state is wrong here.
    assert np.max(np.abs(form(T, theta0 + 1e-6, velocity0, omega0) - reference)) > 1e-7


@pytest.mark.parametrize("form", FORMS)
def test_separatrix(form):
    velocity0 = 2 * math.cos(0.5)
    reference = libration.theta(T[150:250], 1.0, velocity0)
    assert np.max(np.abs(form(T[150:250], 1.0, velocity0) - reference)) < 1e-9


@pytest.mark.parametrize("form", [salas_22, salas_23, salas_24])
@pytest.mark.parametrize("state", [(-1.0, 0.4), (-2.0, 0.0), (0.0, 1.0), (0.0, -1.9)])
def test_salas_holds_on_both_sides(form, state):
    assert np.max(np.abs(form(T, *state) - libration.theta(T, *state))) < 2e-12


@pytest.mark.parametrize("form", [salas_22, salas_23, salas_24])
@pytest.mark.parametrize("state", [(1.0, 3.0), (1.0, -3.0), (-2.0, 2.5), (4.0, 0.5), (9.0, -4.0)])
def test_salas_holds_modulo_a_turn(form, state):
    difference = form(T, *state) - libration.theta(T, *state)
    assert np.max(np.abs(np.angle(np.exp(1j * difference)))) < 1e-10
    assert np.max(np.abs(difference)) > 6


def test_complement():
    # The parameter of (22) is the complement of that of (23). With the wrong one of the two the angle is wrong.
    assert salas_22(1.3, 2.0, 0.4) == pytest.approx(salas_23(1.3, 2.0, 0.4), abs=1e-14)


def test_they_broadcast():
    assert salas_23(T[:, None], [0.5, 1.0]).shape == (401, 2)
    assert juchem_neto(T[:, None], [0.5, 1.0], [0.1, -0.1]).shape == (401, 2)
    assert np.ndim(salas_22(1.0, 1.0)) == 0


@pytest.mark.parametrize("limit", limits(), ids=lambda limit: f"{limit.name} {limit.theta0:.3g} {limit.velocity0}")
def test_they_fail_where_they_are_said_to(limit):
    assert not abs(limit.given - limit.truth) < 1e-3
    assert limit.modulo == (abs(math.remainder(limit.given - limit.truth, math.tau)) < 1e-9)
    assert limit.why


@pytest.mark.parametrize(
    ("name", "state", "t", "given", "truth"),
    [
        # From mpmath with 50 digits, without this package.
        ("Salas (23)", (1.0, 3.0), 7.0, 1.634282840633, 20.4838387621714),
        ("Salas (23)", (math.pi, 0.5), 1.0, -2.55533192399, 3.727853383189),
        ("Salas (24)", (0.0, 2.0), 800.0, math.nan, math.pi),
        ("Juchem Neto", (1.0, 3.0), 1.5, 1.338413590964, 4.944771716215),
        ("Juchem Neto", (-1.0, 0.0), 3.0, -0.948751596946, 0.948751596946),
        ("Juchem Neto", (0.0, 1.0), 1.0, math.nan, 0.847798681677),
        ("Juchem Neto", (math.pi, 1.0), 0.5, 2.62077350365, 3.66241180353),
    ],
)
def test_failing_numbers(name, state, t, given, truth):
    limit = next(
        limit for limit in limits() if (limit.name, limit.theta0, limit.velocity0, limit.t) == (name, *state, t)
    )
    assert limit.given == pytest.approx(given, abs=1e-11, nan_ok=True)
    assert limit.truth == pytest.approx(truth, abs=1e-11)


def test_from_the_top_downward_juchem_neto_holds():
    assert juchem_neto(0.5, math.pi, -1.0) == pytest.approx(libration.theta(0.5, math.pi, -1.0), abs=1e-12)


# Python raises for squares or quotients of some of these floats; NumPy gives a number for each.
HOSTILE = [0, 1, -1.0, 1e200, -1e308, 5e-324, math.nan, math.inf, -math.inf, 10**300, True]


@pytest.mark.parametrize("form", FORMS)
def test_any_numbers_give_numbers(form):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for given in itertools.product(HOSTILE, repeat=4):
            value = form(*given)
            assert type(value) is np.float64, given
            # Arrays give the same.
            assert np.array_equal(value, form(*(np.array([float(each)]) for each in given))[0], equal_nan=True)


def test_a_square_beyond_the_doubles():
    assert math.isnan(salas_24(1, 1, 0, 1e200))
    assert salas_24(1e-200, 1.0, 0.0, 1e100) == pytest.approx(1.0, abs=1e-15)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("place", "name"), [(0, "t"), (1, "theta0"), (2, "velocity0"), (3, "omega0")])
def test_integers_beyond_the_doubles_are_refused(form, place, name):
    given = [1.0, 1.0, 0.5, 1.0]
    given[place] = 10**400
    with pytest.raises(ValueError, match=f"^{name} = an integer beyond the doubles: must be finite$"):
        form(*given)


@pytest.mark.parametrize("form", FORMS)
def test_states_of_pandas_are_aligned_by_their_index(form):
    theta0 = pandas.Series([0.5, 1.0, 1.5], list("abc"))
    velocity0 = pandas.Series([0.3, 0.2, 0.1], list("dcb"))
    result = form(2.0, theta0, velocity0, 1)
    assert (list(result.index), result.name) == (list("abcd"), "theta")
    expected = form(2.0, [1.0, 1.5], [0.1, 0.2])
    assert np.array_equal(result.to_numpy(), [math.nan, *expected, math.nan], equal_nan=True)
    whole = pandas.DataFrame({"x": [1, 2], "y": [3, None]}, [5, 6])
    assert np.array_equal(form(0.5, whole, 0.1).to_numpy(), form(0.5, whole.to_numpy(), 0.1), equal_nan=True)
    missing = pandas.Series([1, None], dtype="Int64")
    assert np.array_equal(form(0.5, missing, 0.1).to_numpy(), form(0.5, [1, math.nan], 0.1), equal_nan=True)


@pytest.mark.parametrize("form", FORMS)
def test_states_of_xarray_are_broadcast_by_their_dimensions(form):
    t = xarray.DataArray([0.1, 0.2], {"time": [3, 4]}, "time", attrs={"units": "s", "source": "clock"})
    theta0 = xarray.DataArray([0.5, 1.0, 1.5], dims="place")
    result = form(t, theta0, 0.5)
    assert (result.name, result.dims, list(result.time)) == ("theta", ("time", "place"), [3, 4])
    assert result.attrs["units"] == "rad" and result.attrs["long_name"]
    assert np.array_equal(result.values, form(t.values[:, None], theta0.values, 0.5))


@pytest.mark.parametrize("form", FORMS)
def test_what_is_masked_stays_masked(form):
    t = np.ma.array([0.1, 0.2, 0.3], mask=[False, True, False])
    theta0 = np.ma.array([0.5, 1.0, 1.5], mask=[False, False, True])
    result = form(t, theta0, 0.5)
    assert list(result.mask) == [False, True, True]
    assert result[0] == form(0.1, 0.5, 0.5)


@pytest.mark.parametrize("form", FORMS)
def test_what_does_not_go_together_is_refused(form):
    with pytest.raises(TypeError, match=r"^pandas Series and xarray DataArray do not go together: "):
        form(pandas.Series([0.1, 0.2]), xarray.DataArray([0.1, 0.2]))
