"""Tables that read back bit for bit, and files that are whole or not there."""

import json
import math
import os
import subprocess
import sys

import numpy as np
import pytest

from libration import Pendulum
from libration.cli import main
from libration.cli.files import staged, write_csv
from libration.cli.parser import Refusal
from libration.plot import linear_theta

HORSLEY = ["solve", "--theta0", "3", "--length", "1m", "--gravity", "9.8", "--samples", "500"]
COLUMNS = ["t [s]", "theta [rad]", "velocity [rad/s]", "theta_linear [rad]"]


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    """Work in an empty directory."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def names(folder="."):
    """The files of a folder, hidden ones too."""
    return sorted(os.listdir(folder))


def read_csv(path):
    """The `#` lines as a dictionary, the header, and the numbers."""
    with open(path) as file:
        lines = file.read().splitlines()
    comments = dict(line[2:].split(" = ", 1) for line in lines if line.startswith("# "))
    header, *rows = [line for line in lines if not line.startswith("#")]
    return comments, header.split(","), np.array([[float(cell) for cell in row.split(",")] for row in rows])


def expected():
    """The same motion without the command line."""
    pendulum = Pendulum(3.0, length=1.0, gravity=9.8)
    t = np.linspace(0.0, 10.0, 500)
    return pendulum, [t, *pendulum.motion(t), linear_theta(pendulum, t)]


def bit_equal(got, want):
    """Whether two arrays hold the same bits."""
    return np.array_equal(np.asarray(got, float).view(np.int64), np.asarray(want, float).view(np.int64))


def test_csv_reads_back_bit_equal():
    assert main([*HORSLEY, "--out", "motion.csv"]) == 0
    comments, header, numbers = read_csv("motion.csv")
    pendulum, columns = expected()
    assert header == COLUMNS
    for got, want in zip(numbers.T.copy(), columns, strict=True):
        assert [value.hex() for value in got.tolist()] == [value.hex() for value in want.tolist()]
    assert comments["theta0"] == "3.0 rad"
    assert comments["velocity0"] == "0.0 rad/s"
    assert comments["length"] == "1.0 m"
    assert comments["gravity"] == "9.8 m/s^2"
    assert comments["regime"] == "libration"
    for name in ("period", "omega0", "theta_max", "energy", "energy_ratio", "energy_ratio_c"):
        assert float(comments[name].split()[0]).hex() == float(getattr(pendulum, name)).hex()


def test_bit_equality_sees_a_last_digit():
    """The sibling: fifteen digits are not enough, and the comparison says so."""
    _, columns = expected()
    assert not bit_equal([float(f"{value:.15g}") for value in columns[1]], columns[1])


@pytest.mark.parametrize(("t", "theta"), [("1", 1.60445851956), ("2.5", -2.9955124465), ("5", 2.98176742475)])
def test_horsley_angles(t, theta):
    with open("t.csv", "w") as file:
        file.write(t)
    words = [*HORSLEY[:-2], "--times", "t.csv", "--out", "one.csv"]
    assert main(words) == 0
    assert read_csv("one.csv")[2][0, 1] == pytest.approx(theta, abs=1e-11)


def test_npz_and_json_hold_the_same():
    for name in ("motion.npz", "motion.json"):
        assert main([*HORSLEY, "--out", name]) == 0
    pendulum, columns = expected()
    with np.load("motion.npz", allow_pickle=False) as archive:
        for name, want in zip(("t", "theta", "velocity", "theta_linear"), columns, strict=True):
            assert bit_equal(archive[name], want)
        assert archive["period"] == pendulum.period
        assert str(archive["regime"]) == "libration"
    with open("motion.json") as file:
        table = json.load(file, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))
    keys = ("t_s", "theta_rad", "velocity_rad_per_s", "theta_linear_rad")
    for name, want in zip(keys, columns, strict=True):
        assert bit_equal(table[name], want)
    assert table["parameters"]["gravity_m_per_s2"] == 9.8
    assert table["parameters"]["period_s"] == pendulum.period


def test_infinite_period_in_a_table():
    for name in ("a.csv", "a.json"):
        assert main(["solve", "--theta0", "0", "--velocity0", "2", "--omega0", "1", "--out", name]) == 0
    assert read_csv("a.csv")[0]["period"] == "inf s"
    with open("a.json") as file:
        table = json.load(file)
    assert table["parameters"]["period_s"] is None
    assert table["parameters"]["regime"] == "separatrix"


def test_table_feeds_times_again():
    """What is written can be read: the column t of our own table."""
    assert main([*HORSLEY, "--out", "a.csv"]) == 0
    assert main([*HORSLEY[:-2], "--times", "a.csv", "--out", "b.csv"]) == 0
    with open("a.csv", "rb") as first, open("b.csv", "rb") as second:
        assert first.read() == second.read()


def test_a_file_that_exists_is_replaced_and_a_directory_made(capsys):
    assert main([*HORSLEY, "--out", "out/motion.csv", "--plot", "out/motion.svg"]) == 0
    assert main([*HORSLEY, "--out", "out/motion.csv"]) == 0
    assert names("out") == ["motion.csv", "motion.svg"]
    assert capsys.readouterr().out.splitlines()[-1].split() == ["written", "out/motion.csv"]


@pytest.mark.posix
def test_a_link_stays_a_link():
    os.symlink("real.csv", "link.csv")
    assert main([*HORSLEY, "--out", "link.csv"]) == 0
    assert os.path.islink("link.csv")
    assert names() == ["link.csv", "real.csv"]


def test_files_have_the_usual_permissions():
    assert main([*HORSLEY, "--out", "a.csv"]) == 0
    with open("plain", "w"):
        pass
    assert os.stat("a.csv").st_mode == os.stat("plain").st_mode


@pytest.mark.parametrize("error", [KeyboardInterrupt, MemoryError])
def test_nothing_stays_after_a_failure(monkeypatch, capsys, error):
    def fail(*_):
        raise error

    with open("old.csv", "w") as file:
        file.write("old")
    monkeypatch.setattr(Pendulum, "motion", fail)
    code = main([*HORSLEY, "--out", "old.csv", "--plot", "new/a.png"])
    assert code == (130 if error is KeyboardInterrupt else 2)
    assert names() == ["old.csv"]
    with open("old.csv") as file:
        assert file.read() == "old"
    assert len(capsys.readouterr().err.splitlines()) == (error is MemoryError)


def test_a_failed_plot_takes_the_table_with_it(monkeypatch):
    import libration.plot

    def fail(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(libration.plot, "plot_motion", fail)
    assert main([*HORSLEY, "--out", "a.csv", "--plot", "a.png"]) == 2
    assert names() == []


@pytest.mark.posix
@pytest.mark.parametrize("name", ["a.csv", "a.npz", "a.json", "deep/a.csv"])
def test_full_disk(name):
    code = """if True:
        import resource, sys
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        from libration.cli import main
        sys.exit(main(sys.argv[1:]))
    """
    run = [sys.executable, "-c", code, *HORSLEY, "--out", name]
    done = subprocess.run(run, capture_output=True, text=True, timeout=600)
    assert done.returncode == 2
    assert done.stderr == f"libration solve: --out = {name}: cannot be written: File too large\n"
    assert done.stdout == ""
    assert names() == []


def test_staged_removes_on_error_and_renames_on_success():
    with pytest.raises(ZeroDivisionError), staged("--out", "a.csv", (".csv", ".npz")):
        assert len(names()) == 1
        raise ZeroDivisionError
    assert names() == []
    with staged("--out", "a.csv", (".csv", ".npz")) as file:
        file.write(b"x")
        assert "a.csv" not in names()
    assert names() == ["a.csv"]


def test_staged_refuses_the_file_it_reads():
    with pytest.raises(Refusal, match="is the file read"), staged("--out", "./a.csv", (".csv", ".npz"), keep=["a.csv"]):
        pass


def test_a_million_rows():
    values = np.random.default_rng(0).standard_normal(10**6)
    columns = [(name, "s", values) for name in "abcd"]
    with open("big.csv", "wb") as file:
        write_csv(file, [("period", math.pi, "s")], columns)
    assert sum(1 for _ in open("big.csv")) == 10**6 + 2
