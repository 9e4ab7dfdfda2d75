"""Taylor integration of u'' = -(f0 + f1 u + ... + f5 u^5) with its linearised equation, in fixed point.

As taylor.py, for every force: numbers are integers over 2^bits, steps are powers of two. Where |u| is large the same motion
is followed in w = 1/u (no fifth power: w'^2 = a4 + a3 w + a2 w^2 + a1 w^3 + a0 w^4 with u'^2 = P(u)) or in 1/u^2 (odd
forces), which are regular at the escape. A column is the derivative of (u, u') by one of the inputs.
"""

from fractions import Fraction
from operator import mul

import mpmath as mp
from mpmath.libmp import MPZ
from taylor import fixed, from_square, product, reciprocal, to_square


def shifted(x, places):
    return x >> places if places >= 0 else x << -places


def power_series(x, force, columns, forcing, step, bits, limit, column_bits):
    """Coefficients times powers of 2^-step of u (from u, u') and of every column; None if limit is too few.

    forcing: for every column the derivatives of the force's coefficients by its input."""
    X = [x[0], shifted(x[1], step)]
    D = [[d[0], shifted(d[1], step)] for d in columns]
    top = max([k for f in (force, *forcing) for k, g in enumerate(f) if g], default=0)
    powers = [[1 << bits], X, *([] for _ in range(2, top + 1))]
    K = []
    for k in range(limit):
        if k:
            powers[0].append(0)
        for j in range(2, top + 1):
            powers[j].append(product(powers[j // 2], powers[j - j // 2], k, bits))
        total = sum(f * powers[j][k] for j, f in enumerate(force) if f)
        below = (k + 1) * (k + 2)
        X.append(shifted(-(total >> bits), 2 * step) // below)
        if D:
            # the derivative of the force by u
            K.append(sum(j * f * powers[j - 1][k] for j, f in enumerate(force) if j and f) >> bits)
        for d, forced in zip(D, forcing, strict=True):
            total = sum(map(mul, d, K[k::-1])) + sum(g * powers[j][k] for j, g in enumerate(forced) if g)
            d.append(shifted(-(total >> bits), 2 * step) // below)
        if k > 6 and converged(X, D, bits, column_bits):
            return X, D
    return None


def converged(X, D, bits, column_bits):
    """Whether the state is complete to the last bit and the columns to as many as they need."""
    if not all(-2 <= c <= 2 for c in X[-5:]):
        return False
    return all(max(map(abs, d[-5:])) <= max(abs(d[0]), abs(d[1]), 1 << bits) >> column_bits for d in D)


class ForceSweep:
    """One pass over an orbit in units where |u| is 1 at the largest feature and no rate exceeds 16.

    start: (u0, u0') rational or mpf; force: rational f0 to f5; by: for every column (du0, du0', df) at the start;
    pace: the most terms of a series are bits / pace (steps shrink), the least half of that (steps grow)."""

    def __init__(self, start, force, by, unbounded, pace, bits, column_bits=100):
        u0, v0 = start
        self.column_bits = column_bits
        self.bits, self.step = bits, 5
        self.most = int(bits / pace)

        def of(value):
            return MPZ(fixed(value, bits))  # gmpy2's integers where it is installed

        f = list(force) + [0] * (6 - len(force))
        self.charts = {"u": (list(map(of, f)), [list(map(of, df)) for _, _, df in by])}
        self.outer = None
        if unbounded and any(f[2:]):
            # P(0) = u0'^2 + sum 2 f u0^(k+1) / (k+1), and by every input
            a0 = v0 * v0 + 2 * sum(g * u0 ** (k + 1) / (k + 1) for k, g in enumerate(f))
            force0 = sum(g * u0**k for k, g in enumerate(f))
            a0s = [
                2 * v0 * dv + 2 * force0 * du + 2 * sum(g * u0 ** (k + 1) / (k + 1) for k, g in enumerate(df))
                for du, dv, df in by
            ]
            self.outer = "square" if f[5] else "reciprocal"
            self.charts[self.outer] = (
                self.outside(f, a0, of),
                [self.outside(df, da, of) for (_, _, df), da in zip(by, a0s, strict=True)],
            )
        self.side = 1
        self.chart = "u"
        self.state = [(of(u0), of(v0)), *((of(du), of(dv)) for du, dv, _ in by)]
        self.turn_to_chart()

    def outside(self, f, a0, of):
        """The force of 1/u or 1/u^2, linear in f and a0 = P(0)."""
        f = list(map(Fraction, f))
        terms = [f[3], 4 * f[1], -6 * a0] if self.outer == "square" else [f[2] / 3, f[1], 3 * f[0], -2 * a0]
        return list(map(of, terms))

    def numbers(self, state):
        return [(mp.ldexp(mp.mpf(a), -self.bits), mp.ldexp(mp.mpf(b), -self.bits)) for a, b in state]

    def in_u(self, state, chart):
        """The state as mpf in u itself."""
        state = self.numbers(state)
        if chart == "reciprocal":
            return reciprocal(state)
        return from_square(state, self.side) if chart == "square" else state

    def turn_to_chart(self):
        """Change the variable where |u| > 1.5 or 1/|u| > 1.5; the gap prevents changes at every step."""
        size = abs(self.state[0][0]) * 2
        limit = 3 << self.bits
        if self.chart == "u" and self.outer and size > limit:
            self.side = 1 if self.state[0][0] > 0 else -1
            state = self.numbers(self.state)
            state = reciprocal(state) if self.outer == "reciprocal" else to_square(state)
            self.chart = self.outer
        elif self.chart != "u" and size > limit:
            state, self.chart = self.in_u(self.state, self.chart), "u"
        else:
            return
        self.state = [(MPZ(fixed(a, self.bits)), MPZ(fixed(b, self.bits))) for a, b in state]

    def run(self, targets, escapes=False):
        """States in u at the ascending times (mpf or rational); escapes: the last one is raw, in its chart."""
        bits = self.bits
        times = [fixed(t, bits) for t in targets]
        now, found = 0, []
        while len(found) < len(times):
            force, forcing = self.charts[self.chart]
            while (
                result := power_series(
                    self.state[0], force, self.state[1:], forcing, self.step, bits, self.most, self.column_bits
                )
            ) is None:
                self.step += 1
                if self.step > bits:
                    raise ArithmeticError("no step is short enough: too few bits have led to a pole")
            X, D = result
            step = self.step
            length = 1 << (bits - step)
            while len(found) < len(times) and times[len(found)] <= now + length:
                part = shifted(times[len(found)] - now, -step)
                state = [at_part(f, part, step, bits) for f in (X, *D)]
                raw = escapes and len(found) == len(times) - 1
                found.append(self.numbers(state) if raw else self.in_u(state, self.chart))
            now += length
            self.state = [(sum(f), shifted(sum(map(mul, f, range(len(f)))), -step)) for f in (X, *D)]
            self.step = max(-200, step - (2 * len(X) < self.most))
            self.turn_to_chart()
        return found


def at_part(X, part, step, bits):
    """Value and derivative of a series at the fraction part (an integer over 2^bits) of its step."""
    value = slope = 0
    for k in range(len(X) - 1, 0, -1):
        value = (value * part >> bits) + X[k]
        slope = (slope * part >> bits) + k * X[k]
    return (value * part >> bits) + X[0], shifted(slope, -step)
