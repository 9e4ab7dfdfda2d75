"""Standard streams that are narrow, closed, full or left, and signals: an exit code, one line at most, no file left."""

import os
import signal
import subprocess
import sys

import pytest
from processes import run, start

LIBRATION = [sys.executable, "-m", "libration"]
SOLVE = ["solve", "--theta0", "1", "--length", "1"]
SIGNALS = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}


def command(*words, **options):
    """Run `python -m libration` in a process of its own."""
    made = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True} | options
    return run([*LIBRATION, *words], **made)


def redirected(redirection, *words):
    """Run it from a shell that redirects a stream."""
    return run(["sh", "-c", f'exec "$@" {redirection}', "sh", *LIBRATION, *words], capture_output=True, text=True)


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "utf-8"])
def test_names_beyond_the_encoding(tmp_path, encoding):
    environment = os.environ | {"PYTHONIOENCODING": encoding}
    names = ["\u00e9.csv", "\u03b8.csv"]
    for name in names:
        done = command(*SOLVE, "--out", name, cwd=tmp_path, env=environment, text=False)
        assert (done.returncode, done.stderr) == (0, b"")
        shown = name.encode(encoding, "backslashreplace")
        assert done.stdout.splitlines()[-1].split() == [b"written", shown]
        done = command("solve", name, cwd=tmp_path, env=environment, text=False)
        said = b"libration solve: unknown word '%b'; see libration solve --help"
        assert (done.returncode, done.stderr.splitlines()) == (2, [said % shown])
    assert sorted(os.listdir(tmp_path)) == sorted(names)


def test_the_streams_of_a_caller_are_given_back():
    code = "import sys; from libration.cli import main; main(['--version']); print(sys.stdout.errors)"
    environment = os.environ | {"PYTHONIOENCODING": "ascii:ignore"}
    done = run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
    assert done.stdout.splitlines()[1:] == ["ignore"]


@pytest.mark.parametrize("words", [["--help"], ["period", "--theta0", "1"], [*SOLVE, "--out", "a.csv"]])
def test_closed_standard_output(tmp_path, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    done = redirected(">&-", *words)
    prog = "libration" if words == ["--help"] else f"libration {words[0]}"
    assert done.stderr == f"{prog}: standard output: is closed, so there is nowhere to print\n"
    assert done.returncode == 2
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("redirection", ["2>&-", "2>/dev/full", ">&- 2>&-", "<&- >&- 2>&-"])
def test_no_place_for_the_refusal(redirection):
    done = redirected(redirection, "period", "--theta0", "nan")
    assert (done.returncode, done.stdout, done.stderr) == (2, "", "")


def test_no_file_takes_the_place_of_a_closed_stream(tmp_path):
    """What another library prints at the place of the standard error would land in the table."""
    code = """if True:
        import os, sys
        from libration import Pendulum
        from libration.cli import main
        motion = Pendulum.motion
        def noisy(*arguments):
            os.write(2, b"noise")
            return motion(*arguments)
        Pendulum.motion = noisy
        sys.exit(main(sys.argv[1:]))
    """
    words = ["sh", "-c", 'exec "$@" 2>&-', "sh", sys.executable, "-c", code, *SOLVE, "--out", "a.csv"]
    assert run(words, cwd=tmp_path, stdout=subprocess.DEVNULL).returncode == 0
    assert b"noise" not in (tmp_path / "a.csv").read_bytes()


@pytest.mark.parametrize("words", [["--help"], ["period", "--theta0", "1"]])
@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_broken_pipe_ends_quietly(words, unbuffered):
    environment = os.environ | {"PYTHONUNBUFFERED": unbuffered}
    reader, writer = os.pipe()
    os.close(reader)
    done = run([*LIBRATION, *words], stdout=writer, stderr=subprocess.PIPE, env=environment)
    os.close(writer)
    assert done.returncode == 141
    assert done.stderr == b""


def test_full_disk_behind_the_standard_output():
    with open("/dev/full", "w") as full:
        done = command("period", "--theta0", "1", stdout=full)
    assert done.returncode == 2
    assert done.stderr == "libration period: standard output: No space left on device\n"


@pytest.mark.parametrize("number", SIGNALS)
def test_a_signal_ends_quietly_and_leaves_nothing(tmp_path, number):
    fifo = tmp_path / "instants"
    os.mkfifo(fifo)
    words = [*SOLVE, "--times", str(fifo), "--out", str(tmp_path / "a.csv"), "--plot", str(tmp_path / "new/a.png")]
    running = start([*LIBRATION, *words], stderr=subprocess.PIPE)
    # Opening waits for the reader; then the process waits for the instants.
    with open(fifo, "wb"):
        staged = [each for each in tmp_path.rglob("*") if each.suffix == ".part"]
        running.send_signal(number)
        said = running.communicate(timeout=600)[1]
    assert len(staged) == 2
    assert running.returncode == SIGNALS[number]
    assert said == b""
    assert [each.name for each in tmp_path.iterdir()] == ["instants"]


def test_an_ignored_signal_stays_ignored(tmp_path):
    fifo = tmp_path / "instants"
    os.mkfifo(fifo)
    words = ["sh", "-c", 'trap "" HUP; exec "$@"', "sh", *LIBRATION, *SOLVE, "--times", str(fifo)]
    running = start(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    with open(fifo, "wb") as file:
        running.send_signal(signal.SIGHUP)
        file.write(b"1\n")
    assert running.communicate(timeout=600)[1] == b""
    assert running.returncode == 0
