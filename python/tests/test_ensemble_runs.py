"""Runs of `libration ensemble`: the same bytes from any workers and parts, and after a kill at any moment.

A kill comes when so many chunks have their byte, which is looked for from outside, and never after a time.
"""

import contextlib
import json
import math
import os
import re
import signal
import sys
import time
import tracemalloc
from pathlib import Path

import numpy as np
import processes
import psutil
import pytest
import xarray
import zarr

import libration
from libration import ensemble
from libration.cli import main
from libration.ensemble import _store, _workers
from libration.ensemble._estimate import chunk_bytes
from libration.ensemble._specification import specification

SPEC = """
title = "a test"
[states]
distribution = "gaussian"
n = 119_500
seed = 3
sigma_theta = 0.8
omega0 = 2.0
[time]
t = [0.0, 5.0, 1e5]
[output]
variables = ["velocity", "theta", "action"]
chunk = 2000
[reduce]
histogram = { theta = [-3.2, 3.2, 16], action = [0.0, 3.0, 8] }
"""
CHUNKS = 60
COMMAND = [sys.executable, "-m", "libration", "ensemble"]
# A run that does not end by itself is a hang on any machine.
PATIENCE = 300


def content(folder):
    """Every file of a store with its bytes."""
    return {str(each.relative_to(folder)): each.read_bytes() for each in folder.rglob("*") if each.is_file()}


@pytest.fixture(scope="module")
def asked(tmp_path_factory):
    path = tmp_path_factory.mktemp("spec") / "bunch.toml"
    path.write_text(SPEC)
    return str(path)


@pytest.fixture(scope="module")
def straight(asked, tmp_path_factory):
    """The store of a run from the beginning to the end in this process."""
    out = tmp_path_factory.mktemp("straight") / "run.zarr"
    assert main(["ensemble", asked, "--out", str(out), "--part", "1/1"]) == 0
    return out


def resumed(asked, out):
    assert main(["ensemble", asked, "--out", str(out), "--part", "1/1", "--resume"]) == 0
    assert not list(out.parent.glob(".*.part"))
    return content(out)


def begun(asked, out, *words):
    return processes.start([*COMMAND, asked, "--out", str(out), *words], stdout=-1, stderr=-1, start_new_session=True)


def wait_for(out, done, run):
    """Wait until so many chunks have their byte, or the run is over."""
    folder = out / "parts" / "done" / "c"
    until = time.monotonic() + PATIENCE
    while run.poll() is None and (not folder.is_dir() or len(list(folder.iterdir())) < done):
        assert time.monotonic() < until
        time.sleep(0.002)


def test_states_and_sums_are_those_of_the_functions(asked, straight):
    store = xarray.open_zarr(straight)
    beam = {"distribution": "gaussian", "seed": 3, "sigma_theta": 0.8, "omega0": 2.0}
    theta0, velocity0 = ensemble.bunch(119_500, **beam)
    theta, velocity = libration.motion(np.array([0.0, 5.0, 1e5]), theta0[:, None], velocity0[:, None], 2.0)
    assert store.theta.dims == ("particle", "t") and store.t.values.tolist() == [0.0, 5.0, 1e5]
    assert store.theta.values.tobytes() == theta.tobytes() and store.velocity.values.tobytes() == velocity.tobytes()
    assert store.action.values.tobytes() == libration.action(theta0, velocity0, 2.0).tobytes()
    assert store.theta.values.tobytes() != np.nextafter(theta, 9.0).tobytes(), "a spoiled bit must show"
    bins = {"theta": (-3.2, 3.2, 16), "action": (0.0, 3.0, 8)}
    sums = ensemble.reduce((theta0, velocity0), t=[0.0, 5.0, 1e5], omega0=2.0, histogram=bins, chunk=2000)
    for name, each in sums.variables.items():
        assert store[name].values.tobytes() == each.values.tobytes() and store[name].attrs == each.attrs, name
    assert store.theta.attrs["units"] == "rad" and store.attrs["Conventions"].startswith("CF-")
    assert store.attrs["title"] == "a test" and store.attrs["libration_version"] == libration.__version__
    assert specification(SPEC).digest == store.attrs["libration_spec_sha256"]
    assert json.loads(store.attrs["libration_spec"])["n"] == 119_500


def test_the_same_bytes_from_one_worker_two_and_parts(asked, straight, tmp_path):
    for workers in ("1", "2"):
        run = processes.run(
            [*COMMAND, asked, "--out", str(tmp_path / f"{workers}.zarr"), "--workers", workers, "--json"],
            capture_output=True,
        )
        assert (run.returncode, run.stderr) == (0, b"") and json.loads(run.stdout)["complete"]
        assert content(tmp_path / f"{workers}.zarr") == content(straight)
    # All at once: one of them makes the store.
    parts = [begun(asked, tmp_path / "parts.zarr", "--part", f"{k}/3", "--json") for k in (1, 2, 3)]
    answers = [json.loads(part.communicate(timeout=PATIENCE)[0]) for part in parts]
    assert [part.returncode for part in parts] == [0, 0, 0] and any(each["complete"] for each in answers)
    assert [each["chunks_written"] for each in answers] == [20, 20, 20]
    assert content(tmp_path / "parts.zarr") == content(straight)


def test_parts_one_after_the_other(asked, straight, tmp_path, capsys):
    for k in (3, 1, 2):
        assert main(["ensemble", asked, "--out", str(tmp_path / "run.zarr"), "--part", f"{k}/3"]) == 0
        shown = capsys.readouterr().out
        assert ("the rest is for the other parts" in shown) == (k != 2) and "20 of 60 chunks" in shown
    assert content(tmp_path / "run.zarr") == content(straight)


@pytest.mark.parametrize(("hands", "done"), [("--workers 2", 0), ("--workers 2", 20), ("--part 1/1", 1)])
def test_a_kill_and_resume_are_the_straight_run(asked, straight, tmp_path, hands, done):
    out = tmp_path / "run.zarr"
    run = begun(asked, out, *hands.split())
    wait_for(out, done, run)
    os.killpg(run.pid, signal.SIGKILL)
    run.communicate(timeout=PATIENCE)
    assert resumed(asked, out) == content(straight)


def test_workers_end_with_the_process_that_began_them(asked, straight, tmp_path):
    out = tmp_path / "run.zarr"
    run = begun(asked, out, "--workers", "2")
    wait_for(out, 2, run)
    workers = []
    # On a machine that stopped for a while the run may be over.
    with contextlib.suppress(psutil.NoSuchProcess):
        workers = psutil.Process(run.pid).children(recursive=True)
    run.kill()
    run.communicate(timeout=PATIENCE)
    assert psutil.wait_procs(workers, timeout=PATIENCE)[1] == []
    assert resumed(asked, out) == content(straight)


def test_a_lost_worker_is_one_line(asked, straight, tmp_path):
    # A run may be over before its worker is lost; not each of many.
    for attempt in range(50):
        out = tmp_path / f"{attempt}.zarr"
        run = begun(asked, out, "--workers", "2")
        wait_for(out, 1, run)
        workers = []
        with contextlib.suppress(psutil.NoSuchProcess):
            workers = [each for each in psutil.Process(run.pid).children() if "spawn_main" in " ".join(each.cmdline())]
            for each in workers:
                each.suspend()
            for each in workers[:1]:
                each.kill()
        said = run.communicate(timeout=PATIENCE)[1].decode()
        if run.returncode:
            break
    assert run.returncode == 2 and said.startswith("libration ensemble: a worker was lost, killed by signal 9; ")
    assert said.endswith(f" of {CHUNKS} chunks are done, and --resume goes on\n") and said.count("\n") == 1
    assert psutil.wait_procs(workers, timeout=PATIENCE)[1] == [] and not list(out.rglob("*.partial"))
    assert resumed(asked, out) == content(straight)


@pytest.mark.parametrize(
    ("hands", "number"),
    [("--workers 2", signal.SIGINT), ("--workers 2", signal.SIGTERM), ("--part 1/1", signal.SIGTERM)],
)
def test_a_signal_ends_it_and_resume_goes_on(asked, straight, tmp_path, hands, number):
    out = tmp_path / "run.zarr"
    run = begun(asked, out, *hands.split())
    wait_for(out, 1, run)
    # To all processes, as a terminal does.
    os.killpg(run.pid, signal.SIGINT) if number == signal.SIGINT else run.send_signal(number)
    said = run.communicate(timeout=PATIENCE)[1].decode()
    # If it was over: 0, or ended by the signal as the interpreter ends.
    assert run.returncode in (128 + number, 0, -number)
    if run.returncode > 0:
        why = "interrupted" if number == signal.SIGINT else "asked to end"
        assert re.fullmatch(
            rf"libration ensemble: {why}; \d+ of {CHUNKS} chunks are done, and --resume goes on\n", said
        )
    else:
        assert said == "" and content(out) == content(straight)
    assert not list(out.rglob("*.partial"))
    assert resumed(asked, out) == content(straight)


def test_no_space_left_is_one_line_and_resumes(asked, straight, tmp_path, monkeypatch, capsys):
    out = tmp_path / "run.zarr"

    def full(path, spec, number):
        if number == 7:
            (out / "theta" / "c" / "7.0123.partial").write_bytes(b"half")
            raise OSError(28, "No space left on device")
        return _store.written(path, spec, number)

    monkeypatch.setattr(_workers, "written", full)
    assert main(["ensemble", asked, "--out", str(out), "--part", "1/1"]) == 2
    said = f"--out = {out}: cannot be written: No space left on device; 7 of 60 chunks are done, and --resume goes on"
    shown = capsys.readouterr().err
    # A long path is shown in part.
    assert shown.endswith(said.partition(": ")[2] + "\n") and shown.count("\n") == 1
    assert not list(out.rglob("*.partial"))
    monkeypatch.undo()
    assert resumed(asked, out) == content(straight)


def test_two_runs_of_one_part_do_not_take_each_others_files_away(asked, straight, tmp_path, monkeypatch, capsys):
    """The second to begin removes what it takes for a leftover; the first ends, and leaves the second at work."""
    out = tmp_path / "run.zarr"
    others = out / "theta" / "c" / "9.0123.partial"

    def taken_away(path, spec, number):
        if number == 7:
            others.write_bytes(b"the other run's")
            raise FileNotFoundError(2, "No such file or directory")
        return _store.written(path, spec, number)

    monkeypatch.setattr(_workers, "written", taken_away)
    assert main(["ensemble", asked, "--out", str(out), "--part", "1/1"]) == 2
    shown = capsys.readouterr().err
    assert "was taken away; is another run at work on the same chunks?; 7 of 60 chunks are done" in shown
    assert shown.count("\n") == 1 and others.exists()
    monkeypatch.undo()
    assert resumed(asked, out) == content(straight)


def test_an_error_of_a_worker_is_one_line(asked, straight, tmp_path):
    out = tmp_path / "run.zarr"
    assert main(["ensemble", asked, "--out", str(out), "--part", "2/2"]) == 0
    in_the_place = out / "theta" / "c" / "3"
    in_the_place.write_bytes(b"")
    run = processes.run([*COMMAND, asked, "--out", str(out), "--workers", "2", "--resume"], capture_output=True)
    assert run.returncode == 2 and b"cannot be written" in run.stderr and run.stderr.count(b"\n") == 1
    in_the_place.unlink()
    assert resumed(asked, out) == content(straight)


def test_a_part_leaves_alone_what_others_write(asked, straight, tmp_path):
    out = tmp_path / "run.zarr"
    assert main(["ensemble", asked, "--out", str(out), "--part", "1/2"]) == 0
    ours = [out / "theta" / "c" / "4" / "0.01ab.partial", out / "parts" / "done" / "c" / "4.01ab.partial"]
    theirs = out / "theta" / "c" / "5" / "0.01ab.partial"
    for each in (*ours, theirs):
        each.parent.mkdir(exist_ok=True)
        each.write_bytes(b"half")
    assert main(["ensemble", asked, "--out", str(out), "--part", "2/2", "--resume"]) == 0
    assert not any(each.exists() for each in ours) and theirs.exists()
    theirs.unlink()
    assert content(out) == content(straight)


def test_chunks_of_nan_are_written_once(tmp_path, capsys):
    asked = tmp_path / "far.toml"
    asked.write_text(
        "[states]\ntheta0 = 0.5\nvelocity0 = [1e200, 1e200, 1.0, 1.0, 1.0, 1e200]\n[time]\nt = [1e18]\n[output]\nchunk = 2\n"
        'variables = ["theta"]\n'
        "[reduce]\n"
    )
    out = tmp_path / "far.zarr"
    assert main(["ensemble", str(asked), "--out", str(out), "--part", "1/1"]) == 0
    store = xarray.open_zarr(out)
    assert np.isnan(store.theta.values.ravel()).tolist() == [False, False, True, True, True, False]
    # Whole turns of so large an angle are not known.
    assert store["count"].values.tolist() == [0] and math.isnan(store.theta_mean[0])
    assert (out / "theta" / "c" / "1" / "0").is_file() and (out / "parts" / "done" / "c" / "1").is_file()
    capsys.readouterr()
    assert main(["ensemble", str(asked), "--out", str(out), "--workers", "2", "--resume", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["chunks_written"] == 0


def test_a_grid_is_the_product_of_its_axes(tmp_path):
    asked = tmp_path / "grid.toml"
    asked.write_text(
        "[states]\ntheta0 = [0.5, 1.0]\nvelocity0 = { from = -1, to = 1, count = 3 }\nomega0 = [1, 2]\n"
        "[time]\nfrom = 0\nto = 2\ncount = 5\n[output]\n"
        'chunk = 5\nvariables = ["theta", "theta0", "velocity0", "omega0", "energy_ratio", "frequency"]\n'
    )
    assert main(["ensemble", str(asked), "--out", str(tmp_path / "grid.zarr"), "--part", "1/1"]) == 0
    store = xarray.open_zarr(tmp_path / "grid.zarr")
    t = np.linspace(0.0, 2.0, 5)
    whole = ensemble.sweep(theta0=[0.5, 1.0], velocity0=np.linspace(-1, 1, 3), omega0=[1.0, 2.0], t=t)
    assert store.theta.values.tobytes() == whole.theta.values.tobytes()
    starts = [store[name].values for name in ("theta0", "velocity0", "omega0")]
    assert np.array_equal(np.reshape(starts, (3, 2, 3, 2))[2, 1, 2], [1.0, 2.0])
    assert np.array_equal(store.frequency, libration.frequency(*starts))
    assert np.array_equal(store.energy_ratio, libration.energy_ratio(*starts))


@pytest.mark.parametrize(
    "changed",
    [
        {},
        {'"velocity", "theta", "action"': '"frequency", "energy_ratio", "theta0"'},
        {"[0.0, 5.0, 1e5]": "[5.0]", '"velocity", "theta", "action"': '"theta"'},
        {"t = [0.0, 5.0, 1e5]": "from = 0.0\nto = 9.0\ncount = 20"},
        {'variables = ["velocity", "theta", "action"]': ""},
    ],
    ids=str,
)
def test_a_chunk_stays_within_its_memory(changed, tmp_path):
    text = SPEC.replace("chunk = 2000", "chunk = 100_000")
    for old, new in changed.items():
        text = text.replace(old, new)
    spec = specification(text)
    path = str(tmp_path / "run.zarr")
    _store.created(path, spec, "0")
    _store.written(path, spec, 0)
    tracemalloc.start()
    _store.written(path, spec, 0)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak <= chunk_bytes(spec) <= 4 * peak


SCHEDULER = """if True:
    import sys
    from distributed import LocalCluster
    if __name__ == "__main__":
        kind = dict(processes=False, protocol="tcp://", host="127.0.0.1", dashboard_address=None)
        with LocalCluster(n_workers=2, threads_per_worker=1, **kind) as cluster:
            print(cluster.scheduler_address, flush=True)
            sys.stdin.read()
"""


def test_a_scheduler_of_dask_fills_the_same_store(asked, straight, tmp_path, monkeypatch, capsys):
    scheduler = processes.start([sys.executable, "-c", SCHEDULER], stdin=-1, stdout=-1, stderr=-1, text=True)
    with scheduler:
        address = scheduler.stdout.readline().strip()
        out = tmp_path / "run.zarr"
        assert main(["ensemble", asked, "--out", str(out), "--part", "1/2"]) == 0
        capsys.readouterr()
        assert main(["ensemble", asked, "--out", str(out), "--scheduler", address, "--resume", "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["chunks_written"] == 30
        scheduler.communicate("", timeout=PATIENCE)
    assert content(out) == content(straight)
    monkeypatch.setattr(_workers, "ANSWER", "1s")
    assert main(["ensemble", asked, "--out", str(tmp_path / "b.zarr"), "--scheduler", "tcp://127.0.0.1:1"]) == 2
    said = capsys.readouterr().err
    assert said == "libration ensemble: --scheduler = tcp://127.0.0.1:1: no scheduler of Dask answers there\n"
    assert not (tmp_path / "b.zarr").exists()


@pytest.mark.parametrize("name", ["filamentation", "training", "tunes"])
def test_examples_run(name, tmp_path):
    example = Path(__file__).parents[2] / "examples" / f"{name}.toml"
    assert main(["ensemble", str(example), "--out", str(tmp_path / "run.zarr"), "--part", "1/1"]) == 0
    store = xarray.open_zarr(tmp_path / "run.zarr")
    assert all(np.isfinite(each.values).all() for each in store.values())
    if name == "filamentation":
        rms = np.sqrt(store.theta_variance.values)
        assert rms[0] < 0.81 and abs(rms[10:] - 0.89).max() < 0.03 and int(store.histogram[0].sum()) <= 200_000


def test_an_unfinished_store_reads_as_nan(asked, tmp_path):
    out = tmp_path / "run.zarr"
    assert main(["ensemble", asked, "--out", str(out), "--part", "1/2"]) == 0
    store = xarray.open_zarr(out)
    assert np.isnan(store.theta[:2000]).all() and not np.isnan(store.theta[2000:4000]).any()
    assert math.isnan(store.theta_mean[0]) and store["count"].values.tolist() == [0, 0, 0]
    assert zarr.open_array(out / "parts" / "done")[:4].tolist() == [0, 1, 0, 1]
