"""Reference values for the whole elliptic family in Arb balls.

Jacobi's functions: theta quotients (balls.py), of complex arguments too; inverses: R_F (DLMF 19.25.29 to 19.25.34);
epsilon: E(am u), zeta: its definition; theta functions: Arb's; the other integrals in integrals.py. Every value is a
ball narrower than 2^-140. elliptic_vectors.py writes the files.
"""

import math
from fractions import Fraction

import balls
from adaptive_precision import STEP, columns
from balls import ball, nint
from elliptic import parameters
from flint import acb, arb
from integrals import (
    carlson_columns,
    complete,
    heuman_columns,
    of_given,
    rf,
    third_kind_columns,
)

GLAISHER = "sn cn dn ns nc nd sc cs sd ds cd dc".split()


def step_of(given, parameter, u):
    """At m = 1 the derivative by m or k grows like exp(2u), and so must the differences shrink."""
    return STEP + (int(12 * abs(u)) if given != "mc" and parameters(given, parameter)[0] == 1 else 0)


# ------------------------------------------------------------------------------------------- Glaisher


def three(u, m, mc):
    """sn, cn, dn and am of a real rational u != 0."""
    u = ball(u)
    if m == 0:
        return u.sin(), u.cos(), arb(1), u
    if m == 1:
        return u.tanh(), u.sech(), u.sech(), u.sinh().atan()
    return balls.jacobi(u, ball(m), ball(mc))


def twelve(s, c, d):
    part = {"s": s, "c": c, "d": d, "n": type(s)(1)}
    return {name: part[name[0]] / part[name[1]] for name in GLAISHER}


def glaisher(given):
    def formula(p, u):
        m, mc = of_given(given)(p)
        return twelve(*three(u, m, mc)[:3])

    return formula


def glaisher_columns(given, parameter, u):
    if u == 0:
        pole = math.copysign(math.inf, u)
        exactly = {"sn": u, "sc": u, "sd": u, "ns": pole, "cs": pole, "ds": pole}
        return columns(lambda: {name: exactly.get(name, 1.0) for name in GLAISHER}, (), (), GLAISHER)
    inputs = [Fraction(parameter), Fraction(u)]
    return columns(glaisher(given), inputs, (0, 1), GLAISHER, step_of(given, parameter, u))


# ------------------------------------------------------------------------------------------- inverses


def delta(p, q, m, mc):
    """Delta(p, q) of DLMF 19.25.28, antisymmetric."""
    table = {"nd": m, "dc": mc, "nc": Fraction(1)}
    return table[p + q] if p + q in table else -table[q + p]


def half_period(m, mc):
    """The first zero of cn for m < 1, of dn for m > 1: the last is K(1/m)/sqrt(m)."""
    if m == 1:
        return arb("inf")
    K = rf(Fraction(0), mc, Fraction(1)) if m < 1 else rf(Fraction(0), -mc / m, Fraction(1)) / ball(m).sqrt()
    return K


def inverse_value(name, x, m, mc):
    """arcpq(x | m) as a ball or a final float; None outside."""
    p, q = name
    u = first_branch(p, q, abs(x), m, mc)
    if x >= 0 or u is None:
        return u
    if "s" in name:
        return -u
    zero = {"c", "d"} & {p, q} if {"c", "d"} == {p, q} else ({"c"} if m < 1 else {"d"}) & {p, q}
    if not zero or m == 1:
        return None  # an even function without a zero or a real pole is positive
    return 2 * half_period(m, mc) - u


def first_branch(p, q, x, m, mc):
    """x >= 0: the least u >= 0 with pq(u) = x."""
    one, square = Fraction(1), x * x
    if "s" in (p, q):
        other = q if p == "s" else p
        a, b = (delta(letter, other, m, mc) for letter in "cdn" if letter != other)
        if q == "s":
            arguments = (square, square + a, square + b)
            if min(arguments) == 0 and sum(value == 0 for value in arguments) > 1:
                return math.inf  # m = 1: the end of the range is taken at infinity
            return rf(*arguments)
        if x == 0:
            return 0.0
        arguments = (one, one + a * square, one + b * square)
        if min(arguments) == 0 and sum(value == 0 for value in arguments) > 1:
            return math.inf
        u = rf(*arguments)
        return None if u is None else ball(x) * u
    if x == 1:
        return 0.0
    distance = delta(q, p, m, mc)
    if distance == 0:
        return None  # dn at m = 0, cd at m = 1 are 1 everywhere
    w = (1 - square) / distance
    (r,) = (letter for letter in "cdn" if letter not in (p, q))
    arguments = (square, one, one + delta(r, q, m, mc) * w)
    if w < 0 or min(arguments) < 0:
        return None
    if sum(value == 0 for value in arguments) > 1:
        return math.inf
    return ball(w).sqrt() * rf(*arguments)


def inverse(name, given):
    def formula(p, x):
        value = inverse_value(name, x, *of_given(given)(p))
        return {} if value is None else {"value": value}

    return formula


def inverse_columns(name, given, parameter, x):
    inputs = [Fraction(parameter), Fraction(x)]
    step = STEP
    if parameters(given, parameter)[0] == 1:
        u = inverse(name, given)(*inputs).get("value", 0.0)
        step = step_of(given, parameter, 0 if isinstance(u, float) else 1 + int(nint(abs(u)).unique_fmpz()))
    if x == 0 and name in ("sn", "sd", "sc"):
        return columns(lambda: {"value": x}, (), (), ["value"])
    return columns(inverse(name, given), inputs, (0, 1), ["value"], step)


# ---------------------------------------------------------------------------------------- second kind


def epsilon(u, m, mc):
    """The integral of dn^2 from 0 to u."""
    if m == 0:
        return ball(u)
    if m == 1:
        return ball(u).tanh()
    if m < 1:
        return acb.elliptic_e_inc(three(u, m, mc)[3], acb(ball(m))).real
    root = ball(m).sqrt()
    am = balls.jacobi(ball(u) * root, ball(1 / m), ball(-mc / m))[3]
    return root * acb.elliptic_e_inc(am, acb(ball(1 / m))).real + ball(mc * u)


def second_kind(given):
    def formula(p, u):
        m, mc = of_given(given)(p)
        value = epsilon(u, m, mc)
        if m > 1:
            return {"epsilon": value}
        if m == 0:
            return {"epsilon": value, "zeta": math.copysign(0.0, u)}
        if m == 1:
            return {"epsilon": value, "zeta": value}
        K, E = complete(m, mc)
        return {"epsilon": value, "zeta": value - ball(u) * E / K}

    return formula


def second_kind_columns(given, parameter, u):
    m, _ = parameters(given, parameter)
    names = ["epsilon", "zeta"]
    if u == 0:
        return columns(lambda: {"epsilon": u, "zeta": u if m <= 1 else math.nan}, (), (), names)
    inputs = [Fraction(parameter), Fraction(u)]
    if m == 1 and given != "mc":  # zeta has no derivative by m here, and is tanh u
        formula = second_kind(given)

        def only(p, x):
            return {"epsilon": formula(p, x)["epsilon"]}

        row = columns(only, inputs, (0, 1), ["epsilon"], step_of(given, parameter, u))
        along = columns(formula, inputs, (1,), names)
        return row[:2] + along[2:4] + row[2:] + along[5:]
    return columns(second_kind(given), inputs, (0, 1), names)


# ---------------------------------------------------------------------------------------------- theta


def theta_of_tau(z, height):
    """theta_1 to theta_4 at nome exp(-pi height)."""
    values = acb(ball(z) / arb.pi()).modular_theta(acb(0, height))
    return [value.real for value in values]


def theta(given):
    def formula(p, z):
        if given == "q":
            height = -ball(abs(p)).log() / arb.pi()
            negative = p < 0
        else:
            m, mc = of_given(given)(p)
            negative = m < 0
            if negative:
                m, mc = -m / mc, 1 / mc
            height = arb(1).agm(ball(mc).sqrt()) / arb(1).agm(ball(m).sqrt())
        one, two, three_, four = theta_of_tau(z, height)
        if negative:
            return {"theta3": four, "theta4": three_}
        return {"theta1": 0.0 if z == 0 else one, "theta2": two, "theta3": three_, "theta4": four}

    return formula


def theta_columns(given, parameter, z):
    names = ["theta1", "theta2", "theta3", "theta4"]
    q = Fraction(parameter) if given == "q" else parameters(given, parameter)[0]
    outside = abs(q) >= 1 if given == "q" else q >= 1
    if outside:
        return columns(dict, (), (), names)
    if q == 0:
        zero = math.copysign(0.0, z)
        nothing = {"theta1": zero, "theta2": 0.0, "theta3": 1.0, "theta4": 1.0}
        return columns(lambda: nothing, (), (), names)
    return columns(theta(given), [Fraction(parameter), Fraction(z)], (0, 1), names)


# -------------------------------------------------------------------------------------------- complex

PARTS = [f"{name}_{part}" for name in ("sn", "cn", "dn") for part in ("re", "im")]


def complex_three(u, m, mc):
    """sn, cn, dn of a complex ball."""
    if m == 0:
        return u.sin(), u.cos(), acb(1)
    if m == 1:
        return u.tanh(), u.sech(), u.sech()
    if m > 1:
        root = ball(m).sqrt()
        sn, dn, cn = complex_three(u * root, 1 / m, -mc / m)
        return sn / root, cn, dn
    K = arb.pi() / 2 / arb(1).agm(ball(mc).sqrt())
    if m < 0:
        tau = acb(1, arb(1).agm(ball(1 / mc).sqrt()) / arb(1).agm(ball(-m / mc).sqrt()))
    else:
        tau = acb(0, arb(1).agm(ball(mc).sqrt()) / arb(1).agm(ball(m).sqrt()))
    z = u / (2 * K)
    rows = nint(z.imag / tau.imag)  # z + tau: cn and dn change sign; z + 1: sn and cn do
    z -= rows * tau
    turns = nint(z.real)
    z -= turns
    odd_row, odd_turn = ((-1) ** int(count.unique_fmpz()) for count in (rows, turns))
    _, t2, t3, t4 = acb(0).modular_theta(tau)
    a1, a2, a3, a4 = z.modular_theta(tau)
    return odd_turn * (t3 / t2 * a1 / a4), odd_turn * odd_row * (t4 / t2 * a2 / a4), odd_row * (t4 / t3 * a3 / a4)


def jacobi_complex(given):
    def formula(p, re, im):
        m, mc = of_given(given)(p)
        values = complex_three(acb(ball(re), ball(im)), m, mc)
        parts = dict(zip(PARTS, (part for value in values for part in (value.real, value.imag)), strict=True))
        if im == 0:
            parts |= {"sn_im": 0.0, "cn_im": 0.0, "dn_im": 0.0}
        elif re == 0:
            parts |= {"sn_re": 0.0, "cn_im": 0.0, "dn_im": 0.0}
        if m == 0:
            parts["dn_im"] = 0.0
        return parts

    return formula


def jacobi_complex_columns(given, parameter, re, im):
    if re == im == 0:
        zero = {"sn_re": 0.0, "sn_im": 0.0, "cn_re": 1.0, "cn_im": 0.0, "dn_re": 1.0, "dn_im": 0.0}
        return columns(lambda: zero, (), (), PARTS)
    inputs = [Fraction(parameter), Fraction(re), Fraction(im)]
    return columns(jacobi_complex(given), inputs, (0, 1, 2), PARTS, step_of(given, parameter, re))


NINE = [name for name in GLAISHER if name not in ("sn", "cn", "dn")]
NINE_PARTS = [f"{name}_{part}" for name in NINE for part in ("re", "im")]


def glaisher_complex(given):
    """The nine that are quotients of sn, cn, dn and 1, of a complex ball that is no pole."""

    def formula(p, re, im):
        m, mc = of_given(given)(p)
        values = twelve(*complex_three(acb(ball(re), ball(im)), m, mc))
        # On the axes an odd function has no real or no imaginary part, an even one no imaginary part.
        zeros = {f"{name}_im": 0.0 for name in NINE if im == 0 or (re == 0 and "s" not in name)}
        zeros |= {f"{name}_re": 0.0 for name in NINE if re == 0 and "s" in name}
        same = ("nd",) if m == 0 else ("cd", "dc") if m == 1 else ()
        ones = {f"{name}_{part}": one for name in same for part, one in (("re", 1.0), ("im", 0.0))}
        parts = {f"{name}_{part}": getattr(values[name], word) for name in NINE for part, word in AXES}
        return parts | zeros | ones

    return formula


AXES = (("re", "real"), ("im", "imag"))


def glaisher_complex_columns(given, parameter, re, im):
    inputs = [Fraction(parameter), Fraction(re), Fraction(im)]
    return columns(glaisher_complex(given), inputs, (0, 1, 2), NINE_PARTS, step_of(given, parameter, re))


# -------------------------------------------------------------------------------------- nome to parameter


def of_nome(q):
    """m and 1 - m of a rational nome: Arb's theta functions at 0."""
    height = -ball(abs(q)).log() / arb.pi()
    _, two, three_, four = theta_of_tau(Fraction(0), height)
    m, mc = (two / three_) ** 4, (four / three_) ** 4
    return {"m": -m / mc, "mc": 1 / mc} if q < 0 else {"m": m, "mc": mc}


def from_nome_columns(q):
    if q == 0:
        return columns(lambda: {"m": q, "mc": 1.0}, (), (), ["m", "mc"])
    if q == 1:
        return columns(lambda: {"m": 1.0, "mc": 0.0}, (), (), ["m", "mc"])
    if not -1 < q < 1:
        return columns(dict, (), (), ["m", "mc"])
    return columns(of_nome, [Fraction(q)], (0,), ["m", "mc"])


# ---------------------------------------------------------------------------------------------- files


def header(fields, names):
    return ["stratum", *fields, *(f"{x}_{part}" for x in names for part in ("hi", "lo")), *(f"cond_{x}" for x in names)]


# file: (arguments, outputs, what makes the columns); an argument that the function does not have is 0.
TABLE = {
    "glaisher.csv": (["given", "parameter", "u"], GLAISHER, glaisher_columns),
    "inverse_jacobi.csv": (["function", "given", "parameter", "x"], ["value"], inverse_columns),
    "second_kind.csv": (["given", "parameter", "u"], ["epsilon", "zeta"], second_kind_columns),
    "theta_functions.csv": (
        ["given", "parameter", "z"],
        ["theta1", "theta2", "theta3", "theta4"],
        theta_columns,
    ),
    "heuman.csv": (["given", "parameter", "phi"], ["lambda"], heuman_columns),
    "carlson.csv": (["function", "x", "y", "z", "p"], ["value"], carlson_columns),
    "third_kind.csv": (["function", "given", "parameter", "n", "phi"], ["value"], third_kind_columns),
    "jacobi_complex.csv": (["given", "parameter", "re", "im"], PARTS, jacobi_complex_columns),
    "glaisher_complex.csv": (["given", "parameter", "re", "im"], NINE_PARTS, glaisher_complex_columns),
    "from_nome.csv": (["q"], ["m", "mc"], from_nome_columns),
}


def row_of(name):
    fields, _, make = TABLE[name]

    def row(inputs):
        given = [inputs[x] if x in ("given", "function") else float.fromhex(inputs[x]) for x in fields]
        return [inputs["stratum"], *(inputs[x] for x in fields), *make(*given)]

    return row


FILES = {name: (header(fields, names), row_of(name)) for name, (fields, names, _) in TABLE.items()}
