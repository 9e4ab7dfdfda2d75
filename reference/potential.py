"""The energy equation u'^2 = P(u) of u'' + f0 + f1 u + ... + f5 u^5 = 0: regime, range, period, action and escape times.

P has rational coefficients. Factors without multiple roots come from greatest common divisors, their real roots are isolated
in balls and compared at rising precision until they are separate. Times and actions are integrals in balls (Arb); the
substitutions u = a + (b - a) sin^2, u = b + tan^2 and u = tan remove the singular ends.
"""

import math
from fractions import Fraction
from itertools import pairwise

import mpmath as mp
from energy import ball, narrow, plus, power, sign, times, trimmed, value
from exact import mpf, real
from flint import acb, acb_poly, arb, ctx, fmpz_poly


def kinetic(start, force):
    """The coefficients of P from the constant upwards."""
    u0, v0 = start
    rising = [Fraction(0), *(2 * f / (k + 1) for k, f in enumerate(force))]
    return trimmed([v0**2 + value(rising, u0), *(-x for x in rising[1:])])


def integer(polynomial):
    common = math.lcm(*(c.denominator for c in polynomial))
    return fmpz_poly([int(c * common) for c in polynomial])


def divided(polynomial, root):
    """(polynomial / (u - root)^n, n) with the largest n; root is rational."""
    count = 0
    while len(polynomial) > 1 and value(polynomial, root) == 0:
        out = [polynomial[-1]]
        for coefficient in polynomial[-2:0:-1]:
            out.append(out[-1] * root + coefficient)
        polynomial, count = out[::-1], count + 1
    return polynomial, count


class Root:
    """A real root of P: rational, or number `index` of the real roots of a factor."""

    def __init__(self, count, exact, factor=None, index=0):
        self.count, self.exact, self.factor, self.index = count, exact, factor, index
        self.kind = "turn" if count == 1 else "limit"
        self.known = {}

    def u(self):
        """A ball at the working precision."""
        if self.exact is not None:
            return ball(self.exact)
        if ctx.prec not in self.known:
            self.known[ctx.prec] = real_roots(self.factor)[self.index]
        return self.known[ctx.prec]

    def above(self, x):
        """Whether the root is above the rational x, which it is not equal to."""
        if self.exact is not None:
            return self.exact > x
        bits = 128
        while bits < 1 << 17:
            with ctx.workprec(bits):
                gap = self.u() - ball(x)
                if gap > 0 or gap < 0:
                    return bool(gap > 0)
            bits *= 2
        raise ArithmeticError("a root and a number do not part")


def real_roots(factor):
    """The real roots of an integer polynomial without multiple roots, ascending, as balls."""
    # isolates complex roots from each other; the real ones have an imaginary part that is exactly 0
    found = [root.real for root, _ in factor.complex_roots() if root.imag == 0]
    return sorted(found, key=lambda root: root.mid())


def ordered(roots):
    """Roots from the lowest to the highest."""
    bits = 128
    while bits < 1 << 17:
        with ctx.workprec(bits):
            keyed = sorted(((root.u(), root) for root in roots), key=lambda pair: pair[0].mid())
            if all(a[0] < b[0] for a, b in pairwise(keyed)):
                return [root for _, root in keyed]
        bits *= 2
    raise ArithmeticError("two roots do not part")


def all_roots(P, known):
    """Every real root of P; `known` are rationals that may be roots."""
    roots = []
    for x in set(known):
        P, count = divided(P, x)
        if count:
            roots.append(Root(count, x))
    if len(P) > 1:
        for factor, count in integer(P).factor_squarefree()[1]:
            with ctx.workprec(64):
                number = len(real_roots(factor))
            if factor.degree() == 1:
                roots.append(Root(count, Fraction(-int(factor[0]), int(factor[1]))))
            else:
                roots += [Root(count, None, factor, index) for index in range(number)]
    return ordered(roots)


def homogeneous(polynomial, degree):
    """Coefficients of sin^k cos^(degree - k) of a polynomial in sin^2."""
    total = [arb(0)]
    for j, h in enumerate(polynomial):
        part = times([arb(0)] * (2 * j) + [h], power([arb(1), arb(0), arb(1)], degree // 2 - j))
        total = plus(total, part)
    return total + [arb(0)] * (degree + 1 - len(total))


def in_exponentials(H):
    """G with sum H_k sin^k cos^(n - k) = G(z) z^(-n/2), z = exp(2 i angle), n even."""
    n = len(H) - 1
    total = acb_poly([0])
    below, above, unit = acb_poly([-1, 1]), acb_poly([1, 1]), acb(0, -1) / 2
    for k, h in enumerate(H):
        total += below**k * above ** (n - k) * (acb(h) * unit**k / 2 ** (n - k))
    return total


def integral(H, start, end, goal, weight=None, above=False):
    """The integral of weight / sqrt(H), or of weight sqrt(H), over an angle; H homogeneous in sine and cosine."""
    half = (len(H) - 1) // 2
    G = in_exponentials(H)
    dG = acb_poly([g * acb(0, 2 * (k - half)) for k, g in enumerate(G)])
    ddG = acb_poly([g * acb(0, 2 * (k - half)) for k, g in enumerate(dG)])

    def under(phi):
        """H on a ball by Taylor's formula: next to a double root direct evaluation loses the sign."""
        centre = acb(phi.real.mid(), phi.imag.mid())
        move = phi - centre
        narrow_one = move.real.rad() < 2 ** (10 - ctx.prec) and move.imag.rad() < 2 ** (10 - ctx.prec)
        if move == 0 or narrow_one:
            z = (acb(0, 2) * phi).exp()
            return G(z) / z**half
        z, wide = (acb(0, 2) * centre).exp(), (acb(0, 2) * phi).exp()
        return (G(z) + dG(z) * move) / z**half + ddG(wide) / wide**half * move**2 / 2

    def f(phi, analytic):
        root = under(phi).sqrt(analytic=analytic)
        over = root if above else 1 / root
        return weight(phi) * over if weight else over

    room = arb(2) ** -(goal + 16)
    return acb.integral(f, acb(start), acb(end), rel_tol=room, eval_limit=10**6, depth_limit=10**4).real


def plus_exact(a, b):
    return [x + (b[k] if k < len(b) else 0) for k, x in enumerate(a)]


def half_pi():
    return arb.pi() / 2


class PotentialOrbit:
    """The orbit with u'^2 = P(u) through start = (u0, velocity0); force = (f0, ..., f5), rationals."""

    def __init__(self, start, force):
        self.u0, self.v0 = start
        self.force = trimmed([Fraction(f) for f in force])
        self.P = kinetic(start, self.force)
        self.acceleration = -value(self.force, self.u0)
        self.linear = len(self.force) <= 2
        self.lower = self.upper = None
        self.roots = []
        if self.v0 == 0 and self.acceleration == 0:
            self.regime = "rest"
            return
        known = [Fraction(0)] + ([self.u0] if self.v0 == 0 else [])
        self.roots = all_roots(self.P, known)
        for root in self.roots:
            above = self.acceleration < 0 if root.exact == self.u0 else root.above(self.u0)
            if not above:
                self.lower = root
            elif self.upper is None:
                self.upper = root
        self.regime = self.name()

    @classmethod
    def of_energy(cls, twice, force, inside):
        """The motion with 2E = twice whose range holds the rational `inside`, where P is positive; without a start."""
        orbit = cls.__new__(cls)
        orbit.force = trimmed([Fraction(f) for f in force])
        orbit.P = trimmed([twice, *(-2 * f / (k + 1) for k, f in enumerate(orbit.force))])
        orbit.linear = len(orbit.force) <= 2
        orbit.roots = all_roots(orbit.P, [Fraction(0)])
        orbit.lower = [root for root in orbit.roots if not root.above(inside)][-1]
        orbit.upper = next(root for root in orbit.roots if root.above(inside))
        orbit.regime = orbit.name()
        return orbit

    def name(self):
        if self.linear:
            return "linear"
        if self.lower is None or self.upper is None:
            return "escape"
        kinds = {self.lower.kind, self.upper.kind}
        if kinds == {"turn"}:
            return "well" if self.in_well() else "libration"
        return "heteroclinic" if kinds == {"limit"} else "homoclinic"

    def in_well(self):
        """Whether another well holds a motion of the same energy (forces to u^3), or the motion is beside 0 (to u^5)."""
        if len(self.P) <= 5:
            return len(self.P) == 5 and self.P[-1] < 0 and len(self.roots) == 4
        zero = Fraction(0)
        return self.P[0] <= 0 or self.lower.above(zero) or not self.upper.above(zero)

    def periodic(self):
        return bool(self.lower and self.upper and {self.lower.kind, self.upper.kind} == {"turn"})

    def stiffness(self):
        """The derivative of the force at the start."""
        return value([k * f for k, f in enumerate(self.force)][1:] or [Fraction(0)], self.u0)

    def beside(self):
        """Q with P = (u - a) (b - u) Q between the turning points a < b, in sin^2 of u = a + (b - a) sin^2; a; b - a."""
        a, b = self.lower.u(), self.upper.u()
        Q = [ball(g) for g in self.P]
        for root in (a, b):
            out = [Q[-1]]
            for coefficient in Q[-2:0:-1]:
                out.append(out[-1] * root + coefficient)
            Q = out[::-1]
        total = [arb(0)]
        for q in Q[::-1]:
            total = plus(times(total, [a, b - a]), [-q])
        return total[: len(Q)], a, b - a

    def over_period(self, evaluate, goal):
        """narrow() of evaluate(H, a, b - a)."""

        def whole():
            Q, a, wide = self.beside()
            return evaluate(homogeneous(Q, 2 * (len(Q) - 1)), a, wide)

        return narrow(whole, goal)

    def period(self, goal):
        if self.regime == "rest":
            k = self.stiffness()
            return narrow(lambda: 2 * arb.pi() / ball(k).sqrt(), goal) if k > 0 else mp.inf
        if not self.periodic():
            return mp.inf
        return self.over_period(lambda H, a, wide: 4 * integral(H, 0, half_pi(), goal), goal)

    def action(self, goal):
        """The integral of u' du / pi from the lowest to the highest u, for a motion that never escapes."""
        if self.regime == "rest":
            return mpf(0)

        def evaluate(H, a, wide):
            share = integral(H, 0, half_pi(), goal, lambda phi: (2 * phi).sin() ** 2 / 4, above=True)
            return 2 * wide**2 * share / arb.pi()

        return self.over_period(evaluate, goal)

    def mean_power(self, power, goal):
        """The mean of u^power over a period."""
        if power % 2 and self.centre() == 0:
            return mpf(0)

        def evaluate(H, a, wide):
            return 4 * integral(H, 0, half_pi(), goal, lambda phi: (a + wide * phi.sin() ** 2) ** power)

        return self.over_period(evaluate, goal) / self.period(goal)

    def since_top(self, goal):
        """The time between the start and the highest u next to it, either way, of a periodic motion."""
        if self.v0 == 0:
            return self.period(goal) / 2 if self.acceleration > 0 else mpf(0)

        def evaluate(H, a, wide):
            below = ball(self.u0) - a
            start = (below / (wide - below)).sqrt().atan()
            return 2 * integral(H, start, half_pi(), goal)

        return self.over_period(evaluate, goal)

    def centre(self):
        """The rational middle of the range if the motion is symmetric about it, exactly; else None."""
        top = len(self.P) - 1
        middle_of = -self.P[-2] / (top * self.P[-1])
        if value(self.P, middle_of) <= 0 or self.lower.above(middle_of) or not self.upper.above(middle_of):
            return None
        moved = [Fraction(0)]
        for g in self.P[::-1]:
            moved = plus_exact([Fraction(0), *moved], [middle_of * x for x in moved])
            moved[0] += g
        return None if any(moved[1::2]) else middle_of

    def escape_time(self, backward, goal):
        """Time to infinity, positive, or inf."""
        way = -sign(self.v0) if backward else sign(self.v0)
        way = way or sign(self.acceleration)
        if self.linear or way == 0:
            return mp.inf
        ahead, behind = (self.upper, self.lower)[::way]
        if ahead is not None and (ahead.kind == "limit" or behind is not None):
            return mp.inf
        # in y = side u the escape is upwards
        side = way if ahead is None else -way
        P = [g * side**k for k, g in enumerate(self.P)]
        degree = len(P) - 1
        turn = ahead or behind
        if turn is None or (turn.kind == "limit" and degree % 2):
            lower = [root for root in self.roots[::side] if root.count % 2]
            turn = lower[-1] if degree % 2 else None
        y0 = side * self.u0
        if turn is not None and turn.count % 2:

            def outward():
                b = side * turn.u()
                Q = list(map(ball, P))
                out = [Q[-1]]
                for coefficient in Q[-2:0:-1]:
                    out.append(out[-1] * b + coefficient)
                at_b = [arb(0)]
                for q in out:
                    at_b = plus(times(at_b, [b, arb(1)]), [q])
                at_b = at_b[:degree]
                start = arb(0)
                if self.v0:
                    # y0 - b = v0^2 / Q(y0)
                    start = (ball(abs(self.v0)) / value(out[::-1], ball(y0)).sqrt()).atan()
                    start = start if ahead is None else -start
                # sum of h_j tan^2j, times cos^2(degree - 1)
                H = [at_b[k // 2] if k % 2 == 0 else arb(0) for k in range(2 * degree - 1)]
                more = degree - 3
                return 2 * integral(H, start, half_pi(), goal, (lambda phi: phi.cos() ** more) if more else None)

            return narrow(outward, goal)

        def straight():
            H = [ball(g) for g in P]
            more = degree // 2 - 2
            weight = (lambda phi: phi.cos() ** more) if more else None
            return integral(H, ball(y0).atan(), half_pi(), goal, weight)

        return narrow(straight, goal)

    def bounds(self, goal):
        """(lowest, highest) u as mpf, infinite where there is no bound."""
        if self.regime == "rest":
            return real(self.u0), real(self.u0)
        return tuple(
            way * mp.inf if end is None else narrow(end.u, goal) for way, end in ((-1, self.lower), (1, self.upper))
        )

    def fastest(self):
        """The largest |u'| of a bounded orbit: at the start or at an equilibrium between its ends."""
        if self.regime == "rest":
            return mpf(0)
        low, high = self.bounds(120)
        places = [real(self.u0)]
        for root in all_roots(self.force, [Fraction(0), self.u0]):
            u = narrow(root.u, 120)
            if low <= u <= high:
                places.append(u)
        P = [real(g) for g in self.P]
        return mp.sqrt(max(value(P, u) for u in places))
