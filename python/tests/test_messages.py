"""Wrong calls, as newcomers make them, and the one line that each is answered with."""

import datetime
import decimal
import fractions
import inspect

import numpy as np
import pandas as pd
import pytest

import libration
from libration import CubicQuintic, Duffing, DuffingForm, Pendulum, approx, elliptic, papers


class Pint:
    """A quantity as those of pint are: no ufunc takes it."""

    __array_ufunc__ = None
    magnitude = 1.0
    units = "second"

    def to(self, unit):
        if unit != "s":
            raise TypeError(f"cannot convert from second to {unit}")
        return self

    def __repr__(self):
        return "<Quantity(1.0, 'second')>"


class Astropy(np.ndarray):
    """A quantity as those of astropy are: an array that no unknown ufunc takes, and that is no number."""

    unit = "s"

    def to_value(self, unit):
        if unit != "s":
            raise ValueError(f"s and {unit} are not convertible")
        return np.asarray(self)

    def __array_ufunc__(self, *arguments, **keywords):
        return NotImplemented

    def __float__(self):
        raise TypeError("only dimensionless scalar quantities can be converted to Python scalars")

    def __repr__(self):
        return "<Quantity 1. s>"


NAMES = {
    "datetime": datetime,
    "decimal": decimal,
    "fractions": fractions,
    "np": np,
    "pd": pd,
    "libration": libration,
    "CubicQuintic": CubicQuintic,
    "Duffing": Duffing,
    "DuffingForm": DuffingForm,
    "Pendulum": Pendulum,
    "approx": approx,
    "elliptic": elliptic,
    "papers": papers,
    "p": Pendulum(1.0),
    "spring": Duffing(1.0, p=1.0, q=1.0),
    "t3": np.arange(3.0),
    "t2": np.arange(2.0),
    "pint": Pint(),
    "quantity": np.array(1.0).view(Astropy),
    "quantities": np.arange(3.0).view(Astropy),
    "dates": np.array(["2026-01-01", "2026-01-02"], dtype="M8[s]"),
}

# A call, and below it what it is answered with.
CALLS = r"""
Pendulum(1, length=1, g=9.8)
    TypeError: Pendulum() got an unexpected keyword argument 'g': did you mean gravity?
libration.DampedPendulum(1, g=9.8)
    TypeError: DampedPendulum() got an unexpected keyword argument 'g': did you mean gravity?
libration.damped.half_swing(1.0)
    TypeError: half_swing() needs friction; it takes theta, friction, omega0, omega2, length, gravity
libration.damped.averaged_energy_loss("1", libration.Friction(dry=1))
    TypeError: theta_max = '1': must be real numbers; write float(theta_max)
libration.damped.averaged_turning_angle(4.0, 2.0, libration.Friction(dry=1))
    ValueError: theta_max = 4.0: must be in [0, pi)
libration.Friction(lin=0.1)
    TypeError: Friction() got an unexpected keyword argument 'lin': did you mean linear?
libration.Torque(const=1)
    TypeError: Torque() got an unexpected keyword argument 'const': did you mean constant?
Pendulum(1, L=1)
    TypeError: Pendulum() got an unexpected keyword argument 'L': did you mean length?
Pendulum(1, lenght=1)
    TypeError: Pendulum() got an unexpected keyword argument 'lenght': did you mean length?
Pendulum(1, omega=2)
    TypeError: Pendulum() got an unexpected keyword argument 'omega': did you mean omega0?
Pendulum(1, mass=2)
    TypeError: Pendulum() got an unexpected keyword argument 'mass': it takes theta0, velocity0, theta0_from_top, omega0, omega2, length, gravity
Pendulum()
    TypeError: Pendulum() needs theta0, or theta0_from_top; the angle 0 is the bottom
Pendulum(1, 0, 9.8, 1)
    TypeError: Pendulum() takes theta0, velocity0 by position and theta0_from_top=, omega0=, omega2=, length=, gravity= by name; 4 are given by position
Pendulum(1, theta0=2)
    TypeError: Pendulum() got theta0 by position and by name
Pendulum("1.0")
    ValueError: theta0 = '1.0': must be one real number, a Python or NumPy scalar; write float(theta0)
Pendulum("30deg")
    ValueError: theta0 = '30deg': must be one real number, a Python or NumPy scalar; write np.radians(30)
Pendulum(1j)
    ValueError: theta0 = 1j: must be one real number, a Python or NumPy scalar; write theta0.real
Pendulum([1.0, 2.0])
    ValueError: theta0 = [1.0, 2.0]: must be one real number, a Python or NumPy scalar; libration.motion takes arrays
Pendulum(t3)
    ValueError: theta0 = an array of shape (3,): must be one real number, a Python or NumPy scalar; libration.motion takes arrays
Pendulum(pint)
    ValueError: theta0 in second: must be in rad, or in what converts to it
Pendulum(quantity)
    ValueError: theta0 in s: must be in rad, or in what converts to it
Pendulum(1.0, length=pint)
    ValueError: length in second: must be in m, or in what converts to it
Pendulum(fractions.Fraction(1, 3))
    ValueError: theta0 = Fraction(1, 3): must be one real number, a Python or NumPy scalar; write float(theta0)
Pendulum(decimal.Decimal("0.1"))
    ValueError: theta0 = Decimal('0.1'): must be one real number, a Python or NumPy scalar; write float(theta0)
Pendulum({1.0})
    ValueError: theta0 = {1.0}: must be one real number, a Python or NumPy scalar; write sorted(theta0)
Pendulum.from_action_phase(1.0)
    TypeError: Pendulum.from_action_phase() needs phase; it takes action, phase, direction, omega0, omega2, length, gravity
Pendulum.from_action_phase(1.0, 0.5, dir=1)
    TypeError: Pendulum.from_action_phase() got an unexpected keyword argument 'dir': it takes action, phase, direction, omega0, omega2, length, gravity
p.theta(None)
    TypeError: t = None: must be real numbers
p.theta("1.0")
    TypeError: t = '1.0': must be real numbers; write float(t)
p.theta(datetime.timedelta(seconds=1))
    TypeError: t = datetime.timedelta(seconds=1): must be real numbers; write t.total_seconds()
p.theta(pd.Timedelta("1s"))
    TypeError: t = Timedelta('0 days 00:00:01'): must be real numbers; write t.total_seconds()
p.theta(np.timedelta64(1, "s"))
    TypeError: t = np.timedelta64(1,'s'): must be real numbers; write t / np.timedelta64(1, 's')
p.theta(pd.to_timedelta(np.array([1, 2], "m8[s]")))
    TypeError: t = an array of shape (2,): must be real numbers, not timedelta64[s]; write t / np.timedelta64(1, 's')
p.theta(pd.Series(pd.to_timedelta(np.array([1, 2], "m8[s]"))))
    TypeError: t = an array of shape (2,): must be real numbers, not timedelta64[s]; write t / np.timedelta64(1, 's')
p.theta([datetime.timedelta(seconds=1)])
    TypeError: t = [datetime.timedelta(seconds=1)]: must be real numbers; write [each.total_seconds() for each in t]
p.theta(datetime.datetime(2026, 1, 1))
    TypeError: t = datetime.datetime(2026, 1, 1, 0, 0): must be real numbers; write (t - start).total_seconds()
p.theta(dates)
    TypeError: t = an array of shape (2,): must be real numbers, not datetime64[s]; write (t - t[0]) / np.timedelta64(1, 's')
libration.theta(1.0, pint)
    TypeError: theta0 in second: must be in rad, or in what converts to it
libration.theta(1.0, quantities)
    TypeError: theta0 in s: must be in rad, or in what converts to it
p.theta({1.0, 2.0})
    TypeError: t = {1.0, 2.0}: must be real numbers; write sorted(t)
p.theta({"t": 1.0})
    TypeError: t = {'t': 1.0}: must be real numbers; write list(t.values())
p.theta(p.turning_times)
    TypeError: t = <bound method Crossings.turning_times of Pendulum(theta0=...: must be real numbers; write turning_times(...), its result
p.theta(1j)
    TypeError: t = 1j: must be real numbers; write t.real
p.theta([1j])
    TypeError: t = [1j]: must be real numbers; write np.real(t)
p.theta(["1", "2"])
    TypeError: t = ['1', '2']: must be real numbers; write np.asarray(t, dtype=float)
p.theta(["a"])
    TypeError: t = ['a']: must be real numbers
p.theta([1.0, None])
    TypeError: t = [1.0, None]: must be real numbers; write np.asarray(t, dtype=float)
p.theta([[1.0], [1.0, 2.0]])
    ValueError: t = [[1.0], [1.0, 2.0]]: has rows of different lengths: must be one length, NaN where there is nothing
p.theta(np.array([1.0, "x"], dtype=object))
    TypeError: t = an array of shape (2,): must be real numbers, not object
p.theta(np.array([(1.0, 2.0)], dtype=[("t", float), ("x", float)]))
    TypeError: t = an array of shape (1,): must be real numbers, not [('t', '<f8'), ('x', '<f8')]; write t['t']
p.theta(t3, out=np.empty(2))
    ValueError: out of shape (2,): must have the shape of the result, (3,)
p.theta(t3, out=np.empty(3, int))
    TypeError: out is an array of int64: must be one of float64
p.theta(t3, out=[0.0, 0.0, 0.0])
    TypeError: out = [0.0, 0.0, 0.0]: must be an array of float64, or a tuple of one for each result
p.theta(p)
    TypeError: t = Pendulum(theta0=1.0, velocity0=0.0, omega0=1.0): must be real numbers
p.theta([10**400])
    ValueError: t = an integer beyond the doubles: must be finite
p.theta(pd.DataFrame({"a": [1.0], "b": [1j]}))
    TypeError: t = an array of shape (1, 2): must be real numbers, not complex128 in 'b'
Duffing.of_pendulum(1.0)
    ValueError: pendulum = 1.0: must be a Pendulum
DuffingForm(t3, 1.0, p=1, q=1)
    ValueError: form = an array of shape (3,): must be one of sn, cn, dn, ns, nc, nd, sc, cs, sd, ds, cd, dc
libration.jacobi_complex(t3, m=0.5, out=t3)
    TypeError: out = an array of shape (3,): must be a tuple of three arrays of complex128
p.motion(None)
    TypeError: t = None: must be real numbers
p.turns("1")
    TypeError: t = '1': must be real numbers; write float(t)
p.times("30deg", 0, 7)
    ValueError: theta = '30deg': must be one real number, a Python or NumPy scalar; write np.radians(30)
p.times(0.5, 7)
    TypeError: Pendulum.times() needs stop; it takes theta, start, stop, every_turn
p.turning_times(0.0, pd.Timedelta("1s"))
    ValueError: stop = Timedelta('0 days 00:00:01'): must be one real number, a Python or NumPy scalar; write stop.total_seconds()
p.phase(None)
    TypeError: t = None: must be real numbers
p.sensitivities("1")
    TypeError: t = '1': must be real numbers; write float(t)
p.amplitude
    AttributeError: a Pendulum has no attribute 'amplitude': did you mean theta_max?
p.T
    AttributeError: a Pendulum has no attribute 'T': did you mean period?
p.g
    AttributeError: a Pendulum has no attribute 'g': did you mean gravity?
Pendulum.degrees("30")
    ValueError: theta0 = '30': must be one real number, a Python or NumPy scalar; write float(theta0)
libration.theta(t3, t2)
    ValueError: shapes of t (3,), theta0 (2,): must be equal, or 1 where they differ; for each t with each theta0 write t[:, None]
libration.theta([0, 1, 2], [1, 2])
    ValueError: shapes of t (3,), theta0 (2,): must be equal, or 1 where they differ; for each t with each theta0 write np.array(t)[:, None]
libration.motion(t3, 1.0, 0.0, t2)
    ValueError: shapes of t (3,), omega0 (2,): must be equal, or 1 where they differ; for each t with each omega0 write t[:, None]
libration.theta(1.0)
    ValueError: theta0 must be given, or theta0_from_top; only beside an energy the bottom is meant
libration.theta(1.0, 1.0, 0.0, 1.0, 5.0)
    TypeError: theta() takes t, theta0, velocity0, omega0 by position and theta0_from_top=, energy_ratio=, energy_ratio_c=, energy=, direction=, omega2=, length=, gravity=, out=, where= by name; 5 are given by position
libration.theta(1.0, 1.0, omega=2.0)
    TypeError: theta() got an unexpected keyword argument 'omega': did you mean omega0?
libration.theta(1.0, "1")
    TypeError: theta0 = '1': must be real numbers; write float(theta0)
libration.theta(1.0, theta_0=1.0)
    TypeError: theta() got an unexpected keyword argument 'theta_0': did you mean theta0?
libration.motion(t3, 1.0, out=np.empty(3))
    TypeError: out is one array: must be an array where there is one result, a tuple of one for each result
libration.motion(t3, 1.0, out=(np.empty(3),))
    ValueError: out is a tuple of 1: must be an array where there is one result, a tuple of one for each result
libration.motion(t3, 1.0, where=[True, False])
    ValueError: shapes of t (3,), where (2,): must be equal, or 1 where they differ
libration.advance(1.0, 0.0)
    TypeError: advance() needs dt; it takes theta, velocity, dt, omega0, omega2, length, gravity, out, where
libration.advance(1.0, 0.0, dates)
    TypeError: dt = an array of shape (2,): must be real numbers, not datetime64[s]; write (dt - dt[0]) / np.timedelta64(1, 's')
libration.action(None)
    ValueError: theta must be given, or theta_from_top; only beside an energy the bottom is meant
libration.sensitivities(t3, t2)
    ValueError: shapes of t (3,), theta0 (2,): must be equal, or 1 where they differ; for each t with each theta0 write t[:, None]
libration.complete_k(0.5)
    TypeError: complete_k() takes nothing by position and one of m= (the parameter), mc= (its complement 1 - m), k= (the modulus), q= (the nome) by name
libration.complete_k(m="0.5")
    TypeError: m = '0.5': must be real numbers; write float(m)
libration.complete_k(m=0.5+0j)
    TypeError: m = (0.5+0j): must be real numbers; write m.real
libration.complete_k(alpha=0.5)
    TypeError: complete_k() got an unexpected keyword argument 'alpha': it takes m, mc, k, q, out, where
libration.complete_k(modulus=0.5)
    TypeError: complete_k() got an unexpected keyword argument 'modulus': did you mean k?
libration.jacobi(1, 0.5)
    TypeError: jacobi() takes u by position and one of m= (the parameter), mc= (its complement 1 - m), k= (the modulus), q= (the nome) by name
libration.jacobi(m=0.5)
    TypeError: jacobi() needs u; it takes u, m, mc, k, q, out, where
libration.jacobi(1.0, m=t3, out=t3)
    TypeError: out is one array: must be an array where there is one result, a tuple of one for each result
elliptic.jacobi_epsilon(1 + 1j, m=0.5)
    TypeError: u = (1+1j): must be real numbers; jacobi_complex takes a complex u
elliptic.jacobi_zeta([1j], m=0.5)
    TypeError: u = [1j]: must be real numbers; jacobi_complex takes a complex u
elliptic.sn(1, 0.5)
    TypeError: sn() takes u by position and one of m= (the parameter), mc= (its complement 1 - m), k= (the modulus), q= (the nome) by name
elliptic.sn("1", m=0.5)
    TypeError: u = '1': must be complex numbers; write float(u)
elliptic.sn(t3, m=t2)
    ValueError: shapes of u (3,), m (2,): must be equal, or 1 where they differ; for each u with each m write u[:, None]
elliptic.arcsn(2, 0.5)
    TypeError: arcsn() takes x by position and one of m= (the parameter), mc= (its complement 1 - m), k= (the modulus), q= (the nome) by name
elliptic.theta1(0.5, 0.1)
    TypeError: theta1() takes z by position and one of q= (the nome), m= (the parameter), mc= (its complement 1 - m), k= (the modulus) by name
elliptic.incomplete_f(0.5, 0.1)
    TypeError: incomplete_f() takes phi by position and one of m= (the parameter), mc= (its complement 1 - m), k= (the modulus), q= (the nome) by name
elliptic.incomplete_pi(0.1, 0.5, 0.5)
    TypeError: incomplete_pi() takes n, phi by position and one of m= (the parameter), mc= (its complement 1 - m), k= (the modulus), q= (the nome) by name
elliptic.carlson_rf(1.0, 2.0)
    TypeError: carlson_rf() needs z; it takes x, y, z, out, where
elliptic.carlson_rf(1.0, 2.0, "3")
    TypeError: z = '3': must be real numbers; write float(z)
libration.jacobi_complex("1", m=0.5)
    TypeError: u = '1': must be complex numbers; write float(u)
libration.ellipk
    AttributeError: module 'libration' has no attribute 'ellipk': did you mean complete_k?
libration.compare
    AttributeError: module 'libration' has no attribute 'compare': did you mean approx.compare?
libration.sn
    AttributeError: module 'libration' has no attribute 'sn': did you mean elliptic.sn?
elliptic.ellipj
    AttributeError: module 'libration.elliptic' has no attribute 'ellipj': did you mean jacobi?
Duffing(1, alpha=1)
    TypeError: Duffing() got an unexpected keyword argument 'alpha': did you mean p?
Duffing(1, p=1)
    TypeError: Duffing() needs q=; it takes u0, velocity0, p, q, r, c
Duffing(1, 0, 1, 1)
    TypeError: Duffing() takes u0, velocity0 by position and p=, q=, r=, c= by name; 4 are given by position
Duffing([1.0], p=1, q=1)
    ValueError: u0 = [1.0]: must be one real number, a Python or NumPy scalar; libration.duffing_motion takes arrays
CubicQuintic(1, alpha=1, q=1)
    TypeError: CubicQuintic() got an unexpected keyword argument 'alpha': did you mean p?
DuffingForm("cn", 1.0)
    TypeError: DuffingForm() needs p= and q=; it takes form, c1, c2, p, q
spring.u(pd.Timedelta("1s"))
    TypeError: t = Timedelta('0 days 00:00:01'): must be real numbers; write t.total_seconds()
spring.motion("1")
    TypeError: t = '1': must be real numbers; write float(t)
spring.amplitude
    AttributeError: a Duffing has no attribute 'amplitude': did you mean range?
spring.alpha
    AttributeError: a Duffing has no attribute 'alpha': did you mean p?
libration.duffing_motion(1.0, 1.0, alpha=2.0)
    TypeError: duffing_motion() got an unexpected keyword argument 'alpha': did you mean p?
approx.angle("linear", order=4)
    TypeError: AngleFormula() got an unexpected keyword argument 'order': it takes name
approx.angle("linear").of(p).theta("1")
    TypeError: t = '1': must be real numbers; write float(t)
approx.angle("linear").error("1")
    TypeError: theta_max = '1': must be real numbers; write float(theta_max)
approx.angle("linear").error(1.0, period=2)
    TypeError: AngleFormula.error() got an unexpected keyword argument 'period': did you mean periods?
approx.period("lima-arun").error("60deg")
    TypeError: theta_max = '60deg': must be real numbers; write np.radians(60)
approx.period("lima-arun").ratio(k=0.5)
    TypeError: PeriodFormula.ratio() got an unexpected keyword argument 'k': it takes theta_max, m, mc
""".strip().split("\n")


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(("call", "answer"), list(zip(CALLS[::2], CALLS[1::2], strict=True)), ids=CALLS[::2])
def test_a_wrong_call_is_answered(call, answer):
    with pytest.raises((TypeError, ValueError, AttributeError)) as caught:
        eval(call, dict(NAMES))
    assert f"    {type(caught.value).__name__}: {caught.value}" == answer


def test_what_is_gone_through_once_is_no_array():
    for once in (iter([1.0]), (t for t in [1.0]), map(float, [1]), zip([1.0]), {1.0: 2.0}.values()):
        with pytest.raises(TypeError, match=r"^t = .*: must be real numbers; write list\(t\)$"):
            Pendulum(1.0).theta(once)


def test_long_doubles_are_not_rounded_unasked():
    long = np.ones(1, np.longdouble)
    if long.itemsize == 8:
        assert Pendulum(1.0).theta(long) == Pendulum(1.0).theta([1.0])
        return
    with pytest.raises(TypeError, match=r"must be real numbers, not \w+; write t.astype\(float\)$"):
        Pendulum(1.0).theta(long)


def test_the_advice_is_good():
    """What a refusal says to write is taken."""
    p, expected = Pendulum(1.0), Pendulum(1.0).theta([1.0, 2.0])
    difference = np.array([1, 2], "m8[s]")
    seconds = pd.Series(pd.to_timedelta(difference))
    assert list(p.theta(difference / np.timedelta64(1, "s"))) == list(expected)
    assert list(p.theta(seconds / np.timedelta64(1, "s"))) == list(expected)
    assert list(p.theta([each.total_seconds() for each in seconds])) == list(expected)
    assert list(p.theta(np.asarray(["1", "2"], dtype=float))) == list(expected)
    assert list(np.isnan(p.theta(np.asarray([1.0, None], dtype=float)))) == [False, True]
    assert libration.theta(np.arange(3.0)[:, None], np.arange(2.0)).shape == (3, 2)


def test_errors_that_need_no_words_stay_what_they_are():
    class Broken:
        def __array__(self, dtype=None, copy=None):
            raise TypeError("broken")

    with pytest.raises(TypeError, match=r"^broken$"):
        Pendulum(1.0).theta(Broken())
    with pytest.raises(TypeError, match="do not go together: give both as one of the two"):
        libration.theta(pd.Series([1.0]), pd.DataFrame([[1.0]]))


def test_a_subclass_is_named_by_its_own_name():
    class Clock(Pendulum):
        pass

    with pytest.raises(TypeError, match=r"^Clock\(\) got an unexpected keyword argument 'g': did you mean gravity\?$"):
        Clock(1.0, g=9.8)
    with pytest.raises(TypeError, match=r"^Clock.times\(\) needs stop; it takes theta, start, stop, every_turn$"):
        Clock(1.0).times(0.5, 0.0)


def test_names_of_other_books_are_no_attributes():
    for thing, name in ((Pendulum(1.0), "amplitude"), (Duffing(1.0, p=1.0, q=1.0), "alpha")):
        assert not hasattr(thing, name)
        assert name not in dir(thing)
    assert CubicQuintic(1.0, p=2.0, q=1.0, s=1.0).p == 2.0


@pytest.mark.parametrize("function", [libration.theta, libration.jacobi, elliptic.sn, Pendulum.times, Pendulum.degrees])
def test_functions_are_shown_as_they_are_written(function):
    assert function.__doc__
    assert "arguments" not in inspect.signature(function).parameters
