"""`libration ensemble`: what is refused, in one line and before anything is written; and what a dry run says."""

import json

import pytest
import zarr

from libration.cli import ensemble, main
from libration.ensemble import _store
from libration.ensemble._specification import specification

STATES = '[states]\ndistribution = "gaussian"\nn = 100\nseed = 1\nsigma_theta = 0.8\n'
TIME = "[time]\nt = [0.0, 1.0]\n"
GRID = "[states]\ntheta0 = [1.0, 2.0]\n"
SPEC = STATES + TIME


@pytest.fixture
def said(capsys, tmp_path, monkeypatch):
    """Run in a folder with bunch.toml; return the one line of the refusal, after which nothing is there that was not."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bunch.toml").write_text(SPEC)

    def run(*words, spec=None, code=2):
        if spec is not None:
            (tmp_path / "bunch.toml").write_text(spec)
        before = everything(tmp_path)
        assert main(["ensemble", *words]) == code
        shown = capsys.readouterr()
        assert shown.out == "" and shown.err.endswith("\n") and len(shown.err.splitlines()) == 1
        assert everything(tmp_path) == before
        assert shown.err.startswith("libration ensemble: ")
        return shown.err.strip()[len("libration ensemble: ") :]

    return run


def everything(folder):
    return {str(each): each.read_bytes() if each.is_file() else None for each in folder.rglob("*")}


@pytest.mark.parametrize(
    ("spec", "line"),
    [
        ("a b", "is no TOML: Expected '=' after a key in a key/value pair (at line 1, column 3)"),
        (f"t = {'[' * 3000}{']' * 3000}", "is no SPEC: its lists are nested too deeply"),
        ("", "[states] is missing: must be there; see docs/ensembles.md"),
        (STATES, "[time] is missing: must be there; see docs/ensembles.md"),
        ("title = 3\n" + SPEC, "title = 3: must be a text"),
        ("states = 3\n" + TIME, "states = 3: must be a table, [states]"),
        ("seed = 3\n" + SPEC, "seed = 3: there is no such key; must be of title, states, time, output, reduce"),
        (SPEC + "[outptu]\n", "[outptu]: there is no such key; did you mean output?"),
        (SPEC + "[output]\nchunks = 3\n", "[output] chunks = 3: there is no such key; did you mean chunk?"),
        ("[states]\nn = 3\n" + TIME, "[states] is neither: must have distribution, a bunch, or theta0, a grid"),
        (STATES.replace("seed = 1", "") + TIME, "[states] seed is missing: must be a whole number"),
        (STATES.replace("seed = 1", "seed = -1") + TIME, "[states] seed = -1: must be from 0 to 2**64 - 1"),
        (STATES.replace("n = 100", "n = 0") + TIME, "[states] n = 0: must be positive"),
        (STATES.replace("n = 100", "n = 1e6") + TIME, "[states] n = 1000000.0: must be a whole number"),
        (STATES.replace("gauss", "g") + TIME, "[states] distribution = 'gian': must be one of gaussian, waterbag,"),
        (STATES.replace("0.8", "1.8") + TIME, "[states] sigma_theta = 1.8: must be positive and below 1.367335"),
        (STATES.replace("0.8", "true") + TIME, "[states] sigma_theta = True: must be one real number"),
        (STATES + "omega0 = 0.0\n" + TIME, "[states] omega0 = 0.0: must be positive and finite"),
        (STATES + "matched = 1\n" + TIME, "[states] matched = 1: must be True or False"),
        (STATES + "theta0 = 1\n" + TIME, "[states] theta0 = 1: there is no such key; must be of distribution, n"),
        (GRID + "velocity = 1\n" + TIME, "[states] velocity = 1: there is no such key; did you mean velocity0?"),
        (GRID + "omega0 = [1, 0]\n" + TIME, "[states] omega0 = 0.0: must be positive"),
        (GRID + "velocity0 = []\n" + TIME, "[states] velocity0 = []: must have a number"),
        (GRID + "velocity0 = ['a']\n" + TIME, "[states] velocity0 = 'a': must be one real number"),
        (GRID + "velocity0 = inf\n" + TIME, "[states] velocity0 = inf: must be finite"),
        (GRID + "velocity0 = {from = 1}\n" + TIME, "[states] velocity0 to is missing: must have from, to and count"),
        (GRID + "velocity0 = {from = 1, to = 2, step = 3}\n" + TIME, "[states] velocity0 step = 3: there is no such"),
        (
            GRID + "velocity0 = {from = 1, to = 2, count = 0}\n" + TIME,
            "[states] velocity0 count = 0: must be from 1 to",
        ),
        (
            GRID + "velocity0 = {from = -1e308, to = 1e308, count = 2}\n" + TIME,
            "[states] velocity0 = {'from': -1e+308,",
        ),
        (GRID + "omega0 = [1, 2]\n" + TIME + "[reduce]\n", "[states] omega0: must be one number beside [reduce]"),
        (STATES + "[time]\nt = nan\n", "[time] t = nan: must be finite"),
        (STATES + "[time]\nt = 2026-01-01\n", "[time] t = datetime.date(2026, 1, 1): must be one real number"),
        (STATES + "[time]\nt = 1\ncount = 2\n", "[time] t = 1: must be alone, or be left out beside from, to and"),
        (STATES + "[time]\nt = {from = 0}\n", "[time] t = {'from': 0}: must be numbers"),
        (STATES + "[time]\nfrom = 0\nto = 1\n", "[time] count is missing: must have from, to and count"),
        (SPEC + "[output]\nvariables = ['x']\n", "[output] variables = ['x']: must be a list of theta, velocity,"),
        (
            SPEC + "[output]\nvariables = ['theta', 'theta']\n",
            "[output] variables = ['theta', 'theta']: must be a list",
        ),
        (SPEC + "[output]\nvariables = []\n", "[output] variables = []: must have one, where there is no [reduce]"),
        (SPEC + "[output]\nchunk = 0\n", "[output] chunk = 0: must be from 1 to 2**31 particles"),
        (SPEC + "[reduce]\nmoments = 3\n", "[reduce] moments = 3: must be 0, 1 or 2"),
        (SPEC + "[reduce]\nhistogram = {x = [0, 1, 2]}\n", "[reduce] histogram has 'x': must be of theta, velocity,"),
        (SPEC + "[reduce]\nhistogram = {theta = [1, 0, 2]}\n", "[reduce] histogram of theta = [1, 0, 2]: must have"),
    ],
)
def test_a_bad_spec_is_one_line_and_nothing_is_written(said, spec, line):
    assert said("bunch.toml", "--out", "run.zarr", spec=spec).startswith(f"bunch.toml: {line}")
    assert said("bunch.toml", "--dry-run", spec=spec).startswith(f"bunch.toml: {line}")


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ([], "missing SPEC.toml: what the ensemble is, such as bunch.toml; see libration ensemble --help"),
        (["none.toml", "--dry-run"], "none.toml: cannot be read: No such file or directory"),
        ([".", "--dry-run"], ".: cannot be read: Is a directory"),
        (["bunch.toml"], "missing --out, such as --out run.zarr; --dry-run works without"),
        (["bunch.toml", "--out", "run"], "--out = run: must end in .zarr"),
        (["bunch.toml", "--out", "none/run.zarr"], "--out = none/run.zarr: cannot be written: there is no directory"),
        (["bunch.toml", "--out", "bunch.toml/run.zarr"], "--out = bunch.toml/run.zarr: cannot be written: there is no"),
        (["bunch.toml", "--out", "a.zarr", "--workers", "0"], "--workers = 0: must be a whole number from 1 to 4096"),
        (
            ["bunch.toml", "--out", "a.zarr", "--workers", "2.5"],
            "--workers = 2.5: must be a whole number from 1 to 4096",
        ),
        (
            ["bunch.toml", "--out", "a.zarr", "--part", "0/3"],
            "--part = 0/3: must be K/N, whole numbers with K from 1 to N",
        ),
        (["bunch.toml", "--out", "a.zarr", "--part", "4/3"], "--part = 4/3: must be K/N"),
        (["bunch.toml", "--out", "a.zarr", "--part", "1"], "--part = 1: must be K/N"),
        (["bunch.toml", "--out", "a.zarr", "--part", "1/2", "--workers", "2"], "--part and --workers: give one of the"),
        (["bunch.toml", "--out", "a.zarr", "--scheduler", "x", "--part", "1/2"], "--scheduler and --part: give one of"),
        (["bunch.toml", "--out", "a.zarr", "--scheduler", "x://y"], "--scheduler = x://y: no scheduler of Dask"),
        (["bunch.toml", "--resum"], "unknown option '--resum'; did you mean --resume?"),
    ],
)
def test_refused_words(said, words, line):
    assert said(*words).startswith(line)


def test_a_store_that_is_there_is_not_replaced(said, tmp_path, capsys):
    assert main(["ensemble", "bunch.toml", "--out", "run.zarr", "--part", "1/1"]) == 0
    capsys.readouterr()
    line = "--out = run.zarr: exists already; --resume goes on with it, or give another name"
    assert said("bunch.toml", "--out", "run.zarr") == line
    changed = SPEC.replace("seed = 1", "seed = 2")
    for words in (["--resume"], ["--part", "1/2"]):
        found = said("bunch.toml", "--out", "run.zarr", *words, spec=changed)
        assert found == "--out = run.zarr: was begun with another SPEC; give that one, or another name"
    # What the SPEC says counts, and not how.
    (tmp_path / "bunch.toml").write_text("# as before\n" + SPEC.replace("0.8", "0.80"))
    assert main(["ensemble", "bunch.toml", "--out", "run.zarr", "--resume", "--workers", "1"]) == 0
    capsys.readouterr()
    root = zarr.open_group("run.zarr", mode="r+")
    root.attrs["libration_version"] = "0.0.1"
    found = said("bunch.toml", "--out", "run.zarr", "--resume")
    assert found.startswith("--out = run.zarr: was begun by libration 0.0.1, and this is ")


def test_a_foreign_folder_stays_as_it_is(said, tmp_path):
    line = "--out = run.zarr: is no store of libration ensemble, and stays as it is; give another name"
    for kind in ("folder", "group", "array", "file"):
        path = tmp_path / "run.zarr"
        if kind == "file":
            path.write_text("mine")
        elif kind == "folder":
            path.mkdir()
            (path / "mine.partial").write_text("mine")
        elif kind == "group":
            zarr.create_group(path)
        else:
            zarr.create_array(path, shape=(3,), dtype="f8")
        for words in (["--resume"], ["--part", "1/2", "--resume"]):
            assert said("bunch.toml", "--out", "run.zarr", *words) == line, kind
        assert "exists already" in said("bunch.toml", "--out", "run.zarr")
        path.rename(tmp_path / kind)


def test_no_room_and_no_memory_are_refused_before(said, monkeypatch):
    large = SPEC.replace("n = 100", "n = 1_000_000_000_000_000")
    assert said("bunch.toml", "--out", "run.zarr", spec=large).startswith("--out = run.zarr: needs 32 PB, and ")
    monkeypatch.setattr(ensemble, "available_bytes", lambda: 1e6)
    line = said("bunch.toml", "--out", "run.zarr", spec=SPEC)
    assert line.endswith("and 1 MB are available; give a smaller [output] chunk or fewer --workers")


def test_what_is_missing_is_named(said, monkeypatch):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert said("bunch.toml", "--out", "run.zarr") == "needs zarr: pip install 'libration[ensemble]'"


def test_a_dry_run_says_what_it_takes_and_writes_nothing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bunch.toml").write_text(SPEC.replace("n = 100", "n = 10_000_000"))
    before = everything(tmp_path)
    assert main(["ensemble", "bunch.toml", "--dry-run", "--workers", "3", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["samples"], found["particles"], found["times"]) == (20_000_000, 10_000_000, 2)
    assert (found["chunk_particles"], found["chunks"], found["workers"]) == (262_144, 39, 3)
    assert found["bytes"] == 39 * 262_144 * 2 * 2 * 8 + 39
    assert found["seconds"] == pytest.approx(20_000_000 * found["seconds_per_sample"] / 3)
    assert found["memory_bytes"] > 3 * found["chunk_memory_bytes"] > 0
    rows = [(each["samples"], each["workers"]) for each in found["outlook"]]
    assert rows == [(samples, workers) for samples in (10**9, 10**12) for workers in (3, 100, 10_000)]
    for each in found["outlook"]:
        assert each["seconds"] == pytest.approx(each["samples"] * found["seconds_per_sample"] / each["workers"])
    assert main(["ensemble", "bunch.toml", "--dry-run", "--out", "run.zarr", "--part", "2/50"]) == 0
    shown = capsys.readouterr().out
    assert "samples  20000000: 10000000 particles at 2 times" in shown and "on 50 workers" in shown
    assert "part 2 of 50, in this process" in shown and "1e12" in shown and "PB" not in shown
    assert everything(tmp_path) == before


def test_memory_is_said_before_the_work(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bunch.toml").write_text(SPEC)

    def written(*_):
        shown = capsys.readouterr().out
        assert "memory   up to 70 MB here" in shown and "a chunk at work" in shown
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("libration.ensemble._workers.written", written)
    assert main(["ensemble", "bunch.toml", "--out", "run.zarr", "--part", "1/1"]) == 2
    assert "0 of 1 chunks are done, and --resume goes on" in capsys.readouterr().err


def test_the_same_spec_has_the_same_text():
    one = specification(SPEC)
    other = specification("title = 'ensemble of pendulums'\n" + TIME + STATES + "omega0 = 1\n[output]\nchunk = 5000\n")
    assert one.canonical == other.canonical and one.digest == other.digest
    assert one.digest != specification(SPEC.replace("0.8", "0.81")).digest
    orders = ["theta = [0, 1, 2], velocity = [0, 1, 2]", "velocity = [0, 1, 2], theta = [0, 1, 2]"]
    found = [specification(f"{SPEC}[reduce]\nhistogram = {{ {each} }}\n").digest for each in orders]
    # The order of the quantities is that of the dimensions.
    assert found[0] != found[1]


def test_a_store_that_could_not_be_made_leaves_nothing(tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(_store, "_arrays", full)
    with pytest.raises(OSError, match="No space"):
        _store.created(str(tmp_path / "run.zarr"), specification(SPEC), "0")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("seconds", "text"),
    [
        (0.014, "0.014 s"),
        (3.21, "3.2 s"),
        (99.7, "100 s"),
        (119, "119 s"),
        (300, "5 min"),
        (9e3, "2.5 h"),
        (1e7, "116 days"),
    ],
)
def test_durations(seconds, text):
    assert ensemble.duration(seconds) == text
