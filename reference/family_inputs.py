"""The inputs of the vectors of the elliptic family: parameters in every range, arguments where the functions are hard to compute.

Built from bits and IEEE operations, like elliptic_inputs.py. Arguments such as n K are rounded from 60 digits.
"""

import math
import random
from fractions import Fraction

import ends_inputs
import mpmath as mp
import nome_inverse
from elliptic import jacobi_evaluate, parameters
from elliptic_inputs import either, log_uniform, neighbours, sign
from exact import mpf, real
from family import GLAISHER
from integrals import CARLSON

SEED = 2
BELOW, ABOVE = math.nextafter(1.0, 0.0), math.nextafter(1.0, 2.0)


def above(rng):
    return rng.choice((1 + log_uniform(rng, -50, 0), either(rng, (1, 10), (10, 99))))


PARAMETERS = {  # stratum: fixed values, random draws
    "m_zero": ([("m", 0.0), ("k", 0.0), ("mc", 1.0)], lambda rng: ("m", 0.0)),
    "m_tiny": (
        [("m", 1e-300), ("m", -1e-300), ("k", 1e-100), ("m", 2.0**-53), ("mc", BELOW), ("mc", ABOVE), ("m", -1e-30)],
        lambda rng: ("m", sign(rng) * either(rng, (-997, -60), (-60, -10))),
    ),
    "m_unit": (
        [*(("m", x) for x in neighbours(0.5, 1)), ("m", 0.1), ("mc", 0.25), ("k", -0.5), ("m", 0.99)],
        lambda rng: (rng.choice(("m", "mc", "k")), rng.random()),
    ),
    "mc_small": (
        [("mc", 1e-300), ("mc", 1e-100), ("mc", 1e-16), ("m", BELOW), ("k", BELOW), ("mc", 1e-8), ("mc", 1e-3)],
        lambda rng: ("mc", either(rng, (-997, -60), (-60, -10))),
    ),
    "m_one": ([("m", 1.0), ("mc", 0.0), ("k", -1.0)], lambda rng: ("m", 1.0)),
    "m_negative": (
        [("m", -1.0), ("m", -1e30), ("m", -0.5), ("mc", 1e30), ("m", -3.0), ("m", -1e16), ("mc", 2.0)],
        lambda rng: rng.choice((("m", -either(rng, (-10, 1), (1, 99))), ("mc", above(rng)))),
    ),
    "m_above": (
        [("m", ABOVE), ("m", 1e30), ("m", 2.0), ("mc", -1e-300), ("mc", -1e-16), ("k", -1.5), ("m", 1e16)],
        lambda rng: rng.choice(
            (("m", above(rng)), ("k", math.sqrt(above(rng))), ("mc", -either(rng, (-997, -60), (-60, 0), (0, 99))))
        ),
    ),
}
EVERY = list(PARAMETERS)
UP_TO_ONE = [stratum for stratum in EVERY if stratum != "m_above"]


def drawn(name, stratum, count):
    """A generator of random numbers and count parameters: every fixed one first."""
    rng = random.Random(f"{SEED} {name} {stratum}")
    fixed, draw = PARAMETERS[stratum]
    return rng, [*fixed, *(draw(rng) for _ in range(count - len(fixed)))][:count]


def quarter(given, parameter):
    """The distance of zeros on the real line: K for m < 1, K(1/m)/sqrt(m) for m > 1; 1 at m = 1."""
    m, mc = parameters(given, parameter)
    with mp.workdps(60):
        if m == 1:
            return mpf(1)
        return mp.elliprf(0, real(mc), 1) if m < 1 else mp.elliprf(0, real(-mc / m), 1) / mp.sqrt(real(m))


def item(stratum, **cells):
    return {"stratum": stratum} | {key: x if isinstance(x, str) else float(x).hex() for key, x in cells.items()}


def close_to(rng, x):
    """The double nearest to x and some at small relative distances."""
    x = float(x)
    return [x, math.nextafter(x, math.inf), x * (1 + sign(rng) * log_uniform(rng, -50, -6))]


def real_arguments(rng, given, parameter, i, far=2.0**30):
    """u: tiny, small, of the size of K, thousands and billions of periods, at and next to n K."""
    K = quarter(given, parameter)
    one = parameters(given, parameter)[0] == 1
    unit = float(K)
    yield sign(rng) * either(rng, (-997, -900), (-900, -30))
    yield sign(rng) * unit * log_uniform(rng, -30, -1)
    yield sign(rng) * unit * 2 * rng.random()
    yield sign(rng) * unit * log_uniform(rng, 1, 6)
    if one:
        yield from (sign(rng) * 30 * rng.random(), sign(rng) * rng.uniform(300, 720))
        if given == "mc":
            yield from (800.0, -1e9)
        return
    yield sign(rng) * unit * log_uniform(rng, 10, 13)
    yield sign(rng) * unit * far * (1 + rng.random())
    n = (1, 2, 3, 4, 1001, 2**30 + i)[i % 6]
    yield from (sign(rng) * x for x in close_to(rng, n * K))
    yield sign(rng) * float(K) * (i % 2 + 1) * (1 + sign(rng) * log_uniform(rng, -8, -2))


def glaisher():
    for stratum in EVERY:
        rng, values = drawn("glaisher", stratum, 9 if stratum != "m_one" else 4)
        for i, (given, parameter) in enumerate(values):
            for u in real_arguments(rng, given, parameter, i):
                yield item(stratum, given=given, parameter=parameter, u=u)
        for given, parameter in values[:2]:
            for u in (0.0, -0.0):
                yield item("signed_zero", given=given, parameter=parameter, u=u)


def second_kind():
    for stratum in EVERY:
        rng, values = drawn("second kind", stratum, 10 if stratum != "m_one" else 4)
        for i, (given, parameter) in enumerate(values):
            for u in real_arguments(rng, given, parameter, i):
                yield item(stratum, given=given, parameter=parameter, u=u)
        for u in (0.0, -0.0):
            yield item("signed_zero", given=values[0][0], parameter=values[0][1], u=u)


def jacobi_value(name, u, m, mc):
    """pq(u | m) at 60 digits, through the real amplitude."""
    with mp.workdps(400):
        sn, cn, dn, _ = jacobi_evaluate(u, m, mc)
        part = {"s": sn, "c": cn, "d": dn, "n": mpf(1)}
        return part[name[0]] / part[name[1]]


def inverses():
    """Values of the function itself over its branch, the ends of its range and what lies beyond, tiny and huge x."""
    for name in GLAISHER:
        for stratum in EVERY:
            count = 6 if stratum in ("m_zero", "m_one") else 10
            rng, values = drawn(f"arc{name}", stratum, count)
            for i, (given, parameter) in enumerate(values):
                m, mc = parameters(given, parameter)
                K = quarter(given, parameter)
                share = [rng.random(), log_uniform(rng, -30, -3), 1 - log_uniform(rng, -25, -3)][i % 3]
                if i % 2 and "s" not in name:
                    share = 2 - share
                with mp.workdps(60):
                    u = float(K * share) * (3 if m == 1 else 1)
                x = float(jacobi_value(name, Fraction(u), m, mc))
                yield item(
                    stratum, function=name, given=given, parameter=parameter, x=x * sign(rng) if "s" in name else x
                )
                if i == 0:
                    yield item(stratum, function=name, given=given, parameter=parameter, x=-x)
            ends = [1.0, BELOW, ABOVE, 0.0, -1.0, 1e-300, -1e-20, 1e15, -1e300]
            for i, x in enumerate(ends):
                given, parameter = values[(i * 3 + 1) % len(values)]
                yield item("range_end", function=name, given=given, parameter=parameter, x=x)
    for name, square in (("dn", 1), ("nd", -1), ("sd", -1), ("ds", 1)):  # an end at a power of sqrt(mc)
        for mc, root in ((0.25, 0.5), (0.0625, 0.25), (4.0, 2.0)):
            end = root**square
            for x in neighbours(end, 1):
                yield item("range_end", function=name, given="mc", parameter=mc, x=x)
    for name, square in (("sn", -1), ("ns", 1)):  # and of sqrt(m) > 1
        for m, root in ((4.0, 2.0), (16.0, 4.0)):
            for x in neighbours(root**square, 1):
                yield item("range_end", function=name, given="m", parameter=m, x=x)


def theta_functions():
    rng = random.Random(f"{SEED} theta")
    nomes = [0.0, 1e-300, 1e-16, 0.1, 0.5, 0.9, 0.99, 0.999, 1 - 1e-6, 1 - 1e-10, BELOW, -1e-300, -0.3, -0.9, -0.999]
    nomes += [math.exp(-math.pi), *(rng.random() for _ in range(12)), *(-rng.random() for _ in range(4))]
    nomes += [*(log_uniform(rng, -900, -3) for _ in range(4)), *(1 - log_uniform(rng, -33, -3) for _ in range(6))]
    values = [("q", q) for q in nomes]
    for stratum in UP_TO_ONE:
        if stratum != "m_one":
            values += drawn("theta", stratum, 4)[1]
    for i, (given, parameter) in enumerate(values):
        stratum = f"{given}_given"
        for z in (
            sign(rng) * either(rng, (-997, -900), (-60, -3)),
            sign(rng) * rng.random() * 4,
            sign(rng) * log_uniform(rng, 2, 10),
            sign(rng) * log_uniform(rng, 29, 31),
            sign(rng) * (1, 2, 3, 4, 1001, 2**31 + 1)[i % 6] * math.pi / 2,
            sign(rng) * (i % 3 + 1) * math.pi / 2 * (1 + sign(rng) * log_uniform(rng, -50, -6)),
            sign(rng) * (i % 2 + 1) * math.pi / 2 * (1 + sign(rng) * log_uniform(rng, -40, -2)),
        ):
            yield item(stratum, given=given, parameter=parameter, z=z)
        if i < 8:
            yield item("zero", given=given, parameter=parameter, z=0.0)
    for given, parameter in (("q", 1.0), ("q", -1.0), ("q", 1.5), ("m", 1.0), ("mc", 0.0), ("m", 2.0), ("k", -1.0)):
        yield item("outside", given=given, parameter=parameter, z=0.5)


def heuman():
    for stratum in ("m_zero", "m_tiny", "m_unit", "mc_small", "m_one"):
        rng, values = drawn("heuman", stratum, 24)
        for i, (given, parameter) in enumerate(values):
            if not 0 <= parameters(given, parameter)[0] <= 1:
                continue
            n = (1, 2, 3, 1001, 2**30 + 1)[i % 5]
            for phi in (
                sign(rng) * either(rng, (-997, -900), (-60, -3)),
                sign(rng) * rng.random() * math.pi / 2,
                sign(rng) * log_uniform(rng, 1, 12),
                sign(rng) * n * math.pi / 2,
                sign(rng) * (math.pi / 2 - log_uniform(rng, -40, -2)),
            ):
                yield item(stratum, given=given, parameter=parameter, phi=phi)
        for phi in (0.0, -0.0, math.nextafter(math.pi / 2, 4.0), 1e9):
            yield item("fixed", given=values[1][0], parameter=values[1][1], phi=phi)
    for given, parameter in (("m", -0.5), ("m", ABOVE), ("mc", -1e-300), ("mc", 2.0), ("k", 1.5), ("m", 1e30)):
        yield item("outside", given=given, parameter=parameter, phi=1.0)


def carlson():
    def row(stratum, function, *x):
        return item(stratum, function=function, **dict(zip("xyzp", [*x, *[0.0] * (4 - len(x))], strict=True)))

    for function, count in CARLSON.items():
        rng = random.Random(f"{SEED} carlson {function}")

        def like(size, rng=rng, count=count):
            return [size * rng.uniform(0.1, 10) for _ in range(count)]

        for _ in range(40):
            yield row("moderate", function, *like(1.0))
        for _ in range(50):
            yield row("wide", function, *(log_uniform(rng, -332, 332) for _ in range(count)))
        for _ in range(20):
            yield row("scaled", function, *like(log_uniform(rng, -332, 332)))
        for i in range(24):
            x = [log_uniform(rng, -40, 40) for _ in range(count)]
            x[i % (2 if function in ("rd", "rc") else 3) if function != "rc" else 0] = 0.0
            yield row("one_zero", function, *x)
        for i in range(30):
            a, b = log_uniform(rng, -60, 60), log_uniform(rng, -20, 20)
            x = [a] * count
            if i % 3 == 1:
                x[i % count] = b
            elif i % 3 == 2:
                x = [a * (1 + sign(rng) * log_uniform(rng, -50, -3)) for _ in range(count)]
            yield row("equal", function, *x)
        for _ in range(12):
            yield row("edge_of_range", function, *(log_uniform(rng, -1020, 1020) for _ in range(count)))
        if function in ("rc", "rj"):
            for i in range(60):
                x = [log_uniform(rng, *((-3, 3), (-40, 40), (-332, 332))[i % 3]) for _ in range(count)]
                x[-1] = -x[-1]
                if i % 10 == 9:
                    x[0] = 0.0
                if i % 10 == 8:
                    x = [x[0]] * (count - 1) + [x[-1]]
                yield row("principal", function, *x)
            for i in range(12):  # next to a zero of the principal value: R_C has none, R_J changes sign
                x = [1 + rng.random() for _ in range(count - 1)]
                yield row("principal", function, *x, -x[i % (count - 1)] * (1 + sign(rng) * log_uniform(rng, -50, -2)))
        edges = {
            "rf": [(0, 0, 1), (0, 0, 0), (-1, 1, 1), (1, math.inf, 2), (math.nan, 1, 1)],
            "rc": [
                (1, 0),
                (0, 0),
                (-1, 1),
                (0, -1),
                (0, 1),
                (1, math.inf),
                (1, -math.inf),
                (math.inf, 1),
                (1, math.nan),
            ],
            "rd": [(0, 0, 1), (1, 1, 0), (0, 1, 0), (1, 1, -1), (-1, 1, 1), (math.inf, 1, 1), (1, 1, math.inf)],
            "rj": [
                (0, 0, 1, 1),
                (1, 1, 1, 0),
                (-1, 1, 1, 1),
                (1, 2, 3, math.inf),
                (1, 2, 3, -math.inf),
                (1, 1, math.nan, 1),
            ],
        }
        for edge in edges[function]:
            yield row("edge", function, *edge)


def characteristics(rng, given, parameter):
    """n: huge and negative, tiny, in (0, 1), next to 1, m itself, beyond 1."""
    m = parameters(given, parameter)[0]
    yield -1e30
    yield -either(rng, (-60, 0), (0, 10), (10, 90))
    yield rng.choice((0.0, 1e-300, -1e-20, 1e-10))
    yield rng.random()
    yield rng.choice((BELOW, 1 - log_uniform(rng, -50, -5)))
    if abs(m) < 10**100:
        yield float(m)
    yield 1 + rng.random()
    yield rng.choice((ABOVE, 1 + log_uniform(rng, -50, -5)))
    yield either(rng, (1, 10), (10, 99))


def third_kind():
    for stratum in UP_TO_ONE:
        if stratum == "m_one":
            continue
        rng, values = drawn("complete pi", stratum, 5)
        for given, parameter in values:
            for n in characteristics(rng, given, parameter):
                yield item(stratum, function="complete_pi", given=given, parameter=parameter, n=n, phi=0.0)
    for given, parameter, n in (
        *(("m", 0.5, 1.0), ("m", -2.0, 1.0), ("m", 1.0, 0.5), ("mc", 0.0, -3.0), ("m", 1.0, 2.0), ("m", 2.0, 0.5)),
        *(("m", 1.5, 3.0), ("k", -2.0, -1.0), ("m", 1.0, 1.0)),
    ):
        yield item("edge", function="complete_pi", given=given, parameter=parameter, n=n, phi=0.0)
    for stratum in EVERY:
        rng, values = drawn("incomplete pi", stratum, 6 if stratum not in ("m_one", "m_zero") else 3)
        for given, parameter in values:
            m = parameters(given, parameter)[0]
            with mp.workdps(60):
                edge = float(mp.asin(1 / mp.sqrt(real(m)))) if m > 1 else math.pi / 2
            for i, n in enumerate(characteristics(rng, given, parameter)):
                angles = [rng.random() * edge, edge * log_uniform(rng, -900 if i % 4 == 0 else -20, -1)]
                if m > 1:
                    n = n * float(m) if n > 1 and n * float(m) < 1e300 else n
                    angles += [edge * (1 - log_uniform(rng, -45, -2))]
                else:
                    angles += [edge - log_uniform(rng, -45, -4), edge * log_uniform(rng, 1, 4 if i % 2 else 30)]
                if n > 1:  # both sides of the pole of the integrand
                    with mp.workdps(60):
                        pole = float(mp.asin(1 / mp.sqrt(mpf(n))))
                    angles[0] = pole * (1 + sign(rng) * log_uniform(rng, -50, -3))
                angle = angles[(i + len(stratum)) % len(angles)] if i % 3 else angles[0]
                for phi in {angle, angles[-1]}:
                    yield item(
                        stratum, function="incomplete_pi", given=given, parameter=parameter, n=n, phi=sign(rng) * phi
                    )
        given, parameter = values[0]
        for phi in (0.0, -0.0):
            yield item("signed_zero", function="incomplete_pi", given=given, parameter=parameter, n=0.5, phi=phi)
    for m, n, phi in ((2.0, 0.5, 1.0), (2.0, 3.0, -1.5), (0.5, 1.0, 2.0), (1.0, 0.5, 2.0), (1.0, 3.0, -2.0)):
        yield item("edge", function="incomplete_pi", given="m", parameter=m, n=n, phi=phi)


def jacobi_complex():
    for stratum in EVERY:
        rng, values = drawn("complex", stratum, 7 if stratum != "m_one" else 3)
        for i, (given, parameter) in enumerate(values):
            m, mc = parameters(given, parameter)
            with mp.workdps(60):
                K = quarter(given, parameter)
                if m in (0, 1):
                    K, height = (mp.pi / 2, mpf(1)) if m == 0 else (mpf(1), mp.pi / 2)
                elif m < 0:  # poles at K + i K'
                    height = mp.elliprf(0, real(-m / mc), 1) / mp.sqrt(real(mc))
                elif m < 1:
                    height = mp.elliprf(0, real(m), 1)
                else:
                    height = mp.elliprf(0, real(1 / m), 1) / mp.sqrt(real(m))
                columns = 0 if m > 0 else 1
                pole = (float(2 * K * (i % 3) + columns * K), float(height))
            a, b = float(K), min(float(height), 300.0)
            for right, up in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
                re, im = right * 2 * a * rng.random(), up * b * rng.random()
                yield item(stratum, given=given, parameter=parameter, re=re, im=im)
            size = log_uniform(rng, -40, -4)
            x, y = rng.choice(((size, size), (0.0, size), (size, 0.0), (size, -size / 3)))
            many = 0 if m == 1 else (0, 1000, 2**28)[i % 3]
            points = [(pole[0] + x * a, pole[1] + y * b)] if m != 0 else []
            points += [
                (a * log_uniform(rng, -900, -800), b * log_uniform(rng, -30, -1)),
                (a * log_uniform(rng, -30, -1), b * log_uniform(rng, -900, -800)),
                (0.0, b * rng.random()),
                (a * 3 * rng.random(), 0.0),
                (a * (many + rng.random()) * 2, b * rng.random() if m == 0 else b * (many + rng.random()) * 2),
                (a * (i % 4), b * rng.random()),
            ]
            for re, im in points:
                yield item(stratum, given=given, parameter=parameter, re=sign(rng) * re, im=sign(rng) * im)
        given, parameter = values[0]
        yield item("zero", given=given, parameter=parameter, re=0.0, im=0.0)
    for im in (400.0, -709.0, 720.0, 1e5):  # beyond the range of doubles
        for parameter, re in ((0.0, 1.25), (1e-300, -0.75)):
            yield item("overflow", given="m", parameter=parameter, re=re, im=im)


def rows(name):
    draw = {
        "glaisher.csv": glaisher,
        "inverse_jacobi.csv": inverses,
        "second_kind.csv": second_kind,
        "theta_functions.csv": theta_functions,
        "heuman.csv": heuman,
        "carlson.csv": carlson,
        "third_kind.csv": third_kind,
        "jacobi_complex.csv": jacobi_complex,
        "glaisher_complex.csv": lambda: [row for row in rows("jacobi_complex.csv") if row["stratum"] != "zero"][::3],
        "from_nome.csv": nome_inverse.nomes,
    }[name]
    return [*draw(), *ends_inputs.rows(name)]
