"""The pendulum with friction and torque: writes vectors/damped.csv and vectors/damped_slopes.csv.

theta'' + 2 linear v + quadratic |v| v + dry z + omega2 sin theta = torque, v = theta'; z = sgn v, or with presliding
z' = (v - |v| z)/presliding. Taylor series in fixed point: numbers are integers over 2^bits, a series is cut where its terms
vanish, sine and cosine are taken anew at every step. Turns are roots of the series of v by halving. Derivatives are
differences of whole motions. Two sets of bits and steps must agree to 30 digits.
"""

from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
from operator import mul

import mpmath as mp
from damped_inputs import INPUTS, SAMPLE_TIMES, SAMPLE_VALUES, cases
from exact import decimal, hi_lo, write

HEADER = ["id", "stratum", *INPUTS, "samples", "t", "theta_hi", "theta_lo", "velocity_hi", "velocity_lo"]
HEADER += ["scale_theta", "scale_velocity", "cond_theta", "cond_velocity"]
SLOPES_HEADER = ["id", "stratum", *INPUTS, "samples", "t"]
SLOPES_HEADER += [f"d{value}_d{by}" for value in ("theta", "velocity") for by in INPUTS]


def polynomial(kind, i):
    """Coefficients of the powers of the time since sample i."""
    t, y = SAMPLE_TIMES, SAMPLE_VALUES
    if kind == "steps":
        return [y[i]]
    width = t[i + 1] - t[i]
    if kind == "lines":
        return [y[i], (y[i + 1] - y[i]) / width]

    def slope(j):
        # Of Lagrange's parabola on three samples, at sample j.
        a = min(max(j, 1), len(t) - 2) - 1
        total = 0
        for p in range(a, a + 3):
            others = [q for q in range(a, a + 3) if q != p]
            below = (t[p] - t[others[0]]) * (t[p] - t[others[1]])
            total += y[p] * (2 * t[j] - t[others[0]] - t[others[1]]) / below
        return total

    # Hermite's basis.
    rise = (y[i + 1] - y[i]) / width
    d0, d1 = slope(i), slope(i + 1)
    return [y[i], d0, (3 * rise - 2 * d0 - d1) / width, (d0 + d1 - 2 * rise) / width**2]


class DampedMotion:
    """One motion; inputs are rationals, `kind` names the polynomials between samples or is empty."""

    def __init__(self, inputs, kind, bits, most):
        self.__dict__.update(inputs)
        self.kind, self.bits, self.most, self.step = kind, bits, most, 3
        self.one = 1 << bits
        self.t = Fraction(0)
        self.theta = self.fixed(self.theta0)
        self.v = self.fixed(self.velocity0)
        self.z = (self.v > 0) - (self.v < 0) if self.presliding else 0
        self.z *= self.one
        self.side = (self.v > 0) - (self.v < 0)
        self.stuck = False
        self.largest = [abs(self.theta), abs(self.v)]
        if not self.v:
            self.begin()

    def fixed(self, value):
        if isinstance(value, mp.mpf):
            return int(mp.nint(mp.ldexp(value, self.bits)))
        value = Fraction(value)
        return (value.numerator << self.bits) // value.denominator

    def torque(self, step, count):
        """Coefficients of the torque from now on, times powers of 2^-step."""
        phase = (
            mp.mpf(self.frequency.numerator)
            / self.frequency.denominator
            * (mp.mpf(self.t.numerator) / self.t.denominator)
            + mp.mpf(self.phase.numerator) / self.phase.denominator
        )
        series = [0] * count
        if self.amplitude:
            x = mp.expj(phase) * self.amplitude.numerator / self.amplitude.denominator
            rate = mp.ldexp(mp.mpf(self.frequency.numerator) / self.frequency.denominator, -step)
            for k in range(count):
                series[k] = self.fixed(x.real)
                x *= mp.mpc(0, rate) / (k + 1)
        series[0] += self.fixed(self.constant)
        if self.kind:
            i = self.knot() - 1
            since = self.t - SAMPLE_TIMES[i]
            own = polynomial(self.kind, i)
            for k in range(len(own)):
                shifted = sum(own[j] * since ** (j - k) * mp.binomial(j, k).__int__() for j in range(k, len(own)))
                series[k] += self.fixed(shifted / 2 ** (step * k))
        return series

    def knot(self):
        """Index of the first sample after now."""
        return next(i for i, t in enumerate(SAMPLE_TIMES) if t > self.t)

    def circular(self):
        angle = mp.ldexp(mp.mpf(self.theta), -self.bits)
        return self.fixed(mp.sin(angle)), self.fixed(mp.cos(angle))

    def pull(self):
        return self.torque(0, 4)[0] - (self.fixed(self.omega2) * self.circular()[0] >> self.bits)

    def begin(self):
        """From rest: held by dry friction, or the side to which it goes."""
        pull = self.pull()
        self.stuck = bool(self.dry) and not self.presliding and abs(pull) <= self.fixed(self.dry)
        self.side = (pull > 0) - (pull < 0)

    def series(self, step):
        """Coefficients of theta, v, z times powers of 2^-step; None if they are too many."""
        bits = self.bits
        omega2, linear, quadratic, dry = map(self.fixed, (self.omega2, 2 * self.linear, self.quadratic, self.dry))
        sine, cosine = self.circular()
        S, C, V, Z, A = [sine], [cosine], [self.v], [self.z], [self.theta]
        T = self.torque(step, self.most)
        inverse = self.fixed(1 / self.presliding) if self.presliding else 0
        for k in range(self.most - 1):
            reverse = V[::-1]
            square = sum(map(mul, V, reverse)) >> bits
            friction = (linear * V[k] + self.side * quadratic * square) >> bits
            if self.presliding:
                friction += dry * Z[k] >> bits
                slip = V[k] - self.side * (sum(map(mul, Z, reverse)) >> bits)
                Z.append((slip * inverse >> bits) // ((k + 1) << step))
            elif k == 0:
                friction += self.side * dry
            force = T[k] - friction - (omega2 * S[k] >> bits)
            divisor = (k + 1) << step
            rise, fall = sum(map(mul, C, reverse)) >> bits, sum(map(mul, S, reverse)) >> bits
            A.append(V[k] // divisor)
            V.append(force // divisor)
            S.append(rise // divisor)
            C.append(-fall // divisor)
            if k > 8 and all(abs(c) <= 16 for f in (V, S, C, Z[k:], A) for c in f[-4:]) and not any(T[k + 1 :]):
                return A, V, Z
        return None

    def at(self, f, part):
        value = 0
        for c in reversed(f):
            value = (value * part >> self.bits) + c
        return value

    def turn_in(self, V, end):
        """The first part of the step, up to `end`, at which v changes its sign; None without."""
        first = next((c for c in V if c), 0)
        sign = 1 if first > 0 else -1
        low = 0
        pieces = 16
        for i in range(1, pieces + 1):
            high = end * i // pieces
            if self.at(V, high) * sign < 0:
                break
            low = high
        else:
            return None
        while high - low > 1:
            middle = (low + high) // 2
            if self.at(V, middle) * sign < 0:
                high = middle
            else:
                low = middle
        return high

    def advance(self, limit):
        """One step, not beyond `limit`."""
        if self.kind:
            limit = min(limit, SAMPLE_TIMES[self.knot()])
        if self.stuck:
            return self.hold(limit)
        while (found := self.series(self.step)) is None:
            self.step += 1
        A, V, Z = found
        length = Fraction(1, 2**self.step)
        end = min(self.one, self.fixed((limit - self.t) / length))
        whole = self.t + length
        turn = self.turn_in(V, end)
        part = end if turn is None else turn
        self.theta, self.v, self.z = self.at(A, part), self.at(V, part), self.at(Z, part)
        self.t = limit if whole >= limit and turn is None else self.t + Fraction(part, self.one) * length
        self.largest = [max(self.largest[0], abs(self.theta)), max(self.largest[1], max(map(abs, V[:1])))]
        if turn is not None:
            self.v = 0
            before = self.side
            self.begin()
            if not self.stuck:
                self.side = -before
        if len(A) < self.most // 2 and self.step > 1:
            self.step -= 1
        return None

    def hold(self, limit):
        """At rest until the pull exceeds dry friction: steps of 1/64 s, then halving."""
        held, rest = self.t, self.theta

        def free(t):
            self.t = t
            return abs(self.pull()) > self.fixed(self.dry)

        if not self.amplitude and not self.kind:
            self.t = limit
            return
        t = held
        while t < limit:
            after = min(limit, t + Fraction(1, 64))
            # At a sample its polynomial ends: what lies just before counts.
            inside = after - Fraction(1, 2**80) if after == limit else after
            if free(inside):
                low, high = t, inside
                while high - low > Fraction(1, 2 ** (self.bits - 20)):
                    middle = (low + high) / 2
                    low, high = (low, middle) if free(middle) else (middle, high)
                self.t = high
                self.t = Fraction(self.fixed(high), self.one)
                self.stuck, self.v, self.theta = False, 0, rest
                pull = self.pull()
                self.side = (pull > 0) - (pull < 0)
                return
            t = after
        self.t = limit
        if free(limit):
            self.begin()


def motion(inputs, kind, times, bits, most):
    """(theta, v) at rising times, and the largest of both on the way."""
    with mp.workprec(bits + 40):
        now = DampedMotion(inputs, kind, bits, most)
        found = []
        for t in times:
            while now.t < t:
                now.advance(t)
            found.append([mp.ldexp(mp.mpf(x), -bits) for x in (now.theta, now.v)])
        return found, [mp.ldexp(mp.mpf(x), -bits) for x in now.largest]


def derivatives(inputs, kind, times, accurate):
    """For every input the differences of (theta, v) at the times: to 20 digits; otherwise to some, of the inputs that are not 0."""
    found = {}
    bits, most, small = (170, 60, 70) if accurate else (110, 40, 40)
    for name in INPUTS:
        if not accurate and not inputs[name]:
            found[name] = [[mp.mpf(0)] * 2 for _ in times]
            continue
        absent = name == "presliding" and not inputs[name]
        driven = name in ("frequency", "phase") and not inputs["amplitude"]
        if absent or driven:
            found[name] = [[mp.nan if absent else mp.mpf(0)] * 2 for _ in times]
            continue
        h = Fraction(1, 2**small)
        # From rest dry friction acts against the motion that begins: only on that side is there a derivative. A push of h at
        # a pendulum that is held moves it by h^2.
        ahead = name == "velocity0" and not inputs[name]
        side = 1
        if ahead:
            probe = DampedMotion(inputs, kind, bits, most)
            if probe.stuck:
                found[name] = [[mp.mpf(0)] * 2 for _ in times]
                continue
            side = probe.side
        one_sided = ahead or (name == "dry" and not inputs[name])
        near = motion({**inputs, name: inputs[name] + side * h}, kind, times, bits, most)[0]
        if one_sided:
            # (-3 f(0) + 4 f(h) - f(2 h))/2h
            base = motion(inputs, kind, times, bits, most)[0]
            far = motion({**inputs, name: inputs[name] + 2 * side * h}, kind, times, bits, most)[0]
            pairs = zip(base, near, far, strict=True)
            both = [
                [(-3 * b + 4 * n - f) * 2 ** (small - 1) * side for b, n, f in zip(*three, strict=True)]
                for three in pairs
            ]
        else:
            before = motion({**inputs, name: inputs[name] - h}, kind, times, bits, most)[0]
            both = [
                [(n - b) * 2 ** (small - 1) for n, b in zip(*pair, strict=True)]
                for pair in zip(near, before, strict=True)
            ]
        found[name] = both
    return found


def texts(inputs):
    return [float(inputs[name]).hex() for name in INPUTS]


def rows(number_and_case):
    """The rows of one motion: of the values, and of the derivatives."""
    number, (stratum, inputs, kind, times, slopes) = number_and_case
    with mp.workprec(300):
        first, largest = motion(inputs, kind, times, 200, 60)
        second, _ = motion(inputs, kind, times, 230, 80)
        for a, b in zip(first, second, strict=True):
            for x, y, size in zip(a, b, largest, strict=True):
                if abs(x - y) > size * mp.mpf(10) ** -30:
                    raise ArithmeticError(f"{stratum} {number}: {x} {y}")
        by = derivatives(inputs, kind, times, slopes)
        values, derived = [], []
        for i, t in enumerate(times):
            name = f"damped-{number:03d}-{i}"
            lead = [name, stratum, *texts(inputs), kind]
            cond = [sum(abs(inputs[p] * by[p][i][j]) for p in INPUTS if not mp.isnan(by[p][i][j])) for j in (0, 1)]
            scales = [max(x, mp.mpf(2) ** -40) for x in largest]
            values.append(
                [*lead, float(t).hex(), *hi_lo(second[i][0]), *hi_lo(second[i][1])]
                + [decimal(x, 6) for x in (*scales, *cond)]
            )
            if slopes:
                numbers = [by[p][i][j] for j in (0, 1) for p in INPUTS]
                derived.append([*lead, float(t).hex(), *("nan" if mp.isnan(x) else decimal(x, 20) for x in numbers)])
        return values, derived


def main():
    with ProcessPoolExecutor() as pool:
        found = list(pool.map(rows, enumerate(cases()), chunksize=1))
    write("damped.csv", HEADER, [row for values, _ in found for row in values])
    write("damped_slopes.csv", SLOPES_HEADER, [row for _, derived in found for row in derived])


if __name__ == "__main__":
    main()
