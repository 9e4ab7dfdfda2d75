"""Reference values for orbits stated by an energy, a turning angle, a period, or an angle from the top; writes vectors/starts.csv.

What is stated gives m and 1 - m at the working precision, none by a subtraction of doubles; the period is inverted by the
secant method in ln(m/(1 - m)). Then velocity0 = 2 omega sqrt(m - sin(r/2)^2), and the motion is that of orbit.py. The conditions
are central differences in every input. Run: python starts.py (a minute).
"""

import math
import random
from fractions import Fraction

import exact
import mpmath as mp
import orbit
from exact import agreed, decimal, hi_lo, mpf, real

NAME = "starts.csv"
INPUTS = "stratum counted angle known value direction omega2 t".split()
OUTPUTS = "theta0 velocity0 theta velocity period energy_ratio energy_ratio_c theta_max energy".split()
HEADER = [*INPUTS, "regime", *(f"{name}_{part}" for name in OUTPUTS for part in ("hi", "lo"))]
HEADER += [f"cond_{name}" for name in OUTPUTS]
NUMBERS = ("angle", "value", "omega2", "t")


def of_period(target, rotation):
    """m and 1 - m with omega T = target, by the secant method in y = ln(m/(1 - m)) or, in rotation, y = -ln(m - 1)."""

    def period(y):
        if rotation:
            m, mc = 1 + mp.exp(-y), -mp.exp(-y)
            return 2 * mp.elliprf(0, -mc / m, 1) / mp.sqrt(m)
        return 4 * mp.elliprf(0, 1 / (1 + mp.exp(y)), 1)

    if rotation:
        y = target - mp.log(16) if target > 5 else -mp.log((2 * mp.pi / target) ** 2 / 4)
    else:
        excess = target / (2 * mp.pi) - 1
        y = target / 2 - mp.log(16) if target > 9 else mp.log(4 * excess)
    last, found = y + mpf(1) / 8, y
    below, here = period(last) - target, period(found) - target
    for _ in range(200):
        if here == below:
            break
        last, found, below = found, found - here * (found - last) / (here - below), here
        here = period(found) - target
        if abs(found - last) < mpf(10) ** (10 - mp.mp.dps):
            break
    if rotation:
        return 1 + mp.exp(-found), -mp.exp(-found)
    return 1 / (1 + mp.exp(-found)), 1 / (1 + mp.exp(found))


def energy_of(known, value, omega2):
    """m and 1 - m."""
    x = real(value)
    if known == "energy_ratio":
        return x, 1 - x
    if known == "energy_ratio_c":
        return 1 - x, x
    if known == "energy":
        return real(value / (2 * abs(omega2))), real(1 - value / (2 * abs(omega2)))
    if known == "theta_max":
        return mp.sin(x / 2) ** 2, mp.cos(x / 2) ** 2
    if known == "theta_max_from_top":
        return mp.cos(x / 2) ** 2, mp.sin(x / 2) ** 2
    return of_period(mp.sqrt(real(abs(omega2))) * x, known == "period_of_rotation")


def evaluate(counted, known, direction, angle, value, omega2, t):
    """regime and the OUTPUTS."""
    omega, time = mp.sqrt(real(abs(omega2))), real(t)
    bottom = mp.pi if omega2 < 0 else mpf(0)
    theta0 = {"theta": real(angle), "from_top": mp.pi - bottom + real(angle), "bottom": bottom}[counted]
    n = mp.nint((theta0 - bottom) / (2 * mp.pi))
    r = theta0 - bottom - 2 * mp.pi * n
    if counted == "from_top":
        # cos(r/2) from what was given, whose size it has.
        s, c = mp.cos(real(angle) / 2), -mp.sin(real(angle) / 2)
        if c < 0 or (c == 0 and r < 0):
            s, c = -s, -c
        s = abs(s) * (1 if r >= 0 else -1)
    elif counted == "bottom":
        s, c = mpf(0), mpf(1)
    else:
        s, c = mp.sin(r / 2), mp.cos(r / 2)
    if known == "velocity":
        x = real(value) / (2 * omega)
        m, mc = s * s + x * x, (c - x) * (c + x)
    else:
        m, mc = energy_of(known, value, omega2)
        x = direction * mp.sqrt(m - s * s if m < 0.5 else c * c - mc)
    regime = "rest" if m == 0 else "libration" if mc > 0 else "rotation" if mc < 0 else "separatrix"
    T = orbit.period(regime, omega, m, mc)
    if regime == "libration":
        theta_max = 2 * mp.asin(mp.sqrt(m)) if m < 0.5 else mp.pi - 2 * mp.asin(mp.sqrt(mc))
    else:
        theta_max = {"rest": mpf(0), "separatrix": +mp.pi, "rotation": mp.nan}[regime]
    kept = [T, m, mc, theta_max, 2 * omega * omega * m]
    v = 2 * omega * x
    if regime == "rest" or (x == 0 and c == 0):
        return regime, [theta0, v, theta0, mpf(0), *kept]
    arc = s * mp.elliprf(x * x, m * c * c, m)
    side = -1 if x < 0 else 1
    if regime == "libration":
        tau0, flip = arc if x >= 0 else (mp.sign(s) or 1) * 2 * mp.elliprf(0, mc, 1) - arc, 1
    else:
        tau0, flip = side * arc, side
    turned, rate, *_ = orbit.canonical(tau0 + omega * time, m, mc)
    return regime, [theta0, v, 2 * mp.pi * n + flip * turned + bottom, flip * omega * rate, *kept]


def conditions(text, numbers):
    """sum |x d/dx| of each output, by central differences; an input that cannot move both ways is left out."""
    totals = [mpf(0)] * len(OUTPUTS)
    for i, value in enumerate(numbers):
        if value == 0:
            continue
        sides = [
            evaluate(*text, *numbers[:i], value * (1 + sign * Fraction(1, 2**130)), *numbers[i + 1 :])[1]
            for sign in (1, -1)
        ]
        for j, (above, below) in enumerate(zip(*sides, strict=True)):
            if mp.isfinite(above) and mp.isfinite(below):
                totals[j] += abs(above - below) * mpf(2) ** 129
    return totals


def digits(known, numbers):
    """A precision for which nothing is lost: the sizes of the inputs, and 1 - m of a long period."""
    sizes = [abs(math.log10(abs(x.numerator)) - math.log10(x.denominator)) for x in numbers if x]
    _, value, omega2, _ = numbers
    long = float(value) * math.sqrt(abs(omega2)) / 2 if known.startswith("period") else 0
    return 120 + 2 * int(max(sizes)) + int(long)


def row(inputs):
    """One row of the file from its input columns."""
    numbers = [Fraction(float.fromhex(inputs[name])) for name in NUMBERS]
    text = inputs["counted"], inputs["known"], int(inputs["direction"])

    def both():
        regime, leads = evaluate(*text, *numbers)
        return regime, leads, []

    enough = digits(inputs["known"], numbers)
    regime, leads, _ = agreed(both, enough)
    with mp.workdps(enough + 90):
        slopes = conditions(text, numbers) if regime in ("libration", "rotation") else [mpf(0)] * len(OUTPUTS)
    with mp.workdps(60):
        pairs = [word for lead in leads for word in hi_lo(lead)]
        return [*(inputs[name] for name in INPUTS), regime, *pairs, *(decimal(+slope, 6) for slope in slopes)]


# --------------------------------------------------------------------------------------------- inputs


def log_uniform(rng, low, high):
    return math.ldexp(rng.uniform(1, 2), rng.randint(low, high))


def values(rng):
    """stratum, known and value over omega0 = 1 (energies and periods are brought to the force)."""
    for _ in range(12):
        yield "ratio", "energy_ratio", rng.choice((rng.random(), 1 + rng.random(), log_uniform(rng, -40, 20)))
        yield "complement", "energy_ratio_c", rng.choice((-1, 1)) * log_uniform(rng, -60, -1)
        yield "complement_small", "energy_ratio_c", rng.choice((-1, 1)) * log_uniform(rng, -900, -60)
        yield "energy", "energy", rng.choice((2 * rng.random(), 2 + 3 * rng.random(), log_uniform(rng, -40, 20)))
        yield "theta_max", "theta_max", rng.choice((math.pi * rng.random(), log_uniform(rng, -60, 0)))
        yield "theta_max_from_top", "theta_max_from_top", log_uniform(rng, -500, 0)
        yield "period", "period", 2 * math.pi * (1 + rng.choice((rng.random(), log_uniform(rng, -44, 6))))
        yield "period_of_rotation", "period_of_rotation", log_uniform(rng, -20, 8)
    for value in (1e-17, -1e-17, 1e-20, -1e-20, 1e-300, -1e-300, 5e-324, -5e-324, 1.0, -1e30):
        yield "complement_ends", "energy_ratio_c", value
    for value in (0.0, 1e-300, 5e-324, 1.0, 1.0 + 2**-52, 1.0 - 2**-53, 1e50):
        yield "ratio_ends", "energy_ratio", value
    for value in (0.0, 2.0, math.nextafter(2.0, 3), math.nextafter(2.0, 0)):
        yield "energy_ends", "energy", value
    for value in (math.pi, 1e-300, math.nextafter(math.pi, 0)):
        yield "theta_max_ends", "theta_max", value
    for value in (1e-17, 1e-290, 0.0, math.pi):
        yield "theta_max_ends", "theta_max_from_top", value
    for value in (1.25 * 2 * math.pi, math.nextafter(2 * math.pi, 7), 6.3, 2670.0):
        yield "period_ends", "period", value
    for value in (1330.0, 1e-8, 2.6, 2.7):
        yield "period_ends", "period_of_rotation", value


def inputs():
    """The rows without their outputs. Angles away from the bottom keep away from the turning angle."""
    rng = random.Random("starts")
    found = []

    def item(stratum, counted, angle, known, value, direction, omega2, t):
        numbers = (x.hex() for x in (angle, value))
        angle, value = numbers
        row = [stratum, counted, angle, known, value, str(direction), omega2.hex(), float(t).hex()]
        found.append(dict(zip(INPUTS, row, strict=True)))

    for stratum, known, value in values(rng):
        ends = stratum.endswith("ends")
        omega2 = 1.0 if ends else rng.choice((1.0, 73.5, -2.25, 0.3, -9.80665))
        omega = math.sqrt(abs(omega2))
        scaled = value * abs(omega2) if known == "energy" else value / omega if known.startswith("period") else value
        with mp.workdps(400):
            m, mc = energy_of(known, Fraction(scaled), Fraction(omega2))
            slow = min(abs(mp.log(abs(mc))), 800) if mc else 20
            t = float(rng.uniform(-2, 2) * (4 + slow) / omega / mp.sqrt(max(m, 1)))
            reach = 2 * mp.asin(mp.sqrt(min(m, 1))) if m < 0.9 else mp.pi
            angle = float(reach * rng.uniform(-0.8, 0.8))
        direction = rng.choice((1, -1))
        item(stratum, "bottom", 0.0, known, scaled, direction, omega2, t)
        if m == 0 or ends or abs(angle) < 1e-200:
            continue
        turn = 2 * math.pi * rng.choice((0, 0, 1, -3)) + (math.pi if omega2 < 0 else 0.0)
        if abs(angle) > 1e-6:
            item(stratum, "theta", angle + turn, known, scaled, direction, omega2, t)
        elif omega2 > 0:
            item(stratum, "theta", angle, known, scaled, direction, omega2, t)
        if mc < 0 or m > 0.9:
            beyond = float(mp.sqrt(abs(mc)) * rng.uniform(2.5, 5)) if mc > 0 else log_uniform(rng, -300, -2)
            if beyond < 1.5:
                beyond *= rng.choice((1, -1))
                item(stratum, "from_top", beyond, known, scaled, direction, omega2, t)
    for _ in range(12):
        omega2 = rng.choice((1.0, 73.5, -2.25))
        beyond = rng.choice((1, -1)) * log_uniform(rng, -200, 1)
        speed = rng.choice((0.0, 0.0, 1.0)) * log_uniform(rng, -60, 1)
        t = rng.uniform(-2, 2) * (4 + abs(math.log(abs(beyond)))) / math.sqrt(abs(omega2))
        item("from_top", "from_top", beyond, "velocity", speed, 1, omega2, t)
    item("from_top", "from_top", 1e-17, "velocity", 0.0, 1, 73.5, 4.7055881337172294)
    item("from_top", "from_top", 0.0, "velocity", 0.0, 1, 1.0, 3.0)
    return found


if __name__ == "__main__":
    exact.write(NAME, HEADER, map(row, inputs()))
