"""`libration duffing` and `cubic-quintic` with several --u0: how period, frequency and action change with the displacement, as a table and a picture."""

import math
from typing import TYPE_CHECKING

from libration.cli.files import STANDARD_OUTPUT, Column, Json, Parameter, strict, write_table
from libration.cli.help import Topic
from libration.cli.language import say, told
from libration.cli.parameters import keyed
from libration.cli.parser import refusal
from libration.cli.picture import check_plot, drawing, form, picture_look
from libration.cli.quantities import Dimension, quantities, quantity, whole
from libration.cli.results import written
from libration.cli.sampling import ResultOptions, check_targets, targets
from libration.cli.style import NumberStyle, number_style
from libration.cli.summary import print_lines, print_table

if TYPE_CHECKING:
    from libration._arrays import Floats

MOST = 1_000_000
# Points of the curve at least.
FINE = 2_000
SEVERAL = Topic(
    "several u0",
    text="""\
Displacements separated by commas, or a range FROM:TO:COUNT, give a table: regime, period, frequency and action of the
motion from each of them; --plot draws the backbone curve, the displacement over the frequency.""",
)


def several(text: str | None) -> bool:
    """Whether --u0 asks for more than one start."""
    return text is not None and any(mark in text for mark in (",", ";", ":"))


def starts(text: str, dimension: Dimension) -> "Floats":
    """The displacements of a list, or of a range FROM:TO:COUNT with both ends."""
    import numpy as np

    if ":" not in text:
        return np.array(quantities("--u0", text, dimension))
    pieces = text.split(":")
    if len(pieces) != 3:
        raise refusal("--u0", text, "a range is FROM:TO:COUNT, as 0.1:2:20")
    first, last = (quantity("--u0", piece, dimension) for piece in pieces[:2])
    return np.linspace(first, last, whole("--u0", pieces[2], 2, MOST))


def curve_of(u0: "Floats") -> "Floats":
    """Displacements from the least to the greatest, and all of `u0`, so near each other that lines between them are a curve."""
    import numpy as np

    return np.union1d(np.linspace(u0.min(), u0.max(), FINE), u0)


def backbone(
    options: ResultOptions, family: str, u0: "Floats", velocity0: float, force: dict[str, float], unit: str
) -> None:
    """Print, write and draw the motions released at each displacement; `family` begins the names of the functions of arrays."""
    import numpy as np

    import libration

    check_targets(options)
    style, look = number_style(options), picture_look(options, options.plot)
    given = {"velocity0": velocity0, **force}
    period, frequency, action, regime = (
        getattr(libration, f"{family}_{kind}")(u0, velocity0, **force)
        for kind in ("period", "frequency", "action", "regime")
    )
    with targets(options) as (table, plot):
        check_plot(options)
        hertz = frequency / math.tau
        columns: list[Column] = [("u0", unit, u0), ("period", "s", period), ("frequency", "Hz", hertz)]
        columns += [("frequency", "rad/s", frequency), ("action", "", action)]
        parameters: list[Parameter] = [
            ("libration", libration.__version__, ""),
            *((k, v, "") for k, v in given.items()),
        ]
        if table and options.out is not None:
            write_table(table, options.out, parameters, columns, style)
        if plot and options.plot is not None:
            from libration.plot._backbone import save_backbone

            finer = curve_of(u0)
            exact = getattr(libration, f"{family}_frequency")(finer, velocity0, **force) / math.tau
            with drawing("--plot", options.plot):
                save_backbone((exact, finer), (hertz, u0), unit, plot, form=form(options.plot), **look)
    files = written(options.out, options.plot)
    if options.json:
        rows = zip(u0.tolist(), regime.tolist(), period.tolist(), hertz.tolist(), action.tolist(), strict=True)
        names = ("u0", "regime", "period_s", "frequency_Hz", "action")
        motions: list[Json] = [dict(zip(names, row, strict=True)) for row in rows]
        print(strict({**keyed(parameters[1:]), "motions": motions, "files": files}))
    elif options.out != STANDARD_OUTPUT:
        shown = np.linspace(0, u0.size - 1, min(u0.size, 40)).astype(int)
        print_rows(style, unit, shown.tolist(), u0, regime, period, hertz, action)
        if shown.size < u0.size:
            say(f"\n{shown.size} of {u0.size} starts; all of them: --out")
        if files:
            print()
            print_lines([("written", path) for path in files])


def print_rows(
    style: NumberStyle,
    unit: str,
    rows: list[int],
    u0: "Floats",
    regime: "Floats",
    *columns: "Floats",
) -> None:
    """A row for each start."""
    heads = [f"u0 [{unit}]" if unit else "u0", "regime", "period [s]", "frequency [Hz]", "action"]
    lines = [
        [style.aligned(float(u0[k]), 6), told(str(regime[k])), *(style.aligned(float(each[k]), 6) for each in columns)]
        for k in rows
    ]
    print_table(heads, lines, left=(1,))
