"""Quantities with units: correctly rounded, and nothing odd let through."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from libration.cli.parser import Refusal
from libration.cli.quantities import ANGLE, FREQUENCY, GRAVITY, LENGTH, TIME, VELOCITY, plain, quantities, quantity

# pi to 60 digits (OEIS A000796), apart from the constant under test.
PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459")


@pytest.mark.parametrize(
    ("text", "dimension", "expected"),
    [
        ("25cm", LENGTH, 0.25),
        ("25 cm", LENGTH, 0.25),
        (" 1.1mm ", LENGTH, 0.0011),
        ("0.3in", LENGTH, 0.00762),
        ("3ft", LENGTH, 0.9144),
        ("1e-3km", LENGTH, 1.0),
        ("1e309mm", LENGTH, 1e306),
        ("180deg", ANGLE, math.pi),
        ("-180deg", ANGLE, -math.pi),
        ("\N{MINUS SIGN}90°", ANGLE, -math.pi / 2),
        ("0.5turn", ANGLE, math.pi),
        ("1.2rad", ANGLE, 1.2),
        ("+.5", ANGLE, 0.5),
        ("3.", ANGLE, 3.0),
        ("0", ANGLE, 0.0),
        ("1e-400", ANGLE, 0.0),
        ("3min", TIME, 180.0),
        ("0.1 h", TIME, 360.0),
        ("1.1ms", TIME, 0.0011),
        ("9.8m/s2", GRAVITY, 9.8),
        ("9.8 m/s^2", GRAVITY, 9.8),
        ("0.5Hz", FREQUENCY, math.pi),
        ("2 1/s", FREQUENCY, 2.0),
        ("180deg/s", FREQUENCY, math.pi),
        ("360 deg/s", VELOCITY, math.tau),
        ("-2.5rad/s", VELOCITY, -2.5),
        ("180\N{MASCULINE ORDINAL INDICATOR}", ANGLE, math.pi),
        ("180\N{RING ABOVE}", ANGLE, math.pi),
        ("180 degrees", ANGLE, math.pi),
        ("1 degree", ANGLE, math.radians(1)),
        ("200gon", ANGLE, math.pi),
        ("0.5 turns", ANGLE, math.pi),
        ("1.5 radians", ANGLE, 1.5),
        ("1100 mrad", ANGLE, 1.1),
        ("11\N{MICRO SIGN}m", LENGTH, 0.000011),
        ("11\N{GREEK SMALL LETTER MU}m", LENGTH, 0.000011),
        ("11um", LENGTH, 0.000011),
        ("1.1 meters", LENGTH, 1.1),
        ("1.1 inches", LENGTH, 0.02794),
        ("11 feet", LENGTH, 3.3528),
        ("1,5m", LENGTH, 1.5),
        ("0,250 m", LENGTH, 0.25),
        ("-0,5", ANGLE, -0.5),
        ("1,5e-2m", LENGTH, 0.015),
        ("1,250e1m", LENGTH, 12.5),
        ("9,8", GRAVITY, 9.8),
        ("1.1 sec", TIME, 1.1),
        ("1.1 seconds", TIME, 1.1),
        ("1.1\N{MICRO SIGN}s", TIME, 0.0000011),
        ("2 minutes", TIME, 120.0),
        ("2 hours", TIME, 7200.0),
        ("9.8 N/kg", GRAVITY, 9.8),
        ("978.1cm/s2", GRAVITY, 9.781),
        ("978.1 cm/s\N{SUPERSCRIPT TWO}", GRAVITY, 9.781),
        ("978.1 cm / s^2", GRAVITY, 9.781),
        ("978.1 Gal", GRAVITY, 9.781),
        ("32.1ft/s2", GRAVITY, 9.78408),
        ("32.1ft/s**2", GRAVITY, 9.78408),
        ("9.8 m s\N{SUPERSCRIPT MINUS}\N{SUPERSCRIPT TWO}", GRAVITY, 9.8),
        ("2 s^-1", FREQUENCY, 2.0),
        ("180\N{MASCULINE ORDINAL INDICATOR}/s", VELOCITY, math.pi),
        ("60 rpm", VELOCITY, math.tau),
        ("0.5 turns/s", VELOCITY, math.pi),
    ],
)
def test_values(text, dimension, expected):
    got = quantity("--x", text, dimension)
    assert got.hex() == expected.hex()


def nearest(exact):
    """The double nearest to a fraction: Python rounds the quotient of whole numbers correctly."""
    return exact.numerator / exact.denominator


@given(st.decimals(-(10**6), 10**6, allow_nan=False, places=12))
def test_one_rounding(number):
    text, exact = f"{number:f}", Fraction(number)
    assert quantity("--x", f"{text}deg", ANGLE) == nearest(exact * PI / 180)
    assert quantity("--x", f"{text}turn", ANGLE) == nearest(exact * 2 * PI)
    assert quantity("--x", f"{text}in", LENGTH) == nearest(exact * Fraction(254, 10000))
    assert quantity("--x", f"{text}ms", TIME) == nearest(exact / 1000)
    assert quantity("--x", text, TIME) == nearest(exact)


def test_the_naive_product_would_not_do():
    """The sibling: number times factor in doubles rounds twice, and these tests see it."""
    assert any(quantity("--x", f"{k}.1mm", LENGTH) != float(f"{k}.1") * 0.001 for k in range(100))
    assert any(quantity("--x", f"{k}deg", ANGLE) != k * (math.pi / 180) for k in range(1, 360))
    assert any(quantity("--x", f"{k}deg", ANGLE) != math.radians(k) for k in range(1, 360))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("12 parsecs", "unknown unit 'parsecs'; lengths take m, cm, mm, km, in, ft"),
        ("1CM", "unknown unit 'CM'; lengths take m, cm, mm, km, in, ft; did you mean cm?"),
        ("1deg", "unknown unit 'deg'"),
        ("1e", "unknown unit 'e'"),
        (",5", "has a decimal comma after no digit; write 0.5"),
        ("1,500m", "may have a decimal comma or one after the thousands; write 1.500m or 1500m"),
        ("-12,345 cm", "write -12.345cm or -12345cm"),
        ("1,234,567", "is not a number with a unit"),
        ("1,5,2m", "is not a number with a unit"),
        ("1.234,5m", "is not a number with a unit"),
        ("1,", "is not a number with a unit"),
        ("nan", "must be a finite number"),
        ("-inf", "must be a finite number"),
        ("infinity m", "must be a finite number"),
        ("1e400", "is beyond the largest double"),
        ("1e99999999999999999999999m", "is beyond the largest double"),
        ("1e300 km 2", "unknown unit 'km 2'"),
        ("1e306km", "is beyond the largest double"),
        ("", "is not a number with a unit; lengths look like 1.5 or 1.5m"),
        ("m", "is not a number with a unit"),
        ("1.5.2m", "is not a number with a unit"),
        ("1_000", "unknown unit '_000'"),
        ("\u0663m", "is not a number with a unit"),
        ("0x10", "unknown unit 'x10'"),
        ("0", "must be greater than 0"),
        ("-1m", "must be greater than 0"),
        ("1e-400m", "must be greater than 0"),
    ],
)
def test_refusals(text, said):
    with pytest.raises(Refusal) as caught:
        quantity("--length", text, LENGTH, above=0)
    assert said in str(caught.value)
    assert str(caught.value).startswith("--length = ")


@given(st.text(max_size=30))
def test_any_text_gives_a_finite_double_or_a_refusal(text):
    try:
        assert math.isfinite(quantity("--x", text, ANGLE))
    except Refusal as refusal:
        assert str(refusal).startswith("--x = ")


LONG = 1_000_000


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (LONG * "1" + "," + LONG * "1", "is beyond the largest double"),
        (LONG * "1" + "." + LONG * "1" + ".", "is not a number with a unit"),
        ("1" + LONG * " " + "x", "unknown unit 'x'"),
        ("1x" + LONG * " " + "y", "unknown unit"),
        (LONG * " " + "x", "is not a number with a unit"),
        ("1e" + LONG * "1" + ".", "unknown unit"),
        ("1." + LONG * "0" + "deg" + LONG * " " + "deg", "unknown unit"),
    ],
)
def test_time_grows_with_the_length(text, said):
    """What takes the square of it would take hours; the refusal is short."""
    with pytest.raises(Refusal, match=said) as caught:
        quantity("--theta0", text, ANGLE)
    assert len(str(caught.value)) < 300


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1m", [1.0]),
        ("1m,25cm, 3 mm", [1.0, 0.25, 0.003]),
        ("1,5m;0,25m", [1.5, 0.25]),
        ("1;2", [1.0, 2.0]),
        ("1.5m;2", [1.5, 2.0]),
    ],
)
def test_lists(text, expected):
    assert quantities("--x", text, LENGTH) == expected


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("0,5", "a comma between digits may separate values or be decimal; write 0m,5m or 0.5"),
        ("1m,2,5m", "write 1m,2m,5m or 1m,2.5m"),
        ("1,5,2cm", "be decimal; write 1cm,5cm,2cm"),
        ("1cm,0,2", "write 1cm,0m,2m or 1cm,0.2"),
        ("1m,,2m", "has an empty place between its separators"),
        ("1m;", "has an empty place"),
        ("", "has no value; lengths look like 1.5 or 1.5m"),
        ("1m,2deg", "--x = 2deg: unknown unit 'deg'"),
    ],
)
def test_refusals_of_lists(text, said):
    with pytest.raises(Refusal) as caught:
        quantities("--x", text, LENGTH)
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("30,60,90", "write 30deg,60deg,90deg"),
        ("20,60,150deg", "write 20deg,60deg,150deg"),
        ("1,2", "1rad,2rad or 1.2"),
    ],
)
def test_a_list_of_angles_is_to_be_written_without_quotes_of_a_shell(text, said):
    with pytest.raises(Refusal) as caught:
        quantities("--theta0", text, ANGLE)
    assert str(caught.value).endswith(said)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("pi/2", "angles look like 1.5 or 1.5rad; pi is 180deg or 0.5turn"),
        ("1.5\u03c0", "unknown unit '\u03c0'; angles take rad, deg, turn; pi is 180deg or 0.5turn"),
        ("20 graus", "unknown unit 'graus'; angles take rad, deg, turn; write deg"),
        ("20Grados", "unknown unit 'Grados'; angles take rad, deg, turn; write deg"),
    ],
)
def test_angles_as_people_write_them(text, said):
    with pytest.raises(Refusal) as caught:
        quantity("--theta0", text, ANGLE)
    assert str(caught.value).endswith(said)


def test_a_plain_number_has_no_unit_to_name():
    with pytest.raises(Refusal, match=r"^--p = x: is not a number; numbers look like 1.5 or 2e-3$"):
        plain("--p", "x")


def test_grad_means_two_things():
    with pytest.raises(Refusal, match="it is a degree in some languages and pi/200 in others: write deg or gon"):
        quantity("--theta0", "30grad", ANGLE)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("150", "taken as 150 rad, 24 whole turns and -45.63 deg; for degrees write 150deg"),
        ("-90", "taken as -90 rad, -14 whole turns and -116.6 deg; for degrees write -90deg"),
        ("6.3", "taken as 6.3 rad, 1 whole turn and 0.9634 deg; for degrees write 6.3deg"),
    ],
)
def test_a_large_angle_without_unit_is_taken_and_said(capsys, text, said):
    assert quantity("--theta0", text, ANGLE) == float(text)
    answer = capsys.readouterr()
    assert answer.out == ""
    assert answer.err == f"libration: --theta0 = {text}: {said}\n"


@pytest.mark.parametrize(
    ("text", "dimension"), [("150deg", ANGLE), ("150rad", ANGLE), ("6.28", ANGLE), ("150", LENGTH), ("150", VELOCITY)]
)
def test_nothing_is_said_otherwise(capsys, text, dimension):
    quantity("--x", text, dimension)
    assert capsys.readouterr() == ("", "")
