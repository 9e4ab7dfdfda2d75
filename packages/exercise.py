"""Tries the libration that is installed: every public name, every door once, the page of the lab, and the truth. Run by the interpreter
that has it, from a folder that is not the checkout; needs NumPy and click, as the package does.

    python CHECKOUT/packages/exercise.py
"""

import importlib
import importlib.util
import json
import math
import os
import subprocess
import sys
import threading
import tomllib
import warnings
from importlib import metadata
from pathlib import Path
from urllib.request import urlopen

ROOT = Path(__file__).resolve().parents[1]
ROOMS = ("approx", "damped", "elliptic", "ensemble", "measurement", "oscillator", "papers", "pendulum", "plot")


def rows_of_the_truth():
    """The module of the reference rows, by its path."""
    place = importlib.util.spec_from_file_location("orbit_rows", ROOT / "bench/measurement/orbit_rows.py")
    module = importlib.util.module_from_spec(place)
    sys.modules[place.name] = module
    place.loader.exec_module(module)
    return module


def installed(libration) -> str:
    """The version, which is that of the checkout; the files are not."""
    version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    assert libration.__version__ == version == metadata.version("libration"), libration.__version__
    assert not Path(libration.__file__).resolve().is_relative_to(ROOT / "python"), libration.__file__
    return f"libration {version}"


def named(libration) -> str:
    """Every public name is there."""
    count = 0
    for owner in (libration, *(importlib.import_module(f"libration.{room}") for room in ROOMS)):
        for name in owner.__all__:
            getattr(owner, name)
            count += 1
    return f"{count} names"


def true(libration) -> str:
    """The angle, the velocity and the period of every reference row hold what functions.toml promises, one by one and as columns."""
    truth = rows_of_the_truth()
    table = tomllib.loads((ROOT / "functions.toml").read_text(encoding="utf-8"))
    one = {output: table["Pendulum." + output]["error_max_ulp"] for output in truth.OUTPUTS}
    own = {output: table[output]["error_max_ulp_own_state"] for output in ("theta", "velocity")}
    rows = truth.rows()
    for row in rows:
        orbit = libration.Pendulum(row.theta0, row.velocity0, omega2=row.omega2)
        assert orbit.regime.value == row.regime, row
        for output, got in zip(truth.OUTPUTS, (*orbit.motion(row.t), orbit.period), strict=True):
            assert row.error(output, got) <= one[output], (output, got, row)
    stated = [row for row in rows if row.omega0 is not None]
    columns = zip(*((row.t, row.theta0, row.velocity0, row.omega0) for row in stated), strict=True)
    for output, column in zip(own, libration.motion(*map(list, columns)), strict=True):
        for row, got in zip(stated, column, strict=True):
            assert row.error(output, got, floor=truth.Fraction(1)) <= own[output], (output, got, row)
    wrong = libration.Pendulum(rows[0].theta0, rows[0].velocity0, omega2=rows[0].omega2).motion(rows[0].t)[0] * (
        1 + 2**-40
    )
    assert rows[0].error("theta", wrong) > one["theta"]
    return f"{len(rows)} rows of the truth"


def fitted(libration) -> str:
    """A file of measurements gives what the page of the lab is held to."""
    record = ROOT / "lab/tests/record-70deg.csv"
    wanted = json.loads(record.with_suffix(".json").read_text(encoding="utf-8"))["g"]["value"]
    found = libration.fit(record, length=(0.8, 0.001))
    assert abs(found.g.value - wanted) < 1e-9 * wanted, found.g
    return found.sentence()


def elsewhere(libration) -> str:
    """One call of each of the other rooms."""
    from libration import approx, elliptic

    assert f"{libration.Duffing(1.0, p=1.0, q=0.5).period:.12f}" == f"{duffing_period(1.0, 1.0, 0.5):.12f}"
    damped = libration.DampedPendulum(1.0, friction=libration.Friction(dry=0.1))
    assert f"{damped.rests(0.0, 60.0)[0][0]:.6f}" == "16.056758"
    assert abs(elliptic.complete_k(m=0.5) - 1.8540746773013719) < 5 * math.ulp(1.85)
    assert 0 < abs(approx.angle("fourier:4").of(libration.Pendulum(2.0)).error().relative) < 1e-2
    return "springs, friction, elliptic functions, approximations"


def duffing_period(u0: float, p: float, q: float) -> float:
    """The period of u'' + p u + q u^3 = 0 from rest, by the arithmetic-geometric mean: pi/2 over agm(sqrt(a), sqrt(b)) times four."""
    a, b = math.sqrt(p + q * u0 * u0), math.sqrt(p + q * u0 * u0 / 2)
    for _ in range(60):
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi / a


def threaded(libration) -> str:
    """A column long enough for several threads has the digits of its rows."""
    import numpy as np

    orbit, t = libration.Pendulum(3.0, length=1.0), np.linspace(0.0, 1e6, 100_001)
    theta = orbit.theta(t)
    assert all(theta[i] == orbit.theta(float(t[i])) for i in range(0, len(t), 997))
    return f"{len(t)} instants"


def served(libration) -> str:
    """The page of the lab is there, and is served."""
    from libration.cli import lab

    files = [each for each in lab.PAGE.rglob("*") if each.is_file()]
    assert any(each.suffix == ".wasm" for each in files), lab.PAGE
    with lab.server(lab.PAGE, 0) as serving:
        threading.Thread(target=serving.serve_forever, daemon=True).start()
        page = urlopen(f"http://127.0.0.1:{serving.server_address[1]}/", timeout=60).read()
        serving.shutdown()
    assert b"<title>" in page and any(each.name == "widget.js" for each in files)
    return f"the lab, {sum(each.stat().st_size for each in files) / 1e6:.1f} MB"


def shell(libration) -> str:
    """The command answers, by its name where there is one."""
    script = Path(sys.executable).with_name("libration" + ".exe" * (os.name == "nt"))
    words = (
        [str(script)] if script.exists() else [*os.environ.get("RUNNER", "").split(), sys.executable, "-m", "libration"]
    )
    words = [*words, "period", "--lang"]
    for lang, phase in (("en", "11.072252581475"), ("pt-BR", "11,072252581475"), ("es", "11,072252581475")):
        run = subprocess.run([*words, lang, "--theta0", "150deg"], capture_output=True, text=True, encoding="utf-8")
        assert run.returncode == 0 and phase in run.stdout, (words, run.stdout, run.stderr)
    refused = subprocess.run([*words, "es", "--theta0", "nan"], capture_output=True, text=True, encoding="utf-8")
    assert refused.returncode == 2 and refused.stderr.count("\n") == 1, refused.stderr
    return Path(words[0]).name + " in the shell"


def main() -> int:
    import libration

    # Angles of the truth are of any size; the package asks whether they are degrees.
    warnings.simplefilter("ignore")
    found = [work(libration) for work in (installed, named, true, fitted, elsewhere, threaded, served, shell)]
    where = f"{sys.implementation.name} {sys.version.split()[0]}, {sys.platform}"
    print(f"{where}: " + "; ".join(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
