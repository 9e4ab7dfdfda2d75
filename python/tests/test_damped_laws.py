"""The exact half swing and the averaged laws against quadratures of 20 digits, which share no formula with them."""

import math

import mpmath as mp
import numpy as np
import pytest
import xarray
from scipy.integrate import quad

from libration import DampedPendulum, Friction
from libration.damped import averaged_energy_loss, averaged_turning_angle, averaged_turning_rate, half_swing

# Linear, quadratic, dry, presliding; the square of omega0.
LAWS = [
    ((0.02, 0.0, 0.0, 0.0), 1.0),
    ((0.0, 0.05, 0.0, 0.0), 2.0),
    ((0.0, 0.0, 0.03, 0.0), 0.25),
    ((0.0, 0.0, 0.03, 0.125), 9.5),
    ((0.01, 0.02, 0.005, 0.0), 1.5),
    ((0.01, 0.02, 0.02, 0.0625), 4.0),
]
ANGLES = (0.0078125, 0.5, 1.75, 3.125)


def friction_of(law):
    return Friction(**dict(zip(("linear", "quadratic", "dry", "presliding"), law, strict=True)))


def speed(theta, a, omega2):
    """Of the undamped orbit with the turning angle a, by its energy."""
    return mp.sqrt(4 * omega2 * mp.sin((a - theta) / 2) * mp.sin((a + theta) / 2))


def lost(a, law, omega2):
    """The work of friction in a period: twice that of the way from -a to a, and the hysteresis of presliding."""
    linear, quadratic, dry, presliding = map(mp.mpf, law)

    def work(x):
        # theta = a sin x takes the root out of the ends.
        theta = a * mp.sin(x)
        v = speed(theta, a, omega2)
        z = 1
        if presliding:
            # The cycle of Dahl's law from -z0 at -a to z0 at a.
            s = theta + a
            z = 1 - 2 * mp.exp(-s / presliding) / (1 + mp.exp(-2 * a / presliding))
        return (2 * linear * v + quadratic * v * v + dry * z) * a * mp.cos(x)

    ends = [-mp.pi / 2, -mp.pi / 4, 0, mp.pi / 4, mp.pi / 2]
    return 2 * mp.quad(work, ends)


def period(a, omega2):
    """By the arithmetic-geometric mean."""
    return 2 * mp.pi / mp.sqrt(omega2) / mp.agm(1, mp.cos(a / 2))


@pytest.mark.parametrize(("law", "omega2"), LAWS)
def test_losses_and_rates(law, omega2):
    with mp.workdps(22):
        losses = [lost(mp.mpf(a), law, mp.mpf(omega2)) for a in ANGLES]
        rates = [
            -loss / (period(mp.mpf(a), mp.mpf(omega2)) * omega2 * mp.sin(a))
            for a, loss in zip(ANGLES, losses, strict=True)
        ]
        found = averaged_energy_loss(ANGLES, friction_of(law), omega2=omega2)
        slopes = averaged_turning_rate(ANGLES, friction_of(law), omega2=omega2)
        assert max(abs(x / y - 1) for x, y in zip(found, losses, strict=True)) <= 1e-15
        assert max(abs(x / y - 1) for x, y in zip(slopes, rates, strict=True)) <= 2e-15
        # A wrong factor is found.
        assert max(abs(x / y - 1) for x, y in zip(found * (1 + 4e-15), losses, strict=True)) > 1e-15


@pytest.mark.parametrize(("law", "omega2"), LAWS)
@pytest.mark.parametrize(("start", "end"), [(0.5, 0.25), (3.125, 1.0), (1.75, 0.0078125)])
def test_decays(law, omega2, start, end):
    """The time to a turning angle by quadratures over the angle, in doubles, and the angle after that time."""
    linear, quadratic, dry, presliding = law

    def work(x, a):
        theta = a * math.sin(x)
        v = math.sqrt(4 * omega2 * math.sin((a - theta) / 2) * math.sin((a + theta) / 2))
        z = 1 - 2 * math.exp(-(theta + a) / presliding) / (1 + math.exp(-2 * a / presliding)) if presliding else 1
        return (2 * linear * v + quadratic * v * v + dry * z) * a * math.cos(x)

    def slowness(a):
        loss = 2 * quad(work, -math.pi / 2, math.pi / 2, (a,), epsabs=0, epsrel=1e-12)[0]
        return float(period(mp.mpf(a), mp.mpf(omega2))) * omega2 * math.sin(a) / loss

    time = quad(lambda x: slowness(math.exp(x)) * math.exp(x), math.log(end), math.log(start), epsabs=0, epsrel=1e-10)[
        0
    ]
    found = averaged_turning_angle(start, time, friction_of(law), omega2=omega2)
    assert abs(found / end - 1) < 1e-8
    assert abs(averaged_turning_angle(start, 1.001 * time, friction_of(law), omega2=omega2) / end - 1) > 1e-6


@pytest.mark.parametrize(
    ("law", "omega2", "start", "end"),
    [
        ((0.01, 0.02, 0.005, 0.0), 1.5, 1.75, 0.25),
        ((0.0, 0.05, 0.0, 0.0), 2.0, 3.125, 1.0),
        ((0.0, 0.0, 0.03, 0.0), 0.25, 0.5, 0.0078125),
        ((0.01, 0.02, 0.02, 0.0625), 4.0, 0.5, 0.0078125),
    ],
)
def test_decays_to_the_last_digits(law, omega2, start, end):
    """The time by the closed form of the loss, whose quadrature is above, with Legendre's integrals of mpmath."""
    with mp.workdps(22):
        linear, quadratic, dry, presliding, square = map(mp.mpf, (*law, omega2))

        def slowness(a):
            m = mp.sin(a / 2) ** 2
            action = 8 * mp.sqrt(square) / mp.pi * (mp.ellipe(m) - (1 - m) * mp.ellipk(m))
            hysteresis = a - (presliding * mp.tanh(a / presliding) if presliding else 0)
            loss = (
                4 * mp.pi * linear * action
                + 8 * quadratic * square * (mp.sin(a) - a * mp.cos(a))
                + 4 * dry * hysteresis
            )
            return 4 * mp.ellipk(m) * mp.sqrt(square) * mp.sin(a) / loss

        points = mp.linspace(mp.log(mp.mpf(end)), mp.log(mp.mpf(start)), 4)
        time = mp.quad(lambda x: slowness(mp.exp(x)) * mp.exp(x), points)
        slow = slowness(mp.mpf(end))
        # The double nearest to the time is not the time.
        truth = end - (mp.mpf(float(time)) - time) / slow
        found = averaged_turning_angle(start, float(time), friction_of(law), omega2=omega2)
        assert abs(found - truth) <= 16 * math.ulp(end) + 2.0**-52 * time / slow
        assert abs(found * (1 + 1e-13) - truth) > 16 * math.ulp(end) + 2.0**-52 * time / slow


@pytest.mark.parametrize(
    ("theta", "quadratic", "dry", "omega2"),
    [(-2.0, 0.1, 0.02, 1.0), (3.125, 0.5, 0.0, 2.0), (0.5, 0.0, 0.0625, 1.0), (-1.0, 2.0, 0.25, 9.5)],
)
def test_half_swings(theta, quadratic, dry, omega2):
    """The square of the velocity over the angle, integrated by Taylor series to 20 digits."""
    with mp.workdps(20):
        beta, mu, square, side = map(mp.mpf, (quadratic, dry, omega2, -math.copysign(1, theta)))
        start = mp.mpf(theta)

        def slope(x, w):
            # x is the way since the turn, w the square of the velocity.
            angle = start + side * x
            return -2 * (beta * w + mu + side * square * mp.sin(angle))

        way = mp.odefun(slope, 0, mp.mpf(0))
        end = mp.findroot(way, (1.2 * abs(start), 2 * abs(start)), solver="anderson", tol=1e-18)
        truth = start + side * end
        found = half_swing(theta, Friction(quadratic=quadratic, dry=dry), omega2=omega2)
        assert abs(found - truth) <= 2 * math.ulp(theta)


def test_where_dry_friction_holds():
    friction = Friction(dry=0.5)
    assert half_swing(0.5, friction) == 0.5
    angles = [3.0]
    while half_swing(angles[-1], friction) != angles[-1]:
        angles.append(float(half_swing(angles[-1], friction)))
    pendulum = DampedPendulum(3.0, friction=friction)
    [(begin, _)] = pendulum.rests(0.0, 60.0)
    assert abs(pendulum.theta(begin) - angles[-1]) < 1e-14
    assert averaged_turning_angle(1.0, 50.0, Friction(dry=0.05)) == 0.0


def test_shapes_and_labels():
    friction, theta = Friction(quadratic=0.1), np.array([[0.5, 1.0, 4.0]])
    for function in (half_swing, averaged_energy_loss, averaged_turning_rate):
        found = function(theta, friction, length=2.0)
        assert found.shape == (1, 3) and np.isnan(found).tolist() == [[False, False, True]]
        assert type(function(1.0, friction)) is np.float64
        assert function(1.0, friction, length=2.0, gravity=9.80665) == found[0, 1]
    t = xarray.DataArray([0.0, 1.0], dims="t")
    envelope = averaged_turning_angle(1.0, t, friction)
    assert envelope.dims == ("t",) and envelope.name == "theta_max" and envelope.attrs["units"] == "rad"
    assert float(envelope[0]) == 1.0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda: half_swing(1.0, Friction(linear=0.1)),
            "friction = Friction(linear=0.1, quadratic=0.0, dry=0.0, presliding=0.0): must be a Friction without a linear term",
        ),
        (lambda: half_swing(1.0, Friction(dry=0.1, presliding=0.1)), "without presliding"),
        (lambda: half_swing(1.0, Friction(quadratic=-0.1)), "its quadratic term not negative"),
        (lambda: half_swing(1.0, 0.1), "friction = 0.1: must be a Friction"),
        (lambda: averaged_energy_loss(1.0, None), "friction = None: must be a Friction"),
        (lambda: averaged_energy_loss(1.0, Friction(), omega2=-1), "omega2 = -1.0: must be positive"),
        (lambda: averaged_energy_loss(1.0, Friction(), length=1, gravity=-9.8), "gravity = -9.8: must be positive"),
        (lambda: averaged_turning_rate(1.0, Friction(), omega0=0), "omega0 = 0.0: must be"),
        (lambda: averaged_turning_angle(3.2, 1.0, Friction()), "theta_max = 3.2: must be in [0, pi)"),
        (lambda: averaged_turning_angle([1.0], 1.0, Friction()), "theta_max = [1.0]: must be one real number"),
        (
            lambda: averaged_turning_angle(1.0, 1.0, Friction(linear=-0.1, dry=0.1)),
            "must have no term below 0, or the linear one alone",
        ),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError) as refused:
        call()
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)
