"""The benchmark: every section, its raw rounds into bench/results/, then docs/benchmarks.md with its pictures.

    python bench/run.py                 what `make bench` runs
    python bench/run.py --full          more horizons, orbits and slow rivals to their limit: `make bench-full`
    python bench/run.py orbits steps    these sections only; the page is not written, its sections being of one run

Exit status 1 if a demand (demands.py) is missed.
"""

import os

os.environ["LIBRATION_NUM_THREADS"] = "1"  # one thread unless said: threads.py says otherwise, in its own processes

import argparse
import datetime
import importlib.metadata
import json
import platform
import subprocess
import sys
import time
from pathlib import Path

import page
from rivals.compiled import version
from sections import SECTIONS, strict

import libration

PACKAGES = ["numpy", "scipy", "heyoka", "elliptic-functions", "mpmath", "python-flint"]


def installed(package: str) -> str:
    """The version of a package, or `not available`."""
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "not available"


def processor() -> str:
    """The processor by its own name, with what matters of its instruction sets."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.processor() or platform.machine()
    lines = dict(line.split(":", 1) for line in text.splitlines() if ":" in line)
    held = {name.strip(): value.strip() for name, value in lines.items()}
    sets = [word for word in ("avx2", "fma", "avx512f") if word in held.get("flags", "").split()]
    family = [f"{what} {held[what]}" for what in ("cpu family", "model") if what in held]
    return ", ".join([held.get("model name", platform.machine()), *family, *sets])


def compiler() -> str:
    """The first line of the compiler's own version."""
    try:
        return subprocess.run(["g++", "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    except (OSError, IndexError):
        return "not available"


def header(full: bool) -> dict:
    """What must be known to read the numbers."""
    packages = {name: installed(name) for name in PACKAGES}
    return {
        "date": datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "command": "make bench-full" if full else "make bench",
        "processor": processor(),
        "processors available": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "load at the start": round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None,
        "system": f"{platform.system()} {platform.machine()}",
        "versions": {
            "libration": libration.__version__,
            "Python": platform.python_version(),
            **packages,
            "GSL": version("gsl"),
            "Boost": version("boost"),
            "C++ compiler": compiler(),
        },
    }


def main() -> int:
    """Run the sections, write what they gave, and the page if all of them ran."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sections", nargs="*", metavar="section", help=", ".join(SECTIONS))
    parser.add_argument("--full", action="store_true")
    options = parser.parse_args()
    if unknown := set(options.sections) - set(SECTIONS):
        parser.error(f"no section {', '.join(sorted(unknown))}: {', '.join(SECTIONS)}")
    page.RESULTS.mkdir(exist_ok=True)
    head, begun = header(options.full), time.monotonic()
    for name in options.sections or SECTIONS:
        print(f"{name}: {SECTIONS[name].__doc__}", flush=True)
        started = time.monotonic()
        records = SECTIONS[name](options.full)
        held = {"section": name, **head, "minutes": round((time.monotonic() - started) / 60, 2), "records": records}
        text = json.dumps(strict(held), ensure_ascii=False, indent=1)
        (page.RESULTS / f"{name}.json").write_text(text + "\n", encoding="utf-8")
    print(f"{(time.monotonic() - begun) / 60:.1f} minutes")
    return 0 if options.sections else page.main()


if __name__ == "__main__":
    sys.exit(main())
