"""Constructors refuse in one line that names argument, value and what is allowed; arrays give NaN for one element."""

import datetime
import inspect
import math

import numpy as np
import pandas as pd
import pytest

import libration
from libration import Pendulum

BAD_SCALARS = {
    "None": None,
    "bool": True,
    "NumPy bool": np.True_,
    "complex": 1j,
    "NumPy complex": np.complex128(1.0),
    "string": "1.0",
    "bytes": b"1.0",
    "list": [1.0],
    "tuple": (1.0, 2.0),
    "array": np.array([1.0]),
    "0-d bool array": np.array(True),
    "0-d string array": np.array("1"),
    "object": object(),
    "NaN": math.nan,
    "infinity": math.inf,
    "huge integer": 10**400,
    "integer too long to print": 10**5000,
    "timedelta": np.timedelta64(1, "s"),
}


def refused(*arguments, **keywords):
    with pytest.raises(ValueError) as caught:
        Pendulum(*arguments, **keywords)
    message = str(caught.value)
    assert "\n" not in message
    assert len(message) < 200
    return message


@pytest.mark.parametrize("value", BAD_SCALARS.values(), ids=BAD_SCALARS)
@pytest.mark.parametrize("name", ["theta0", "velocity0", "omega0", "omega2", "length", "gravity"])
def test_only_finite_real_scalars(name, value):
    keywords = {"theta0": 1.0, name: value}
    if name == "gravity":
        keywords["length"] = 1.0
    if value is None and name not in ("theta0", "velocity0"):
        assert Pendulum(**keywords).regime == "libration"
        return
    if value is None and name == "theta0":
        with pytest.raises(TypeError, match="needs theta0"):
            Pendulum(**keywords)
        return
    message = refused(**keywords)
    assert message.startswith(f"{name} = ")
    assert ": must be " in message


@pytest.mark.parametrize(
    ("keywords", "words"),
    [
        ({"omega0": 1.0, "length": 1.0}, ["omega0", "length", "1.0"]),
        ({"omega0": 1.0, "omega2": 2.0}, ["omega0", "omega2", "2.0"]),
        ({"omega2": 1.0, "length": 3.0}, ["omega2", "length", "3.0"]),
        ({"gravity": 9.8}, ["gravity", "9.8", "length"]),
        ({"gravity": 9.8, "omega0": 1.0}, ["gravity", "9.8", "length"]),
        ({"length": 0.0}, ["length = 0.0", "positive"]),
        ({"length": -1.0}, ["length = -1.0", "positive"]),
        ({"length": 1.0, "gravity": math.nan}, ["gravity = NaN", "finite"]),
        ({"omega0": -1.0}, ["omega0 = -1.0", "not negative"]),
        ({"omega2": -math.inf}, ["omega2 = -inf", "finite"]),
    ],
)
def test_frequency(keywords, words):
    message = refused(1.0, **keywords)
    for word in words:
        assert word in message


@pytest.mark.parametrize(
    "value", [1.5, np.float64(1.5), np.float32(1.5), np.longdouble(1.5), np.array(1.5), np.array(1.5, ">f4")]
)
def test_every_real_scalar_is_taken(value):
    assert Pendulum(value, value, length=value) == Pendulum(1.5, 1.5, length=1.5)
    assert Pendulum(np.uint8(2)) == Pendulum(2)


@pytest.mark.parametrize("function", ["complete_k", "complete_e", "nome", "jacobi", "incomplete_f", "incomplete_e"])
@pytest.mark.parametrize(
    ("keywords", "named"),
    [({}, "none"), ({"m": 0.5, "k": 0.1}, "m and k"), ({"m": 0.1, "mc": [0.9], "k": 0.1}, "m and mc and k")],
)
def test_exactly_one_parameter(function, keywords, named):
    arguments = [] if function.startswith("complete") or function == "nome" else [1.0]
    with pytest.raises(ValueError, match=f"^exactly one of m, mc, k and q must be given, not {named}$"):
        getattr(libration, function)(*arguments, **keywords)


def test_no_parameter_by_position():
    with pytest.raises(TypeError):
        libration.jacobi(1.0, 0.5)
    with pytest.raises(TypeError):
        libration.complete_k(0.5)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("position", range(4))
@pytest.mark.parametrize("function", [libration.theta, libration.velocity, libration.motion, libration.advance])
def test_a_bad_element_is_nan_and_no_other(function, position, bad):
    good = [np.full(5, value) for value in (0.7, 1.0, 0.5, 1.2)]
    expected = np.array(function(*good))
    spoilt = [column.copy() for column in good]
    spoilt[position][2] = bad
    with np.errstate(all="raise"):
        result = np.array(function(*spoilt))
    assert np.all(np.isnan(result[..., 2]))
    assert np.array_equal(np.delete(result, 2, -1), np.delete(expected, 2, -1))
    assert not np.any(np.isnan(expected))


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("function", [libration.theta, libration.velocity, libration.motion])
def test_negative_omega0_is_nan_on_both_paths(function):
    assert np.all(np.isnan(function([1.0, 2.0], 1.0, 0.0, -1.0)))
    omega0 = np.array([1.0, -1.0, -0.0])
    first = np.atleast_2d(function(1.0, 1.0, 0.0, omega0))[0]
    assert list(np.isnan(first)) == [False, True, False]


@pytest.mark.filterwarnings("error")
def test_bad_orbits_of_all_scalars_give_nan():
    for orbit in [(math.nan, 0.0, 1.0), (1.0, math.inf, 1.0), (1.0, 0.0, math.nan), (1.0, 0.0, math.inf)]:
        assert np.all(np.isnan(libration.theta([0.0, 1.0], *orbit)))
        assert math.isnan(libration.velocity(1.0, *orbit))


@pytest.mark.filterwarnings("error")
def test_bad_times_give_nan_and_no_turn():
    pendulum = Pendulum(0.0, 3.0)
    n, angle = pendulum.turns([1.0, math.nan, math.inf])
    assert n[1] == n[2] == 0
    assert list(np.isnan(angle)) == [False, True, True]
    assert list(np.isnan(pendulum.theta([1.0, math.nan, math.inf, 1e300]))) == [False, True, True, True]


@pytest.mark.filterwarnings("error")
def test_elliptic_functions_out_of_domain():
    values = libration.jacobi([1.0, math.nan, math.inf, -math.inf], m=0.5)
    for value in values:
        assert list(np.isnan(value)) == [False, True, True, True]
    sn, cn, dn, am = libration.jacobi([math.inf, -math.inf], m=1.0)
    assert list(sn) == [1.0, -1.0]
    assert list(cn) == list(dn) == [0.0, 0.0]
    assert list(am) == [math.pi / 2, -math.pi / 2]
    assert np.all(np.isnan(libration.jacobi(1.0, m=[math.nan, math.inf])))
    assert np.all(np.isnan(libration.complete_k(m=[1.5, math.nan, math.inf])))
    assert np.all(np.isnan(libration.complete_e(mc=[-0.5, math.nan])))
    assert np.all(np.isnan(libration.nome(k=[1.5, math.nan])))
    assert list(np.isnan(libration.incomplete_f([0.5, 1.5, math.nan], m=2.0))) == [False, True, True]


@pytest.mark.parametrize(
    ("where", "said"),
    [
        (None, "where = None: must be True, False or an array of them"),
        ([1.0, 0.0], "where of dtype float64: must be True, False or an array of them"),
    ],
)
def test_where_is_booleans(where, said):
    for function in (libration.theta, libration.velocity, libration.motion):
        with pytest.raises(ValueError, match=f"^{said}$"):
            function([0.0, 1.0], 1.0, where=where)
    with pytest.raises(ValueError, match=f"^{said}$"):
        libration.jacobi([0.0, 1.0], m=0.5, where=where)


def test_arrays_that_are_not_real_numbers_are_numpys_to_refuse():
    for bad in (["a"], [1j], [None]):
        with pytest.raises(TypeError):
            Pendulum(1.0).theta(bad)
        with pytest.raises(TypeError):
            libration.theta(1.0, bad)


ODD = {
    "object": object(),
    "class": Pendulum,
    "pendulum": Pendulum(1.0),
    "date": datetime.date(2026, 1, 1),
    "dictionary": {"a": 1.0},
    "bytes": b"1",
    "fields": np.zeros(2, [("a", float), ("b", int)]),
    "objects": np.array([object()]),
    "series of text": pd.Series(["a"]),
    "table of text": pd.DataFrame({"a": ["x"]}),
    "large integers": [10**400],
    "slice": slice(1),
    "ragged": [[1.0], [1.0, 2.0]],
}


# These take files, tables and pairs, which are odd for the others; test_fit.py and test_gravity.py have what they refuse.
OF_OTHER_THINGS = ("fit", "fit_together", "gravity_of_pivots")
FUNCTIONS = [
    getattr(libration, name) for name in libration.__all__ if name[0].islower() and name not in OF_OTHER_THINGS
]


@pytest.mark.parametrize("odd", ODD.values(), ids=ODD)
@pytest.mark.parametrize("function", FUNCTIONS)
def test_no_message_names_what_is_inside(function, odd):
    """Each argument of each function in turn is something odd: the answer is one short line that names the argument."""
    given = inspect.signature(function).parameters.values()
    names = [each.name for each in given if each.name not in ("out", "where") and each.kind is not each.VAR_POSITIONAL]
    needed = [name for name in names if inspect.signature(function).parameters[name].default is inspect.Parameter.empty]
    good = dict.fromkeys(needed, 0.5) | ({"m": 0.5} if "mc" in names else {})
    for name in names:
        if name in ("mc", "k", "q"):
            good.pop("m", None)
        # A state needs an angle, and gravity a length.
        angle = next((each for each in ("theta", "theta0") if f"{each}_from_top" in names), None)
        beside = {angle: 0.5} if angle and name != f"{angle}_from_top" else {}
        beside |= {"length": 1.0} if name == "gravity" else {}
        with pytest.raises((TypeError, ValueError)) as caught:
            function(**good | beside | {name: odd})
        message = str(caught.value)
        assert message.startswith(f"{name} = ") and len(message) < 250
        assert "ufunc" not in message and "\n" not in message
