"""Truth for one orbit of u'' + a u + b u^3 + c u^5 = 0 with any real a, b, c and any start.

The regime follows from exact algebra: u'^2 = G(u^2), G(y) = 2E - a y - b y^2 / 2 - c y^3 / 3 with rational
coefficients, multiple roots found by the Euclidean algorithm, real roots isolated and compared in balls until they
part. Periods and escape times are integrals of the energy equation in balls (Arb), with the ends taken out by
u = A sin, A sec, s tan. The motion is integrated by Taylor series (taylor.py); whole periods are taken off before.
Conditions: derivatives by u0, velocity0 (and c) from the linearised equation; the others from the two scalings
  u0 d/du0 + v0 d/dv0 - 2 b d/db - 4 c d/dc = u,  t d/dt - v0 d/dv0 - 2 a d/da - 2 b d/db - 2 c d/dc = 0  (of u).
"""

from fractions import Fraction

import mpmath as mp
from exact import agreement, decimal, hi_lo, mpf, real
from flint import acb, arb, ctx, fmpq, fmpz_poly
from taylor import Sweep

SETTLED = mpf(10) ** -50
OUTPUTS = (
    "regime u_hi u_lo velocity_hi velocity_lo period_hi period_lo low_hi low_lo high_hi high_lo energy_hi energy_lo "
    "escape_hi escape_lo escape_backward_hi escape_backward_lo scale_u scale_velocity "
    "cond_u cond_velocity cond_period cond_escape cond_escape_backward"
).split()


def ball(fraction):
    return arb(fmpq(fraction.numerator, fraction.denominator))


def middle(x):
    """The midpoint of a ball as an mpf, exactly."""
    mantissa, exponent = x.mid().man_exp()
    with mp.workprec(max(53, int(mantissa).bit_length())):
        return mp.ldexp(mpf(int(mantissa)), int(exponent))


def narrow(evaluate, goal):
    """evaluate() with the precision raised until its ball has goal good bits."""
    bits = goal + 64
    for _ in range(14):
        with ctx.workprec(bits):
            x = evaluate()
            if x is not None and x.is_finite() and (x == 0 or x.rel_accuracy_bits() >= goal):
                return middle(x)
        bits = bits * 3 // 2
    raise ArithmeticError("a ball does not narrow")


def power_of_two(fraction):
    """An exponent e with 2^e within a factor 2 of |fraction|."""
    return abs(fraction.numerator).bit_length() - fraction.denominator.bit_length()


def scaled(fraction, exponent):
    return fraction * Fraction(2) ** exponent


def sign(x):
    return (x > 0) - (x < 0)


def value(polynomial, x):
    """Horner; coefficients from the constant upwards."""
    total = polynomial[-1]
    for coefficient in polynomial[-2::-1]:
        total = total * x + coefficient
    return total


def derivative(polynomial):
    return [k * c for k, c in enumerate(polynomial)][1:] or [Fraction(0)]


def trimmed(polynomial):
    while len(polynomial) > 1 and polynomial[-1] == 0:
        polynomial = polynomial[:-1]
    return polynomial


def quotient(polynomial, root):
    """polynomial / (y - root) by synthetic division, the remainder dropped."""
    out = [polynomial[-1]]
    for coefficient in polynomial[-2:0:-1]:
        out.append(out[-1] * root + coefficient)
    return out[::-1]


def remainder(a, b):
    a = list(a)
    while len(a) >= len(b) and any(a):
        factor = a[-1] / b[-1]
        for k in range(len(b)):
            a[len(a) - len(b) + k] -= factor * b[k]
        a.pop()
    return trimmed(a or [Fraction(0)])


def multiple_root(polynomial):
    """The double or triple root of a polynomial of degree at most 3, which is rational, or None."""
    if len(polynomial) < 3:
        return None
    a, b = polynomial, derivative(polynomial)
    while any(b):
        a, b = b, remainder(a, b)
    if len(a) == 1:
        return None
    return -a[-2] / (a[-1] * (len(a) - 1))


class End:
    """A turning point ("turn") or an equilibrium never reached ("limit"): where G(y) = 0, on this side of u = 0."""

    def __init__(self, side, kind, exact, polynomial=None, index=0):
        self.side, self.kind, self.exact, self.polynomial, self.index = side, kind, exact, polynomial, index

    def square(self):
        """y as a ball at the working precision."""
        return ball(self.exact) if self.exact is not None else positive_roots(self.polynomial)[self.index]

    def u(self):
        return self.side * self.square().sqrt()


def positive_roots(polynomial):
    """The positive roots of a polynomial without multiple roots, ascending, as balls."""
    if len(polynomial) < 2:
        return []
    common = 1
    for c in polynomial:
        common = common * c.denominator
    integer = fmpz_poly([int(c * common) for c in polynomial])
    # isolates complex roots from each other; the real ones have an imaginary part that is exactly 0
    found = [root.real for root, _ in integer.complex_roots() if root.imag == 0]
    return sorted((root for root in found if root > 0), key=lambda root: root.mid())


class Orbit:
    """start = (u0, velocity0), c = (a, b, c): rationals."""

    def __init__(self, start, c):
        self.u0, self.v0 = start
        self.c = a, b, c5 = c
        y = self.u0**2
        self.y0 = y
        self.G = trimmed([self.v0**2 + a * y + b * y**2 / 2 + c5 * y**3 / 3, -a, -b / 2, -c5 / 3])
        self.energy = self.G[0] / 2
        self.acceleration = -self.u0 * (a + b * y + c5 * y**2)
        self.linear = b == 0 and c5 == 0
        self.lower = self.upper = None
        if self.v0 == 0 and self.acceleration == 0:
            self.regime = "rest"
        else:
            self.lower, self.upper = self.ends()
            self.regime = self.name()

    def ends(self):
        """The nearest roots below and above the start; None where the motion has no bound."""
        G, known = self.G, []
        for root in {Fraction(0), self.y0 if self.v0 == 0 else Fraction(0), multiple_root(G) or Fraction(0)}:
            count = 0
            while len(G) > 1 and value(G, root) == 0:
                G, count = quotient(G, root), count + 1
            if count and root >= 0:
                known.append((root, count))
        ends = []
        for root, count in known:
            kind = "turn" if count == 1 and root > 0 else "limit"
            ends += [(side, End(side, kind, root)) for side in ((-1, 1) if root > 0 else (0,))]
        with ctx.workprec(64):
            number = len(positive_roots(G))
        for index in range(number):
            ends += [(side, End(side, "turn", None, G, index)) for side in (-1, 1)]
        below, above = [], []
        for _, end in ends:
            order = self.order(end)
            if order == 0:  # the start is a turning point
                order = -1 if self.acceleration > 0 else 1
            (below if order < 0 else above).append(end)
        return self.nearest(below, 1), self.nearest(above, -1)

    def order(self, end):
        """Sign of end - u0."""
        here = sign(self.u0) * self.y0
        if end.exact is not None:
            return sign(end.side * end.exact - here)
        if end.side != sign(self.u0):
            return end.side
        bits = 128
        while bits < 1 << 16:
            with ctx.workprec(bits):
                gap = end.side * end.square() - ball(here)
                if gap > 0 or gap < 0:
                    return 1 if gap > 0 else -1
            bits *= 2
        raise ArithmeticError("a root and the start do not part")

    @staticmethod
    def nearest(ends, direction):
        bits = 128
        while ends and bits < 1 << 16:
            with ctx.workprec(bits):
                keys = [direction * end.side * end.square() for end in ends]
                best = max(range(len(ends)), key=lambda k: keys[k].mid())
                if all(k == best or keys[k] < keys[best] for k in range(len(ends))):
                    return ends[best]
            bits *= 2
        if ends:
            raise ArithmeticError("two roots do not part")
        return None

    def name(self):
        if self.linear:
            return "linear"
        if self.lower is None or self.upper is None:
            return "escape"
        kinds = {self.lower.kind, self.upper.kind}
        if kinds == {"turn"}:
            return "libration" if self.lower.side < 0 < self.upper.side else "well"
        return "heteroclinic" if kinds == {"limit"} else "homoclinic"

    def periodic(self):
        return bool(self.lower and self.upper and {self.lower.kind, self.upper.kind} == {"turn"})

    def stiffness(self):
        """The derivative of the force at the start, which is an equilibrium."""
        return self.c[0] + 3 * self.c[1] * self.y0 + 5 * self.c[2] * self.y0**2

    def period(self, goal):
        if self.regime == "rest":
            k = self.stiffness()
            return narrow(lambda: 2 * arb.pi() / ball(k).sqrt(), goal) if k > 0 else mp.inf
        if not self.periodic():
            return mp.inf

        def through():
            A2 = self.upper.square()
            H = quotient([ball(g) for g in self.G], A2)
            return 4 * integral([-h * A2**j for j, h in enumerate(H)], 0, 0)

        def one_sided():
            ya, yb = sorted((self.lower.square(), self.upper.square()), key=lambda y: y.mid())
            H = [-h for h in quotient(quotient([ball(g) for g in self.G], ya), yb)]
            y = [ya, yb - ya]
            total = times(y, [H[0]])
            if len(H) > 1:
                total = plus(total, times(times(y, y), [H[1]]))
            return 2 * integral(total, 0, 0)

        return narrow(through if self.lower.side < 0 < self.upper.side else one_sided, goal)

    def flight(self, backward, goal):
        """Time to infinity, positive, or inf."""
        direction = -sign(self.v0) if backward else sign(self.v0)
        direction = direction or sign(self.acceleration)
        if self.linear or direction == 0:
            return mp.inf
        ahead, behind = (self.upper, self.lower)[::direction]
        if ahead is not None and (ahead.kind == "limit" or behind is not None):
            return mp.inf
        degree = len(self.G) - 1
        turn = ahead or behind
        if turn is not None and turn.kind == "turn":
            # out from the turning point A by u = A sec(phi); sec(phi0) = u0 / A

            def outward():
                A2 = turn.square()
                H = quotient([ball(g) for g in self.G], A2)
                start = arb(0)
                if self.v0:
                    over = ball(abs(self.v0)) / value(H, ball(self.y0)).sqrt()
                    start = (over / A2.sqrt()).atan() * (1 if ahead is None else -1)

                total = [arb(0)]
                for j, h in enumerate(H):
                    total = plus(total, times([h * A2**j], power([arb(1), arb(-1)], degree - 1 - j)))
                return integral(total, start, degree - 2)

            return narrow(outward, goal)

        def straight():
            # no turning point on the way; the unit of length is 1 in the scaled orbit
            total = [arb(0)]
            for j, g in enumerate(self.G):
                part = times(power([arb(0), arb(1)], j), power([arb(1), arb(-1)], degree - j))
                total = plus(total, times([ball(g)], part))
            return integral(total, (direction * ball(self.u0)).atan(), degree - 2)

        return narrow(straight, goal)

    def bounds(self, goal):
        """(lowest, highest) u as mpf, infinite where there is no bound."""
        if self.regime == "rest":
            return real(self.u0), real(self.u0)
        return tuple(
            side * mp.inf if end is None else narrow(end.u, goal) for side, end in ((-1, self.lower), (1, self.upper))
        )

    def fastest(self):
        """The largest |u'| of a bounded orbit: at the start, at u = 0 or at an equilibrium on the way."""
        if self.regime == "rest":
            return mpf(0)
        low, high = (real(mp_rational(b)) for b in self.bounds(120))
        squares = [real(self.y0)]
        if low <= 0 <= high:
            squares.append(mpf(0))
        with ctx.workprec(200):
            force = trimmed([-g for g in derivative(self.G)])
            doubled = multiple_root(force)
            for y in [ball(doubled)] if doubled else positive_roots(force):
                u = mp.sqrt(abs(middle(y)))
                if low <= u <= high or low <= -u <= high:
                    squares.append(u * u)
        G = [real(g) for g in self.G]
        return mp.sqrt(max(value(G, y) for y in squares))


def mp_rational(x):
    from exact import rational

    return rational(x)


def plus(a, b):
    short, long = sorted((a, b), key=len)
    return [x + y for x, y in zip(short, long, strict=False)] + long[len(short) :]


def times(a, b):
    out = [arb(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def power(a, exponent):
    out = [arb(1)]
    for _ in range(exponent):
        out = times(out, a)
    return out


def integral(P, start, cosines):
    """The integral of cos^cosines / sqrt(P(sin^2)) from start to pi/2, as a ball."""
    dP = [k * p for k, p in enumerate(P)][1:] or [arb(0)]
    ddP = [k * p for k, p in enumerate(dP)][1:] or [arb(0)]

    def under(phi):
        """P(sin^2 phi) on a ball by Taylor's formula: next to a double root the plain value loses its sign."""
        centre = acb(phi.real.mid(), phi.imag.mid())
        s2 = centre.sin() ** 2
        here = acb(value(P, s2))
        move = phi - centre
        if move.real.rad() < 2 ** (10 - ctx.prec) and move.imag.rad() < 2 ** (10 - ctx.prec):
            return here if move == 0 else acb(value(P, phi.sin() ** 2))
        wide, twice = phi.sin() ** 2, 2 * phi
        bend = value(ddP, wide) * twice.sin() ** 2 + 2 * value(dP, wide) * twice.cos()
        return here + value(dP, s2) * (2 * centre).sin() * move + bend * move**2 / 2

    def f(phi, analytic):
        root = under(phi).sqrt(analytic=analytic)
        return phi.cos() ** cosines / root if cosines else 1 / root

    return acb.integral(f, acb(start), acb.pi() / 2, eval_limit=10**6, depth_limit=10**4).real


class Scaled:
    """The orbit in units 2^length and 2^-rate, where its features are of order 1."""

    def __init__(self, start, c, times):
        plain = Orbit(start, c)
        (u0, v0), (a, b, c5) = start, c
        if plain.regime == "rest":
            length = power_of_two(u0) if u0 else 0
        elif plain.linear:
            sizes = [power_of_two(u0)] if u0 else []
            if v0 and a:
                sizes.append(power_of_two(v0) - power_of_two(a) // 2)
            elif v0:
                sizes.append(power_of_two(v0 * max(map(abs, times), default=1) or v0))
            length = max(sizes)
        elif plain.lower and plain.upper:
            with ctx.workprec(64):
                sizes = [float_exponent(end.u()) for end in (plain.lower, plain.upper)]
            length = max(size for size in sizes if size is not None)
        else:
            # Cauchy's bound on the roots of G
            top = len(plain.G) - 1
            sizes = [power_of_two(g / plain.G[-1]) / (2 * (top - j)) for j, g in enumerate(plain.G[:-1]) if g]
            length = round(max(sizes)) if sizes else power_of_two(u0)
        self.length = length
        rates = [scaled(abs(a), 1), scaled(7 * abs(b), 2 * length), scaled(26 * abs(c5), 4 * length)]
        if any(rates):
            # an eighth of the bound on the fastest rate: steps in taylor.py are 1 at most, and slow stretches want more
            self.rate = power_of_two(sum(rates)) // 2 - 3
        else:
            self.rate = -power_of_two(max(map(abs, times), default=Fraction(1)) or Fraction(1))
        r = -2 * self.rate
        self.start = scaled(u0, -length), scaled(v0, -length - self.rate)
        self.c = scaled(a, r), scaled(b, r + 2 * length), scaled(c5, r + 4 * length)
        self.times = [scaled(t, self.rate) for t in times]
        self.orbit = Orbit(self.start, self.c)
        if self.orbit.regime != plain.regime:
            raise ArithmeticError("the regime depends on the units")
        self.u_unit, self.t_unit = mp.ldexp(mpf(1), length), mp.ldexp(mpf(1), -self.rate)


def float_exponent(x):
    mid = middle(x)
    return int(mp.mag(mid)) if mid else None


class Ephemeris:
    """States and columns of a scaled orbit at its times, from sweeps forward and backward."""

    def __init__(self, orbit, c, times, slopes, pace, bits):
        self.orbit, self.c, self.slopes, self.pace, self.bits = orbit, c, slopes, pace, bits
        self.unbounded = orbit.regime == "escape"
        self.T = orbit.period(bits) if orbit.periodic() else None
        self.flights = [orbit.flight(backward, bits) for backward in (False, True)]
        self.states, self.by_period, self.by_flight = {}, None, [None, None]
        first = [(real(orbit.u0), real(orbit.v0)), (mpf(1), mpf(0)), (mpf(0), mpf(1)), (mpf(0), mpf(0))]
        self.states[Fraction(0)] = first[: slopes + 1]
        if self.T is not None:
            self.whole_periods(times)
        else:
            for backward in (False, True):
                self.sweep(backward, times)

    def whole_periods(self, times):
        orbit = self.orbit
        turns, rests = {}, []
        for t in times:
            if t:
                most = max(0, power_of_two(t) - int(mp.mag(self.T))) + 4
                T = orbit.period(self.bits + most) if most > 8 else self.T
                with mp.workprec(self.bits + 2 * most + 64):
                    n = int(mp.floor(real(t) / T))
                    turns[t] = n
                    rests.append((real(t) - n * T, t))
        rests.sort()
        targets = [rest for rest, _ in rests]
        if self.slopes:
            targets.append(self.T)
        found = self.run(1, targets, False)
        slope = [mpf(0)] * self.slopes
        if self.slopes:
            last = found.pop()
            (u, v), *columns = last
            close = max(abs(u - real(orbit.u0)), abs(v - real(orbit.v0)))
            if close > mpf(2) ** -150:
                raise ArithmeticError("the integration does not return after the period of the quadrature")
            # u(T) = u0 and v(T) = v0 for all inputs: the dominant one gives dT
            a0, v0 = real(orbit.acceleration), real(orbit.v0)
            start = [(1, 0), (0, 1), (0, 0)]
            for k, (du, dv) in enumerate(columns):
                slope[k] = (start[k][0] - du) / v0 if abs(v0) > abs(a0) else (start[k][1] - dv) / a0
            self.by_period = slope
        for (_, t), state in zip(rests, found, strict=True):
            (u, v), *columns = state
            a, b, c5 = (real(x) for x in self.c)
            force = -u * (a + b * u**2 + c5 * u**4)
            n = turns[t]
            moved = [(du - n * dT * v, dv - n * dT * force) for (du, dv), dT in zip(columns, slope, strict=True)]
            self.states[t] = [(u, v), *moved]

    def run(self, direction, targets, escapes):
        orbit = self.orbit
        start = orbit.u0, direction * orbit.v0
        return Sweep(start, self.c, self.slopes, self.unbounded, self.pace, self.bits).run(targets, escapes)

    def sweep(self, backward, times):
        direction = -1 if backward else 1
        flight = self.flights[backward]
        chosen = sorted((abs(t), t) for t in times if t and sign(t) == direction and real(abs(t)) < flight)
        targets = [real(size) for size, _ in chosen]
        escapes = mp.isfinite(flight) and self.slopes > 0
        if escapes:
            targets.append(flight)
        found = self.run(direction, targets, escapes)
        if escapes:
            (w, dw), *columns = found.pop()
            if abs(w) > mpf(2) ** -150:
                raise ArithmeticError("the integration does not escape when the quadrature does")
            self.by_flight[backward] = [-d / dw for d, _ in columns]
        flips = [1, direction, 1][: self.slopes]
        for (_, t), state in zip(chosen, found, strict=True):
            (u, v), *columns = state
            moved = [(flip * du, flip * direction * dv) for (du, dv), flip in zip(columns, flips, strict=True)]
            self.states[t] = [(u, direction * v), *moved]


def settle(orbit, c, times, slopes, u_size):
    """An Ephemeris with columns that agrees with a shorter one, by other steps, to 50 digits."""
    bits = 270
    for _ in range(10):
        with mp.workprec(bits + 150):
            rough = Ephemeris(orbit, c, times, 0, 3, bits)
            fine = Ephemeris(orbit, c, times, slopes, 2, bits + 80)
            pairs = [(rough.states[t][0][k], fine.states[t][0][k]) for t in fine.states for k in (0, 1)]
            if all(agreement(a, b) < SETTLED for a, b in pairs):
                return fine
        bits += bits // 2
    raise ArithmeticError("two precisions do not agree")


def condition(columns, inputs, c5, total, last):
    """sum |x dz/dx| from the columns u0, v0 (and c5), by the two scalings; total, last: their right-hand sides.

    total = sum of u0 d/du0 + v0 d/dv0 - 2 b d/db - 4 c d/dc; last = v0 d/dv0 + 2 a d/da + 2 b d/db + 2 c d/dc."""
    u0, v0 = inputs
    by = [u0 * columns[0], v0 * columns[1]]
    fifth = c5 * columns[2] if len(columns) > 2 else mpf(0)
    cubic = (by[0] + by[1] - 4 * fifth - total) / 2
    linear = (last - by[1] - 2 * cubic - 2 * fifth) / 2
    return sum(map(abs, (*by, fifth, cubic, linear)))


def rest_period_condition(orbit, T):
    """Sum over the force of the period of small swings; by u0 and velocity0 it is stationary."""
    _a, b, c5 = orbit.c
    k = orbit.stiffness()
    y = orbit.y0
    if y == 0 or c5 == 0:
        return T / 2
    moved = -y * y / (b + 2 * c5 * y)
    fifth = c5 * (4 * y * y + (2 * b + 8 * c5 * y) * moved)
    # the scalings: b d/db = -2 c d/dc of k, and a d/da = k - b d/db - c d/dc
    return real((abs(fifth) + abs(2 * fifth) + abs(k + fifth)) / k) * T / 2


def outputs(u0, velocity0, force, times):
    """The OUTPUTS columns for each of the times; all inputs are doubles."""
    start = Fraction(u0), Fraction(velocity0)
    c = (*map(Fraction, force), Fraction(0))[:3]
    slopes = 3 if c[2] else 2
    exact_times = list(dict.fromkeys(map(Fraction, times)))
    whole = Scaled(start, c, exact_times)
    orbit = whole.orbit
    with mp.workprec(400):
        fine = settle(orbit, whole.c, dict.fromkeys(whole.times), slopes, whole.u_unit)
        unit, second = whole.u_unit, whole.t_unit
        inputs = real(orbit.u0), real(orbit.v0)
        c5 = real(whole.c[2])
        cond_period = mpf(0)
        period = orbit.period(200)
        if orbit.regime == "rest":
            cond_period = rest_period_condition(orbit, period) if mp.isfinite(period) else mpf(0)
        elif fine.by_period:
            cond_period = condition(fine.by_period, inputs, c5, mpf(0), -period)
        # backward columns belong to the motion with velocity0 turned round
        cond_flights = [
            condition(by, (inputs[0], direction * inputs[1]), c5, mpf(0), -flight) if by else mpf(0)
            for by, direction, flight in zip(fine.by_flight, (1, -1), fine.flights, strict=True)
        ]
        low, high = orbit.bounds(200)
        forward, backward = fine.flights
        fixed = [*hi_lo(period * second), *hi_lo(low * unit), *hi_lo(high * unit)]
        fixed += [
            *hi_lo(real(orbit.energy) * (unit / second) ** 2),
            *hi_lo(forward * second),
            *hi_lo(-backward * second),
        ]
        ends = [decimal(x * second, 6) for x in (cond_period, *cond_flights)]
        bounded = mp.isfinite(low) and mp.isfinite(high)
        if bounded:
            scales = max(abs(low), abs(high)), orbit.fastest()
        rows = []
        for t in times:
            moment = scaled(Fraction(t), whole.rate)
            if moment not in fine.states:
                z, conds = (mp.nan, mp.nan), (mpf(0), mpf(0))
            else:
                z, *columns = fine.states[moment]
                u, v = z
                a, b, _ = (real(x) for x in whole.c)
                time, acceleration = real(moment), -u * (a + b * u**2 + c5 * u**4)
                conds = (
                    abs(time * v) + condition([d for d, _ in columns], inputs, c5, u, time * v),
                    abs(time * acceleration)
                    + condition([d for _, d in columns], inputs, c5, v, v + time * acceleration),
                )
            if not bounded:
                known = [x if mp.isfinite(x) else mpf(0) for x in z]
                scales = max(abs(known[0]), abs(inputs[0])), max(abs(known[1]), abs(inputs[1]))
            row = [orbit.regime, *hi_lo(z[0] * unit), *hi_lo(z[1] * unit / second), *fixed]
            row += [decimal(scales[0] * unit, 17), decimal(scales[1] * unit / second, 17)]
            row += [decimal(conds[0] * unit, 6), decimal(conds[1] * unit / second, 6), *ends]
            rows.append(row)
        return rows


def clock(u0, velocity0, force):
    """(period, escape, backward escape, unit of time) good enough to choose instants; inf where there is none."""
    start = Fraction(u0), Fraction(velocity0)
    whole = Scaled(start, (*map(Fraction, force), Fraction(0))[:3], [])
    orbit, unit = whole.orbit, whole.t_unit
    with mp.workprec(120):
        return orbit.period(100) * unit, orbit.flight(False, 100) * unit, -orbit.flight(True, 100) * unit, unit


def regime(u0, velocity0, force):
    return Orbit((Fraction(u0), Fraction(velocity0)), (*map(Fraction, force), Fraction(0))[:3]).regime
