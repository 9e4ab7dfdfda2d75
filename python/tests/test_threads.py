"""Threads share long arrays and change no bit; memory that overlaps and a fork change no answer."""

import os
import subprocess
import sys

import numpy as np
import pytest
from bits import all_same, same

import libration
from libration import Pendulum, _core

LONG = 200_000
ROWS = 100_000
PENDULUM = Pendulum(3.0, 0.1, omega0=1.3)
LIMIT = 600

# What one process computes for the array t: named columns, saved for the comparison.
COLUMNS = """if True:
    import sys
    import numpy as np
    import libration
    t = np.load(sys.argv[1])
    np.savez(
        sys.argv[2],
        theta=libration.theta(t, 3.0, 0.1, 1.3),
        velocity=libration.velocity(t, 3.0, 0.1, 1.3),
        motion=libration.motion(t, 3.0, 0.1, 1.3),
        states=libration.motion(t, np.sin(t), np.cos(t)),
        jacobi=libration.jacobi(t, m=0.8),
        parameters=libration.jacobi(t, mc=np.cos(t)),
    )
"""


def instants(count, seed=5):
    """Times of both signs and many sizes."""
    random = np.random.default_rng(seed)
    return random.normal(size=count) * 10.0 ** random.integers(-6, 7, size=count)


def python(code, *words, threads):
    """Run a program in a process with so many threads."""
    environment = os.environ | {"LIBRATION_NUM_THREADS": threads}
    run = [sys.executable, "-c", code, *map(str, words)]
    return subprocess.run(run, env=environment, capture_output=True, text=True, timeout=LIMIT)


def test_the_number_of_threads_changes_no_bit(tmp_path):
    t = instants(LONG)
    np.save(tmp_path / "t.npy", t)
    columns = {}
    for threads in ("1", "2", "7"):
        done = python(COLUMNS, tmp_path / "t.npy", tmp_path / f"{threads}.npz", threads=threads)
        assert (done.returncode, done.stderr) == (0, "")
        with np.load(tmp_path / f"{threads}.npz") as archive:
            columns[threads] = dict(archive)
    assert len(columns["1"]) == 6
    for name, one in columns["1"].items():
        assert one.shape[-1] == LONG
        assert same(one, columns["2"][name]), name
        assert same(one, columns["7"][name]), name
    one = columns["1"]
    for index in [0, 1, LONG // 2 - 1, LONG // 2, LONG - 1, *range(17, LONG, 1999)]:
        value = float(t[index])
        assert same(one["theta"][index], PENDULUM.theta(value))
        assert same(one["velocity"][index], PENDULUM.velocity(value))
        assert same(one["motion"][:, index], np.array(PENDULUM.motion(value)))
        row = libration.motion(t[index : index + 1], np.sin(t)[index : index + 1], np.cos(t)[index : index + 1])
        assert same(one["states"][:, index], np.concatenate(row))
        assert same(one["jacobi"][:, index], np.array(libration.jacobi(value, m=0.8)))
        own = libration.jacobi(value, mc=np.cos(t)[index : index + 1])
        assert same(one["parameters"][:, index], np.concatenate(own))


@pytest.mark.parametrize("threads", ["0", "x", "-1", "1.5", "1025"])
def test_a_bad_number_of_threads_is_refused_by_the_import(threads):
    done = python("import libration", threads=threads)
    assert done.returncode == 1
    said = f"ValueError: LIBRATION_NUM_THREADS = {threads}: must be a whole number from 1 to 1024"
    assert done.stderr.splitlines()[-1] == said
    assert done.stderr.count("Error") == 1


@pytest.mark.posix
def test_a_number_of_threads_that_is_no_text_is_refused_by_the_import():
    run, environment = [sys.executable, "-c", "import libration"], dict(os.environb)
    environment[b"LIBRATION_NUM_THREADS"] = b"2\xff"
    done = subprocess.run(run, env=environment, capture_output=True, timeout=LIMIT)
    assert done.returncode == 1
    said = "ValueError: LIBRATION_NUM_THREADS = 2\ufffd: must be a whole number from 1 to 1024"
    assert done.stderr.decode("utf-8", "replace").splitlines()[-1].replace("\\ufffd", "\ufffd") == said


@pytest.mark.parametrize("threads", ["", " 2 ", "1024"])
def test_a_good_number_of_threads_is_taken(threads):
    assert python("import libration", threads=threads).returncode == 0


@pytest.mark.posix
def test_a_forked_child_answers():
    """The threads of the parent are not there in the child, which must not wait for them."""
    code = f"""if True:
        import os, signal
        import numpy as np
        import libration
        t = np.linspace(0.0, 50.0, {LONG})
        before = libration.theta(t, 3.0)
        child = os.fork()
        if child == 0:
            signal.alarm(600)
            os._exit(0 if np.array_equal(libration.theta(t, 3.0), before) else 1)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        print(status, np.array_equal(libration.theta(t, 3.0), before))
    """
    done = python(code, threads="2")
    assert done.stdout.strip() == "0 True", done.stderr


@pytest.mark.parametrize("count", [2, 3, 40])
def test_reduce_and_accumulate_are_the_loop(count):
    u = np.random.default_rng(count).uniform(0.01, 0.9, count)
    expected = [u[0]]
    for value in u[1:]:
        expected.append(_core.incomplete_f_m(expected[-1], value))
    assert same(_core.incomplete_f_m.accumulate(u), np.array(expected))
    assert same(_core.incomplete_f_m.reduce(u), expected[-1])


def test_shifted_views_as_out():
    for ahead in (True, False):
        t = instants(ROWS)
        source, target = (t[:-1], t[1:]) if ahead else (t[1:], t[:-1])
        expected = PENDULUM.theta(source.copy())
        kept = t[:1].copy() if ahead else t[-1:].copy()
        PENDULUM.theta(source, out=target)
        assert same(target, expected)
        assert same(t[:1] if ahead else t[-1:], kept)


def test_columns_of_one_table():
    table = np.empty((ROWS, 3))
    table[:, 0] = t = instants(ROWS)
    expected = libration.motion(t, 3.0, 0.1, 1.3)
    libration.motion(table[:, 0], 3.0, 0.1, 1.3, out=(table[:, 1], table[:, 2]))
    assert same(table[:, 0], t)
    assert all_same((table[:, 1], table[:, 2]), expected)
    libration.motion(table[:, 0], 3.0, 0.1, 1.3, out=(table[:, 2], table[:, 0]))
    assert all_same((table[:, 2], table[:, 0]), expected)


def test_out_may_be_the_input():
    t = instants(ROWS)
    expected = PENDULUM.theta(t.copy())
    PENDULUM.theta(t, out=t)
    assert same(t, expected)
    u = instants(ROWS)
    values = libration.jacobi(u.copy(), m=0.8)
    out = (np.empty(ROWS), u, np.empty(ROWS), np.empty(ROWS))
    libration.jacobi(u, m=0.8, out=out)
    assert all_same(out, tuple(values))
    theta, velocity = np.sin(instants(ROWS)), np.cos(instants(ROWS))
    after = libration.advance(theta.copy(), velocity.copy(), 0.7)
    libration.advance(theta, velocity, 0.7, out=(velocity, theta))
    assert all_same((velocity, theta), after)


def test_out_backwards():
    t = instants(ROWS)
    expected = PENDULUM.theta(t.copy())
    PENDULUM.theta(t, out=t[::-1])
    assert same(t[::-1], expected)
