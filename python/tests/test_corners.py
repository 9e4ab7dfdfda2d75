"""Every row of docs/corners.toml: the table of docs/corners.md is what the library does."""

import math
import tomllib
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import libration
from libration import Pendulum

ROOT = Path(__file__).resolve().parents[2]
CORNERS = tomllib.loads((ROOT / "docs/corners.toml").read_text(encoding="utf-8"))["corner"]
NAMES = {"Pendulum": Pendulum, "libration": libration, "math": math}


def error(got: float, truth: str, digits: int | None) -> float:
    """Distance from the truth in units of 4 ulp, or of the last digit given."""
    if truth in ("nan", "inf", "-inf"):
        expected = float(truth)
        return 0.0 if got == expected or (math.isnan(got) and math.isnan(expected)) else math.inf
    if not math.isfinite(got):
        return math.inf
    distance = abs(Fraction(float(got)) - Fraction(truth))
    unit = Fraction(abs(float(truth))) / 10 ** (digits - 1) if digits else 4 * Fraction(math.ulp(float(truth)))
    return float(distance / unit) if distance else 0.0


@pytest.mark.parametrize("corner", CORNERS, ids=[corner["title"] for corner in CORNERS])
def test_corner(corner):
    if "message" in corner:
        with pytest.raises(ValueError) as caught:
            eval(corner["call"], dict(NAMES))
        assert str(caught.value) == corner["message"]
        return
    got = eval(corner["call"], dict(NAMES))
    if isinstance(corner["gives"], str):
        assert repr(got) == corner["gives"]
        return
    values = np.atleast_1d(got)
    assert len(values) == len(corner["gives"])
    for value, truth in zip(values, corner["gives"], strict=True):
        assert error(value, truth, corner.get("digits")) <= 1, (value, truth)


def test_a_wrong_corner_is_found():
    assert error(1.0 + 2e-15, "1", None) > 1
    assert error(-0.5, "0.5", None) > 1
    assert error(math.nan, "0", None) > 1
    assert error(math.inf, "nan", None) > 1
    assert error(1e-300, "0", None) > 1
