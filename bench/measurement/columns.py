"""Arrays of 100,000 rows, each with numbers of its own, on one thread: libration beside the fastest peer that has the function.

Where no library has a function, the peer is np.cos of a million doubles in order, and the times are of one value each. A limit that is
stated for a machine on which np.cos takes 8 ns a value is so one for every machine. The inputs are moderate and random; the errors
at hard ones are on the pages accuracy.md and elliptic.md.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from cases.orbits import SEED
from rivals.elliptic_family import TWELVE, ellippy
from scipy import special

import libration
from libration import elliptic

COUNT = 100_000
MILLION = 10**6
COSINE = "np.cos"
THETAS = ("theta1", "theta2", "theta3", "theta4")


@dataclass(frozen=True)
class Column:
    """One function of columns.

    Parameters
    ----------
    work : str
        As the page calls it.
    call : callable
        Ours, into an array that is kept.
    peer : str
        The other library's function.
    theirs : callable
        The call of it.
    limit : float
        The largest time of ours, theirs being 1, a row of each.
    rows : int
        How many values the other call computes.
    """

    work: str
    call: Callable[[], object]
    peer: str
    theirs: Callable[[], object]
    limit: float
    rows: int = COUNT


def drawn(count: int) -> dict[str, np.ndarray]:
    """Random columns by name: parameters, arguments, angles, sides of Carlson's integrals, states and springs."""
    ranges = {
        "m": (0.0, 1.0),
        "u": (-10.0, 10.0),
        "phi": (-1.5, 1.5),
        "n": (-1.0, 0.9),
        "q": (0.0, 0.95),
        "x": (0.1, 10.0),
        "y": (0.1, 10.0),
        "z": (0.1, 10.0),
        "p": (0.1, 10.0),
        "theta": (-3.14, 3.14),
        "velocity": (-3.0, 3.0),
        "t": (0.0, 100.0),
        "action": (0.0, 2.5),
        "phase": (-3.14, 3.14),
        "stiffness": (-3.0, 3.0),
        "cubic": (0.1, 3.0),
        "inside": (0.01, 0.99),
        "outside": (1.01, 9.0),
        "quadratic": (-1.0, 1.0),
        "constant": (-1.0, 1.0),
    }
    generator = np.random.default_rng(SEED)
    return {name: generator.uniform(low, high, count) for name, (low, high) in ranges.items()}


def beside_peers(c: dict[str, np.ndarray], out: np.ndarray) -> list[Column]:
    """Functions that another library has."""
    m, u, phi, n = c["m"], c["u"], c["phi"], c["n"]
    sides = c["x"], c["y"], c["z"]
    four = tuple(np.empty_like(out) for _ in range(4))
    amplitude = special.ellipj(u, m)[3]
    found = [
        Column("K(m)", partial(elliptic.complete_k, m=m, out=out), "SciPy ellipk", partial(special.ellipk, m), 0.4),
        Column("E(m)", partial(elliptic.complete_e, m=m, out=out), "SciPy ellipe", partial(special.ellipe, m), 0.4),
        Column(
            *("sn, cn, dn, am", partial(libration.jacobi, u, m=m)),
            *("SciPy ellipj", partial(special.ellipj, u, m, out=four), 1 / 8),
        ),
    ]
    for work, call, name, arguments in (
        ("F(φ, m)", partial(elliptic.incomplete_f, phi, m=m, out=out), "ellipf", (phi, m)),
        ("E(φ, m)", partial(elliptic.incomplete_e, phi, m=m, out=out), "ellipeinc", (phi, m)),
        ("R_F", partial(elliptic.carlson_rf, *sides, out=out), "elliprf", sides),
        ("R_C", partial(elliptic.carlson_rc, *sides[:2], out=out), "elliprc", sides[:2]),
        ("R_D", partial(elliptic.carlson_rd, *sides, out=out), "elliprd", sides),
        ("R_J", partial(elliptic.carlson_rj, *sides, c["p"], out=out), "elliprj", (*sides, c["p"])),
        ("Π(n, m)", partial(elliptic.complete_pi, n, m=m, out=out), "ellippi", (n, m)),
        ("Π(n, φ, m)", partial(elliptic.incomplete_pi, n, phi, m=m, out=out), "ellippiinc", (phi, n, m)),
        ("Heuman's Λ(φ, m)", partial(elliptic.heuman_lambda, phi, m=m, out=out), "heuman_lambda", (phi, m)),
        # Of the angle am u, which ours finds first.
        ("Zeta(u, m)", partial(elliptic.jacobi_zeta, u, m=m, out=out), "jacobi_zeta", (amplitude, m)),
    ):
        found.append(Column(work, call, f"ellippy {name}", partial(ellippy(name), *arguments), 0.5))
    return found


def beside_cosine(c: dict[str, np.ndarray], out: np.ndarray) -> list[Column]:
    """Functions that no other library has for arrays."""
    # In order, as the times of an orbit are: in random order np.cos takes twice as long.
    many = np.linspace(0.0, 100.0, MILLION)
    cosine = partial(np.cos, many, out=np.empty(MILLION))
    state, pair = (c["theta"], c["velocity"]), (out, np.empty_like(out))
    springs, even = (c["t"], *state, c["stiffness"], c["cubic"]), {"r": c["quadratic"], "c": c["constant"]}
    calls: dict[str, tuple[Callable, float]] = {"nome": (partial(elliptic.nome, m=c["m"], out=out), 8)}
    for name in THETAS:
        calls[name] = partial(getattr(elliptic, name), c["u"], q=c["q"], out=out), 80
    for name in TWELVE:
        domain = {"sc": "x", "cs": "x", "dn": "between", "nd": "beyond"}
        column = domain.get(name, "inside" if name in ("sn", "cn", "cd", "sd") else "outside")
        kc = np.sqrt(1 - c["m"])
        between = {"between": kc + (1 - kc) * c["inside"], "beyond": 1 / (kc + (1 - kc) * c["inside"])}
        argument = between[column] if column in between else c[column]
        calls[f"arc{name}"] = partial(getattr(elliptic, f"arc{name}"), argument, m=c["m"], out=out), 80
    calls |= {
        "epsilon": (partial(elliptic.jacobi_epsilon, c["u"], m=c["m"], out=out), 120),
        "`frequency`": (partial(libration.frequency, *state, out=out), 15),
        "`period`": (partial(libration.period, *state, out=out), 15),
        "`action`": (partial(libration.action, *state, out=out), 20),
        "`phase`": (partial(libration.phase, *state, out=out), 45),
        "`from_action_phase`": (partial(libration.from_action_phase, c["action"], c["phase"], out=pair), 100),
        "`sensitivities`": (partial(libration.sensitivities, c["t"], *state), 180),
        "`duffing_motion`": (
            partial(libration.duffing_motion, *springs, out=pair),
            100,
        ),
        "`duffing_motion` with r, c": (partial(libration.duffing_motion, *springs, **even, out=pair), 100),
    }
    return [Column(work, call, COSINE, cosine, limit / 8, MILLION) for work, (call, limit) in calls.items()]


def columns(count: int = COUNT) -> list[Column]:
    """Every function of columns, in the order of the page."""
    inputs, out = drawn(count), np.empty(count)
    return beside_peers(inputs, out) + beside_cosine(inputs, out)
