"""Taylor integration of x'' = -(c1 x + c3 x^3 + c5 x^5) with its linearised equation, in fixed point.

Numbers are integers over 2^bits, times are integers over 2^bits too, steps are powers of two. Where |x| is large the
same motion is followed in 1/x (c5 = 0: w'' = -(c1 w - 4E w^3)) or in 1/x^2 (s'' = 12 E s^2 - 4 c1 s - c3), which are
regular at the escape. No closed form is used. A column is the derivative of (x, x') by one of the inputs.
"""

from operator import mul

import mpmath as mp


def fixed(value, bits):
    """A rational or mpf as an integer over 2^bits."""
    if isinstance(value, mp.mpf):
        return int(mp.nint(mp.ldexp(value, bits)))
    return (value.numerator << bits) // value.denominator


def product(a, b, k, bits):
    """Coefficient k of the product of two series."""
    return sum(map(mul, a, b[k::-1])) >> bits


def converged(X, D, bits):
    """Whether the state is complete to the last bit and the columns, which need no more, to 100 bits."""
    if not all(-2 <= c <= 2 for c in X[-5:]):
        return False
    return all(max(map(abs, d[-5:])) <= max(abs(d[0]), abs(d[1]), 1 << bits) >> 100 for d in D)


def odd_series(x, c, columns, forcing, step, bits, limit):
    """Coefficients times powers of 2^-step of x (from x, x') and of every column; None if limit is too few.

    forcing: for every column the derivatives of (c1, c3, c5) by its input."""
    c1, c3, c5 = c
    X = [x[0], x[1] >> step]
    D = [[d[0], d[1] >> step] for d in columns]
    W, X3, X5, V, K = [], [], [], [], []
    fifth = c5 != 0 or any(f[2] for f in forcing)
    for k in range(limit):
        W.append(product(X, X, k, bits))
        X3.append(product(X, W, k, bits))
        K.append((3 * c3 * W[k] >> bits) + (c1 if k == 0 else 0))
        force = c1 * X[k] + c3 * X3[k]
        if fifth:
            X5.append(product(X3, W, k, bits))
            V.append(product(W, W, k, bits))
            K[k] += 5 * c5 * V[k] >> bits
            force += c5 * X5[k]
        divisor = (k + 1) * (k + 2) << (2 * step)
        X.append(-(force >> bits) // divisor)
        for d, f in zip(D, forcing, strict=True):
            total = sum(map(mul, d, K[k::-1])) + f[0] * X[k] + f[1] * X3[k]
            if f[2]:
                total += f[2] * X5[k]
            d.append(-(total >> bits) // divisor)
        if k > 6 and converged(X, D, bits):
            return X, D
    return None


def square_series(s, c, columns, forcing, step, bits, limit):
    """The same for s'' = c0 + c1 s + c2 s^2."""
    c0, c1, c2 = c
    X = [s[0], s[1] >> step]
    D = [[d[0], d[1] >> step] for d in columns]
    W, K = [], []
    for k in range(limit):
        W.append(product(X, X, k, bits))
        K.append((2 * c2 * X[k] >> bits) + (c1 if k == 0 else 0))
        divisor = (k + 1) * (k + 2) << (2 * step)
        X.append(((c1 * X[k] + c2 * W[k] >> bits) + (c0 if k == 0 else 0)) // divisor)
        for d, f in zip(D, forcing, strict=True):
            total = sum(map(mul, d, K[k::-1])) + f[1] * X[k] + f[2] * W[k]
            d.append(((total >> bits) + (f[0] if k == 0 else 0)) // divisor)
        if k > 6 and converged(X, D, bits):
            return X, D
    return None


def at(X, part, step, bits):
    """Value and derivative of a series at the fraction part (an integer over 2^bits) of its step."""
    value = slope = 0
    for k in range(len(X) - 1, 0, -1):
        value = (value * part >> bits) + X[k]
        slope = (slope * part >> bits) + k * X[k]
    return (value * part >> bits) + X[0], slope << step


def reciprocal(state):
    """(x, x') to (1/x, (1/x)'), an involution; columns go along by the chain rule."""
    x, y = state[0]
    return [(1 / x, -y / x**2)] + [(-d / x**2, -e / x**2 + 2 * y * d / x**3) for d, e in state[1:]]


def to_square(state):
    x, y = state[0]
    return [(x**-2, -2 * y * x**-3)] + [(-2 * d * x**-3, -2 * e * x**-3 + 6 * y * d * x**-4) for d, e in state[1:]]


def from_square(state, side):
    s, r = state[0]
    f, g, h = side / mp.sqrt(s), side * s ** mp.mpf("-1.5") / 2, side * 3 * s ** mp.mpf("-2.5") / 4
    return [(f, -g * r)] + [(-g * d, -g * e + h * r * d) for d, e in state[1:]]


class Sweep:
    """One pass over an orbit in units where |x| is 1 at the largest feature and no rate exceeds 16.

    start: rational (x0, x0'); c: rational (c1, c3, c5); slopes: how many of the columns x0, x0', c5 to follow;
    pace: the most terms of a series are bits / pace (steps shrink), the least half of that (steps grow)."""

    def __init__(self, start, c, slopes, unbounded, pace, bits):
        x0, y0 = start
        c1, c3, c5 = c
        self.bits, self.step, self.c = bits, 5, c
        self.most = int(bits / pace)
        self.energy = y0**2 / 2 + c1 * x0**2 / 2 + c3 * x0**4 / 4 + c5 * x0**6 / 6
        by_energy = [c1 * x0 + c3 * x0**3 + c5 * x0**5, y0, x0**6 / 6][:slopes]
        zero, one = 0, 1 << bits
        first = [(one, 0), (0, one), (0, 0)][:slopes]
        E = self.energy

        def of(value):
            return fixed(value, bits)

        self.charts = {
            "x": (odd_series, list(map(of, c)), [(0, 0, 0), (0, 0, 0), (0, 0, one)][:slopes]),
            "reciprocal": (odd_series, [of(c1), of(-4 * E), 0], [(zero, of(-4 * e), 0) for e in by_energy]),
            "square": (square_series, [of(-c3), of(-4 * c1), of(12 * E)], [(0, 0, of(12 * e)) for e in by_energy]),
        }
        self.outer = ("square" if c5 else "reciprocal") if unbounded else None
        self.side = 1
        self.chart = "x"
        self.state = [(of(x0), of(y0)), *first]
        self.turn_to_chart()

    def numbers(self, state):
        return [(mp.ldexp(mp.mpf(a), -self.bits), mp.ldexp(mp.mpf(b), -self.bits)) for a, b in state]

    def in_x(self, state, chart):
        """The state as mpf in x itself."""
        state = self.numbers(state)
        if chart == "reciprocal":
            return reciprocal(state)
        return from_square(state, self.side) if chart == "square" else state

    def turn_to_chart(self):
        """Change the variable where |x| > 1.5 or 1/|x| > 1.5; the gap prevents changes at every step."""
        size = abs(self.state[0][0]) * 2
        limit = 3 << self.bits
        if self.chart == "x" and self.outer and size > limit:
            self.side = 1 if self.state[0][0] > 0 else -1
            state = self.numbers(self.state)
            state = reciprocal(state) if self.outer == "reciprocal" else to_square(state)
            self.chart = self.outer
        elif self.chart != "x" and size > limit:
            state, self.chart = self.in_x(self.state, self.chart), "x"
        else:
            return
        self.state = [(fixed(a, self.bits), fixed(b, self.bits)) for a, b in state]

    def run(self, targets, escapes=False):
        """States in x at the ascending times (mpf or rational); escapes: the last one is raw, in its chart."""
        bits = self.bits
        times = [fixed(t, bits) for t in targets]
        now, found = 0, []
        while len(found) < len(times):
            series, c, forcing = self.charts[self.chart]
            while (result := series(self.state[0], c, self.state[1:], forcing, self.step, bits, self.most)) is None:
                self.step += 1
            X, D = result
            step = self.step
            length = 1 << (bits - step)
            while len(found) < len(times) and times[len(found)] <= now + length:
                part = (times[len(found)] - now) << step
                state = [at(f, part, step, bits) for f in (X, *D)]
                raw = escapes and len(found) == len(times) - 1
                found.append(self.numbers(state) if raw else self.in_x(state, self.chart))
            now += length
            self.state = [(sum(f), sum(map(mul, f, range(len(f)))) << step) for f in (X, *D)]
            self.step = max(0, step - (2 * len(X) < self.most))
            self.turn_to_chart()
        return found
