"""The pinned surface: names, signatures, attributes, and numbers from the mathematics (mpmath, 40 digits)."""

import copy
import inspect
import math
import pickle
import subprocess
import sys
import weakref
from dataclasses import is_dataclass
from pathlib import Path

import numpy as np
import pytest

import libration
from libration import Pendulum, Regime, _core

PACKAGE = Path(libration.__file__).parent


# What the signatures of the functions of states have in common.
FREQUENCY = "omega2=None, length=None, gravity=None"
ENERGY = f"energy_ratio=None, energy_ratio_c=None, energy=None, direction=1.0, {FREQUENCY}"
STATE = f"theta=None, velocity=None, omega0=None, *, theta_from_top=None, {ENERGY}"
START = f"theta0=None, velocity0=None, omega0=None, *, theta0_from_top=None, {ENERGY}"


def close(got, truth, relative=1e-14):
    return abs(got - truth) <= relative * abs(truth)


def test_close_sees_nan_signs_and_negative_truth():
    assert not close(math.nan, 1.0)
    assert not close(-1.0, 1.0)
    assert not close(-1.1, -1.0)
    assert close(-1.0, -1.0)


def test_every_public_name_is_there_and_documented():
    names = [
        "CubicQuintic DampedPendulum Duffing DuffingForm Estimate Fit Fourier Friction JacobiComplexValues",
        "JacobiValues OscillatorFourier OscillatorRegime Pendulum Regime Together Torque __version__ action advance",
        "carlson_rc carlson_rd carlson_rf carlson_rj cite complete_e complete_k complete_pi cubic_quintic_action",
        "cubic_quintic_escape_times cubic_quintic_frequency cubic_quintic_motion cubic_quintic_period",
        "cubic_quintic_phase cubic_quintic_regime duffing_action duffing_escape_times duffing_frequency",
        "duffing_motion duffing_period duffing_phase duffing_regime energy energy_ratio energy_ratio_c fit",
        "fit_together frequency from_action_phase from_nome gravity_of_period gravity_of_pivots harmonic_distortion",
        "heuman_lambda incomplete_e incomplete_f incomplete_pi jacobi jacobi_complex jacobi_epsilon jacobi_zeta",
        "motion next_crossing nome normal_gravity period phase regime sensitivities theta theta1 theta2 theta3 theta4",
        "theta_max turns uncertain_motion uncertain_period velocity",
    ]
    assert libration.__all__ == " ".join(names).split()
    for name in libration.__all__:
        value = getattr(libration, name)
        assert isinstance(value, str) or inspect.getdoc(value)


@pytest.mark.parametrize(
    ("function", "signature"),
    [
        (
            Pendulum,
            "(theta0=None, velocity0=0.0, *, theta0_from_top=None, omega0=None, omega2=None, length=None, gravity=None)",
        ),
        (Pendulum.theta, "(self, t, out=None)"),
        (Pendulum.velocity, "(self, t, out=None)"),
        (Pendulum.motion, "(self, t)"),
        (Pendulum.turns, "(self, t)"),
        (Pendulum.times, "(self, theta, start, stop, *, every_turn=False)"),
        (Pendulum.turning_times, "(self, start, stop)"),
        (Pendulum.phase, "(self, t, out=None)"),
        (Pendulum.sensitivities, "(self, t)"),
        (Pendulum.second_sensitivities, "(self, t)"),
        (Pendulum.fourier, "(self, n)"),
        (
            Pendulum.from_action_phase,
            "(action, phase, *, direction=0, omega0=None, omega2=None, length=None, gravity=None)",
        ),
        (libration.action, f"({STATE}, out=None, where=True)"),
        (libration.period, f"({STATE}, out=None, where=True)"),
        (libration.regime, f"({STATE})"),
        (libration.next_crossing, f"(theta, {START.replace('*, ', '*, after=0.0, ')}, out=None, where=True)"),
        (libration.turns, f"(t, {START})"),
        (
            libration.from_action_phase,
            f"(action, phase, omega0=None, *, direction=0.0, {FREQUENCY}, out=None, where=True)",
        ),
        (libration.sensitivities, f"(t, {START})"),
        (libration.theta, f"(t, {START}, out=None, where=True)"),
        (libration.velocity, f"(t, {START}, out=None, where=True)"),
        (libration.motion, f"(t, {START}, out=None, where=True)"),
        (libration.advance, f"(theta, velocity, dt, omega0=None, *, {FREQUENCY}, out=None, where=True)"),
        (libration.jacobi, "(u, *, m=None, mc=None, k=None, q=None, out=None, where=True)"),
        (libration.incomplete_f, "(phi, *, m=None, mc=None, k=None, q=None, out=None, where=True)"),
        (libration.incomplete_e, "(phi, *, m=None, mc=None, k=None, q=None, out=None, where=True)"),
        (libration.complete_k, "(*, m=None, mc=None, k=None, q=None, out=None, where=True)"),
        (libration.complete_e, "(*, m=None, mc=None, k=None, q=None, out=None, where=True)"),
        (libration.nome, "(*, m=None, mc=None, k=None, q=None, out=None, where=True)"),
    ],
)
def test_signature(function, signature):
    shown = inspect.signature(function)
    bare = [parameter.replace(annotation=inspect.Parameter.empty) for parameter in shown.parameters.values()]
    assert str(inspect.Signature(bare)) == signature


@pytest.mark.parametrize(
    ("arguments", "regime", "period"),
    [
        ({"theta0": math.pi}, "libration", 154.87260221755525),
        ({"theta0": 0.0, "velocity0": math.nextafter(2.0, 0.0)}, "libration", 77.632484222713879),
        ({"theta0": 0.0, "velocity0": 2.0}, "separatrix", math.inf),
        ({"theta0": 0.0, "velocity0": math.nextafter(2.0, 3.0)}, "rotation", 38.123094930796988),
        ({"theta0": 0.0, "velocity0": 3.0}, "rotation", 2.4128899939821179),
        ({"theta0": 3.0, "length": 1.0, "gravity": 9.8}, "libration", 5.1606977499779820),
        ({"theta0": 1.0, "length": 0.25}, "libration", 1.0697514696687809),
        ({"theta0": 1.0, "velocity0": 0.5, "omega2": 4.0}, "libration", 3.3666131703061800),
        ({"theta0": 0.0, "omega0": 2.0}, "rest", math.pi),
    ],
)
def test_regime_and_period(arguments, regime, period):
    pendulum = Pendulum(**arguments)
    assert pendulum.regime == regime
    assert pendulum.regime is Regime(regime)
    assert pendulum.period == period or close(pendulum.period, period)


def test_attributes_of_a_libration():
    pendulum = Pendulum(1.0, 0.5, omega0=2.0)
    assert (pendulum.theta0, pendulum.velocity0, pendulum.omega0, pendulum.omega2) == (1.0, 0.5, 2.0, 4.0)
    assert close(pendulum.energy_ratio, 0.2454738470659301413)
    assert close(pendulum.energy_ratio_c, 0.7545261529340698587)
    assert close(pendulum.energy, 1.9637907765274411304)
    assert close(pendulum.theta_max, 1.0367129236260946589)


def test_attributes_next_to_the_separatrix_and_beyond():
    assert close(Pendulum(math.pi).energy_ratio_c, 3.7493994566546439866e-33)
    assert Pendulum(0.0, 2.0).theta_max == math.pi
    assert Pendulum(0.0, 2.0).energy_ratio_c == 0.0
    rotation = Pendulum(0.0, 3.0)
    assert (rotation.energy_ratio, rotation.energy_ratio_c, rotation.energy) == (2.25, -1.25, 4.5)
    assert math.isnan(rotation.theta_max)


def test_hanging_from_the_other_side_is_the_same_pendulum_half_a_turn_away():
    upside_down = Pendulum(0.1, omega2=-4.0)
    upright = Pendulum(0.1 - math.pi, omega2=4.0)
    assert (upside_down.regime, upside_down.omega0, upside_down.omega2) == ("libration", 2.0, -4.0)
    t = np.linspace(0.0, 20.0, 50)
    assert np.allclose(upside_down.theta(t), math.pi + upright.theta(t), rtol=0.0, atol=1e-12)
    assert np.ptp(upside_down.theta(t)) > 6.0


def test_free_rotation_has_no_force():
    assert np.array_equal(Pendulum(0.5, 2.0, omega0=0.0).theta([0.0, 1.0, 1e6]), [0.5, 2.5, 2000000.5])


@pytest.mark.parametrize(
    ("pendulum", "t", "theta", "velocity"),
    [
        (Pendulum(3.0, length=1.0, gravity=9.8), 10.0, 2.92241948221262057, None),
        (Pendulum(1.0, 0.5, omega0=2.0), 3.0, 0.60644189582150069932, 1.5814647422444923477),
        (Pendulum(0.0, 3.0), 10.0, 26.15812972521963137, 2.8350544242380382689),
        (Pendulum(0.0, 2.0), 1.0, 1.7315389664793172486, 1.2961085473277707991),
        (Pendulum(0.0, 2.0), 5.0, 3.1146412734521020444, None),
    ],
)
def test_motion_has_the_numbers_of_the_equation(pendulum, t, theta, velocity):
    assert close(pendulum.theta(t), theta)
    assert velocity is None or close(pendulum.velocity(t), velocity)
    assert libration.theta(t, pendulum.theta0, pendulum.velocity0, 2.0) == (
        Pendulum(pendulum.theta0, pendulum.velocity0, omega0=2.0).theta(t)
    )


def test_turns_counts_whole_turns():
    n, angle = Pendulum(0.0, 3.0).turns(10.0)
    assert (type(n), type(angle)) == (np.int64, np.float64)
    assert n == 4
    assert close(angle, 26.15812972521963137 - 8 * math.pi, 1e-13)
    n, angle = Pendulum(0.0, 3.0).turns(np.linspace(-1e6, 1e6, 2001))
    assert n.dtype == np.int64
    assert np.all((-math.pi <= angle) & (angle < math.pi))
    assert np.allclose(2 * math.pi * n + angle, Pendulum(0.0, 3.0).theta(np.linspace(-1e6, 1e6, 2001)), rtol=1e-15)


@pytest.mark.filterwarnings("ignore:theta0 = .* is in radians:UserWarning")
def test_turns_beyond_the_integers_have_no_answer():
    """The largest count is 2**63 - 1; the truth is by mpmath at 1,400 bits."""
    n, angle = Pendulum(5.7e19).turns(0.0)
    assert (int(n), float(angle)) == (9071831756238034139, -1.0909211136875014)
    for theta0 in (5.9e19, -5.9e19, 1e300):
        for t in (0.0, np.zeros(2)):
            n, angle = Pendulum(theta0).turns(t)
            assert np.all(n == 0), theta0
            assert np.all(np.isnan(angle)), theta0


def test_motions_can_be_weakly_referenced():
    orbits = [
        _core.Orbit(1.0, 0.0),
        _core.Duffing(1.0, 0.0, 1.0, 1.0, 0.0, 0.0),
        _core.CubicQuintic(1.0, 0.0, 1.0, 1.0, 1.0),
    ]
    for orbit in [*orbits, _core.DuffingForm("cn", 1.0, 1.0, 1.0, 0.0), _core.AngleFormula("linear")]:
        assert weakref.ref(orbit)() is orbit


def test_advance_is_the_flow_and_goes_on_through_turns():
    theta, velocity = libration.advance(0.0, 3.0, 10.0)
    assert close(theta, 26.15812972521963137)
    assert close(velocity, 2.8350544242380382689)


@pytest.mark.parametrize(
    ("u", "m", "sn", "cn", "dn", "am"),
    [
        (1.5, -3.0, 0.71142786525254073, -0.70275912839479556, 1.5869432322466238, 2.3500647291894077),
        (2.5, 0.7, 0.97194035058174875, -0.23522745356575054, 0.58200718933507958, 1.8082489083520841),
        (0.9, 2.0, 0.64498686029008459, 0.76419366004510853, 0.40985839030850376, 0.70100608888778660),
        (1.5, 1.0, 0.90514825364486644, 0.42509603494228046, 0.42509603494228046, 1.1317283452505091),
    ],
)
def test_jacobi(u, m, sn, cn, dn, am):
    values = libration.jacobi(u, m=m)
    for got, truth in zip(values, (sn, cn, dn, am), strict=True):
        assert close(got, truth, 2e-15)
    assert values._fields == ("sn", "cn", "dn", "am")
    assert np.allclose(libration.jacobi(u, mc=1.0 - m), values, rtol=2e-15)
    if m >= 0:
        assert np.allclose(libration.jacobi(u, k=math.sqrt(m)), values, rtol=1e-14)


@pytest.mark.parametrize(
    ("m", "complete_k", "complete_e", "nome", "f", "e"),
    [
        (-2.0, 1.1714200841467699, 2.1844381427462012, None, 3.0786434343282144, 5.3853750615186297),
        (0.3, 1.7138894481787911, 1.4453630644126653, 0.022277436157153507, 4.3159433883995853, 3.7210652682686023),
        (0.99, 3.6956373629898742, 1.0159935450252239, 0.26219626791770932, 8.3780176712203761, 2.7899470306145861),
    ],
)
def test_integrals(m, complete_k, complete_e, nome, f, e):
    assert close(libration.complete_k(m=m), complete_k, 2e-15)
    assert close(libration.complete_e(m=m), complete_e, 2e-15)
    assert nome is None or close(libration.nome(m=m), nome, 2e-15)
    assert close(libration.incomplete_f(4.0, m=m), f, 2e-15)
    assert close(libration.incomplete_e(4.0, m=m), e, 2e-15)


def test_the_complement_keeps_its_digits():
    assert close(libration.complete_k(mc=1e-300), 346.77405831022674322)
    assert libration.complete_k(m=1.0) == math.inf


def test_scalars_give_float64():
    pendulum = Pendulum(3.0)
    for t in (1.0, 1, np.float64(1.0), np.float32(1.0), np.int64(1), np.array(1.0)):
        for value in (pendulum.theta(t), pendulum.velocity(t), *pendulum.motion(t), pendulum.turns(t)[1]):
            assert type(value) is np.float64
        assert type(pendulum.turns(t)[0]) is np.int64
        assert type(libration.theta(t, 3.0)) is np.float64
        assert type(libration.jacobi(t, m=0.5).am) is np.float64
    assert type(libration.complete_k(m=0.5)) is np.float64


@pytest.mark.parametrize(
    ("pendulum", "shown"),
    [
        (Pendulum(3.0, length=1.0, gravity=9.8), "Pendulum(theta0=3.0, velocity0=0.0, length=1.0, gravity=9.8)"),
        (Pendulum(3, -1), "Pendulum(theta0=3.0, velocity0=-1.0, omega0=1.0)"),
        (Pendulum(3.0, omega2=-2), "Pendulum(theta0=3.0, velocity0=0.0, omega2=-2.0)"),
    ],
)
def test_repr_evaluates_to_an_equal_pendulum(pendulum, shown):
    assert repr(pendulum) == shown
    assert eval(shown, {"Pendulum": Pendulum}) == pendulum


def test_equality_and_hash_go_by_the_numbers_given():
    assert Pendulum(3.0) == Pendulum(3, 0, omega0=1)
    assert Pendulum(3.0, length=1.0) == Pendulum(3.0, length=1.0, gravity=9.80665)
    assert Pendulum(3.0) != Pendulum(3.0, omega0=1.0000000000000002)
    assert Pendulum(3.0, omega0=2) != Pendulum(3.0, omega2=4)
    assert Pendulum(3.0) != 3.0
    assert len({Pendulum(3.0), Pendulum(3.0), Pendulum(2.0)}) == 2


class Named(Pendulum):
    """A pendulum with another constructor and a name."""

    def __new__(cls, name):
        self = Pendulum.__new__(cls, 3.0, omega2=2.0)
        self.__dict__["name"] = name
        return self


DUPLICATES = [copy.copy, copy.deepcopy]
for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
    DUPLICATES.append(lambda pendulum, protocol=protocol: pickle.loads(pickle.dumps(pendulum, protocol)))


@pytest.mark.parametrize("duplicate", DUPLICATES)
def test_a_copy_answers_the_same(duplicate):
    for pendulum in (Pendulum(3.0, 0.1, length=0.3, gravity=9.81), Pendulum(3.0), Pendulum(-0.0, omega2=-1.0)):
        twin = duplicate(pendulum)
        assert (twin, repr(twin), twin.theta(1e5)) == (pendulum, repr(pendulum), pendulum.theta(1e5))


@pytest.mark.parametrize("duplicate", DUPLICATES)
def test_a_copy_of_a_subclass_is_one(duplicate):
    pendulum = Named("clock")
    twin = duplicate(pendulum)
    assert type(twin) is Named
    assert (twin, twin.name, twin.theta(1e5)) == (pendulum, "clock", pendulum.theta(1e5))


def test_a_pendulum_does_not_change():
    pendulum = Pendulum(3.0)
    for change in (lambda: setattr(pendulum, "theta0", 1.0), lambda: setattr(pendulum, "new", 1.0)):
        with pytest.raises(AttributeError):
            change()
    with pytest.raises(AttributeError):
        del pendulum._orbit


MADE = [
    Pendulum(3.0),
    libration.Friction(linear=0.01, dry=0.1),
    libration.Torque(constant=0.5, samples=([0.0, 1.0], [0.5, 1.0])),
    libration.DampedPendulum(1.0, omega2=2.0, friction=libration.Friction(dry=0.1)),
    libration.Duffing(1.0, p=1.0, q=1.0),
    libration.CubicQuintic(1.0, p=1.0, q=0.0, s=1.0),
    libration.DuffingForm("cn", 1.0, 0.5, p=1.0, q=1.0),
    libration.approx.angle("fourier:3"),
    libration.approx.angle("fourier:3").of(Pendulum(1.0)),
    libration.approx.period("agm:2"),
    libration.approx.sine("taylor:3"),
    libration.approx.sine("best:3", phi_max=1.0),
    libration.approx.numerical("rk4:0.1"),
    libration.approx.numerical("rk4:0.1").of(Pendulum(1.0)),
    libration.approx.compare(Pendulum(1.0), ["fourier:3"]),
]


@pytest.mark.parametrize("made", MADE, ids=repr)
def test_what_does_not_change_is_one_value(made):
    assert weakref.ref(made)() is made
    assert weakref.WeakValueDictionary({"made": made})["made"] is made
    for duplicate in DUPLICATES:
        twin = duplicate(made)
        assert (twin, hash(twin), repr(twin)) == (made, hash(made), repr(made))
    assert [other for other in MADE if other == made] == [made]
    assert made != object() and made != 1.0
    assert is_dataclass(made) or all(name[0] != "_" for name in dir(made))
    with pytest.raises(AttributeError):
        made.new = 1


ROOMS = [libration.elliptic, libration.ensemble, libration.jax, libration.approx, libration.plot, libration.papers]


@pytest.mark.parametrize("room", [libration, *ROOMS])
def test_dir_shows_the_public_names_and_nothing_else(room):
    rooms = ["approx", "elliptic", "ensemble", "jax", "papers", "plot"] if room is libration else []
    assert dir(room) == sorted([*room.__all__, *rooms])
    for name in dir(room):
        assert getattr(room, name) is not None


def test_dir_of_an_orbit_shows_what_can_be_asked():
    shown = dir(Pendulum(1.0))
    assert all(name[0] != "_" for name in shown)
    assert {"theta", "velocity0", "from_action_phase", "period", "times"} <= set(shown)
    assert dir(libration.approx.angle) == ["names"]
    assert "name" in dir(Named("clock"))


def test_regime_is_its_string():
    assert [str(regime) for regime in Regime] == ["rest", "libration", "separatrix", "rotation"]
    assert f"{Pendulum(3.0).regime}" == "libration"


def test_stub_agrees_with_the_compiled_module():
    command = [sys.executable, "-m", "mypy.stubtest", "libration._core"]
    run = subprocess.run(command, cwd=PACKAGE.parent, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr
    assert (PACKAGE / "py.typed").is_file()


def test_import_brings_no_heavy_library():
    heavy = "{'dask', 'jax', 'xarray', 'scipy', 'matplotlib', 'pandas', 'argparse', 'importlib.metadata'}"
    code = (
        f"import numpy, sys; before = set(sys.modules); import libration; print({heavy} & (set(sys.modules) - before))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "set()"
