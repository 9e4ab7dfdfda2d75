"""`libration solve` with friction and torque: the table, the picture and the summary of a damped or driven motion."""

import math
from typing import TYPE_CHECKING

from libration.cli.animation import AnimationOptions, animate, film
from libration.cli.files import STANDARD_OUTPUT, Column, Json, Parameter, strict, write_table
from libration.cli.friction import Forces
from libration.cli.language import told
from libration.cli.parameters import given_parameters, keyed
from libration.cli.picture import Look, check_plot, draw
from libration.cli.results import written
from libration.cli.sampling import InstantOptions, instants, nans, sampled, targets
from libration.cli.state import State, pendulum
from libration.cli.style import NumberStyle
from libration.cli.summary import digits, print_lines

if TYPE_CHECKING:
    from libration import DampedPendulum
    from libration._arrays import Floats

NOT_REACHED = "the motion does not get there"


class DampedOptions(InstantOptions, AnimationOptions):
    """What is asked of a motion with friction and torque: instants, files and a film."""


def solve_damped(
    options: "DampedOptions", given: State, acting: Forces, motion: "DampedPendulum", style: NumberStyle, look: Look
) -> None:
    """Solve a motion with friction and torque, write the files, print the summary."""
    with targets(options, acting.kept) as (table, plot), film(options) as moving:
        check_plot(options)
        times, source = instants(options)
        theta, velocity = motion.motion(times)
        known = [("libration", version(), ""), *given_parameters(given, motion), *acting.parameters]
        if table and options.out is not None:
            columns: list[Column] = [("t", "s", times), ("theta", "rad", theta), ("velocity", "rad/s", velocity)]
            columns.append(("energy", "rad^2/s^2", motion.energy(times)))
            write_table(table, options.out, [*known, *undamped(given)], columns, style)
        if plot and options.plot is not None:
            from libration.plot import plot_motion

            draw(plot_motion, motion, times, plot, options.plot, look)
        if moving:
            animate(motion, times, moving, options, look)
    files = written(options.out, options.plot, options.animate)
    if options.json:
        answer = keyed([*known[1:], *undamped(given)]) | events(motion, times, theta)
        answer |= {"samples": len(times), "samples_nan": nans(theta)}
        answer |= {"first_t_s": float(times[0]), "last_t_s": float(times[-1])}
        answer |= {"last_theta_rad": float(theta[-1]), "last_velocity_rad_per_s": float(velocity[-1]), "files": files}
        print(strict(answer))
    elif options.out != STANDARD_OUTPUT:
        lines = summary(given, acting, motion, times, theta, style)
        lines.append(("sampled", sampled(times, source, style)))
        if lost := nans(theta):
            lines.append(("of them not reached", f"{lost}, {NOT_REACHED}: nan in a table"))
        print_lines(lines + [("written", path) for path in files])


def version() -> str:
    """That of the package."""
    from libration import __version__

    return __version__


def undamped(given: State) -> list[Parameter]:
    """What the motion would be without friction and torque."""
    free = pendulum(given)
    return [("undamped_regime", str(free.regime), ""), ("undamped_period", float(free.period), "s")]


def span(times: "Floats", theta: "Floats") -> tuple[float, float]:
    """From the first to the last instant that the motion reaches, with t = 0."""
    import numpy as np

    reached = times[np.isfinite(theta)]
    return float(reached.min(initial=0.0)), float(reached.max(initial=0.0))


def events(motion: "DampedPendulum", times: "Floats", theta: "Floats") -> dict[str, Json]:
    """When it turns back and rests, and when it stops for good."""
    first, last = span(times, theta)
    turning, rests = motion.turning_times(first, last), motion.rests(first, last)
    stops = rests[-1][0] if rests and rests[-1][1] == last else math.nan
    return {
        "energy_rad2_per_s2": float(motion.energy(0.0)),
        "last_energy_rad2_per_s2": float(motion.energy(last)),
        "turning_times_s": turning.tolist(),
        "turning_angles_rad": motion.theta(turning).tolist(),
        "rests_s": [list(each) for each in rests],
        "stop_time_s": stops,
    }


def summary(
    given: State, acting: Forces, motion: "DampedPendulum", times: "Floats", theta: "Floats", style: NumberStyle
) -> list[tuple[str, str]]:
    """What the motion is, for people."""
    found = events(motion, times, theta)
    first, last = span(times, theta)
    free = pendulum(given)
    period = f", period {digits(free.period, style)} s" if math.isfinite(free.period) else ""
    friction = [part for part in acting.parameters if not part[0].startswith("torque")]
    torque = [part for part in acting.parameters if part[0].startswith("torque")]
    without = "both" if friction and torque else "friction" if friction else "torque"
    lines = [(f"without {without}", f"{told(str(free.regime))}{told(period)}")]
    for label, parts in (("torque", torque), ("friction", friction)):
        if parts:
            lines.insert(0, (label, ", ".join(term(part, label, style) for part in parts)))
    at_first, at_last = (style.shown(float(motion.energy(t)), 6) for t in (0.0, last))
    lines.append(
        ("energy", f"{at_first} rad^2/s^2 per unit inertia at t = 0, {at_last} at t = {style.shown(last, 6)} s")
    )
    lines.append(("turning points", turning_text(motion, first, last, style)))
    n = int(motion.turns(last)[0])
    if n:
        lines.append(
            (
                "over the top",
                f"{abs(n)} {told('whole turn' if abs(n) == 1 else 'whole turns')} {told('forward' if n > 0 else 'back')}",
            )
        )
    rests = motion.rests(first, last)
    stops = found["stop_time_s"]
    if isinstance(stops, float) and math.isfinite(stops):
        lines.append(("stops", f"at t = {digits(stops, style)} s, theta = {angle(float(motion.theta(stops)), style)}"))
        rests = rests[:-1]
    if rests:
        times_held = "once" if len(rests) == 1 else f"{len(rests)} times"
        begin, end = (style.shown(t, 6) for t in rests[0])
        lines.append(("held by dry friction", f"{times_held}, first from t = {begin} s to {end} s"))
    return lines


def term(part: Parameter, label: str, style: NumberStyle) -> str:
    """A term of friction or torque by its name, its number and its unit."""
    name, value, unit = part
    short = told(name.removeprefix(label).removeprefix("_").replace("file", "of") or "constant")
    number = digits(value, style) if isinstance(value, float) else value
    return f"{short} {number} {unit}".rstrip()


def turning_text(motion: "DampedPendulum", first: float, last: float, style: NumberStyle) -> str:
    """How often it turns back, and where at first and at last."""
    turning = motion.turning_times(first, last)
    if not turning.size:
        return "none"

    def place(t: float) -> str:
        return f"t = {style.shown(t, 6)} s {told('at')} {angle(float(motion.theta(t)), style)}"

    ends = [place(float(t)) for t in (turning[0], turning[-1])][: turning.size]
    between = f" {told('to')} "
    return f"{turning.size}, {between.join(ends)}"


def angle(radians: float, style: NumberStyle) -> str:
    """An angle in radians and degrees, to read."""
    return f"{style.shown(radians, 6)} rad = {style.shown(math.degrees(radians), 6)} deg"
