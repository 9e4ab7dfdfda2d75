"""Writes vectors/cubic_quintic.csv: the exact motion u'' + alpha u + beta u^3 + gamma u^5 = 0 by Taylor series.

Run: python cubic_quintic.py
"""

from fractions import Fraction
from itertools import groupby
from itertools import product as pairs

import energy
import exact
import oscillator
from oscillator_inputs import Draw, first, instants, numbered, product, root

NAME = "cubic_quintic.csv"
INPUTS = "u0 velocity0 alpha beta gamma t".split()
HEADER = ["id", "stratum", *INPUTS, *oscillator.OUTPUTS]
NEAR = [1e-3, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12]


def regime(orbit):
    return oscillator.regime(*orbit[:2], orbit[2:])


def by_signs(draw, signs, each):
    """Random starts for one pattern of signs, at most `each` orbits of every regime that turns up in 40 draws."""
    seen = {}
    for _ in range(40):
        force = [sign * draw.number() if sign else 0.0 for sign in signs]
        orbit = draw.sign() * draw.number(-3, 1), draw.sign() * draw.number(-3, 2), *force
        name = regime(orbit)
        seen[name] = seen.get(name, 0) + 1
        if seen[name] <= each:
            yield orbit


def signs(draw):
    for pattern in pairs((1, -1), repeat=3):
        yield from by_signs(draw, pattern, 3)


def zeros(draw):
    for pattern in pairs((1, 0, -1), repeat=3):
        if 0 in pattern and any(pattern[1:]):
            yield from by_signs(draw, pattern, 1)


def potential(y, force):
    """Twice the potential energy at u^2 = y."""
    a, b, c = map(Fraction, force)
    return a * y + b * y**2 / 2 + c * y**3 / 3


def at_level(draw, u0, force, level):
    """The orbit through u0 with 2E = level."""
    return u0, draw.sign() * root(level - potential(Fraction(u0) ** 2, force)), *force


def triple(draw):
    """Coefficients of a triple well and the squares of its saddle and its outer well."""
    saddle, well, gamma = draw.number(-2, 1), draw.number(-1, 1) + 2, draw.number(-2, 1)
    return (gamma * saddle * well, -gamma * (saddle + well), gamma), saddle, well


def triple_centre(draw):
    for _ in range(6):
        force, saddle, _ = triple(draw)
        u0 = draw.sign() * root(Fraction(saddle)) * 0.8 * draw.part()
        low, top = potential(Fraction(u0) ** 2, force), potential(Fraction(saddle), force)
        yield at_level(draw, u0, force, low + (top - low) * Fraction(draw.part()))


def triple_outer(draw):
    for _ in range(6):
        force, saddle, well = triple(draw)
        u0 = draw.sign() * root(Fraction(well)) * (0.95 + 0.1 * draw.part())
        low, top = potential(Fraction(u0) ** 2, force), potential(Fraction(saddle), force)
        yield at_level(draw, u0, force, low + (top - low) * Fraction(draw.part()))


def triple_over(draw):
    for _ in range(6):
        force, saddle, well = triple(draw)
        u0 = draw.sign() * root(Fraction(well)) * draw.part()
        low, top = potential(Fraction(u0) ** 2, force), potential(Fraction(saddle), force)
        yield at_level(draw, u0, force, max(low, top) + Fraction(draw.number(-6, 2)))


def shallow(draw):
    """Saddles at +-1 between wells of very different depth, or a well so flat that the roots of G come in pairs."""
    for _k in range(4):
        saddle, gap, gamma = draw.number(-1, 1), draw.number(-20, -10), draw.number(-1, 1)
        well = saddle + gap
        force = gamma * saddle * well, -gamma * (saddle + well), gamma
        yield draw.sign() * root(Fraction(saddle)) * (0.5 + draw.part()), draw.sign() * draw.number(-8, 0), *force


def double_root(y0, d, g, c):
    """(alpha, beta, gamma) and velocity0 with G = -g (y - d)^2 (y - r), r = y0 + c^2 / g: exact for short numbers."""
    r = y0 + c * c / g
    return (g * (d * d + 2 * d * r), -2 * g * (2 * d + r), 3 * g), c * (y0 - d), r


def exact_orbits(draw, wanted, choose, count):
    """count orbits of the wanted regime from short y0 = u0^2, d, g, c that pass `choose`."""
    found = 0
    while found < count:
        u0, d, c = draw.sign() * draw.short(2), draw.short(), draw.short(2) if draw.getrandbits(2) else 0.0
        g = draw.sign() * 2.0 ** (draw.getrandbits(8) % 3 - 1)
        force, v0, r = double_root(u0 * u0, d, g, c)
        if choose(u0 * u0, d, g, r) and regime((u0, v0, *force)) == wanted:
            found += 1
            yield u0, draw.sign() * v0, *force


def homoclinic_saddle(draw):
    """Out from the saddle and back, on the outer side (gamma > 0) or on the inner side (gamma < 0)."""
    yield from exact_orbits(draw, "homoclinic", lambda y, d, g, r: g > 0 and y > d, 4)
    yield from exact_orbits(draw, "homoclinic", lambda y, d, g, r: g < 0 and 0 < r <= y < d, 3)


def heteroclinic(draw):
    """From -s to s, for both signs of gamma."""
    yield from exact_orbits(draw, "heteroclinic", lambda y, d, g, r: g > 0, 4)
    yield from exact_orbits(draw, "heteroclinic", lambda y, d, g, r: g < 0, 4)


def heteroclinic_zero(draw):
    """From 0 to s: E = 0 and a double root at d, G = |g| y (y - d)^2."""
    for k in range(4):
        u0 = draw.sign() * draw.short(2)
        # r = 0 asks for c^2 = -g y0
        c, g = abs(u0) * 2.0**k, -(4.0**k)
        force, v0, _r = double_root(u0 * u0, u0 * u0 + draw.short(), g, c)
        yield u0, draw.sign() * v0, *force


def triple_root(draw):
    """G = g (d - y)^3: the saddle is degenerate and approached like a power of t."""
    for k in range(5):
        u0, c = draw.sign() * draw.short(2), draw.short(2)
        g = 2.0 ** (k % 3) * (1 if k < 3 else -1)
        d = u0 * u0 + c * c / g
        if d > 0:
            force, v0, _ = double_root(u0 * u0, d, g, c)
            yield u0, draw.sign() * v0, *force


def homoclinic_zero(draw):
    """E = 0 exactly; alpha = 0 is left and reached like a power of t."""
    found = 0
    while found < 9:
        u0, ratio = draw.sign() * 2.0 ** (draw.getrandbits(8) % 3 - 1), draw.short() if found % 3 else 0.0
        g, y = draw.sign() * draw.short(2), u0 * u0
        beta = -2 * (ratio * ratio + g * y * y) / y if found % 4 == 3 else draw.sign() * draw.short()
        orbit = u0, draw.sign() * ratio * u0, -ratio * ratio - beta * y / 2 - g * y * y, beta, 3 * g
        if regime(orbit) == "homoclinic":
            found += 1
            yield orbit


def separatrix_escape(draw):
    """Escape one way, an unstable equilibrium the other way."""
    yield from exact_orbits(draw, "escape", lambda y, d, g, r: g < 0 and y > d > r, 4)


def near(draw, generator):
    """Next to the exact separatrices: the velocity moved on one half, alpha on the other."""
    for k, (distance, side) in enumerate(pairs(NEAR, (-1, 1))):
        while True:
            u0, v0, alpha, beta, gamma = first(generator(draw), 1 + draw.getrandbits(8) % 4)[-1]
            if v0:
                break
        moved = 1 + side * Fraction(distance)
        if k // 2 % 2:
            yield u0, v0, exact.nearest(Fraction(alpha) * moved), beta, gamma
        else:
            yield u0, exact.nearest(Fraction(v0) * moved), alpha, beta, gamma


def near_homoclinic_zero(draw):
    yield from near(draw, homoclinic_zero)


def near_saddle(draw):
    yield from near(draw, homoclinic_saddle)
    yield from near(draw, heteroclinic)


def near_heteroclinic_zero(draw):
    yield from first(near(draw, heteroclinic_zero), 8)


def near_escape_energy(draw):
    yield from first(near(draw, separatrix_escape), 12)


def near_triple_root(draw):
    yield from first(near(draw, triple_root), 6)


def escapes(draw, kind, count):
    """gamma < 0, out to infinity: "turn" with velocity0 towards 0, "through" from one side to the other."""
    found = 0
    while found < count:
        force = [draw.sign() * draw.number(), draw.sign() * draw.number(), -draw.number()]
        u0, v0 = draw.sign() * draw.number(-2, 2), draw.sign() * draw.number(-2, 2)
        orbit = u0, v0, *force
        if regime(orbit) != "escape":
            continue
        low, high = energy.Orbit((Fraction(u0), Fraction(v0)), tuple(map(Fraction, force))).ends()
        if (kind == "turn") == (low is not None or high is not None):
            found += 1
            yield orbit


def linear(draw):
    for alpha in (1, -1, 0, 1):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), alpha * draw.number(), 0.0, 0.0


def cubic(draw):
    for alpha, beta in ((1, 1), (-1, 1), (1, -1), (-1, -1), (0, 1), (0, -1)):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), alpha * draw.number(), beta * draw.number(), 0.0


def rest(draw):
    yield 0.0, 0.0, draw.number(), -draw.number(), draw.number()
    yield 0.0, 0.0, -draw.number(), draw.number(), -draw.number()
    yield 0.0, -0.0, 0.0, draw.number(), draw.number()
    yield 1.0, 0.0, 4.0, -5.0, 1.0
    yield -2.0, 0.0, 4.0, -5.0, 1.0
    yield 1.0, 0.0, -4.0, 5.0, -1.0
    yield 0.5, 0.0, 0.0, -0.75, 3.0
    yield 1.0, 0.0, 1.0, -2.0, 1.0
    yield 2.0, 0.0, -4.0, 1.0, 0.0


def turning(draw):
    for pattern in pairs((1, -1), repeat=3):
        yield draw.sign() * draw.number(-2, 2), 0.0, *(sign * draw.number() for sign in pattern)


def start_zero(draw):
    for pattern in pairs((1, -1), repeat=3):
        yield 0.0, draw.sign() * draw.number(-3, 2), *(sign * draw.number() for sign in pattern)


def scales(draw):
    """Units of length and time far from 1."""
    for length, rate in ((1e60, 1.0), (1e-60, 1.0), (1.0, 1e100), (1.0, 1e-100), (1e30, 1e-30)):
        for pattern in ((1, -1, 1), (1, -1, -1), (-1, 1, 1), (-1, 1, -1)):
            u0, v0 = draw.sign() * draw.number(-2, 1) * length, draw.sign() * draw.number(-2, 0) * length * rate
            units = [
                rate * rate,
                (rate / length) * (rate / length),
                (rate / length / length) * (rate / length / length),
            ]
            yield u0, v0, *(sign * draw.number() * unit for sign, unit in zip(pattern, units, strict=True))


def disparate(draw):
    """One or two terms of the force tiny beside the others."""
    sizes = ((1, 1e-30, 1e-12), (1, 1, 1e-30), (1, 1, -1e-30), (1e-30, 1, 1), (-1e-20, 1, 1), (1e-30, 1e-30, 1))
    for size in (*sizes, (1, -1e-30, 1e-9), (-1, 1e-10, 1e-16), (1, -1e-8, -1e-20), (1e-30, -1e-15, 1)):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), *(draw.number() * x for x in size)


STRATA = [
    ("signs", signs, 3, "libration well escape"),
    ("zeros", zeros, 2, "libration well escape"),
    ("triple_centre", triple_centre, 3, "libration"),
    ("triple_outer", triple_outer, 3, "well"),
    ("triple_over", triple_over, 3, "libration"),
    ("shallow", shallow, 3, "libration well"),
    ("homoclinic_zero", homoclinic_zero, 3, "homoclinic"),
    ("homoclinic_saddle", homoclinic_saddle, 3, "homoclinic"),
    ("heteroclinic", heteroclinic, 3, "heteroclinic"),
    ("heteroclinic_zero", heteroclinic_zero, 3, "heteroclinic"),
    ("triple_root", triple_root, 3, "heteroclinic escape"),
    ("near_homoclinic_zero", near_homoclinic_zero, 2, "libration well escape"),
    ("near_saddle", near_saddle, 2, "libration well escape"),
    ("near_heteroclinic_zero", near_heteroclinic_zero, 2, "libration well escape"),
    ("near_triple_root", near_triple_root, 2, "libration well escape"),
    ("near_escape_energy", near_escape_energy, 2, "escape"),
    ("separatrix_escape", separatrix_escape, 4, "escape"),
    ("escape_turn", lambda draw: escapes(draw, "turn", 8), 4, "escape"),
    ("escape_through", lambda draw: escapes(draw, "through", 8), 4, "escape"),
    ("linear", linear, 2, "linear"),
    ("cubic", cubic, 3, "libration well escape"),
    ("rest", rest, 2, "rest"),
    ("turning", turning, 2, "libration well escape"),
    ("start_zero", start_zero, 2, "libration escape"),
    ("scales", scales, 2, "libration well escape"),
    ("disparate", disparate, 2, "libration well escape"),
]


def inputs():
    """Every row's id, stratum and inputs."""
    draw = Draw(20161014)
    rows = []
    for stratum, generator, count, regimes in STRATA:
        for orbit in generator(draw):
            if regime(orbit) not in regimes.split():
                raise ArithmeticError(f"{stratum}: {orbit} is {regime(orbit)}")
            rows.extend((stratum, *orbit, t) for t in instants(draw, *orbit[:2], orbit[2:], count))
    for orbit in [*first(triple_centre(draw), 2), *first(triple_outer(draw), 2), *first(triple_over(draw), 2)]:
        period = oscillator.clock(*orbit[:2], orbit[2:])[0]
        for turns in (1e3, 1e6, 1e9):
            rows.append(("long", *orbit, product(period, draw.sign() * turns * (1 + draw.part()))))
    before, beyond = [], []
    for orbit in [*escapes(draw, "turn", 3), *escapes(draw, "through", 3), *first(separatrix_escape(draw), 2)]:
        _, ahead, behind, _ = oscillator.clock(*orbit[:2], orbit[2:])
        ends = [end for end in (ahead, behind) if abs(end) < 1e300]
        before += [("before_escape", *orbit, product(end, 1 - part)) for part in (1e-3, 1e-6, 1e-9) for end in ends]
        beyond += [("beyond_escape", *orbit, product(end, part)) for part in (1 + 1e-9, 2.0) for end in ends]
    rows += before + beyond
    starts = [first(g(draw), 3)[2] for g in (triple_centre, triple_outer, homoclinic_zero, heteroclinic, linear, rest)]
    rows.extend(("t_zero", *orbit, 0.0) for orbit in starts)
    return list(numbered("cq", INPUTS, rows))


def orbit_rows(rows):
    """The rows of the file for inputs that share an orbit."""
    values = [[float.fromhex(row[name]) for name in INPUTS] for row in rows]
    u0, velocity0, *force = values[0][:-1]
    found = oscillator.outputs(u0, velocity0, force, [v[-1] for v in values])
    for row, out in zip(rows, found, strict=True):
        yield [row["id"], row["stratum"], *(row[name] for name in INPUTS), *out]


def row(inputs):
    """One row of the file from its input columns."""
    return next(orbit_rows([inputs]))


def all_rows(inputs):
    for _, rows in groupby(inputs, key=lambda row: [row[name] for name in INPUTS[:-1]]):
        yield from orbit_rows(list(rows))


if __name__ == "__main__":
    exact.write(NAME, HEADER, all_rows(inputs()))
