"""Every promise of `functions.toml` against the truth, on both paths, and siblings that must go red."""

import importlib.util
import math
import tomllib
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

import libration

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("accuracy", ROOT / "bench" / "accuracy.py")
accuracy = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(accuracy)


def test_every_promise_holds_in_every_stratum():
    strata = accuracy.measure()
    assert len(strata) == 16
    assert sum(held["rows"] for held in strata.values()) == 1998
    assert accuracy.failures(strata) == []


def spoiled_velocity(self, t, out=None):
    return -libration.motion(t, self.theta0, self.velocity0, self.omega0)[1]


def spoiled_theta(self, t, out=None):
    return libration.theta(math.fmod(t, self.period), self.theta0, self.velocity0, self.omega0)


def spoiled_advance(theta, velocity, dt, omega0):
    return libration.motion(np.asarray(dt) * (1 + 1e-12), theta, velocity, omega0)


@pytest.mark.parametrize(
    ("owner", "name", "sibling"),
    [
        (libration.Pendulum, "velocity", spoiled_velocity),
        (libration.Pendulum, "theta", spoiled_theta),
        (libration.Pendulum, "period", property(lambda self: self._orbit.period * (1 + 1e-15))),
        (libration.Pendulum, "regime", property(lambda self: libration.Regime.LIBRATION)),
        (libration, "advance", spoiled_advance),
    ],
)
def test_a_spoiled_sibling_turns_red(monkeypatch, owner, name, sibling):
    monkeypatch.setattr(owner, name, sibling)
    assert accuracy.failures(accuracy.measure()) != []


def frequency_errors(pendulum, omega2):
    """How many units in the last place omega0 and omega2 are off, for the exact omega2."""
    with mpmath.workdps(60):
        exact = mpmath.mpf(omega2.numerator) / omega2.denominator
        pairs = [(pendulum.omega0, mpmath.sqrt(abs(exact))), (pendulum.omega2, exact)]
        return [float(abs(got - truth) / math.ulp(float(truth))) for got, truth in pairs]


def test_frequency_keeps_its_last_place():
    table = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))
    promised = [table[f"Pendulum.{name}"]["error_max_ulp"] for name in ("omega0", "omega2")]
    generator = np.random.default_rng(11)
    for a, b in (10.0 ** generator.uniform(-150, 150, (2000, 2))).tolist():
        stated = [
            (libration.Pendulum(1.0, omega0=a), Fraction(a) ** 2),
            (libration.Pendulum(1.0, omega2=a), Fraction(a)),
            (libration.Pendulum(1.0, omega2=-a), -Fraction(a)),
            (libration.Pendulum(1.0, length=a, gravity=b), Fraction(b) / Fraction(a)),
        ]
        for pendulum, omega2 in stated:
            errors = frequency_errors(pendulum, omega2)
            assert all(got <= limit for got, limit in zip(errors, promised, strict=True)), (pendulum, errors)
    assert frequency_errors(libration.Pendulum(1.0, omega2=2.0), Fraction(2 + 2**-50))[1] > 1
    assert frequency_errors(libration.Pendulum(1.0, omega0=2.0), Fraction(-4))[1] > 1


def test_separatrix_neighbours():
    assert libration.Pendulum(math.pi).regime == "libration"
    assert abs(libration.Pendulum(math.pi).period - 154.872602217555) < 1e-11
    below, above = (libration.Pendulum(0.0, math.nextafter(2.0, to)) for to in (0.0, 3.0))
    assert abs(below.period - 77.6324842227139) < 1e-12
    assert abs(above.period - 38.123094930797) < 1e-12
    assert (below.regime, above.regime) == ("libration", "rotation")


def test_energy_ratio_over_a_billion_periods():
    generator = np.random.default_rng(7)
    for theta0, velocity0 in zip(generator.uniform(-3.1, 3.1, 300), generator.uniform(-3.0, 3.0, 300), strict=True):
        pendulum = libration.Pendulum(theta0, velocity0)
        t = pendulum.period * 10 ** generator.uniform(0, 9, 40)
        _, angle = pendulum.turns(t)
        velocity = pendulum.velocity(t)
        for a, v in zip(angle.tolist(), velocity.tolist(), strict=True):
            with mpmath.workdps(40):
                drift = mpmath.sin(mpmath.mpf(a) / 2) ** 2 + mpmath.mpf(v) ** 2 / 4 - pendulum.energy_ratio
            slack = abs(math.sin(a) / 2) * math.ulp(a) + abs(v / 2) * math.ulp(v)
            assert abs(drift) <= 4 * slack + math.ulp(pendulum.energy_ratio)
