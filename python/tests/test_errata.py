"""The errata: the corrected form passes its check, the printed form fails it, and the checks find errors."""

import math

import numpy as np
import pytest

import libration
from libration.papers import Erratum, Kind, errata
from libration.papers._erratum import largest, motion_residual, pendulum_residual, second_derivative

ROWS = errata()
NAMES = [f"{row.work} {row.place}" for row in ROWS]


@pytest.mark.parametrize("row", ROWS, ids=NAMES)
def test_corrected_form_holds(row):
    assert row.holds(row.corrected_form), row.corrected_residual


@pytest.mark.parametrize("row", ROWS, ids=NAMES)
def test_printed_form_in_its_place_fails(row):
    assert not row.holds(row.printed_form), row.printed_residual


@pytest.mark.parametrize("row", ROWS, ids=NAMES)
def test_the_printed_form_fails_clearly(row):
    # A wrong formula exceeds the tolerance several times; a wrong rounding to two decimals need not.
    if row.printed != "N = 2 at π/3: 0.04 %":
        assert not row.printed_residual < 4 * row.tolerance


def test_every_row_says_what_it_is():
    for row in ROWS:
        assert isinstance(row, Erratum)
        assert isinstance(row.kind, Kind)
        assert row.printed != row.corrected
        assert all((row.work, row.place, row.printed, row.corrected, row.why, row.measure))
        assert math.isfinite(row.corrected_residual)
    assert [sum(row.work == work for row in ROWS) for work in ("Salas 2019", "Lima 2019", "Horsley 2025")] == [
        21,
        6,
        12,
    ]
    assert {row.kind for row in ROWS} == set(Kind)


@pytest.mark.parametrize(
    ("work", "place", "residual"),
    [
        # From mpmath and a separate integrator, without this package.
        ("Salas 2019", "(25)", 0.75),
        ("Salas 2019", "conclusions", 0.0595),
        ("Lima 2019", "section 4", 0.0751),
        ("Horsley 2025", "historical development", 1.0),
    ],
)
def test_known_residuals(work, place, residual):
    row = next(row for row in ROWS if (row.work, row.place) == (work, place))
    assert row.printed_residual == pytest.approx(residual, rel=2e-3)


def test_the_residual_of_a_motion_is_rounding_and_of_a_changed_one_is_not():
    t = np.linspace(0.1, 3.0, 30)
    swing = libration.Pendulum(2.5, 0.3)
    assert motion_residual(swing.theta, np.sin, t) < 1e-9
    assert motion_residual(lambda t: swing.theta(t) * (1 + 1e-6), np.sin, t) > 1e-7
    assert np.allclose(second_derivative(np.sin, t), -np.sin(t), atol=1e-11)


def test_initial_state_counts():
    assert pendulum_residual(libration.theta) < 1e-9
    assert pendulum_residual(lambda t, theta0, velocity0: libration.theta(t, theta0, -velocity0)) > 1e-3
    assert pendulum_residual(lambda t, theta0, velocity0: libration.theta(t, theta0 + 1e-5, velocity0)) > 9e-6


def test_no_value_is_no_pass():
    assert math.isnan(largest([0.0, math.nan]))
    row = Erratum("w", "p", "a", "b", "c", Kind.PAPER, "m", 1.0, lambda form: form, math.nan, 0.5)
    assert row.holds(row.corrected_form)
    assert not row.holds(row.printed_form)
    assert not row.holds(math.inf)
