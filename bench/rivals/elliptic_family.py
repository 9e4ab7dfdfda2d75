"""The elliptic functions of libration, SciPy, ellippy and mpmath: how each library is asked, and the domain it states.

All but libration take the parameter m (SciPy's K also its complement), a double here; mpmath is asked at its 53 bits.
"""

import dataclasses
import math
from collections.abc import Callable
from dataclasses import dataclass

import mpmath
import numpy as np
from scipy import special

import libration
from libration import elliptic

TWELVE = "sn cn dn ns nc nd sc cs sd ds cd dc".split()
REAL = "any real m"
UNIT = "0 ≤ m ≤ 1"


@dataclass(frozen=True)
class Rival:
    """How a library is asked: the domain it states, the call, the keywords that carry the parameter, and whether the numbers
    of a row, `m` among them, are in that domain."""

    domain: str
    call: Callable
    keywords: tuple[str, ...] = ("m",)
    inside: Callable[[dict], bool] = lambda numbers: True


def unit(numbers: dict) -> bool:
    return 0 <= numbers["m"] <= 1


def up_to_one(numbers: dict) -> bool:
    return numbers["m"] <= 1


def no_pole(numbers: dict) -> bool:
    """The integrand of the third kind stays finite from 0 to phi."""
    reach = 1.0 if abs(numbers["phi"]) > math.pi / 2 else math.sin(numbers["phi"]) ** 2
    return numbers["n"] * reach <= 1


@dataclass(frozen=True)
class Function:
    """One function: its vectors, arguments, outputs and how the libraries are asked for it (None: the library has none)."""

    name: str
    file: str
    arguments: tuple[str, ...]
    outputs: tuple[str, ...]
    domain: str
    ours: Callable
    scipy: Rival | None = None
    mpmath: Rival | None = None
    label: str | None = None
    parameter: bool = True
    ellippy: Rival | None = None


def ellipj(place: int) -> Callable:
    return lambda u, m: special.ellipj(u, m)[place]


def scipy_k(*, m=None, mc=None):
    return special.ellipk(m) if mc is None else special.ellipkm1(mc)


def ellipfun(name: str) -> Callable:
    return lambda u, m: mpmath.ellipfun(name, u, m=m)


def jtheta(index: int) -> Callable:
    return lambda z, q: mpmath.jtheta(index, z, q)


def our_complex(re, im, **given) -> tuple:
    u = np.empty(np.shape(re), complex)
    u.real, u.imag = re, im
    return tuple(part for value in libration.jacobi_complex(u, **given) for part in (value.real, value.imag))


def their_complex(re, im, m) -> tuple:
    u = mpmath.mpc(re, im)
    values = [mpmath.mpc(mpmath.ellipfun(name, u, m=m)) for name in ("sn", "cn", "dn")]
    return tuple(part for value in values for part in (value.real, value.imag))


def ours(name: str) -> Callable:
    return getattr(elliptic, name)


def ellippy(name: str) -> Callable:
    """A function of ellippy, which is there only where its package is."""

    def call(*arguments, **given):
        import ellippy

        return getattr(ellippy, name)(*arguments, **given)

    return call


def below_pole(numbers: dict) -> bool:
    """1 - m sin(phi)^2 is not negative on the way from 0 to phi."""
    reach = 1.0 if abs(numbers["phi"]) > math.pi / 2 else math.sin(numbers["phi"]) ** 2
    return numbers["m"] * reach <= 1


# ellippy raises an error for a whole array where one row is outside of these domains.
ELLIPPY = {
    "complete_k": Rival("m ≤ 1", ellippy("ellipk"), inside=up_to_one),
    "complete_e": Rival("m ≤ 1", ellippy("ellipe"), inside=up_to_one),
    "incomplete_f": Rival("m sin² ≤ 1", ellippy("ellipf"), inside=below_pole),
    "incomplete_e": Rival("m sin² ≤ 1", ellippy("ellipeinc"), inside=below_pole),
    "complete_pi": Rival("m ≤ 1, n ≠ 1", ellippy("ellippi"), inside=up_to_one),
    "incomplete_pi": Rival(
        "m sin² ≤ 1, n sin² ≠ 1", lambda n, phi, m: ellippy("ellippiinc")(phi, n, m), inside=below_pole
    ),
    "heuman_lambda": Rival("0 ≤ m < 1", ellippy("heuman_lambda"), inside=lambda row: 0 <= row["m"] < 1),
    "carlson_rf": Rival("x, y, z ≥ 0", ellippy("elliprf")),
    "carlson_rc": Rival("x ≥ 0, any real y", ellippy("elliprc")),
    "carlson_rd": Rival("x, y ≥ 0, z > 0", ellippy("elliprd")),
    "carlson_rj": Rival("x, y, z ≥ 0, any real p", ellippy("elliprj")),
}


def functions() -> list[Function]:
    """Every function that another library has too."""
    found = [
        Function(
            *(name, "glaisher", ("u",), (name,), REAL, ours(name)),
            Rival(UNIT, ellipj(place), inside=unit) if place < 3 else None,
            Rival("any complex m", ellipfun(name)),
        )
        for place, name in enumerate(TWELVE)
    ]
    found.append(
        Function(
            *("am", "jacobi", ("u",), ("am",), REAL, lambda u, **given: libration.jacobi(u, **given).am),
            Rival(UNIT, ellipj(3), inside=unit),
        )
    )
    found.append(
        Function(
            *("jacobi_complex", "jacobi_complex", ("re", "im")),
            tuple(f"{name}_{part}" for name in ("sn", "cn", "dn") for part in ("re", "im")),
            *(REAL, our_complex, None, Rival("any complex m", their_complex)),
        )
    )
    for i in (1, 2, 3, 4):
        ours_domain = "0 ≤ q < 1" if i < 3 else "−1 < q < 1"
        rival = Rival("complex q in the unit disc", jtheta(i), ("q",))
        found.append(
            Function(
                f"theta{i}", "theta_functions", ("z",), (f"theta{i}",), ours_domain, ours(f"theta{i}"), None, rival
            )
        )
    found += [
        Function(
            *("complete_k", "complete", (), ("complete_k",), "m ≤ 1", ours("complete_k")),
            Rival("m ≤ 1", scipy_k, ("m", "mc"), up_to_one),
            Rival("any complex m", lambda m: mpmath.ellipk(m)),
        ),
        Function(
            *("complete_e", "complete", (), ("complete_e",), "m ≤ 1", ours("complete_e")),
            Rival("m ≤ 1", lambda m: special.ellipe(m), inside=up_to_one),
            Rival("any complex m", lambda m: mpmath.ellipe(m)),
        ),
        Function(
            *("nome", "complete", (), ("nome",), "m ≤ 1", ours("nome")),
            *(None, Rival("any complex m", lambda m: mpmath.qfrom(m=m))),
        ),
        Function(
            *("incomplete_f", "incomplete", ("phi",), ("incomplete_f",), "m sin² ≤ 1", ours("incomplete_f")),
            Rival("m ≤ 1", lambda phi, m: special.ellipkinc(phi, m), inside=up_to_one),
            Rival("any complex m", lambda phi, m: mpmath.ellipf(phi, m)),
        ),
        Function(
            *("incomplete_e", "incomplete", ("phi",), ("incomplete_e",), "m sin² ≤ 1", ours("incomplete_e")),
            Rival("m ≤ 1", lambda phi, m: special.ellipeinc(phi, m), inside=up_to_one),
            Rival("any complex m", lambda phi, m: mpmath.ellipe(phi, m)),
        ),
        Function("heuman_lambda", "heuman", ("phi",), ("lambda",), "0 ≤ m ≤ 1", ours("heuman_lambda")),
        Function(
            *("complete_pi", "third_kind", ("n",), ("value",), "m < 1, any real n", ours("complete_pi"), None),
            Rival("complex; for n > 1 not real", lambda n, m: mpmath.ellippi(n, m), inside=lambda row: row["n"] <= 1),
            "complete_pi",
        ),
        Function(
            *(
                "incomplete_pi",
                "third_kind",
                ("n", "phi"),
                ("value",),
                "m sin² ≤ 1, any real n",
                ours("incomplete_pi"),
                None,
            ),
            Rival("complex; for n sin² > 1 not real", lambda n, phi, m: mpmath.ellippi(n, phi, m), inside=no_pole),
            "incomplete_pi",
        ),
    ]
    carlson = (("rf", "xyz"), ("rc", "xy"), ("rd", "xyz"), ("rj", "xyzp"))
    domains = ("x, y, z ≥ 0", "x ≥ 0, any real y", "x, y, z ≥ 0", "x, y, z ≥ 0, any real p")
    for (name, arguments), domain in zip(carlson, domains, strict=True):
        theirs = "complex; for p < 0 not real" if name == "rj" else "complex"
        found.append(
            Function(
                *(f"carlson_{name}", "carlson", tuple(arguments), ("value",), domain, ours(f"carlson_{name}")),
                Rival("the same, and complex", getattr(special, f"ellip{name}")),
                Rival(theirs, getattr(mpmath, f"ellip{name}"), inside=lambda row, n=name: n != "rj" or row["p"] >= 0),
                *(name, False),
            )
        )
    return [dataclasses.replace(function, ellippy=ELLIPPY.get(function.name)) for function in found]
