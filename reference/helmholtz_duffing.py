"""Writes vectors/helmholtz_duffing.csv: the exact motion u'' + p u + r u^2 + q u^3 = c by Taylor series.

Run: python helmholtz_duffing.py
"""

from concurrent.futures import ProcessPoolExecutor
from itertools import groupby

import double_roots
import exact
import general_oscillator
import helmholtz_duffing_inputs as starts
import mpmath as mp
from oscillator_inputs import Draw, first, numbered, product

NAME = "helmholtz_duffing.csv"
INPUTS = "u0 velocity0 p r q c t".split()
HEADER = ["id", "stratum", *INPUTS, *general_oscillator.OUTPUTS]

ANY = "rest linear libration well homoclinic heteroclinic escape"
MOVING = "libration well homoclinic heteroclinic escape"
STRATA = [
    (starts.single_well, 3, "libration well"),
    (starts.confined, 3, "libration well"),
    (starts.left_well, 3, "libration well"),
    (starts.right_well, 3, "libration well"),
    (starts.above_barrier, 3, "libration well"),
    (starts.near_barrier, 2, "libration well"),
    (starts.softening, 3, "libration well"),
    (starts.near_lower_barrier, 2, "libration well escape"),
    (starts.outside, 3, "escape"),
    (starts.over_one_barrier, 3, "escape"),
    (starts.over_both, 3, "escape"),
    (starts.open_force, 3, "libration well escape"),
    (double_roots.homoclinic, 4, "homoclinic"),
    (double_roots.heteroclinic, 4, "heteroclinic"),
    (double_roots.double_elsewhere, 3, "libration well"),
    (double_roots.double_escape, 3, "escape"),
    (double_roots.triple, 4, "homoclinic escape"),
    (double_roots.coth, 3, "escape"),
    (double_roots.tangent, 3, "escape"),
    (double_roots.quadruple, 3, "escape"),
    (double_roots.last_double, 2, MOVING),
    (starts.quadratic_bounded, 3, "libration well"),
    (starts.quadratic_near_separatrix, 3, "libration well escape"),
    (starts.quadratic_escape, 3, "libration well escape"),
    (double_roots.quadratic_separatrix, 4, "homoclinic escape"),
    (starts.only_even, 3, MOVING),
    (starts.zeros, 2, MOVING),
    (starts.linear, 4, "linear"),
    (starts.rest, 2, "rest"),
    (starts.well_bottom, 3, "libration well"),
    (starts.saddle, 2, "libration well escape"),
    (starts.junction, 3, "libration well escape"),
    (starts.beam, 3, "libration well"),
    (starts.equal_roots, 2, "libration well escape"),
    (starts.turning, 3, MOVING),
    (starts.start_zero, 3, MOVING),
    (starts.no_force, 3, MOVING),
    (starts.moved_origin, 3, MOVING),
    (starts.weak, 3, MOVING),
    (starts.disparate, 2, MOVING),
    (starts.scales, 2, MOVING),
]


def clock(orbit):
    return general_oscillator.clock(*orbit[:2], double_roots.letters(orbit))


def instants(draw, orbit, count, longest=20):
    """Times of both signs: within a period and after up to longest periods, before an escape, or a few units."""
    period, ahead, behind, unit = clock(orbit)
    found = []
    for k in range(count):
        part = draw.part()
        end = behind if k % 2 else ahead
        if mp.isfinite(end):
            found.append(product(end, part))
        elif mp.isfinite(period) and k < 2:
            found.append(product(period, -part if k else part))
        elif mp.isfinite(period):
            found.append(product(period, draw.sign() * (part * longest)))
        else:
            found.append(product(unit, (-24 if k % 2 else 24) * part))
    return found


def inputs():
    """Every row's id, stratum and inputs."""
    draw = Draw(20210607)
    rows = []
    for generator, count, regimes in STRATA:
        for orbit in generator(draw):
            if double_roots.regime_of(orbit) not in regimes.split():
                raise ArithmeticError(f"{generator.__name__}: {orbit} is {double_roots.regime_of(orbit)}")
            rows.extend((generator.__name__, *orbit, t) for t in instants(draw, orbit, count))
    bounded = [starts.single_well, starts.left_well, starts.right_well, starts.above_barrier, starts.softening]
    for generator in [*bounded, starts.quadratic_bounded, double_roots.double_elsewhere]:
        for orbit in first(generator(draw), 2):
            period = clock(orbit)[0]
            for turns in (1e3, 1e6, 1e9):
                rows.append(("long", *orbit, product(period, draw.sign() * turns * (1 + draw.part()))))
    before, beyond = [], []
    unbounded = [
        starts.outside,
        starts.over_one_barrier,
        starts.over_both,
        double_roots.coth,
        double_roots.double_escape,
    ]
    for generator in [*unbounded, double_roots.quadratic_separatrix, starts.only_even, starts.quadratic_escape]:
        for orbit in first((o for o in generator(draw) if double_roots.regime_of(o) == "escape"), 2):
            _, ahead, behind, _ = clock(orbit)
            ends = [end for end in (ahead, behind) if abs(end) < 1e300]
            before += [("before_escape", *orbit, product(end, 1 - part)) for part in (1e-3, 1e-6, 1e-9) for end in ends]
            beyond += [("beyond_escape", *orbit, product(end, part)) for part in (1 + 1e-9, 2.0) for end in ends]
    rows += before + beyond
    early = [
        starts.left_well,
        starts.softening,
        starts.over_both,
        double_roots.homoclinic,
        starts.only_even,
        starts.linear,
    ]
    for generator in [*early, double_roots.triple, starts.rest]:
        orbit = first(generator(draw), 3)[2]
        rows.append(("t_zero", *orbit, 0.0))
        rows.append(("t_tiny", *orbit, draw.sign() * 2.0**-60 * draw.number()))
        rows.append(("t_tiny", *orbit, draw.sign() * 2.0**-900 * draw.number()))
    order = {row[0]: None for row in rows}
    return list(numbered("hd", INPUTS, [row for stratum in order for row in rows if row[0] == stratum]))


def orbit_rows(rows):
    """The rows of the file for inputs that share an orbit."""
    values = [[float.fromhex(row[name]) for name in INPUTS] for row in rows]
    u0, velocity0, *force = values[0][:-1]
    found = general_oscillator.outputs(u0, velocity0, dict(zip("prqc", force, strict=True)), [v[-1] for v in values])
    return [
        [row["id"], row["stratum"], *(row[name] for name in INPUTS), *out] for row, out in zip(rows, found, strict=True)
    ]


def row(inputs):
    """One row of the file from its input columns."""
    return orbit_rows([inputs])[0]


def all_rows(inputs):
    groups = [list(rows) for _, rows in groupby(inputs, key=lambda row: [row[name] for name in INPUTS[:-1]])]
    with ProcessPoolExecutor() as pool:
        for rows in pool.map(orbit_rows, groups):
            yield from rows


if __name__ == "__main__":
    exact.write(NAME, HEADER, all_rows(inputs()))
