"""The promises of `functions.toml` for the elliptic functions against the truth, and siblings that must go red.

The unit of `jacobi` is ulp + 2^-100 of the condition in u; that of the integrals and the nome is the ulp alone.
"""

import csv
import math
import tomllib
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import libration

ROOT = Path(__file__).parents[2]
ROWS = {"jacobi": 2823, "complete": 697, "incomplete": 1467, "jacobi_special": 116}
# Per function: its file, the column of its first argument, its outputs, and whether the condition eases.
FUNCTIONS = {
    "jacobi": ("jacobi", ["u"], ["sn", "cn", "dn", "am"], True),
    "complete_k": ("complete", [], ["complete_k"], False),
    "complete_e": ("complete", [], ["complete_e"], False),
    "nome": ("complete", [], ["nome"], False),
    "incomplete_f": ("incomplete", ["phi"], ["incomplete_f"], False),
    "incomplete_e": ("incomplete", ["phi"], ["incomplete_e"], False),
}


def truth(file, count=None):
    """The rows of a file of vectors; one that is missing or short is an error."""
    with (ROOT / f"reference/vectors/{file}.csv").open(newline="", encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == (count or ROWS[file])
    return rows


def values(function, rows, arguments):
    """What the function gives for every row, one list per output, through the keyword that the row names."""
    found = [None] * len(rows)
    for given in ("m", "mc", "k"):
        where = [index for index, row in enumerate(rows) if row["given"] == given]
        columns = [np.array([float.fromhex(rows[i][name]) for i in where]) for name in (*arguments, "parameter")]
        got = getattr(libration, function)(*columns[:-1], **{given: columns[-1]})
        outputs = got if isinstance(got, tuple) else (got,)
        for place, index in enumerate(where):
            found[index] = [float(output[place]) for output in outputs]
    return found


def error(got, high, low, ease=Fraction(0)):
    """|got - (hi + lo)| in units of ulp + ease; infinite for NaN and for an infinity on one side only."""
    if not (math.isfinite(got) and math.isfinite(high)):
        return 0.0 if got == high or (got != got and high != high) else math.inf
    ratio = abs(Fraction(got) - Fraction(high) - Fraction(low)) / (Fraction(math.ulp(high)) + ease)
    return float(ratio) if ratio < 2**1000 else math.inf


def worst(function):
    """The largest error of every stratum and output."""
    file, arguments, outputs, eased = FUNCTIONS[function]
    rows = truth(file)
    largest = {}
    for row, got in zip(rows, values(function, rows, arguments), strict=True):
        for output, value in zip(outputs, got, strict=True):
            high, low = (float.fromhex(row[f"{output}_{part}"]) for part in ("hi", "lo"))
            ease = Fraction(row[f"cond_{output}"]) / 2**100 if eased else Fraction(0)
            key = row["stratum"], output
            largest[key] = max(largest.get(key, 0.0), error(value, high, low, ease))
    return largest


def failures(function):
    """The strata that break the promise of functions.toml."""
    promised = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))[function]["error_max_ulp"]
    return {key: value for key, value in worst(function).items() if not value <= promised}


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_promise_holds_in_every_stratum(function):
    assert failures(function) == {}


def test_limits_are_exact():
    rows = truth("jacobi_special")
    for row, got in zip(rows, values("jacobi", rows, ["u"]), strict=True):
        for output, value in zip(("sn", "cn", "dn", "am"), got, strict=True):
            expected = float.fromhex(row[output])
            assert (value, math.copysign(1, value)) == (expected, math.copysign(1, expected)) or (
                math.isnan(value) and math.isnan(expected)
            ), row


JACOBI, COMPLETE_K, COMPLETE_E = libration.jacobi, libration.complete_k, libration.complete_e
NOME, INCOMPLETE_F, INCOMPLETE_E = libration.nome, libration.incomplete_f, libration.incomplete_e


def modulus_for_parameter(u, *, m=None, mc=None, k=None):
    return JACOBI(u, m=m, mc=mc) if k is None else JACOBI(u, m=k)


def wrapped(u, **given):
    sn, cn, dn, am = JACOBI(u, **given)
    return sn, cn, dn, np.where(np.isfinite(am), np.remainder(am, 2 * math.pi), am)


def turns_lost(phi, **given):
    finite = np.isfinite(phi)
    return INCOMPLETE_F(np.where(finite, np.remainder(np.where(finite, phi, 0.0), 2 * math.pi), phi), **given)


def complement_lost(*, m=None, mc=None, k=None):
    return COMPLETE_K(m=m, k=k) if mc is None else COMPLETE_K(m=1 - mc)


@pytest.mark.parametrize(
    ("function", "sibling"),
    [
        ("jacobi", modulus_for_parameter),
        ("jacobi", wrapped),
        ("complete_k", complement_lost),
        ("complete_e", lambda **given: COMPLETE_E(**given) * (1 + 1e-15)),
        ("nome", lambda **given: abs(NOME(**given))),
        ("incomplete_f", turns_lost),
        ("incomplete_e", lambda phi, **given: INCOMPLETE_E(np.abs(phi), **given)),
    ],
)
def test_a_spoiled_sibling_turns_red(monkeypatch, function, sibling):
    monkeypatch.setattr(libration, function, sibling)
    assert failures(function) != {}


def test_the_ruler_sees_nan_signs_and_infinities():
    assert error(math.nan, 1.0, 0.0) == error(1.0, math.nan, 0.0) == error(math.inf, 1.0, 0.0) == math.inf
    assert error(-math.inf, math.inf, 0.0) == math.inf
    assert error(math.inf, math.inf, 0.0) == error(math.nan, math.nan, 0.0) == 0.0
    assert error(-1.0, 1.0, 0.0) > 1e15
    assert error(-1.0 - math.ulp(1.0), -1.0, 0.0) == 1.0
    assert error(1.0, 1.0, math.ulp(0.25)) == 0.25
