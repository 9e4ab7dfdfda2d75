"""Reference values for one orbit of theta'' + omega2 sin(theta) = 0, with its six derivatives, by mpmath.

With r = theta0 - 2 pi n, s = sin(r/2), c = cos(r/2) >= 0, x = velocity0 / (2 omega):
  m = s^2 + x^2 (energy ratio),  mc = 1 - m = (c - x)(c + x),  tau0 = s R_F(x^2, m c^2, m)
  libration   u = tau0 + omega t           theta = 2 pi n + 2 atan2(k sn, dn)  velocity = 2 omega k cn
  rotation    u = sqrt(m) (tau0 + omega t) theta = 2 pi n +- 2 am(u | 1/m)     velocity = +-2 omega sqrt(m) dn
  separatrix  u = tau0 + omega t           theta = 2 pi n +- 2 atan(sinh u)    velocity = +-2 omega sech u
omega2 < 0 is the same pendulum seen from the other side: theta - pi obeys |omega2|. omega2 = 0 is free.
Source: DLMF 22.19.2-4, 19.25.5; derivatives from the two solutions of the linearised equation (Wronskian 2).
"""

import math
from fractions import Fraction

import mpmath as mp
from exact import agreed, decimal, hi_lo, mpf, real

BASE_DIGITS = 85
OUTPUTS = (
    "regime theta_hi theta_lo velocity_hi velocity_lo period_hi period_lo "
    "energy_ratio_hi energy_ratio_lo energy_ratio_c_hi energy_ratio_c_lo "
    "cond_theta cond_velocity cond_period "
    "dtheta_dtheta0 dtheta_dvelocity0 dtheta_domega2 "
    "dvelocity_dtheta0 dvelocity_dvelocity0 dvelocity_domega2 "
    "theta_max_hi theta_max_lo energy_hi energy_lo"
).split()


def jacobi_reduced(u, m):
    """sn, cn, dn, unwrapped am and epsilon(u) = integral of dn^2, for 0 < m < 1."""
    K, E = mp.ellipk(m), mp.ellipe(m)
    j = mp.nint(u / (2 * K))
    v = u - 2 * K * j
    sn, cn, dn = (mp.ellipfun(name, v, m=m).real for name in ("sn", "cn", "dn"))
    am = mp.atan2(sn, cn)
    epsilon = sn * mp.elliprf(cn * cn, dn * dn, 1)
    if sn != 0:
        epsilon -= m * sn**3 / 3 * mp.elliprd(cn * cn, dn * dn, 1)
    if int(j) % 2:
        sn, cn = -sn, -cn
    return sn, cn, dn, am + mp.pi * j, epsilon + 2 * E * j


def canonical(tau, m, mc):
    """The orbit of Theta'' = -sin(Theta) that passes 0 upwards at tau = 0.

    Returns Theta, its tau derivatives Theta_t, Theta_tt, and the derivatives Theta_m, Theta_mt."""
    if mc > 0:
        sn, cn, dn, _, epsilon = jacobi_reduced(tau, m)
        k = mp.sqrt(m)
        g = mc * tau - epsilon
        by_m = (sn * dn + cn * g) / (k * mc)
        by_mt = (cn * dn * dn - m * sn * sn * cn - sn * dn * g + cn * (mc - dn * dn)) / (k * mc)
        return 2 * mp.atan2(k * sn, dn), 2 * k * cn, -2 * k * sn * dn, by_m, by_mt
    if mc < 0:
        p, root = 1 / m, mp.sqrt(m)
        sn, cn, dn, am, epsilon = jacobi_reduced(root * tau, p)
        f = -1 / mc
        by_m = f * (epsilon * dn - p * sn * cn)
        by_mt = root * f * (dn**3 - p * epsilon * sn * cn - p * (cn * cn - sn * sn) * dn)
        return 2 * am, 2 * root * dn, -2 * sn * cn, by_m, by_mt
    ch, sh = mp.cosh(tau), mp.sinh(tau)
    by_m = (sh + tau / ch) / 2
    by_mt = (ch + 1 / ch - tau * sh / ch**2) / 2
    return 2 * mp.atan(sh), 2 / ch, -2 * sh / ch**2, by_m, by_mt


def start(theta0, velocity0, omega2):
    """regime, turns n, omega, s, c, x, m, mc of an orbit with omega2 != 0, at the working precision."""
    angle = real(theta0)
    omega = mp.sqrt(real(abs(omega2)))
    x = real(velocity0) / (2 * omega)
    if omega2 > 0:
        n = mp.nint(angle / (2 * mp.pi))
        s, c = mp.sin(angle / 2), mp.cos(angle / 2)
    else:
        n = mp.nint((angle - mp.pi) / (2 * mp.pi))
        s, c = -mp.cos(angle / 2), mp.sin(angle / 2)
    if int(n) % 2:
        s, c = -s, -c
    m = s * s + x * x
    mc = (c - x) * (c + x)
    # theta0 != 0 is algebraic, so c is transcendental and mc != 0 (Lindemann); theta0 = 0 is rational
    if theta0 == 0 and omega2 > 0:
        mc = real(1 - velocity0**2 / (4 * omega2))
    regime = "rest" if m == 0 else "libration" if mc > 0 else "rotation" if mc < 0 else "separatrix"
    return regime, n, omega, s, c, x, m, mc


def period(regime, omega, m, mc):
    """Libration: there and back; rotation: one turn; separatrix: inf; rest: the limit of small swings."""
    if regime == "separatrix":
        return mp.inf
    if regime == "rest":
        return 2 * mp.pi / omega
    if mc > 0:
        return 4 * mp.elliprf(0, mc, 1) / omega
    return 2 * mp.elliprf(0, -mc / m, 1) / (omega * mp.sqrt(m))


def period_condition(theta0, velocity0, regime, omega, m, mc, T):
    """sum |x_i dT/dx_i| over theta0, velocity0, omega2; 0 where the period is infinite."""
    if regime == "separatrix":
        return mpf(0)
    if regime == "rest":
        return T / 2
    if mc > 0:
        slope = mpf(2) / 3 * mp.elliprd(0, 1, mc)
    else:
        p = 1 / m
        slope = -(p**1.5) * mp.elliprf(0, -mc / m, 1) - p**2.5 * mp.elliprd(0, 1, -mc / m) / 3
    angle, v = real(theta0), real(velocity0)
    ratio = v * v / (4 * omega * omega)
    return (
        abs(angle * slope * mp.sin(angle) / 2) + abs(2 * ratio * slope) + abs(ratio * slope + T * omega / 2)
    ) / omega


def free(theta0, velocity0, t):
    """omega2 = 0: uniform rotation, or rest; derivatives from theta'' = -omega2 sin(theta) to first order."""
    angle, v, time = real(theta0), real(velocity0), real(t)
    theta = angle + v * time
    if v == 0:
        slopes = [-(time**2) / 2 * mp.sin(angle), -time * mp.sin(angle)]
        leads = [theta, v, mp.inf, mpf(0), mpf(1), mpf(0), mpf(0)]
    else:
        slopes = [
            (mp.sin(theta) - mp.sin(angle)) / v**2 - time * mp.cos(angle) / v,
            (mp.cos(theta) - mp.cos(angle)) / v,
        ]
        leads = [theta, v, 2 * mp.pi / abs(v), mp.inf, -mp.inf, mp.nan, v * v / 2]
    D = [mpf(1), time, slopes[0], mpf(0), mpf(1), slopes[1]]
    condition = mpf(0) if v == 0 else leads[2]
    return "rest" if v == 0 else "rotation", leads, [*D, condition]


def evaluate(theta0, velocity0, omega2, t):
    """regime; theta, velocity, period, m, mc, theta_max, energy; six derivatives and cond_period."""
    if omega2 == 0:
        return free(theta0, velocity0, t)
    regime, n, omega, s, c, x, m, mc = start(theta0, velocity0, omega2)
    angle, v, time = real(theta0), real(velocity0), real(t)
    T = period(regime, omega, m, mc)
    theta_max = {"rest": mpf(0), "separatrix": +mp.pi, "rotation": mp.nan}.get(regime)
    if theta_max is None:
        theta_max = 2 * mp.asin(mp.sqrt(m)) if m < 0.5 else mp.pi - 2 * mp.asin(mp.sqrt(mc))
    orbit = [T, m, mc, theta_max, 2 * omega * omega * m]
    condition = period_condition(theta0, velocity0, regime, omega, m, mc, T)
    still = [mpf(1), mpf(0), mpf(0), mpf(0), mpf(1), mpf(0)]
    if t == 0:
        return regime, [angle, v, *orbit], [*still, condition]
    if x == 0 and (s == 0 or c == 0):
        # equilibrium: hanging (cos, sin), or upright (cosh, sinh), which only omega2 < 0 reaches exactly
        cos, sin = (mp.cos, mp.sin) if s == 0 else (mp.cosh, mp.sinh)
        sign = -1 if s == 0 else 1
        y, z = cos(omega * time), sin(omega * time)
        D = [y, z / omega, mpf(0), sign * omega * z, y, mpf(0)]
        return regime, [angle, v, *orbit], [*D, condition]
    arc = s * mp.elliprf(x * x, m * c * c, m)
    side = -1 if x < 0 else 1
    if regime == "libration":
        tau0, flip = arc, 1
        if x < 0:
            tau0 = (mp.sign(s) or 1) * 2 * mp.elliprf(0, mc, 1) - arc
    else:
        tau0, flip = side * arc, side
    # whole periods do not change theta but do change Theta_m: tau stays unreduced
    A = canonical(tau0, m, mc)
    B = canonical(tau0 + omega * time, m, mc)
    theta = 2 * mp.pi * n + flip * B[0] + (mp.pi if omega2 < 0 else 0)
    velocity = flip * omega * B[1]
    y1, y1t = (B[1] * A[4] - B[3] * A[2]) / 2, (B[2] * A[4] - B[4] * A[2]) / 2
    y2, y2t = (A[1] * B[3] - A[3] * B[1]) / 2, (A[1] * B[4] - A[3] * B[2]) / 2
    acceleration = -real(omega2) * mp.sin(theta)
    by_velocity0, velocity_by_velocity0 = y2 / omega, y2t
    # dimension: omega d/domega = t d/dt - velocity0 d/dvelocity0
    by_omega = time * velocity - v * by_velocity0
    velocity_by_omega = velocity + time * acceleration - v * velocity_by_velocity0
    twice = 2 * real(omega2)
    D = [y1, by_velocity0, by_omega / twice, omega * y1t, velocity_by_velocity0, velocity_by_omega / twice]
    return regime, [theta, velocity, *orbit], [*D, condition]


def first_digits(theta0, velocity0, omega2, t):
    """A precision that nearly always passes the two-precision check at once."""
    if omega2 == 0:
        return BASE_DIGITS
    with mp.workdps(80):
        _, _, omega, _, _, x, _, mc = start(theta0, velocity0, omega2)
        extra = int(max(0, -mp.log10(abs(mc)))) if mc != 0 else 0
        phase = abs(omega * real(t))
        extra += int(mp.log10(1 + phase * (1 + abs(x))))
        extra += int(mp.log10(1 + abs(real(theta0))))
        if 0 < phase < 1:  # derivatives start like t, t^2, t^3
            extra -= int(2 * mp.log10(phase))
    return BASE_DIGITS + 2 * extra


def outputs(theta0, velocity0, omega2, t):
    """The OUTPUTS columns of one row; the inputs are doubles and omega2 a Fraction."""
    given = [Fraction(theta0), Fraction(velocity0), omega2, Fraction(t)]
    regime, leads, others = agreed(lambda: evaluate(*given), first_digits(*given))
    theta, velocity, T, m, mc, theta_max, energy = leads
    *D, condition = others
    with mp.workdps(60):
        inputs = [real(f) for f in given]
        acceleration = -inputs[2] * mp.sin(theta)
        conditions = [
            sum(abs(a * b) for a, b in zip(inputs, [*slopes, last], strict=True))
            for slopes, last in ((D[:3], +velocity), (D[3:], acceleration))
        ]
        row = [regime, *hi_lo(theta), *hi_lo(velocity), *hi_lo(T), *hi_lo(m), *hi_lo(mc)]
        row += [decimal(value, 6) for value in (*conditions, condition)]
        row += [decimal(+d, 25) for d in D]
        return [*row, *hi_lo(theta_max), *hi_lo(energy)]


def rough_period(theta0, velocity0, omega2):
    """A period good enough to choose instants; 40/omega where it is infinite."""
    with mp.workdps(60 + int(math.log10(1 + abs(theta0)))):
        if omega2 == 0:
            return 2 * mp.pi / abs(velocity0) if velocity0 else mpf(1)
        regime, _, omega, _, _, _, m, mc = start(Fraction(theta0), Fraction(velocity0), omega2)
        return 40 / omega if regime == "separatrix" else period(regime, omega, m, mc)
