"""Reference values for one orbit of u'' + a u + b u^3 + c u^5 = 0 with any real a, b, c and any start.

Regime, range, period and escape times come from the energy equation (energy.py), the motion from Taylor series
(taylor.py) after whole periods are taken off, in units where the orbit is of order 1.
Conditions: derivatives by u0, velocity0 (and c) from the linearised equation; the others from the two scalings
  u0 d/du0 + v0 d/dv0 - 2 b d/db - 4 c d/dc = u,  t d/dt - v0 d/dv0 - 2 a d/da - 2 b d/db - 2 c d/dc = 0  (of u).
"""

from fractions import Fraction

import mpmath as mp
from energy import Orbit, middle, power_of_two, scaled, sign
from exact import agreement, decimal, hi_lo, mpf, real
from flint import ctx
from taylor import Sweep

AGREEMENT = mpf(10) ** -50
OUTPUTS = (
    "regime u_hi u_lo velocity_hi velocity_lo period_hi period_lo low_hi low_lo high_hi high_lo energy_hi energy_lo "
    "escape_hi escape_lo escape_backward_hi escape_backward_lo scale_u scale_velocity "
    "cond_u cond_velocity cond_period cond_escape cond_escape_backward"
).split()


class Scaled:
    """The orbit in units 2^length and 2^-rate, where its features are of order 1."""

    def __init__(self, start, c, times):
        unscaled = Orbit(start, c)
        (u0, v0), (a, b, c5) = start, c
        if unscaled.regime == "rest":
            length = power_of_two(u0) if u0 else 0
        elif unscaled.linear:
            sizes = [power_of_two(u0)] if u0 else []
            if v0 and a:
                sizes.append(power_of_two(v0) - power_of_two(a) // 2)
            elif v0:
                sizes.append(power_of_two(v0 * max(map(abs, times), default=1) or v0))
            length = max(sizes)
        elif unscaled.lower and unscaled.upper:
            with ctx.workprec(64):
                sizes = [float_exponent(end.u()) for end in (unscaled.lower, unscaled.upper)]
            length = max(size for size in sizes if size is not None)
        else:
            # Cauchy's bound on the roots of G
            top = len(unscaled.G) - 1
            sizes = [power_of_two(g / unscaled.G[-1]) / (2 * (top - j)) for j, g in enumerate(unscaled.G[:-1]) if g]
            length = round(max(sizes)) if sizes else power_of_two(u0)
        self.length = length
        rates = [scaled(abs(a), 1), scaled(7 * abs(b), 2 * length), scaled(26 * abs(c5), 4 * length)]
        if any(rates):
            # an eighth of the bound on the fastest rate: steps in taylor.py are at most 1, and slow parts of the motion need longer ones
            self.rate = power_of_two(sum(rates)) // 2 - 3
        else:
            self.rate = -power_of_two(max(map(abs, times), default=Fraction(1)) or Fraction(1))
        r = -2 * self.rate
        self.start = scaled(u0, -length), scaled(v0, -length - self.rate)
        self.c = scaled(a, r), scaled(b, r + 2 * length), scaled(c5, r + 4 * length)
        self.times = [scaled(t, self.rate) for t in times]
        self.orbit = Orbit(self.start, self.c)
        if self.orbit.regime != unscaled.regime:
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
        self.escape_times = [orbit.escape_time(backward, bits) for backward in (False, True)]
        self.states, self.by_period, self.by_escape = {}, None, [None, None]
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
        escape_time = self.escape_times[backward]
        chosen = sorted((abs(t), t) for t in times if t and sign(t) == direction and real(abs(t)) < escape_time)
        targets = [real(size) for size, _ in chosen]
        escapes = mp.isfinite(escape_time) and self.slopes > 0
        if escapes:
            targets.append(escape_time)
        found = self.run(direction, targets, escapes)
        if escapes:
            (w, dw), *columns = found.pop()
            if abs(w) > mpf(2) ** -150:
                raise ArithmeticError("the integration does not escape when the quadrature does")
            self.by_escape[backward] = [-d / dw for d, _ in columns]
        flips = [1, direction, 1][: self.slopes]
        for (_, t), state in zip(chosen, found, strict=True):
            (u, v), *columns = state
            moved = [(flip * du, flip * direction * dv) for (du, dv), flip in zip(columns, flips, strict=True)]
            self.states[t] = [(u, direction * v), *moved]


def agreed_ephemeris(orbit, c, times, slopes, u_size):
    """An Ephemeris with columns that agrees with a shorter one, by other steps, to 50 digits."""
    bits = 270
    for _ in range(10):
        with mp.workprec(bits + 150):
            rough = Ephemeris(orbit, c, times, 0, 3, bits)
            fine = Ephemeris(orbit, c, times, slopes, 2, bits + 80)
            pairs = [(rough.states[t][0][k], fine.states[t][0][k]) for t in fine.states for k in (0, 1)]
            if all(agreement(a, b) < AGREEMENT for a, b in pairs):
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
    _, b, c5 = orbit.c
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
        fine = agreed_ephemeris(orbit, whole.c, dict.fromkeys(whole.times), slopes, whole.u_unit)
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
        cond_escapes = [
            condition(by, (inputs[0], direction * inputs[1]), c5, mpf(0), -escape_time) if by else mpf(0)
            for by, direction, escape_time in zip(fine.by_escape, (1, -1), fine.escape_times, strict=True)
        ]
        low, high = orbit.bounds(200)
        forward, backward = fine.escape_times
        fixed = [*hi_lo(period * second), *hi_lo(low * unit), *hi_lo(high * unit)]
        fixed += [
            *hi_lo(real(orbit.energy) * (unit / second) ** 2),
            *hi_lo(forward * second),
            *hi_lo(-backward * second),
        ]
        ends = [decimal(x * second, 6) for x in (cond_period, *cond_escapes)]
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
        return (
            orbit.period(100) * unit,
            orbit.escape_time(False, 100) * unit,
            -orbit.escape_time(True, 100) * unit,
            unit,
        )


def regime(u0, velocity0, force):
    return Orbit((Fraction(u0), Fraction(velocity0)), (*map(Fraction, force), Fraction(0))[:3]).regime
