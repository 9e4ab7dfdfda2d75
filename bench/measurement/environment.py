"""What must be known to read the numbers of a run: date, processor, load and versions."""

import datetime
import importlib.metadata
import os
import platform
import subprocess
from pathlib import Path

from rivals.compiled import version

import libration

PACKAGES = ["numpy", "scipy", "zarr", "heyoka", "elliptic-functions", "ellippy", "mpmath", "python-flint"]


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


def environment(command: str) -> dict:
    """The head of a file of results, for the command that makes it."""
    packages = {name: installed(name) for name in PACKAGES}
    return {
        "date": datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "command": command,
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
