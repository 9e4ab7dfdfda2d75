"""Orbits of oscillator_action.py, oscillator_states.py and oscillator_slopes.py: (u0, velocity0, p, r, q, s, c) by strata."""

import cubic_quintic
import helmholtz_duffing_inputs as even
import mpmath as mp
from cubic_quintic import homoclinic_saddle, triple_centre, triple_outer, triple_over
from general_oscillator import clock
from helmholtz_duffing_inputs import regime_of
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
    (even.double_elsewhere, 4, "libration"),
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
    (even.homoclinic, 6, "homoclinic"),
    (even.heteroclinic, 4, "heteroclinic"),
    (even.triple, 2, "homoclinic"),
    (even.last_double, 8, "libration well"),
]
QUINTIC = [
    (triple_centre, 6),
    (triple_outer, 6),
    (triple_over, 6),
    (homoclinic_saddle, 2),
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
        found = (o for o in cubic_quintic.by_signs(draw, pattern, 1) if cubic_quintic.regime(o) in ("libration", "well"))
        for orbit in first(found, 2):
            yield "quintic_signs", odd(orbit)


def falls(orbit):
    """A linear motion that does not repeat."""
    return orbit[3] == orbit[4] == 0 and orbit[2] <= 0


def letters(orbit):
    return dict(zip("prqsc", orbit[2:], strict=True))


def rows(prefix, names):
    draw = Draw(20200229)
    found = []
    for k, (stratum, orbit) in enumerate(orbits()):
        period, _, _, unit = clock(*orbit[:2], letters(orbit))
        span = period if mp.isfinite(period) else unit
        part = draw.sign() * draw.part() * (1e6 if k % 9 == 5 else 3)
        found.append((stratum, *orbit, 0.0 if k % 4 == 0 else product(span, part)))
    return list(numbered(prefix, names, found))
