"""Reference values for the approximations of the angle; writes vectors/approx_angle.csv.

Each formula as its author writes it, with the phase of the exact orbit from Carlson's R_F (orbit.py). Series are summed from
the nome. Taylor coefficients come from derivatives computed as polynomials. The motions of polynomial sines are the closed form of
a release from rest, shifted in time to the start. `difference` is the approximation minus the exact angle; `scale` is the
size of the angle that its error is measured by; conditions are central differences at many more digits. NaN where a
formula has no value. Run: python approx_angle.py (a minute).
"""

from collections import Counter
from fractions import Fraction

import exact
import mpmath as mp
import orbit
from exact import agreed, decimal, hi_lo, mpf, real
from oscillator_inputs import Draw

NAME = "approx_angle.csv"
INPUTS = "id stratum formula theta0 velocity0 omega2 t".split()
OUTPUTS = ["theta", "difference", "period"]
HEADER = [*INPUTS, *(f"{name}_{part}" for name in OUTPUTS for part in ("hi", "lo")), "scale"]
HEADER += ["cond_theta", "cond_difference", "cond_period"]


class Motion:
    """The exact orbit at the working precision: theta(t), and the phase that formulas run on."""

    def __init__(self, theta0, velocity0, omega2):
        self.given = theta0, velocity0, omega2
        self.regime, n, self.omega, self.s, self.c, self.x, self.m, self.mc = orbit.start(theta0, velocity0, omega2)
        self.base = 2 * mp.pi * n + (mp.pi if omega2 < 0 else 0)
        self.theta0, self.velocity0 = real(theta0), real(velocity0)
        s, c, x, m = self.s, self.c, self.x, self.m
        arc = s * mp.elliprf(x * x, m * c * c, m)
        if self.regime == "libration":
            self.K = mp.elliprf(0, self.mc, 1)
            self.nome = mp.exp(-mp.pi * mp.elliprf(0, m, 1) / self.K)
            self.theta_max = 2 * mp.atan2(mp.sqrt(m), mp.sqrt(self.mc))
            self.start = arc if x > 0 else mp.sign(s) * self.K if x == 0 else (mp.sign(s) or 1) * 2 * self.K - arc
            self.flip, self.rate = 1, self.omega
            self.period = 4 * self.K / self.omega
        else:
            self.K = mp.elliprf(0, -self.mc / m, 1)
            self.nome = mp.exp(-mp.pi * mp.elliprf(0, 1 / m, 1) / self.K)
            self.theta_max = mp.nan
            self.flip, self.rate = mp.sign(x), self.omega * mp.sqrt(m)
            self.start = mp.sqrt(m) * self.flip * arc
            self.period = 2 * self.K / self.rate

    def argument(self, t):
        return self.start + self.rate * t

    def theta(self, t):
        u = self.argument(t)
        if self.regime == "libration":
            sn, _, dn, _, _ = orbit.jacobi_reduced(u, self.m)
            return self.base + 2 * mp.atan2(mp.sqrt(self.m) * sn, dn)
        return self.base + self.flip * 2 * orbit.jacobi_reduced(u, 1 / self.m)[3]


def linear(motion, t, _):
    w = motion.omega
    return motion.theta0 * mp.cos(w * t) + motion.velocity0 / w * mp.sin(w * t), 2 * mp.pi / w


def harmonic(motion, t, _):
    wave = mp.sin(mp.pi * motion.argument(t) / (2 * motion.K))
    return motion.base + motion.theta_max * wave, motion.period


def fourier(motion, t, order):
    """Lima (20)-(22)."""
    K, q, u = motion.K, motion.nome, motion.argument(t)
    waves = sum(mp.sqrt(q) ** j / (1 - q**j) * mp.sin(j * mp.pi * u / (2 * K)) for j in range(1, 2 * order, 2))
    sn = 2 * mp.pi / K * waves
    return (mp.nan if abs(sn) > 1 else motion.base + 2 * mp.asin(sn)), motion.period


def fourier_theta(motion, t, order):
    K, q, u = motion.K, motion.nome, motion.argument(t)
    if motion.regime == "rotation":
        waves = sum(q**n / (n * (1 + q ** (2 * n))) * mp.sin(n * mp.pi * u / K) for n in range(1, order + 1))
        return motion.base + motion.flip * (mp.pi * u / K + 4 * waves), motion.period
    waves = sum(mp.sqrt(q) ** j / (j * (1 + q**j)) * mp.sin(j * mp.pi * u / (2 * K)) for j in range(1, 2 * order, 2))
    return motion.base + 8 * waves, motion.period


def trigonometric(motion, t, _):
    """Salas (35) from the last turning point on."""
    x = motion.theta_max**2
    k = motion.omega * mp.sqrt(1 - 10 * x / 81 + x * x / 262)
    flattening = (243 * x * x - 2620 * x) / (243 * x * x - 7860 * x + 63666)
    j = mp.floor((motion.start / motion.K - 1) / 2) if motion.velocity0 else mp.nint((motion.start / motion.K - 1) / 2)
    since = (motion.start - (2 * j + 1) * motion.K) / motion.omega if motion.velocity0 else mpf(0)
    angle = k * (t + since)
    wave = mp.cos(angle) / mp.sqrt(1 + flattening * mp.sin(angle) ** 2)
    return motion.base + (-1) ** int(j) * motion.theta_max * wave, 2 * mp.pi / k


def small_m(motion, t, _):
    """Salas before fig. 6: the expansion of (24) to first order in m, with his N and D."""
    w, v, phi = motion.omega, motion.velocity0, motion.theta0
    u = w * t
    sin, cos = mp.sin(u), mp.cos(u)
    y = u - sin * cos
    n0 = 2 * w * w * mp.sin(phi) * cos + 2 * w * v * sin
    n1 = w * w / 2 * mp.sin(phi) * y * sin + 2 * w * v * (-(sin**3) / 2 - y * cos / 4)
    d0 = 2 * w * w * (1 + mp.cos(phi)) - v * v * sin * sin
    d1 = v * v / 2 * sin * cos * y
    return motion.base + 2 * mp.atan((n0 * d0 + motion.m * (n1 * d0 - n0 * d1)) / d0**2), mp.nan


def small_m_bounded(motion, t, _):
    s, c, x, m = motion.s, motion.c, motion.x, motion.m
    z = mp.pi * motion.omega * t / (2 * motion.K)
    sn = (1 + m / 16) * mp.sin(z) + m / 16 * mp.sin(3 * z)
    cn = (1 - m / 16) * mp.cos(z) + m / 16 * mp.cos(3 * z)
    dn = 1 - m / 4 + m / 4 * mp.cos(2 * z)
    return motion.base + 2 * mp.atan2(s * c * cn + x * dn * sn, c * c - x * x * sn * sn), motion.period


class Released:
    """u'' + w^2 (u - 40/243 u^3 + gamma u^5) = 0 released from A, through 0."""

    def __init__(self, motion, gamma):
        self.w, u, v = motion.omega, motion.theta0, motion.velocity0
        self.beta, self.gamma = -mpf(40) / 243, gamma
        energy = v * v / (2 * self.w**2) + self.potential(u * u)
        self.escapes = False
        if gamma == 0:
            # Over the barrier, or beyond it, the orbit does not return.
            barrier = -1 / self.beta
            self.escapes = u * u >= barrier or energy >= self.potential(barrier)
        if not self.escapes:
            y = self.turning(energy, u * u)
            self.A = mp.sqrt(y)
            self.P, self.Q = mp.sqrt(self.force(y)), mp.sqrt(1 + self.beta * y / 2 + gamma * y * y / 3)
            self.m = (gamma * y * y / 3 - (self.P - self.Q) ** 2) / (4 * self.P * self.Q)
            self.period = 4 * mp.ellipk(self.m) / mp.sqrt(self.P * self.Q) / self.w
            self.start = self.found(u, v)

    def potential(self, y):
        return y / 2 + self.beta * y * y / 4 + self.gamma * y**3 / 6

    def force(self, y):
        return 1 + self.beta * y + self.gamma * y * y

    def turning(self, energy, y):
        """A^2: the potential grows all the way to it."""
        for _ in range(400):
            step = (energy - self.potential(y)) / (self.force(y) / 2)
            y += step
            if abs(step) < mp.eps * y * 16:
                return y
        raise ArithmeticError("no turning point")

    def u(self, time):
        z = mp.sqrt(self.P * self.Q) * self.w * time
        sn, cn, dn = (mp.ellipfun(name, z, m=self.m).real for name in ("sn", "cn", "dn"))
        return self.A * cn / mp.sqrt(cn * cn + self.P / self.Q * (sn * dn) ** 2)

    def found(self, u, v):
        """When it passes u with the velocity v, from A at rest."""
        if v == 0:
            return mpf(0) if u > 0 else self.period / 2
        low, high = mpf(0), self.period / 2
        for _ in range(30):
            middle = (low + high) / 2
            low, high = (middle, high) if self.u(middle) > u else (low, middle)
        time = mp.findroot(
            lambda t: self.u(t) - u, (low, high), solver="anderson", tol=mp.eps * mpf(10) ** 6, verify=False
        )
        return time if v < 0 else -time

    def theta(self, t):
        time = self.start + t
        return self.u(time - self.period * mp.nint(time / self.period))


def model(gamma):
    def theta(motion, t, _):
        released = Released(motion, gamma())
        # All escapes of the rows happen before their times.
        return (mp.nan, mp.nan) if released.escapes else (released.theta(t), released.period)

    return theta


def derivative(terms):
    """d/dt of a polynomial in v, sin theta, cos theta and omega2, by its exponents: v' = -omega2 sin theta."""
    found = Counter()
    for (v, sin, cos, force), factor in terms.items():
        for exponents, by in (
            ((v - 1, sin + 1, cos, force + 1), -v),
            ((v + 1, sin - 1, cos + 1, force), sin),
            ((v + 1, sin + 1, cos - 1, force), -cos),
        ):
            if by:
                found[exponents] += factor * by
    return found


def coefficients(given, order):
    """Taylor coefficients of the exact angle: its derivatives, worked out as polynomials."""
    theta0, velocity0, omega2 = map(real, given)
    places = velocity0, mp.sin(theta0), mp.cos(theta0), omega2
    found, terms = [theta0], Counter({(1, 0, 0, 0): 1})
    for k in range(1, order + 1):
        value = sum(
            factor * mp.fprod(x**e for x, e in zip(places, exponents, strict=True))
            for exponents, factor in terms.items()
        )
        found.append(value / mp.factorial(k))
        terms = derivative(terms)
    return found


def taylor(motion, t, order):
    return sum(a * t**k for k, a in enumerate(coefficients(motion.given, order))), mp.nan


FORMULAS = {
    "linear": linear,
    "harmonic": harmonic,
    "fourier": fourier,
    "fourier-theta": fourier_theta,
    "trigonometric": trigonometric,
    "small-m": small_m,
    "small-m-bounded": small_m_bounded,
    "cubic": model(lambda: mpf(0)),
    "cubic-quintic": model(lambda: mpf(1) / 131),
    "taylor": taylor,
}


def values(formula, theta0, velocity0, omega2, t):
    """theta, difference and period of a formula."""
    name, _, order = formula.partition(":")
    motion, time = Motion(theta0, velocity0, omega2), real(t)
    theta, period = FORMULAS[name](motion, time, int(order or 0))
    return [theta, theta - motion.theta(time), period]


def conditions(formula, given):
    """sum |x d/dx| of each output, by central differences."""
    totals = [mpf(0)] * len(OUTPUTS)
    for i, value in enumerate(given):
        if value == 0:
            continue
        moved = lambda sign, i=i, value=value: [*given[:i], value * (1 + sign * Fraction(1, 2**120)), *given[i + 1 :]]  # noqa: E731
        above, below = values(formula, *moved(1)), values(formula, *moved(-1))
        totals = [total + abs(a - b) * mpf(2) ** 119 for total, a, b in zip(totals, above, below, strict=True)]
    return [mpf(0) if mp.isnan(total) else total for total in totals]


def scale(formula, given, theta):
    """The size of the angle: its own, that of the swing, of the start; of the largest term of a polynomial."""
    motion, t = Motion(*given[:3]), real(given[3])
    sizes = [abs(theta), abs(motion.theta0)]
    name, _, order = formula.partition(":")
    if name == "linear":
        sizes.append(mp.hypot(motion.theta0, motion.velocity0 / motion.omega))
    elif name == "taylor":
        sizes += [abs(a * t**k) for k, a in enumerate(coefficients(given[:3], int(order)))]
    elif motion.regime == "libration":
        sizes.append(motion.theta_max)
    return max(size for size in sizes if not mp.isnan(size))


def row(inputs):
    """One row of the file from its input columns."""
    formula = inputs["formula"]
    given = [Fraction(float.fromhex(inputs[name])) for name in INPUTS[3:]]
    digits = orbit.first_digits(*given) + 40
    _, leads, _ = agreed(lambda: (formula, values(formula, *given), []), digits)
    with mp.workdps(digits + 60):
        slopes = conditions(formula, given)
        size = scale(formula, given, leads[0])
    with mp.workdps(60):
        pairs = [word for lead in leads for word in hi_lo(lead)]
        return [*(inputs[name] for name in INPUTS), *pairs, decimal(+size, 6), *(decimal(+s, 6) for s in slopes)]


def swings(draw):
    """stratum, theta0, velocity0, omega2 of librations."""
    number, sign = draw.number, draw.sign
    for _ in range(3):
        yield "rest", sign() * 3 * draw.part(), 0.0, number()
    for _ in range(3):
        yield "moving", sign() * 1.8 * draw.part(), sign() * draw.part(), 1.0 + draw.part()
    yield "bottom", 0.0, sign() * (0.2 + draw.part()), 1.0
    yield "small", sign() * 1e-9 * (0.5 + draw.part()), sign() * 1e-9 * draw.part(), number()
    yield "near_top", 3.14159, 0.0, 1.0
    yield "near_top", -2.5, 0.631, 1.0
    yield "turned", 6.0 + draw.part(), draw.part() - 0.5, 9.8
    yield "turned", -20.0 + draw.part(), 0.0, 2.0


def spins(draw):
    """stratum, theta0, velocity0, omega2 of rotations."""
    for _ in range(3):
        yield "rotation", draw.sign() * 3 * draw.part(), draw.sign() * (2.1 + 3 * draw.part()), 1.0
    yield "rotation", 0.0, 2.0 + 2.0**-40, 1.0
    yield "rotation", 9.0 + draw.part(), -40.0, 2.0


def hanging(draw):
    """stratum, theta0, velocity0, omega2 < 0 of both regimes."""
    yield "hanging", 3.0 * draw.part(), draw.part(), -2.0
    yield "hanging", 4.0 + draw.part(), 0.0, -1.0
    yield "hanging", 1.0, -4.0 - draw.part(), -1.0


ORDERS = {"fourier": (1, 2, 5, 16), "fourier-theta": (1, 3, 12), "taylor": (1, 4, 9)}
ALL = ("linear", "small-m", "cubic-quintic", "taylor")
ABOUT_ANY = ("harmonic", "fourier", "fourier-theta")
# Where the sine models and the series in m are about theta = 0 as it is given.
LITERAL = ("cubic", "cubic-quintic")
ESCAPES = [(2.6, 0.0, 1.0, 40.0), (-0.3, 1.9, 1.0, 60.0)]


def inputs():
    """Every row's id, stratum and inputs."""
    draw, rows = Draw(20250801), []

    def add(formula, stratum, theta0, velocity0, omega2, t):
        numbers = [float(number).hex() for number in (theta0, velocity0, omega2, t)]
        rows.append(dict(zip(INPUTS, [f"angle-{len(rows):04d}", stratum, formula, *numbers], strict=True)))

    def times(formula, theta0, velocity0, omega2):
        period = float(orbit.rough_period(theta0, velocity0, Fraction(omega2)))
        yield 2 * (draw.part() - 0.5) * period
        if formula.startswith("taylor"):
            yield draw.part() * 0.2 * period
        elif formula == "small-m":
            yield (20 + draw.part()) * period
        else:
            yield 1e6 * (1 + draw.part()) * period

    for name in FORMULAS:
        for order in ORDERS.get(name, (0,)):
            formula = f"{name}:{order}" if order else name
            states = list(swings(draw))
            if name in ALL or name == "fourier-theta":
                states += list(spins(draw))
            if name in ABOUT_ANY:
                states += list(hanging(draw))
            for stratum, *state in states:
                if name not in (*ALL, "fourier-theta") and orbit.start(*map(Fraction, state))[0] != "libration":
                    continue
                if name in LITERAL and (stratum == "turned" or (name == "cubic" and stratum == "near_top")):
                    continue
                for t in times(formula, *state):
                    add(formula, stratum, *state, t)
            add(formula, "t_zero", 1.5, 0.25, 1.0, 0.0)
    for theta0, velocity0, omega2, t in ESCAPES:
        add("cubic", "escaped", theta0, velocity0, omega2, t)
    return rows


if __name__ == "__main__":
    exact.write(NAME, HEADER, map(row, inputs()))
