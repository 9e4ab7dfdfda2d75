"""A newcomer's first minute on one screen: an environment, the wheel into it, the first answer in Python and in the shell, each with its
seconds. No Rust, no Node and no compiler stand on the path.

    python packages/first_answer.py WHEEL [PYTHON]
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from try_wheel import ANSWER, BUILDERS


def main(wheel: str, python: str = sys.executable) -> int:
    place = Path(tempfile.mkdtemp())
    scripts = place / "swing" / ("Scripts" if os.name == "nt" else "bin")
    environment = {name: os.environ[name] for name in ("HOME", "SYSTEMROOT", "TEMP") if name in os.environ}
    environment |= {"PATH": str(scripts), "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    assert not [name for name in BUILDERS if shutil.which(name, path=environment["PATH"])]
    lines = [
        ("python -m venv swing", [python, "-m", "venv", place / "swing"]),
        (f"pip install {Path(wheel).name}", [scripts / "pip", "install", "--quiet", Path(wheel).resolve()]),
        (f'python -c "{ANSWER}"', [scripts / "python", "-c", ANSWER]),
        (
            "libration period --theta0 150deg --length 1m",
            [scripts / "libration", *"period --theta0 150deg --length 1m".split()],
        ),
    ]
    total = 0.0
    try:
        for shown, words in lines:
            print(f"$ {shown}", flush=True)
            begun = time.perf_counter()
            done = subprocess.run(words, cwd=place, env=environment, capture_output=True, text=True, encoding="utf-8")
            seconds = time.perf_counter() - begun
            total += seconds
            if done.returncode:
                raise SystemExit(done.stdout + done.stderr)
            print(done.stdout, end="")
            print(f"{seconds:79.2f} s")
    finally:
        shutil.rmtree(place)
    print(
        f"{total:79.2f} s in all, by CPython of {Path(python).name}, a wheel of {Path(wheel).stat().st_size / 1e6:.2f} MB"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
