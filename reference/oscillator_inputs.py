"""Draws of starts, coefficients and instants for duffing.py and cubic_quintic.py: bits and IEEE operations only."""

import math
import random
from fractions import Fraction

import mpmath as mp
from exact import nearest, rational
from oscillator import clock


class Draw(random.Random):
    """A seeded generator of doubles."""

    def number(self, low=-2, high=2):
        """A positive double with a full mantissa between 2^low and 2^high."""
        return math.ldexp(1 + self.getrandbits(52) * 2.0**-52, low + self.getrandbits(16) % (high - low))

    def short(self, bits=3):
        """A positive double with few bits, such that products of several stay exact."""
        return math.ldexp(1 + self.getrandbits(bits), self.getrandbits(8) % 3 - bits)

    def sign(self):
        return 1.0 if self.getrandbits(1) else -1.0

    def part(self):
        """A double between 0 and 1."""
        return (self.getrandbits(52) + 0.5) * 2.0**-52


def product(x, part):
    """The double nearest to x * part."""
    return nearest(rational(mp.mpf(x)) * Fraction(part))


def root(square):
    """A double next to the root of a rational, which must be positive."""
    if square <= 0:
        raise ArithmeticError("no such start")
    shift = (square.denominator.bit_length() - square.numerator.bit_length()) // 2 + 64
    return nearest(Fraction(math.isqrt(int(square * Fraction(4) ** shift)), 1) / Fraction(2) ** shift)


def first(generator, count):
    return [values for values, _ in zip(generator, range(count), strict=False)]


def instants(draw, u0, velocity0, force, count, longest=20):
    """Times of both signs: within a period and after up to longest periods, before an escape, or a few units."""
    period, ahead, behind, unit = clock(u0, velocity0, force)
    found = []
    for k in range(count):
        part = draw.part()
        end = behind if k % 2 else ahead
        if mp.isfinite(end):
            found.append(product(end, part))
        elif mp.isfinite(period) and k < 2:
            found.append(product(period, -part if k else part))
        elif mp.isfinite(period):
            found.append(product(period, draw.sign() * (part * longest)))
        else:
            found.append(product(unit, (-8 if k % 2 else 8) * part))
    return found


def numbered(prefix, names, rows):
    """Dictionaries with an id, from (stratum, *doubles)."""
    for number, (stratum, *values) in enumerate(rows, 1):
        texts = (value.hex() for value in values)
        yield {"id": f"{prefix}-{number:04d}", "stratum": stratum, **dict(zip(names, texts, strict=True))}
