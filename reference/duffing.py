"""Writes vectors/duffing.csv: the exact motion u'' + p u + q u^3 = 0 by Taylor series (oscillator.py).

Run: python duffing.py
"""

from fractions import Fraction
from itertools import groupby

import exact
import oscillator
from oscillator_inputs import Draw, first, instants, numbered, product, root

NAME = "duffing.csv"
INPUTS = "u0 velocity0 p q t".split()
HEADER = ["id", "stratum", *INPUTS, *oscillator.OUTPUTS]
NEAR = [1e-3, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12]


def hardening(draw):
    for _ in range(12):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), draw.number(), draw.number()


def above(draw):
    """Over the barrier of the double well."""
    for _k in range(12):
        p, q = -draw.number(), draw.number()
        u0 = draw.sign() * draw.number(-3, 1)
        level = max(Fraction(0), -Fraction(p) * Fraction(u0) ** 2 - Fraction(q) * Fraction(u0) ** 4 / 2)
        extra = Fraction(draw.number(-5, 2)) * Fraction(p) ** 2 / Fraction(q)
        yield u0, draw.sign() * root(level + extra), p, q


def pure_cubic(draw):
    for _ in range(4):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), 0.0, draw.number()


def softening(draw):
    for _ in range(12):
        p, q = draw.number(), -draw.number()
        u0 = draw.sign() * root(Fraction(p) / -Fraction(q)) * draw.part() * 0.95
        room = (Fraction(p) + Fraction(q) * Fraction(u0) ** 2) ** 2 / (-2 * Fraction(q))
        yield u0, draw.sign() * root(room) * draw.part(), p, q


def one_well(draw):
    for k in range(12):
        p, q = -draw.number(), draw.number()
        u0 = draw.sign() * root(-Fraction(p) / Fraction(q)) * (1 + draw.part() * (0.4 if k % 2 else -0.9))
        room = -Fraction(p) * Fraction(u0) ** 2 - Fraction(q) * Fraction(u0) ** 4 / 2
        yield u0, draw.sign() * root(room) * draw.part(), p, q


def well_bottom(draw):
    """Next to an equilibrium with small swings."""
    for k in range(4):
        p, q = -draw.number(), draw.number()
        u0 = draw.sign() * root(-Fraction(p) / Fraction(q))
        yield u0, draw.sign() * draw.number(-30, -20) if k % 2 else 0.0, p, q
    for _ in range(2):
        yield draw.number(-40, -20), draw.sign() * draw.number(-40, -20), draw.number(), draw.sign() * draw.number()


def homoclinic(draw):
    """E = 0 exactly: p = -(v0/u0)^2 - q u0^2 / 2 is a double for short numbers."""
    yield 1.0, 0.0, -0.5, 1.0
    yield -2.0, 0.0, -2.0, 1.0
    for _k in range(7):
        u0, ratio, q = draw.sign() * draw.short(2), draw.sign() * draw.short(), draw.short()
        yield u0, u0 * ratio, -ratio * ratio - q * u0 * u0 / 2, q


def near_homoclinic(draw):
    for near in NEAR:
        for side in (-1, 1):
            p, q = -draw.number(), draw.number()
            u0 = draw.sign() * root(-Fraction(p) / Fraction(q)) * (0.3 + draw.part())
            square = -Fraction(p) * Fraction(u0) ** 2 - Fraction(q) * Fraction(u0) ** 4 / 2
            yield u0, draw.sign() * root(square + side * Fraction(near) * Fraction(p) ** 2 / (2 * Fraction(q))), p, q
        # from the saddle itself, at rest beside it or pushed through it
        small = root(Fraction(near) * -Fraction(p) / (2 * Fraction(q)))
        yield draw.sign() * small, 0.0, p, q
        yield 0.0, draw.sign() * small * -p, p, q


def heteroclinic_force(u0, ratio, s):
    """q = -2 s^2 and p such that (p + q u0^2)^2 = -2 q v0^2 with v0 = ratio; all short."""
    return 2 * s * s * u0 * u0 + 2 * s * ratio, -2 * s * s


def heteroclinic(draw):
    yield 0.0, 1.0, 2.0, -2.0
    for _ in range(7):
        u0, v0, s = draw.sign() * draw.short(2), draw.short(), draw.short(2)
        p, q = heteroclinic_force(u0, v0, s)
        yield u0, draw.sign() * v0, p, q


def coth(draw):
    """The same energy, outside: escape one way, the unstable equilibrium the other."""
    while True:
        u0, v0, s = draw.sign() * draw.short(2), draw.short(), draw.short(2)
        p, q = heteroclinic_force(u0, -v0, s)
        if p > 0:
            yield u0, draw.sign() * v0, p, q


def tangent(draw):
    """p < 0, E = p^2 / 4|q| exactly: escape both ways, tan; and p = 0 = E: 1 / t."""
    while True:
        u0, v0, s = draw.sign() * draw.short(2), draw.short(), draw.short(2)
        p, q = heteroclinic_force(u0, -v0, s)
        if p < 0:
            yield u0, draw.sign() * v0, p, q


def near_heteroclinic(draw):
    for near in NEAR:
        for side, place in ((-1, 0.9), (1, 0.9), (-1, 1.5), (1, 1.5)):
            p, q = draw.number(), -draw.number()
            u0 = draw.sign() * root(Fraction(p) / -Fraction(q)) * place * (0.7 + 0.3 * draw.part())
            square = (Fraction(p) + Fraction(q) * Fraction(u0) ** 2) ** 2 / (-2 * Fraction(q))
            square += side * Fraction(near) * Fraction(p) ** 2 / (-2 * Fraction(q))
            yield u0, draw.sign() * root(square), p, q


def escape_turn(draw):
    """E < 0: in, round and out again."""
    for _ in range(12):
        p, q = draw.sign() * draw.number(), -draw.number()
        beyond = 1 + draw.number(-3, 2)
        u0 = draw.sign() * root(Fraction(abs(p)) * 2 / -Fraction(q)) * beyond
        room = -Fraction(p) * Fraction(u0) ** 2 - Fraction(q) * Fraction(u0) ** 4 / 2
        yield u0, draw.sign() * root(room) * draw.part(), p, q


def escape_outside(draw):
    """p > 0 and 0 < E < p^2 / 4|q|, outside the barrier."""
    for _ in range(8):
        p, q = draw.number(), -draw.number()
        u0 = draw.sign() * root(Fraction(p) / -Fraction(q)) * (1.05 + 0.3 * draw.part())
        room = (Fraction(p) + Fraction(q) * Fraction(u0) ** 2) ** 2 / (-2 * Fraction(q))
        yield u0, draw.sign() * root(room) * (0.7 + 0.29 * draw.part()) if draw.getrandbits(1) else 0.0, p, q


def escape_zero(draw):
    """E = 0 exactly: sec, csch and 1 / t."""
    yield 1.0, 0.0, 0.5, -1.0
    yield -2.0, 2.0, 1.0, -1.0
    yield 1.0, -2.0, 0.0, -8.0
    yield 2.0, 2.0, 0.0, -0.5
    for _k in range(6):
        u0, ratio, q = draw.sign() * draw.short(2), draw.sign() * draw.short(), -draw.short()
        yield u0, u0 * ratio, -ratio * ratio - q * u0 * u0 / 2, q


def escape_monotone(draw):
    """Delta < 0 of all signs of p, and p < 0 with 0 < E < p^2 / 4|q|."""
    for k in range(9):
        p, q = (1.0, -1.0, 0.0)[k % 3] * draw.number(), -draw.number()
        u0 = draw.sign() * draw.number()
        square = (Fraction(p) + Fraction(q) * Fraction(u0) ** 2) ** 2 / (-2 * Fraction(q))
        yield u0, draw.sign() * root(square + Fraction(draw.number(-4, 2))), p, q
    for k in range(5):
        p, q = -draw.number(), -draw.number()
        u0 = draw.sign() * draw.number() if k else 0.0
        low = -Fraction(p) * Fraction(u0) ** 2 - Fraction(q) * Fraction(u0) ** 4 / 2
        yield u0, draw.sign() * root(low + Fraction(draw.part()) * Fraction(p) ** 2 / (-2 * Fraction(q))), p, q


def linear(draw):
    for p in (1.0, 1.0, -1.0, -1.0, 0.0, 0.0):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), p * draw.number(), 0.0
    yield draw.number(), 0.0, draw.number(), -0.0
    yield 0.0, draw.number(), -draw.number(), 0.0
    yield -draw.number(), 0.0, -draw.number(), 0.0
    yield 1.5, -3.0, -4.0, 0.0
    yield 1.5, 3.0, -4.0, 0.0
    yield 0.0, -draw.number(), 0.0, 0.0


def rest(draw):
    yield 0.0, 0.0, draw.number(), draw.number()
    yield 0.0, 0.0, -draw.number(), draw.number()
    yield -0.0, 0.0, draw.number(), -draw.number()
    yield 0.0, 0.0, 0.0, -draw.number()
    yield 2.0, 0.0, -4.0, 1.0
    yield -0.5, 0.0, -0.75, 3.0
    yield 1.5, -0.0, 4.5, -2.0
    yield -3.0, 0.0, 9.0, -1.0
    yield draw.number(), 0.0, 0.0, 0.0
    yield 0.0, 0.0, draw.number(), 0.0
    yield 2.0**300, 0.0, -(2.0**100), 2.0**-500


def turning(draw):
    for p, q in ((1, 1), (-1, 1), (1, -1), (-1, -1), (0, 1), (0, -1), (-1, 1), (1, -1), (-1, 1), (1, -1)):
        yield draw.sign() * draw.number(-3, 3), 0.0, p * draw.number(), q * draw.number()


def start_zero(draw):
    for p, q in ((1, 1), (-1, 1), (1, -1), (-1, -1), (0, 1), (0, -1), (-1, 1), (1, -1)):
        yield 0.0, draw.sign() * draw.number(-3, 2), p * draw.number(), q * draw.number()


def scales(draw):
    """Units of length and time far from 1: u = 10^k x, t = 10^j s."""
    for length, rate in ((1e100, 1.0), (1e-100, 1.0), (1.0, 1e100), (1.0, 1e-100), (1e70, 1e-80), (1e-70, 1e75)):
        for p, q in ((1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)):
            number = draw.number
            u0, v0 = draw.sign() * number(-1, 1) * length, draw.sign() * number(-2, 0) * length * rate
            yield u0, v0, p * number() * rate * rate, q * number() * (rate / length) * (rate / length)


def disparate(draw):
    """One term of the force tiny beside the other, at the start."""
    for p, q in ((1.0, 1e-30), (1.0, -1e-30), (-1.0, 1e-14), (-1.0, -1e-14), (1e-30, 1.0), (1e-30, -1.0)):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), p * draw.number(), q * draw.number()
    for p, q in ((-1e-30, 1.0), (-1e-30, -1.0), (1.0, 1e-300), (1e-300, 1.0), (-1.0, 1e-60), (1.0, -1e-9)):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), p * draw.number(), q * draw.number()


def inputs():
    """Every row's id, stratum and inputs."""
    draw = Draw(20190206)
    rows = []

    def add(stratum, orbits, count, regimes):
        for u0, v0, p, q in orbits:
            regime = oscillator.regime(u0, v0, (p, q))
            if regime not in regimes.split():
                raise ArithmeticError(f"{stratum}: {u0} {v0} {p} {q} is {regime}")
            rows.extend((stratum, u0, v0, p, q, t) for t in instants(draw, u0, v0, (p, q), count))

    add("hardening", hardening(draw), 4, "libration")
    add("above", above(draw), 4, "libration")
    add("pure_cubic", pure_cubic(draw), 4, "libration")
    add("softening", softening(draw), 4, "libration")
    add("one_well", one_well(draw), 4, "well")
    add("well_bottom", well_bottom(draw), 3, "well libration")
    add("homoclinic", homoclinic(draw), 4, "homoclinic")
    add("near_homoclinic", near_homoclinic(draw), 2, "libration well")
    add("heteroclinic", heteroclinic(draw), 4, "heteroclinic")
    add("near_heteroclinic", near_heteroclinic(draw), 2, "libration escape")
    add("escape_turn", escape_turn(draw), 4, "escape")
    add("escape_outside", escape_outside(draw), 4, "escape")
    add("escape_zero", escape_zero(draw), 3, "escape")
    add("escape_coth", first(coth(draw), 5), 4, "escape")
    add("escape_tangent", first(tangent(draw), 4), 4, "escape")
    add("escape_monotone", escape_monotone(draw), 4, "escape")
    add("linear", linear(draw), 4, "linear")
    add("rest", rest(draw), 2, "rest")
    add("turning", turning(draw), 3, "libration well escape")
    add("start_zero", start_zero(draw), 3, "libration escape")
    add("scales", scales(draw), 2, "libration well escape")
    add("disparate", disparate(draw), 3, "libration well escape")
    for orbit in [
        *first(hardening(draw), 3),
        *first(above(draw), 2),
        *first(softening(draw), 3),
        *first(one_well(draw), 3),
    ]:
        period = oscillator.clock(*orbit[:2], orbit[2:])[0]
        for turns in (1e3, 1e6, 1e9):
            rows.append(("long", *orbit, product(period, draw.sign() * turns * (1 + draw.part()))))
    escapes = [*first(escape_turn(draw), 3), *first(escape_outside(draw), 2), *first(escape_monotone(draw), 3)]
    for orbit in [*escapes, *first(escape_zero(draw), 3), *first(coth(draw), 2)]:
        _, ahead, behind, _ = oscillator.clock(*orbit[:2], orbit[2:])
        for part in (1 - 1e-3, 1 - 1e-6, 1 - 1e-9):
            rows.extend(("before_escape", *orbit, product(end, part)) for end in (ahead, behind) if abs(end) < 1e300)
        for part in (1 + 1e-9, 2.0):
            rows.extend(("beyond_escape", *orbit, product(end, part)) for end in (ahead, behind) if abs(end) < 1e300)
    starts = [first(g(draw), 3)[2] for g in (hardening, one_well, homoclinic, heteroclinic, escape_turn, linear, rest)]
    rows.extend(("t_zero", *orbit, 0.0) for orbit in starts)
    order = {row[0]: None for row in rows}
    return list(numbered("duf", INPUTS, [row for stratum in order for row in rows if row[0] == stratum]))


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
