"""GSL and Boost, each through a small C++ driver compiled here with -O3 -march=native.

Debian packages: libgsl-dev, libboost-math-dev. A library or a compiler that is missing makes the rival not available.
"""

import ctypes
import functools
import shutil
import subprocess
from pathlib import Path

import numpy as np

from .method import Call, Method, NotAvailable

HERE = Path(__file__).parent
BUILD = HERE / "build"
FLAGS = ["-std=c++17", "-O3", "-march=native", "-shared", "-fPIC"]
LIBRARIES = {"gsl": ["-lgsl", "-lgslcblas"], "boost": []}
POINTER = np.ctypeslib.ndpointer(np.float64, flags="C_CONTIGUOUS")


@functools.cache
def driver(name: str) -> ctypes.CDLL:
    """The compiled driver of a library.

    Raises
    ------
    NotAvailable
        With the first error of the compiler.
    """
    compiler = shutil.which("g++")
    if compiler is None:
        raise NotAvailable("g++")
    BUILD.mkdir(exist_ok=True)
    target = BUILD / f"{name}.so"
    command = [compiler, *FLAGS, str(HERE / f"{name}.cpp"), "-o", str(target), *LIBRARIES[name]]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        said = done.stderr.partition("error: ")[2].splitlines()  # without the path of the source file
        raise NotAvailable((said or [name])[0])
    library = ctypes.CDLL(str(target))
    library.version.restype = ctypes.c_char_p
    library.version()
    for function, kinds in (("one_orbit", [ctypes.c_double] * 2), ("own_states", [POINTER] * 2)):
        getattr(library, function).restype = None
        getattr(library, function).argtypes = [ctypes.c_long, *kinds, POINTER, POINTER, POINTER]
    return library


def version(name: str) -> str:
    """The version compiled in, or `not available`."""
    try:
        return driver(name).version().decode().replace("_", ".")
    except NotAvailable:
        return "not available"


def orbit_by(name: str):
    """Preparation of one orbit."""

    def prepare(orbit, t) -> Call:
        run, theta, velocity = driver(name).one_orbit, np.empty_like(t), np.empty_like(t)

        def call():
            run(len(t), orbit.theta0, orbit.velocity0, t, theta, velocity)
            return theta, velocity

        return call

    return prepare


def states_by(name: str):
    """Preparation of states of their own; a single step is given to all of them."""

    def prepare(theta0, velocity0, t) -> Call:
        times = np.ascontiguousarray(np.broadcast_to(t, theta0.shape), dtype=float)
        run, theta, velocity = driver(name).own_states, np.empty_like(theta0), np.empty_like(theta0)

        def call():
            run(len(theta0), theta0, velocity0, times, theta, velocity)
            return theta, velocity

        return call

    return prepare


GSL = Method("GSL, C", orbit=orbit_by("gsl"), states=states_by("gsl"), advance=states_by("gsl"))
BOOST = Method("Boost.Math, C++", orbit=orbit_by("boost"), states=states_by("boost"), advance=states_by("boost"))
