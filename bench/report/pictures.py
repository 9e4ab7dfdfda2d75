"""The pictures of docs/benchmarks.md: error against time for every method, and how cost and error grow.

Made with matplotlib's Figure alone. Names are written at the points, without a legend; libration has the one strong colour.
"""

import itertools
import math
import statistics
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure
from rivals.ours import FRESH, MOTION

OURS = "#b5341f"
COLOURS = {
    "libration": OURS,
    "θ₀ cos": "#8a8a8a",
    "SciPy": "#20639b",
    "GSL": "#3c8d5a",
    "Boost": "#7b5ea7",
    "elliptic-functions": "#c08a2d",
    "mpmath": "#5b5b5b",
    "heyoka": "#2a9d9d",
    "DOP853": "#9c5a3c",
    "odeint": "#c2698b",
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
}
LEAST = 3e-17


def family(method: str) -> str:
    """The rival to which a method belongs."""
    return next(name for name in COLOURS if method.startswith(name))


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
    "θ₀ cos": (8, -3, "left"),
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
        color="#9a8877",
        fontsize=8,
    )
    for name, found in points(records).items():
        line = "-" if name in ("heyoka", "DOP853", "odeint", "mpmath") else ""
        ours = name == "libration"
        size = 9 if ours else 4
        axes.plot(*zip(*found, strict=True), line, color=COLOURS[name], marker="o", markersize=size, linewidth=1)
        across, up, side = PLACES[name]
        last = max(found) if name in ("DOP853", "odeint") else found[len(found) // 2 if name == "heyoka" else 0]
        text = {"θ₀ cos": "θ₀ cos ω₀t in NumPy", "SciPy": "SciPy recipe"}.get(name, name)
        weight = "bold" if ours else "normal"
        axes.annotate(
            text, last, (across, up), textcoords="offset points", ha=side, color=COLOURS[name], fontweight=weight
        )
    axes.set_ylim(LEAST, 300)
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
    figure = Figure(figsize=(10.4, 3.9), layout="constrained")
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
        for name, line in drawn.items():
            width = 2.2 if name == "libration" else 1
            axes.plot(*zip(*line, strict=True), color=COLOURS[name], marker="o", markersize=2.5, linewidth=width)
        named_at_ends(axes, {name: line[-1] for name, line in drawn.items()})
    return figure


def named_at_ends(axes, ends: dict[str, tuple[float, float]]) -> None:
    """Names to the right of the last points; names that would overlap are moved apart."""
    low, high = (math.log(limit) for limit in axes.get_ylim())
    apart = (high - low) / 22
    places = {name: math.log(y) for name, (_, y) in ends.items()}
    touching = [(a, b) for a, b in itertools.combinations(ends, 2) if abs(math.log(ends[a][0] / ends[b][0])) < 4]
    for _ in range(500):
        for pair in touching:
            below, above = sorted(pair, key=places.get)
            push = max(0.0, apart - (places[above] - places[below]))
            places[below] -= push / 2
            places[above] += push / 2
    for name, place in places.items():
        text = {"elliptic-functions": "elliptic-f.", "θ₀ cos": "θ₀ cos ω₀t"}.get(name, name)
        axes.annotate(
            text,
            (ends[name][0], math.exp(place)),
            (5, 0),
            textcoords="offset points",
            va="center",
            color=COLOURS[name],
            fontsize=7.5,
            fontweight="bold" if name == "libration" else "normal",
            annotation_clip=False,
        )


def draw(held: dict[str, dict], folder: Path) -> None:
    """Write benchmarks-error and benchmarks-growth as SVG and PNG."""
    with matplotlib.rc_context(STYLE):
        figures = {
            "benchmarks-error": error_against_time(held["digits"]["records"]),
            "benchmarks-growth": growth(held["sizes"]["records"], held["horizons"]["records"]),
        }
        for name, figure in figures.items():
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
            figure.savefig(folder / f"{name}.png", dpi=160)
