"""`libration compare`: approximations and numerical solutions beside the exact motion, with their largest errors.

Everything that can be refused is refused before anything is evaluated; files are written completely or not at all.
"""

import math
import os
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeAlias

from libration.cli.files import STANDARD_OUTPUT, Column, Json, strict, write_table
from libration.cli.help import Topic
from libration.cli.language import say, told
from libration.cli.offers import solutions
from libration.cli.parameters import keyed, table_parameters
from libration.cli.parser import Refusal, Value, command, refusal
from libration.cli.picture import check_plot, drawing, form, picture_look, picture_options
from libration.cli.quantities import plain
from libration.cli.results import out_options, written
from libration.cli.sampling import ResultOptions, check_targets, targets
from libration.cli.series import ENDINGS, Series, is_series, series
from libration.cli.state import UNITS, State, StateOptions, pendulum, state, state_options, upright
from libration.cli.style import NumberStyle, number_style, style_options
from libration.cli.summary import angle_text, period_text, print_lines

if TYPE_CHECKING:
    from libration import Pendulum
    from libration.approx._angle import AngleApproximation, AngleError, AngleFormula
    from libration.approx._numerical import NumericalFormula, NumericalSolution
    from libration.approx._registry import Registry

Solution: TypeAlias = "AngleApproximation | NumericalSolution | Series"
# The largest error over one of the spans, and when a numerical swing goes over the top, else NaN.
Measured: TypeAlias = "tuple[AngleError, float]"

DESCRIPTION = """\
How far approximations and numerical solutions are from the exact motion: the largest
error of each, in rad and in percent of the turning angle (as Lima 2019 counts), over one
period and over a hundred."""

APPROXIMATIONS = Topic(
    "approximations",
    (
        ("linear", "theta0 cos(omega0 t) + velocity0 / omega0 sin(omega0 t)"),
        ("harmonic", "a cosine with the exact period (Lima 17)"),
        ("fourier:N", "N terms of sn, under the arcsine (Lima 22); undefined where that is"),
        ("fourier-theta:N", "N terms of the series of theta itself"),
        ("trigonometric", "cosine over root, for a release from rest (Salas 35)"),
        ("small-m", "first order in m, any start; its error grows with time (Salas)"),
        ("small-m-bounded", "the same without that growth"),
        ("cubic, cubic-quintic", "sin(theta) as a polynomial (Salas 2, 3), solved exactly"),
        ("taylor:N", "N-th Taylor polynomial in t about t = 0"),
    ),
)
NUMERICAL = Topic(
    "numerical solutions",
    (
        ("euler:H", "explicit Euler, with steps of H seconds"),
        ("euler-cromer:H", "semi-implicit Euler, symplectic; also symplectic-euler:H"),
        ("verlet:H", "velocity Verlet of order 2, symplectic; also leapfrog:H, stormer-verlet:H"),
        ("rk4:H", "the classical Runge-Kutta method of order 4"),
        ("rk45", "solve_ivp step by step, without SciPy"),
        ("solve_ivp, odeint", "SciPy's, with their defaults"),
    ),
)
TOPICS = (
    APPROXIMATIONS,
    NUMERICAL,
    Topic(
        "a series of yours",
        text="""\
A name that ends in .csv, .txt, .tsv or .dat is a file with the columns t and theta, by name or the first two, in the
units of the header, as in `theta [deg]`, else s and rad. It is compared at its own instants, from t = 0 on.""",
    ),
    Topic("omega0", text="Without --length or --omega0 it is a pendulum with omega0 = 1 rad/s."),
    UNITS,
    Topic(
        "files",
        text="""\
--out writes t, the exact theta and that of each solution at 1,000 instants a period to a .csv, .npz or .json file, nan
(in JSON null) where one is undefined. --plot draws the angles above their errors to a .png or .svg file.""",
    ),
)
EXAMPLES = (
    "libration compare --theta0 157.5deg --with harmonic,fourier:4,fourier-theta:4",
    "libration compare --theta0 90deg --with harmonic,fourier:2 --plot lima-3.png",
    "libration compare --theta0 3 --length 1m --gravity 9.8 --with solve_ivp,rk4:0.025",
    "libration compare --theta0 60deg --length 50cm --with linear,data.csv --plot data.png",
)
PERIODS = "periods of the table, the plot and one of the errors; the other is over 100 (default 1)"

LONG = 100.0
# Other names of the symplectic schemes.
ALIASES = {"leapfrog": "verlet", "stormer-verlet": "verlet", "symplectic-euler": "euler-cromer"}


class CompareOptions(StateOptions, ResultOptions):
    """The options of `libration compare`; `names` are those of --with."""

    names: str | None
    periods: str | None


def run(options: CompareOptions) -> None:
    """Compare the solutions that the words name, write the files, print the errors."""
    given = state(options)
    assumed = not given.has_frequency
    given = given.with_frequency(1.0)
    wanted = names(options.names)
    periods = span(options.periods)
    check_targets(options)
    style, look = number_style(options), picture_look(options, options.plot)
    motion = moving(options, pendulum(given))
    hint = "; leave out --from-top" if given.from_top else ""
    solutions = different([solution(name, motion, hint) for name in wanted], options.names)
    with targets(options, keep=[name for name in wanted if is_series(name)]) as (table, plot):
        check_plot(options)
        spans = sorted({periods, LONG})
        rows = [(name, [measured(name, made, each) for each in spans]) for name, made in solutions]
        if table and options.out is not None:
            columns = sampled_angles(motion, solutions, periods)
            write_table(table, options.out, table_parameters(given, motion), columns, style)
        if plot and options.plot is not None:
            from libration.plot import plot_comparison

            with drawing("--plot", options.plot):
                plot_comparison(motion, solutions, plot, periods=periods, form=form(options.plot), **look)
    files = written(options.out, options.plot)
    if options.json:
        print_json(given, motion, spans, rows, files)
    elif options.out != STANDARD_OUTPUT:
        print_text(motion, assumed, spans, rows, files, style)


def names(text: str | None) -> list[str]:
    """The names in the value of --with."""
    if text is None:
        raise Refusal("missing --with, what to compare, such as --with harmonic,fourier:4")
    wanted = [name.strip() for name in text.split(",")]
    for name in wanted:
        if not name:
            raise refusal("--with", text, "has an empty name; separate names by single commas")
    return wanted


def different(solutions: Sequence[Solution], text: str | None) -> list[tuple[str, Solution]]:
    """The solutions by their names, or a Refusal if one is named twice."""
    names = [made.formula.name for made in solutions]
    keys = [key_of(name) for name in names]
    for name, key in zip(names, keys, strict=True):
        if keys.count(key) > 1:
            what = "has two files with the name" if is_series(name) and names.count(name) == 1 else ""
            base = os.path.basename(name)
            raise refusal("--with", text, f"{told(what)} {base}" if what else f"names {base} twice")
    return list(zip(names, solutions, strict=True))


def span(text: str | None) -> float:
    """How many periods."""
    if text is None:
        return 1.0
    from libration.approx._numerical import MOST_PERIODS

    periods = plain("--periods", text)
    if not 0 < periods <= MOST_PERIODS:
        raise refusal("--periods", text, f"must be above 0 and at most {MOST_PERIODS}")
    return periods


def moving(options: CompareOptions, motion: "Pendulum") -> "Pendulum":
    """A motion with a period, or a Refusal."""
    regime = str(motion.regime)
    if regime == "rest":
        raise refusal("--theta0", options.theta0, "is at rest: nothing moves, so there is nothing to compare")
    if regime == "separatrix":
        raise refusal("--velocity0", options.velocity0, "is on the separatrix: it has no period to compare over")
    if upright(motion):
        reason = "is the upright balance, whose period is infinite; give less, such as 179.9deg"
        raise refusal("--theta0", options.theta0, reason)
    return motion


def solution(name: str, motion: "Pendulum", hint: str) -> Solution:
    """One solution by its name, or a Refusal with the nearest names first."""
    from libration import approx
    from libration.approx._numerical import nearest

    if is_series(name):
        return series(name, motion)
    base, colon, step = name.partition(":")
    if base in ALIASES:
        base = ALIASES[base]
        name = base + colon + step
    patterns = (*approx.angle.names, *approx.numerical.names)
    if base not in [each.partition(":")[0] for each in patterns]:
        if os.path.isfile(name):
            raise refusal("--with", name, f"a file with a series must end in {', '.join(ENDINGS)}")
        raise refusal("--with", name, f"must be one of {', '.join(nearest(patterns, name))}")
    numerical = base in [each.partition(":")[0] for each in approx.numerical.names]
    makes: Registry[NumericalFormula] | Registry[AngleFormula] = approx.numerical if numerical else approx.angle
    try:
        return makes(name).of(motion)
    except (ValueError, ImportError) as error:
        raise refusal("--with", name, reason(error, name) + hint * ("omega2" in str(error))) from error


def reason(error: Exception, name: str) -> str:
    """The message of an error, without the name that it begins with."""
    first, colon, rest = str(error).partition(": ")
    return rest if colon and name.partition(":")[0] in first else str(error)


def measured(name: str, made: Solution, periods: float) -> Measured:
    """The largest error over so many periods, and when a numerical swing goes over the top (else NaN), or a Refusal."""
    import numpy as np

    from libration.approx._numerical import NumericalSolution

    try:
        # SciPy's solvers may leave the doubles.
        with np.errstate(all="ignore"):
            top = made.over_the_top(periods) if isinstance(made, NumericalSolution) else math.nan
            return made.error(periods), top
    except ValueError as error:
        raise refusal("--with", name, reason(error, name)) from error


def sampled_angles(motion: "Pendulum", solutions: Sequence[tuple[str, Solution]], periods: float) -> list[Column]:
    """The columns of the table."""
    import numpy as np

    t = np.linspace(0.0, periods * motion.period, math.ceil(1000 * periods) + 1)
    angles = [(key_of(name), "rad", made.theta(t)) for name, made in solutions]
    return [("t", "s", t), ("theta", "rad", motion.theta(t)), *angles]


def key_of(name: str) -> str:
    """`fourier:4` as the name of a column, `theta_fourier_4`; a file without its directory."""
    name = os.path.basename(name) if is_series(name) else name
    return "theta_" + re.sub(r"[^\w.]", "_", name)


def print_json(
    given: State,
    motion: "Pendulum",
    spans: Sequence[float],
    rows: Sequence[tuple[str, list[Measured]]],
    files: list[str],
) -> None:
    """One JSON object."""
    answer: dict[str, Json] = keyed(table_parameters(given, motion)[1:])
    answer["errors"] = [
        {
            "name": name,
            "periods": periods,
            "largest_error_rad": error.difference,
            "largest_error_percent": 100 * error.relative,
            "t_s": error.t,
            "t_per_period": error.t / motion.period,
            "undefined_from_s": error.undefined_from,
            "over_the_top_s": top,
        }
        for name, errors in rows
        for periods, (error, top) in zip(spans, errors, strict=True)
    ]
    answer["files"] = files
    print(strict(answer))


def print_text(
    motion: "Pendulum",
    assumed: bool,
    spans: Sequence[float],
    rows: Sequence[tuple[str, list[Measured]]],
    files: list[str],
    style: NumberStyle,
) -> None:
    """A table for people."""
    print_lines(
        [
            ("exact motion", f"{told(str(motion.regime))}, {told('period')} {period_text(motion, style)}"),
            ("turning angle", angle_text(motion, style)),
            *([("omega0", "1 rad/s (default)")] if assumed else []),
        ]
    )
    percent = math.isfinite(motion.theta_max)
    heads = ["      rad", *(["        %"] if percent else []), " at t/T"]
    largest = told("largest error")
    width = max(len(largest), *(len(name) for name, *_ in rows))
    block = sum(map(len, heads)) + 2 * (len(heads) - 1)
    print()
    print(f"{largest:{width}}", *(f"  {over(periods):>{block}}" for periods in spans), sep="")
    print(" " * width, *(f"  {'  '.join(heads)}" for _ in spans), sep="")
    for name, errors in rows:
        cells = [
            f"  {cell:>{len(head)}}"
            for error, _ in errors
            for head, cell in zip(heads, texts(error, motion, percent, style), strict=True)
        ]
        print(f"{name:{width}}{''.join(cells)}{remarks(name, motion, errors, style)}".rstrip())
    if percent:
        say("\n% of the turning angle; t/T is when the error is largest, in periods")
    if files:
        print()
        print_lines([("written", path) for path in files])


def over(periods: float) -> str:
    """`over 1 period`, as the head of a block."""
    return f"{told('over')} {periods:g} {told('period' if periods == 1 else 'periods')}"


def texts(error: "AngleError", motion: "Pendulum", percent: bool, style: NumberStyle) -> list[str]:
    """The cells of one error."""
    if math.isnan(error.difference):
        return [told("undefined"), *(["-"] if percent else []), "-"]
    shown = [style.shown(error.difference, 4), *([style.shown(100 * error.relative, 4)] if percent else [])]
    return [*shown, style.shown(error.t / motion.period, 5)]


def remarks(name: str, motion: "Pendulum", errors: Sequence[Measured], style: NumberStyle) -> str:
    """Where a solution is undefined, and when it goes over the top; the last error is that of the longest span."""
    said = []
    gaps = [error.undefined_from for error, _ in errors if not math.isnan(error.undefined_from)]
    if gaps:
        what = "ends at" if is_series(name) else "undefined from"
        said.append(f"{told(what)} t/T = {style.shown(gaps[0] / motion.period, 5)}")
    top = errors[-1][1]
    if not math.isnan(top):
        said.append(told(f"goes over the top at t = {style.shown(top, 4)} s"))
    return "  " + "; ".join(said) if said else ""


COMMAND = command(
    "compare",
    DESCRIPTION,
    run,
    CompareOptions,
    short="approximations and numerical solutions beside the exact motion",
    parameters=[
        *state_options("(gives the time in seconds)"),
        Value(
            "--with",
            "NAMES",
            "what to compare, separated by commas, also files (required)",
            "the comparison",
            name="names",
            offered=solutions,
        ),
        Value("--periods", "N", PERIODS, "the comparison"),
        *out_options("the angles", "them", "print the errors as one JSON object"),
        *style_options("4, of times 5"),
        *picture_options("the angles and their errors"),
    ],
    usage=["libration compare", "--theta0 ANGLE", "--with NAMES", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
