"""The promises of `functions.toml` for the elliptic family against the truth, and siblings that must go red.

The unit is ulp + 2^-100 of the condition in all arguments; real and imaginary part are measured apart.
"""

import math
import tomllib
from collections import defaultdict
from fractions import Fraction

import numpy as np
import pytest
from test_accuracy_elliptic import ROOT, error, truth

import libration
from libration import elliptic

TWELVE = "sn cn dn ns nc nd sc cs sd ds cd dc".split()
ROWS = {
    "glaisher": 649,
    "inverse_jacobi": 2182,
    "second_kind": 693,
    "theta_functions": 534,
    "heuman": 616,
    "carlson": 978,
    "third_kind": 914,
    "jacobi_complex": 575,
    "glaisher_complex": 190,
    "from_nome": 98,
}
PARTS = [f"{name}_{part}" for name in ("sn", "cn", "dn") for part in ("re", "im")]


def complex_parts(re, im, **given):
    """The six parts of `jacobi_complex`."""
    u = np.empty(re.shape, complex)
    u.real, u.imag = re, im
    return tuple(part for value in libration.jacobi_complex(u, **given) for part in (value.real, value.imag))


NINE = [name for name in TWELVE if name not in ("sn", "cn", "dn")]


def quotient_parts(name):
    """Both parts of one of the nine of a complex argument."""

    def parts(re, im, **given):
        u = np.empty(re.shape, complex)
        u.real, u.imag = re, im
        value = getattr(elliptic, name)(u, **given)
        return value.real, value.imag

    return parts


# name: file, value of its column `function` if it has one, arguments, outputs, what computes them.
FUNCTIONS = {
    **{name: ("glaisher", None, ["u"], [name], lambda u, f=name, **g: getattr(elliptic, f)(u, **g)) for name in TWELVE},
    **{
        f"arc{name}": (
            *("inverse_jacobi", name, ["x"], ["value"]),
            lambda x, f=f"arc{name}", **g: getattr(elliptic, f)(x, **g),
        )
        for name in TWELVE
    },
    "jacobi_epsilon": ("second_kind", None, ["u"], ["epsilon"], lambda u, **g: libration.jacobi_epsilon(u, **g)),
    "jacobi_zeta": ("second_kind", None, ["u"], ["zeta"], lambda u, **g: libration.jacobi_zeta(u, **g)),
    **{
        f"theta{i}": (
            *("theta_functions", None, ["z"], [f"theta{i}"]),
            lambda z, f=f"theta{i}", **g: getattr(libration, f)(z, **g),
        )
        for i in (1, 2, 3, 4)
    },
    "heuman_lambda": ("heuman", None, ["phi"], ["lambda"], lambda phi, **g: libration.heuman_lambda(phi, **g)),
    **{
        f"carlson_{name}": (
            *("carlson", name, list(arguments), ["value"]),
            lambda *x, f=f"carlson_{name}": getattr(libration, f)(*x),
        )
        for name, arguments in (("rf", "xyz"), ("rc", "xy"), ("rd", "xyz"), ("rj", "xyzp"))
    },
    "complete_pi": ("third_kind", "complete_pi", ["n"], ["value"], lambda n, **g: libration.complete_pi(n, **g)),
    "incomplete_pi": (
        *("third_kind", "incomplete_pi", ["n", "phi"], ["value"]),
        lambda n, phi, **g: libration.incomplete_pi(n, phi, **g),
    ),
    "jacobi_complex": ("jacobi_complex", None, ["re", "im"], PARTS, complex_parts),
    **{
        f"{name} of complex u": (
            *("glaisher_complex", None, ["re", "im"], [f"{name}_re", f"{name}_im"]),
            quotient_parts(name),
        )
        for name in NINE
    },
    "from_nome": ("from_nome", None, ["q"], ["m", "mc"], libration.from_nome),
}
# Those of several outputs are spoiled part by part.
SEVERAL = ["jacobi_complex", "from_nome", *(f"{name} of complex u" for name in NINE)]


def rows_of(function):
    """The rows of a function; the file must have as many as promised."""
    file, label, *_ = FUNCTIONS[function]
    rows = truth(file, ROWS[file])
    return [row for row in rows if label is None or row["function"] == label]


def values(function, rows):
    """One list of outputs for every row, through the keyword that the row names."""
    _, _, arguments, _, call = FUNCTIONS[function]
    places = defaultdict(list)
    for index, row in enumerate(rows):
        places[row.get("given")].append(index)
    found = [None] * len(rows)
    for given, where in places.items():
        columns = [np.array([float.fromhex(rows[i][name]) for i in where]) for name in arguments]
        keyword = {given: np.array([float.fromhex(rows[i]["parameter"]) for i in where])} if given else {}
        got = call(*columns, **keyword)
        outputs = got if isinstance(got, tuple) else (got,)
        for place, index in enumerate(where):
            found[index] = [float(output[place]) for output in outputs]
    return found


def worst(function):
    """The largest error of every stratum and output."""
    rows = rows_of(function)
    largest = {}
    for row, got in zip(rows, values(function, rows), strict=True):
        for output, value in zip(FUNCTIONS[function][3], got, strict=True):
            high, low = (float.fromhex(row[f"{output}_{part}"]) for part in ("hi", "lo"))
            key = row["stratum"], output
            ease = Fraction(row[f"cond_{output}"]) / 2**100
            largest[key] = max(largest.get(key, 0.0), error(value, high, low, ease))
    return largest


def failures(function):
    """The strata that break the promise of functions.toml."""
    promises = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))
    common = "elliptic.arcpq" if function.startswith("arc") else "elliptic.pq"
    promised = promises[function if function in promises else common]["error_max_ulp"]
    return {key: value for key, value in worst(function).items() if not value <= promised}


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_promise_holds_in_every_stratum(function):
    assert failures(function) == {}


def test_every_row_belongs_to_a_function():
    seen = defaultdict(int)
    for function, (file, label, *_) in FUNCTIONS.items():
        if label is not None:
            seen[file] += len(rows_of(function))
    assert dict(seen) == {file: ROWS[file] for file in ("inverse_jacobi", "carlson", "third_kind")}


SPOILED = {
    "a little off": lambda call: lambda *x, **g: call(*x, **g) * (1 + 1e-15),
    "sign lost": lambda call: lambda *x, **g: np.abs(call(*x, **g)),
    "NaN hidden": lambda call: lambda *x, **g: np.nan_to_num(call(*x, **g), nan=0.0, posinf=np.inf, neginf=-np.inf),
    "modulus for parameter": lambda call: lambda *x, **g: call(*x, **({"m": g["k"]} if "k" in g else g)),
    "complement formed again": lambda call: lambda *x, **g: call(*x, **({"m": 1 - g["mc"]} if "mc" in g else g)),
}
NEVER = {  # what a function cannot show: it has no such rows, or the spoiled one is right
    "sign lost": [
        "arccn",
        "arcdn",
        "arcnc",
        "arcnd",
        "arccd",
        "arcdc",
        "theta3",
        "theta4",
        "carlson_rf",
        "carlson_rc",
        "carlson_rd",
    ],
    "NaN hidden": [*TWELVE, "jacobi_epsilon"],
}


def without_parameter(function):
    return function.startswith("carlson")


def shows(function, how):
    if how in ("modulus for parameter", "complement formed again") and without_parameter(function):
        return False
    return function not in NEVER.get(how, [])


@pytest.mark.parametrize("how", SPOILED)
@pytest.mark.parametrize("function", [name for name in FUNCTIONS if name not in SEVERAL])
def test_a_spoiled_sibling_turns_red(monkeypatch, function, how):
    *entry, call = FUNCTIONS[function]
    monkeypatch.setitem(FUNCTIONS, function, (*entry, SPOILED[how](call)))
    assert (failures(function) != {}) == shows(function, how)


@pytest.mark.parametrize(
    ("function", "part"), [(name, part) for name in SEVERAL for part in range(len(FUNCTIONS[name][3]))]
)
def test_a_spoiled_part_turns_red(monkeypatch, function, part):
    *entry, call = FUNCTIONS[function]

    def spoiled(*x, **given):
        parts = list(call(*x, **given))
        parts[part] = parts[part] * (1 + 1e-15)
        return tuple(parts)

    monkeypatch.setitem(FUNCTIONS, function, (*entry, spoiled))
    assert {output for _, output in failures(function)} == {entry[3][part]}


def test_turns_lost_turn_red(monkeypatch):
    for function in ("jacobi_epsilon", "heuman_lambda", "incomplete_pi"):
        *entry, call = FUNCTIONS[function]
        monkeypatch.setitem(
            FUNCTIONS, function, (*entry, lambda *x, c=call, **g: c(*x[:-1], np.remainder(x[-1], math.pi), **g))
        )
        assert failures(function) != {}
