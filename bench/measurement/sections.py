"""What is compared: orbits, sizes, horizons, orders, states of their own, tolerances, calls and threads.

Each section returns its records (comparison.py). bench/run.py writes them to bench/results/.
"""

import functools
import math

from cases.orbits import BY_NAME, ORBITS, states, times
from rivals.compiled import BOOST, GSL
from rivals.formulas import (
    ELLIPTIC_FUNCTIONS,
    LINEAR,
    LINEAR_AS_WRITTEN,
    MPMATH,
    SCIPY,
    SCIPY_MOTION,
    SINE_COSINE,
    by_mpmath,
)
from rivals.integrators import HEYOKA_BATCH, HEYOKA_DENSE, HEYOKA_GRID, at_tolerance, dop853, grid, lsoda
from rivals.method import Method
from rivals.ours import ALLOCATING, FRESH, MOTION, THETA

from . import threads
from .columns import COUNT, columns
from .comparison import TOLERANCES, one_orbit, own_states, tuned
from .timing import LIMIT, ROUNDS, rounds

MILLION = 10**6
OURS = [THETA, ALLOCATING, FRESH, MOTION]
FORMULAS = [LINEAR, LINEAR_AS_WRITTEN, SCIPY, SCIPY_MOTION, GSL, BOOST, ELLIPTIC_FUNCTIONS]
HEYOKA = [HEYOKA_DENSE, HEYOKA_GRID]
INTEGRATORS = [("DOP853", dop853), ("odeint", lsoda)]
# Released at 90° or 150°, every fourth or sixth Taylor coefficient is zero. This misleads a step control that reads the last
# coefficients (heyoka's, at some tolerances). So sizes, horizons and tolerances are compared on an orbit without such zeros.
STANDARD = BY_NAME["170°"]


@functools.cache
def integrators(orbit) -> list[Method]:
    """SciPy's integrators, each at the loosest tolerance that gives 1e-9 over ten periods and at its best."""
    found = []
    for name, build in INTEGRATORS:
        reached, best = tuned(build, orbit, 10)
        if reached is not None and reached != best:
            found.append(at_tolerance(f"{name} for 1e-9", build, reached))
        found.append(at_tolerance(f"{name} at its best" if reached else f"{name} at its best, never 1e-9", build, best))
    return found


def orbits(full: bool) -> list[dict]:
    """A million sorted times over ten periods, orbit after orbit."""
    most = {} if full else {MPMATH.name: 1000}
    found = []
    for orbit in ORBITS:
        methods = [*OURS, *FORMULAS, *HEYOKA, *integrators(orbit), MPMATH]
        found += one_orbit(methods, orbit, MILLION, 10, most=most)
    return found


def sizes(full: bool) -> list[dict]:
    """One sample, a thousand, a million (ten million) over ten periods."""
    methods = [*OURS, *FORMULAS, *HEYOKA, *integrators(STANDARD), MPMATH]
    counts = [1, 10, 100, 10**3, 10**4, 10**5, MILLION] + ([10**7] if full else [])
    most = {} if full else {MPMATH.name: 10**4}
    return [record for count in counts for record in one_orbit(methods, STANDARD, count, 10, most=most)]


def horizons(full: bool) -> list[dict]:
    """Ten thousand times over 10 to 1e9 periods; a method that would exceed the time limit is left out."""
    methods = [THETA, SCIPY, GSL, BOOST, ELLIPTIC_FUNCTIONS, *HEYOKA, *integrators(STANDARD), MPMATH]
    most = {MPMATH.name: 10**4 if full else 1000}
    found, over, before = [], set(), 0.0
    for periods in (1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9) if full else (1e1, 1e3, 1e5, 1e6, 1e9):
        for record in found:
            if (
                record["periods"] == before
                and record["seconds"]
                and not record["method"].startswith(("libration", "mp"))
            ):
                grows = record["method"].startswith(("heyoka", "DOP853", "odeint"))
                if grows and record["seconds"][0] * periods / before > LIMIT:
                    over.add(record["method"])
        found += one_orbit(methods, STANDARD, 10**4, periods, most=most, over=over)
        before = periods
    return found


def long_times(full: bool) -> list[dict]:
    """Ours and the formulas at a million times over ten and over 1e9 periods, sorted and in random order."""
    found = []
    for name in ("90°", "150°", "170°", "fast rotation"):
        methods = [THETA, MOTION, LINEAR, SCIPY, GSL] if name == STANDARD.name or full else [THETA, MOTION, LINEAR]
        for periods in (10, 1e9):
            for order in ("sorted", "random"):
                found += one_orbit(methods, BY_NAME[name], MILLION, periods, order)
    return found


def long_times_ratio(full: bool) -> list[dict]:
    """Ours at ten and at 1e9 periods in the same rounds: the cost of long times."""
    found = []
    for name in ("90°", "150°", "170°", "fast rotation"):
        orbit = BY_NAME[name]
        calls = {f"{name} {periods:g}": THETA.orbit(orbit, times(orbit, MILLION, periods)) for periods in (10, 1e9)}
        found.append({"case": name, "count": MILLION, "seconds": rounds(calls)})
        print(f"  {name}", {key: f"{min(taken) * 1e3:.2f} ms" for key, taken in found[-1]["seconds"].items()})
    return found


def own(full: bool) -> list[dict]:
    """A million random states with a time each, swinging and turning."""
    solvers = integrators(STANDARD)
    most = {} if full else {solver.name: 100 for solver in solvers}
    methods = [MOTION, SCIPY_MOTION, GSL, BOOST, ELLIPTIC_FUNCTIONS, HEYOKA_BATCH, *solvers]
    return own_states(methods, "states", states(MILLION), most, "states of their own, t up to 100")


def steps(full: bool) -> list[dict]:
    """The same states, 0.3 later, ours in place; beside a sine and a cosine in NumPy."""
    theta, velocity, _ = states(MILLION)
    methods = [MOTION, SINE_COSINE, SCIPY_MOTION, GSL, BOOST, ELLIPTIC_FUNCTIONS, HEYOKA_BATCH]
    return own_states(methods, "advance", (theta, velocity, 0.3), {}, "one step of 0.3")


def digits(full: bool) -> list[dict]:
    """Ten thousand times over ten periods, at every tolerance and precision there is to ask for."""
    methods = [THETA, FRESH, MOTION, *FORMULAS]
    most = {}
    for name, build in [*INTEGRATORS, ("heyoka, propagate_grid", grid)]:
        tolerances = [*TOLERANCES[:-1], 1e-14, 1e-15] if build is grid else TOLERANCES
        methods += [at_tolerance(name, build, tolerance) for tolerance in tolerances]
    for precision in (8, 15, 20, 30):
        methods.append(Method(f"mpmath, {precision} digits: θ", orbit=functools.partial(by_mpmath, digits=precision)))
        most[methods[-1].name] = 1000 if full else 300
    return one_orbit(methods, STANDARD, 10**4, 10, most=most)


def calls(full: bool) -> list[dict]:
    """`Pendulum.theta(t, out=)` at 1,000 samples, and at 17,000: the difference is sixteen times the kernel alone."""
    found = []
    for orbit in ORBITS:
        made = {str(count): THETA.orbit(orbit, times(orbit, count, 10)) for count in (1000, 17000)}
        found.append({"case": orbit.name, "count": 1000, "seconds": rounds(made, 3 * ROUNDS)})
        few, many = (min(taken) for taken in found[-1]["seconds"].values())
        print(f"  {orbit.name}: {few * 1e6:.2f} us, kernel {(many - few) / 16 * 1e6:.2f} us")
    return found


def rows(full: bool) -> list[dict]:
    """A hundred thousand rows of every function of columns, beside the fastest peer or np.cos, in turn."""
    found = []
    for column in columns():
        seconds = rounds({"ours": column.call, "theirs": column.theirs}, 3 * ROUNDS)
        each = {
            "ours": [taken / COUNT for taken in seconds["ours"]],
            "theirs": [taken / column.rows for taken in seconds["theirs"]],
        }
        found.append({"case": column.work, "peer": column.peer, "limit": column.limit, "seconds": each})
        print(f"  {column.work}", {name: f"{min(taken) * 1e9:.1f} ns" for name, taken in each.items()}, flush=True)
    return found


def threaded(full: bool) -> list[dict]:
    """One thread against two, each in a process of its own, in turn: 10^7 times, a million states, their actions."""
    return threads.compare([orbit.name for orbit in (ORBITS if full else [BY_NAME["150°"], STANDARD, ORBITS[-1]])])


SECTIONS = {
    "digits": digits,
    "calls": calls,
    "orbits": orbits,
    "sizes": sizes,
    "horizons": horizons,
    "long_times_ratio": long_times_ratio,
    "long_times": long_times,
    "states": own,
    "steps": steps,
    "columns": rows,
    "threads": threaded,
}


def plain_json(record):
    """A record in which infinities and NaN are words, so that any reader of JSON can read it."""
    if isinstance(record, float) and not math.isfinite(record):
        return str(record)
    if isinstance(record, dict):
        return {name: plain_json(value) for name, value in record.items()}
    return [plain_json(value) for value in record] if isinstance(record, list) else record
