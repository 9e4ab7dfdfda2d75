"""How every picture looks: colours, frame, legend, ticks, and the way it is saved.

matplotlib is needed only here (`pip install 'libration[plot]'`) and only its Figure is used: no pyplot, no global
state, no window.
"""

from typing import Any

import numpy as np

BLACK = "#1a1a1a"
DOTTED, DASHED = (0, (1, 1.4)), (0, (4.5, 3.2))
EXACT = "#1f5fa8"
LINEAR = "#8a8a8a"
SEPARATRIX = "#b5442e"
FAINT = "#d9d9d9"
# Of more than MANY swings or turns, only the first SHOWN are drawn over t.
MANY, SHOWN = 60, 20
# Instants are drawn as dots up to this number.
FEW = 60


def finite(t: Any) -> np.ndarray:
    """The finite instants among those given, at least one."""
    given = np.asarray(t, dtype=float).ravel()
    instants: np.ndarray = given[np.isfinite(given)]
    if not instants.size:
        raise ValueError("t = []: at least one finite instant is needed for a picture")
    return instants


def save(path: Any, form: str | None, title: Any, left: Any, right: Any) -> None:
    """Draw a panel over time beside a phase portrait, under one line, and save the picture."""

    def draw(figure: Any) -> None:
        panels = figure.subplots(1, 2, width_ratios=(1.35, 1))
        left(panels[0])
        right(panels[1])
        head(figure, title())

    save_figure({form: path}, (12, 5), draw)


def head(figure: Any, title: str) -> None:
    """The line above a picture."""
    figure.suptitle(title, x=0.012, ha="left", fontsize=13)


def save_figure(
    files: dict[Any, Any], size: tuple[float, float], draw: Any, *, dpi: int = 100, told: dict[str, str] | None = None
) -> None:
    """Draw a figure of a size in inches once, in the settings of the house, and save it in every form.

    `files` are paths or binary files by form; without one (None) the ending of the path says it. `told` is what a file
    says of itself.
    """
    from matplotlib import rc_context, rcParamsDefault
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    # Not those of a matplotlibrc, which may ask for LaTeX or hide a line; the salt makes the same file of the same picture.
    settings: Any = {name: value for name, value in rcParamsDefault.items() if name != "backend"}
    with rc_context(settings | {"svg.hashsalt": "libration"}):
        figure = Figure(figsize=size, dpi=dpi, layout="constrained")
        FigureCanvasAgg(figure)
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            draw(figure)
            for form, file in files.items():
                # A date would make another file of the same picture.
                stamp = {"Date": None} if is_svg(file, form) else {"Software": "libration"}
                figure.savefig(file, format=form, metadata=(told or {}) | stamp)


def is_svg(path: Any, form: str | None) -> bool:
    """Whether the picture is SVG."""
    return form == "svg" or (form is None and str(path).lower().endswith(".svg"))


def number(value: float, digits: int = 6) -> str:
    """A number with a real minus sign."""
    return f"{value:.{digits}g}".replace("-", "−")


def first_swings(first: float, last: float, scale: float) -> float:
    """Where the picture ends: more swings than it has room for would be a solid band."""
    return first + SHOWN * scale if last - first > MANY * scale else last


def part_of(unit: str, first: float, last: float, start: float, stop: float) -> str:
    """What an axis from `first` to `last` shows of the instants asked for, `start` to `stop`."""
    if last - first == stop - start:
        return unit
    which = "the first " if first == start else ""
    return f"{unit}, {which}{last - first:.3g} of {stop - start:.6g} s"


def quiet(axes: Any) -> None:
    """Thin grey frame on two sides, a light grid."""
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color("#777777")
    axes.tick_params(color="#777777")
    axes.grid(color="#f0f0f0", lw=0.8)
    axes.set_axisbelow(True)


def legend(axes: Any) -> None:
    """One line above the panel, clear of every curve."""
    axes.legend(
        loc="lower right",
        bbox_to_anchor=(1.01, 1.0),
        ncols=4,
        frameon=False,
        fontsize=9.5,
        handlelength=1.6,
        handletextpad=0.5,
        columnspacing=1.0,
    )


def angle_ticks(axis: Any, low: float, high: float) -> None:
    """Ticks at multiples of pi if the range spans some; else decimal radians."""
    from matplotlib.ticker import FuncFormatter, MultipleLocator

    steps = [0.25, 0.5] + [digit * 10.0**power for power in range(9) for digit in (1, 2, 5)]
    step = next((each for each in steps if (high - low) / np.pi <= 7 * each), None)
    if high - low < 2 or step is None:
        return
    axis.set_major_locator(MultipleLocator(step * np.pi))
    axis.set_major_formatter(FuncFormatter(pi_text))


def pi_text(value: float, _position: object = None) -> str:
    """`-π/2`, `0`, `3π`: a multiple of pi/4 in words."""
    quarters = round(4 * value / np.pi)
    whole, below = quarters, 4
    while below > 1 and whole % 2 == 0:
        whole, below = whole // 2, below // 2
    if whole == 0:
        return "0"
    front = {1: "", -1: "−"}.get(whole, f"{whole}".replace("-", "−"))
    return f"{front}π" + (f"/{below}" if below > 1 else "")
