"""`libration solve`: the motion at many instants, its summary, a table and a plot.

Everything that can be refused is refused before the motion is evaluated; files are written completely or not at all.
"""

from typing import TYPE_CHECKING

from libration.cli.animation import animate, animation_options, film
from libration.cli.damped import DampedOptions, solve_damped
from libration.cli.files import STANDARD_OUTPUT, Column, strict, write_table
from libration.cli.friction import FORCES, ForceOptions, damped, force_options, forces
from libration.cli.help import Topic
from libration.cli.language import told
from libration.cli.parameters import found_parameters, given_parameters, keyed, table_parameters
from libration.cli.parser import Refusal, command
from libration.cli.picture import check_plot, draw, picture_look
from libration.cli.results import written
from libration.cli.sampling import (
    FILES,
    check_instants,
    check_targets,
    instant_options,
    instants,
    nans,
    result_options,
    sampled,
    targets,
    valueless,
)
from libration.cli.state import UNITS, StateOptions, pendulum, state, state_options
from libration.cli.style import NumberStyle, number_style
from libration.cli.summary import angle_text, digits, period_text, print_lines

if TYPE_CHECKING:
    from libration import Pendulum
    from libration._arrays import Floats

DESCRIPTION = """\
The exact motion of a pendulum: angle and angular velocity at many instants, and how far
the linear solution, theta0 cos(omega0 t) + velocity0 / omega0 sin(omega0 t), is from it.
The angle of a rotation grows beyond a turn. With friction or a torque the motion is integrated to the last digits; its
energy takes the place of the linear solution."""

TOPICS = (
    UNITS,
    FORCES,
    FILES,
    Topic(
        "json",
        text="""\
With --json: one object on the standard output; the keys end in the unit. null stands for a value that is infinite or
does not exist; "regime" tells which: on the separatrix the period is infinite, in rotation there is no turning angle.
With friction or a torque: the turning points, the rests, the time at which it stops, and "undamped_regime".
""",
    ),
)
EXAMPLES = (
    "libration solve --theta0 170deg --length 1m",
    "libration solve --theta0 3 --length 1m --gravity 9.8 --out motion.csv --plot motion.png",
    "libration solve --theta0 0 --velocity0 2.5 --omega0 1 --times instants.csv --out a.npz",
    "libration solve --theta0 2 --length 1m --linear 0.02/s --dry 0.1 --plot decay.png",
    "libration solve --theta0 0 --omega0 1 --torque-amplitude 0.3 --torque-frequency 0.1Hz",
    "libration solve --turning-angle 170deg --length 1m --downwards --out motion.csv",
    "libration solve --theta0 150deg --length 1m --animate swing.gif",
)


class SolveOptions(StateOptions, ForceOptions, DampedOptions):
    """The options of `libration solve`."""


def run(options: SolveOptions) -> None:
    """Solve what the words ask for, write the files, print the summary."""
    given = state(options)
    if not given.has_frequency:
        raise Refusal("missing --length or --omega0, such as --length 1m; `libration period` works without")
    check_instants(options)
    check_targets(options)
    style, look = number_style(options), picture_look(options, options.plot or options.animate)
    acting = forces(options)
    if acting is not None:
        solve_damped(options, given, acting, damped(given, acting, options), style, look)
        return
    motion = pendulum(given)
    with targets(options) as (table, plot), film(options) as moving:
        check_plot(options)
        times, source = instants(options)
        columns, largest, at = motion_columns(motion, times)
        if table and options.out is not None:
            write_table(table, options.out, table_parameters(given, motion), columns, style)
        if plot and options.plot is not None:
            from libration.plot import plot_motion

            draw(plot_motion, motion, times, plot, options.plot, look)
        if moving:
            animate(motion, times, moving, options, look)
    files = written(options.out, options.plot, options.animate)
    if options.json:
        answer = keyed(given_parameters(given, motion) + found_parameters(motion))
        answer |= {"samples": len(times), "samples_nan": nans(columns[1][2])}
        answer |= {"first_t_s": float(times[0]), "last_t_s": float(times[-1])}
        answer |= {"linear_difference_rad": largest, "linear_difference_t_s": at, "files": files}
        print(strict(answer))
    elif options.out != STANDARD_OUTPUT:
        lines = [*summary(motion, style), ("sampled", sampled(times, source, style)), *valueless(nans(columns[1][2]))]
        if motion.omega2 > 0:
            lines.append(("largest difference from linear", difference(largest, at, style)))
        print_lines(lines + [("written", path) for path in files])


def motion_columns(motion: "Pendulum", times: "Floats") -> tuple[list[Column], float | None, float | None]:
    """The columns of the table; the largest difference from the linear solution and the instant where it occurs.

    Without a force towards theta = 0 there is no linear solution, and no column of it.
    """
    import numpy as np

    from libration.plot import linear_theta

    theta, velocity = motion.motion(times)
    columns: list[Column] = [("t", "s", times), ("theta", "rad", theta), ("velocity", "rad/s", velocity)]
    if motion.omega2 <= 0:
        return columns, None, None
    linear = linear_theta(motion, times)
    with np.errstate(over="ignore", invalid="ignore"):
        difference = np.abs(theta - linear)
    columns.append(("theta_linear", "rad", linear))
    if np.isnan(difference).all():
        return columns, None, None
    where = int(np.nanargmax(difference))
    return columns, float(difference[where]), float(times[where])


def summary(motion: "Pendulum", style: NumberStyle) -> list[tuple[str, str]]:
    """What the motion is, for people."""
    return [
        ("regime", str(motion.regime)),
        ("period", period_text(motion, style)),
        ("turning angle", angle_text(motion, style)),
        ("energy", f"{digits(motion.energy, style)} rad^2/s^2 per unit inertia, 0 at the bottom"),
        ("energy ratio", digits(motion.energy_ratio, style)),
        ("1 - energy ratio", digits(motion.energy_ratio_c, style)),
    ]


def difference(largest: float | None, at: float | None, style: NumberStyle) -> str:
    """The largest difference from the linear solution, and when it occurs."""
    if largest is None or at is None:
        return "not known"
    return f"{style.shown(largest, 6)} rad, {told('at')} t = {style.shown(at, 6)} s"


COMMAND = command(
    "solve",
    DESCRIPTION,
    run,
    SolveOptions,
    short="angle and velocity at many instants, as a table and as a plot",
    parameters=[
        *state_options("(this, --omega0 or --omega2 is required)"),
        *force_options(),
        *instant_options(),
        *animation_options(),
        *result_options(
            "t, theta, velocity and theta_linear (with friction: energy)", "theta(t) and the phase portrait"
        ),
    ],
    usage=["libration solve", "--theta0 ANGLE", "(--length LENGTH | --omega0 OMEGA0)", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
