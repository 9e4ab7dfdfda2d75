"""The elliptic family through its door: names and help, doors that change no bit, Dask and xarray, bad input."""

import inspect
import math

import dask.array
import numpy as np
import pytest
import xarray
from bits import all_same, same
from test_dispatch import T, lazily
from test_doors import each, times

import libration
from libration import elliptic

TWELVE = "sn cn dn ns nc nd sc cs sd ds cd dc".split()
INVERSES = [f"arc{name}" for name in TWELVE]
CARLSON = {"carlson_rf": 3, "carlson_rc": 2, "carlson_rd": 3, "carlson_rj": 4}
THETA = [f"theta{i}" for i in (1, 2, 3, 4)]
# Arguments before the keyword.
WITH_PARAMETER = {
    **dict.fromkeys([*TWELVE, *INVERSES, "jacobi_epsilon", "jacobi_zeta", "heuman_lambda", "complete_pi", *THETA], 1),
    "incomplete_pi": 2,
    "jacobi_complex": 1,
}
# Those that answer a parameter with dimensions by a formula of its own: decision 5.
ROWS = {*TWELVE, "jacobi_epsilon", "jacobi_zeta", *THETA}

with_parameter = pytest.mark.parametrize("name", WITH_PARAMETER)
carlson = pytest.mark.parametrize("name", CARLSON)


def calling(name):
    """A function of one argument at m = 0.8."""
    function = getattr(elliptic, name)
    return lambda t: function(t, m=0.8)


def parts(result):
    return tuple(result) if isinstance(result, tuple) else (result,)


def all_close(results, others):
    """Within some places of the last digit, infinities and NaN alike."""
    return all(
        np.allclose(one, other, rtol=2e-15, atol=0, equal_nan=True) for one, other in zip(results, others, strict=True)
    )


def columns(count, seed=11):
    """Arguments in and out of every range, infinities and NaN among them."""
    random = np.random.default_rng(seed)
    arguments = random.normal(size=(count, 200)) * 10.0 ** random.integers(-6, 4, size=(count, 200))
    arguments[:, :4] = [[math.nan, math.inf, -math.inf, -0.0]]
    return list(arguments)


def parameters(seed=12):
    random = np.random.default_rng(seed)
    values = random.uniform(-1.0, 2.0, 200)
    values[5:9] = [0.0, 1.0, math.nan, 1e20]
    return values


# ----------------------------------------------------------------------------------------------- names and help


def test_every_name_of_the_package_is_there():
    assert sorted([*TWELVE, *INVERSES]) == sorted(set(elliptic.__all__) - set(libration.__all__))
    for name in elliptic.__all__:
        function = getattr(elliptic, name)
        assert getattr(libration, name, function) is function
        assert function.__name__ == name


@pytest.mark.parametrize("name", [name for name in elliptic.__all__ if name[0].islower()])
def test_help_is_whole(name):
    text = inspect.getdoc(getattr(elliptic, name))
    sections = [
        "Parameters\n---",
        "Returns\n---",
        "Notes\n---",
        "Examples\n---",
        "Error promised: ",
        "Source: ",
        ">>> ",
    ]
    if name not in (*CARLSON, "from_nome"):
        sections.append("Raises\n---")
    for section in sections:
        assert section in text
    assert "{" not in text.replace("{elliptic", "").replace("{libration", "").replace("{values", "")
    assert max(map(len, text.splitlines())) <= 120


def test_no_two_functions_of_the_table_have_the_same_help():
    texts = [
        inspect.getdoc(getattr(elliptic, name)).partition("Parameters")[0] for name in [*TWELVE, *INVERSES, *THETA]
    ]
    assert len(set(texts)) == len(texts)
    assert "sn/cn" in inspect.getdoc(elliptic.sc)
    assert "sc(u | m) = x" in inspect.getdoc(elliptic.arcsc)


def test_signatures():
    keywords = "m: Any = None, mc: Any = None, k: Any = None, q: Any = None, out: Any = None, where: Any = True) -> Any"
    of_theta = f"q: Any = None, {keywords.replace('q: Any = None, ', '')}"
    assert str(inspect.signature(elliptic.sn)) == f"(u: Any, *, {keywords}"
    assert str(inspect.signature(elliptic.arccd)) == f"(x: Any, *, {keywords}"
    assert str(inspect.signature(elliptic.theta2)) == f"(z: Any, *, {of_theta}"
    assert str(inspect.signature(elliptic.incomplete_pi)) == f"(n: Any, phi: Any, *, {keywords}"
    assert (
        str(inspect.signature(elliptic.carlson_rc)) == "(x: Any, y: Any, *, out: Any = None, where: Any = True) -> Any"
    )


def test_complex_values_have_names():
    values = libration.jacobi_complex(0.5, m=0.5)
    assert values._fields == ("sn", "cn", "dn")
    assert values.dn is values[2]
    assert {type(value) for value in values} == {np.complex128}


# ------------------------------------------------------------------------------------------------------- doors


@with_parameter
@pytest.mark.parametrize("keyword", ["m", "mc", "k"])
def test_scalars_are_the_array_bit_for_bit(name, keyword):
    function = getattr(elliptic, name)
    alike = all_close if name in ROWS else all_same
    arguments, given = columns(WITH_PARAMETER[name]), parameters()
    whole = parts(function(*arguments, **{keyword: given}))
    rows = [
        parts(function(*(float(column[i]) for column in arguments), **{keyword: float(given[i])})) for i in range(200)
    ]
    assert alike(whole, tuple(map(np.array, zip(*rows, strict=True))))
    slices = each(lambda *c: parts(function(*c[:-1], **{keyword: c[-1]})), *arguments, given)
    assert all_same(whole, slices)
    shared = parts(function(*arguments, **{keyword: 0.7}))
    assert alike(shared, parts(function(*arguments, **{keyword: np.full(200, 0.7)})))
    assert all_same(shared, parts(function(*arguments, **{keyword: np.array(0.7)})))
    backwards = parts(function(*(column[::-1] for column in arguments), **{keyword: given[::-1]}))
    assert all_same(tuple(part[::-1] for part in backwards), whole)


@carlson
def test_scalars_are_the_array_of_carlson(name):
    function, arguments = getattr(elliptic, name), columns(CARLSON[name])
    arguments = [abs(column) for column in arguments[:-1]] + arguments[-1:]
    whole = function(*arguments)
    assert np.isfinite(whole).sum() > 80
    assert same(whole, np.array([function(*map(float, row)) for row in np.transpose(arguments)]))
    assert same(function(*(column[:, None] for column in arguments[:-1]), arguments[-1]).diagonal(), whole)


@pytest.mark.parametrize("name", ["jacobi", *sorted(ROWS)])
def test_chunks_and_labels_of_the_parameter_change_no_bit(name):
    function, u, m = getattr(elliptic, name), np.linspace(-9.0, 9.0, 40), parameters()[:40]
    whole = parts(function(u, m=m))
    for chunk in (1, 7, 40):
        lazy = dask.array.from_array(m, chunks=chunk)
        assert all_same(tuple(np.asarray(part) for part in parts(function(u, m=lazy))), whole)
        labelled = xarray.DataArray(lazy, dims="place")
        assert all_same(
            tuple(part.values for part in parts(function(xarray.DataArray(u, dims="place"), m=labelled))), whole
        )
    # A number beside arguments in chunks has one set-up, as without chunks.
    lazy = function(dask.array.from_array(u, chunks=1), m=0.7)
    assert all_same(tuple(np.asarray(part) for part in parts(lazy)), parts(function(u, m=0.7)))
    dataset = function(0.5, m=xarray.Dataset({"a": ("place", m)}))
    first = dataset[0] if isinstance(dataset, tuple) else dataset
    assert same(first["a"].values, parts(function(0.5, m=m))[0])


@pytest.mark.parametrize("name", THETA)
def test_theta_of_the_nome(name):
    function, z, q = getattr(elliptic, name), times(200) % 7.0, np.random.default_rng(4).uniform(-1, 1, 200)
    assert same(function(z, q=q), each(lambda *c: function(c[0], q=c[1]), z, q))
    m = np.linspace(0.1, 0.9, 9)
    assert np.allclose(function(1.0, m=m), function(1.0, q=libration.nome(m=m)), rtol=1e-14)


def test_twelve_are_the_quotients_of_three():
    u = np.linspace(-9.0, 9.0, 181) + 0.01
    values = {"n": np.ones(181), **dict(zip("scd", libration.jacobi(u, m=0.3)[:3], strict=True))}
    for name in TWELVE:
        assert np.allclose(getattr(elliptic, name)(u, m=0.3), values[name[0]] / values[name[1]], rtol=1e-12)


def test_inverses_go_back():
    for name in TWELVE:
        function, inverse = getattr(elliptic, name), getattr(elliptic, f"arc{name}")
        for m in (-2.0, 0.0, 0.4, 1.0, 3.0):
            u = np.linspace(0.05, 0.5, 10) / max(1.0, math.sqrt(abs(m)))
            x = function(u, m=m)
            if np.ptp(x) > 0:
                assert np.allclose(inverse(x, m=m), u, rtol=1e-6)


def test_complex_on_the_real_line_is_real():
    u = times(200) % 30.0
    for value, real in zip(libration.jacobi_complex(u, m=0.6), libration.jacobi(u, m=0.6)[:3], strict=True):
        assert np.allclose(value.real, real, rtol=1e-14)
        assert not value.imag.any()


def test_infinite_parts_stay_apart():
    values = libration.jacobi_complex(1.25 + 720j, m=0.0)
    assert values.sn.real == values.sn.imag == values.cn.real == math.inf
    assert values.cn.imag == -math.inf
    assert values.dn == 1.0


# ------------------------------------------------------------------------------------------------ out and where


@pytest.mark.parametrize("name", [name for name in WITH_PARAMETER if name != "jacobi_complex"])
def test_out_and_where(name):
    function, arguments = getattr(elliptic, name), columns(WITH_PARAMETER[name])
    expected, chosen = function(*arguments, m=0.3), np.arange(200) % 3 == 0
    out = np.full(400, 7.0)
    assert function(*arguments, m=0.3, out=out[::2]).base is out
    assert same(out[::2], expected)
    assert np.all(out[1::2] == 7.0)
    assert same(function(*arguments, m=0.3, where=chosen), np.where(chosen, expected, math.nan))
    kept = np.full(200, 7.0)
    function(*arguments, m=0.3, out=kept, where=chosen)
    assert same(kept, np.where(chosen, expected, 7.0))


@carlson
def test_out_and_where_of_carlson(name):
    function, arguments = getattr(elliptic, name), [abs(column) for column in columns(CARLSON[name])]
    expected, chosen = function(*arguments), np.arange(200) % 3 == 0
    out = np.empty(200)
    assert function(*arguments, out=out) is out
    assert same(out, expected)
    assert same(function(*arguments, where=chosen), np.where(chosen, expected, math.nan))


def test_out_and_where_of_complex_values():
    u, chosen = np.empty(200, complex), np.arange(200) % 3 == 0
    u.real, u.imag = columns(2)
    expected = libration.jacobi_complex(u, m=0.3)
    out = tuple(np.full(200, 7.0 + 7.0j) for _ in range(3))
    results = libration.jacobi_complex(u, m=0.3, out=out)
    assert all(result is kept for result, kept in zip(results, out, strict=True))
    assert all_same(out, tuple(expected))
    for value, whole in zip(libration.jacobi_complex(u, m=0.3, where=chosen), expected, strict=True):
        assert same(value[chosen], whole[chosen])
        assert np.isnan(value[~chosen].real).all() and np.isnan(value[~chosen].imag).all()
    kept = tuple(np.full(200, 7.0 + 7.0j) for _ in range(3))
    libration.jacobi_complex(u, m=0.3, out=kept, where=chosen)
    assert all_same(kept, tuple(np.where(chosen, whole, 7.0 + 7.0j) for whole in expected))
    with pytest.raises((TypeError, ValueError)):
        libration.jacobi_complex(u, m=0.3, out=tuple(np.empty(200) for _ in range(3)))


# ---------------------------------------------------------------------------------------------- Dask and xarray

CALLS = {
    **{name: calling(name) for name in (*TWELVE, *INVERSES)},
    "jacobi_epsilon": lambda t: libration.jacobi_epsilon(0.7, mc=t),
    "jacobi_zeta": lambda t: libration.jacobi_zeta(t, k=t / 40),
    "theta": lambda t: libration.theta3(t, q=0.3),
    "heuman_lambda": lambda t: libration.heuman_lambda(t, m=0.8),
    "complete_pi": lambda t: libration.complete_pi(t, m=0.8),
    "incomplete_pi": lambda t: libration.incomplete_pi(0.3, t, m=0.8),
    "jacobi_complex": lambda t: libration.jacobi_complex(t + 0.5j, m=0.8),
    "jacobi_complex where": lambda t: libration.jacobi_complex(t + 0.5j, m=0.8, where=t > 0),
    "carlson_rf": lambda t: libration.carlson_rf(t, 2.0, 3.0),
    "carlson_rj": lambda t: libration.carlson_rj(1.0, 2.0, 3.0, t),
}
calls = pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)


@calls
def test_dask(call):
    results = lazily(call, dask.array.from_array(T, chunks=(2, 4)))
    for result, expected in zip(results, parts(call(T)), strict=True):
        assert isinstance(result, dask.array.Array)
        assert (result.dtype, result.chunks) == (expected.dtype, ((2, 2), (4, 4, 4, 3)))
        assert all_same(result.compute(), expected)


@calls
def test_xarray_and_xarray_over_dask(call):
    labelled = xarray.DataArray(T, dims=("time", "place"))
    for result, expected in zip(parts(call(labelled)), parts(call(T)), strict=True):
        assert result.dims == ("time", "place")
        assert all_same(result.values, expected)
    for result, expected in zip(lazily(call, labelled.chunk(time=2)), parts(call(T)), strict=True):
        assert isinstance(result.data, dask.array.Array)
        assert all_same(result.values, expected)


# --------------------------------------------------------------------------------------------------- bad input


@with_parameter
@pytest.mark.parametrize(
    ("keywords", "named"),
    [({}, "none"), ({"m": 0.5, "k": 0.1}, "m and k"), ({"m": 0.1, "mc": [0.9], "k": 0.1}, "m and mc and k")],
)
def test_exactly_one_parameter(name, keywords, named):
    every = "q, m, mc and k" if name in THETA else "m, mc, k and q"
    with pytest.raises(ValueError, match=f"^exactly one of {every} must be given, not {named}$"):
        getattr(elliptic, name)(*[1.0] * WITH_PARAMETER[name], **keywords)


def test_nome_and_parameter_exclude_each_other():
    with pytest.raises(ValueError, match="exactly one of q, m, mc and k must be given, not q and mc"):
        libration.theta1(1.0, q=0.1, mc=0.5)
    with pytest.raises(ValueError, match="exactly one of m, mc, k and q must be given, not m and q"):
        libration.heuman_lambda(1.0, m=0.5, q=0.1)


@with_parameter
def test_no_parameter_by_position(name):
    with pytest.raises(TypeError):
        getattr(elliptic, name)(*[1.0] * WITH_PARAMETER[name], 0.5)


@with_parameter
@pytest.mark.filterwarnings("error")
def test_a_bad_element_is_nan_and_no_other(name):
    function, count = getattr(elliptic, name), WITH_PARAMETER[name]
    start = 1.0 if name.startswith("arc") else 0.4
    for position in range(count + 1):
        good = [np.full(5, start) for _ in range(count)] + [np.full(5, 0.5)]
        good[position][2] = math.nan
        with np.errstate(all="raise"):
            results = parts(function(*good[:-1], m=good[-1]))
        for result in results:
            assert list(np.isnan(result)) == [False, False, True, False, False]


@with_parameter
def test_other_types_are_numpys_to_refuse(name):
    for bad in (["a"], [None]):
        with pytest.raises((TypeError, AttributeError)):
            getattr(elliptic, name)(*[bad] * WITH_PARAMETER[name], m=0.5)
    if name not in ("jacobi_complex", *TWELVE):
        with pytest.raises(TypeError):
            getattr(elliptic, name)(*[1j] * WITH_PARAMETER[name], m=0.5)
    with pytest.raises(TypeError):
        getattr(elliptic, name)(*[1.0] * WITH_PARAMETER[name], m=1j)


def test_lists_and_integers_are_numbers():
    assert same(elliptic.sn([0, 1], m=0.5), elliptic.sn(np.array([0.0, 1.0]), m=0.5))
    assert libration.jacobi_complex(1, m=0.5).sn == libration.jacobi_complex(1.0 + 0j, m=0.5).sn
    assert libration.jacobi_complex([0, 1j], m=0.5).cn.shape == (2,)
    assert libration.carlson_rf(1, 1, 1) == 1.0
