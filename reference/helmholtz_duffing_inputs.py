"""Starts and coefficients of helmholtz_duffing.py: every class of quartic u'^2 = P(u), by strata.

An orbit is (u0, velocity0, p, r, q, c). Those with double roots are in double_roots.py.
"""

from fractions import Fraction
from itertools import product as pairs

from double_roots import exact_double
from even_forces import equilibria, potential, spread, through
from general_oscillator import PLACE

NEAR = [1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14]


def single_well(draw):
    """q > 0 and one equilibrium: the force is (u - a) times a positive square."""
    for _ in range(16):
        a, b, gap, q = (
            draw.sign() * draw.number(-2, 1),
            draw.sign() * draw.number(-2, 1),
            draw.number(-2, 2),
            draw.number(),
        )
        square = b * b + gap
        force = q * (square + 2 * a * b), -q * (a + 2 * b), q, q * a * square
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), *force


def confined(draw):
    """q > 0, whatever the other coefficients are."""
    for _ in range(16):
        force = draw.sign() * draw.number(), draw.sign() * draw.number(), draw.number(), draw.sign() * draw.number()
        yield draw.sign() * draw.number(-3, 2), draw.sign() * draw.number(-3, 2), *force


def in_well(draw, left):
    for _ in range(12):
        places = spread(draw)
        force = equilibria(draw, draw.number(), places)
        bottom, top = places[0 if left else 2], places[1]
        u0 = bottom + (top - bottom) * 0.6 * draw.part()
        low, high = potential(u0, force), potential(top, force)
        yield through(draw, u0, force, low + (high - low) * Fraction(draw.part()))


def left_well(draw):
    return in_well(draw, True)


def right_well(draw):
    return in_well(draw, False)


def above_barrier(draw):
    for k in range(12):
        places = spread(draw)
        force = equilibria(draw, draw.number(), places)
        u0 = places[0] + (places[2] - places[0]) * (1.2 * draw.part() - 0.1)
        level = max(potential(u0, force), potential(places[1], force))
        yield through(draw, u0, force, level + Fraction(draw.number(-8 if k % 2 else -1, 2)))


def near_barrier(draw):
    """Just below and just above the barrier of a tilted double well, from the left, from the right and from the top."""
    for near in NEAR:
        for side in (-1, 1):
            places = spread(draw)
            force = equilibria(draw, draw.number(), places)
            top = potential(places[1], force)
            level = top + side * Fraction(near) * (top - potential(places[2], force))
            yield through(draw, places[0] + (places[1] - places[0]) * 0.8 * draw.part(), force, level)
            yield through(draw, places[2] + (places[1] - places[2]) * 0.8 * draw.part(), force, level)
        yield places[1] + draw.sign() * near, 0.0, *force
        yield places[1], draw.sign() * near, *force


def softening(draw):
    """q < 0 between two barriers of different height."""
    for _ in range(12):
        places = spread(draw)
        force = equilibria(draw, -draw.number(), places)
        u0 = places[1] + (places[2 if draw.getrandbits(1) else 0] - places[1]) * 0.6 * draw.part()
        low, high = potential(u0, force), min(potential(places[0], force), potential(places[2], force))
        if high > low:
            yield through(draw, u0, force, low + (high - low) * Fraction(draw.part()))


def near_lower_barrier(draw):
    for near in NEAR:
        for side in (-1, 1):
            places = spread(draw)
            force = equilibria(draw, -draw.number(), places)
            top, other = sorted((potential(places[0], force), potential(places[2], force)))
            level = top + side * Fraction(near) * min(other - top, top - potential(places[1], force))
            yield through(draw, places[1], force, level)


def outside(draw):
    """q < 0, four real roots: the escape on either side of the bounded motion of the same energy."""
    for k in range(12):
        places = spread(draw)
        force = equilibria(draw, -draw.number(), places)
        low, high = potential(places[1], force), min(potential(places[0], force), potential(places[2], force))
        level = low + (high - low) * Fraction(draw.part())
        reach = places[2] - places[0]
        u0 = places[2] + reach * (1 + draw.part()) if k % 2 else places[0] - reach * (1 + draw.part())
        while potential(u0, force) > level:
            u0 += (u0 - places[1]) / 2
        yield through(draw, u0, force, level)


def over_one_barrier(draw):
    """q < 0, two real roots: over one barrier, back from the other, or outside of it."""
    for k in range(12):
        places = spread(draw)
        force = equilibria(draw, -draw.number(), places)
        tops = [potential(places[0], force), potential(places[2], force)]
        level = min(tops) + abs(tops[1] - tops[0]) * Fraction(draw.part())
        high = places[0] if tops[0] > tops[1] else places[2]
        u0 = places[1] if k % 3 else high + (high - places[1]) * 3
        while potential(u0, force) > level:
            u0 += (u0 - places[1]) / 2
        yield through(draw, u0, force, level)


def over_both(draw):
    """q < 0, no real root: through from infinity to infinity."""
    for k in range(12):
        places = spread(draw)
        force = equilibria(draw, -draw.number(), places)
        u0 = places[0] + (places[2] - places[0]) * (3 * draw.part() - 1)
        level = max(potential(places[0], force), potential(places[2], force))
        yield through(draw, u0, force, level + Fraction(draw.number(-10 if k % 2 else -2, 2)))


def open_force(draw):
    """q < 0, whatever the other coefficients are."""
    for _ in range(16):
        force = draw.sign() * draw.number(), draw.sign() * draw.number(), -draw.number(), draw.sign() * draw.number()
        yield draw.sign() * draw.number(-3, 2), draw.sign() * draw.number(-3, 2), *force


def quadratic_bounded(draw):
    """q = 0: Helmholtz's oscillator in its well."""
    for _ in range(12):
        p, r = draw.number(), draw.sign() * draw.number()
        e = draw.sign() * draw.number(-3, 2)
        # minimum at e, saddle at e - p / r
        force = p - 2 * r * e, r, 0.0, (p - 2 * r * e) * e + r * e * e
        top = potential(e - p / r, force)
        u0 = e - p / r * (1.2 * draw.part() - 0.4)
        low = potential(u0, force)
        if top > low:
            yield through(draw, u0, force, low + (top - low) * Fraction(draw.part()))


def quadratic_near_separatrix(draw):
    for near in NEAR[::2]:
        for side in (-1, 1):
            p, r, e = draw.number(), draw.sign() * draw.number(), draw.sign() * draw.number(-3, 2)
            force = p - 2 * r * e, r, 0.0, (p - 2 * r * e) * e + r * e * e
            top, bottom = potential(e - p / r, force), potential(e, force)
            yield through(draw, e - p / r * 0.5 * draw.part(), force, top + side * Fraction(near) * (top - bottom))


def quadratic_escape(draw):
    """q = 0: all other motions of a cubic P."""
    for k in range(14):
        force = draw.sign() * draw.number(), draw.sign() * draw.number(), 0.0, draw.sign() * draw.number()
        v0 = draw.sign() * draw.number(-3, 2) if k % 4 else 0.0
        yield draw.sign() * draw.number(-3, 3), v0, *force


def only_even(draw):
    """p = q = 0: a quadratic force, with and without a constant."""
    for k in range(10):
        force = 0.0, draw.sign() * draw.number(), 0.0, (draw.sign() * draw.number() if k % 3 else 0.0)
        yield draw.sign() * draw.number(-2, 2), draw.sign() * draw.number(-2, 2) if k % 5 else 0.0, *force


def zeros(draw):
    """Every pattern of coefficients that are 0."""
    for pattern in pairs((1, 0, -1), repeat=4):
        if 0 in pattern and (pattern[1] or pattern[2]):
            force = [sign * draw.number() if sign else 0.0 for sign in pattern]
            yield draw.sign() * draw.number(-2, 1), draw.sign() * draw.number(-3, 1), *force


def linear(draw):
    """Harmonic with a constant, hyperbolic, uniformly accelerated and free."""
    for p, c in ((1, 1), (1, -1), (1, 1), (-1, 1), (-1, -1), (0, 1), (0, -1)):
        yield draw.sign() * draw.number(), draw.sign() * draw.number(), p * draw.number(), 0.0, 0.0, c * draw.number()
    yield 0.0, 0.0, draw.number(), 0.0, 0.0, draw.number()
    yield 0.0, 0.0, draw.number(), -0.0, -0.0, -draw.number()
    yield draw.number(), 0.0, 0.0, 0.0, 0.0, draw.number()
    yield draw.number(), draw.number(), 0.0, 0.0, 0.0, 0.0
    yield draw.number(), draw.number(), draw.number(), 0.0, 0.0, 0.0
    # exponential towards c / p, either way
    yield 1.5, -3.0, -4.0, 0.0, 0.0, 0.0
    yield 2.5, -3.0, -4.0, 0.0, 0.0, -4.0
    yield 2.5, 3.0, -4.0, 0.0, 0.0, -4.0


def rest(draw):
    """Stable, unstable and flat equilibria, exactly."""
    for k in range(16):
        u0, p, r, q = (
            draw.sign() * draw.short(2),
            draw.sign() * draw.short(2),
            draw.sign() * draw.short(2),
            draw.sign() * draw.short(2),
        )
        if k % 4 == 1:
            q = 0.0
        if k % 4 == 2:
            r = 0.0
        if k % 4 == 3:
            # no stiffness
            p = -2 * r * u0 - 3 * q * u0 * u0
        c = exact_double(Fraction(p) * Fraction(u0) + Fraction(r) * Fraction(u0) ** 2 + Fraction(q) * Fraction(u0) ** 3)
        yield u0, 0.0, p, r, q, c
    yield 0.0, 0.0, draw.number(), draw.sign() * draw.number(), draw.number(), 0.0
    yield -0.0, 0.0, -draw.number(), draw.sign() * draw.number(), draw.number(), 0.0
    yield 0.0, 0.0, 0.0, draw.number(), draw.number(), 0.0
    yield 0.0, -0.0, 0.0, draw.number(), 0.0, 0.0
    yield draw.number(), 0.0, 0.0, 0.0, 0.0, 0.0


def well_bottom(draw):
    """Small swings about an equilibrium, the start as near as doubles are."""
    for k in range(8):
        places = spread(draw)
        force = equilibria(draw, draw.number(), places)
        u0 = places[0 if k % 2 else 2]
        yield u0, draw.sign() * draw.number(-40, -20) if k % 4 < 2 else 0.0, *force
    for k in range(4):
        force = draw.number(), draw.sign() * draw.number(), draw.sign() * draw.number(), 0.0
        yield draw.number(-60, -20), draw.sign() * draw.number(-60, -20) if k % 2 else 0.0, *force


def saddle(draw):
    """Beside an unstable equilibrium, the start as near as doubles are."""
    for k in range(6):
        places = spread(draw)
        yield places[1], draw.sign() * draw.number(-50, -30) if k % 3 else 0.0, *equilibria(draw, draw.number(), places)
    for _ in range(2):
        places = spread(draw)
        yield places[2], draw.sign() * draw.number(-50, -30), *equilibria(draw, -draw.number(), places)


def junction(draw):
    """A biased Josephson junction to third order about its bias: u'' + cos(b) (u - u^3 / 6) + sin(b) (1 - u^2 / 2) = i."""
    for cosine, sine in ((0.8, 0.6), (0.28, 0.96), (0.96, 0.28), (0.6, 0.8)):
        for kick in (0.0, 0.1):
            force = cosine, -sine / 2, -cosine / 6, kick * draw.sign() * draw.part()
            yield draw.sign() * 0.3 * cosine * draw.part(), draw.sign() * 0.2 * cosine * draw.part(), *force


def beam(draw):
    """A resonator with a quadratic term from its bias, in units of its mode."""
    for _ in range(6):
        p, r, q = 1.0, draw.sign() * draw.number(-6, 0), draw.number(-6, 1)
        yield draw.number(-4, 1), 0.0, p, r, q, 0.0


def equal_roots(draw):
    """Roots of P that nearly meet: P = -(q/2) (u - a) (u - a - g) (u - b) (u - b - h), rounded."""
    for gap in (1e-3, 1e-5, 1e-7, 1e-9, 1e-12):
        for other in (1.0, gap):
            for q in (1.0, -1.0):
                a, q = draw.sign() * draw.number(-2, 1), q * draw.number()
                b = a + draw.number(0, 2)
                g, h = gap * (1 + draw.part()), other * (1 + draw.part())
                e1 = [Fraction(x) for x in (a, a + g, b, b + h)]
                sums = [Fraction(1)]
                for x in e1:
                    sums = [
                        (sums[k] if k < len(sums) else 0) - (x * sums[k - 1] if k else 0) for k in range(len(sums) + 1)
                    ]
                # coefficients of u^4 down to 1
                half = -Fraction(q) / 2
                P = [half * x for x in sums]
                force = float(-P[2]), float(-3 * P[1] / 2), q, float(P[3] / 2)
                yield (a if draw.getrandbits(1) else b + h), 0.0, *force
                if q < 0:
                    continue
                yield (a + g if draw.getrandbits(1) else b), 0.0, *force


def turning(draw):
    for signs in pairs((1, -1), repeat=4):
        yield draw.sign() * draw.number(-3, 2), 0.0, *(sign * draw.number() for sign in signs)


def start_zero(draw):
    for k, signs in enumerate(pairs((1, -1), repeat=3)):
        force = [sign * draw.number() for sign in signs]
        yield 0.0, (draw.sign() * draw.number(-3, 2) if k % 4 else 0.0), *force, draw.sign() * draw.number()


def no_force(draw):
    """A start where the force is 0, exactly, with a velocity."""
    for _ in range(8):
        u0, p, r, q = (
            draw.sign() * draw.short(1),
            draw.sign() * draw.short(1),
            draw.sign() * draw.short(1),
            draw.sign() * draw.short(1),
        )
        c = exact_double(Fraction(p) * Fraction(u0) + Fraction(r) * Fraction(u0) ** 2 + Fraction(q) * Fraction(u0) ** 3)
        yield u0, draw.sign() * draw.number(-3, 2), p, r, q, c


def moved_origin(draw):
    """Duffing's equation about another origin: P stays symmetric, exactly."""
    for _ in range(10):
        m, p, q = draw.sign() * draw.short(2), draw.sign() * draw.short(2), draw.sign() * draw.short(1)
        M, p2, q2 = Fraction(m), Fraction(p), Fraction(q)
        force = p2 + 3 * q2 * M**2, -3 * q2 * M, q2, p2 * M + q2 * M**3
        yield draw.sign() * draw.short(3), draw.sign() * draw.number(-3, 1), *map(exact_double, force)


def weak(draw):
    """Even powers that hardly matter, and odd ones that hardly do."""
    for tiny in (1e-8, 1e-16, 1e-40, 1e-250):
        for q in (1, -1):
            u0, v0 = draw.sign() * draw.number(-3, -1), draw.sign() * draw.number(-3, -1)
            yield (
                u0,
                v0,
                draw.number(0, 2),
                draw.sign() * tiny * draw.number(),
                q * draw.number(),
                draw.sign() * tiny * draw.number(),
            )
        u0, v0 = draw.sign() * draw.number(-3, -1), draw.sign() * draw.number(-3, -1)
        yield u0, v0, draw.number(0, 2), draw.sign() * draw.number(-2, 0), draw.sign() * tiny * draw.number(), 0.0


def disparate(draw):
    """One term of the force far larger than the others."""
    for sizes in (
        (1, 1e-9, 1e-20, 1e-5),
        (1e-12, 1, 1e-6, 1e-12),
        (1e-9, 1e-9, 1, 1e-9),
        (1, 1e6, 1e12, 1e-6),
        (1e-6, 1e-3, 1, 1e3),
    ):
        for _ in range(3):
            force = [draw.sign() * size * draw.number() for size in sizes]
            yield draw.sign() * draw.number(), draw.sign() * draw.number(), *force


SCALES = [
    (1e290, 1.0), (1e-290, 1e-140), (1e145, 1.0), (1e-145, 1.0), (1.0, 1e140), (1.0, 1e-140),
    (1e100, 1e40), (1e-100, 1e-40), (1e-250, 1e-20), (1e200, 1e-50), (1e-60, 1e120), (1e60, 1e-120),
]  # fmt: skip


def scales(draw):
    """Units of length and time from one end of the doubles to the other; terms that do not fit are 0."""
    for length, rate in SCALES:
        for signs in ((1, 1, 1, 1), (1, -1, -1, 1), (-1, 1, 1, -1), (-1, -1, -1, 0)):
            u0 = draw.sign() * draw.number(-1, 1) * length
            v0 = draw.sign() * fitting(Fraction(draw.number(-2, 0)) * Fraction(length) * Fraction(rate))
            force = []
            for letter, sign in zip("prqc", signs, strict=True):
                unit = Fraction(length) ** (1 - PLACE[letter][0]) * Fraction(rate) ** 2
                force.append(sign * fitting(Fraction(draw.number(-2, 1)) * unit))
            if force[1] or force[2]:
                yield u0, v0, *force


def fitting(x):
    """The double next to a positive rational, or 0 if that is not a normal one."""
    return float(x) if Fraction(1, 2**1000) < x < Fraction(2) ** 1010 else 0.0
