"""The calls by which two builds are compared: every kernel at moderate inputs, and every orbit of the reference vectors.

Nothing is imported from libration here: the build to be asked is passed in.
"""

import csv
from functools import partial
from pathlib import Path

import numpy as np

VECTORS = Path(__file__).resolve().parents[2] / "reference/vectors"
COUNT = 16_384  # times of one orbit: inputs and outputs stay in the second-level cache
FEW = 2048  # states, arguments and derivatives, which cost more each
TWELVE = "sn cn dn ns nc nd sc cs sd ds cd dc".split()
ORBITS = {
    "0.1°": (0.0017453292519943296, 0.0),
    "90°": (1.5707963267948966, 0.0),
    "150°": (2.6179938779914944, 0.0),
    "170°": (2.9670597283903604, 0.0),
    "179.999°": (3.141575200297, 0.0),
    "1 − κ² = 1e-12": (0.0, 1.999999999999),
    "separatrix": (0.0, 2.0),
    "1 − κ² = −1e-12": (0.0, 2.000000000001),
    "rotation": (1.0, -3.0),
    "fast rotation": (0.5, 20.0),
}
DUFFING = {  # u0, velocity0, p, q
    "libration": (1.0, 0.3, 1.0, 1.0),
    "well": (1.2, 0.1, -1.0, 1.0),
    "homoclinic": (1.0, 0.7071067811865476, -1.0, 1.0),
    "linear": (1.0, 0.5, 1.0, 0.0),
    "escape": (1.0, 0.3, -1.0, -1.0),
}
CUBIC_QUINTIC = {  # u0, velocity0, p, q, s
    "libration": (1.0, 0.3, 1.0, 1.0, 1.0),
    "well": (1.2, 0.1, -1.0, 0.5, 1.0),
    "rising": (0.5, 0.2, 1.0, -1.0, 0.2),
    "s = 0": (1.0, 0.3, 1.0, 1.0, 0.0),
    "escape": (1.0, 0.3, -1.0, -1.0, -1.0),
}


def aligned(shape) -> np.ndarray:
    """An array of doubles that starts at a cache line, so that both builds read and write alike."""
    size = int(np.prod(shape))
    held = np.empty(size + 8)
    first = (-held.ctypes.data % 64) // 8
    return held[first : first + size].reshape(shape)


def drawn(low: float, high: float, seed: int) -> np.ndarray:
    """FEW seeded random doubles."""
    found = aligned(FEW)
    found[:] = np.random.default_rng(seed).uniform(low, high, FEW)
    return found


def calls(libration) -> dict:
    """Calls by name: what is timed and what is compared. A call returns an array, a number or a tuple of them."""
    from libration import elliptic

    t, near, out, pair = aligned(COUNT), aligned(COUNT), aligned(COUNT), (aligned(COUNT), aligned(COUNT))
    t[:], near[:] = np.linspace(-20.0, 80.0, COUNT), np.linspace(-0.4, 0.4, COUNT)
    theta0, velocity0, later, m = drawn(-3.1, 3.1, 1), drawn(-3.0, 3.0, 2), drawn(0.0, 100.0, 3), drawn(0.01, 0.99, 4)
    u, phi, x, q = drawn(-10.0, 10.0, 5), drawn(-1.5, 1.5, 6), drawn(0.1, 10.0, 7), drawn(0.0, 0.9, 8)
    y, p, action, stiff = drawn(0.1, 10.0, 9), drawn(0.1, 10.0, 10), drawn(0.0, 2.5, 11), drawn(0.1, 2.0, 12)
    complex_u = u + 0.1j * phi
    found = {}
    for name, state in ORBITS.items():
        orbit = libration.Pendulum(*state)
        found[f"Pendulum {name}: set-up"] = partial(libration.Pendulum, *state)
        found[f"Pendulum {name}: theta"] = partial(orbit.theta, t, out=out)
        found[f"Pendulum {name}: velocity"] = partial(orbit.velocity, t, out=out)
        found[f"Pendulum {name}: motion"] = partial(libration.motion, t, *state, out=pair)
        found[f"Pendulum {name}: phase"] = partial(orbit.phase, t)
        found[f"Pendulum {name}: sensitivities"] = partial(orbit.sensitivities, t[:FEW])
        found[f"Pendulum {name}: second_sensitivities"] = partial(orbit.second_sensitivities, t[: FEW // 8])
    for kind, table in {"Duffing": DUFFING, "CubicQuintic": CUBIC_QUINTIC}.items():
        for name, (a, b, *force) in table.items():
            keywords = dict(zip(("p", "q") if kind == "Duffing" else ("p", "q", "s"), force, strict=True))
            made, times = getattr(libration, kind), near if name == "escape" else t
            orbit = made(a, b, **keywords)
            found[f"{kind} {name}: set-up"] = partial(made, a, b, **keywords)
            found[f"{kind} {name}: u"] = partial(orbit.u, times, out=out)
            found[f"{kind} {name}: velocity"] = partial(orbit.velocity, times, out=out)
            found[f"{kind} {name}: motion"] = partial(orbit.motion, times)
            found[f"{kind} {name}: u of one time"] = partial(orbit.u, 0.3)
    row, rows = aligned(FEW), (aligned(FEW), aligned(FEW))
    swing = libration.Pendulum(3.0)
    found |= {
        "own states: theta": partial(libration.theta, later, theta0, velocity0, out=row),
        "own states: velocity": partial(libration.velocity, later, theta0, velocity0, out=row),
        "own states: motion": partial(libration.motion, later, theta0, velocity0, out=rows),
        "own states: advance": partial(libration.advance, theta0, velocity0, 0.3, out=rows),
        "own states: sensitivities": partial(libration.sensitivities, later, theta0, velocity0),
        "own states: action": partial(libration.action, theta0, velocity0, out=row),
        "own states: frequency": partial(libration.frequency, theta0, velocity0, out=row),
        "own states: phase": partial(libration.phase, theta0, velocity0, out=row),
        "own states: from_action_phase": partial(libration.from_action_phase, action, phi, out=rows),
        "own states: duffing_motion": partial(libration.duffing_motion, phi, theta0, 0.1, stiff, x, out=rows),
        "own states: harmonic_distortion": partial(libration.harmonic_distortion, x / 4, out=row),
        "one call: Pendulum.theta": partial(swing.theta, 0.3),
        "one call: Pendulum.motion": partial(swing.motion, 0.3),
        "one call: Pendulum.theta of 100": partial(swing.theta, t[:100], out=out[:100]),
        "one call: theta": partial(libration.theta, 0.3, 1.0),
        "one call: advance": partial(libration.advance, 1.0, 0.5, 0.3),
        "one call: jacobi": partial(libration.jacobi, 0.3, m=0.5),
        "one call: complete_k": partial(libration.complete_k, m=0.5),
        "one call: Pendulum.times": partial(swing.times, 0.5, 0.0, 100.0),
        "one call: Pendulum.fourier": partial(swing.fourier, 20),
        "jacobi, one m": partial(libration.jacobi, u, m=0.7),
        "jacobi, each its m": partial(libration.jacobi, u, m=m),
        "jacobi, each its mc": partial(libration.jacobi, u, mc=m),
        "jacobi_complex": partial(libration.jacobi_complex, complex_u, m=0.7),
        "complete_pi": partial(elliptic.complete_pi, q, m=m, out=row),
        "incomplete_pi": partial(elliptic.incomplete_pi, q, phi, m=m, out=row),
        "carlson_rc": partial(elliptic.carlson_rc, x, y, out=row),
        "carlson_rj": partial(elliptic.carlson_rj, x, y, u + 11, p, out=row),
        **{f"carlson_{s}": partial(getattr(elliptic, f"carlson_{s}"), x, y, p, out=row) for s in ("rf", "rd")},
        **{s: partial(getattr(elliptic, s), m=m, out=row) for s in ("complete_k", "complete_e", "nome")},
    }
    for name in ("incomplete_f", "incomplete_e", "heuman_lambda"):
        found[name] = partial(getattr(elliptic, name), phi, m=m, out=row)
    for name in ("jacobi_epsilon", "jacobi_zeta", *TWELVE, "theta1", "theta2", "theta3", "theta4"):
        for what, given in {"one m": 0.7, "each its m": m}.items():
            found[f"{name}, {what}"] = partial(getattr(elliptic, name), u, m=given, out=row)
    inside = {"sn": q, "cn": q, "cd": q, "sd": q, "sc": y, "cs": y, "dn": 0.6 + 0.4 * q, "nd": 1 + 0.8 * q}
    for name in TWELVE:
        found[f"arc{name}"] = partial(getattr(elliptic, f"arc{name}"), inside.get(name, 1 + y), m=0.7, out=row)
    return found


def attributes(libration) -> dict:
    """Results that are compared and not timed: the attributes of every orbit of the reference vectors."""
    ends = ("regime", "period", "energy")
    kinds = {  # class: vectors, arguments, keywords, attributes
        "Pendulum": (
            *("pendulum", ("theta0", "velocity0"), ("omega2",)),
            (*ends, "theta_max", "energy_ratio", "energy_ratio_c", "omega0", "action", "frequency"),
        ),
        "Duffing": ("duffing", ("u0", "velocity0"), ("p", "q"), (*ends, "range", "escape_time")),
        "CubicQuintic": (
            *("cubic_quintic", ("u0", "velocity0"), ("p", "q", "s")),
            (*ends, "range", "escape_time", "escape_time_backward"),
        ),
    }

    def column(kind: str, attribute: str) -> np.ndarray:
        file, arguments, keywords, _ = kinds[kind]
        with (VECTORS / f"{file}.csv").open(encoding="utf-8", newline="") as lines:
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        made = getattr(libration, kind)
        orbits = [made(*(number(row[x]) for x in arguments), **{x: number(row[x]) for x in keywords}) for row in rows]
        return np.array([getattr(orbit, attribute) for orbit in orbits])

    return {f"{kind}.{name}": partial(column, kind, name) for kind, held in kinds.items() for name in held[3]}


def number(text: str) -> float:
    """A double written in decimal or as a hexadecimal float."""
    return float.fromhex(text) if "0x" in text else float(text)
