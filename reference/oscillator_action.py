"""Writes vectors/oscillator_action.csv: action, frequency, phase and Fourier coefficients of u'' + p u + r u^2 + q u^3 + s u^5 = c.

The action is the integral of u' du over a period, by 2 pi. The phase is 0 at the highest u and grows with time; its value at
t = 0 lies in (-pi, pi]. u = mean + the sum of amplitude_j cos(j phase); `distortion` is the root of the sum of amplitude_j^2
over j >= 2, over abs(amplitude_1). Actions and times are quadratures (potential.py), the coefficients sums over samples of
Taylor series (force_taylor.py), which converge geometrically. Run: python oscillator_action.py
"""

from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
from functools import lru_cache

import exact
import mpmath as mp
import oscillator_action_inputs
from exact import agreement, decimal, hi_lo, mpf, real
from force_taylor import ForceSweep
from general_oscillator import PLACE, ScaledOrbit, columns_of, rest_period_slopes, total

NAME = "oscillator_action.csv"
LETTERS = "prqsc"
INPUTS = ["u0", "velocity0", *LETTERS, "t"]
HARMONICS = (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 24)
OUTPUTS = ["action", "frequency", "phase", "mean", *(f"amplitude_{j}" for j in HARMONICS), "distortion"]
# amplitudes below this share of the first are left out
SMALL = mpf(10) ** -60
HEADER = ["id", "stratum", *INPUTS, "regime", *(f"{name}_{part}" for name in OUTPUTS for part in ("hi", "lo"))]
HEADER += [f"cond_{name}" for name in OUTPUTS]


class Samples:
    """u and u' at `number` times over a period of a scaled orbit, from the highest u on, with columns."""

    def __init__(self, orbit, by, number, pace, bits):
        self.orbit, self.by, self.number = orbit, by, number
        T, gap = orbit.period(bits), orbit.since_top(bits)
        ahead = gap if orbit.v0 > 0 or gap == 0 else T - gap
        self.T, self.ahead = T, ahead
        self.start_phase = -2 * mp.pi * ahead / T if orbit.v0 > 0 else 2 * mp.pi * gap / T
        targets = [ahead + j * T / number for j in range(number)]
        places = sorted([(t, j) for j, t in enumerate(targets)] + [(T, -1)])
        run = ForceSweep((orbit.u0, orbit.v0), orbit.force, by, False, pace, bits).run([t for t, _ in places])
        states = {j: state for (_, j), state in zip(places, run, strict=True)}
        (u, v), *columns = states.pop(-1)
        room = mpf(2) ** (-3 * bits // 5)
        top = states[0][0]
        if max(abs(u - real(orbit.u0)), abs(v - real(orbit.v0)), abs(top[1])) > room:
            raise ArithmeticError("the integration does not return after the period of the quadrature")
        a0, v0 = real(orbit.acceleration), real(orbit.v0)
        self.by_period = [
            (du0 - du) / v0 if abs(v0) > abs(a0) else (dv0 - dv) / a0
            for (du, dv), (du0, dv0, _) in zip(columns, by, strict=True)
        ]
        self.states = [states[j] for j in range(number)]
        if any(abs(self.states[j][0][0] - self.states[-j][0][0]) > room for j in range(1, number // 2)):
            raise ArithmeticError("the motion is not symmetric about its highest point")
        pull = -sum(real(f) * top[0] ** k for k, f in enumerate(orbit.force) if f)
        self.by_top = [-dv / pull for _, dv in self.states[0][1:]]

    def values(self):
        return [state[0][0] for state in self.states]

    def moved(self, k):
        """Derivatives of u at fixed phase by the input k."""
        found = []
        for j, state in enumerate(self.states):
            later = self.by_top[k] + self.by_period[k] * j / self.number
            found.append(state[k + 1][0] + state[0][1] * later)
        return found


@lru_cache(maxsize=8)
def cosines(number, precision):
    """cos(2 pi k / number) at the working precision."""
    return [mp.cos(2 * mp.pi * k / number) for k in range(number)]


def coefficient(values, j):
    number = len(values)
    known = cosines(number, mp.mp.prec)
    return sum(u * known[j * k % number] for k, u in enumerate(values)) * (2 if j else 1) / number


def without_first(values, mean, first):
    known = cosines(len(values), mp.mp.prec)
    return [u - mean - first * c for u, c in zip(values, known, strict=True)]


def series(values, vanishing, centre):
    """mean, amplitudes and distortion of samples from the highest point on; what vanishes is exactly 0, what is too small NaN."""
    mean = sum(values) / len(values) if centre is None else centre
    found = [mpf(0) if vanishing(j) else coefficient(values, j) for j in HARMONICS]
    if vanishing(3):
        return [mean, *found, mpf(0)]
    rest = mp.sqrt(2 * sum(w * w for w in without_first(values, mean, found[0])) / len(values)) / found[0]
    return [mean, *(mp.nan if a and abs(a) < SMALL * found[0] else a for a in found), rest if rest > SMALL else mp.nan]


def by_series(values, moved, lead):
    """Derivatives of series() by one input."""
    mean, first, rest = lead[0], lead[1], lead[-1]
    by_mean = sum(moved) / len(moved)
    found = [coefficient(moved, j) if a == a else mpf(0) for j, a in zip(HARMONICS, lead[1:-1], strict=True)]
    if not rest > 0:
        return [by_mean, *found, mpf(0)]
    left = without_first(values, mean, first)
    by_power = 2 * sum(w * d for w, d in zip(left, moved, strict=True)) / len(values)
    return [by_mean, *found, by_power / (rest * first**2) - rest * found[0] / first]


def enough(values):
    """Whether the coefficients past half the number of samples hide nothing of the last harmonic asked for."""
    number, last = len(values), HARMONICS[-1]
    largest = max(abs(coefficient(values, number // 2 - k)) for k in (0, 1, 2, 3))
    size = abs(coefficient(values, 1))
    if largest == 0:
        return True
    return mp.log10(largest / size) * (number - 2 * last) / (number / 2) < -42


def vanishing_of(orbit):
    if orbit.linear:
        return lambda j: j > 1
    return (lambda j: j % 2 == 0) if orbit.centre() is not None else (lambda j: False)


def periodic(whole, letters):
    """Fine samples with their series; derivatives of the series by every input; samples with columns, and those of the phase."""
    orbit = whole.orbit
    vanishing, centre = vanishing_of(orbit), orbit.centre()
    number, bits = 128, 360
    while bits < 3000:
        with mp.workprec(bits + 150):
            middle = None if centre is None else real(centre)
            rough = Samples(orbit, [], number, 2.2, bits)
            if not enough(rough.values()):
                number *= 2
                continue
            fine = Samples(orbit, [], number, 1.8, bits + 50)
            leads = [series(samples.values(), vanishing, middle) for samples in (rough, fine)]
            same = all(agreement(a, b) < mpf(10) ** -36 for a, b in zip(*leads, strict=True))
            if not same or agreement(rough.start_phase, fine.start_phase) > mpf(10) ** -50:
                bits += bits // 2
                continue
            moved = Samples(orbit, columns_of(letters), number, 1.9, bits - 100)
            values = moved.values()
            slopes = [by_series(values, moved.moved(k), leads[1]) for k in range(2 + len(letters))]
            T = moved.T
            by_phase = [
                -2 * mp.pi * (d / T - moved.ahead * dT / T**2)
                for d, dT in zip(moved.by_top, moved.by_period, strict=True)
            ]
            return fine, leads[1], slopes, moved, by_phase
    raise ArithmeticError("two precisions do not agree")


def outputs(u0, velocity0, coefficients, t):
    """regime, the OUTPUTS and their conditions; all inputs are doubles, coefficients by their letters."""
    start = Fraction(u0), Fraction(velocity0)
    whole = ScaledOrbit(start, coefficients, [Fraction(t)])
    orbit = whole.orbit
    letters = [letter for letter, x in whole.coefficients.items() if x]
    inputs = [real(orbit.u0), real(orbit.v0), *(real(whole.coefficients[letter]) for letter in letters)]
    unit, second = whole.u_unit, whole.t_unit
    time = real(Fraction(t)) / second
    count = len(HARMONICS)
    none = [mpf(0)] * len(OUTPUTS)
    action = orbit.action(200) * unit**2 / second
    if orbit.regime == "rest":
        T = orbit.period(200)
        rate = 2 * mp.pi / T if mp.isfinite(T) else mpf(0)
        leads = [mpf(0), rate / second, rate * time, real(start[0]), *[mpf(0)] * (count + 1)]
        slopes = rest_period_slopes(orbit, T, letters) if rate else []
        by_rate = total(inputs, slopes) / T * rate if rate else mpf(0)
        conds = [mpf(0), by_rate / second, abs(time) * (rate + by_rate), abs(leads[3]), *[mpf(0)] * (count + 1)]
        return orbit.regime, leads, conds
    if not orbit.periodic():
        return orbit.regime, [action, mpf(0), mp.nan, *[mp.nan] * (count + 2)], none
    fine, lead, slopes, moved, by_phase = periodic(whole, letters)
    T = fine.T
    rate = 2 * mp.pi / T
    # J = (the integral of u'^2 dt) / 2 pi
    summed = sum(state[0][1] ** 2 for state in fine.states) / fine.number * T / (2 * mp.pi)
    if agreement(summed, orbit.action(200)) > mpf(10) ** -36:
        raise ArithmeticError("the action of the samples is not that of the quadrature")
    by_rate = [-rate * d / T for d in moved.by_period]
    # dJ = (dE - <dV at fixed u>) / frequency
    mean_powers = {letter: mean_power(moved, PLACE[letter][0] + 1) for letter in letters}
    by_energy = [-real(orbit.acceleration), real(orbit.v0)]
    for letter in letters:
        power, side = PLACE[letter]
        by_energy.append(side * (real(orbit.u0) ** (power + 1) - mean_powers[letter]) / (power + 1))
    by_action = [d / rate for d in by_energy]
    leads = [action, rate / second, fine.start_phase + rate * time, lead[0] * unit]
    leads += [x * unit for x in lead[1:-1]] + [lead[-1]]
    phase_slopes = [a + time * b for a, b in zip(by_phase, by_rate, strict=True)]
    conds = [total(inputs, by_action) * unit**2 / second, total(inputs, by_rate) / second]
    conds.append(total(inputs, phase_slopes) + abs(time * rate))
    columns = [total(inputs, column) for column in zip(*slopes, strict=True)]
    conds += [x * unit for x in columns[:-1]] + [columns[-1]]
    return orbit.regime, leads, conds


def mean_power(samples, power):
    return sum(u**power for u in samples.values()) / samples.number


def row(inputs):
    """One row of the file from its input columns."""
    given = {name: float.fromhex(inputs[name]) for name in INPUTS}
    with mp.workprec(500):
        coefficients = {letter: given[letter] for letter in LETTERS}
        regime, leads, conds = outputs(given["u0"], given["velocity0"], coefficients, given["t"])
        pairs = [word for lead in leads for word in hi_lo(lead)]
        kept = [inputs[name] for name in ("id", "stratum", *INPUTS)]
        return [*kept, regime, *pairs, *(decimal(x, 6) for x in conds)]


def inputs():
    return oscillator_action_inputs.rows("oa", INPUTS)


def all_rows(inputs):
    with ProcessPoolExecutor() as pool:
        yield from pool.map(row, inputs)


if __name__ == "__main__":
    exact.write(NAME, HEADER, all_rows(inputs()))
