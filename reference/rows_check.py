"""Checks the vectors of the pendulum, its approximations of the angle, and the elliptic functions. Called by check.py.

A seeded sample of every file is derived again by its generator and must be the same text. Every row must agree with
Arb balls by other formulas (balls.py), the derivative and condition columns of the sample with central differences
(slopes.py), and mutated rows must fail. The elliptic family is computed in balls, so it is compared with mpmath by other
formulas (second_route.py), values and conditions of a sample; actions and amplitudes with samples of the motion
(samples_route.py); orbits stated by an energy with Gauss's mean and the energy (starts_route.py).
"""

import action
import approx_angle
import approx_angle_route
import balls
import corners
import elliptic
import elliptic_inputs
import exact
import family
import family_inputs
import pendulum
import samples_route
import second
import second_route
import slopes
import starts
import starts_route
from table import counted, fail, mutated

GENERATORS = {
    "pendulum.csv": (pendulum.HEADER, pendulum.row),
    "pendulum_corners.csv": (corners.HEADER, corners.row),
    "action.csv": (action.HEADER, action.row),
    "second.csv": (second.HEADER, second.row),
    "approx_angle.csv": (approx_angle.HEADER, approx_angle.row),
    "starts.csv": (starts.HEADER, starts.row),
    **elliptic.FILES,
    **family.FILES,
}
SAMPLES = {
    "pendulum.csv": 120,
    "pendulum_corners.csv": 60,
    "action.csv": 16,
    "second.csv": 8,
    "approx_angle.csv": 10,
    "jacobi.csv": 250,
    "jacobi_special.csv": 500,
    "complete.csv": 120,
    "incomplete.csv": 150,
    "glaisher.csv": 649,
    "inverse_jacobi.csv": 2182,
    "second_kind.csv": 150,
    "theta_functions.csv": 534,
    "heuman.csv": 150,
    "carlson.csv": 12,
    "third_kind.csv": 6,
    "jacobi_complex.csv": 575,
    "glaisher_complex.csv": 60,
    "from_nome.csv": 40,
    "starts.csv": 8,
}


def contradictions(name, row):
    if name in family.FILES:
        return second_route.wrong(name, row) + second_route.conditions_wrong(name, row)
    return balls.wrong(name, row) + slopes.wrong(name, row)


def inputs_of(name):
    if name == "pendulum.csv":
        return exact.read(exact.ROOM / "inputs" / name)
    if name == "pendulum_corners.csv":
        return list(corners.inputs())
    own = {"action.csv": action, "second.csv": second, "approx_angle.csv": approx_angle, "starts.csv": starts}
    if name in own:
        return list(own[name].inputs())
    return list((family_inputs if name in family.FILES else elliptic_inputs).rows(name))


def check(name, every, rng):
    """Fails at the first row of a file that is not what it should be; says how many are."""
    header, generator = GENERATORS[name]
    rows = exact.read(exact.VECTORS / name)
    if list(rows[0]) != header:
        fail(name, "columns differ from the generator's")
    if counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail("README.md lacks the line", counted(name, rows))
    sample = rows if every else rng.sample(rows, min(SAMPLES[name], len(rows)))
    for row in sample:
        if [str(text) for text in generator(row)] != list(row.values()):
            fail(name, "is not what its generator writes:", row)
    if every:
        given = inputs_of(name)
        if [{key: row[key] for key in given[0]} for row in rows] != given:
            fail(name, "inputs are not what the generator draws")
    if name in balls.VALUES:
        for row in rows:
            if found := balls.wrong(name, row):
                fail(name, "balls contradict", found, row)
        slope_rows = sample if every else sample[:60]
        for row in slope_rows:
            if found := slopes.wrong(name, row):
                fail(name, "differences contradict", found, row)
    elif name == "action.csv":
        steady = [row for row in sample if samples_route.measured(row)][:6]
        if not steady:
            fail(name, "the sample has no row for samples of the motion")
        for row in steady:
            if found := samples_route.wrong(row):
                fail(name, "samples of the motion contradict", found, row)
        if not samples_route.wrong({**steady[0], "action_lo": steady[0]["action_hi"]}):
            fail(name, "a mutated action passes")
    elif name == "starts.csv":
        for row in rows:
            if found := starts_route.wrong(row):
                fail(name, "other formulas contradict", found, row)
        for column in ("period_lo", "velocity_lo", "energy_ratio_c_lo", "energy_lo"):
            given = next(row for row in rows if row["stratum"] == "ratio" and row["counted"] == "theta")
            moved = float.fromhex(given[column]) + float.fromhex(given[f"{column[:-2]}hi"]) * 2.0**-90
            if not starts_route.wrong({**given, column: moved.hex()}):
                fail(name, "a mutated", column, "passes")
    elif name == "approx_angle.csv":
        approx_angle_route.main(fail, rng.sample(rows, len(rows)), every)
    elif name in family.FILES:
        for i, row in enumerate(sample):
            if found := second_route.wrong(name, row):
                fail(name, "mpmath contradicts", found, row)
            if (every or i % 4 == 0) and (found := second_route.conditions_wrong(name, row)):
                fail(name, "differences contradict", found, row)
    if name in balls.VALUES or name in family.FILES:
        moving = [row for row in sample if not is_exact(name, row)]
        for column, row in mutated(moving[0]):
            if not contradictions(name, row):
                fail(name, "a mutated", column, "passes")
    return f"{len(rows)} rows, {len(sample)} derived again"


def is_exact(name, row):
    """Rows whose outputs are inputs, infinities or NaN: too simple to show that the check can fail."""
    if name in family.FILES:
        outputs = family.TABLE[name][1]
        flat = any(second_route.final(row, x) or not 1e-50 < float(row[f"cond_{x}"]) < 1e50 for x in outputs)
        return flat or not second_route.differentiable(name, row)
    texts = list(row.values())
    return "0x0.0p+0" in texts[:8] or any(text in ("nan", "inf", "-inf") for text in texts)
