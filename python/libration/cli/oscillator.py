"""What `libration duffing` and `libration cubic-quintic` share: the motion of a nonlinear spring at many instants.

Everything that can be refused is refused before the motion is evaluated; files are written completely or not at all.
"""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import click

from libration.cli.files import STANDARD_OUTPUT, Column, Parameter, strict, write_table
from libration.cli.help import Topic
from libration.cli.language import told
from libration.cli.parameters import keyed
from libration.cli.parser import Refusal, Value
from libration.cli.picture import check_plot, draw, picture_look
from libration.cli.quantities import plain
from libration.cli.results import written
from libration.cli.sampling import (
    FILES,
    InstantOptions,
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
from libration.cli.style import NumberStyle, number_style
from libration.cli.summary import digits, print_lines

if TYPE_CHECKING:
    from libration import CubicQuintic, Duffing
    from libration._arrays import Floats

TOPICS = (
    Topic(
        "numbers",
        text="""\
u0, velocity0 and the coefficients are numbers without a unit, of any sign; u is in any unit, time in s (--until takes
ms, min, h too). Beyond an escape u does not exist: nan in a table, null in JSON.""",
    ),
    FILES,
    Topic(
        "json",
        text="""\
With --json: one object on the standard output. null stands for a value that is infinite or does not exist: a motion
that does not repeat has no period, one that does not escape no escape time.""",
    ),
)


class OscillatorOptions(InstantOptions):
    """The options of a command of a spring; the coefficients beside them have the names of the spring."""

    u0: str | None
    velocity0: str | None


def oscillator_options(coefficients: dict[str, str], more: dict[str, str] | None = None) -> list[click.Option]:
    """The options of a spring; `coefficients` says what each is, and `more` those that are 0 if not given."""
    group = "the oscillator"
    return [
        *(
            Value(f"--{name}", name.upper(), f"{text} (required without --mass)", group)
            for name, text in coefficients.items()
        ),
        *(Value(f"--{name}", name.upper(), f"{text} (default 0)", group) for name, text in (more or {}).items()),
        Value("--u0", "U0", "initial displacement (required)", group),
        Value("--velocity0", "VELOCITY0", "initial velocity (default 0)", group),
        *instant_options(),
        *result_options("t, u and velocity", "u(t) and the phase portrait"),
    ]


def required(options: OscillatorOptions, names: Iterable[str], so: str) -> None:
    """A Refusal that names the options that are not given, with an example."""
    missing = [f"--{name}" for name in names if getattr(options, name) is None]
    if missing:
        raise Refusal(f"missing {', '.join(missing)}; such as {so}")


def plain_numbers(options: OscillatorOptions, names: Iterable[str]) -> dict[str, float]:
    """The options that are given, as numbers without units."""
    return {name: plain(f"--{name}", text) for name in names if (text := getattr(options, name)) is not None}


def show(
    options: OscillatorOptions, kind: "type[Duffing] | type[CubicQuintic]", given: dict[str, float], unit: str
) -> None:
    """Solve the motion that the numbers give, write the files, print the summary; `unit` is that of u, none if it may be any."""
    check_instants(options)
    check_targets(options)
    style, look = number_style(options), picture_look(options, options.plot)
    motion = kind(**given)
    with targets(options) as (table, plot):
        check_plot(options)
        times, source = instants(options)
        u, velocity = motion.motion(times)
        if table and options.out is not None:
            columns: list[Column] = [("t", "s", times), ("u", unit, u), ("velocity", f"{unit or 1}/s", velocity)]
            write_table(table, options.out, parameters(given, motion), columns, style)
        if plot and options.plot is not None:
            from libration.plot import plot_oscillator

            draw(plot_oscillator, motion, times, plot, options.plot, look)
    files = written(options.out, options.plot)
    if options.json:
        answer = keyed(parameters(given, motion)[1:])
        answer |= {"samples": len(times), "samples_nan": nans(u)}
        answer |= {"first_t_s": float(times[0]), "last_t_s": float(times[-1]), "files": files}
        print(strict(answer))
    elif options.out != STANDARD_OUTPUT:
        print_text(motion, times, u, source, files, style, unit)


def parameters(given: dict[str, float], motion: "Duffing | CubicQuintic") -> list[Parameter]:
    """What was given and what the motion is, as (name, value, unit)."""
    from libration import __version__

    low, high = motion.range
    found = [
        ("period", motion.period, "s"),
        ("frequency", motion.frequency / math.tau, "Hz"),
        ("lowest_u", low, ""),
        ("highest_u", high, ""),
        ("energy", motion.energy, ""),
    ]
    found += [("escape", motion.escape_time, "s"), ("escape_backward", motion.escape_time_backward, "s")]
    return [
        ("libration", __version__, ""),
        *((name, value, "") for name, value in given.items()),
        ("regime", str(motion.regime), ""),
        *((name, float(value), unit) for name, value, unit in found),
    ]


def print_text(
    motion: "Duffing | CubicQuintic",
    times: "Floats",
    u: "Floats",
    source: str | None,
    files: list[str],
    style: NumberStyle,
    unit: str,
) -> None:
    """The summary for people."""
    import numpy as np

    def time(value: float, never: str) -> str:
        return f"{digits(value, style)} s" if math.isfinite(value) else never

    def bound(value: float) -> str:
        return digits(value, style) if math.isfinite(value) else told("infinity" if value > 0 else "-infinity")

    def size(value: float) -> str:
        return digits(value, style) if math.isfinite(value) else "beyond the largest double, 1.8e308,"

    low, high = motion.range
    lines = [("regime", str(motion.regime)), ("period", time(motion.period, "none, it does not repeat"))]
    if math.isfinite(motion.period):
        lines.append(("frequency", f"{digits(motion.frequency / math.tau, style)} Hz"))
    lines += [
        ("range of u", f"{bound(low)} {told('to')} {bound(high)} {unit}".rstrip()),
        ("energy", f"{size(motion.energy)} per unit mass, 0 at rest at u = 0"),
        ("escapes at", time(motion.escape_time, "never")),
        ("came from infinity at", time(motion.escape_time_backward, "never")),
        ("sampled", sampled(times, source, style)),
    ]
    beyond = int(np.count_nonzero((times > motion.escape_time) | (times < motion.escape_time_backward)))
    if beyond:
        lines.append(("of them beyond an escape", f"{beyond}, nan in a table"))
    lines += valueless(nans(u) - beyond)
    print_lines(lines + [("written", path) for path in files])
