"""Orbits of oscillator_action.py, oscillator_states.py and oscillator_slopes.py: (u0, velocity0, p, r, q, s, c) by strata."""

from fractions import Fraction

import cubic_quintic
import double_roots
import helmholtz_duffing_inputs as even
import mpmath as mp
from cubic_quintic import homoclinic_saddle, triple_centre, triple_outer, triple_over
from double_roots import regime_of
from energy import value
from exact import real
from general_oscillator import ScaledOrbit, clock
from oscillator_inputs import Draw, first, numbered, product

# generator, number of orbits, regimes
DUFFING = [
    (even.single_well, 10, "libration"),
    (even.left_well, 6, "libration well"),
    (even.right_well, 6, "libration well"),
    (even.above_barrier, 8, "libration"),
    (even.near_barrier, 10, "libration well"),
    (even.softening, 8, "libration"),
    (even.near_lower_barrier, 4, "libration"),
    (double_roots.double_elsewhere, 4, "libration"),
    (even.quadratic_bounded, 8, "libration"),
    (even.quadratic_near_separatrix, 3, "libration"),
    (even.well_bottom, 8, "libration well"),
    (even.junction, 4, "libration"),
    (even.beam, 6, "libration"),
    (even.zeros, 12, "libration well"),
    (even.moved_origin, 4, "libration well"),
    (even.weak, 6, "libration well"),
    (even.turning, 6, "libration well"),
    (even.scales, 10, "libration well"),
    (even.linear, 12, "linear"),
    (even.rest, 10, "rest"),
    (double_roots.homoclinic, 6, "homoclinic"),
    (double_roots.heteroclinic, 4, "heteroclinic"),
    (double_roots.triple, 2, "homoclinic"),
    (double_roots.last_double, 8, "libration well"),
]
QUINTIC = [
    (triple_centre, 6),
    (triple_outer, 6),
    (triple_over, 6),
    (homoclinic_saddle, 2),
]
# states of the cubic-quintic oscillator: generator, number of orbits, regimes
QUINTIC_MORE = [
    (cubic_quintic.signs, 10, "libration well"),
    (cubic_quintic.zeros, 8, "libration well"),
    (cubic_quintic.shallow, 3, "libration well"),
    (cubic_quintic.homoclinic_zero, 6, "homoclinic"),
    (cubic_quintic.homoclinic_saddle, 5, "homoclinic"),
    (cubic_quintic.heteroclinic, 5, "heteroclinic"),
    (cubic_quintic.heteroclinic_zero, 3, "heteroclinic"),
    (cubic_quintic.triple_root, 3, "heteroclinic"),
    (cubic_quintic.near_homoclinic_zero, 6, "libration well"),
    (cubic_quintic.near_saddle, 12, "libration well"),
    (cubic_quintic.near_heteroclinic_zero, 4, "libration well"),
    (cubic_quintic.near_triple_root, 4, "libration well"),
    (cubic_quintic.cubic, 2, "libration well"),
    (cubic_quintic.turning, 4, "libration well"),
    (cubic_quintic.start_zero, 4, "libration"),
    (cubic_quintic.scales, 10, "libration well"),
    (cubic_quintic.disparate, 5, "libration well"),
    (cubic_quintic.linear, 1, "linear"),
    (cubic_quintic.rest, 9, "rest"),
]


def wide(orbit):
    u0, v0, p, r, q, c = orbit
    return u0, v0, p, r, q, 0.0, c


def odd(orbit):
    u0, v0, p, q, s = orbit
    return u0, v0, p, 0.0, q, s, 0.0


def stated():
    """Duffing(1, p=1, q=1) and others with values printed elsewhere."""
    yield 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0
    yield 1.0, 0.0, 1.0, 0.5, 0.2, 0.0, 0.0
    for u0 in (0.5, 1.0, 2.0):
        yield u0, 0.0, 1.0, 0.0, 0.1, 0.0, 0.0


def orbits():
    """(stratum, orbit) of bounded motions of both oscillators."""
    draw = Draw(20190714)
    for orbit in stated():
        yield "stated", orbit
    for generator, count, regimes in DUFFING:
        found = (o for o in generator(draw) if regime_of(o) in regimes.split() and not falls(o))
        for orbit in first(found, count):
            yield generator.__name__, wide(orbit)
    for generator, count in QUINTIC:
        for orbit in first(generator(draw), count):
            yield f"quintic_{generator.__name__}", odd(orbit)
    for pattern in ((1, 1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, -1), (1, -1, -1), (-1, -1, 1), (0, 0, 1), (1, 0, 1)):
        found = (
            o for o in cubic_quintic.by_signs(draw, pattern, 1) if cubic_quintic.regime(o) in ("libration", "well")
        )
        for orbit in first(found, 2):
            yield "quintic_signs", odd(orbit)


def quintic_orbits():
    """(stratum, orbit) of more motions of the cubic-quintic oscillator that stay."""
    draw = Draw(20161015)
    for generator, count, regimes in QUINTIC_MORE:
        found = (o for o in generator(draw) if cubic_quintic.regime(o) in regimes.split())
        for orbit in first(found, count):
            yield f"quintic_{generator.__name__}", odd(orbit)


def falls(orbit):
    """A linear motion that does not repeat."""
    return orbit[3] == orbit[4] == 0 and orbit[2] <= 0


def moves(orbit):
    """Whether a motion with odd powers is a libration or in a well."""
    u0, v0, p, _, q, s, _ = orbit
    return cubic_quintic.regime((u0, v0, p, q, s)) in ("libration", "well")


def letters(orbit):
    return dict(zip("prqsc", orbit[2:], strict=True))


# rows that would take minutes: many hundreds of rates after the start on a separatrix, nearly symmetric, or a triple root
SLOW = tuple(
    "os-0056 os-0074 os-0154 os-0155 os-0159 oa-0155 oa-0156 oa-0220 oa-0236 oa-0237 oa-0238 oa-0261 oa-0262 oa-0263 oa-0264".split()
)
ESCAPES = [
    (even.outside, 5),
    (even.over_one_barrier, 5),
    (even.over_both, 6),
    (double_roots.coth, 2),
    (double_roots.tangent, 2),
    (double_roots.double_escape, 3),
    (even.quadratic_escape, 5),
    (double_roots.quadratic_separatrix, 3),
    (even.only_even, 3),
]


def slope_rows(prefix, names):
    """Every second bounded motion, and escapes of both oscillators."""
    draw = Draw(20220222)
    chosen = list(orbits())[::2]
    for generator, count in ESCAPES:
        found = (wide(o) for o in generator(draw) if regime_of(o) == "escape")
        chosen += [(generator.__name__, orbit) for orbit in first(found, count)]
    for kind in ("turn", "through"):
        chosen += [(f"quintic_escape_{kind}", odd(o)) for o in first(cubic_quintic.escapes(draw, kind, 4), 4)]
    chosen += list(quintic_orbits())[::2]
    found = []
    for k, (stratum, orbit) in enumerate(chosen):
        period, ahead, behind, unit = clock(*orbit[:2], letters(orbit))
        if mp.isfinite(ahead) or mp.isfinite(behind):
            end = behind if not mp.isfinite(ahead) or (k % 2 and mp.isfinite(behind)) else ahead
            t = product(end, draw.part())
        else:
            t = product(
                period if mp.isfinite(period) else 32 * unit, draw.sign() * draw.part() * (100 if k % 5 == 3 else 2)
            )
        found.append((stratum, *orbit, t))
    return [row for row in numbered(prefix, names, found) if row["id"] not in SLOW]


STATES = [
    even.single_well,
    even.left_well,
    even.right_well,
    even.above_barrier,
    even.softening,
    even.quadratic_bounded,
    even.beam,
    even.zeros,
    even.moved_origin,
    even.turning,
    even.scales,
]


def state_rows(prefix, names):
    """Actions and phases, with a state next to the motion."""
    draw = Draw(20230303)
    chosen = [("stated", orbit) for orbit in stated()]
    for generator in STATES:
        found = (o for o in generator(draw) if regime_of(o) in ("libration", "well"))
        chosen += [(generator.__name__, wide(o)) for o in first(found, 6)]
    for generator in (triple_centre, triple_outer, triple_over):
        chosen += [(f"quintic_{generator.__name__}", odd(o)) for o in first(generator(draw), 4)]
    chosen += [(stratum, orbit) for stratum, orbit in quintic_orbits() if moves(orbit)]
    found = []
    for k, (stratum, orbit) in enumerate(chosen):
        whole = ScaledOrbit(tuple(map(Fraction, orbit[:2])), letters(orbit), [])
        low, high = whole.orbit.bounds(80)
        with mp.workprec(100):
            near = (low + high * (1 + k % 3)) / (2 + k % 3)
            near = near if abs(near) > (high - low) * mp.mpf(2) ** -60 else mp.mpf(0)
            speed = mp.sqrt(value([real(g) for g in whole.orbit.P], near))
            action = whole.orbit.action(80) * whole.u_unit**2 / whole.t_unit
            numbers = [product(x, 1) for x in (action, near * whole.u_unit, speed * whole.u_unit / whole.t_unit)]
        phase = (0.0, 3.0, -1.5)[k % 3] if k % 5 == 0 else draw.sign() * draw.part() * (3.14 if k % 4 else 1000)
        if min(abs(x) for x in numbers[::2]) > 1e-290 and max(map(abs, numbers)) < 1e300:
            found.append((stratum, numbers[0], phase, *orbit[2:], *numbers[1:]))
    return list(numbered(prefix, names, found))


def rows(prefix, names):
    draw = Draw(20200229)
    found = []
    for k, (stratum, orbit) in enumerate([*orbits(), *quintic_orbits()]):
        period, _, _, unit = clock(*orbit[:2], letters(orbit))
        span = period if mp.isfinite(period) else unit
        part = draw.sign() * draw.part() * (1e6 if k % 9 == 5 else 3)
        found.append((stratum, *orbit, 0.0 if k % 4 == 0 else product(span, part)))
    return [row for row in numbered(prefix, names, found) if row["id"] not in SLOW]
