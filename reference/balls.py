"""The same values in Arb ball arithmetic (python-flint), by other formulas.

Jacobi: theta quotients (DLMF 22.2.4-6) with the nome of the parameter itself, negative for m < 0.
Integrals: Arb's own. Pendulum: the addition theorem, sin and cos of theta/2 from sn, cn, dn of omega t. A row passes
if hi + lo is within 2^-104 of the ball. The precision doubles until the ball is narrower than that.
"""

import math
from fractions import Fraction

from elliptic import parameters
from flint import acb, arb, ctx, fmpq


def ball(x):
    """A double or a rational as a ball."""
    f = Fraction(x)
    return arb(fmpq(f.numerator, f.denominator))


def nint(x):
    """The integer nearest to the ball, any of the two where it straddles a half."""
    integer = (x.mid() + arb(0.5)).floor().unique_fmpz()
    if integer is None:
        raise ArithmeticError("the ball is too wide for an integer")
    return arb(integer)


def jacobi(u, m, mc):
    """sn, cn, dn, am for balls m > 0 or m < 0, mc != 0, mc given on its own."""
    if mc < 0:
        root = m.sqrt()
        sn, dn, cn, _ = jacobi(u * root, 1 / m, -mc / m)
        sn = sn / root
        return sn, cn, dn, acb(cn, sn).arg()
    K = arb.pi() / 2 / arb(1).agm(mc.sqrt())
    if m < 0:
        tau = acb(1, arb(1).agm((1 / mc).sqrt()) / arb(1).agm((-m / mc).sqrt()))
    else:
        tau = acb(0, arb(1).agm(mc.sqrt()) / arb(1).agm(m.sqrt()))
    z = u / (2 * K)
    turns = nint(z)
    _, t2, t3, t4 = acb(0).modular_theta(tau)
    a1, a2, a3, a4 = acb(z - turns).modular_theta(tau)
    sn, cn, dn = ((t3 / t2 * a1 / a4).real, (t4 / t2 * a2 / a4).real, (t4 / t3 * a3 / a4).real)
    am = acb(cn, sn).arg() + arb.pi() * turns
    return (-sn, -cn, dn, am) if int(turns.unique_fmpz()) % 2 else (sn, cn, dn, am)


def jacobi_values(given, parameter, u):
    m, mc = parameters(given, parameter)
    u = ball(u)
    if m == 0:
        values = u.sin(), u.cos(), arb(1), u
    elif m == 1:
        values = u.tanh(), u.sech(), u.sech(), u.sinh().atan()
    else:
        values = jacobi(u, ball(m), ball(mc))
    return dict(zip(("sn", "cn", "dn", "am"), values, strict=True))


def complete_values(given, parameter):
    m, mc = parameters(given, parameter)
    if m >= 1:
        return {"complete_e": arb(1), "nome": arb(1)} if m == 1 else {}
    p = acb(ball(m))
    nome = (-acb.pi() * acb(ball(mc)).elliptic_k() / p.elliptic_k()).exp() if m else acb(0)
    if not nome.imag.contains(0):
        raise SystemExit(f"complex nome at {given} = {parameter}")
    return {"complete_k": p.elliptic_k().real, "complete_e": p.elliptic_e().real, "nome": nome.real}


def incomplete_values(given, parameter, phi):
    m, _ = parameters(given, parameter)
    x = ball(phi)
    if m > 1 and abs(x) > (1 / ball(m).sqrt()).asin():
        return {}
    if m == 1:
        turns = nint(x / arb.pi())
        values = {"incomplete_e": 2 * turns + x.sin() * (-1) ** int(turns.unique_fmpz())}
        return values if turns != 0 else {**values, "incomplete_f": x.tan().asinh()}
    p = acb(ball(m))
    return {"incomplete_f": acb.elliptic_f(x, p).real, "incomplete_e": acb.elliptic_e_inc(x, p).real}


def pendulum_values(theta0, velocity0, omega2, t):
    """The state after the time t, for rational inputs; equilibria, free rotation and the exact separatrix separately."""
    angle, v, time = ball(theta0), ball(velocity0), ball(t)
    if omega2 == 0:
        values = {"theta": angle + v * time, "velocity": v, "energy": v * v / 2}
        return {**values, "period": 2 * arb.pi() / abs(v)} if velocity0 else values
    omega = ball(abs(omega2)).sqrt()
    s, c, origin = (angle / 2).sin(), (angle / 2).cos(), arb(0)
    if omega2 < 0:
        s, c, origin = -c, s, arb.pi()
    x = v / (2 * omega)
    m, mc, u, drift = s * s + x * x, (c - x) * (c + x), omega * time, arb(0)
    values = {"energy_ratio": m, "energy": 2 * omega * omega * m}
    if theta0 == 0 and velocity0 == 0:
        return {**values, "theta": angle, "velocity": v}
    if theta0 == 0 and velocity0**2 == 4 * omega2:
        sn, cn, dn = u.tanh(), u.sech(), u.sech()
    else:
        sn, cn, dn, _ = jacobi(u, m, mc)
        values["energy_ratio_c"] = mc
        if mc > 0:
            values["period"] = 2 * arb.pi() / (omega * arb(1).agm(mc.sqrt()))
            values["theta_max"] = 2 * acb(mc.sqrt(), m.sqrt()).arg()
        elif mc < 0:
            values["period"] = arb.pi() / (omega * m.sqrt().agm((-mc).sqrt()))
            drift = 2 * arb.pi() * time / values["period"] * (1 if velocity0 > 0 else -1)
        else:
            raise ArithmeticError("the ball is too wide for the regime")
    D = cn * cn + (c * sn) ** 2
    half = acb(c * dn - s * x * sn * cn, s * cn * dn + c * x * sn).arg()
    turns = nint((angle - origin + drift - 2 * half) / (4 * arb.pi()))
    theta = origin + 2 * half + 4 * arb.pi() * turns
    return {**values, "theta": theta, "velocity": 2 * omega * (x * cn - s * c * sn * dn) / D}


FIELDS = {
    "jacobi.csv": ["parameter", "u"],
    "complete.csv": ["parameter"],
    "incomplete.csv": ["parameter", "phi"],
    "pendulum.csv": ["theta0", "velocity0", "omega2", "t"],
    "pendulum_corners.csv": ["theta0", "velocity0", "omega2_a", "omega2_b", "omega2_c", "t"],
}


def arguments(name, row):
    """The inputs of a row as the arguments of its formula, rational; None where one is not finite."""
    fields = FIELDS[name]
    numbers = [float.fromhex(row[field]) for field in fields]
    if not all(map(math.isfinite, numbers)):
        return None
    numbers = [Fraction(x) for x in numbers]
    if len(numbers) == 6:
        numbers[2:5] = [numbers[2] * numbers[3] / numbers[4]]
    return numbers if "theta0" in fields else [row["given"], *numbers]


VALUES = {
    "jacobi.csv": jacobi_values,
    "complete.csv": complete_values,
    "incomplete.csv": incomplete_values,
    "pendulum.csv": pendulum_values,
    "pendulum_corners.csv": pendulum_values,
}


def narrow(x):
    return x.is_finite() and x.rad() <= abs(x.mid()) * arb(2) ** -112 + arb(2) ** -1085


def narrowed(evaluate, first=300):
    """Values as narrow balls: the precision doubles until they are."""
    ctx.prec = first
    while ctx.prec < 400_000:
        try:
            values = evaluate()
            if all(narrow(x) for x in values.values()):
                return values
        except ArithmeticError:
            pass  # a ball too wide to decide a sign or an integer
        ctx.prec *= 2
    raise ArithmeticError("no precision is enough")


def close(x, hi, lo):
    """Certainly within 2^-104 of hi + lo, or within the last subnormal bits."""
    return abs(x - hi - lo) <= abs(hi) * arb(2) ** -104 + arb(2) ** -1073


def unexplained(row, values):
    """Finite outputs of a row where the formula has none."""
    outputs = [column[:-3] for column in row if column.endswith("_hi")]
    return [x for x in outputs if x not in values and math.isfinite(float.fromhex(row[f"{x}_hi"]))]


def wrong(name, row):
    """The outputs of a row that a ball contradicts."""
    inputs = arguments(name, row)
    if inputs is None:
        return []
    values = narrowed(lambda: VALUES[name](*inputs))
    found = [] if "theta0" in row else unexplained(row, values)
    for output, x in values.items():
        hi, lo = (float.fromhex(row[f"{output}_{part}"]) for part in ("hi", "lo"))
        if not (math.isfinite(hi) and close(x, ball(hi), ball(lo))):
            found.append(output)
    return found
