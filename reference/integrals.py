"""Reference values for the integrals of the elliptic family in Arb balls: Heuman's lambda, Carlson's four, the third kind.

Heuman: the definition by Legendre's integrals. Pi: R_F and R_J (DLMF 19.25.2, 19.25.14); principal values by 19.20.14,
19.2.20 and 19.6.5. A difference of two large numbers does no harm here, because the precision rises until the ball is narrow.
"""

import math
from fractions import Fraction

from adaptive_precision import columns
from balls import ball, nint
from elliptic import parameters
from flint import acb, arb


def of_given(given):
    """The formula of m and mc as one of the parameter as given."""
    return {"m": lambda p: (p, 1 - p), "mc": lambda p: (1 - p, p), "k": lambda p: (p * p, 1 - p * p)}[given]


def complete(m, mc):
    """K and E of m < 1."""
    K = arb.pi() / 2 / arb(1).agm(ball(mc).sqrt())
    return K, acb(ball(m)).elliptic_e().real if m else arb.pi() / 2


def rf(x, y, z):
    """R_F of rationals or balls >= 0, at most one of them 0; None for a negative one."""
    if any(value < 0 for value in (x, y, z)):
        return None
    return acb.elliptic_rf(*(acb(value if isinstance(value, arb) else ball(value)) for value in (x, y, z))).real


# --------------------------------------------------------------------------------------------- Heuman


def heuman(given):
    def formula(p, phi):
        m, mc = of_given(given)(p)
        x = ball(phi)
        n = nint(x / arb.pi())
        r = x - n * arb.pi()
        if m == 0:
            value = r.sin()
        elif m == 1:
            value = 2 * r / arb.pi()
        else:
            K, E = complete(m, mc)
            F, second = acb.elliptic_f(r, acb(ball(mc))).real, acb.elliptic_e_inc(r, acb(ball(mc))).real
            value = 2 / arb.pi() * (E * F + K * (second - F))
        return {"lambda": 2 * n + value}

    return formula


def heuman_columns(given, parameter, phi):
    m, _ = parameters(given, parameter)
    if m < 0 or m > 1:
        return columns(dict, (), (), ["lambda"])
    if phi == 0:
        return columns(lambda: {"lambda": phi}, (), (), ["lambda"])
    # At either end of the parameter the derivative by it is one-sided or infinite.
    return columns(heuman(given), [Fraction(parameter), Fraction(phi)], (1,) if m in (0, 1) else (0, 1), ["lambda"])


# -------------------------------------------------------------------------------------------- Carlson


def real_rj(x, y, z, p):
    """R_J of balls >= 0; for p < 0 the principal value, DLMF 19.20.14."""
    if p > 0:
        return acb.elliptic_rj(acb(x), acb(y), acb(z), acb(p)).real
    if not p < 0:
        raise ArithmeticError("the ball is too wide for the sign of p")
    q = -p
    p = (z * (x + y + q) - x * y) / (z + q)
    a, b = x * y + p * q, p * q
    value = (p - z) * acb.elliptic_rj(acb(x), acb(y), acb(z), acb(p)).real - 3 * rf(x, y, z)
    if not (x == 0 or y == 0 or z == 0):
        value += 3 * (x * y * z / a).sqrt() * acb.elliptic_rc(acb(a), acb(b)).real
    return value / (z + q)


def real_rc(x, y):
    """R_C; for y < 0 the principal value, DLMF 19.2.20."""
    if y > 0:
        return acb.elliptic_rc(acb(x), acb(y)).real
    return (x / (x - y)).sqrt() * acb.elliptic_rc(acb(x - y), acb(-y)).real if x != 0 else 0.0


CARLSON = {"rf": 3, "rc": 2, "rd": 3, "rj": 4}


def carlson(function):
    def formula(*inputs):
        if function == "rj":
            largest_last = [*sorted(inputs[:3]), inputs[3]]
            return {"value": real_rj(*map(ball, largest_last))}
        x = [ball(value) for value in inputs]
        if function == "rc":
            return {"value": real_rc(*x)}
        if function == "rd":
            return {"value": acb.elliptic_rd(*map(acb, x)).real}
        return {"value": rf(*x)}

    return formula


def carlson_edge(function, x):
    """The value at an edge of the domain, None inside: infinite, 0 for an infinite argument, NaN beyond."""
    first = {"rc": 1, "rd": 2}.get(function, 3)
    if any(math.isnan(value) for value in x) or min(x[:first]) < 0 or (function == "rd" and x[2] < 0):
        return math.nan
    if any(map(math.isinf, x)):
        return 0.0
    zeros = sum(value == 0 for value in x[:first])
    singular = {"rf": zeros > 1, "rc": x[1] == 0, "rd": zeros > 1 or x[-1] == 0, "rj": zeros > 1 or x[-1] == 0}
    return math.inf if singular[function] else None


def carlson_columns(function, x, y, z, p):
    inputs = [x, y, z, p][: CARLSON[function]]
    edge = carlson_edge(function, inputs)
    if edge is not None:
        return columns(lambda: {"value": edge}, (), (), ["value"])
    return columns(carlson(function), [*map(Fraction, inputs)], range(len(inputs)), ["value"])


# ----------------------------------------------------------------------------------------- third kind


def complete_pi(n, m, mc):
    """Pi(n | m) for m < 1, n != 1; DLMF 19.6.5 for n > 1."""
    zero, one = arb(0), arb(1)
    if n > 1:
        return rf(zero, ball(mc), one) - complete_pi(m / n, m, mc)
    return rf(zero, ball(mc), one) + ball(n) / 3 * real_rj(zero, ball(mc), one, ball(1 - n))


def third_kind(function, given):
    def formula(p, n, phi):
        m, mc = of_given(given)(p)
        if function == "complete_pi":
            return {"value": complete_pi(n, m, mc)}
        x = ball(phi)
        turns = nint(x / arb.pi())
        s, c = (x - turns * arb.pi()).sin(), (x - turns * arb.pi()).cos()
        square = c * c + ball(mc) * s * s
        if square < 0 or (m > 1 and turns != 0):
            return {}
        if not square > 0:
            raise ArithmeticError("the ball is too wide for the domain")
        value = s * rf(c * c, square, arb(1))
        if n:
            value += ball(n) / 3 * s**3 * real_rj(c * c, square, arb(1), 1 - ball(n) * s * s)
        if turns == 0:
            return {"value": value}
        if n == 1 or m == 1:
            return {"value": math.copysign(math.inf, phi) * (1 if n <= 1 else -1)}
        return {"value": value + 2 * turns * complete_pi(n, m, mc)}

    return formula


def third_kind_columns(function, given, parameter, n, phi):
    m, _ = parameters(given, parameter)
    inputs = [Fraction(parameter), Fraction(n), Fraction(phi)]
    if function == "complete_pi":
        if m > 1 or n == 1 or m == 1:
            # DLMF 19.6.1 and 19.6.6; the complete integral is not real for m > 1.
            edge = math.nan if m > 1 else (-math.inf if n > 1 else math.inf)
            return columns(lambda: {"value": edge}, (), (), ["value"])
        return columns(third_kind(function, given), inputs, (0, 1), ["value"])
    if phi == 0:
        return columns(lambda: {"value": phi}, (), (), ["value"])
    return columns(third_kind(function, given), inputs, (0, 1, 2), ["value"])
