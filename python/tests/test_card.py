"""What a notebook shows: an SVG that is well formed, and a closed form whose printed numbers give theta(t)."""

import html
import math
import re
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

from libration import CubicQuintic, Duffing, Pendulum, elliptic
from libration.pendulum._closed_form import closed_form

# Six digits: half a unit in the last of them, of the argument and of the frequency times the time.
ROUNDING = 5e-6
PENDULUMS = {
    "swing": Pendulum(3.0, length=1.0, gravity=9.8),
    "small": Pendulum(1e-7),
    "moving": Pendulum(1.0, -0.5, omega0=2.0),
    "another turn": Pendulum(-7.0, 0.3),
    "many turns": Pendulum(1000.0, 0.3),
    "near the top": Pendulum(math.radians(179.999), length=1.0),
    "next to the top": Pendulum(math.pi),
    "hanging": Pendulum(2.5, omega2=-4.0),
    "hanging below": Pendulum(-2.5, 0.4, omega2=-4.0),
    "rotation": Pendulum(0.3, 2.6),
    "rotation back": Pendulum(0.3, -2.6, omega0=1.3),
    "rotation from another turn": Pendulum(9.0, 3.0),
    "slow rotation": Pendulum(0.0, 2.0000001),
    "slow rotation back": Pendulum(3.0, -0.2, omega0=1.0),
    "fast": Pendulum(1.0, 1e5),
    "hanging rotation": Pendulum(7.0, -3.0, omega2=-1.0),
    "hanging rotation of 0": Pendulum(0.0, 3.0, omega2=-1.0),
    "separatrix": Pendulum(0.0, 2.0),
    "separatrix back": Pendulum(0.0, -2.0),
    "balance": Pendulum(0.0, omega2=-1.0),
    "rest": Pendulum(0.0),
    "free": Pendulum(1.0, -0.25, omega0=0.0),
    "free rest": Pendulum(1.5, omega0=0.0),
}


def printed(pendulum):
    """The closed form as the notebook shows it."""
    shown = html.unescape(re.sub(r"<[^>]*>", "\n", pendulum._repr_html_()))
    [form] = [line for line in shown.splitlines() if line.startswith("θ(t)")]
    return form.replace("\u00a0", " ")


def parameter(text):
    """A printed parameter, with its distance from 1 where that is printed."""
    complement = re.fullmatch(r"1 - (\S+)", text.strip())
    return {"mc": float(complement[1])} if complement else {"m": float(text)}


def evaluated(form, t):
    """The value of a printed form: its text is read, and nothing else is known of the pendulum."""
    text = form.partition(" = ")[2].replace("−", "-")
    raised = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
    text = re.sub(r"(?:(?<=\d)×)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", lambda found: f"@e{found[1].translate(raised)}", text)
    text = re.sub(r"(?<![\d.])@", "1", text).replace("@", "")
    text = text.replace("2 arcsin(", "2*arcsin(").replace("2 am(", "2*am(").replace("2 arctan(", "2*arctan(")
    text = re.sub(r"(?<=[\d)]) (?=sn|t\b)", "*", text)
    text = re.sub(r"(\d*)π", lambda found: f"{found[1] or 1}*pi", text)
    text = re.sub(r"\| (.+?)\)(?=\)|$)", r", '\1')", text)
    names = {
        "t": t,
        "pi": math.pi,
        "arcsin": np.arcsin,
        "arctan": np.arctan,
        "sinh": np.sinh,
        "sn": lambda u, m: elliptic.sn(u, **parameter(m)),
        "am": lambda u, m: elliptic.jacobi(u, **parameter(m)).am,
    }
    return eval(text, {"__builtins__": {}}, names) + 0 * t


def duration(pendulum):
    """A time in which much happens."""
    if math.isfinite(pendulum.period):
        return pendulum.period
    return 6 / pendulum.omega0 if pendulum.omega0 else 3.0


def tolerance(form, pendulum, t):
    """What the rounding of the numbers makes of the angle, with the steepest slope that there is."""
    numbers = [abs(float(each)) for each in re.findall(r"t [+−] ([\d.]+)", form)]
    fastest = max(np.max(np.abs(pendulum.velocity(t))), 1e-300)
    rate = pendulum.omega0 if pendulum.regime != "rotation" or not pendulum.omega0 else fastest
    size = pendulum.theta_max if pendulum.regime == "libration" else 1.0
    return ROUNDING * (np.abs(t) * fastest + size + (fastest / (rate or 1.0)) * sum(numbers, 1.0))


@pytest.mark.parametrize("name", PENDULUMS)
def test_the_printed_form_is_the_motion(name):
    pendulum = PENDULUMS[name]
    t = np.linspace(-1.0, 1.5, 401) * duration(pendulum)
    form = printed(pendulum)
    assert form == closed_form(pendulum)
    with np.errstate(over="ignore"):
        difference = np.abs(evaluated(form, t) - pendulum.theta(t))
    assert np.all(difference <= tolerance(form, pendulum, t)), (form, difference.max())


@pytest.mark.parametrize("name", ["swing", "near the top", "rotation", "hanging", "separatrix"])
def test_a_spoiled_form_is_found(name):
    """The sibling: one digit of the first number of the argument, changed."""
    pendulum = PENDULUMS[name]
    t = np.linspace(-1.0, 1.5, 401) * duration(pendulum)
    form = printed(pendulum)
    spoiled = re.sub(
        r"(\()([\d.]* ?)t\b", lambda found: f"{found[1]}{float(found[2] or 1) * 1.001:.6g} t", form, count=2
    )
    spoiled = spoiled.replace("θ(1.001 t)", "θ(t)")
    assert spoiled != form
    with np.errstate(over="ignore"):
        difference = np.abs(evaluated(spoiled, t) - pendulum.theta(t))
    assert not np.all(difference <= tolerance(form, pendulum, t))


@pytest.mark.parametrize(
    ("pendulum", "form"),
    [
        (PENDULUMS["swing"], "θ(t) = 2 arcsin(0.99749499 sn(3.1305 t + 4.03888 | 0.99499625))"),
        (Pendulum(0.3, -2.6), "θ(t) = −2 am(1.30856 t − 0.150329 | 0.583999)"),
        (PENDULUMS["separatrix"], "θ(t) = 2 arctan(sinh(t))"),
        (PENDULUMS["free"], "θ(t) = −0.25 t + 1"),
        (PENDULUMS["rest"], "θ(t) = 0"),
        (PENDULUMS["hanging"], "θ(t) = π + 2 arcsin(0.315322 sn(2 t − 1.61219 | 0.0994282))"),
    ],
)
def test_forms_by_regime(pendulum, form):
    assert closed_form(pendulum) == form


@pytest.mark.parametrize("name", PENDULUMS)
def test_the_drawing_shows_the_start(name):
    pendulum = PENDULUMS[name]
    drawing = re.search(r"<svg.*?</svg>", pendulum._repr_html_(), re.DOTALL)[0]
    tree = ElementTree.fromstring(drawing)
    bob, pivot = [each for each in tree.iter() if each.get("fill") == "currentColor"]
    angle = pendulum.theta0 - (math.pi if pendulum.omega2 < 0 else 0.0)
    x = float(bob.get("cx")) - float(pivot.get("cx"))
    y = float(bob.get("cy")) - float(pivot.get("cy"))
    assert (x, y) == pytest.approx((56 * math.sin(angle), 56 * math.cos(angle)), abs=0.006)
    colours = {each.get(field) for each in tree.iter() for field in ("fill", "stroke") if each.get(field)}
    assert colours == {"none", "currentColor"}
    left, top, width, height = map(float, tree.get("viewBox").split())
    assert left + 8 <= float(bob.get("cx")) <= left + width - 8
    assert top + 8 <= float(bob.get("cy")) <= top + height - 8


def test_a_motion_beyond_the_doubles_has_no_form():
    pendulum = Pendulum(0.0, 1e200)
    assert closed_form(pendulum) is None
    assert "θ(t)" not in pendulum._repr_html_()


@pytest.mark.parametrize("given", [{"omega0": 1e-300}, {"omega0": 1e150}, {"omega2": 5e-324}, {"omega0": 1e300}])
@pytest.mark.parametrize("state", [(1.0, 0.0), (0.0, 1e-300), (5e-324, 0.0), (1e300, 1.0), (-0.0, 0.0)])
def test_every_pendulum_is_shown(given, state):
    shown = Pendulum(*state, **given)._repr_html_()
    assert shown.count("<svg") == 1
    assert "nan" not in shown
    assert "inf" not in shown.replace("infinite", "")


def test_a_turn_that_takes_longer_than_any_double():
    assert "one turn takes more than 1.8×10³⁰⁸ s" in Pendulum(1.0, 1e-310, omega0=0.0)._repr_html_()


def test_a_card_needs_no_matplotlib(tmp_path):
    code = """if True:
        import sys
        sys.modules["matplotlib"] = None
        from libration import Pendulum
        assert Pendulum(3.0)._repr_html_().startswith("<div")
    """
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True)


SPRINGS = [
    Duffing(1.4, p=1.0, q=1.0),
    Duffing(1.4, p=-1.0, q=1.0),
    Duffing(1.8, p=1.0, q=-0.5),
    Duffing(0.0, 1.4, p=1.0, q=-0.5),
    Duffing(0.0, p=1.0, q=1.0),
    Duffing(0.0, 1.0, p=0.0, q=0.0),
    Duffing(0.0, 1.0, p=-1.0, q=0.0),
    Duffing(1e-200, p=1.0, q=1.0),
    Duffing(1e100, p=1.0, q=1.0),
    CubicQuintic(1.0, p=1.0, q=-3.0, s=1.0),
    CubicQuintic(0.5, 0.1, p=-1.0, q=3.0, s=-1.0),
]


@pytest.mark.parametrize("spring", SPRINGS, ids=repr)
def test_the_potential_of_a_spring_is_drawn(spring):
    shown = spring._repr_html_()
    tree = ElementTree.fromstring(re.search(r"<svg.*?</svg>", shown, re.DOTALL)[0])
    curve, energy, ball = list(tree)
    numbers = [float(each) for each in re.findall(r"-?[\d.]+", curve.get("d"))]
    left, top, width, height = map(float, tree.get("viewBox").split())
    assert all(left <= x <= left + width for x in numbers[::2])
    assert all(top <= y <= top + height for y in numbers[1::2])
    # The start is on the potential, and the energy is not below it.
    x, y = float(ball.get("cx")), float(ball.get("cy")) + 6
    assert abs(np.interp(x, numbers[::2], numbers[1::2]) - y) < 3
    level = float(re.match(r"M[\d.-]+ ([\d.]+)", energy.get("d"))[1])
    assert level <= y + 0.11
    if spring.velocity0 == 0:
        assert level == pytest.approx(y, abs=0.11)
    assert str(spring.regime) in shown
    assert "nan" not in shown
    assert "inf" not in shown.replace("infinity", "")


def test_what_is_said_of_a_spring():
    lines = re.sub(r"<[^>]*>+", "\n", Duffing(1.8, p=1.0, q=-0.5)._repr_html_()).split("\n")
    assert [line for line in lines if line] == [
        "Duffing oscillator: escape",
        "u″ + p u + q u³ = 0",
        "p = 1, q = −0.5",
        "u(0) = 1.8, u′(0) = 0",
        "escapes to infinity at t = 1.86387 s",
        "came from infinity at t = −1.86387 s",
    ]
    well = CubicQuintic(1.0, p=1.0, q=-3.0, s=1.0)._repr_html_()
    assert "p = 1, q = −3, s = 1" in well
    assert "period 2.7368 s, u from 1 to 1.90721" in well
