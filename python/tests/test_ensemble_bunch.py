"""Bunches: the same particles however they are cut, the distributions they are of, and that matched ones stay."""

import csv
import math
from itertools import pairwise

import numpy as np
import pytest
import scipy.stats
from test_accuracy_elliptic import ROOT

import libration
from libration.ensemble import bunch
from libration.ensemble._density import rms, scale_of
from libration.ensemble._uniform import STEPS, uniforms

OMEGA0 = 2.5
EDGE = 8 / math.pi * OMEGA0
MATCHED = {
    "gaussian": {"distribution": "gaussian", "sigma_theta": 0.8},
    "gaussian by action": {"distribution": "gaussian", "action": 1.5},
    "waterbag": {"distribution": "waterbag", "sigma_theta": 0.9},
    "waterbag to the edge": {"distribution": "waterbag", "energy_ratio": 1.0},
    "parabolic": {"distribution": "parabolic", "energy_ratio": 0.9},
    "parabolic by action": {"distribution": "parabolic", "action": 3.0},
    "thermal": {"distribution": "thermal", "temperature": 4.0},
    "hot": {"distribution": "thermal", "temperature": 1e9},
    "canonical": {"distribution": "thermal", "temperature": 4.0, "rotations": True},
    "one orbit": {"distribution": "microcanonical", "energy_ratio": 0.7},
    "two orbits": {"distribution": "microcanonical", "energy_ratio": 1.7},
}
UNMATCHED = {
    name: {"distribution": name, "sigma_theta": 0.5, "matched": False} for name in ("gaussian", "waterbag", "parabolic")
}
every = pytest.mark.parametrize("kind", [*MATCHED.values(), *UNMATCHED.values()], ids=[*MATCHED, *UNMATCHED])
matched = pytest.mark.parametrize("kind", MATCHED.values(), ids=MATCHED)


def ratio(theta, velocity, omega0=OMEGA0):
    return np.sin(theta / 2) ** 2 + (velocity / (2 * omega0)) ** 2


def probability(values, cumulative):
    """The p-value of Kolmogorov and Smirnov's test; a fixed seed, so it is one number for all time."""
    return scipy.stats.kstest(values, cumulative).pvalue


@every
@pytest.mark.parametrize("quiet", [False, True])
def test_any_chunks_are_the_whole_bit_for_bit(kind, quiet):
    whole = bunch(70_000, seed=7, omega0=OMEGA0, quiet=quiet, **kind)
    for cuts in ([0, 1, 3, 10, 32_768, 65_537, 70_000], [0, 35_000, 70_000], [0, 69_999, 70_000]):
        pairs = list(pairwise(cuts))
        parts = [bunch(end - first, first=first, seed=7, omega0=OMEGA0, quiet=quiet, **kind) for first, end in pairs]
        for column in (0, 1):
            assert np.concatenate([part[column] for part in parts]).tobytes() == whole[column].tobytes()
    far = bunch(2, seed=7, omega0=OMEGA0, quiet=quiet, first=2**62, **kind)
    assert np.isfinite(far).all()


@every
def test_seeds_are_bunches_of_their_own(kind):
    first, same, other = (bunch(1000, seed=seed, omega0=OMEGA0, **kind) for seed in (1, 1, 2))
    assert np.array_equal(first, same)
    assert not (first[0] == other[0]).any()


@matched
def test_a_matched_bunch_stays(kind):
    theta, velocity = bunch(60_000, seed=3, omega0=OMEGA0, **kind)
    later, faster = libration.motion(1000.0, theta, velocity, OMEGA0)
    later -= math.tau * np.round(later / math.tau)
    # Both samples are of one distribution; they are of the same particles, which have forgotten their phases.
    assert scipy.stats.ks_2samp(theta, later).pvalue > 1e-3
    assert scipy.stats.ks_2samp(velocity, faster).pvalue > 1e-3
    inside = kind.get("rotations") or kind.get("energy_ratio", 0.0) > 1.0 or ratio(theta, velocity).max() <= 1.0 + 1e-14
    assert inside and np.isfinite(theta).all() and (np.abs(theta) <= math.pi).all()


@pytest.mark.parametrize("kind", UNMATCHED.values(), ids=UNMATCHED)
def test_one_that_is_not_matched_smears(kind):
    theta, velocity = bunch(60_000, seed=3, omega0=OMEGA0, **kind | {"sigma_theta": 0.9})
    assert abs(theta.std() - 0.9) < 0.01 and abs(velocity.std() / OMEGA0 - 0.9) < 0.01
    _, faster = libration.motion(1000.0, theta, velocity, OMEGA0)
    assert scipy.stats.ks_2samp(velocity, faster).pvalue < 1e-6


def test_actions_and_phases_are_those_of_the_formulas():
    cumulative = {
        "gaussian": lambda action: np.expm1(-action / 1.5) / np.expm1(-EDGE / 1.5),
        "waterbag": lambda action: action / 1.5,
        "parabolic": lambda action: 2 * action / 1.5 - (action / 1.5) ** 2,
    }
    for distribution, function in cumulative.items():
        theta, velocity = bunch(60_000, distribution=distribution, action=1.5, seed=11, omega0=OMEGA0)
        actions = libration.action(theta, velocity, OMEGA0)
        assert probability(actions, function) > 1e-3
        assert probability(actions * 1.02, function) < 1e-3, "a spoiled scale must show"
        phases = libration.phase(theta, velocity, OMEGA0)
        assert probability(phases, scipy.stats.uniform(-math.pi, math.tau).cdf) > 1e-3


def rows():
    with (ROOT / "reference/vectors/bunches.csv").open(newline="") as file:
        found = list(csv.DictReader(file))
    assert len(found) == 12
    return [(row["stratum"], *(float.fromhex(row[name]) for name in ("scale", "rms_hi"))) for row in found]


def test_truth():
    for shape, scale, true in rows():
        assert abs(rms(shape, scale) / true - 1) < 1e-14
        # The rms hangs on the scale by less than its own size.
        if rms(shape, scale) < 1.3:
            assert abs(scale_of(shape, true) / scale - 1) < 1e-13
        assert abs(rms(shape, scale * (1 - 1e-9)) / true - 1) > 1e-14, "a spoiled scale must show"


def test_widths_are_those_asked_for():
    for distribution in ("gaussian", "waterbag", "parabolic"):
        for sigma in (1e-6, 0.3, 1.0):
            kind = {"distribution": distribution, "sigma_theta": sigma, "seed": 5, "omega0": OMEGA0, "quiet": True}
            theta, velocity = bunch(200_000, **kind)
            assert abs(theta.std() / sigma - 1) < 1e-3
            # The pendulum softens: a matched bunch is less high than long.
            assert velocity.std() < (1 + 1e-3) * sigma * OMEGA0
    theta, velocity = bunch(200_000, distribution="gaussian", sigma_theta=1e-5, seed=5, omega0=OMEGA0)
    assert abs(theta.std() / 1e-5 - 1) < 0.01 and abs(velocity.std() / (1e-5 * OMEGA0) - 1) < 0.01


@pytest.mark.parametrize("temperature", [0.01, 4.0, 30.0])
def test_temperatures(temperature):
    theta, velocity = bunch(
        60_000, distribution="thermal", temperature=temperature, seed=2, omega0=OMEGA0, rotations=True
    )
    kappa = OMEGA0**2 / temperature
    assert probability(theta, scipy.stats.vonmises(kappa).cdf) > 1e-3
    assert probability(velocity, scipy.stats.norm(scale=math.sqrt(temperature)).cdf) > 1e-3
    assert probability(velocity, scipy.stats.norm(scale=1.05 * math.sqrt(temperature)).cdf) < 1e-3
    # Only those inside, by leaving out the others, are what is made without rotations.
    kept = ratio(theta, velocity) < 1.0
    within = bunch(60_000, distribution="thermal", temperature=temperature, seed=8, omega0=OMEGA0)
    for column, other in zip((theta, velocity), within, strict=True):
        assert scipy.stats.ks_2samp(column[kept], other).pvalue > 1e-3


def test_orbits_have_one_energy():
    theta, velocity = bunch(10_000, distribution="microcanonical", energy_ratio=0.7, seed=1, omega0=OMEGA0)
    assert np.abs(ratio(theta, velocity) - 0.7).max() < 1e-14
    theta, velocity = bunch(10_000, distribution="microcanonical", energy_ratio=1.7, seed=1, omega0=OMEGA0)
    assert np.abs(ratio(theta, velocity) - 1.7).max() < 1e-14
    assert 0.48 < np.mean(velocity > 0) < 0.52
    theta, velocity = bunch(10_000, distribution="microcanonical", action=3.0, seed=1, omega0=OMEGA0)
    assert np.abs(libration.action(theta, velocity, OMEGA0) - 3.0).max() < 1e-13


def test_a_quiet_start_is_quieter():
    kind = {"distribution": "gaussian", "sigma_theta": 0.8, "seed": 4}
    parts = [4096 * k for k in range(20)]
    means = [
        np.mean([abs(bunch(4096, quiet=quiet, first=first, **kind)[0].mean()) for first in parts])
        for quiet in (False, True)
    ]
    assert means[1] < means[0] / 10


def test_uniform_numbers_are_philox_by_the_particle():
    philox = np.random.Philox(key=np.array([9, 0], dtype=np.uint64))
    words = philox.random_raw(4 * 100).reshape(100, 4)[:, :2].T
    assert np.array_equal(uniforms(9, 0, 100, False), ((words >> np.uint64(12)) + 0.5) * 2.0**-52)
    assert 0.0 < (0.5 * 2.0**-52) and (2.0**52 - 0.5) * 2.0**-52 < 1.0
    # Multiples of 1/rho and 1/rho**2 with rho**3 = rho + 1, in whole numbers.
    ratios = [float(step) / 2.0**64 for step in STEPS]
    assert abs(ratios[0] ** 2 - ratios[1]) < 1e-15 and abs(ratios[0] ** 3 + ratios[0] ** 2 - 1) < 1e-15
    whole = uniforms(9, 0, 50, True)
    assert np.array_equal(uniforms(9, 20, 30, True), whole[:, 20:])
    assert np.isfinite(uniforms(2**64 - 1, 2**63 - 1, 3, True)).all()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"n": -1}, "n = -1: must not be negative"),
        ({"n": 2.5}, "n = 2.5: must be a whole number"),
        ({"n": 2**62}, "n = 4611686018427387904: must fit into memory, 16 bytes a particle"),
        ({"first": -1}, "first = -1: must not be negative"),
        ({"seed": -1}, "seed = -1: must be from 0 to 2**64 - 1"),
        ({"seed": 2**64}, "seed = 18446744073709551616: must be from 0 to 2**64 - 1"),
        ({"seed": None}, "seed = None: must be a whole number"),
        (
            {"distribution": "normal"},
            "distribution = 'normal': must be one of gaussian, waterbag, parabolic, thermal, micro",
        ),
        ({"distribution": ["gaussian"]}, "distribution = ['gaussian']: must be one of"),
        ({"sigma_theta": None}, "no width given: gaussian takes one of sigma_theta=, action="),
        ({"action": 1.0}, "sigma_theta and action given: gaussian takes one of sigma_theta=, action="),
        ({"sigma_theta": 0.0}, "sigma_theta = 0.0: must be positive and finite"),
        ({"sigma_theta": math.nan}, "sigma_theta = nan: must be positive and finite"),
        ({"sigma_theta": "1"}, "sigma_theta = '1': must be one real number"),
        ({"sigma_theta": 1.4}, "sigma_theta = 1.4: must be positive and below 1.367335, a full bucket, if matched"),
        ({"sigma_theta": 1e-200}, "sigma_theta = 1e-200: must give an action within the doubles, not 0.0"),
        ({"distribution": "parabolic", "sigma_theta": 1.1}, "sigma_theta = 1.1: must be positive and to 1.037691"),
        ({"sigma_theta": None, "temperature": 1.0}, "temperature = 1.0: gaussian takes one of sigma_theta=, action="),
        ({"distribution": "thermal"}, "sigma_theta = 0.8: thermal takes temperature="),
        (
            {"distribution": "thermal", "sigma_theta": None, "temperature": 1e-320},
            "temperature = 1e-320: must be within",
        ),
        (
            {"distribution": "waterbag", "sigma_theta": None, "action": 3.0},
            "action = 3.0: must be positive, to that of the separatrix, 8 omega0/pi",
        ),
        (
            {"distribution": "waterbag", "sigma_theta": None, "energy_ratio": 1.5},
            "energy_ratio = 1.5: must be in (0, 1]",
        ),
        (
            {"distribution": "microcanonical", "sigma_theta": None, "energy_ratio": 1.0},
            "energy_ratio = 1.0: must not be 1; the separatrix has no phase",
        ),
        (
            {"distribution": "microcanonical", "sigma_theta": None, "energy_ratio": 0.5, "matched": False},
            "matched = False: must be True for microcanonical, a function of the energy",
        ),
        (
            {"distribution": "waterbag", "sigma_theta": None, "energy_ratio": 0.5, "matched": False},
            "energy_ratio = 0.5: a bunch that is not matched takes one of sigma_theta=, action=",
        ),
        ({"rotations": True}, "rotations = True: must be False for gaussian; thermal takes it"),
        ({"matched": None}, "matched = None: must be True or False"),
        ({"omega0": 0.0}, "omega0 = 0.0: must be positive and finite"),
        ({"omega0": [1.0]}, "omega0 = [1.0]: must be one real number"),
    ],
)
def test_bad_input_is_one_line(arguments, said):
    given = {"n": 10, "distribution": "gaussian", "sigma_theta": 0.8, "seed": 1} | arguments
    with pytest.raises(ValueError) as caught:
        bunch(**given)
    assert str(caught.value).startswith(said) and "\n" not in str(caught.value)


def test_wrong_names():
    with pytest.raises(TypeError, match="got an unexpected keyword argument 'sigma': did you mean sigma_theta"):
        bunch(10, distribution="gaussian", sigma=0.8, seed=1)


def test_nothing_is_a_bunch_too():
    theta, velocity = bunch(0, distribution="gaussian", sigma_theta=0.8, seed=1)
    assert theta.shape == velocity.shape == (0,)
