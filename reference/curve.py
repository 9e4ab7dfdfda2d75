"""The motion of duffing.csv and cubic_quintic.csv by another method: addition on an elliptic curve, in balls.

x'^2 = f(x) with f of degree 4 (x = u, or x = u^2 where there is a fifth power) has, for any start and any f,
  x = x0 + [-x0' P' + f' (P - f''/24) / 2 + f f'''/24] / [2 (P - f''/24)^2 - f f''''/48],  f at x0,
with P = wp(t; g2, g3) (Whittaker and Watson, 20.6). P comes from its Laurent series at t / 2^n and n tangent steps on
the curve Y^2 = 4 X^3 - g2 X - g3. No regime, no root, no branch: the same line holds everywhere.
"""

import math
from fractions import Fraction

from flint import arb, ctx, fmpq

TOLERANCE = Fraction(1, 2**104)


def ball(x):
    f = Fraction(x)
    return arb(fmpq(f.numerator, f.denominator))


def quartic(start, force):
    """f as coefficients from the constant upwards, x0 and x0'."""
    (u, v), (a, b, c) = start, force
    energy2 = v**2 + a * u**2 + b * u**4 / 2 + c * u**6 / 3
    if c == 0:
        return [energy2, 0, -a, 0, -b / 2], u, v
    return [0, 4 * energy2, -4 * a, -2 * b, -4 * c / 3], u**2, 2 * u * v


def wp(t, g2, g3):
    """wp and wp' of a ball t != 0; None if the ball is too wide at one of the steps."""
    # halve until the Laurent series, whose radius exceeds 1 / max(|g2|^(1/4), |g3|^(1/6)), converges by 2^-8 a term
    sizes = [(abs(g) ** (arb(1) / k) * abs(t)).upper() for g, k in ((g2, 4), (g3, 6))]
    halves = 5
    for s in sizes:
        if s > 1:
            halves = max(halves, 6 + int(float(s.log()) / math.log(2)))
    z = t / arb(2) ** halves
    coefficients = [arb(0), arb(0), g2 / 20, g3 / 28]
    square = z * z
    value, slope, factor = 1 / square, -2 / (square * z), square
    terms = ctx.prec // 8 + 4
    for k in range(2, terms):
        if k > 3:
            total = sum((coefficients[m] * coefficients[k - m] for m in range(2, k - 1)), arb(0))
            coefficients.append(3 * total / ((2 * k + 1) * (k - 3)))
        value += coefficients[k] * factor
        slope += (2 * k - 2) * coefficients[k] * factor / z
        factor = factor * square
    rest = arb(0, 1) * abs(value) * arb(2) ** (-ctx.prec)
    value, slope = value + rest, slope + rest * abs(slope / value)
    for _ in range(halves):
        tangent = (12 * value * value - g2) / (2 * slope)
        doubled = tangent * tangent / 4 - 2 * value
        value, slope = doubled, -(slope + tangent * (doubled - value))
        if not slope.is_finite():
            return None
    return value, slope


def motion(start, force, t):
    """(x, x') as balls at the working precision, all arguments rationals or balls; None if too wide."""
    return moved(*quartic(start, force), t)


def moved(f, x0, v0, t):
    """The same for x'^2 = f(x), coefficients from the constant upwards."""

    def ball_of(x):
        return x if isinstance(x, arb) else ball(x)

    f, x0, v0 = list(map(ball_of, f)), ball_of(x0), ball_of(v0)
    d = [f]
    for _ in range(4):
        d.append([k * c for k, c in enumerate(d[-1])][1:])
    at = []
    for g in d:
        total = arb(0)
        for c in g[::-1]:
            total = total * x0 + c
        at.append(total)
    g2 = f[0] * f[4] - f[1] * f[3] / 4 + f[2] * f[2] / 12
    g3 = (
        f[0] * f[2] * f[4] / 6
        + f[1] * f[2] * f[3] / 48
        - f[2] ** 3 / 216
        - f[0] * f[3] ** 2 / 16
        - f[1] ** 2 * f[4] / 16
    )
    found = wp(ball_of(t), g2, g3)
    if found is None:
        return None
    P, dP = found
    over = P - at[2] / 24
    numerator = -v0 * dP + at[1] * over / 2 + v0 * v0 * at[3] / 24
    denominator = 2 * over * over - v0 * v0 * at[4] / 48
    d_numerator = -v0 * (6 * P * P - g2 / 2) + at[1] * dP / 2
    x = x0 + numerator / denominator
    return x, d_numerator / denominator - numerator * (4 * over * dP) / (denominator * denominator)


def inside(evaluate, value, scale=0):
    """Whether the ball of evaluate() agrees with the value within 2^-104 of itself, the precision raised until it could tell."""
    bits = 256
    while bits < 1 << 15:
        with ctx.workprec(bits):
            found = evaluate()
            if found is not None and found.is_finite():
                room = max(abs(value), scale) * TOLERANCE
                if ball(room / 4) > found.rad():
                    return abs(found - ball(value)) < ball(room)
        bits *= 2
    raise ArithmeticError("no precision makes the ball narrow")


def changes_sign(evaluate, value):
    """Whether evaluate(x) has different signs at value (1 - 2^-102) and value (1 + 2^-102)."""
    bits = 512
    while bits < 1 << 15:
        with ctx.workprec(bits):
            ends = [evaluate(value * (1 + side * Fraction(1, 2**102))) for side in (-1, 1)]
            if all(e is not None and (e > 0 or e < 0) for e in ends):
                return bool(ends[0] > 0) != bool(ends[1] > 0)
        bits *= 2
    raise ArithmeticError("no precision decides the sign")


def parts(row):
    start = Fraction(float.fromhex(row["u0"])), Fraction(float.fromhex(row["velocity0"]))
    names = ("p", "q") if "p" in row else ("alpha", "beta", "gamma")
    force = [Fraction(float.fromhex(row[name])) for name in names]
    return start, (*force, Fraction(0))[:3], Fraction(float.fromhex(row["t"]))


def stored(row, name):
    """hi + lo as a rational, or a float where it is infinite or NaN."""
    hi, lo = (float.fromhex(row[f"{name}_{part}"]) for part in ("hi", "lo"))
    return Fraction(hi) + Fraction(lo) if math.isfinite(hi) else hi


def wrong(row):
    """The columns of the row that the second route contradicts."""
    (u0, v0), force, t = parts(row)
    start = u0, v0
    a, b, c = force
    found = []
    energy = v0**2 / 2 + a * u0**2 / 2 + b * u0**4 / 4 + c * u0**6 / 6
    if abs(stored(row, "energy") - energy) > abs(energy) * TOLERANCE:
        found.append("energy")
    u, v = stored(row, "u"), stored(row, "velocity")
    period, ahead, behind = (stored(row, name) for name in ("period", "escape", "escape_backward"))
    still = row["regime"] == "rest"
    if not isinstance(u, Fraction):
        if not (math.isnan(u) and math.isnan(v) and not behind < t < ahead):
            found.append("u")
    elif not behind < t < ahead:
        found.append("u")
    elif t == 0 or still:
        found += [name for name, x, y in (("u", u, u0), ("velocity", v, v0)) if x != y]
    else:
        x, y = (u, v) if c == 0 else (u**2, 2 * u * v)

        def pick(k):
            return lambda: (motion(start, force, t) or (None, None))[k]

        # u^2 and 2 u u' double the relative errors
        if not inside(pick(0), x, 0 if c == 0 else 4 * abs(x)):
            found.append("u")
        if not inside(pick(1), y, 0 if c == 0 else 4 * abs(y)):
            found.append("velocity")
        if c != 0 and (u > 0) != (expected_side(row, u, v) > 0):
            found.append("u")
    for name, end in (("escape", ahead), ("escape_backward", behind)):
        # 1 / x = 0, with a sign change in 1 / x or in x' / x = O(1 / time left)
        if isinstance(end, Fraction) and not changes_sign(lambda s: log_slope(start, force, s), end):
            found.append(name)
    if isinstance(period, Fraction) and still:
        k = a + 3 * b * u0**2 + 5 * c * u0**4
        if not inside(lambda: 2 * arb.pi() / ball(k).sqrt(), period):
            found.append("period")
    elif isinstance(period, Fraction):
        if not changes_sign(lambda s: back(start, force, s), period):
            found.append("period")
    found += bounds(row, start, force, energy)
    found += scales(row, start, force, energy)
    return found


def scales(row, start, force, energy):
    """The scales: ends of the range and the largest of many velocities on it, or value and start."""
    a, b, c = force
    told = [Fraction(row[name]) for name in ("scale_u", "scale_velocity")]
    low, high = stored(row, "low"), stored(row, "high")
    if isinstance(low, Fraction) and isinstance(high, Fraction):
        squares = [(low + (high - low) * Fraction(k, 500)) ** 2 for k in range(501)]
        fastest = mid_root(max(2 * energy - a * y - b * y**2 / 2 - c * y**3 / 3 for y in squares)) if told[1] else 0
        ranges = (max(abs(low), abs(high)), 10**-15), (fastest, 10**-4 if row["regime"] != "rest" else 0)
    else:
        known = [stored(row, name) for name in ("u", "velocity")]
        known = [x if isinstance(x, Fraction) else 0 for x in known]
        ranges = [(max(abs(x), abs(y)), 10**-15) for x, y in zip(known, start, strict=True)]
    names = zip(("scale_u", "scale_velocity"), told, ranges, strict=True)
    return [name for name, x, (y, room) in names if abs(x - y) > Fraction(room) * x]


def expected_side(row, u, v):
    """Sign of u where only u^2 is known: followed in a libration, kept beside 0, told by u' where that keeps its."""
    low, high = stored(row, "low"), stored(row, "high")
    u0, v0 = (float.fromhex(row[name]) for name in ("u0", "velocity0"))
    if row["regime"] == "libration":
        return side(row)
    if low >= 0 or high <= 0:
        return u0 if u0 else (1 if high > 0 else -1)
    return 1 if (u * v > 0) == (v0 > 0) else -1


def log_slope(start, force, t):
    found = motion(start, force, t)
    return None if found is None else found[1] / found[0]


def back(start, force, t):
    found = motion(start, force, t)
    return None if found is None else distance(found, start, force, by_place(start, force))


def by_place(start, force):
    """Whether x leaves its start to first order in t, rather than x'."""
    (u0, v0), (a, b, c) = start, force
    return abs(v0) > abs(u0 * (a + b * u0**2 + c * u0**4)) and (u0 != 0 or c == 0)


def distance(found, start, force, place):
    """Distance from the start in x or in x'."""
    _, x0, y0 = quartic(start, force)
    return found[0] - ball(x0) if place else found[1] - ball(y0)


def bounds(row, start, force, energy):
    """Ends of the range: u'^2 changes sign at a turning point, the force at an equilibrium."""
    found = []
    a, b, c = force
    if row["regime"] == "rest":
        return [name for name in ("low", "high") if stored(row, name) != start[0]]

    def kinetic(u):
        return ball(2 * energy - a * u**2 - b * u**4 / 2 - c * u**6 / 3)

    def pull(u):
        return ball(a + b * u**2 + c * u**4)

    for name, side in (("low", -1), ("high", 1)):
        end = stored(row, name)
        if not isinstance(end, Fraction):
            if end != side * math.inf:
                found.append(name)
        elif end == 0:
            if energy != 0:
                found.append(name)
        elif not changes_any((kinetic, pull), end):
            found.append(name)
        elif not (end - start[0]) * side >= 0:
            found.append(name)
    return found


def changes_any(functions, end):
    for function in functions:
        try:
            if changes_sign(function, end):
                return True
        except ArithmeticError:
            continue
    return False


def slopes_wrong(row):
    """The condition columns of the row that central differences contradict."""
    (u0, v0), (a, b, c), t = parts(row)
    numbers = [u0, v0, a, b, *([] if "p" in row else [c]), t]
    found = []
    u = stored(row, "u")
    plain, place = c == 0, by_place((u0, v0), (a, b, c))

    def whole(values):
        return motion(values[:2], (*values[2:-1], Fraction(0))[:3], values[-1])

    def state(values):
        moved = whole(values)
        if moved is None or plain:
            return moved
        root = moved[0].sqrt()
        return root, moved[1] / (2 * root)

    def turned(k, end):
        """Time of return or escape by one input: -(d/dx) / (d/dt) of a function that vanishes there."""

        def function(values):
            moved = whole(values)
            if moved is None:
                return None
            if k != "period":
                return (moved[0] / moved[1],)
            start, force = tuple(values[:2]), (*values[2:-1], Fraction(0))[:3]
            return (distance(moved, start, force, place),)

        return total(function, [*numbers[:-1], end], quotient=True)

    if isinstance(u, Fraction) and u != 0 and t != 0:
        conditions = total(state, numbers)
        for name, value in zip(("cond_u", "cond_velocity"), conditions, strict=True):
            if not near(value, row[name]):
                found.append(name)
    elif t != 0 and (row["cond_u"], row["cond_velocity"]) != ("0", "0") and u != 0:
        found.append("cond_u")
    for name in ("period", "escape", "escape_backward"):
        end = stored(row, name)
        if isinstance(end, Fraction) and row["regime"] != "rest":
            if not near(turned(name, end)[0], row["cond_" + name]):
                found.append("cond_" + name)
        elif not isinstance(end, Fraction) and row["cond_" + name] != "0":
            found.append("cond_" + name)
    return found


def near(value, text):
    """Six digits agree."""
    told = Fraction(text)
    return abs(value - ball(told)) <= ball(abs(told) / 10**5)


def total(function, numbers, quotient=False):
    """Sums of |x dF/dx| over the numbers (quotient: all but the last, divided by dF/dlast), by differences."""
    bits = 1200
    while bits < 1 << 15:
        with ctx.workprec(bits):
            sums = None
            slopes = []
            for k, number in enumerate(numbers):
                # an input that is 0 adds nothing
                step = abs(number) / 2**320
                ends = [function([*numbers[:k], number + side * step, *numbers[k + 1 :]]) for side in (1, -1)]
                if number == 0:
                    continue
                if None in ends:
                    break
                slopes.append([(x - y) / ball(2 * step) * ball(number) for x, y in zip(*ends, strict=True)])
            else:
                if quotient:
                    last = slopes.pop()[0] / ball(numbers[-1])
                    slopes = [[s[0] / last] for s in slopes]
                sums = [sum((abs(s[k]) for s in slopes), arb(0)) for k in range(len(ends[0]))]
                if all(s.is_finite() and (s.rad() == 0 or s.rel_accuracy_bits() > 40 or s < 2**-1000) for s in sums):
                    return sums
        bits *= 2
    raise ArithmeticError("no precision is enough for the differences")


def mid_root(square):
    """A rational near the root of a rational."""
    shift = (square.denominator.bit_length() - square.numerator.bit_length()) // 2 + 64
    return Fraction(math.isqrt(int(square * Fraction(4) ** shift))) / Fraction(2) ** shift


def side(row):
    """Sign of u by following u = +-sqrt(y) through its zeros, for a libration of the quintic equation."""
    (u0, v0), (a, b, c), t = parts(row)
    period = stored(row, "period")
    left = t - period * math.floor(t / period)
    with ctx.workprec(400):
        top = stored(row, "high")
        rate = mid_root(abs(a) + 3 * abs(b) * top**2 + 5 * abs(c) * top**4)
        most = 1 / (3 * rate)
        now, u, v, step = Fraction(0), ball(u0), ball(v0), most
        while now < left:
            pull = -u * (ball(a) + ball(b) * u**2 + ball(c) * u**4)
            step = min(step, most, left - now)
            found = motion((u0, v0), (a, b, c), now + step)
            size = found[0].sqrt() if found[0] > 0 else abs(found[0]).sqrt()
            # u and u' together name the branch: the prediction has to be clearly nearer to one of the two
            expected = u + ball(step) * v + ball(step) ** 2 * pull / 2, v + ball(step) * pull
            choices = [(s * size, s * found[1] / (2 * size)) for s in (1, -1)]
            weight = ball(period) / 8
            far = [abs(x - expected[0]) + weight * abs(y - expected[1]) for x, y in choices]
            best = 0 if far[0] < far[1] else 1
            if far[best] * 4 < far[1 - best]:
                now, (u, v), step = now + step, choices[best], step * 2
            else:
                step = step / 2
        return 1 if u > 0 else -1
