"""Labels of xarray, pandas and Dask through every public function of arrays: what they are of, their name, their units."""

import inspect
import pickle

import dask.array
import numpy as np
import pandas
import pytest
import xarray
from bits import all_same, same

import libration
from libration import CubicQuintic, Duffing, DuffingForm, Pendulum, approx, elliptic, papers

# Values that every argument takes: between 0 and 1.
T = np.array([[0.1, 0.25, 0.3], [0.45, 0.6, 0.7]])
PENDULUM = Pendulum(1.0, 0.2)
DUFFING = Duffing(1.0, p=1.0, q=1.0)
FORCE = {"p": 1.0, "q": 0.2, "r": 0.5}
ODD = {"p": 1.0, "q": -0.5, "s": 0.1}
QUINTIC = CubicQuintic(1.0, p=1.0, q=-0.5, s=0.1)
FORM = DuffingForm("cn", 1.0, p=1.0, q=1.0)
ANGLE = approx.angle("harmonic")
APPROXIMATION = ANGLE.of(PENDULUM)
PERIOD = approx.period("kidd-fogg")

# The call with one labelled argument, and the name and units of each of its results.
CALLS = {
    "Pendulum.theta": (PENDULUM.theta, [("theta", "rad")]),
    "Pendulum.velocity": (PENDULUM.velocity, [("velocity", "rad/s")]),
    "Pendulum.motion": (PENDULUM.motion, [("theta", "rad"), ("velocity", "rad/s")]),
    "Pendulum.turns": (PENDULUM.turns, [("n", "1"), ("angle", "rad")]),
    "Pendulum.phase": (PENDULUM.phase, [("phase", "rad")]),
    "theta": (lambda t: libration.theta(t, 1.0), [("theta", "rad")]),
    "velocity": (lambda t: libration.velocity(t, t), [("velocity", "rad/s")]),
    "motion": (lambda t: libration.motion(0.3, t), [("theta", "rad"), ("velocity", "rad/s")]),
    "advance": (lambda t: libration.advance(t, 0.1, 0.3), [("theta", "rad"), ("velocity", "rad/s")]),
    "action": (libration.action, [("action", "rad**2/s")]),
    "frequency": (libration.frequency, [("frequency", "rad/s")]),
    "phase": (libration.phase, [("phase", "rad")]),
    "period": (lambda theta: libration.period(theta, length=0.5), [("period", "s")]),
    "theta_max": (lambda theta: libration.theta_max(theta, omega2=2.0), [("theta_max", "rad")]),
    "energy": (lambda energy: libration.energy(energy=energy), [("energy", "rad**2/s**2")]),
    "energy_ratio": (libration.energy_ratio, [("energy_ratio", "1")]),
    "energy_ratio_c": (lambda theta: libration.energy_ratio_c(theta_from_top=theta), [("energy_ratio_c", "1")]),
    "turns": (lambda t: libration.turns(t, 0.0, 3.0, length=1.0), [("n", "1"), ("angle", "rad")]),
    "next_crossing": (lambda theta: libration.next_crossing(theta, 0.0, 3.0), [("next_crossing", "s")]),
    "from_nome": (elliptic.from_nome, [("m", "1"), ("mc", "1")]),
    "from_action_phase": (
        lambda t: libration.from_action_phase(t, 0.5),
        [("theta", "rad"), ("velocity", "rad/s")],
    ),
    "harmonic_distortion": (libration.harmonic_distortion, [("harmonic_distortion", "1")]),
    "duffing_motion": (lambda t: libration.duffing_motion(t, 1.0), [("u", None), ("velocity", None)]),
    "cubic_quintic_motion": (
        lambda t: libration.cubic_quintic_motion(t, 1.0, p=1.0, q=-0.5, s=0.1),
        [("u", None), ("velocity", None)],
    ),
    "cubic_quintic_period": (lambda u: libration.cubic_quintic_period(u, **ODD), [("period", "s")]),
    "cubic_quintic_frequency": (lambda u: libration.cubic_quintic_frequency(u, **ODD), [("frequency", "rad/s")]),
    "cubic_quintic_action": (lambda u: libration.cubic_quintic_action(u, **ODD), [("action", None)]),
    "cubic_quintic_phase": (lambda u: libration.cubic_quintic_phase(u, **ODD), [("phase", "rad")]),
    "cubic_quintic_escape_times": (
        lambda u: libration.cubic_quintic_escape_times(u, **ODD),
        [("escape_time_backward", "s"), ("escape_time", "s")],
    ),
    "duffing_period": (lambda u: libration.duffing_period(u, **FORCE), [("period", "s")]),
    "duffing_frequency": (lambda u: libration.duffing_frequency(u, **FORCE), [("frequency", "rad/s")]),
    "duffing_action": (lambda u: libration.duffing_action(u, **FORCE), [("action", None)]),
    "duffing_phase": (lambda u: libration.duffing_phase(u, **FORCE), [("phase", "rad")]),
    "duffing_escape_times": (
        lambda u: libration.duffing_escape_times(u, **FORCE),
        [("escape_time_backward", "s"), ("escape_time", "s")],
    ),
    "Duffing.phase": (DUFFING.phase, [("phase", "rad")]),
    "Duffing.u": (DUFFING.u, [("u", None)]),
    "Duffing.velocity": (DUFFING.velocity, [("velocity", None)]),
    "Duffing.motion": (DUFFING.motion, [("u", None), ("velocity", None)]),
    "CubicQuintic.phase": (QUINTIC.phase, [("phase", "rad")]),
    "CubicQuintic.u": (QUINTIC.u, [("u", None)]),
    "CubicQuintic.velocity": (QUINTIC.velocity, [("velocity", None)]),
    "CubicQuintic.motion": (QUINTIC.motion, [("u", None), ("velocity", None)]),
    "DuffingForm.u": (FORM.u, [("u", None)]),
    "DuffingForm.velocity": (FORM.velocity, [("velocity", None)]),
    "DuffingForm.motion": (FORM.motion, [("u", None), ("velocity", None)]),
    "AngleFormula.error": (ANGLE.error, [("error", "1")]),
    "AngleApproximation.theta": (APPROXIMATION.theta, [("theta", "rad")]),
    "AngleApproximation.difference": (APPROXIMATION.difference, [("difference", "rad")]),
    "NumericalSolution.theta": (approx.numerical("rk4:0.1").of(PENDULUM).theta, [("theta", "rad")]),
    "PeriodFormula.ratio": (PERIOD.ratio, [("ratio", "1")]),
    "PeriodFormula.error": (lambda t: PERIOD.error(m=t), [("error", "1")]),
    "SineFormula.value": (approx.sine("taylor:3").value, [("value", "1")]),
    "jacobi": (lambda u: elliptic.jacobi(u, m=0.5), [("sn", "1"), ("cn", "1"), ("dn", "1"), ("am", "rad")]),
    "jacobi_complex": (lambda u: elliptic.jacobi_complex(u, m=0.5), [("sn", "1"), ("cn", "1"), ("dn", "1")]),
    "complete_pi": (lambda n: elliptic.complete_pi(n, m=0.5), [("complete_pi", "1")]),
    "incomplete_pi": (lambda n: elliptic.incomplete_pi(n, 0.5, m=0.5), [("incomplete_pi", "1")]),
    "carlson_rf": (lambda x: elliptic.carlson_rf(x, 1.0, 2.0), [("carlson_rf", "1")]),
    "carlson_rc": (lambda x: elliptic.carlson_rc(x, 1.0), [("carlson_rc", "1")]),
    "carlson_rd": (lambda x: elliptic.carlson_rd(x, 1.0, 2.0), [("carlson_rd", "1")]),
    "carlson_rj": (lambda x: elliptic.carlson_rj(x, 1.0, 2.0, 3.0), [("carlson_rj", "1")]),
    "salas_22": (lambda t: papers.salas_22(t, 1.0, 0.5), [("theta", "rad")]),
    "salas_23": (lambda t: papers.salas_23(0.3, 1.0, t), [("theta", "rad")]),
    "salas_24": (lambda t: papers.salas_24(t, t, 0.5, omega0=2.0), [("theta", "rad")]),
    "juchem_neto": (lambda t: papers.juchem_neto(t, t, 0.5, t), [("theta", "rad")]),
}


def by_m(function):
    return lambda m: function(m=m)


def at_m(function):
    return lambda u: function(u, m=0.5)


for name in elliptic.__all__:
    if name not in CALLS and name[0].islower():
        call = by_m if name in ("complete_k", "complete_e", "nome") else at_m
        CALLS[name] = (call(getattr(elliptic, name)), [(name, "1")])

# Public functions and methods that take no array of any length, or make a matrix of every element.
NO_ARRAYS = {
    "regime",
    "cubic_quintic_regime",
    "duffing_regime",
    "sensitivities",
    "claims",
    "errata",
    "limits",
    "pictures",
    "fit",
    "fit_together",
    "gravity_of_period",
    "gravity_of_pivots",
    "normal_gravity",
    "cite",
    "uncertain_motion",
    "uncertain_period",
}
OTHERS = {
    "Pendulum": {
        "degrees",
        "animate",
        "to_dataframe",
        "plot",
        "widget",
        "plot_phase",
        "times",
        "turning_times",
        "fourier",
        "from_action_phase",
        "from_energy",
        "from_period",
        "from_turning_angle",
        "sensitivities",
        "second_sensitivities",
    },
    "Duffing": {
        "times",
        "of_pendulum",
        "plot",
        "fourier",
        "sensitivities",
        "from_energy",
        "from_action_phase",
        "to_dataframe",
    },
    "CubicQuintic": {
        "times",
        "plot",
        "fourier",
        "sensitivities",
        "from_energy",
        "from_action_phase",
        "to_dataframe",
    },
    "DuffingForm": {"table"},
    "AngleFormula": {"of", "ranges"},
    "AngleApproximation": {"error"},
    "NumericalFormula": {"of"},
    "NumericalSolution": {"error", "over_the_top"},
    "PeriodFormula": {"period", "quarter_period", "ranges"},
    "SineFormula": {"error", "ranges"},
}
calls = pytest.mark.parametrize(("call", "results"), CALLS.values(), ids=CALLS)


def parts(result):
    return tuple(result) if isinstance(result, tuple) else (result,)


def test_every_public_function_of_arrays_is_called_here():
    functions = {
        name
        for room in (libration, elliptic, papers)
        for name in room.__all__
        if inspect.isfunction(getattr(room, name)) and name not in NO_ARRAYS
    }
    for room in (libration, approx):
        for kind in (getattr(room, name) for name in room.__all__):
            if inspect.isclass(kind) and kind.__name__ in OTHERS:
                methods = {name for name in dir(kind) if name[0] != "_" and callable(getattr(kind, name))}
                functions |= {f"{kind.__name__}.{name}" for name in methods - OTHERS[kind.__name__]}
    assert functions == set(CALLS)


@calls
def test_xarray(call, results):
    labels = {"time": [3, 4], "place": list("abc")}
    t = xarray.DataArray(
        T, labels, ("time", "place"), "phi", {"units": "deg", "long_name": "an argument", "source": "clock"}
    )
    for result, expected, (name, units) in zip(parts(call(t)), parts(call(T)), results, strict=True):
        assert isinstance(result, xarray.DataArray)
        assert (result.name, result.attrs.get("units"), result.attrs["source"]) == (name, units, "clock")
        assert result.attrs["long_name"] not in ("", "an argument")
        assert (result.dims, list(result.place)) == (("time", "place"), list("abc"))
        assert all_same(result.values, expected)
    assert (t.name, t.units, t.long_name) == ("phi", "deg", "an argument")


@calls
def test_xarray_over_dask(call, results):
    t = xarray.DataArray(dask.array.from_array(T, chunks=(1, 2)), dims=("time", "place"), name="phi")
    for result, expected, (name, units) in zip(parts(call(t)), parts(call(T)), results, strict=True):
        assert (result.name, result.attrs.get("units"), result.dims) == (name, units, ("time", "place"))
        assert isinstance(result.data, dask.array.Array)
        assert all_same(result.values, expected)


@calls
def test_dask(call, results):
    for result, expected in zip(parts(call(dask.array.from_array(T, chunks=(1, 2)))), parts(call(T)), strict=True):
        assert isinstance(result, dask.array.Array)
        assert result.chunks == ((1, 1), (2, 1))
        again = pickle.loads(pickle.dumps(result))
        assert all_same(result.compute(scheduler="sync"), expected)
        assert all_same(again.compute(scheduler="sync"), expected)


@calls
def test_pandas_series(call, results):
    t = pandas.Series(T[0], list("abc"), name="phi")
    for result, expected, (name, _) in zip(parts(call(t)), parts(call(T[0])), results, strict=True):
        assert isinstance(result, pandas.Series)
        assert (list(result.index), result.name) == (list("abc"), name)
        assert same(result.to_numpy(), expected)
    assert t.name == "phi"


@calls
def test_pandas_table(call, results):
    t = pandas.DataFrame(T, [3, 4], ["name", "dims", "iloc"])
    for result, expected in zip(parts(call(t)), parts(call(T)), strict=True):
        assert isinstance(result, pandas.DataFrame)
        assert (list(result.index), list(result.columns)) == ([3, 4], ["name", "dims", "iloc"])
        assert same(result.to_numpy(), expected)


def test_missing_values_of_pandas_are_nan():
    t = pandas.Series([0.1, None, 0.3], dtype="Float64")
    assert np.isnan(APPROXIMATION.theta(t)[1]) and APPROXIMATION.theta(t)[2] == APPROXIMATION.theta(0.3)


@pytest.mark.parametrize("room", [Pendulum.sensitivities, Pendulum.second_sensitivities])
def test_matrices_have_a_name_and_no_units(room):
    t = xarray.DataArray(T, dims=("time", "place"), name="phi", attrs={"units": "s"})
    result = room(PENDULUM, t)
    assert (result.name, "units" in result.attrs, result.dims[:2]) == (room.__name__, False, ("time", "place"))
    of_rows = libration.sensitivities(t, 1.0)
    assert (of_rows.name, "units" in of_rows.attrs) == ("sensitivities", False)


SERIES = pandas.Series([0.1, 0.2, 0.3])
TABLE = pandas.DataFrame(T)
ARRAY = xarray.DataArray([0.1, 0.2, 0.3], dims="time")
LAZY = dask.array.from_array(np.array([0.1, 0.2, 0.3]))


@pytest.mark.parametrize(
    ("first", "second", "named"),
    [
        (SERIES, ARRAY, "pandas Series and xarray DataArray"),
        (ARRAY, SERIES, "xarray DataArray and pandas Series"),
        (ARRAY, pandas.Index([0.1, 0.2, 0.3]), "xarray DataArray and pandas Index"),
        (ARRAY.to_dataset(name="t"), TABLE, "xarray Dataset and pandas DataFrame"),
        (SERIES, LAZY, "pandas Series and dask Array"),
        (SERIES, TABLE, "pandas Series and pandas DataFrame"),
    ],
)
@pytest.mark.parametrize("function", [libration.theta, libration.motion, libration.action, elliptic.incomplete_pi])
def test_what_does_not_go_together_is_said_in_one_line(function, first, second, named):
    keyword = {"m": 0.5} if function is elliptic.incomplete_pi else {}
    with pytest.raises(TypeError) as caught:
        function(first, second, **keyword)
    assert str(caught.value).startswith(f"{named} do not go together: ") and "\n" not in str(caught.value)


def test_a_mask_of_another_library_is_refused_too():
    with pytest.raises(TypeError, match="do not go together"):
        libration.theta(ARRAY, 1.0, where=SERIES > 0.1)
    with pytest.raises(TypeError, match="do not go together"):
        libration.theta(ARRAY, SERIES, out=np.empty(3))
