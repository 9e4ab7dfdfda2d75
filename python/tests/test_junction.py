"""The Josephson junction of docs/junction.py against what is known of it: Bessel's functions, and the overdamped limit."""

import importlib.util
import math
from pathlib import Path

import mpmath
import numpy as np
import pytest

PLACE = Path(__file__).resolve().parents[2] / "docs/junction.py"


@pytest.fixture(scope="module")
def junction():
    specification = importlib.util.spec_from_file_location("junction", PLACE)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


@pytest.mark.parametrize("n", [0, 1, 2])
def test_widths_of_the_steps(junction, n):
    """Where the drive is fast the width of step n is 2 |J_n(b)|, b being the swing of the free phase under the drive."""
    given = {"alpha": 3.0, "frequency": 3.0}
    swing = 1.0
    drive = junction.drive_of(swing, **given)
    expected = 2 * abs(float(mpmath.besselj(n, swing)))
    width = junction.step_width(n, drive=drive, expected=expected, halvings=8, **given)
    assert abs(width - expected) < 0.01
    # The swing of a junction without capacitance is another one, and so are the widths.
    wrong = 2 * abs(float(mpmath.besselj(n, drive / (3.0 * 3.0))))
    assert abs(width - wrong) > 0.04


def test_steps_stand_at_multiples_of_the_frequency(junction):
    given = {"alpha": 2.5, "frequency": 0.4}
    found = junction.voltages([0.1, 1.0, 2.2, 3.15], drive=2.2, average=20, **given)
    assert np.allclose(found, [0, 1, 2, 3], atol=1e-6)
    between = junction.voltages([0.4, 1.7], drive=2.2, average=20, **given)
    assert np.abs(between - np.round(between)).min() > 0.02


def test_the_overdamped_limit(junction):
    """Without a drive and without capacitance the voltage is sqrt(i^2 - 1)/alpha."""
    alpha, current = 30.0, 1.5
    mean = math.sqrt(current**2 - 1) / alpha
    # As many periods of the motion as are averaged over.
    [found] = junction.voltages([current], alpha=alpha, drive=0.0, frequency=mean, settle=2, average=10)
    assert abs(found - 1) < 2e-3


def test_the_swing_and_its_drive(junction):
    assert junction.swing(
        alpha=2.0, drive=junction.drive_of(1.3, alpha=2.0, frequency=0.7), frequency=0.7
    ) == pytest.approx(1.3)
