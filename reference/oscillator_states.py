"""Writes vectors/oscillator_states.csv: the start (u0, velocity0) of an action and a phase, the way back from oscillator_action.py.

The energy comes from Newton's method on the action's quadrature (potential.py), the start from a Taylor series from the highest
u on (force_taylor.py). (`near`, `near_velocity`) is a state next to the motion meant: one action may belong to several wells.
Run: python oscillator_states.py
"""

from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction

import exact
import mpmath as mp
import oscillator_action_inputs
from energy import narrow
from exact import agreement, decimal, hi_lo, mpf, rational, real
from force_taylor import ForceSweep
from general_oscillator import PLACE, ScaledOrbit, columns_of, total
from potential import PotentialOrbit

NAME = "oscillator_states.csv"
LETTERS = "prqsc"
INPUTS = ["action", "phase", *LETTERS, "near", "near_velocity"]
OUTPUTS = ("u0", "velocity0", "energy")
HEADER = ["id", "stratum", *INPUTS, "regime", *(f"{x}_{part}" for x in OUTPUTS for part in ("hi", "lo"))]
HEADER += ["cond_u0", "cond_velocity0"]


def twice_potential(force, u):
    return sum(2 * f * u ** (k + 1) / (k + 1) for k, f in enumerate(force))


def of_action(action, force, near, guess):
    """The orbit with this action whose range holds near, from a guess of 2E: rationals."""
    twice, gap = guess, None
    for _ in range(60):
        orbit = PotentialOrbit.of_energy(twice, force, near)
        with mp.workprec(500):
            miss = orbit.action(300) - real(action)
            if abs(miss) < abs(real(action)) * mpf(2) ** -280 or miss == gap:
                return orbit
            gap = miss
            step = miss * 4 * mp.pi / orbit.period(300)
            twice = rational(real(twice) - step)
    raise ArithmeticError("no energy has this action")


def state(orbit, part, letters, pace, bits):
    """u, u' at the part of a period after the highest u, and their derivatives by action, phase and the letters."""
    T, top = orbit.period(bits), narrow(orbit.upper.u, bits)
    rate = 2 * mp.pi / T
    pull = -sum(real(f) * top**k for k, f in enumerate(orbit.force))
    by = [(-rate / pull, 0, [0] * 6)]
    for letter, (_, _, forced) in zip(letters, columns_of(letters)[2:], strict=True):
        power, side = PLACE[letter]
        by_energy = side * orbit.mean_power(power + 1, bits // 2) / (power + 1)
        by.append((-(by_energy - side * top ** (power + 1) / (power + 1)) / pull, 0, forced))
    time = part * T
    run = ForceSweep((top, mpf(0)), orbit.force, by, False, pace, bits).run(sorted((time, T)))
    (u, v), *columns = run[0] if time < T else run[1]
    (u1, v1), *closed = run[1]
    if max(abs(u1 - top), abs(v1)) > mpf(2) ** (-3 * bits // 5):
        raise ArithmeticError("the integration does not return after the period of the quadrature")
    force = -sum(real(f) * u**k for k, f in enumerate(orbit.force))
    found = []
    for (du, dv), (_, dv1) in zip(columns, closed, strict=True):
        later = part * -dv1 / pull
        found.append((du + v * later, dv + force * later))
    found.insert(1, (v / rate, force / rate))
    return u, v, found


def row(inputs):
    """One row of the file from its input columns."""
    given = {name: float.fromhex(inputs[name]) for name in INPUTS}
    coefficients = {letter: given[letter] for letter in LETTERS}
    action, phase, near = (Fraction(given[name]) for name in ("action", "phase", "near"))
    whole = ScaledOrbit((near, Fraction(given["near_velocity"])), coefficients, [])
    letters = [letter for letter, x in whole.coefficients.items() if x]
    with mp.workprec(500):
        unit, second = whole.u_unit, whole.t_unit
        joule = unit**2 / second
        force = whole.force
        guess = whole.start[1] ** 2 + twice_potential(force, whole.start[0])
        orbit = of_action(rational(real(action) / joule), force, near / rational(unit), guess)
        turns = real(phase) / (2 * mp.pi)
        part = turns - mp.floor(turns)
        bits = 220
        while True:
            ways = [state(orbit, part, letters, pace, bits + more) for pace, more in ((2.2, 0), (1.8, 50))]
            if all(agreement(a, b) < mpf(10) ** -40 for a, b in zip(ways[0][:2], ways[1][:2], strict=True)) or not part:
                break
            bits += bits // 2
            if bits > 2000:
                raise ArithmeticError("two precisions do not agree")
        u, v, slopes = ways[1]
        v = v if part else mpf(0)
        numbers = [real(action) / joule, real(phase), *(real(whole.coefficients[x]) for x in letters)]
        conds = [total(numbers, [d[k] for d in slopes]) for k in (0, 1)]
        texts = [*hi_lo(u * unit), *hi_lo(v * unit / second), *hi_lo(real(orbit.P[0]) / 2 * (unit / second) ** 2)]
        texts += [decimal(conds[0] * unit, 6), decimal(conds[1] * unit / second, 6)]
    return [*(inputs[name] for name in ("id", "stratum", *INPUTS)), orbit.regime, *texts]


def inputs():
    return oscillator_action_inputs.state_rows("of", INPUTS)


def all_rows(inputs):
    with ProcessPoolExecutor() as pool:
        yield from pool.map(row, inputs)


if __name__ == "__main__":
    exact.write(NAME, HEADER, all_rows(inputs()))
