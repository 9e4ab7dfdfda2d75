"""Checks vectors/helmholtz_duffing.csv: the motion by addition on an elliptic curve in balls (curve.py). Called by check.py.

Roots between the start and the ends of the range are counted by Sturm's sequence, conditions are compared with central
differences, a few rows are derived again, and mutated rows must fail. A seeded sample of the rows; --all takes every one.
"""

import math
from fractions import Fraction
from itertools import pairwise

import curve
import exact
import helmholtz_duffing
import oscillator_stated
from energy import derivative, remainder, trimmed, value
from flint import arb
from potential import kinetic
from table import counted, fail, mutated

FILES = (helmholtz_duffing.NAME,)
SAMPLE, AGAIN, SLOPES = 60, 2, 4
NUMBERS = helmholtz_duffing.INPUTS


def force_of(numbers):
    p, r, q, c = numbers
    return [-c, p, r, q]


def quartic(numbers):
    """P from the constant upwards, u0 and velocity0, of rationals or balls."""
    u0, v0, p, r, q, c = numbers
    constant = v0 * v0 + p * u0**2 + 2 * r * u0**3 / 3 + q * u0**4 / 2 - 2 * c * u0
    return [constant, 2 * c, -p, -2 * r / 3, -q / 2], u0, v0


def motion(numbers, t):
    return curve.moved(*quartic(numbers), t)


def stretched(row):
    return [Fraction(float.fromhex(row[name])) for name in NUMBERS]


def wrong(row):
    """The columns of the row that the second route contradicts."""
    *numbers, t = stretched(row)
    u0, v0 = numbers[:2]
    force = force_of(numbers[2:])
    names = ("u", "velocity", "period", "low", "high", "energy", "escape", "escape_backward")
    u, v, period, low, high, told, ahead, behind = (curve.stored(row, name) for name in names)
    energy = v0**2 / 2 + sum(f * u0 ** (k + 1) / (k + 1) for k, f in enumerate(force))
    found = []
    if abs(energy) > 2**-900 and isinstance(told, Fraction) and abs(told - energy) > abs(energy) * curve.TOLERANCE:
        found.append("energy")
    still = v0 == 0 and value(force, u0) == 0
    if not isinstance(u, Fraction):
        if not (math.isnan(u) and math.isnan(v) and not behind < t < ahead):
            found.append("u")
    elif not behind < t < ahead:
        found.append("u")
    elif t == 0 or still:
        found += [name for name, x, y in (("u", u, u0), ("velocity", v, v0)) if x != y]
    else:
        found += [name for k, (name, x) in enumerate((("u", u), ("velocity", v))) if not at_time(numbers, t, k, x)]
    for name, end in (("escape", ahead), ("escape_backward", behind)):
        # u'/u = O(1 / time left) changes sign
        if isinstance(end, Fraction) and not curve.changes_sign(lambda s: log_slope(numbers, s), end):
            found.append(name)
    if isinstance(period, Fraction):
        if still or not any(force[2:]):
            stiffness = value(derivative(force), u0)
            if not curve.inside(lambda: 2 * arb.pi() / curve.ball(stiffness).sqrt(), period):
                found.append("period")
        elif not curve.changes_sign(lambda s: back(numbers, s), period):
            found.append("period")
    return found + range_wrong(row, numbers, force, low, high, still) + scales_wrong(row, numbers, force)


def at_time(numbers, t, k, x):
    if abs(x) < 2**-1000:
        return True  # a subnormal result has fewer bits
    return curve.inside(lambda: (motion(numbers, t) or (None, None))[k], x)


def log_slope(numbers, t):
    found = motion(numbers, t)
    return None if found is None else found[1] / found[0]


def by_place(numbers):
    """Whether u leaves its start to first order in t, rather than u'."""
    u0, v0 = numbers[:2]
    return abs(v0) > abs(value(force_of(numbers[2:]), u0))


def back(numbers, t):
    found = motion(numbers, t)
    k = 0 if by_place(numbers) else 1
    return None if found is None else found[k] - curve.ball(numbers[k])


def sturm(P):
    chain = [P, derivative(P)]
    while len(chain[-1]) > 1:
        rest = [-x for x in remainder(chain[-2], chain[-1])]
        if not any(rest):
            break
        chain.append(rest)
    return chain


def roots_between(P, a, b):
    """The number of different roots of P in a < u <= b; neither end is a root."""
    chain = sturm(P)

    def changes(x):
        signs = [s for s in (value(p, x) for p in chain) if s]
        return sum(y * z < 0 for y, z in pairwise(signs))

    return changes(a) - changes(b)


def range_wrong(row, numbers, force, low, high, still):
    """Ends of the range: simple roots of P or multiple ones, none between, and the regime they make."""
    found = []
    u0, v0 = numbers[:2]
    if still:
        found += [name for name, x in (("low", low), ("high", high)) if x != u0]
        return found + ([] if row["regime"] == "rest" else ["regime"])
    P = kinetic((u0, v0), force)
    kinds = []
    for name, side, end in (("low", -1, low), ("high", 1, high)):
        if not isinstance(end, Fraction):
            beyond = 2 * (abs(u0) + 1) + sum(abs(g / P[-1]) for g in P)
            near = u0 + side * abs(u0 or 1) / 2**200 if v0 == 0 else u0
            if end != side * math.inf or (near < side * beyond) != (side > 0) or between(P, near, side * beyond):
                found.append(name)
            kinds.append("open")
            continue
        room = max(abs(end) / 2**102, Fraction(1, 2**1100))
        inner, outer = end - side * room, end + side * room
        if v0 == 0 and end == u0:
            inner = end
        elif (u0 - inner) * side < 0 and between(P, u0 if v0 else u0 + side * abs(inner - u0) / 2**90, inner):
            found.append(name)
        at = [value(P, x) for x in (inner, outer)]
        simple = (at[0] > 0 or inner == end) and at[1] < 0
        sides = [value(multiple_roots(P), x) for x in (inner, outer)]
        multiple = sides[0] * sides[1] <= 0
        if not simple and not multiple:
            found.append(name)
        kinds.append("limit" if multiple else "turn")
    regime = "escape"
    if not any(force[2:]):
        regime = "linear"
    elif kinds == ["turn", "turn"]:
        far = 2 * sum(abs(g / P[-1]) for g in P) + 2
        regime = "well" if numbers[4] > 0 and roots_between(P, -far, far) == 4 else "libration"
    elif "open" not in kinds:
        regime = "heteroclinic" if kinds == ["limit", "limit"] else "homoclinic"
    return found + ([] if row["regime"] == regime else ["regime"])


def between(P, a, b):
    a, b = sorted((a, b))
    return roots_between(P, a, b) if value(P, a) and value(P, b) else 0


def common(a, b):
    """The greatest common divisor of two polynomials."""
    while any(b):
        a, b = b, remainder(a, b)
    return a


def multiple_roots(P):
    """A polynomial with the multiple roots of P, each once."""
    shared = common(trimmed(P), derivative(trimmed(P)))
    again = common(shared, derivative(shared))
    quotient, left = [], list(shared)
    while len(left) >= len(again):
        factor = left[-1] / again[-1]
        quotient.insert(0, factor)
        shift = len(left) - len(again)
        left = [x - (factor * again[k - shift] if k >= shift else 0) for k, x in enumerate(left)][:-1]
    return quotient


def scales_wrong(row, numbers, force):
    """The scales: ends of the range and the largest of many velocities on it, or value and start."""
    told = [Fraction(row[name]) for name in ("scale_u", "scale_velocity")]
    low, high, u, v = (curve.stored(row, name) for name in ("low", "high", "u", "velocity"))
    if isinstance(low, Fraction) and isinstance(high, Fraction):
        P = kinetic(numbers[:2], force)
        most = max(value(P, low + (high - low) * Fraction(k, 500)) for k in range(501))
        fastest = curve.mid_root(most) if told[1] else 0
        ranges = (max(abs(low), abs(high)), 10**-15), (fastest, 10**-4 if row["regime"] != "rest" else 0)
    else:
        known = [x if isinstance(x, Fraction) else 0 for x in (u, v)]
        ranges = [(max(abs(x), abs(y)), 10**-15) for x, y in zip(known, numbers, strict=False)]
    names = zip(("scale_u", "scale_velocity"), told, ranges, strict=True)
    # velocities may be too small for a double
    names = [item for item in names if item[1] > Fraction(1, 2**1000) or item[1] == 0]
    return [name for name, x, (y, room) in names if abs(x - y) > Fraction(room) * x]


def slopes_wrong(row):
    """The condition columns of the row that central differences contradict."""
    *numbers, t = stretched(row)
    found = []
    u = curve.stored(row, "u")
    if isinstance(u, Fraction) and u != 0 and t != 0:
        conditions = curve.total(lambda values: motion(values[:-1], values[-1]), [*numbers, t])
        for name, x in zip(("cond_u", "cond_velocity"), conditions, strict=True):
            if not curve.near(x, row[name]):
                found.append(name)
    k = 0 if by_place(numbers) else 1

    def returned(values):
        moved = motion(values[:-1], values[-1])
        return None if moved is None else (moved[k] - curve_ball(values[k]),)

    def gone(values):
        moved = motion(values[:-1], values[-1])
        return None if moved is None else (moved[0] / moved[1],)

    def kinetic_at(values):
        P = quartic([curve_ball(x) for x in values[:-1]])[0]
        return (value(P, curve_ball(values[-1])),)

    def energy(values):
        return (quartic([curve_ball(x) for x in values])[0][0] / 2,)

    if abs(curve.stored(row, "energy")) < math.inf and not curve.near(
        curve.total(energy, numbers)[0], row["cond_energy"]
    ):
        found.append("cond_energy")
    if row["regime"] != "rest":
        for name, function in (
            ("period", returned),
            ("escape", gone),
            ("escape_backward", gone),
            ("low", kinetic_at),
            ("high", kinetic_at),
        ):
            end = curve.stored(row, name)
            if not isinstance(end, Fraction) or row["regime"] == "linear":
                continue
            if row[f"cond_{name}"] == "0" or end == 0:
                continue
            if not curve.near(curve.total(function, [*numbers, end], quotient=True)[0], row[f"cond_{name}"]):
                found.append(f"cond_{name}")
    return found


def curve_ball(x):
    return x if isinstance(x, arb) else curve.ball(x)


def check(name, every, rng):
    """Fails at the first row that is not what it should be; says how many are."""
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != helmholtz_duffing.HEADER:
        fail(name, "columns differ from the generator's")
    if counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail("README.md lacks the line", counted(name, rows))
    if every:
        given = helmholtz_duffing.inputs()
        if [{key: row[key] for key in given[0]} for row in rows] != given:
            fail(name, "inputs are not what the generator draws")
    sample = rows if every else rng.sample(rows, SAMPLE)
    again = sample if every else sample[:AGAIN]
    for row in again:
        if [str(text) for text in helmholtz_duffing.row(row)] != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    for row in sample:
        if found := wrong(row):
            fail(name, "the curve contradicts", found, row)
    for row in sample if every else sample[:SLOPES]:
        if found := slopes_wrong(row):
            fail(name, "differences contradict", found, row)
    if found := oscillator_stated.wrong():
        fail("the generators do not give the stated figures", found)
    row = next(row for row in sample if row["regime"] in ("libration", "well") and row["u_lo"] != "0x0.0p+0")
    for column, bad in mutated(row):
        if not wrong(bad) + slopes_wrong(bad):
            fail(name, "a mutated", column, "passes")
    return f"{len(rows)} rows, {len(again)} derived again"
