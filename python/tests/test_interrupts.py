"""Ctrl-C ends every long call: KeyboardInterrupt in Python, exit code 130 and no file in the command line.

Every call here would take minutes. A child process says when it begins; a call that goes on kills it by its alarm, long
after a signal should have ended it on the busiest machine.
"""

import os
import signal
import subprocess
import sys
import time

import pytest

LIMIT = 300
# Ctrl-C while the command line is being loaded.
LOADING = """if True:
    import sys

    class Interrupted:
        def find_spec(self, name, *_):
            if name == "libration.cli":
                raise KeyboardInterrupt

    sys.meta_path.insert(0, Interrupted())
    from libration.__main__ import run
    sys.exit(run())
"""
# Long enough for the call to have begun; on a busy machine the signal comes before it, and ends it as well.
BEGUN = 0.5

BEGIN = f"""if True:
    import signal
    import sys
    import numpy as np
    import libration
    import scipy.integrate
    from libration import Pendulum, approx, elliptic
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    swing = Pendulum(2.0)

    def damped(k):
        return libration.DampedPendulum(1.0 + k / 10**5, friction=libration.Friction(linear=1e-9))

    table = b"t / s,theta / rad\\n" + b"".join(b"%d,0.%d\\n" % (k, k % 7) for k in range(10**6))
    seconds = np.linspace(0.0, 60.0, 6000)
    swings = np.exp(-0.01 * seconds) * np.cos(3.0 * seconds)

    def same(value, count=10**9):
        return np.broadcast_to(value, (count,))

    def interrupted(call):
        try:
            # Inside, because the signal may come before the call.
            print("begun", flush=True)
            signal.alarm({LIMIT})
            call()
        except KeyboardInterrupt:
            signal.alarm(0)
            return print("interrupted", flush=True)
        print("went on", flush=True)

"""

# Broadcast arguments take no memory, and the one page of a broadcast `out` none either.
CALLS = {
    "theta functions": "elliptic.theta1(same(0.7), m=same(0.5), out=np.empty(10**9))",
    "one orbit": "swing.theta(same(0.7), out=np.empty(10**9))",
    "states of their own": "libration.motion(same(1e3, 10**8), same(1.0, 10**8), same(0.3, 10**8))",
    "whole turns": "swing.turns(same(1e3, 10**8))",
    "a set-up for every row": "libration.theta(np.linspace(0, 9, 10**4)[:, None], 1.0, np.linspace(0, 9, 10**5))",
    "an accumulation": "libration._core.incomplete_e_m.accumulate(np.full(10**7, 0.5))",
    "errors of a secular formula": "approx.angle('small-m').of(swing).error(10000)",
    "ranges over many periods": "approx.angle('fourier:50').ranges(1e-3, 10000)",
    "angles by a long series": "approx.angle('fourier:500').of(Pendulum(3.14159)).theta(same(0.7, 10**8).copy())",
    "periods of many angles": "approx.period('chachiyo').error(same(0.7, 10**8).copy())",
    "values of a polynomial": "approx.sine('best:21', phi_max=2.0).value(same(0.7, 10**8).copy())",
    "steps of a scheme": "[approx.numerical('rk4:0.00001').of(swing).error(4.0 + k / 100) for k in range(50)]",
    "a damped motion": "[damped(k).theta(1e9) for k in range(10**4)]",
    "derivatives of a damped motion": "[damped(k).sensitivities(np.arange(1e5)) for k in range(10**4)]",
    "fits": "[libration.fit(seconds, swings) for _ in range(10**4)]",
    "long tables": "[libration._core.Record('', table, [], []) for _ in range(10**4)]",
    "SciPy's solution": "approx.numerical('odeint').of(Pendulum(3.0)).error(10000)",
}


@pytest.mark.parametrize("threads", ["1", "2"])
def test_every_long_call_ends(threads):
    code = BEGIN + "".join(f"    interrupted(lambda: {call})\n" for call in CALLS.values())
    environment = os.environ | {"LIBRATION_NUM_THREADS": threads}
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, env=environment)
    with child:
        for name in CALLS:
            assert child.stdout.readline() == "begun\n", name
            time.sleep(BEGUN)
            child.send_signal(signal.SIGINT)
            assert child.stdout.readline() == "interrupted\n", name
    assert child.returncode == 0


def test_passages_are_cut_short():
    """A search for ten million times takes a second: repeated, so that the signal falls into one of them."""
    code = BEGIN + "    interrupted(lambda: [swing.times(0.5, 0, 4.9e6 * swing.period) for _ in range(10**4)])\n"
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    with child:
        assert child.stdout.readline() == "begun\n"
        time.sleep(BEGUN)
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "interrupted\n"


def test_a_handler_may_call_and_go_on():
    """A signal that raises nothing changes no value, and its handler may use the library."""
    code = """if True:
        import signal
        import numpy as np
        import libration
        t = np.linspace(0.0, 50.0, 300_000)
        expected = libration.theta(t, 3.0)
        seen = []
        def handler(*_):
            seen.append(libration.theta(t, 3.0))
            # Once more only when this one is done.
            signal.setitimer(signal.ITIMER_REAL, 0.01)
        signal.signal(signal.SIGALRM, handler)
        signal.setitimer(signal.ITIMER_REAL, 0.01)
        while len(seen) < 5:
            assert np.array_equal(libration.theta(t, 3.0), expected)
        signal.setitimer(signal.ITIMER_REAL, 0)
        assert all(np.array_equal(each, expected) for each in seen)
    """
    subprocess.run([sys.executable, "-c", code], check=True, timeout=LIMIT)


def test_the_command_line_leaves_no_file(tmp_path):
    # Minutes, each of some four million steps; so that a machine however slow is not done before the signal comes.
    schemes = ",".join(f"rk4:0.000{step}" for step in range(180, 400))
    words = ["compare", "--theta0", "2", "--with", schemes, "--periods", "5"]
    words += ["--out", str(tmp_path / "a.csv"), "--plot", str(tmp_path / "new/a.png")]
    code = BEGIN + "    from libration.cli import main\n    sys.exit(main(sys.argv[1:]))\n"
    child = subprocess.Popen([sys.executable, "-c", code, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while not any(each.suffix == ".part" for each in tmp_path.rglob("*")):
        assert child.poll() is None
        time.sleep(0.01)
    time.sleep(BEGUN)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=LIMIT) == (b"", b"")
    assert child.returncode == 130
    assert list(tmp_path.iterdir()) == []


def test_while_the_command_line_is_loaded():
    done = subprocess.run([sys.executable, "-c", LOADING], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")
