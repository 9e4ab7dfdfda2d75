"""Installs a wheel where nothing else is, with no Rust, no Node and no compiler on the path, and tries it; says how long that took.

    python packages/try_wheel.py WHEEL PYTHON...                         an environment of each interpreter's own
    python packages/try_wheel.py WHEEL --for PLATFORM VERSION [REQUIREMENT...] -- RUN...
        a folder for an interpreter of another system, which RUN starts; a requirement is a version that runs there

The seconds are those of a person: from `pip install` to the prompt, and from the first word to the first answer.
"""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
EXERCISE = ROOT / "packages/exercise.py"
PLACE = ROOT / "target/packages"
ANSWER = "import libration; print(libration.Pendulum.degrees(150, length=1.0).period)"
LINUX = ("manylinux_2_28", "manylinux_2_27", "manylinux_2_17", "manylinux2014")
BUILDERS = ("cargo", "rustc", "maturin", "cc", "gcc", "node", "npm")


def run(words, **options) -> tuple[str, str]:
    """What a command prints, and its seconds: those of a clock, and of the processor where it is not Windows."""
    begun, before = time.perf_counter(), os.times()
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, encoding="utf-8", **options)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return done.stdout.strip(), f"{time.perf_counter() - begun:.2f} s ({used:.2f} s of the processor)"


def own_environment(wheel: Path, python: str) -> str:
    """A new environment of this interpreter, with the wheel and what it asks for."""
    home = PLACE / f"on-{Path(python).resolve().parent.parent.name}-{Path(python).name}"
    shutil.rmtree(home, ignore_errors=True)
    run([python, "-m", "venv", home])
    scripts = home / ("Scripts" if os.name == "nt" else "bin")
    inside = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("PYTHON", "CARGO", "RUST", "VIRTUAL_ENV"))
    }
    inside |= {"PATH": str(scripts), "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    there = [name for name in BUILDERS if shutil.which(name, path=inside["PATH"])]
    assert not there, f"{there} stand on the path"
    within, here = scripts / ("python" + ".exe" * (os.name == "nt")), {"cwd": PLACE, "env": inside}
    _, install = run([within, "-m", "pip", "install", "--quiet", "--only-binary", ":all:", wheel], **here)
    answer, first = run([within, "-c", ANSWER], **here)
    shell, second = run([scripts / "libration", "period", "--theta0", "150deg", "--length", "1m"], **here)
    assert answer[:14] in shell, (answer, shell)
    told, _ = run([within, EXERCISE], **here)
    return f"{told}\n  pip install {install}, then the first answer {first} in Python, {second} in the shell"


def foreign(wheel: Path, platform: str, version: str, more: list[str], runner: list[str]) -> str:
    """The wheel and what it asks for in a folder, for an interpreter that is started by `runner`."""
    home = PLACE / f"for-{platform}-{version}"
    shutil.rmtree(home, ignore_errors=True)
    # Those of Linux are asked for by every name that they may have.
    names = [f"{each}_{platform}" for each in LINUX] if not platform.startswith("win") else [platform]
    wanted = [word for name in names for word in ("--platform", name)]
    # pip asks of its own interpreter what is asked of the other one.
    wanted += ["--python-version", version, "--only-binary", ":all:", "--ignore-requires-python", "--target", home]
    run([sys.executable, "-m", "pip", "install", "--quiet", *wanted, wheel, *more])
    # What starts the interpreter starts it for the command too; a system of its own starts it by itself.
    again = "" if platform.startswith("win") else " ".join(runner[:-1])
    told, seconds = run([*runner, EXERCISE], cwd=PLACE, env=os.environ | {"PYTHONPATH": str(home), "RUNNER": again})
    return f"{told}\n  {seconds} by {Path(runner[0]).name}"


def main(words: list[str]) -> int:
    wheel = Path(words[0]).resolve()
    PLACE.mkdir(parents=True, exist_ok=True)
    print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.2f} MB")
    if words[1] == "--for":
        end = words.index("--")
        print(foreign(wheel, words[2], words[3], words[4:end], words[end + 1 :]))
        return 0
    for python in words[1:]:
        print(own_environment(wheel, python))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
