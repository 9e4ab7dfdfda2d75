"""The energy equation u'^2 = G(u^2) of u'' + a u + b u^3 + c u^5 = 0: regime, range, period and escape times.

G(y) = 2E - a y - b y^2 / 2 - c y^3 / 3 has rational coefficients. Multiple roots come from the Euclidean algorithm. Real
roots are isolated in balls, and compared at rising precision until they are separate. Periods and escape times are integrals
in balls (Arb); the substitutions u = A sin, A sec and tan remove the singular ends.
"""

from fractions import Fraction

import mpmath as mp
from exact import mpf, rational, real
from flint import acb, arb, ctx, fmpq, fmpz_poly


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

    def escape_time(self, backward, goal):
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
            # no turning point before infinity; the unit of length is 1 in the scaled orbit
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
        """The largest |u'| of a bounded orbit: at the start, at u = 0 or at an equilibrium between the turning points."""
        if self.regime == "rest":
            return mpf(0)
        low, high = (real(rational(b)) for b in self.bounds(120))
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
        """P(sin^2 phi) on a ball by Taylor's formula: next to a double root direct evaluation loses the sign."""
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
