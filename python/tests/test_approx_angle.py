"""The approximations of the angle: what the papers say of them, and their tables to the printed digit.

The tables were measured at 40 digits with mpmath, apart from this code.
"""

import math

import numpy as np
import pytest

from libration import Pendulum, approx


def released(degrees):
    return Pendulum(math.radians(degrees))


def error(name, pendulum, periods=1):
    return approx.angle(name).of(pendulum).error(periods)


def printed(value, text):
    """Whether a value rounds to a printed number."""
    digits = len(text.split("e")[0].lstrip("-0.").replace(".", "")) or 1
    return float(f"{value:.{digits - 1}e}") == float(text)


# ------------------------------------------------------------------------------------------------ Lima 2019

LIMA = [
    (60, "harmonic", "0.941"),
    (60, "fourier:1", "1.951"),
    (60, "fourier:2", "0.0350"),
    (90, "harmonic", "2.329"),
    (90, "fourier:2", "0.2269"),
    (144, "harmonic", "8.5981"),
    (144, "fourier:3", "0.6069"),
    (157.5, "harmonic", "12.34"),
    (157.5, "fourier:4", "0.3989"),
    (171, "harmonic", "19.79"),
    (171, "fourier:6", "0.2945"),
]


@pytest.mark.parametrize(("degrees", "name", "percent"), LIMA)
def test_percentages_of_lima(degrees, name, percent):
    found = error(name, released(degrees))
    assert printed(100 * found.relative, percent)
    assert math.isnan(found.undefined_from)


def test_the_largest_error_is_not_always_at_the_start():
    pendulum = Pendulum(0.9 * math.pi)
    found = error("fourier:2", pendulum)
    assert f"{found.difference:.4f} {found.t / pendulum.period:.4f}" == "0.3787 0.0921"
    start = abs(approx.angle("fourier:2").of(pendulum).difference(0.0))
    assert f"{start:.4f}" == "0.3036"


# The turning angle in pi from which the arcsine is undefined: odd N at t = 0, even N inside the swing.
THRESHOLDS = {1: 0.7308281, 2: 0.9045696, 3: 0.9139335, 4: 0.9547283, 5: 0.9619201, 6: 0.9766126, 7: 0.9804268}
THRESHOLDS |= {8: 0.9869081, 9: 0.98899}


@pytest.mark.parametrize("order", THRESHOLDS)
def test_where_the_arcsine_ends(order):
    bound, digit = THRESHOLDS[order], 1e-5 if order == 9 else 1e-7
    assert math.isnan(error(f"fourier:{order}", Pendulum((bound - digit) * math.pi)).undefined_from)
    beyond = approx.angle(f"fourier:{order}").of(Pendulum((bound + digit) * math.pi))
    since = beyond.error().undefined_from
    assert (since == 0.0) == (order % 2 == 1)
    # An interval as short as that of an even N next to its threshold is found all the same.
    assert since < 0.25 * beyond.pendulum.period
    assert np.isnan(beyond.theta(since))


# From here on the largest error of even N is inside the swing.
LEAVES = {2: "0.884478", 4: "0.939148", 6: "0.966271", 8: "0.980073"}


@pytest.mark.parametrize("order", LEAVES)
def test_where_the_largest_error_leaves_the_start(order):
    bound = float(LEAVES[order])
    assert error(f"fourier:{order}", Pendulum((bound - 2e-6) * math.pi)).t == 0.0
    assert error(f"fourier:{order}", Pendulum((bound + 2e-6) * math.pi)).t > 0.0


def test_a_difference_is_the_rest_of_the_series_and_not_that_of_two_angles():
    pendulum = Pendulum(math.pi / 2)
    for name in ("fourier:16", "fourier-theta:16"):
        made = approx.angle(name).of(pendulum)
        assert 1e-24 < abs(made.difference(0.3)) < 1e-20
        assert abs(made.theta(0.3) - pendulum.theta(0.3)) < 1e-15


# ------------------------------------------------------------------------------------------------ Salas 2019

# Degrees, k/k_exact - 1, largest |difference| over T/4, T and 10 T, and that from the cubic-quintic motion over T.
TRIGONOMETRIC = """
10   2.3e-5  6.4e-6  1.9e-5  2.5e-4  1.4e-7
30   1.9e-4  1.6e-4  4.8e-4  6.2e-3  3.4e-5
60   5.4e-4  9.1e-4  2.7e-3  3.5e-2  1.2e-3
90   5.9e-4  2.6e-3  5.4e-3  6.0e-2  1.2e-2
100  5.7e-4  4.2e-3  7.1e-3  6.6e-2  2.2e-2
110  6.9e-4  7.2e-3  1.1e-2  9.1e-2  4.0e-2
120  1.3e-3  1.4e-2  2.1e-2  1.8e-1  7.3e-2
140  7.1e-3  5.8e-2  1.1e-1  1.25    2.3e-1
160  4.2e-2  3.0e-1  7.4e-1  5.4     8.0e-1
170  1.2e-1  8.0e-1  2.1     5.9     1.5
"""


@pytest.mark.parametrize("line", TRIGONOMETRIC.strip().splitlines())
def test_trigonometric(line):
    degrees, rate, *errors, own = line.split()
    pendulum = released(float(degrees))
    made, model = (approx.angle(name).of(pendulum) for name in ("trigonometric", "cubic-quintic"))
    assert printed(pendulum.period / made.period - 1, rate)
    for periods, text in zip((0.25, 1, 10), errors, strict=True):
        assert printed(made.error(periods).difference, text)
    t = np.linspace(0, pendulum.period, 20_001)
    assert printed(np.abs(made.theta(t) - model.theta(t)).max(), own)


def test_example_3():
    made = approx.angle("trigonometric").of(Pendulum(math.pi / 2))
    t = [1, 2, 3, 5, made.pendulum.period]
    truth = [1.07276838564, -0.206665130214, -1.32084723898, -0.749808275721, 1.57078665838]
    assert np.allclose(made.theta(t), truth, rtol=0, atol=1e-11)
    assert f"{made.period:.9f}" == "7.411914058"


# m, largest |difference| over theta_max of the formula before fig. 6 over T and 10 T, and of the bounded one over both.
SMALL = """
0.001  1.4e-6  1.2e-4  -
0.01   1.4e-4  1.2e-2  5.1e-6
0.05   3.6e-3  0.30    1.3e-4
0.1    1.4e-2  1.1     5.4e-4
0.2    6.0e-2  3.0     2.3e-3
0.3    0.139   3.1     5.7e-3
0.5    0.43    2.9     1.9e-2
"""


@pytest.mark.parametrize("line", SMALL.strip().splitlines())
def test_small_m(line):
    m, once, ten, bounded = line.split()
    pendulum = Pendulum(2 * math.asin(math.sqrt(float(m))))
    assert printed(error("small-m", pendulum).relative, once)
    assert printed(error("small-m", pendulum, 10).relative, ten)
    both = [error("small-m-bounded", pendulum, periods).relative for periods in (1, 10)]
    assert both[0] == both[1]
    assert bounded == "-" or printed(both[0], bounded)


# ------------------------------------------------------------------------------------------------ both series

# N, and for pi/3, pi/2, 4pi/5, 7pi/8, 0.95pi, 0.99pi the largest difference of fourier:N / fourier-theta:N; * undefined.
SERIES = """
1   2.0e-2/6.5e-3    8.4e-2/2.4e-2    */.150           */.241           */.438           */.770
2   3.7e-4/7.0e-5    3.6e-3/6.4e-4    9.8e-2/1.3e-2    .229/3.0e-2      */8.3e-2         */.225
3   6.6e-6/9.0e-7    1.5e-4/2.0e-5    1.5e-2/1.4e-3    6.2e-2/4.3e-3    */1.8e-2         */7.1e-2
4   1.2e-7/1.3e-8    6.7e-6/6.7e-7    2.1e-3/1.6e-4    1.1e-2/6.5e-4    .109/4.0e-3      */2.4e-2
5   2.1e-9/1.9e-10   2.9e-7/2.4e-8    3.1e-4/1.8e-5    2.2e-3/1.1e-4    3.6e-2/9.5e-4    */8.1e-3
6   3.8e-11/2.8e-12  1.2e-8/8.6e-10   4.4e-5/2.2e-6    4.2e-4/1.7e-5    8.8e-3/2.3e-4    */2.9e-3
8   1.2e-14/7.0e-16  2.3e-11/1.2e-12  9.0e-7/3.5e-8    1.6e-5/5.1e-7    7.3e-4/1.5e-5    */3.8e-4
12  -/-              8.1e-17/2.9e-18  3.7e-10/1.0e-11  2.2e-8/4.9e-10   4.8e-6/6.6e-8    1.5e-3/7.5e-6
16  -/-              -/-              1.6e-13/3.2e-15  3.2e-11/5.3e-13  3.2e-8/3.3e-10   4.2e-5/1.6e-7
"""
AMPLITUDES = (1 / 3, 1 / 2, 4 / 5, 7 / 8, 0.95, 0.99)


@pytest.mark.parametrize("line", SERIES.strip().splitlines())
def test_both_series(line):
    order, *cells = line.split()
    for share, cell in zip(AMPLITUDES, cells, strict=True):
        pendulum = Pendulum(share * math.pi)
        for name, text in zip(("fourier", "fourier-theta"), cell.split("/"), strict=True):
            found = error(f"{name}:{order}", pendulum)
            assert math.isnan(found.undefined_from) == (text != "*")
            assert text in "*-" or printed(found.difference, text)
