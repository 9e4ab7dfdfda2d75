"""Reference values for one orbit of u'' + p u + r u^2 + q u^3 + s u^5 = c from any start.

Regime, range, period and escape times come from the energy equation (potential.py), the motion and its derivatives by all
inputs from Taylor series (force_taylor.py) after whole periods are taken off, in units where the orbit is of order 1.
"""

from fractions import Fraction

import mpmath as mp
from energy import middle, power_of_two, scaled, sign
from exact import agreement, decimal, hi_lo, mpf, real
from flint import ctx
from force_taylor import ForceSweep
from potential import PotentialOrbit

AGREEMENT = mpf(10) ** -50
LETTERS = "prqcs"
# power of u and sign on the left-hand side
PLACE = {"p": (1, 1), "r": (2, 1), "q": (3, 1), "c": (0, -1), "s": (5, 1)}
# bounds on the rates: the frequency at a power of u, and that of small motions in the same force
WEIGHT = {0: 2, 1: 2, 2: 4, 3: 7, 5: 26}
STATE = ("u", "velocity", "period", "low", "high", "energy", "escape", "escape_backward")
CONDITIONS = ("u", "velocity", "period", "low", "high", "energy", "escape", "escape_backward")
OUTPUTS = ["regime", *(f"{name}_{part}" for name in STATE for part in ("hi", "lo"))]
OUTPUTS += ["scale_u", "scale_velocity", *(f"cond_{name}" for name in CONDITIONS)]


def force_of(coefficients):
    """f0 to f5 of the letters, rationals."""
    force = [Fraction(0)] * 6
    for letter, x in coefficients.items():
        power, side = PLACE[letter]
        force[power] += side * Fraction(x)
    return force


def exponent(x):
    mid = middle(x)
    return int(mp.mag(mid)) if mid else None


def length_of(orbit, times):
    """The exponent of a unit of length in which the orbit is of order 1."""
    sizes = [power_of_two(orbit.u0)] if orbit.u0 else []
    if orbit.lower and orbit.upper:
        with ctx.workprec(64):
            sizes = [e for e in (exponent(end.u()) for end in (orbit.lower, orbit.upper)) if e is not None]
    elif orbit.regime != "rest":
        # Cauchy's bound on the roots of P
        top = len(orbit.P) - 1
        sizes += [round(power_of_two(g / orbit.P[-1]) / (top - j)) for j, g in enumerate(orbit.P[:-1]) if g]
        if orbit.linear and orbit.v0 and times:
            sizes.append(power_of_two(orbit.v0 * max(map(abs, times)) or orbit.v0))
            if len(orbit.P) > 1:
                sizes.pop()
    return max(sizes, default=0)


class ScaledOrbit:
    """The orbit in units 2^length and 2^-rate, where its features are of order 1."""

    def __init__(self, start, coefficients, times):
        force = force_of(coefficients)
        unscaled = PotentialOrbit(start, force)
        u0, v0 = start
        self.length = length = length_of(unscaled, times)
        rates = [scaled(WEIGHT[k] * abs(f), (k - 1) * length) for k, f in enumerate(force) if f]
        if any(rates) and not (unscaled.linear and not force[1]):
            # an eighth of the bound on the fastest rate
            self.rate = power_of_two(sum(rates)) // 2 - 3
        else:
            self.rate = -power_of_two(max(map(abs, times), default=Fraction(1)) or Fraction(1))
        self.start = scaled(u0, -length), scaled(v0, -length - self.rate)
        self.coefficients = {
            letter: scaled(Fraction(x), (PLACE[letter][0] - 1) * length - 2 * self.rate)
            for letter, x in coefficients.items()
        }
        self.force = force_of(self.coefficients)
        self.times = [scaled(t, self.rate) for t in times]
        self.orbit = PotentialOrbit(self.start, self.force)
        if self.orbit.regime != unscaled.regime:
            raise ArithmeticError("the regime depends on the units")
        self.u_unit, self.t_unit = mp.ldexp(mpf(1), length), mp.ldexp(mpf(1), -self.rate)


def columns_of(letters):
    """(du0, dv0, df) of every input: u0, velocity0 and the letters."""
    none = [0] * 6
    found = [(1, 0, none), (0, 1, none)]
    for letter in letters:
        power, side = PLACE[letter]
        found.append((0, 0, [side if k == power else 0 for k in range(6)]))
    return found


class OrbitStates:
    """States and columns of a scaled orbit at its times, from sweeps forward and backward."""

    def __init__(self, orbit, times, by, pace, bits, closing=True, column_bits=100):
        self.column_bits = column_bits
        self.orbit, self.by, self.pace, self.bits, self.closing = orbit, by, pace, bits, closing
        self.unbounded = orbit.regime == "escape"
        self.T = orbit.period(bits) if orbit.periodic() else None
        self.escape_times = [orbit.escape_time(backward, bits) for backward in (False, True)]
        self.states, self.by_period, self.by_escape = {}, None, [None, None]
        self.states[Fraction(0)] = [(real(orbit.u0), real(orbit.v0)), *((mpf(du), mpf(dv)) for du, dv, _ in by)]
        if self.T is not None:
            self.whole_periods(times)
        else:
            for backward in (False, True):
                self.sweep(backward, times)

    def tolerance(self):
        """How well the integration has to meet the quadrature."""
        return mpf(2) ** (-3 * self.bits // 5)

    def force(self, u):
        return sum(real(f) * u**k for k, f in enumerate(self.orbit.force) if f)

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
        if self.closing:
            targets.append(self.T)
        found = self.run(1, targets, False)
        slopes = [mpf(0)] * len(self.by)
        if self.closing:
            (u, v), *columns = found.pop()
            close = max(abs(u - real(orbit.u0)), abs(v - real(orbit.v0)))
            if close > self.tolerance():
                raise ArithmeticError("the integration does not return after the period of the quadrature")
            # u(T) = u0 and v(T) = v0 for all inputs: the dominant one gives dT
            a0, v0 = real(orbit.acceleration), real(orbit.v0)
            for k, ((du, dv), (du0, dv0, _)) in enumerate(zip(columns, self.by, strict=True)):
                slopes[k] = (du0 - du) / v0 if abs(v0) > abs(a0) else (dv0 - dv) / a0
            self.by_period = slopes
        for (_, t), state in zip(rests, found, strict=True):
            (u, v), *columns = state
            n, pull = turns[t], -self.force(u)
            moved = [(du - n * dT * v, dv - n * dT * pull) for (du, dv), dT in zip(columns, slopes, strict=True)]
            self.states[t] = [(u, v), *moved]

    def run(self, direction, targets, escapes):
        orbit = self.orbit
        start = orbit.u0, direction * orbit.v0
        return ForceSweep(start, orbit.force, self.by, self.unbounded, self.pace, self.bits, self.column_bits).run(
            targets, escapes
        )

    def sweep(self, backward, times):
        direction = -1 if backward else 1
        escape_time = self.escape_times[backward]
        chosen = sorted((abs(t), t) for t in times if t and sign(t) == direction and real(abs(t)) < escape_time)
        targets = [real(size) for size, _ in chosen]
        escapes = mp.isfinite(escape_time) and self.closing
        if escapes:
            targets.append(escape_time)
        found = self.run(direction, targets, escapes)
        # backward columns belong to the motion with velocity0 turned round
        flips = [direction if dv else 1 for _, dv, _ in self.by]
        if escapes:
            (w, dw), *columns = found.pop()
            if abs(w) > self.tolerance():
                raise ArithmeticError("the integration does not escape when the quadrature does")
            if len(self.orbit.P) == 4:
                # no fourth power: w = 1/u has a double zero
                if abs(dw) > self.tolerance():
                    raise ArithmeticError("the integration does not escape when the quadrature does")
                bend = -real(self.orbit.force[2]) / 3
                moved = [-d / bend for _, d in columns]
            else:
                moved = [-d / dw for d, _ in columns]
            self.by_escape[backward] = [flip * d for flip, d in zip(flips, moved, strict=True)]
        for (_, t), state in zip(chosen, found, strict=True):
            (u, v), *columns = state
            moved = [(flip * du, flip * direction * dv) for (du, dv), flip in zip(columns, flips, strict=True)]
            self.states[t] = [(u, direction * v), *moved]


def agreed_ephemeris(orbit, times, by):
    """OrbitStates that agrees with a shorter one, by other steps, to 50 digits; and one with columns, to fewer."""
    bits = 200
    for _ in range(14):
        with mp.workprec(bits + 150):
            try:
                rough = OrbitStates(orbit, times, [], 2.2, bits, closing=False)
                fine = OrbitStates(orbit, times, [], 1.8, bits + 50)
                pairs = [(rough.states[t][0][k], fine.states[t][0][k]) for t in fine.states for k in (0, 1)]
                if all(agreement(a, b) < AGREEMENT for a, b in pairs):
                    return fine, OrbitStates(orbit, times, by, 1.9, max(160, bits - 60))
            except ArithmeticError:
                pass  # the integration misses the quadrature, or divides by a state that has no digits: too few bits
        bits += bits // 2
    raise ArithmeticError("two precisions do not agree")


def total(inputs, slopes):
    return sum((abs(x * d) for x, d in zip(inputs, slopes, strict=True)), mpf(0))


def by_energy(orbit, u, letters):
    """Derivatives of P(u) at fixed u by u0, velocity0 and the letters."""
    u0, v0 = real(orbit.u0), real(orbit.v0)
    found = [-2 * real(orbit.acceleration), 2 * v0]
    for letter in letters:
        power, side = PLACE[letter]
        found.append(2 * side * (u0 ** (power + 1) - u ** (power + 1)) / (power + 1))
    return found


def by_end(orbit, u, letters):
    """Derivatives of a simple root of P."""
    slope = -2 * sum(real(f) * u**k for k, f in enumerate(orbit.force))
    return [-d / slope for d in by_energy(orbit, u, letters)]


def rest_period_slopes(orbit, T, letters):
    """Derivatives of the period of small swings by the force; by u0 and velocity0 it is stationary."""
    u, k = real(orbit.u0), real(orbit.stiffness())
    bend = sum(real(f) * j * (j - 1) * u ** (j - 2) for j, f in enumerate(orbit.force) if j > 1)
    found = [mpf(0), mpf(0)]
    for letter in letters:
        power, side = PLACE[letter]
        own = side * power * u ** (power - 1) if power else mpf(0)
        found.append(-T / (2 * k) * (own - bend * side * u**power / k))
    return found


def outputs(u0, velocity0, coefficients, times):
    """The OUTPUTS columns for each of the times; all inputs are doubles, coefficients by their letters."""
    start = Fraction(u0), Fraction(velocity0)
    exact_times = list(dict.fromkeys(map(Fraction, times)))
    whole = ScaledOrbit(start, coefficients, exact_times)
    orbit = whole.orbit
    letters = [letter for letter, x in whole.coefficients.items() if x]
    with mp.workprec(400):
        fine, moved = agreed_ephemeris(orbit, dict.fromkeys(whole.times), columns_of(letters))
        unit, second = whole.u_unit, whole.t_unit
        inputs = [real(orbit.u0), real(orbit.v0), *(real(whole.coefficients[letter]) for letter in letters)]
        period = orbit.period(200)
        cond_period = mpf(0)
        if orbit.regime == "rest":
            if mp.isfinite(period):
                cond_period = total(inputs, rest_period_slopes(orbit, period, letters))
        elif moved.by_period:
            cond_period = total(inputs, moved.by_period)
        cond_escapes = [total(inputs, by) if by else mpf(0) for by in moved.by_escape]
        ends = orbit.bounds(200)
        cond_ends = [mpf(0), mpf(0)]
        if orbit.regime == "rest":
            cond_ends = [abs(inputs[0])] * 2
        else:
            for k, (end, u) in enumerate(zip((orbit.lower, orbit.upper), ends, strict=True)):
                if end and end.kind == "turn":
                    cond_ends[k] = total(inputs, by_end(orbit, u, letters))
        force = orbit.force
        potential = [real(f * orbit.u0 ** (k + 1)) / (k + 1) for k, f in enumerate(force)]
        energy = real(orbit.v0**2) / 2 + sum(potential)
        slopes = [-real(orbit.acceleration), real(orbit.v0)]
        slopes += [PLACE[x][1] * real(orbit.u0 ** (PLACE[x][0] + 1)) / (PLACE[x][0] + 1) for x in letters]
        cond_energy = total(inputs, slopes)
        exact_energy = orbit.v0**2 / 2 + sum(f * orbit.u0 ** (k + 1) / (k + 1) for k, f in enumerate(force))
        energy = real(exact_energy)
        joule = (unit / second) ** 2
        forward, backward = fine.escape_times
        fixed = [*hi_lo(period * second), *hi_lo(ends[0] * unit), *hi_lo(ends[1] * unit), *hi_lo(energy * joule)]
        fixed += [*hi_lo(forward * second), *hi_lo(-backward * second)]
        conds = [cond_period * second, *(x * unit for x in cond_ends), cond_energy * joule]
        conds += [x * second for x in cond_escapes]
        conds = [decimal(x, 6) for x in conds]
        bounded = all(map(mp.isfinite, ends))
        if bounded:
            scales = max(map(abs, ends)), orbit.fastest()
        rows = []
        for t in times:
            moment = scaled(Fraction(t), whole.rate)
            if moment not in fine.states:
                z, own = (mp.nan, mp.nan), (mpf(0), mpf(0))
            else:
                z, columns = fine.states[moment][0], moved.states[moment][1:]
                u, v = z
                time = real(moment)
                own = (
                    abs(time * v) + total(inputs, [d for d, _ in columns]),
                    abs(time * fine.force(u)) + total(inputs, [d for _, d in columns]),
                )
            if not bounded:
                known = [x if mp.isfinite(x) else mpf(0) for x in z]
                scales = max(abs(known[0]), abs(inputs[0])), max(abs(known[1]), abs(inputs[1]))
            row = [orbit.regime, *hi_lo(z[0] * unit), *hi_lo(z[1] * unit / second), *fixed]
            row += [decimal(scales[0] * unit, 17), decimal(scales[1] * unit / second, 17)]
            rows.append([*row, decimal(own[0] * unit, 6), decimal(own[1] * unit / second, 6), *conds])
        return rows


def clock(u0, velocity0, coefficients):
    """(period, escape, backward escape, unit of time) good enough to choose instants; inf where there is none."""
    whole = ScaledOrbit((Fraction(u0), Fraction(velocity0)), coefficients, [])
    orbit, unit = whole.orbit, whole.t_unit
    with mp.workprec(120):
        return (
            orbit.period(56) * unit,
            orbit.escape_time(False, 56) * unit,
            -orbit.escape_time(True, 56) * unit,
            unit,
        )


def regime(u0, velocity0, coefficients):
    return PotentialOrbit((Fraction(u0), Fraction(velocity0)), force_of(coefficients)).regime
