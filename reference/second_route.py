"""Checks of the elliptic family in mpmath, by other formulas than those of family.py; used by check.py.

Jacobi's functions: Landen's chain (elliptic.py), of complex arguments the addition theorem A&S 16.21; inverses: the
function itself on both sides of the value; zeta: the sum of c_n sin phi_n along the chain, A&S 17.6.10, and epsilon
for m > 1 the integral of dn^2; theta functions: their series, or for q > 0.9 the sum of Gaussians, DLMF 20.7.30 to
20.7.33; Heuman's lambda: R_J, DLMF 19.25.18; Carlson's integrals and Pi: the defining integral over t = exp(s) by the
trapezoidal rule, along Im s = pi/2 for a principal value, whose real part it is.
"""

import math
from fractions import Fraction

import mpmath as mp
import nome_inverse
from elliptic import digits, jacobi_evaluate
from exact import mpf, real
from family import GLAISHER, NINE, NINE_PARTS, PARTS, TABLE
from integrals import of_given

TOLERANCE = mpf(2) ** -104
SMALLEST = mpf(2) ** -1073  # what lo cannot hold


def jacobi(u, m, mc):
    with mp.workdps(digits(m, mc, u) + 100):
        sn, cn, dn, _ = jacobi_evaluate(u, m, mc)
    return sn, cn, dn


def ratios(u, m, mc):
    sn, cn, dn = jacobi(u, m, mc)
    part = {"s": sn, "c": cn, "d": dn, "n": mpf(1)}
    with mp.workdps(200):
        return {name: part[name[0]] / part[name[1]] for name in GLAISHER}


def glaisher(row):
    return lambda p, u: ratios(u, *of_given(row["given"])(p))


# ---------------------------------------------------------------------------------------- second kind


def zeta(u, m, mc):
    """Sum of c_n sin phi_n; the last is phi_N = 2^N a_N u."""
    a, b, chain = mpf(1), mp.sqrt(real(mc)), []
    while abs(a - b) > a * mp.eps * 4:
        a, b, c = (a + b) / 2, mp.sqrt(a * b), (a - b) / 2
        chain.append((c, a))
    phi, total = mp.ldexp(a * u, len(chain)), mpf(0)
    for c, a in reversed(chain):
        total += c * mp.sin(phi)
        phi = (phi + mp.asin(c / a * mp.sin(phi))) / 2
    return total


def mean(mc):
    """E/K."""
    return mp.elliprg(0, real(mc), 1) * 2 / mp.elliprf(0, real(mc), 1)


def second_kind(row):
    def formula(p, u):
        m, mc = of_given(row["given"])(p)
        if m == 1:
            with mp.workdps(80):
                return {"epsilon": mp.tanh(real(u)), "zeta": mp.tanh(real(u))}
        with mp.workdps(digits(m, mc, u, *([1 / m] if 0 < abs(m) < 1 else [])) + 100):
            if m > 1 and abs(u) * abs(u) * m < 4:
                quadrature = mp.quad(lambda t: jacobi_evaluate(exactly(t * real(u)), m, mc)[2] ** 2, [0, mpf(1) / 2, 1])
                return {"epsilon": real(u) * quadrature}
            if m > 1:  # further out from the reciprocal parameter, which the quadrature confirms
                root = mp.sqrt(real(m))
                inner = zeta(real(u) * root, 1 / m, -mc / m) + real(u) * root * mean(-mc / m)
                return {"epsilon": root * inner + real(mc) * real(u)}
            Z = zeta(real(u), m, mc)
            return {"epsilon": Z + real(u) * mean(mc), "zeta": Z}

    return formula


def exactly(x):
    sign, mantissa, exponent, _ = x._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


# ---------------------------------------------------------------------------------------------- theta


def theta(row):
    def formula(p, z):
        m, mc = (p, 1 - p) if row["given"] == "q" else of_given(row["given"])(p)
        with mp.workdps(digits(m, mc, z) + 100):
            if row["given"] == "q":
                log_q, negative = mp.log(abs(real(p))), p < 0
            else:
                negative = m < 0
                if negative:
                    m, mc = -m / mc, 1 / mc
                log_q = -mp.pi * mp.elliprf(0, real(m), 1) / mp.elliprf(0, real(mc), 1)
            one, two, three, four = series(real(z), log_q) if log_q < -0.1 else gaussians(real(z), log_q)
        if negative:
            return {"theta3": four, "theta4": three}
        return {"theta1": one, "theta2": two, "theta3": three, "theta4": four}

    return formula


def series(z, log_q):
    """DLMF 20.2.1 to 20.2.4."""
    one = two = mpf(0)
    three = four = mpf(1)
    n = 0
    while (n - 1) * n * log_q > -mp.mp.prec:
        odd, even = mp.exp(log_q * (n + mpf(1) / 2) ** 2), mp.exp(log_q * (n + 1) ** 2)
        one += 2 * (-1) ** n * odd * mp.sin((2 * n + 1) * z)
        two += 2 * odd * mp.cos((2 * n + 1) * z)
        three += 2 * even * mp.cos(2 * (n + 1) * z)
        four += 2 * (-1) ** (n + 1) * even * mp.cos(2 * (n + 1) * z)
        n += 1
    return one, two, three, four


def gaussians(z, log_q):
    """Sums over z + n pi/2 of exp((z + n pi/2)^2 / log q), scaled."""
    nearest = int(mp.nint(2 * z / mp.pi))
    reach = 4 + int(mp.sqrt(mp.mp.prec * -log_q))
    scale = mp.sqrt(mp.pi / -log_q)
    one = two = three = four = mpf(0)
    for n in range(nearest - reach, nearest + reach + 1):
        bell = scale * mp.exp((z - n * mp.pi / 2) ** 2 / log_q)
        if n % 2:  # theta_1 and theta_4 have their bells at odd multiples of pi/2
            one, four = one + (bell if n % 4 == 1 else -bell), four + bell
        else:
            two, three = two + (bell if n % 4 == 0 else -bell), three + bell
    return one, two, three, four


# --------------------------------------------------------------------------------------------- Heuman


def heuman(row):
    def formula(p, phi):
        m, mc = of_given(row["given"])(p)
        with mp.workdps(digits(m, mc, phi) + 400 * (m < 1e-9) + 60):
            n = mp.nint(real(phi) / mp.pi)
            r = real(phi) - n * mp.pi
            s, c = mp.sin(r), mp.cos(r)
            if m == 0:
                return {"lambda": 2 * n + s}
            if m == 1:
                return {"lambda": 2 * n + 2 * r / mp.pi}
            k, kc = real(m), real(mc)
            square = c * c + k * s * s
            integral = mp.elliprf(0, kc, 1) + k / square / 3 * mp.elliprj(0, kc, 1, kc * c * c / square)
            return {"lambda": 2 * n + 2 / mp.pi * kc * s * c / mp.sqrt(square) * integral}

    return formula


# -------------------------------------------------------------------------- integrals by the trapezoid


def trapezoid(integrand, places):
    """The integral over t from 0 to infinity, integrand(t) ds with t = exp(s): the sum converges like
    exp(-2 pi d/h), d the distance of singularities, which lie on Im s = +-pi and, at t = -y > 0, on Im s = 0."""
    sizes = [mp.log(abs(x)) for x in places if x]
    shift = mp.pi / 2 if any(x < 0 for x in places) else mpf(0)
    distance = mp.pi - shift if shift else mp.pi
    accuracy = mp.mp.dps * mp.log(10)
    h = 2 * mp.pi * distance / accuracy / mpf("1.05")
    low, high = min(sizes) - 2.1 * accuracy, max(sizes) + 2.1 * accuracy
    # exp(s) on a lattice is a product, not an exponential each
    t, ratio = mp.exp(low) * (mp.mpc(0, 1) if shift else 1), mp.exp(h)
    total = mpf(0)
    for _ in range(int((high - low) / h) + 1):
        total += mp.re(integrand(t))
        t *= ratio
    return h * total


QUADRATURE = 38


def root(t, *places):
    """The product of sqrt(t + x), each continued from positive t."""
    if isinstance(t, mpf):
        return mp.sqrt(math.prod(t + x for x in places))
    return math.prod(mp.sqrt(t + x) for x in places)


def carlson(row):
    kernels = {
        "rf": lambda t, x, y, z: t / (2 * root(t, x, y, z)),
        "rc": lambda t, x, y: t / (2 * root(t, x) * (t + y)),
        "rd": lambda t, x, y, z: 3 * t / (2 * root(t, x, y, z) * (t + z)),
        "rj": lambda t, x, y, z, p: 3 * t / (2 * root(t, x, y, z) * (t + p)),
    }
    kernel = kernels[row["function"]]

    def formula(*inputs):
        with mp.workdps(QUADRATURE + spread_digits(inputs)):
            places = [real(x) for x in inputs]
            return {"value": trapezoid(lambda t: kernel(t, *places), places)}

    return formula


def spread_digits(inputs):
    """A principal value cancels, by about the spread of its arguments at worst."""
    if min(inputs) >= 0:
        return 0
    sizes = [math.log10(abs(x).numerator) - math.log10(abs(x).denominator) for x in inputs if x]
    return int(max(sizes) - min(sizes))


def third_kind(row):
    """sin^2 theta = 1/(c + t) in the defining integral, c = 1/sin^2 phi."""

    def once(n, m, c, c_less_one):
        c_less_n, c_less_m = c_less_one + real(1 - n), c_less_one + real(1 - m)

        def kernel(t):
            return t * (t + c) / (2 * (t + c_less_n) * root(t, c_less_one, c_less_m, c))

        return trapezoid(kernel, [c_less_one, c_less_m, c, c_less_n])

    def formula(p, n, *phi):
        m, mc = of_given(row["given"])(p)
        # A principal value cancels down to about m/n.
        extra = digits(m, mc, *phi, *([n * n] if n > 1 else []), *([1 / m] if n > 1 and 0 < abs(m) < 1 else [])) - 70
        with mp.workdps(QUADRATURE + extra):
            if not phi:
                return {"value": once(n, m, mpf(1), mpf(0))}
            turns = mp.nint(real(phi[0]) / mp.pi)
            r = real(phi[0]) - turns * mp.pi
            c = 1 / mp.sin(r) ** 2
            value = mp.sign(r) * once(n, m, c, mp.cot(r) ** 2)
            return {"value": value + 2 * turns * once(n, m, mpf(1), mpf(0)) if turns else value}

    return formula


# -------------------------------------------------------------------------------------------- complex


def jacobi_complex(row):
    def formula(p, re, im):
        m, mc = of_given(row["given"])(p)
        s, c, d = (mpf(0), mpf(1), mpf(1)) if re == 0 else jacobi(re, m, mc)
        s1, c1, d1 = (mpf(0), mpf(1), mpf(1)) if im == 0 else jacobi(im, mc, m)
        with mp.workdps(digits(m, mc, re, im) + 100):
            k = real(m)
            bottom = c1 * c1 + k * (s * s1) ** 2
            tops = s * d1, c * d * s1 * c1, c * c1, -s * d * s1 * d1, d * c1 * d1, -k * s * c * s1
            return {name: top / bottom for name, top in zip(PARTS, tops, strict=True)}

    return formula


def glaisher_complex(row):
    """Quotients of the three above as complex numbers."""
    three = jacobi_complex(row)

    def formula(p, re, im):
        found = three(p, re, im)
        with mp.workdps(digits(*of_given(row["given"])(p), re, im) + 100):
            s, c, d = (mp.mpc(found[f"{name}_re"], found[f"{name}_im"]) for name in ("sn", "cn", "dn"))
            part = {"s": s, "c": c, "d": d, "n": mpf(1)}
            values = [part[name[0]] / part[name[1]] for name in NINE]
            return dict(zip(NINE_PARTS, (x for value in values for x in (value.real, value.imag)), strict=True))

    return formula


# ---------------------------------------------------------------------------------------------- check

ROUTES = {
    "glaisher.csv": glaisher,
    "second_kind.csv": second_kind,
    "theta_functions.csv": theta,
    "heuman.csv": heuman,
    "carlson.csv": carlson,
    "third_kind.csv": third_kind,
    "jacobi_complex.csv": jacobi_complex,
    "glaisher_complex.csv": glaisher_complex,
    "from_nome.csv": lambda _: nome_inverse.parameters,
}
BY_TRAPEZOID = ("carlson.csv", "third_kind.csv")
COUNTED = {"rf": 3, "rc": 2, "rd": 3, "rj": 4, "complete_pi": 2}


def inputs_of(name, row):
    """The arguments of a row, rational; None where one is not finite."""
    numbers = [float.fromhex(row[field]) for field in TABLE[name][0] if field not in ("given", "function")]
    numbers = numbers[: COUNTED.get(row.get("function"), len(numbers))]
    return [Fraction(x) for x in numbers] if all(map(math.isfinite, numbers)) else None


def written(row, name):
    """hi, and hi + lo as a number."""
    hi, lo = (float.fromhex(row[f"{name}_{part}"]) for part in ("hi", "lo"))
    with mp.workdps(80):
        return hi, mpf(hi) + mpf(lo)


def final(row, name):
    """Infinite, NaN, an exact 0 or 1: the edges, which have no second formula."""
    hi, value = written(row, name)
    return not math.isfinite(hi) or value in (0, 1)


def differs(value, expected):
    return not abs(value - expected) <= abs(expected) * TOLERANCE + SMALLEST


def wrong(name, row):
    """The columns of a row that the second route contradicts."""
    inputs = inputs_of(name, row)
    names = [x for x in TABLE[name][1] if not final(row, x)]
    if inputs is None or not names:
        return []
    if name == "inverse_jacobi.csv":
        return inverse(row, *inputs)
    formula = ROUTES[name](row)
    values = formula(*inputs)
    with mp.workdps(80):
        return [x for x in names if x in values and differs(written(row, x)[1], values[x])]


def inverse(row, p, x):
    """pq(u) at u a little less and a little more than written lies on both sides of x, or at the end of the range."""
    m, mc = of_given(row["given"])(p)
    _, u = written(row, "value")
    with mp.workdps(80):
        around = [exactly(u + side * (abs(u) * TOLERANCE + SMALLEST)) for side in (-1, 1)]
    values = [ratios(point, m, mc)[row["function"]] for point in around]
    with mp.workdps(80):
        if abs(x) > 1:
            low, high = (1 / value - 1 / real(x) for value in values)
        else:
            low, high = (value - real(x) for value in values)
        if low * high <= 0:
            return []
        # Next to an extremum both lie on one side: then x is the extreme value, missed by the square of the step.
        return [] if max(abs(low), abs(high)) < TOLERANCE**2 * 2**20 else ["value"]


# Strata whose conditions are not compared: one-sided, infinite, or a quadrature too far for differences.
WITHOUT = ("m_one", "m_zero", "range_end", "m_above", "edge_of_range")


def differentiable(name, row):
    """Whether the conditions of a row are compared; the third kind next to its pole is not, nearer than the step."""
    near = name == "third_kind.csv" and abs(1 - float.fromhex(row["n"])) < 1e-5
    return not near and row["stratum"] not in WITHOUT


def conditions_wrong(name, row):
    """Condition columns against central differences of the second route. At m = 1 family.py differs from it on purpose."""
    inputs = inputs_of(name, row)
    names = [x for x in TABLE[name][1] if not final(row, x)]
    if inputs is None or not names or not differentiable(name, row):
        return []
    if name == "inverse_jacobi.csv":
        return inverse_condition(row, *inputs)
    formula, step = ROUTES[name](row), Fraction(1, 2 ** (40 if name in BY_TRAPEZOID else 160))
    total = dict.fromkeys(names, mpf(0))
    for i, x in enumerate(inputs):
        if x:
            sides = [formula(*inputs[:i], x * (1 + side * step), *inputs[i + 1 :]) for side in (1, -1)]
            for output in names:
                if any(output not in side for side in sides):
                    return []
                with mp.workdps(200):
                    total[output] += abs(sides[0][output] - sides[1][output]) / (2 * real(step))
    return [f"cond_{x}" for x in names if far_off(row, x, total[x])]


def inverse_condition(row, p, x):
    """From the slopes of the function: du/dx = 1/pq', du/dp = -(d pq/dp)/pq'."""
    step = Fraction(1, 2**100)
    u = exactly(written(row, "value")[1])

    def value(p, u):
        return ratios(u, *of_given(row["given"])(p))[row["function"]]

    with mp.workdps(80):
        by_u = (value(p, u * (1 + step)) - value(p, u * (1 - step))) / (2 * real(step * u))
        by_p = (value(p * (1 + step), u) - value(p * (1 - step), u)) / (2 * real(step))
        if abs(by_u * real(u)) < mpf("1e-25") * abs(real(x)):
            return []  # the end of the range, met by rounding
        total = (abs(real(x)) + abs(by_p)) / abs(by_u)
    return ["cond_value"] if far_off(row, "value", total) else []


def far_off(row, output, value):
    with mp.workdps(30):
        return not abs(mpf(row[f"cond_{output}"]) - value) <= mpf("1e-3") * value + mpf("1e-100")
