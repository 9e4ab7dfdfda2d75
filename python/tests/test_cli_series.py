"""A series of the user, and schemes under their other names, in `libration compare`."""

import csv
import json
import math

import numpy as np
import pytest
from matplotlib.figure import Figure

from libration import Pendulum, approx
from libration.cli import main
from libration.cli.series import series
from libration.plot._comparison import draw_comparison

PENDULUM = Pendulum(math.radians(60), length=0.5)
WORDS = ["compare", "--theta0", "60deg", "--length", "50cm"]
T = np.arange(90) / 30
# Too high by 0.02 rad at the 20th instant, and by less elsewhere.
OFF = 0.01 * np.sin(T) + 0.02 * (np.arange(90) == 20)


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    """Work in an empty directory."""
    monkeypatch.chdir(tmp_path)


def write(name="data.csv", header="t,theta", row="{},{}", factor=1.0):
    """A series beside the exact motion."""
    angles = (PENDULUM.theta(T) + OFF) * factor
    with open(name, "w", encoding="utf-8") as file:
        print(
            header,
            *(row.format(t, angle) for t, angle in zip(T.tolist(), angles.tolist(), strict=True)),
            sep="\n",
            file=file,
        )


def largest(capsys, *names):
    """The errors over one period and over a hundred, by name."""
    assert main([*WORDS, "--with", ",".join(names), "--json"]) == 0
    errors = json.loads(capsys.readouterr().out)["errors"]
    return {(each["name"], each["periods"]): each for each in errors}


@pytest.mark.parametrize(
    ("header", "row", "factor"),
    [
        ("t,theta", "{},{}", 1.0),
        ("theta [deg],t [ms]", None, 180 / math.pi),
        ("time (s);angle (°)", "{};{}", 180 / math.pi),
        ("x\ttheta_deg\tt", "7\t{1}\t{0}", 180 / math.pi),
        ("# measured\n0,0", "{},{}", 1.0),
    ],
)
def test_its_largest_difference(capsys, header, row, factor):
    if row is None:
        angles = (PENDULUM.theta(T) + OFF) * factor
        with open("data.csv", "w") as file:
            print(
                header,
                *(f"{angle!r},{1000 * t!r}" for t, angle in zip(T.tolist(), angles.tolist(), strict=True)),
                sep="\n",
                file=file,
            )
    elif header.startswith("#"):
        # Without a header: the first column is t, the second theta.
        write("data.csv", "# measured", row, factor)
    else:
        write("data.csv", header, row, factor)
    found = largest(capsys, "data.csv")["data.csv", 1.0]
    assert found["t_s"] == pytest.approx(T[20], abs=1e-12)
    assert found["largest_error_rad"] == pytest.approx(OFF[20], abs=1e-12)
    assert found["largest_error_percent"] == pytest.approx(100 * OFF[20] / math.radians(60), rel=1e-9)


def test_it_is_drawn_as_dots_at_its_own_instants():
    write()
    measured, linear = series("data.csv", PENDULUM), approx.angle("linear").of(PENDULUM)
    figure = Figure()
    draw_comparison(figure, PENDULUM, [("data.csv", measured), ("linear", linear)], 1.0)
    inside = PENDULUM.period >= T
    for axes, expected in zip(figure.axes, (PENDULUM.theta(T) + OFF, 100 * OFF / math.radians(60)), strict=True):
        line = next(each for each in axes.lines if each.get_label() == "data.csv")
        assert (line.get_linestyle(), line.get_marker()) == ("None", "o")
        assert np.allclose(line.get_xdata(), (T / PENDULUM.period)[inside], rtol=1e-15)
        assert np.allclose(line.get_ydata(), expected[inside], rtol=0, atol=1e-12)
    assert figure.axes[1].get_xlabel() == "t / T"


def test_degrees_without_a_unit_are_told(capsys):
    write(factor=180 / math.pi)
    assert main([*WORDS, "--with", "data.csv"]) == 0
    told = capsys.readouterr().err
    assert told.startswith("libration: --with = data.csv: angles up to 60")
    assert told.endswith("are taken as rad; for degrees the header says theta [deg]\n")
    write("named.csv", "t,theta [deg]", factor=180 / math.pi)
    assert main([*WORDS, "--with", "named.csv"]) == 0
    assert capsys.readouterr().err == ""


def test_two_files_with_one_name_and_a_file_of_another_kind(capsys, tmp_path):
    write()
    (tmp_path / "other").mkdir()
    write("other/data.csv")
    write("data")
    assert main([*WORDS, "--with", "data.csv,other/data.csv"]) == 2
    assert main([*WORDS, "--with", "data.csv,data.csv"]) == 2
    assert main([*WORDS, "--with", "data"]) == 2
    two, twice, other = capsys.readouterr().err.splitlines()
    assert two.endswith("has two files with the name data.csv")
    assert twice.endswith("names data.csv twice")
    assert other.endswith("--with = data: a file with a series must end in .csv, .txt, .tsv, .dat")


def test_decimal_commas_and_the_end(capsys):
    write("data.csv", "t;theta", "{};{}")
    with open("data.csv") as file:
        text = file.read().replace(".", ",")
    with open("data.csv", "w") as file:
        file.write(text)
    found = largest(capsys, "data.csv", "linear")
    assert found["data.csv", 1.0]["largest_error_rad"] == pytest.approx(OFF[20], abs=1e-12)
    assert found["data.csv", 100.0]["undefined_from_s"] == T[-1]
    assert main([*WORDS, "--with", "data.csv"]) == 0
    assert f"ends at t/T = {T[-1] / PENDULUM.period:.5g}" in capsys.readouterr().out


def test_it_is_drawn_and_written():
    write()
    assert main([*WORDS, "--with", "linear,data.csv", "--out", "a.csv", "--plot", "a.png", "--periods", "3"]) == 0
    with open("a.csv", newline="") as file:
        header, *rows = csv.reader(line for line in file if not line.startswith("#"))
    assert header[2:] == ["theta_linear [rad]", "theta_data.csv [rad]"]
    values = np.array([[float(cell) for cell in row] for row in rows])
    # Between its instants it follows the exact angle, and behind its end there is none.
    assert np.nanmax(np.abs(values[:, 3] - values[:, 1])) <= OFF[20]
    assert np.array_equal(np.isnan(values[:, 3]), values[:, 0] > T[-1])


def test_the_difference_at_its_instants_is_that_of_the_file():
    write()
    made = series("data.csv", PENDULUM)
    assert np.abs(made.difference(T) - OFF).max() < 1e-15
    assert np.abs(made.theta(T) - made.given).max() < 1e-15


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (None, "cannot be read: No such file or directory"),
        ("", "is empty"),
        ("t,theta\n", "holds no instants: no row follows the header"),
        ("t\n1\n2\n", "has 1 column, and the angles are in a second"),
        ("t,theta [m]\n0,1\n", "column 'theta [m]' is in 'm'; angles take rad, deg, turn"),
        ("t,theta\n0,1\n0,2\n", "instants must rise, and 0 s follows 0 s"),
        ("t,theta\n0,x\n", "line 2 'x' is not a number"),
        ("t,theta\n0,nan\n", "line 2 'nan' is not finite"),
    ],
)
def test_refusals(capsys, content, said):
    if content is not None:
        with open("data.csv", "w") as file:
            file.write(content)
    assert main([*WORDS, "--with", "data.csv"]) == 2
    line = capsys.readouterr().err
    assert line.startswith(f"libration compare: --with = data.csv: {said}") and line.count("\n") == 1


def test_the_series_is_not_overwritten(capsys):
    write()
    assert main([*WORDS, "--with", "linear,data.csv", "--out", "./data.csv"]) == 2
    assert "--out = ./data.csv: is the file read" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("other", "name"),
    [
        ("leapfrog:0.01", "verlet:0.01"),
        ("stormer-verlet:0.02", "verlet:0.02"),
        ("symplectic-euler:0.01", "euler-cromer:0.01"),
    ],
)
def test_other_names_of_symplectic_schemes(capsys, other, name):
    error = approx.numerical(name).of(PENDULUM).error(1)
    assert largest(capsys, other)[name, 1.0]["largest_error_rad"] == pytest.approx(error.difference, rel=1e-9)
    assert main([*WORDS, "--with", f"{other},{name}"]) == 2
    assert f"names {name} twice" in capsys.readouterr().err


def test_verlet_keeps_its_energy_and_rk4_does_not():
    pendulum = Pendulum(3.0)
    t = np.linspace(0, 2000, 40001)
    swing = {name: np.abs(approx.numerical(name).of(pendulum).theta(t)) for name in ("verlet:0.05", "rk4:0.3")}
    # The largest angle of the last hundred seconds is that of the first for Verlet, and has shrunk for Runge-Kutta.
    assert swing["verlet:0.05"][-2000:].max() == pytest.approx(swing["verlet:0.05"][:2000].max(), abs=1e-3)
    assert swing["rk4:0.3"][-2000:].max() < 2.9
