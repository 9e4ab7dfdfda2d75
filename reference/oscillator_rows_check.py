"""Checks vectors/oscillator_action.csv, oscillator_slopes.csv and oscillator_states.csv. Called by check.py.

Actions and Fourier coefficients: sums over a period of the motion by addition on an elliptic curve in balls (curve.py), where
there is no fifth power; with one, the action by that of u^2. Derivatives: central differences of the same motion. States: action
and phase of the start by samples of a Taylor series. Some rows are derived again; mutated rows must fail.
"""

from fractions import Fraction

import curve
import exact
import helmholtz_duffing_check as even
import mpmath as mp
import oscillator_action
import oscillator_slopes
import oscillator_states
from energy import middle
from exact import mpf, real
from flint import arb, ctx
from general_oscillator import PLACE, ScaledOrbit
from table import counted, fail

FILES = {
    # generator, rows compared by another method, rows derived again
    oscillator_action.NAME: (oscillator_action, 3, 1),
    oscillator_slopes.NAME: (oscillator_slopes, 3, 1),
    oscillator_states.NAME: (oscillator_states, 3, 1),
}
STIFF = ("quintic_near", "quintic_shallow", "quintic_disparate")
MOVING = ("libration", "well", "linear")


def numbers_of(row, names):
    return [Fraction(float.fromhex(row[name])) for name in names]


def ball(x):
    """A ball around a number of the file, which has 106 bits."""
    return curve.ball(x)


def number(row, name):
    hi, lo = (float.fromhex(row[f"{name}_{part}"]) for part in ("hi", "lo"))
    return mpf(hi) + mpf(lo)


def motion(numbers, t):
    """u and u', or u^2 and its rate where there is a fifth power, of (u0, velocity0, p, r, q, s, c) at t."""
    u0, v0, p, r, q, s, c = numbers
    if s == 0:
        return even.motion([u0, v0, p, r, q, c], t)
    return curve.motion((u0, v0), (p, q, s), t)


def kinetic(numbers, x):
    """u'^2 at u, or at u^2 where there is a fifth power."""
    u0, v0, p, r, q, s, c = numbers
    if s == 0:
        P = even.quartic([u0, v0, p, r, q, c])[0]
    else:
        P = [v0**2 + p * u0**2 + q * u0**4 / 2 + s * u0**6 / 3, -p, -q / 2, -s / 3]
    return sum(ball(g) * x**k for k, g in enumerate(P))


def sampled(numbers, first, period, number):
    """Midpoints of motion() at first + k period / number, and of u'^2 there."""
    bits = 500
    while bits < 1 << 14:
        with ctx.workprec(bits):
            times = [first + period * Fraction(k, number) for k in range(number)]
            states = [motion(numbers, t) if t else (ball(numbers[0] ** (2 if numbers[5] else 1)), None) for t in times]
            found = [state[0] if state else arb("nan") for state in states]
            squares = [kinetic(numbers, x) for x in found]
            if all(narrow(column) for column in (found, squares)):
                return [middle(x) for x in found], [middle(x) for x in squares]
        bits *= 2
    raise ArithmeticError("no precision makes the samples narrow")


def narrow(balls):
    largest = max((abs(x.mid()) for x in balls if x.is_finite()), default=arb(0))
    return all(x.is_finite() and x.rad() <= largest * arb(2) ** -120 for x in balls)


def action_wrong(row):
    """The columns of oscillator_action.csv that sums over the motion contradict."""
    *numbers, t = numbers_of(row, oscillator_action.INPUTS)
    with mp.workprec(400):
        rate, phase = number(row, "frequency"), number(row, "phase")
        T = 2 * mp.pi / rate
        first = exact.rational(-(phase - rate * real(t)) / rate)
        count = 256
        values, squares = sampled(numbers, first, exact.rational(T), count)
        found = []

        def compare(name, value, scale=0):
            told = number(row, name)
            if not mp.isnan(told) and abs(told - value) > max(abs(value), scale) * mpf(10) ** -22:
                found.append(name)

        compare("action", sum(squares) / count * T / (2 * mp.pi))
        if numbers[5] == 0:
            top = max(map(abs, values))
            compare("mean", sum(values) / count, top)
            amplitudes = [oscillator_action.coefficient(values, j) for j in range(1, 65)]
            for j in oscillator_action.HARMONICS:
                compare(f"amplitude_{j}", amplitudes[j - 1], amplitudes[0] * mpf(10) ** -10)
            rest = mp.sqrt(sum(a * a for a in amplitudes[1:])) / amplitudes[0]
            compare("distortion", rest, mpf(10) ** -10)
    return found


def steady(row):
    """Whether 256 samples are enough: the amplitudes fall fast."""
    if row["regime"] not in MOVING:
        return False
    first, *late = (abs(float.fromhex(row[f"amplitude_{j}_hi"])) for j in (1, 9, 10))
    return not any(x > 1e-4 * first for x in late)


def differences(numbers, k, step, t, bits):
    """motion() on both sides of input k and there."""
    with ctx.workprec(bits):
        return [motion([*numbers[:k], numbers[k] + side * step, *numbers[k + 1 :]], t) for side in (1, -1, 0)]


def slopes_wrong(row):
    """The derivatives of oscillator_slopes.csv that central differences contradict."""
    *numbers, t = numbers_of(row, oscillator_slopes.INPUTS)
    found = []
    if row["regime"] == "rest":
        return found
    whole = ScaledOrbit(tuple(numbers[:2]), dict(zip(oscillator_slopes.LETTERS, numbers[2:], strict=True)), [t])
    length, rate = Fraction(2) ** whole.length, Fraction(2) ** whole.rate
    units = {"u0": length, "velocity0": length * rate}
    units |= {x: length ** (1 - PLACE[x][0]) * rate**2 for x in oscillator_slopes.LETTERS}
    for k, x in enumerate(oscillator_slopes.BY):
        if row[f"du_d{x}"] == "nan":
            continue
        step = (abs(numbers[k]) or units[x]) / 2**200
        bits = 2200
        while None in (ends := differences(numbers, k, step, t, bits)):
            bits *= 2
        with ctx.workprec(bits):
            *ends, here = ends
            by = [(a - b) / ball(2 * step) for a, b in zip(*ends, strict=True)]
            if numbers[5] != 0:
                # u^2 is known: u = +-root, and du as its sign
                root = here[0].sqrt()
                by = [by[0] / (2 * root), by[1] / (2 * root) - here[1] * by[0] / (4 * root**3)]
            for name, value in zip(("u", "velocity"), by, strict=True):
                told = Fraction(row[f"d{name}_d{x}"])
                far = min(abs(value - ball(told)), abs(value + ball(told)) if numbers[5] != 0 else arb("inf"))
                if not far <= ball(abs(told)) * ball(Fraction(1, 10**20)) + ball(Fraction(1, 10**35)) * abs(value):
                    found.append(f"d{name}_d{x}")
    return found


def state_wrong(row):
    """Action and phase of the start by samples of a Taylor series."""
    p, r, q, s, c = numbers_of(row, oscillator_states.LETTERS)
    action, phase = numbers_of(row, ("action", "phase"))
    start = [sum(numbers_of(row, (f"{x}_hi", f"{x}_lo"))) for x in ("u0", "velocity0")]
    whole = ScaledOrbit(tuple(start), dict(zip(oscillator_states.LETTERS, (p, r, q, s, c), strict=True)), [])
    found = []
    with mp.workprec(400):
        # next to a separatrix a period has many times that of the poles
        count = 1024 if row["stratum"].startswith(STIFF) else 256
        samples = oscillator_action.Samples(whole.orbit, [], count, 2, 240)
        summed = sum(state[0][1] ** 2 for state in samples.states) / count * samples.T / (2 * mp.pi)
        summed *= whole.u_unit**2 / whole.t_unit
        if abs(summed - real(action)) > abs(real(action)) * mpf(10) ** -22:
            found.append("action")
        turns = (samples.start_phase - real(phase)) / (2 * mp.pi)
        if abs(turns - mp.nint(turns)) > mpf(10) ** (-14 if start[1] == 0 else -22):
            found.append("phase")
    return found


def check(name, every, rng):
    """Fails at the first row of a file that is not what it should be; says how many are."""
    module, size, repeated = FILES[name]
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != module.HEADER:
        fail(name, "columns differ from the generator's")
    if counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail("README.md lacks the line", counted(name, rows))
    if every:
        given = module.inputs()
        if [{key: row[key] for key in given[0]} for row in rows] != given:
            fail(name, "inputs are not what the generator draws")
    wrong = {oscillator_action.NAME: action_wrong, oscillator_slopes.NAME: slopes_wrong}.get(name, state_wrong)
    fit = [row for row in rows if name != oscillator_action.NAME or steady(row)]
    sample = fit if every else rng.sample(fit, size)
    again = rows if every else rng.sample(rows, repeated)
    for row in again:
        if [str(text) for text in module.row(row)] != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    for row in sample:
        if found := wrong(row):
            fail(name, "another method contradicts", found, row)
    row = next(row for row in fit if row["regime"] in MOVING)
    spoilt = {
        oscillator_action.NAME: ("action_lo", "action_hi"),
        oscillator_slopes.NAME: ("du_du0", "dvelocity_dvelocity0"),
        oscillator_states.NAME: ("u0_lo", "u0_hi"),
    }[name]
    if not wrong({**row, spoilt[0]: row[spoilt[1]]}):
        fail(name, "a mutated", spoilt[0], "passes")
    return f"{len(rows)} rows, {len(again)} derived again"
