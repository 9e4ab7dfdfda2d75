"""The claims: the measured value of every row supports its verdict, and a row with a wrong value is found."""

import dataclasses
import math

import pytest

from libration.papers import Claim, Verdict, claims
from libration.papers._claim import rounded, within

ROWS = claims()


@pytest.mark.parametrize("row", ROWS, ids=[f"{row.work} {row.place} {row.printed}" for row in ROWS])
def test_every_claim_stands(row):
    assert row.stands, (row.claim, row.value)


@pytest.mark.parametrize("row", [row for row in ROWS if row.measured], ids=lambda row: f"{row.work} {row.place}")
def test_a_mutated_value_does_not_stand(row):
    assert not dataclasses.replace(row, measured=lambda: math.nan).stands
    wrong = row.allows[0] - 1 if row.corrected is None else sum(row.allows) / 2
    assert not dataclasses.replace(row, measured=lambda: wrong).stands


def test_what_is_not_reproducible_has_a_reason():
    left = [row for row in ROWS if row.verdict is Verdict.NOT_REPRODUCIBLE]
    assert [row.place for row in left] == [
        "example 1, fig. 3",
        "example 2, fig. 4",
        "example 3, fig. 6",
        "example 4, fig. 7",
    ]
    assert all(row.reason for row in left)
    assert not Claim("w", "p", "c", "1").stands


@pytest.mark.parametrize(
    ("text", "value"),
    [
        # max |difference| / theta0 over a period, from mpmath, without this package.
        ("harmonic approximation (17) at θ₀ = π/3", 0.9413),
        ("N = 1 at θ₀ = π/3", 1.951),
        ("N = 2 at θ₀ = π/3", 0.03496),
        ("harmonic approximation (17) at θ₀ = π/2", 2.329),
        ("N = 2 at θ₀ = π/2", 0.2269),
        ("harmonic approximation (17) at θ₀ = 4π/5", 8.598),
        ("N = 3 at θ₀ = 4π/5", 0.6069),
        ("harmonic approximation (17) at θ₀ = 7π/8", 12.34),
        ("N = 4 at θ₀ = 7π/8", 0.3989),
        ("N = 6 at θ₀ = 0.95π", 0.2945),
    ],
)
def test_limas_percentages(text, value):
    row = next(row for row in ROWS if row.claim.endswith(text))
    assert float(f"{row.value:.4g}") == value
    assert row.ours == f"{value:.4g} %"


def test_verdicts_that_must_not_change():
    corrected = {(row.work, row.printed) for row in ROWS if row.verdict is Verdict.CORRECTED}
    assert {("Lima 2019", "0.04 %"), ("Salas 2019", "|m| < 1"), ("Horsley 2025", "13")} <= corrected
    places = {row.place for row in ROWS if row.verdict is Verdict.CORRECTED}
    assert {"(25)", "(26)", "(27)", "(28)", "conclusions", "(3)", "appendix, code"} <= places


def test_one_paper_at_a_time():
    assert sum(len(claims(work)) for work in ("salas", "lima", "horsley")) == len(ROWS)
    with pytest.raises(ValueError, match="unknown paper 'slas': must be salas, lima or horsley"):
        claims("slas")


def test_intervals():
    assert rounded("0.04") == (0.035, 0.045)
    assert rounded("2") == (1.5, 2.5)
    assert within(2.0, (1.0, 2.0))
    assert not within(math.nan, (-math.inf, math.inf))
