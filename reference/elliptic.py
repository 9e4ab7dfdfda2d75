"""Reference values for Jacobi functions, complete and incomplete elliptic integrals, by mpmath.

A real parameter is given as m, as mc = 1 - m or as k (m = k^2), a double taken as an exact rational, so m and
mc are both exact. Jacobi: descending Landen chain for the amplitude (DLMF 22.20.6), reciprocal parameter for
m > 1 (22.17.2-4). Integrals: Carlson's R_F, R_D, R_G (19.25.1, 19.25.5, 19.25.9-10). Nome: exp(-pi K'/K), for
m < 0 its analytic continuation q(m) = -q(-m/(1-m)).
"""

import math
from fractions import Fraction

import mpmath as mp
from exact import agreed, decimal, hi_lo, mpf, real

JACOBI = (
    "stratum given parameter u sn_hi sn_lo cn_hi cn_lo dn_hi dn_lo am_hi am_lo cond_sn cond_cn cond_dn cond_am"
).split()
SPECIAL = "stratum given parameter u sn cn dn am".split()
COMPLETE = (
    "stratum given parameter complete_k_hi complete_k_lo complete_e_hi complete_e_lo nome_hi nome_lo "
    "cond_complete_k cond_complete_e cond_nome"
).split()
INCOMPLETE = (
    "stratum given parameter phi incomplete_f_hi incomplete_f_lo incomplete_e_hi incomplete_e_lo "
    "cond_incomplete_f cond_incomplete_e"
).split()


def parameters(given, parameter):
    """m and mc as exact rationals."""
    p = Fraction(parameter)
    m = {"m": p, "mc": 1 - p, "k": p * p}[given]
    return m, 1 - m


def by_given(given, parameter, m):
    """p dm/dp for the given parameter p: turns a derivative by m into a condition number."""
    return {"m": m, "mc": -Fraction(parameter), "k": 2 * m}[given]


def digits(m, mc, *arguments):
    """Working digits at which the first two precisions nearly always agree."""
    sizes = [abs(x) for x in arguments if x] + [max(1, abs(m))]
    large = sum(max(0, math.log10(size.numerator) - math.log10(size.denominator)) for size in sizes)
    close = max(0, math.log10(mc.denominator) - math.log10(abs(mc.numerator))) if mc else 0
    return int(75 + large + 1.1 * close)


# --------------------------------------------------------------------------------------------- Jacobi


def landen(u, mc):
    """am(u), mc > 0: phi_N = 2^N a_N u, sin(2 phi_(n-1) - phi_n) = (c_n / a_n) sin phi_n down to phi_0."""
    a, b, chain = mpf(1), mp.sqrt(mc), []
    while abs(a - b) > a * mp.eps * 4:
        a, b, c = (a + b) / 2, mp.sqrt(a * b), (a - b) / 2
        chain.append(c / a)
    phi = mp.ldexp(a * u, len(chain))
    for ratio in reversed(chain):
        phi = (phi + mp.asin(ratio * mp.sin(phi))) / 2
    return phi


def jacobi_evaluate(u, m, mc):
    """sn, cn, dn and the amplitude, the integral of dn from 0 to u."""
    x, p, pc = real(u), real(m), real(mc)
    if m == 1:
        return mp.tanh(x), mp.sech(x), mp.sech(x), 2 * mp.atan(mp.tanh(x / 2))
    if m < 1:
        am = landen(x, pc)
        sn, cn = mp.sin(am), mp.cos(am)
        return sn, cn, mp.sqrt(cn * cn + pc * sn * sn), am
    root = mp.sqrt(p)
    phi = landen(x * root, -pc / p)
    sn, dn = mp.sin(phi) / root, mp.cos(phi)
    cn = mp.sqrt(dn * dn - pc / p * mp.sin(phi) ** 2)
    return sn, cn, dn, mp.atan2(sn, cn)


def jacobi(given, parameter, u):
    """sn, cn, dn, am and |u d/du| of each, accepted at two precisions."""
    m, mc = parameters(given, parameter)
    x = Fraction(u)
    _, leads, _ = agreed(lambda: (None, jacobi_evaluate(x, m, mc), ()), digits(m, mc, x))
    with mp.workdps(60):
        sn, cn, dn, _ = (+value for value in leads)
        conditions = [abs(real(x) * d) for d in (cn * dn, sn * dn, real(m) * sn * cn, dn)]
    if u == 0:  # sn and am are odd: the sign of zero passes through
        leads = (u, 1.0, 1.0, u)
    return leads, conditions


def jacobi_row(inputs):
    given, parameter, u = inputs["given"], *(float.fromhex(inputs[name]) for name in ("parameter", "u"))
    leads, conditions = jacobi(given, parameter, u)
    row = [inputs["stratum"], given, inputs["parameter"], inputs["u"]]
    return row + [text for value in leads for text in hi_lo(value)] + [decimal(c, 6) for c in conditions]


def special_row(inputs):
    """Infinite u at m = 1 gives the limits; every other infinity or NaN gives NaN."""
    given, parameter, u = inputs["given"], *(float.fromhex(inputs[name]) for name in ("parameter", "u"))
    values = [math.nan] * 4
    if math.isinf(u) and math.isfinite(parameter) and parameters(given, parameter)[0] == 1:
        values = [math.copysign(1.0, u), 0.0, 0.0, math.copysign(math.pi / 2, u)]
    elif math.isfinite(u) and math.isfinite(parameter):
        values = [hi if isinstance(hi, float) else float.fromhex(hi_lo(hi)[0]) for hi in jacobi(given, parameter, u)[0]]
    return [inputs["stratum"], given, inputs["parameter"], inputs["u"], *(value.hex() for value in values)]


# ------------------------------------------------------------------------------------------- complete


def complete_evaluate(m, mc):
    """K, E, nome and their derivatives by m, for m < 1."""
    p, pc = real(m), real(mc)
    K, E = mp.elliprf(0, pc, 1), 2 * mp.elliprg(0, pc, 1)
    if m < 0:  # both parameters of q(-m/(1-m)) lie between 0 and 1
        nome = -mp.exp(-mp.pi * mp.elliprf(0, -p / pc, 1) / mp.elliprf(0, 1 / pc, 1))
    else:
        nome = mp.exp(-mp.pi * mp.elliprf(0, p, 1) / K) if m else mpf(0)
    slope_k = mp.elliprd(0, 1, pc) / 6
    slope_e = -mp.elliprd(0, pc, 1) / 6
    slope_q = mp.pi**2 * nome / (4 * p * pc * K * K) if m else mpf(1) / 16
    return (K, E, nome), (slope_k, slope_e, slope_q)


def complete(given, parameter):
    """K, E, nome and |p d/dp| of each. m = 1: inf, 1, 1 exactly; m > 1 and non-finite parameters: NaN."""
    if not math.isfinite(parameter):
        return [mp.nan] * 3, [mpf(0)] * 3
    m, mc = parameters(given, parameter)
    if m > 1:
        return [mp.nan] * 3, [mpf(0)] * 3
    if m == 1:
        return [mp.inf, mpf(1), mpf(1)], [mpf(0)] * 3
    _, leads, slopes = agreed(lambda: (None, *complete_evaluate(m, mc)), digits(m, mc))
    with mp.workdps(60):
        return leads, [abs(real(by_given(given, parameter, m)) * slope) for slope in slopes]


def complete_row(inputs):
    leads, conditions = complete(inputs["given"], float.fromhex(inputs["parameter"]))
    row = [inputs["stratum"], inputs["given"], inputs["parameter"]]
    return row + [text for value in leads for text in hi_lo(value)] + [decimal(c, 6) for c in conditions]


# ----------------------------------------------------------------------------------------- incomplete


def outside(phi, m):
    """m > 1 and m sin^2 > 1 somewhere on [0, phi]."""
    with mp.workdps(60):
        return m > 1 and abs(real(phi)) > mp.asin(1 / mp.sqrt(real(m)))


def incomplete_evaluate(phi, m, mc):
    """F, E and their derivatives by phi and by m; at m = 1 past pi/2 F is infinite and has none."""
    x, p, pc = real(phi), real(m), real(mc)
    n = mp.nint(x / mp.pi)
    s, c = mp.sin(x), mp.cos(x)
    if int(n) % 2:
        s, c = -s, -c
    delta2 = c * c + pc * s * s
    delta = mp.sqrt(delta2)
    if m == 1 and n != 0:
        return (mp.sign(x) * mp.inf, 2 * n + s), (mpf(0), delta, mpf(0), mpf(0))
    F = s * mp.elliprf(c * c, delta2, 1)
    D = s**3 * mp.elliprd(c * c, delta2, 1) / 3  # (F - E) / m, which is finite at m = 0
    E = F - p * D
    if n:
        F += 2 * n * mp.elliprf(0, pc, 1)
        D += 2 * n * mp.elliprd(0, pc, 1) / 3
        E += 4 * n * mp.elliprg(0, pc, 1)
    by_m = (s / c**2 - F) / 4 if m == 1 else (F - D - s * c / delta) / (2 * pc)
    return (F, E), (1 / delta, delta, by_m, -D / 2)


def incomplete(given, parameter, phi):
    """F, E and |phi d/dphi| + |p d/dp| of each. phi = +-inf: +-inf for m <= 1; NaN outside the domain."""
    blank = [mp.nan] * 2, [mpf(0)] * 2
    if not math.isfinite(parameter) or math.isnan(phi):
        return blank
    m, mc = parameters(given, parameter)
    if math.isinf(phi):
        return blank if m > 1 else ([mpf(phi)] * 2, [mpf(0)] * 2)
    x = Fraction(phi)
    if outside(x, m):
        return blank
    if phi == 0:
        return [phi] * 2, [mpf(0)] * 2

    def evaluate():
        leads, (f_phi, e_phi, f_m, e_m) = incomplete_evaluate(x, m, mc)
        scale = real(by_given(given, parameter, m))
        return None, leads, [abs(real(x) * f_phi) + abs(scale * f_m), abs(real(x) * e_phi) + abs(scale * e_m)]

    return agreed(evaluate, digits(m, mc, x))[1:]


def incomplete_row(inputs):
    given, parameter, phi = inputs["given"], *(float.fromhex(inputs[name]) for name in ("parameter", "phi"))
    leads, conditions = incomplete(given, parameter, phi)
    row = [inputs["stratum"], given, inputs["parameter"], inputs["phi"]]
    return row + [text for value in leads for text in hi_lo(value)] + [decimal(c, 6) for c in conditions]


# ---------------------------------------------------------------------------------------------- files

FILES = {
    "jacobi.csv": (JACOBI, jacobi_row),
    "jacobi_special.csv": (SPECIAL, special_row),
    "complete.csv": (COMPLETE, complete_row),
    "incomplete.csv": (INCOMPLETE, incomplete_row),
}
