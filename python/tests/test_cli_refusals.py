"""Bad input: one line that names the option, its value and what is allowed; exit code 2; nothing left behind."""

import os
import subprocess
import sys

import pytest

from libration import Pendulum
from libration.cli import main
from libration.cli.top import COMMANDS

EVERY = ", ".join(COMMANDS)
SOLVE = ["solve", "--theta0", "3", "--length", "1m"]


@pytest.fixture
def said(capsys, tmp_path, monkeypatch):
    """Run in an empty directory where the motion must not be evaluated; return the line."""

    def evaluated(*_):
        pytest.fail("evaluated before the input was checked")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(Pendulum, "motion", evaluated)
    before = set()

    def run(*words):
        before.update(os.listdir())
        assert main(list(words)) == 2
        shown = capsys.readouterr()
        assert shown.out == ""
        assert shown.err.endswith("\n")
        assert len(shown.err.splitlines()) == 1
        assert "Traceback" not in shown.err
        assert set(os.listdir()) == before
        return shown.err.strip()

    return run


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ([], f"libration: missing command: one of {EVERY}; see libration --help"),
        (
            ["solv"],
            f"libration: unknown command 'solv': commands are {EVERY}; did you mean solve?",
        ),
        (
            [""],
            f"libration: unknown command '': commands are {EVERY}; see libration --help",
        ),
        ([*SOLVE, " "], "libration solve: unknown word ' '; see libration solve --help"),
        (["--theta0", "3"], "option '--theta0' stands after a command, one of solve, at, period, compare; see"),
        (["-x"], "libration: unknown option '-x'; see libration --help"),
        (["help"], "did you mean --help?"),
        (["VERSION"], "did you mean --version?"),
        (["Period"], "did you mean period?"),
        (["period", "--angle", "1"], "libration period: unknown option '--angle'; did you mean --theta0?"),
        (["period", "--l", "1"], "unknown option '--l'; did you mean --length?"),
        (["period", "-g", "1"], "unknown option '-g'; did you mean --gravity?"),
        (["period", "--THETA0", "1"], "did you mean --theta0?"),
        (["period", "--t", "1"], "did you mean --theta0 or --turning-angle or --title?"),
        (["solve", "-o", "a.csv"], "did you mean --out?"),
        (["duffing", "--alpha", "1"], "did you mean --p?"),
        (["duffing", "--x0", "1"], "did you mean --u0?"),
        (["duffing", "--p", "1", "--q", "1", "--u0", "1,5"], "or be decimal; write '1;5' or 1.5"),
        (["cubic-quintic", "--alpha", "1"], "did you mean --p?"),
        (["period", "--", "--theta0", "1"], "unknown option '--theta0'; options stand before --"),
        (["period", "150"], "unknown word '150'; a value follows its option, and several are joined by commas"),
        (["period", "--theta0", "'150", "deg'"], "unknown word 'deg''; this shell takes double quotes, "),
        (["period", "--theta0", "150", "deg"], "unknown word 'deg'; a unit stands with its number, as in 150deg; see"),
        (["--versio"], "libration: unknown option '--versio'; did you mean --version?"),
        (["solve"], "libration solve: missing --theta0, the initial angle, such as --theta0 170deg"),
        (["period"], "libration period: missing --theta0, the initial angle, such as --theta0 170deg"),
        (["solve", "--theta", "3"], "libration solve: unknown option '--theta'; did you mean --theta0?"),
        ([*SOLVE, "--lenght", "3"], "libration solve: unknown option '--lenght'; did you mean --length?"),
        ([*SOLVE, "--zzz"], "libration solve: unknown option '--zzz'; see libration solve --help"),
        ([*SOLVE, "extra"], "libration solve: unknown word 'extra'; see libration solve --help"),
        (
            ["period", "--theta0"],
            "libration period: --theta0: needs a value, --theta0 ANGLE; see libration period --help",
        ),
        ([*SOLVE, "--json=3"], "libration solve: --json: takes no value"),
        ([*SOLVE, "--theta0", "4"], "libration solve: --theta0 = 3 and --theta0 = 4: give it once"),
        ([*SOLVE, "--omega0", "2"], "libration solve: --length = 1m and --omega0 = 2: give one of the two"),
        (
            ["solve", "--theta0", "3"],
            "libration solve: missing --length or --omega0, such as --length 1m; `libration period` works without",
        ),
        (
            ["period", "--theta0", "3", "--gravity", "9.8"],
            "libration period: --gravity = 9.8: needs --length beside it; omega0 is sqrt(gravity / length)",
        ),
        (
            ["solve", "--theta0", "3", "--omega0", "1", "--gravity", "9.8"],
            "libration solve: --gravity = 9.8: needs --length beside it; omega0 is sqrt(gravity / length)",
        ),
        (["period", "--theta0", "nan"], "libration period: --theta0 = nan: must be a finite number"),
        (["period", "--theta0", "-inf"], "libration period: --theta0 = -inf: must be a finite number"),
        (["period", "--theta0", "170 grad"], "unknown unit 'grad'; angles take rad, deg, turn"),
        (
            ["period", "--theta0", "1", "--velocity0", "2rad/s"],
            "--velocity0 = 2rad/s: has a unit, but no frequency is given",
        ),
        (["period", "--theta0", "1", "--omega0", "0"], "--omega0 = 0: must be greater than 0"),
        (["period", "--theta0", "1", "--omega0", "-2"], "--omega0 = -2: must be greater than 0"),
        (["period", "--theta0", "1", "--length", "0"], "--length = 0: must be greater than 0"),
        (["period", "--theta0", "1", "--length", "-1m"], "--length = -1m: must be greater than 0"),
        (["period", "--theta0", "1", "--length", "nan"], "--length = nan: must be a finite number"),
        (["period", "--theta0", "1", "--length", "inf"], "--length = inf: must be a finite number"),
        (["period", "--theta0", "1", "--length", "12 parsecs"], "unknown unit 'parsecs'"),
        (["period", "--theta0", "1", "--length", "1", "--gravity", "0"], "--gravity = 0: must be greater than 0"),
        (["period", "--theta0", "1\n2", "--length", "1"], r"--theta0 = 1\n2: "),
        ([*SOLVE, "--until", "0"], "--until = 0: must be greater than 0"),
        ([*SOLVE, "--until", "-5s"], "--until = -5s: must be greater than 0"),
        ([*SOLVE, "--until", "nan"], "--until = nan: must be a finite number"),
        ([*SOLVE, "--until", "3 m"], "--until = 3 m: unknown unit 'm'; times take s, ms, min, h"),
        ([*SOLVE, "--samples", "0"], "--samples = 0: must be 1 or greater"),
        ([*SOLVE, "--samples", "-3"], "--samples = -3: must be 1 or greater"),
        ([*SOLVE, "--samples", "2.5"], "--samples = 2.5: must be a whole number, 1 or greater"),
        ([*SOLVE, "--samples", "many"], "--samples = many: must be a whole number, 1 or greater"),
        ([*SOLVE, "--samples", "\uff15"], "must be a whole number, 1 or greater"),
        ([*SOLVE, "--samples", "nan"], "--samples = nan: must be a whole number, 1 or greater"),
        ([*SOLVE, "--samples", "1e999999999"], "--samples = 1e999999999: must be a whole number"),
        ([*SOLVE, "--samples", "1e12"], "--samples = 1e12: would take 64 TB of memory, and "),
        ([*SOLVE, "--samples", "1e30"], "of memory, and "),
        ([*SOLVE, "--column", "t"], "--column = t: needs --times FILE beside it"),
        ([*SOLVE, "--times", "t.csv", "--until", "3"], "--until = 3: the instants are read from --times"),
        ([*SOLVE, "--times", "t.csv", "--samples", "3"], "--samples = 3: the instants are read from --times"),
        ([*SOLVE, "--times", "t.csv"], "--times = t.csv: cannot be read: No such file or directory"),
        ([*SOLVE, "--times", "."], "--times = .: cannot be read: it is a directory"),
        ([*SOLVE, "--times", "a\0b"], "--times = "),
        ([*SOLVE, "--out", "a.txt"], "--out = a.txt: must end in .csv, .npz or .json"),
        ([*SOLVE, "--out", "csv"], "--out = csv: must end in .csv, .npz or .json"),
        ([*SOLVE, "--out", ""], "--out = '': must end in .csv, .npz or .json"),
        ([*SOLVE, "--plot", "a.pdf"], "--plot = a.pdf: must end in .png or .svg"),
        ([*SOLVE, "--out", "a/b/c.csv"], "--out = a/b/c.csv: cannot be written: there is no directory "),
        ([*SOLVE, "--out", "/proc/a.csv"], "--out = /proc/a.csv: cannot be written: "),
        ([*SOLVE, "--out", "new/a.csv", "--plot", "/proc/a.png"], "--plot = /proc/a.png: cannot be written: "),
        ([*SOLVE, "--out", "a\0.csv"], "--out = "),
        ([*SOLVE, "--out", "x" * 300 + ".csv"], "cannot be written: File name too long"),
    ],
)
def test_words(said, words, line):
    assert line in said(*words)


def test_files_of_every_bad_kind(said):
    contents = {
        "empty.csv": (b"", "is empty"),
        "binary.csv": (bytes(range(256)), "is not text: byte 0 is 0x00"),
        "header.csv": (b"t,x\n", "no row follows the header"),
        "ragged.csv": (b"t,x\n1,2\n3\n", "line 3 has 1 cells, and the first row has 2"),
        "words.csv": (b"t\n1\nx\n", "line 3 'x' is not a number"),
    }
    for name, (content, expected) in contents.items():
        with open(name, "wb") as file:
            file.write(content)
        assert expected in said(*SOLVE, "--times", name, "--out", "a.csv", "--plot", "new/a.png")


def test_a_gigabyte_is_refused_by_its_size(said, monkeypatch):
    with open("huge.csv", "wb") as file:
        file.truncate(2**30)
    monkeypatch.setattr("libration.cli.times.open", lambda *_: pytest.fail("opened"), raising=False)
    line = said(*SOLVE, "--times", "huge.csv")
    assert "has 1024 MiB, more than the 256 MiB that are read; in Python, Pendulum(...).theta(t)" in line


def test_too_long_a_file_of_unknown_size(said, monkeypatch):
    monkeypatch.setattr("libration.cli.times.LARGEST_FILE", 100)
    monkeypatch.setattr("libration.cli.times.readable", lambda *_: (0, False))
    with open("t.csv", "w") as file:
        file.write("1\n" * 51)
    assert "has more than the 100 bytes that are read; in Python" in said(*SOLVE, "--times", "t.csv")
    assert said(*SOLVE, "--torque-file", "t.csv").endswith("has more than the 100 bytes that are read")


def test_unknown_column_lists_what_there_is(said):
    with open("t.csv", "w") as file:
        file.write("t [s],theta\n1,2\n")
    line = said(*SOLVE, "--times", "t.csv", "--column", "time")
    assert line == "libration solve: --column = time: is no column of t.csv; it has 't [s]', 'theta'"


@pytest.mark.posix
def test_targets_that_are_not_files(said, monkeypatch):
    os.mkdir("d.csv")
    os.mkfifo("f.csv")
    with open("file", "w"), open("old.csv", "w"):
        pass
    assert "cannot be written: it is a directory" in said(*SOLVE, "--out", "d.csv")
    assert "cannot be written: it is not a regular file" in said(*SOLVE, "--out", "f.csv")
    assert "is not a directory" in said(*SOLVE, "--out", "file/a.csv")
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert "cannot be written: it is read-only" in said(*SOLVE, "--out", "old.csv")


@pytest.mark.posix
def test_one_file_under_two_names(said):
    for name in ("s1.csv", "s2.png"):
        os.symlink("picture", name)
    line = said(*SOLVE, "--out", "s1.csv", "--plot", "s2.png")
    assert line == "libration solve: --out = s1.csv and --plot = s2.png: are one file; give two"
    with open("picture", "w"):
        pass
    assert "are one file" in said(*SOLVE, "--out", "./s1.csv", "--plot", "s2.png")


@pytest.mark.posix
@pytest.mark.parametrize("loop", [("a.csv", "a.csv"), ("a.csv", "b.csv")])
def test_links_in_a_circle(said, loop):
    first, second = loop
    os.symlink(second, first)
    if second != first:
        os.symlink(first, second)
    assert "cannot be written: Too many levels of symbolic links" in said(*SOLVE, "--out", first)
    assert os.path.islink(first)
    os.symlink("circle", "circle")
    assert "cannot be written: " in said(*SOLVE, "--out", "circle/a.csv")


def test_the_input_is_not_overwritten(said):
    with open("t.csv", "w") as file:
        file.write("1\n")
    assert "--out = ./t.csv: is the file read; give another name" in said(
        *SOLVE, "--times", "t.csv", "--out", "./t.csv"
    )


def test_a_new_directory_goes_with_a_refusal(said):
    assert "--samples = 0" in said(*SOLVE, "--samples", "0", "--out", "new/a.csv")


def test_without_matplotlib(said, monkeypatch):
    for name in [each for each in sys.modules if each.partition(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    line = said(*SOLVE, "--plot", "a.png")
    assert line == "libration solve: --plot = a.png: needs matplotlib: pip install 'libration[plot]'"


def run_with(environment, folder):
    """Draw in a process of its own."""
    run = [sys.executable, "-m", "libration", *SOLVE, "--plot", "z.png"]
    return subprocess.run(run, env=os.environ | environment, cwd=folder, capture_output=True, text=True, timeout=600)


def test_a_backend_that_is_none(tmp_path):
    done = run_with({"MPLBACKEND": "foo"}, tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith("libration solve: --plot = z.png: matplotlib does not start: Key backend: 'foo' ")
    assert len(done.stderr.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


def test_settings_of_matplotlib_do_not_reach_the_picture(tmp_path):
    """LaTeX, which need not be there, and a figure without lines."""
    pictures = []
    for settings in ("", "text.usetex: True\nfigure.facecolor: black\nlines.marker: x\n"):
        (tmp_path / "matplotlibrc").write_text(settings)
        done = run_with({"MPLBACKEND": "Agg", "PATH": ""}, tmp_path)
        assert (done.returncode, done.stderr) == (0, "")
        pictures.append((tmp_path / "z.png").read_bytes())
    assert pictures[0] == pictures[1]


def test_a_refusal_of_pendulum_names_the_option(said, monkeypatch):
    def refuse(*_, **__):
        raise ValueError("length = 1.0: must be\nsomething else")

    monkeypatch.setattr("libration.Pendulum", refuse)
    assert said(*SOLVE) == "libration solve: --length = 1.0: must be something else"


def test_what_pendulum_refuses(said):
    line = said("period", "--theta0", "1", "--length", "1e-320", "--gravity", "1e300")
    assert "--length = " in line
    assert "with --gravity = 1e+300 gives an infinite omega0" in line
