"""The command `libration` as people run it: numbers, help, exit codes."""

import json
import math
import subprocess
import sys

import pytest

import libration
from libration.cli import main
from libration.cli.top import COMMANDS

HORSLEY = ["--theta0", "3", "--length", "1m", "--gravity", "9.8"]


@pytest.fixture
def answer(capsys):
    """Run with --json; return the one object, which must be strict JSON."""

    def run(*words):
        assert main([*words, "--json"]) == 0
        shown = capsys.readouterr()
        assert shown.err == ""
        return json.loads(shown.out, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))

    return run


def command(*words, **options):
    """Run `python -m libration` in a process of its own."""
    made = {"capture_output": True, "text": True, "timeout": 600} | options
    return subprocess.run([sys.executable, "-m", "libration", *words], **made)


def test_horsley_period_and_difference(answer):
    got = answer("solve", *HORSLEY, "--until", "10s", "--samples", "500")
    assert got["regime"] == "libration"
    assert got["period_s"] == pytest.approx(5.16069774997798, rel=3e-15)
    assert got["theta_max_rad"] == pytest.approx(3.0, rel=3e-16)
    assert got["energy_rad2_per_s2"] == pytest.approx(9.8 * (1 - math.cos(3.0)), rel=1e-15)
    assert got["energy_ratio"] + got["energy_ratio_c"] == pytest.approx(1.0, rel=1e-15)
    assert got["linear_difference_rad"] == pytest.approx(5.9858, abs=5e-5)
    assert got["linear_difference_t_s"] == pytest.approx(5.03, abs=0.011)
    assert got["samples"] == 500
    assert (got["length_m"], got["gravity_m_per_s2"]) == (1.0, 9.8)


def test_horsley_small_angle_period(answer):
    got = answer("period", "--theta0", "0.4", "--length", "1m", "--gravity", "9.8")
    assert got["period_s"] == pytest.approx(2.0273467577909, rel=1e-13)
    assert got["small_swing_period_s"] == pytest.approx(math.tau / math.sqrt(9.8), rel=1e-15)


def test_summary_for_people(capsys):
    assert main(["solve", *HORSLEY, "--samples", "500"]) == 0
    lines = dict(line.split("  ", 1) for line in capsys.readouterr().out.splitlines())
    texts = {label: text.strip() for label, text in lines.items()}
    assert texts["regime"] == "libration"
    assert texts["period"] == "5.16069774997798 s"
    assert texts["turning angle"] == "3 rad = 171.88734 deg"
    assert texts["largest difference from linear"] == "5.9858 rad, at t = 5.03006 s"
    assert float(texts["energy ratio"]) + float(texts["1 - energy ratio"]) == pytest.approx(1.0, rel=1e-14)
    assert texts["sampled"] == "500 instants, 0 s to 10 s"
    assert "per unit inertia" in texts["energy"]


def test_defaults_of_solve(answer):
    got = answer("solve", "--theta0", "1", "--length", "1")
    assert (got["samples"], got["first_t_s"], got["last_t_s"]) == (501, 0.0, 10.0)
    assert got["gravity_m_per_s2"] == 9.80665


def test_ratio_of_periods_without_a_frequency(answer):
    got = answer("period", "--theta0", "150deg")
    assert got["period_ratio"] == pytest.approx(1.762204, abs=5e-7)
    assert got["period_omega0_rad"] == pytest.approx(1.762204 * math.tau, abs=4e-6)
    assert "period_s" not in got


def test_period_in_the_other_regimes(answer):
    rest = answer("period", "--theta0", "0", "--omega0", "2")
    assert (rest["regime"], rest["period_s"]) == ("rest", math.pi)
    separatrix = answer("period", "--theta0", "0", "--velocity0", "2")
    assert (separatrix["regime"], separatrix["period_ratio"]) == ("separatrix", None)
    rotation = answer("period", "--theta0", "0", "--velocity0", "-1", "--omega0", "1e-3")
    assert rotation["regime"] == "rotation"
    assert rotation["theta_max_rad"] is None
    assert rotation["period_s"] == pytest.approx(math.tau, rel=1e-5)


def test_velocity_without_a_frequency_counts_in_omega0(answer):
    plain = answer("period", "--theta0", "1", "--velocity0", "0.5")
    scaled = answer("period", "--theta0", "1", "--velocity0", "2rad/s", "--omega0", "4")
    assert plain["period_ratio"] == pytest.approx(scaled["period_ratio"], rel=1e-15)
    assert plain["velocity0_per_omega0"] == 0.5


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--theta0", "0.3", "--length", "1"], "s"),
        (["--theta0", "0"], "T / T0         1"),
        (["--theta0", "0", "--velocity0", "2"], "infinite"),
        (["--theta0", "0", "--velocity0", "3"], "none, it turns over the top"),
    ],
)
def test_period_for_people(capsys, words, expected):
    assert main(["period", *words]) == 0
    assert expected in capsys.readouterr().out


def test_negative_quantities_are_values_not_options(answer):
    assert answer("solve", "--theta0", "-170deg", "--length", "1")["theta0_rad"] == pytest.approx(-math.radians(170))
    assert answer("period", "--theta0=-.5", "--omega0", "1")["theta0_rad"] == -0.5


@pytest.mark.parametrize("words", [["--help"], ["period", "-h"], *([name, "--help"] for name in COMMANDS)])
def test_help_has_an_example_and_fits_a_screen(capsys, words):
    assert main(words) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    examples = shown.out.partition("examples:\n")[2]
    assert "  libration " in examples
    assert max(len(line) for line in shown.out.splitlines()) <= 92


@pytest.mark.parametrize("words", [["--help"], *([name, "--help"] for name in COMMANDS)])
@pytest.mark.parametrize("columns", [40, 60, 80])
def test_help_wraps_on_a_narrow_screen(capsys, monkeypatch, words, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    assert main(words) == 0
    narrow = capsys.readouterr().out
    assert max(map(len, narrow.splitlines())) <= columns
    monkeypatch.setenv("COLUMNS", "100")
    assert main(words) == 0
    assert narrow.replace("\\\n", "").split() == capsys.readouterr().out.split()
    monkeypatch.setenv("COLUMNS", "1")
    assert main(words) == 0
    assert max(map(len, capsys.readouterr().out.splitlines())) <= 40


@pytest.mark.parametrize("columns", ["40", "80", "100"])
def test_every_example_of_the_help_runs(capsys, tmp_path, monkeypatch, columns):
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "instants.csv").write_text("t [s]\n0\n1\n2\n")
    (tmp_path / "data.csv").write_text("t [s],theta [deg]\n0,60\n0.1,54.9\n0.2,40.7\n")
    examples = []
    for words in (["--help"], *([name, "--help"] for name in ("solve", "at", "period", "compare"))):
        main(words)
        text = capsys.readouterr().out.partition("examples:\n")[2].replace("\\\n", "")
        examples += [line.split()[1:] for line in text.splitlines() if line.startswith("  libration ")]
    assert len(examples) == 24
    for words in examples:
        assert main(words) == 0, words


def test_version(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"libration {libration.__version__}\n"


@pytest.mark.parametrize("words", [["--help"], *([name, "--help"] for name in COMMANDS)])
def test_help_loads_nothing_that_takes_long(words):
    code = f"""if True:
        import sys
        from libration.cli import main
        main({words})
        sys.exit(", ".join({{"numpy", "matplotlib", "scipy", "pandas", "xarray", "dask"}} & set(sys.modules)) or 0)
    """
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_process_prints_and_exits_zero():
    done = command("period", "--theta0", "150deg")
    assert done.returncode == 0
    assert "1.76220372950376" in done.stdout
    assert done.stderr == ""


def test_process_refuses_in_one_line():
    done = command("solve", "--theta0", "3", "--length", "12 parsecs")
    assert done.returncode == 2
    assert done.stdout == ""
    said = "--length = 12 parsecs: unknown unit 'parsecs'; lengths take m, cm, mm, km, in, ft"
    assert done.stderr == f"libration solve: {said}\n"
