"""How much memory is available, as the operating system reports it; and sizes and durations as text."""

import math
import os
import sys

from libration.cli.language import decimal


def available_bytes() -> float:
    """Bytes available: the kernel's estimate, or what the control group still allows; infinite if unknown."""
    return min(meminfo(), control_group(), physical())


def meminfo() -> float:
    """MemAvailable of /proc/meminfo."""
    for line in lines("/proc/meminfo"):
        if line.startswith("MemAvailable:"):
            return int(line.split()[1]) * 1024
    return math.inf


def control_group() -> float:
    """What remains below the memory limit of a container."""
    limit, current = lines("/sys/fs/cgroup/memory.max"), lines("/sys/fs/cgroup/memory.current")
    if limit and current and limit[0].strip().isdigit():
        return max(0, int(limit[0]) - int(current[0]))
    return math.inf


def physical() -> float:
    """All physical memory; on Windows, what of it is available."""
    if sys.platform == "win32":
        return windows()
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, OSError, ValueError):
        return math.inf


def windows() -> float:
    """Available physical memory by GlobalMemoryStatusEx."""
    if sys.platform != "win32":
        return math.inf
    import ctypes

    class Status(ctypes.Structure):
        _fields_ = [("length", ctypes.c_ulong), ("load", ctypes.c_ulong)] + [
            (name, ctypes.c_ulonglong) for name in ("total", "available", "a", "b", "c", "d", "e")
        ]

    status = Status(length=ctypes.sizeof(Status))
    ok = ctypes.windll.kernel32.GlobalMemoryStatusEx(ctypes.byref(status))
    return status.available if ok else math.inf


def lines(path: str) -> list[str]:
    """The lines of a small system file; none if it does not exist."""
    try:
        with open(path, encoding="utf-8") as file:
            return file.readlines()
    except OSError:
        return []


def bytes_text(count: float) -> str:
    """`80.0 TB`, `256 MiB` for a whole number of MiB."""
    if count < 2**40 and count % 2**20 == 0:
        return f"{int(count) // 2**20} MiB"
    for unit in ("bytes", "kB", "MB", "GB", "TB", "PB", "EB"):
        if count < 1000:
            return decimal(f"{count:.3g} {unit}")
        count /= 1000
    return decimal(f"{count:.3g} ZB")


def duration(seconds: float) -> str:
    """`3.2 s`, `5.1 min`, `2.4 h` or `13 days`."""
    for unit, size, most in (("s", 1, 120), ("min", 60, 120), ("h", 3600, 48)):
        if seconds < most * size:
            return decimal(f"{seconds / size:.2g} {unit}") if seconds < 99.5 * size else f"{seconds / size:.0f} {unit}"
    return f"{seconds / 86400:.3g} days"
