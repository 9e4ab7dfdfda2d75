"""Buckets: rings of the reference, tunes against tracking, ways to the pendulum and back, refusals."""

import csv
import math
import pickle

import numpy as np
import pytest
from test_accuracy_elliptic import ROOT

from libration.ensemble import Bucket, track

PROTON = 938.272_088e6
LHC = {
    "voltage": 8e6,
    "harmonic": 35640,
    "energy": 450e9,
    "mass": PROTON,
    "charge": 1,
    "circumference": 26658.883,
    "momentum_compaction": 3.225e-4,
}
# A booster, below transition; ions; and electrons of a light source.
BOOSTER = {
    "voltage": 8e3,
    "harmonic": 1,
    "energy": PROTON + 160e6,
    "mass": PROTON,
    "charge": 1,
    "circumference": 157.08,
}
BOOSTER["momentum_compaction"] = 1 / 4.1**2
LEAD = LHC | {"energy": 82 * 450e9, "mass": 193.687e9, "charge": 82}
LIGHT_SOURCE = {"voltage": 2e6, "harmonic": 400, "energy": 3e9, "mass": 510998.95, "charge": -1, "circumference": 500.0}
LIGHT_SOURCE["momentum_compaction"] = 1e-3
RINGS = {"LHC": LHC, "booster": BOOSTER, "lead": LEAD, "light source": LIGHT_SOURCE}
rings = pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)


def turn_by_turn(ring, zeta, delta, turns):
    """An independent ring: half a drift, one cavity, half a drift, in zeta and delta; yields each turn's state."""
    gamma = ring["energy"] / ring["mass"]
    beta2 = 1 - 1 / gamma**2
    eta = ring["momentum_compaction"] - 1 / gamma**2
    kick = abs(ring["charge"]) * ring["voltage"] / (beta2 * ring["energy"])
    for _ in range(turns):
        zeta = zeta - 0.5 * eta * ring["circumference"] * delta
        # The phase of the cavity is such that the middle is stable.
        delta = delta + math.copysign(kick, eta) * np.sin(2 * math.pi * ring["harmonic"] * zeta / ring["circumference"])
        zeta = zeta - 0.5 * eta * ring["circumference"] * delta
        yield zeta, delta


def crossings(values):
    """The mean distance of upward passages through 0, which are interpolated."""
    values = np.asarray(values)
    places = np.flatnonzero((values[:-1] < 0) & (values[1:] >= 0))
    exact = places + values[places] / (values[places] - values[places + 1])
    return (exact[-1] - exact[0]) / (len(exact) - 1)


def reference_rings():
    """The rings of reference/vectors/rings.csv: the arguments, and what is known of each as pairs of doubles."""
    with (ROOT / "reference/vectors/rings.csv").open(newline="") as file:
        rows = [{name: row[name] for name in row if name != "stratum"} for row in csv.DictReader(file)]
    assert len(rows) == 9
    for row in rows:
        numbers = {name: float.fromhex(value) for name, value in row.items()}
        given = {name: numbers[name] for name in LHC} | {"harmonic": int(numbers["harmonic"])}
        yield (
            given,
            {name[:-3]: (numbers[name], numbers[f"{name[:-3]}_lo"]) for name in numbers if name.endswith("_hi")},
        )


def test_truth():
    for given, truth in reference_rings():
        bucket = Bucket(**given)
        # A difference of two numbers that are nearly alike next to transition: what an ulp of them is of it.
        lost = (abs(given["momentum_compaction"]) + (given["mass"] / given["energy"]) ** 2) / abs(bucket.slip_factor)
        for name, (hi, lo) in truth.items():
            found = bucket.tune(2.0) if name == "tune" else getattr(bucket, name)
            ulps = abs((found - hi) - lo) / math.ulp(hi) / (1 if name == "revolution_frequency" else lost)
            assert ulps <= 4, (given, name, ulps)
            spoiled = found * (1 + 1e-14 * lost)
            assert abs((spoiled - hi) - lo) / math.ulp(hi) / lost > 4, "a spoiled value must show"


@rings
def test_small_amplitudes_go_round_as_a_ring_tracked_turn_by_turn(ring):
    bucket = Bucket(**ring)
    zeta = 1e-4 * ring["circumference"] / ring["harmonic"]
    path = [state[0] for state in turn_by_turn(ring, zeta, 0.0, math.ceil(20 / bucket.qs))]
    assert abs(crossings(path) * math.asin(math.pi * bucket.qs) / math.pi - 1) < 1e-7
    assert abs(crossings(path) * bucket.qs * 1.01 - 1) > 1e-3, "a spoiled tune must show"
    assert abs(bucket.lumped_tune(0.0) * math.pi / math.asin(math.pi * bucket.qs) - 1) < 1e-9
    assert abs(bucket.tune(0.0) / bucket.qs - 1) < 1e-15


@rings
def test_large_amplitudes_too(ring):
    bucket = Bucket(**ring)
    amplitudes = np.array([1.0, 2.0, 2.8])
    zeta, _ = bucket.from_pendulum(amplitudes, 0.0)
    paths = np.array([state[0] for state in turn_by_turn(ring, zeta, 0.0, math.ceil(60 / bucket.qs))]).T
    found = bucket.lumped_tune(amplitudes)
    for tune, path in zip(found, paths, strict=True):
        assert abs(crossings(path) * tune - 1) < 2e-6
    assert np.abs(found / bucket.tune(amplitudes) - 1).max() < 2 * bucket.qs**2


def test_the_map_differs_from_the_pendulum_by_the_square_of_qs():
    parts = []
    for voltage in (5e5, 5e6, 5e7):
        bucket = Bucket(**LIGHT_SOURCE | {"voltage": voltage})
        apart = bucket.lumped_tune([0.0, 2.0]) / bucket.tune([0.0, 2.0]) - 1
        x = math.pi * bucket.qs
        assert abs(apart[0] / (math.asin(x) / x - 1) - 1) < 1e-3
        parts.append(apart[1] / bucket.qs**2)
    # Lower at large amplitudes, and higher at small ones.
    assert max(parts) < -0.5 and max(parts) / min(parts) > 0.99


def test_no_tune_where_there_is_no_regular_motion():
    strong = Bucket(**LIGHT_SOURCE | {"voltage": 2e9})
    assert 0.1 < strong.qs < 0.3
    assert math.isnan(strong.lumped_tune(3.1)) and math.isfinite(strong.lumped_tune(0.5))
    assert math.isnan(Bucket(**LIGHT_SOURCE | {"voltage": 2e10}).lumped_tune(0.5))
    for tune in (strong.tune, strong.lumped_tune):
        assert np.isnan(tune([math.pi, -4.0, math.nan, math.inf])).all()
        assert tune(-0.5) == tune(0.5) == tune([[0.5]])[0, 0]


@rings
def test_the_way_to_the_pendulum_and_back(ring):
    bucket = Bucket(**ring)
    zeta, delta = np.random.default_rng(1).normal(size=(2, 100))
    zeta, delta = zeta * 0.1 * ring["circumference"] / ring["harmonic"], delta * 0.3 * bucket.height
    theta, velocity = bucket.to_pendulum(zeta, delta)
    again = bucket.from_pendulum(theta, velocity)
    assert np.allclose(again[0], zeta, rtol=1e-15) and np.allclose(again[1], delta, rtol=1e-15)
    # The height is the separatrix at the bottom.
    assert abs(abs(bucket.to_pendulum(0.0, bucket.height)[1]) / (2 * bucket.omega0) - 1) < 1e-14
    # Turn by turn and by the pendulum: the same motion, but for O(qs**2) of a turn a turn.
    turns = 40
    [*_, after] = turn_by_turn(ring, zeta, delta, turns)
    theta, velocity, _ = track(theta, velocity, 1 / bucket.revolution_frequency, bucket.omega0, steps=turns)
    there = bucket.from_pendulum(theta, velocity)
    inside = np.abs(zeta) < 0.2 * ring["circumference"] / ring["harmonic"]
    assert np.abs(there[0] - after[0])[inside].max() < 30 * bucket.qs**2 * zeta.std()
    assert np.abs(there[1] - after[1])[inside].max() < 30 * bucket.qs**2 * bucket.height
    # The area, from the shape of the separatrix in zeta and delta, by the trapezoidal rule.
    places = np.linspace(-0.5, 0.5, 20_001) * ring["circumference"] / ring["harmonic"]
    heights = bucket.height * np.cos(math.pi * places * ring["harmonic"] / ring["circumference"])
    gamma = ring["energy"] / ring["mass"]
    seconds = math.sqrt(1 - 1 / gamma**2) * 299792458.0
    energy = (1 - 1 / gamma**2) * ring["energy"]
    assert abs(2 * np.trapezoid(heights * energy, places) / seconds / bucket.area - 1) < 1e-7


@pytest.mark.parametrize("distribution", ["gaussian", "waterbag", "parabolic"])
def test_matched_bunches(distribution):
    bucket = Bucket(**LHC)
    zeta, delta = bucket.matched(100_000, bunch_length=0.08, seed=1, distribution=distribution)
    assert abs(zeta.std() / 0.08 - 1) < 0.01
    theta, velocity = bucket.to_pendulum(zeta, delta)
    turn = 1 / bucket.revolution_frequency
    theta, velocity, _ = track(theta, velocity, 5000 * turn, bucket.omega0, steps=1)
    later = bucket.from_pendulum(theta, velocity)
    assert abs(later[0].std() / zeta.std() - 1) < 0.01 and abs(later[1].std() / delta.std() - 1) < 0.01
    small = bucket.matched(100_000, emittance=1e-4, seed=1, distribution=distribution)
    area = math.pi * (small[0].std() / 299792458.0) * (small[1].std() * 450e9)
    assert abs(1e-4 / area / {"gaussian": 4, "waterbag": 4, "parabolic": 6}[distribution] - 1) < 0.02
    part = bucket.matched(10, emittance=1e-4, seed=1, distribution=distribution, first=50)
    assert np.array_equal(part, [each[50:60] for each in small])


def test_a_bucket_does_not_change():
    bucket = Bucket(**LHC)
    assert pickle.loads(pickle.dumps(bucket)) == bucket == Bucket(**LHC) != Bucket(**BOOSTER)
    assert hash(bucket) == hash(Bucket(**LHC)) and eval(repr(bucket)) == bucket
    with pytest.raises(AttributeError, match="does not change"):
        bucket.voltage = 1.0
    assert Bucket(**LHC, synchronous_phase=math.pi).qs == bucket.qs


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"voltage": 0.0}, "voltage = 0.0: must be positive and finite"),
        ({"voltage": "8MV"}, "voltage = '8MV': must be one real number"),
        ({"harmonic": 0}, "harmonic = 0: must be positive"),
        ({"harmonic": 1.5}, "harmonic = 1.5: must be a whole number"),
        ({"energy": 450e6}, "energy = 450000000.0: must be the whole energy in eV, above mass, 938272088.0"),
        ({"charge": 0}, "charge = 0.0: must not be 0"),
        ({"momentum_compaction": math.nan}, "momentum_compaction = nan: must be finite"),
        (
            {"momentum_compaction": (PROTON / 450e9) ** 2},
            f"momentum_compaction = {(PROTON / 450e9) ** 2!r}: must not be 1/gamma**2; there is no bucket at transition",
        ),
        ({"voltage": 1e300, "energy": 1e12, "charge": 1e300}, "qs = inf of these numbers: must be within the doubles"),
    ],
)
def test_bad_input_is_one_line(arguments, said):
    with pytest.raises(ValueError) as caught:
        Bucket(**LHC | arguments)
    assert str(caught.value).startswith(said) and "\n" not in str(caught.value)


def test_an_accelerating_bucket_is_told_where_to_go():
    with pytest.raises(ValueError) as caught:
        Bucket(**LHC, synchronous_phase=0.5)
    said = str(caught.value)
    assert said.startswith("synchronous_phase = 0.5: must be 0 or pi") and "\n" not in said
    assert "order8" in said and "DampedPendulum(torque=)" in said


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({}, "no width given: matched takes one of emittance=, bunch_length="),
        ({"emittance": 1.0, "bunch_length": 0.1}, "emittance and bunch_length given: matched takes one of"),
        ({"emittance": 2.0}, "emittance = 2.0: must be positive and below the area of the bucket, 1.42"),
        ({"bunch_length": 0.3}, "bunch_length = 0.3: must be positive and below 0.162"),
        (
            {"bunch_length": 0.1, "distribution": "thermal"},
            "distribution = 'thermal': must be one of gaussian, waterbag",
        ),
        ({"bunch_length": 0.1, "seed": "a"}, "seed = 'a': must be a whole number"),
    ],
)
def test_bad_bunches_are_one_line(arguments, said):
    with pytest.raises(ValueError) as caught:
        Bucket(**LHC).matched(10, **{"seed": 1} | arguments)
    assert str(caught.value).startswith(said) and "\n" not in str(caught.value)


def test_text_is_no_place():
    for call in (Bucket(**LHC).to_pendulum, Bucket(**LHC).from_pendulum):
        with pytest.raises(TypeError, match="must be real numbers"):
            call("a", 1.0)
    with pytest.raises(TypeError, match="theta_max = 'a': must be real numbers"):
        Bucket(**LHC).tune("a")
    for call in (Bucket(**LHC).tune, Bucket(**LHC).lumped_tune):
        with pytest.raises(TypeError, match=r"theta_max = 1j: must be real numbers; write theta_max.real"):
            call(1j)
    with pytest.raises(TypeError, match="delta = 1j: must be real numbers"):
        Bucket(**LHC).to_pendulum(1.0, 1j)
