"""The pictures of docs/benchmarks.md: error against time for every method, and how cost and error grow.

Made with matplotlib's Figure alone. Names are written at the points, without a legend; libration has the one strong colour,
and every family a marker and a dash of its own, so that they are told apart in grey too.
"""

import itertools
import math
import statistics
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure
from rivals.ours import FRESH, MOTION

from libration.plot._style import FONTS, save_as

OURS = "#b5341f"
# Colour, marker, dash.
FAMILIES = {
    "libration": (OURS, "o", "-"),
    "θ₀ cos": ("#767676", "s", ":"),
    "SciPy": ("#0072b2", "^", "--"),
    "GSL": ("#00805e", "D", "-."),
    "Boost": ("#a8447c", "v", ":"),
    "elliptic-functions": ("#946c00", "P", "--"),
    "mpmath": ("#4d4d4d", "X", "-"),
    "heyoka": ("#2b83b5", "s", "-"),
    "DOP853": ("#7a4a21", "^", "-"),
    "odeint": ("#c2527f", "D", "-"),
}
STYLE = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#777777",
    "axes.labelcolor": "#333333",
    "xtick.color": "#555555",
    "ytick.color": "#555555",
    "svg.hashsalt": "libration",
    "svg.fonttype": "none",
    "font.sans-serif": list(FONTS[:-1]),
}
LEAST = 3e-17
# The part of a panel's width that names take beyond the last points.
ROOM = 0.42


def family(method: str) -> str:
    """The rival to which a method belongs."""
    return next(name for name in FAMILIES if method.startswith(name))


def points(records: list[dict]) -> dict[str, list[tuple[float, float]]]:
    """Nanoseconds per sample and worst error, by family; ours and the recipes with θ alone."""
    found: dict[str, list[tuple[float, float]]] = {}
    for record in records:
        if not record["seconds"] or record["method"] in (FRESH.name, MOTION.name):
            continue
        nanoseconds = statistics.median(record["seconds"]) / record["count"] * 1e9
        worst = float(record["errors"][0])
        if math.isfinite(worst):
            found.setdefault(family(record["method"]), []).append((nanoseconds, max(worst, LEAST)))
    return found


def quiet(axes, horizontal: str, vertical: str) -> None:
    """Logarithmic axes with few lines."""
    axes.set(xscale="log", yscale="log", xlabel=horizontal, ylabel=vertical)
    axes.grid(True, color="#ececec", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.minorticks_off()


PLACES = {
    "libration": (8, 6, "left"),
    "θ₀ cos": (0, 9, "center"),
    "SciPy": (0, 9, "center"),
    "GSL": (-8, -3, "right"),
    "Boost": (0, -14, "center"),
    "elliptic-functions": (8, -3, "left"),
    "mpmath": (-8, -3, "right"),
    "heyoka": (-8, 2, "right"),
    "DOP853": (10, -3, "left"),
    "odeint": (10, -3, "left"),
}


def error_against_time(records: list[dict]) -> Figure:
    """The worst error of every method against nanoseconds per sample; integrators are lines over their tolerances."""
    figure = Figure(figsize=(7.6, 5.0), layout="constrained")
    axes = figure.add_subplot()
    quiet(axes, "nanoseconds per sample", "worst error of θ, relative to the swing")
    axes.axhspan(LEAST, 2.0**-52, color="#f6efe9", zorder=0)
    axes.annotate(
        "the last digit of a double",
        (0.6, 2.0**-53),
        xycoords=("axes fraction", "data"),
        ha="center",
        va="center",
        color="#7a6654",
        fontsize=8,
    )
    for name, found in points(records).items():
        color, marker, _ = FAMILIES[name]
        line = "-" if name in ("heyoka", "DOP853", "odeint", "mpmath") else ""
        ours = name == "libration"
        size = 10 if ours else 5
        axes.plot(*zip(*found, strict=True), line, color=color, marker=marker, markersize=size, linewidth=1, mew=0)
        across, up, side = PLACES[name]
        last = max(found) if name in ("DOP853", "odeint") else found[len(found) // 2 if name == "heyoka" else 0]
        text = {"θ₀ cos": "θ₀ cos ω₀t in NumPy", "SciPy": "SciPy recipe"}.get(name, name)
        weight = "bold" if ours else "normal"
        axes.annotate(text, last, (across, up), textcoords="offset points", ha=side, color=color, fontweight=weight)
    axes.set_ylim(LEAST, 1e3)
    return figure


def lines(records: list[dict], over: str, value) -> dict[str, list[tuple[float, float]]]:
    """A line for each family: its first method with an entry, or its fastest, over `count` or `periods`."""
    found: dict[str, dict[float, float]] = {}
    for record in records:
        if record["method"] in (FRESH.name, MOTION.name) or not record["seconds"]:
            continue
        here = found.setdefault(family(record["method"]), {})
        y = value(record)
        if math.isfinite(y):
            here[record[over]] = min(y, here.get(record[over], math.inf))
    return {name: sorted(line.items()) for name, line in found.items()}


def growth(sizes: list[dict], horizons: list[dict]) -> Figure:
    """Time against samples, time against the horizon, error against the horizon."""
    figure = Figure(figsize=(12.6, 4.6), layout="constrained")
    left, middle, right = figure.subplots(1, 3)
    quiet(left, "samples, over ten periods", "seconds per call")
    quiet(middle, "periods", "nanoseconds per sample, 10⁴ samples")
    quiet(right, "periods", "worst error of θ")
    right.axhspan(LEAST, 2.0**-52, color="#f6efe9", zorder=0)
    right.set_ylim(LEAST, 1)

    def seconds(record):
        return statistics.median(record["seconds"])

    def each(record):
        return seconds(record) / record["count"] * 1e9

    def worst(record):
        return max(float(record["errors"][0]), LEAST)

    for axes, records, over, value in (
        (left, sizes, "count", seconds),
        (middle, horizons, "periods", each),
        (right, horizons, "periods", worst),
    ):
        drawn = lines(records, over, value)
        axes.margins(y=0.08)
        for name, line in drawn.items():
            color, marker, dash = FAMILIES[name]
            look = {"linewidth": 2.4, "zorder": 3} if name == "libration" else {"linewidth": 1.1}
            axes.plot(*zip(*line, strict=True), dash, color=color, marker=marker, markersize=4, mew=0, **look)
        named_at_ends(axes, {name: line[-1] for name, line in drawn.items()})
    return figure


def named_at_ends(axes, ends: dict[str, tuple[float, float]]) -> None:
    """Names at the last points: beyond the end of the axis apart from each other, within it above their points."""
    left, right = (math.log(limit) for limit in axes.get_xlim())
    ticks = [tick for tick in axes.get_xticks() if left <= math.log(tick) <= right]
    # The room of the longest name beyond the last point of all.
    axes.set_xlim(math.exp(left), math.exp(right + ROOM * (right - left)))
    axes.set_xticks(ticks)
    low, high = (math.log(limit) for limit in axes.get_ylim())
    apart = (high - low) / 21
    furthest = max(x for x, _ in ends.values())
    outer = {name: math.log(y) for name, (x, y) in ends.items() if x == furthest}
    for _ in range(500):
        for pair in itertools.combinations(outer, 2):
            below, above = sorted(pair, key=outer.get)
            push = max(0.0, apart - (outer[above] - outer[below]))
            outer[below] -= push / 2
            outer[above] += push / 2
    gap = math.exp(0.05 * (right - left))
    for name, (x, y) in ends.items():
        color = FAMILIES[name][0]
        style = {"color": color, "fontsize": 8, "fontweight": "bold" if name == "libration" else "normal"}
        text = {"θ₀ cos": "θ₀ cos ω₀t"}.get(name, name)
        if name in outer:
            if abs(outer[name] - math.log(y)) > apart / 3:
                axes.plot([x * gap**0.3, x * gap * 0.97], [y, math.exp(outer[name])], color=color, linewidth=0.6)
            axes.annotate(text, (x * gap, math.exp(outer[name])), va="center", **style)
            continue
        # Where another point is just above, the name stands beside its own.
        crowded = any(x == other_x and 0 < math.log(other_y / y) < 2 * apart for other_x, other_y in ends.values())
        place, sides = ((7, 0), ("left", "center")) if crowded else ((0, 5), ("center", "bottom"))
        axes.annotate(text, (x, y), place, textcoords="offset points", ha=sides[0], va=sides[1], **style)


def draw(held: dict[str, dict], folder: Path) -> None:
    """Write benchmarks-error and benchmarks-growth as SVG and PNG."""
    with matplotlib.rc_context(STYLE):
        figures = {
            "benchmarks-error": error_against_time(held["digits"]["records"]),
            "benchmarks-growth": growth(held["sizes"]["records"], held["horizons"]["records"]),
        }
        for name, figure in figures.items():
            save_as(figure, folder / f"{name}.svg", "svg", {})
            figure.savefig(folder / f"{name}.png", dpi=160)
