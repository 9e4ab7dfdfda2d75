"""The verdict of the elliptic page can fail, and a library is asked only for what it states."""

import math

import pytest
from measurement.elliptic_family import PROMISED, keyword, measured, verdict
from rivals.elliptic_family import Rival, functions, unit

import libration

ROW = {"value_hi": (2.0).hex(), "value_lo": (2.0**-55).hex(), "cond_value": "1.0e0"}
BY_NAME = {function.name: function for function in functions()}


def verdict_of(got, **changed):
    return verdict({**ROW, **changed}, "value", got)


def test_a_wrong_value_is_wrong():
    assert verdict_of(2.0) == ("answer", pytest.approx(0.0625, rel=1e-6))
    assert verdict_of(2.0 + 2.0**-51)[1] > 0.9
    assert verdict_of(math.nan) == ("none", math.inf)
    assert verdict_of(-2.0)[0] == verdict_of(2.001)[0] == verdict_of(math.inf)[0] == "wrong"
    assert verdict_of(-math.inf, value_hi="inf")[0] == "wrong"
    assert verdict_of(math.inf, value_hi="inf") == ("answer", 0.0)
    assert verdict_of(2.001, cond_value="1e40")[0] == "answer"
    assert verdict_of(0.0, value_hi="0x0.0p+0", value_lo="0x0.0p+0") == ("answer", 0.0)
    assert verdict_of(1e-20, value_hi="0x0.0p+0", value_lo="0x0.0p+0")[0] == "wrong"


def test_parts_of_a_complex_value_share_a_unit():
    row = {"sn_re_hi": (1.0).hex(), "sn_im_hi": (1e-30).hex(), "sn_re_lo": "0x0p+0", "sn_im_lo": "0x0p+0"}
    row |= {"cond_sn_re": "0", "cond_sn_im": "0"}
    assert verdict(row, "sn_im", 2e-30) == ("answer", pytest.approx(1e-30 / 2**-52))
    assert verdict(row, "sn_im", 1e-3)[0] == "wrong"


def test_only_what_a_library_states_is_asked():
    row = {"given": "mc", "parameter": (0.25).hex(), "u": (1.0).hex()}
    sn = BY_NAME["sn"]
    assert keyword(row, sn, None) == {"mc": 0.25}
    assert keyword(row, sn, Rival("", None, inside=unit)) == {"m": 0.75}
    assert keyword({**row, "parameter": (1e-30).hex()}, sn, Rival("", None)) is None
    assert keyword({**row, "parameter": (2.0).hex()}, sn, Rival("", None, inside=unit)) is None
    assert keyword({**row, "parameter": (1e-30).hex()}, sn, Rival("", None, ("m", "mc"))) == {"mc": 1e-30}
    pole = {"given": "m", "parameter": (0.5).hex(), "n": (3.0).hex(), "phi": (1.0).hex()}
    assert keyword(pole, BY_NAME["incomplete_pi"], BY_NAME["incomplete_pi"].mpmath) is None


def test_a_mutated_function_is_found():
    right = measured(BY_NAME["carlson_rf"], None)
    assert (right["within"], right["wrong"], right["none"]) == (right["rows"], 0, 0)
    mutated = vars(BY_NAME["carlson_rf"]) | {"ours": lambda *x: libration.carlson_rf(*x) * (1 + 1e-14)}
    assert measured(type(BY_NAME["carlson_rf"])(**mutated), None)["worst"] > PROMISED
    refused = vars(BY_NAME["carlson_rf"]) | {"ours": lambda *x: math.nan}
    assert measured(type(BY_NAME["carlson_rf"])(**refused), None)["none"] == right["rows"]
