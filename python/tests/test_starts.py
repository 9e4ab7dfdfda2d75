"""Orbits stated by what one knows of them: the truth through every door, arrays as their scalars, and what they are called."""

import copy
import csv
import math
import pickle

import numpy as np
import pandas
import pytest
import xarray
from bits import same
from test_accuracy_elliptic import ROOT, error

import libration
from libration import Pendulum, elliptic
from libration.cli import main

COUNT = 301
METHODS = {
    "energy_ratio": (Pendulum.from_energy, "energy_ratio", {}),
    "energy_ratio_c": (Pendulum.from_energy, "energy_ratio_c", {}),
    "energy": (Pendulum.from_energy, "energy", {}),
    "theta_max": (Pendulum.from_turning_angle, "theta_max", {}),
    "theta_max_from_top": (Pendulum.from_turning_angle, "theta_max_from_top", {}),
    "period": (Pendulum.from_period, "period", {}),
    "period_of_rotation": (Pendulum.from_period, "period", {"regime": "rotation"}),
}
KEPT = ("period", "energy_ratio", "energy_ratio_c", "theta_max", "energy")


def rows():
    with (ROOT / "reference/vectors/starts.csv").open(newline="") as file:
        found = list(csv.DictReader(file))
    assert len(found) == COUNT
    return found


ROWS = rows()


def number(row, name):
    return float.fromhex(row[name])


def angle(row):
    """The keyword of the angle, none for the bottom."""
    name = {"theta": "theta0", "from_top": "theta0_from_top"}.get(row["counted"])
    return {name: number(row, "angle")} if name else {}


def pendulum(row):
    value, force = number(row, "value"), {"omega2": number(row, "omega2")}
    if row["known"] == "velocity":
        return Pendulum(**angle(row), velocity0=value, **force)
    method, name, more = METHODS[row["known"]]
    return method(**{name: value}, **more, **angle(row), direction=int(row["direction"]), **force)


def failures(value):
    """The rows and outputs beyond 4 ulp, eased by 2**-100 of the condition."""
    found = []
    for row in ROWS:
        for name in ("velocity0", *KEPT):
            high, low = number(row, f"{name}_hi"), number(row, f"{name}_lo")
            got = value(row, name)
            ease = float(row[f"cond_{name}"]) * 2.0**-100
            wrong = not math.isnan(got) if math.isnan(high) else not error(got, high, low, ease) <= 4
            if wrong:
                found.append((row["known"], row["value"], name, got, high))
    return found


def test_truth():
    for row in ROWS:
        assert pendulum(row).regime == row["regime"]
    assert failures(lambda row, name: getattr(pendulum(row), name)) == []


@pytest.mark.parametrize("name", ["velocity0", *KEPT])
def test_a_spoiled_answer_is_found(name):
    def spoiled(row, each):
        return getattr(pendulum(row), each) * (1 + 2e-15 * (each == name))

    assert {each for *_, each, _, _ in failures(spoiled)} == {name}


def test_a_state_of_doubles_would_not_do():
    def rounded(row, name):
        given = pendulum(row)
        return getattr(Pendulum(given.theta0, given.velocity0, omega2=given.omega2), name)

    assert {"period", "energy_ratio_c"} <= {name for *_, name, _, _ in failures(rounded)}


def stated(row):
    """The keywords of the functions of arrays for a row, but for the angle."""
    name = "velocity" if row["known"] == "velocity" else row["known"]
    return {name: number(row, "value"), "direction": float(row["direction"]), "omega2": number(row, "omega2")}


ARRAYS = [row for row in ROWS if row["known"] in ("energy_ratio", "energy_ratio_c", "energy", "velocity")]


@pytest.mark.parametrize("name", [*KEPT, "action", "frequency", "phase", "regime"])
def test_functions_of_states_are_their_scalars(name):
    function = getattr(libration, name)
    for row in ARRAYS:
        place = {key.replace("0", ""): value for key, value in angle(row).items()}
        scalar = function(**place, **stated(row))
        many = function(**place, **{key: np.full(3, value) for key, value in stated(row).items()})
        expected = getattr(pendulum(row), name)
        expected = expected(0.0) if name == "phase" else expected
        assert many.shape == (3,)
        if name == "regime":
            assert scalar == expected and set(many) == {expected}
        else:
            assert same(scalar, expected) and same(many, np.full(3, expected))


@pytest.mark.parametrize("name", ["theta", "velocity", "motion", "turns", "sensitivities"])
def test_functions_of_times_are_their_scalars(name):
    function = getattr(libration, name)
    for row in ARRAYS[::3]:
        given = {("velocity0" if key == "velocity" else key): value for key, value in stated(row).items()}
        t = number(row, "t")
        expected = getattr(pendulum(row), name)(t)
        found = function(t, **angle(row), **given)
        many = function(np.full(2, t), **angle(row), **{key: np.full(2, value) for key, value in given.items()})
        pair = isinstance(expected, tuple)
        for one, scalar, column in zip(*((each if pair else (each,)) for each in (expected, found, many)), strict=True):
            assert same(one, scalar) and same(np.broadcast_to(one, column.shape), column)


def test_next_crossing_is_the_first_of_times():
    for row in ARRAYS[::3]:
        orbit = pendulum(row)
        given = {("velocity0" if key == "velocity" else key): value for key, value in stated(row).items()}
        for theta in (0.5, -2.0, 9.0):
            found = libration.next_crossing(theta, **angle(row), **given, after=1.5)
            horizon = 1.5 + (1.5 * orbit.period if orbit.regime == "libration" else 1e300)
            times = orbit.times(theta, 1.5, horizon)
            assert same(found, times[0] if len(times) else math.nan)


@pytest.mark.parametrize(
    "force", [{"omega0": 1.7}, {"omega2": 1.7}, {"omega2": -1.7}, {"length": 0.7}, {"length": 0.7, "gravity": 3.7}]
)
def test_every_frequency_is_taken_by_functions_of_arrays(force):
    theta, velocity = np.array([0.1, 2.0, -3.1]), np.array([0.5, -4.0, 0.0])
    many = [Pendulum(a, b, **force) for a, b in zip(theta, velocity, strict=True)]
    for name in [*KEPT, "action", "frequency"]:
        found = getattr(libration, name)(theta, velocity, **force)
        expected = np.array([getattr(each, name) for each in many])
        # States by angle, velocity and omega0 have kernels of their own, within the same promise of 4 ulp.
        own = "omega0" in force and name in ("period", "action", "frequency")
        assert np.allclose(found, expected, rtol=1.8e-15, atol=0.0) if own else same(found, expected), name
    for name in ("theta", "velocity"):
        found = getattr(libration, name)(0.7, theta, velocity, **force)
        expected = np.array([getattr(each, name)(0.7) for each in many])
        assert np.allclose(found, expected, rtol=1e-14, atol=1e-15), name
    whole = libration.advance(theta, velocity, 0.7, **force)
    assert np.allclose(whole, libration.motion(0.7, theta, velocity, **force), rtol=1e-13, atol=1e-14)
    action = libration.action(theta[:1], velocity[:1], **force)
    if force.get("omega2", 1.0) > 0:
        back = libration.from_action_phase(action, libration.phase(theta[:1], velocity[:1], **force), **force)
        assert np.allclose(np.ravel(back), [theta[0], velocity[0]], rtol=1e-13)
    # One frequency for each row.
    each = {name: np.full(3, value) for name, value in force.items()}
    assert same(libration.period(theta, velocity, **each), libration.period(theta, velocity, **force))


def test_the_contract():
    """From the issue: states a rounding error from the separatrix, a pencil, a period, a nome."""
    periods = libration.period(energy_ratio_c=[1e-17, -1e-17, 1e-20, -1e-20])
    assert abs(periods[0] - 83.8330706062771158) <= 2e-14 and abs(periods[3] - 48.8242905821206949) <= 1e-14
    assert list(libration.regime(energy_ratio_c=[1e-17, -1e-17])) == ["libration", "rotation"]
    fall = 4.7055881337172293806
    assert abs(Pendulum(theta0_from_top=1e-17, omega2=73.5).times(1.5 * math.pi, 0.0, 9.0)[0] - fall) <= 1e-15
    pencils = libration.next_crossing(1.5 * math.pi, theta0_from_top=np.array([1e-17, 1e-17]), omega2=73.5)
    assert np.abs(pencils - fall).max() <= 1e-15
    assert abs(libration.next_crossing(math.pi / 2, 1e-17, omega2=-73.5) - fall) <= 1e-15
    assert abs(Pendulum.from_period(1.25 * math.tau).theta_max - 1.7980851553537129723) <= 4.5e-16
    m, mc = libration.from_nome(0.1)
    # The double next to a tenth is 5.6e-18 above, and m changes by 3.3 of it.
    assert abs(m - 0.80240329821757621169) <= 1.2e-16 and abs(mc - 0.19759670178242378831) <= 5e-17


def test_the_contract_on_the_command_line(capsys):
    words = "at --crossing 90deg --theta0 1e-17 --from-top --omega2 73.5 --digits 17"
    assert main(words.split()) == 0
    assert abs(float(capsys.readouterr().out.split()[1]) - 4.7055881337172293806) <= 1e-15
    for words, period in (
        ("period --energy-ratio-c 1e-17 --omega0 1 --only exact", 83.8330706062771158),
        ("period --energy-ratio-c -1e-20 --omega0 1 --only exact", 48.8242905821206949),
    ):
        assert main(words.split()) == 0
        line = next(line for line in capsys.readouterr().out.splitlines() if line.startswith("period T"))
        assert abs(float(line.split()[2]) - period) <= 1e-12
    assert main("period --period 7.853981633974483s --omega0 1 --only exact".split()) == 0
    assert "1.79808515535371 rad" in capsys.readouterr().out


def test_an_orbit_is_what_it_was_made_from():
    made = [
        Pendulum(theta0_from_top=-1e-17, velocity0=0.1, length=1.0),
        Pendulum.from_energy(energy_ratio_c=-1e-20, direction=-1, omega2=-2.0),
        Pendulum.from_energy(energy=3.0, theta0=0.1),
        Pendulum.from_turning_angle(theta_max_from_top=1e-30, theta0_from_top=1e-3),
        Pendulum.from_period(2.0, regime="rotation", gravity=9.8, length=1.0),
    ]
    for each in made:
        namespace = {"Pendulum": Pendulum}
        for again in (pickle.loads(pickle.dumps(each)), copy.deepcopy(each), eval(repr(each), namespace)):
            assert again == each and hash(again) == hash(each) and repr(again) == repr(each)
            assert (again.period, again.velocity0) == (each.period, each.velocity0)
    assert len(set(made)) == 5
    assert repr(made[1]) == "Pendulum.from_energy(energy_ratio_c=-1e-20, direction=-1, omega2=-2.0)"
    assert made[4].gravity == 9.8 and made[1].gravity is None


class Clock(Pendulum):
    """A subclass whose constructor takes something else."""

    def __new__(cls, name):
        raise AssertionError(name)


def test_a_subclass_is_made_and_rebuilt_without_its_constructor():
    clock = Clock.from_energy(energy_ratio=0.5)
    assert type(clock) is Clock and type(pickle.loads(pickle.dumps(clock))) is Clock
    assert clock == Pendulum.from_energy(energy_ratio=0.5)


def test_regime_keeps_labels():
    values = [0.5, 1.5, math.nan]
    named = xarray.DataArray(values, dims="x", coords={"x": [1, 2, 3]})
    expected = ["libration", "rotation", ""]
    found = libration.regime(energy_ratio=named)
    assert found.name == "regime" and list(found.values) == expected and list(found.x) == [1, 2, 3]
    lazy = libration.regime(energy_ratio=named.chunk(x=2))
    assert list(lazy.compute().values) == expected
    series = libration.regime(energy_ratio=pandas.Series(values, index=[4, 5, 6], name="kappa"))
    assert list(series) == expected and list(series.index) == [4, 5, 6] and series.name == "regime"
    masked = libration.regime(energy_ratio=np.ma.array(values, mask=[True, False, False]))
    assert masked.mask.tolist() == [True, False, False]


def test_a_bad_element_is_nan_and_no_other():
    found = libration.period(energy_ratio=[0.5, -1.0, math.inf, math.nan, 0.5])
    assert np.isnan(found).tolist() == [False, True, True, True, False]
    found = libration.motion(1.0, [0.1, 3.0], energy_ratio=0.1)
    assert np.isnan(found).tolist() == [[False, True], [False, True]]
    assert np.isnan(libration.period(energy_ratio=0.5, direction=[1.0, -1.0, 0.0])).tolist() == [False, False, True]
    assert np.isnan(libration.period(0.5, length=[1.0, -1.0])).tolist() == [False, True]
    n, rest = libration.turns(1.0, [0.0, math.inf], 3.0)
    assert n[1] == 0 and np.isnan(rest[1])


def test_the_nome_is_a_keyword_everywhere():
    q = np.array([0.01, 0.1, 0.5, 0.9, 0.985, 0.99])
    _, mc = libration.from_nome(q)
    for name in ("complete_k", "complete_e", "nome"):
        function = getattr(libration, name)
        by_nome = function(q=q)
        assert np.isnan(by_nome[-1])
        assert np.allclose(by_nome[:-1], function(mc=mc)[:-1], rtol=1e-13), name
    assert np.allclose(libration.nome(q=q[:-1]), q[:-1], rtol=5e-16)
    for name in ("sn", "dc", "arcsc"):
        assert np.allclose(getattr(elliptic, name)(0.3, q=q[:4]), getattr(elliptic, name)(0.3, mc=mc[:4]), rtol=1e-13)
    # K is pi/2 theta_3**2.
    assert np.allclose(libration.complete_k(q=q[:-1]), math.pi / 2 * libration.theta3(0.0, q=q[:-1]) ** 2, rtol=1e-15)


def test_complex_arguments_have_the_same_names():
    u = np.array([0.3 + 0.2j, -1.0 + 0.5j, 2.0, 1j])
    s, c, d = libration.jacobi_complex(u, m=0.3)
    part = {"s": s, "c": c, "d": d, "n": 1.0}
    for p in "scdn":
        for q in "scdn".replace(p, ""):
            found = getattr(elliptic, p + q)(u, m=0.3)
            assert found.dtype == complex and np.allclose(found, part[p] / part[q], rtol=1e-14)
            real = getattr(elliptic, p + q)(u.real[:3], m=0.3)
            on_axis = getattr(elliptic, p + q)(u.real[:3] + 0j, m=0.3)
            assert np.allclose(on_axis.real, real, rtol=1e-15) and not on_axis.imag.any()
    out = np.empty(4, complex)
    assert elliptic.sc(u, m=0.3, out=out) is out and same(out.real, elliptic.sc(u, m=0.3).real)
    with pytest.raises(TypeError, match="must be an array of complex128"):
        elliptic.sc(u, m=0.3, out=np.empty(4))
    assert isinstance(elliptic.ns(1j, mc=0.5), np.complex128)
    pole = elliptic.ns(0j, m=0.5)
    assert pole.real == math.inf and math.isnan(pole.imag)
    labelled = elliptic.sc(xarray.DataArray(u, dims="x"), m=0.3)
    assert labelled.name == "sc" and labelled.dims == ("x",)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (
            "libration.action(1.0, 0.1, energy=0.5)",
            "ValueError: at most one of velocity, energy_ratio, energy_ratio_c and energy must be given, not velocity and energy",
        ),
        (
            "libration.period(1.0, length=1.0, omega2=2.0)",
            "ValueError: at most one of omega0, omega2 and length must be given, not omega2 and length",
        ),
        ("libration.motion(1.0, 1.0, gravity=9.8)", "ValueError: gravity must be given with a length"),
        (
            "libration.next_crossing(1.0, 1.0, theta0_from_top=0.1)",
            "ValueError: at most one of theta0 and theta0_from_top must be given, not theta0 and theta0_from_top",
        ),
        (
            "Pendulum(1.0, theta0_from_top=0.1)",
            "ValueError: exactly one of theta0 and theta0_from_top must be given, not both",
        ),
        (
            "Pendulum.from_energy()",
            "ValueError: exactly one of energy_ratio, energy_ratio_c and energy must be given, not none",
        ),
        (
            "Pendulum.from_energy(energy_ratio=0.5, energy=1.0)",
            "ValueError: exactly one of energy_ratio, energy_ratio_c and energy must be given, not energy_ratio and energy",
        ),
        ("Pendulum.from_energy(energy_ratio=-0.5)", "ValueError: energy_ratio = -0.5: must be finite and not negative"),
        ("Pendulum.from_energy(energy_ratio_c=1.5)", "ValueError: energy_ratio_c = 1.5: must be finite and at most 1"),
        (
            "Pendulum.from_energy(energy_ratio=0.5, theta0=2.0)",
            "ValueError: theta0 = 2.0: must be an angle that the energy reaches, at most 1.5707963267948966 from the bottom",
        ),
        ("Pendulum.from_energy(energy_ratio=0.5, direction=0)", "ValueError: direction = 0.0: must be 1 or -1"),
        (
            'Pendulum.from_energy(energy_ratio="0.5")',
            "ValueError: energy_ratio = '0.5': must be one real number, a Python or NumPy scalar; write float(energy_ratio)",
        ),
        ("Pendulum.from_turning_angle(3.2)", "ValueError: theta_max = 3.2: must be from 0 to pi"),
        (
            "Pendulum.from_turning_angle()",
            "ValueError: exactly one of theta_max and theta_max_from_top must be given, not none",
        ),
        (
            "Pendulum.from_period(6.0)",
            "ValueError: period = 6.0: must be at least that of small swings, 6.283185307179586, in libration",
        ),
        (
            "Pendulum.from_period(np.nan)",
            "ValueError: period = NaN: must be at least that of small swings, 6.283185307179586, in libration",
        ),
        (
            'Pendulum.from_period(7.0, regime="swing")',
            "ValueError: regime = 'swing': must be 'libration' or 'rotation'",
        ),
        ("p.times(1.0, 0.0, 1.0, every_turn=1)", "ValueError: every_turn = 1: must be True or False"),
    ],
)
def test_a_wrong_call_is_answered(call, said):
    with pytest.raises((TypeError, ValueError)) as caught:
        eval(call, {"libration": libration, "Pendulum": Pendulum, "np": np, "p": Pendulum(1.0)})
    assert f"{type(caught.value).__name__}: {caught.value}" == said
