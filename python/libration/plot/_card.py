"""What a notebook shows of a pendulum: a drawing as SVG, its regime and period, and its closed form with the numbers.

Made without matplotlib. Everything has the colour of the text around it, so that it stands on light and dark pages; on a
narrow page the words go below the drawing.
"""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

from .._number_text import number_text as number
from ..pendulum._closed_form import closed_form
from ._angle import degrees_text
from ._language import ENGLISH

if TYPE_CHECKING:
    from ..pendulum._constants import Constants

# The drawing is a square of this side, the pivot in its middle.
SIDE, ROD, BOB = 160.0, 56.0, 8.0
# Up to this angle the upper half stays empty; from this one on the arc has no end that could be seen.
LOW, ALL_ROUND = 1.4, 3.1
PAGE = "display:flex;flex-wrap:wrap;gap:4px 18px;align-items:center;max-width:46em;line-height:1.5"
FORM = "font-family:'DejaVu Serif',Cambria,Georgia,serif;overflow-wrap:anywhere;margin-top:4px"


def card(pendulum: Constants) -> str:
    """The HTML of a pendulum."""
    form = closed_form(pendulum)
    return page(drawing(pendulum), [heading(pendulum), *facts(pendulum)], kept_together(form) if form else "")


def page(picture: str, lines: list[str], form: str = "") -> str:
    """A drawing beside lines of text, the first of them bold, and a formula."""
    first, *others = lines
    text = "".join(f"<div>{line}</div>" for line in (f"<b>{first}</b>", *others))
    last = f'<div style="{FORM}">{form}</div>' if form else ""
    return f'<div style="{PAGE}">{picture}<div style="flex:1 1 16em;min-width:0">{text}{last}</div></div>'


def heading(pendulum: Constants) -> str:
    """The kind of motion."""
    words = {
        "rest": "Pendulum at rest",
        "libration": "Pendulum in libration",
        "separatrix": "Pendulum on the separatrix",
        "rotation": "Pendulum in rotation",
    }
    return words[str(pendulum.regime)]


def facts(pendulum: Constants) -> list[str]:
    """State, period and turning angle, a line each."""
    state = f"θ₀ = {number(pendulum.theta0)} rad"
    if pendulum.velocity0:
        state += f", θ̇₀ = {number(pendulum.velocity0)} rad/s"
    regime = str(pendulum.regime)
    told = {
        "rest": f"small swings would take {number(pendulum.period)} s" if pendulum.omega0 else "no force",
        "libration": f"period {number(pendulum.period)} s",
        "separatrix": "period infinite: the top is approached and never reached",
        "rotation": f"one turn in {number(pendulum.period)} s"
        if math.isfinite(pendulum.period)
        else "one turn takes more than 1.8×10³⁰⁸ s",
    }[regime]
    if regime == "separatrix" and pendulum.velocity0 == 0:
        told = "balanced at the top"
    if regime == "libration":
        turning = degrees_text(pendulum.theta_max, pendulum, ENGLISH)
        told += f", turning angle {turning}" + (" from π" if pendulum.omega2 < 0 else "")
    square = "ω₀² = −" if pendulum.omega2 < 0 else "ω₀ = "
    rate = number(abs(pendulum.omega2)) if pendulum.omega2 < 0 else number(pendulum.omega0)
    unit = "s⁻²" if pendulum.omega2 < 0 else "s⁻¹"
    return [f"{state}, {square}{rate} {unit}", told]


def kept_together(form: str) -> str:
    """The closed form; on a narrow page a line breaks before sn, and before the parameter."""
    together = escape(form).replace(" ", "\u00a0")
    return together.replace("\u00a0sn(", " sn(").replace("|\u00a0", "| ")


def drawing(pendulum: Constants) -> str:
    """The pendulum at its start, with the arc of its swing and the direction of its velocity."""
    middle = SIDE / 2
    # Below 0 the pendulum hangs from the other side: pi is at the bottom.
    angle = pendulum.theta0 - (math.pi if pendulum.omega2 < 0 else 0.0)
    x, y = place(angle)
    parts = [
        f'<path d="M{middle:g} {middle:g}v{ROD + 14:g}" stroke-dasharray="3 4" opacity=".45"/>',
        swing(pendulum),
        f'<path d="M{middle:g} {middle:g}L{x:.2f} {y:.2f}" stroke-width="2.4"/>',
        arrow(pendulum, angle),
        f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{BOB:g}" fill="currentColor"/>',
        f'<circle cx="{middle:g}" cy="{middle:g}" r="3.2" fill="currentColor"/>',
    ]
    # The upper half is left out where the bob does not get there.
    top = 0.0 if widest(pendulum, angle) > LOW else middle - 16
    return svg(top, SIDE, f"{heading(pendulum)}, drawn at its start", parts)


def svg(top: float, bottom: float, said: str, parts: list[str]) -> str:
    """A drawing of the width of `SIDE` in the colour of the text; `said` is read out in its place."""
    box = f'viewBox="0 {top:g} {SIDE:g} {bottom - top:g}" width="{SIDE:g}" height="{bottom - top:g}"'
    line = 'fill="none" stroke="currentColor" stroke-width="1.4" stroke-linecap="round" stroke-linejoin="round"'
    name = f'role="img" aria-label="{said}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {box} {name} {line} style="flex:none">{"".join(parts)}</svg>'


def place(angle: float, radius: float = ROD) -> tuple[float, float]:
    """The point at an angle from the vertical below the pivot."""
    return SIDE / 2 + radius * math.sin(angle), SIDE / 2 + radius * math.cos(angle)


def widest(pendulum: Constants, angle: float) -> float:
    """The largest angle from the bottom that is drawn."""
    if str(pendulum.regime) == "rotation":
        return math.pi
    return max(abs(math.remainder(angle, math.tau)), pendulum.theta_max)


def swing(pendulum: Constants) -> str:
    """The path of the bob: the arc between the turning angles, or the whole circle."""
    soft = 'stroke-width="1.4" stroke-dasharray="1 4" opacity=".8"'
    if str(pendulum.regime) == "rest" or (str(pendulum.regime) == "separatrix" and not pendulum.velocity0):
        return ""
    if not pendulum.theta_max < ALL_ROUND:
        return f'<circle cx="{SIDE / 2:g}" cy="{SIDE / 2:g}" r="{ROD:g}" {soft}/>'
    (x, y), (right, bottom) = place(-pendulum.theta_max), place(pendulum.theta_max)
    large = int(pendulum.theta_max > math.pi / 2)
    ends = "".join(tick(sign * pendulum.theta_max) for sign in (-1, 1))
    return f'<path d="M{x:.2f} {y:.2f}A{ROD:g} {ROD:g} 0 {large} 0 {right:.2f} {bottom:.2f}" {soft}/>{ends}'


def tick(angle: float) -> str:
    """A short line across the path at a turning angle."""
    (x, y), (to_x, to_y) = place(angle, ROD - 6), place(angle, ROD + 6)
    return f'<path d="M{x:.2f} {y:.2f}L{to_x:.2f} {to_y:.2f}" stroke-width="1" opacity=".6"/>'


def arrow(pendulum: Constants, angle: float) -> str:
    """The direction of the velocity at the start, along the path."""
    if not pendulum.velocity0:
        return ""
    forward = math.copysign(1.0, pendulum.velocity0)
    reach = 0.62
    (x, y), (tip_x, tip_y) = place(angle + forward * 0.2, ROD + 14), place(angle + forward * reach, ROD + 14)
    # The barbs point back along the arc.
    barbs = [place(angle + forward * (reach - 0.12), ROD + 14 + side) for side in (-5, 5)]
    (left_x, left_y), (right_x, right_y) = barbs
    sweep = 0 if forward > 0 else 1
    radius = ROD + 14
    return (
        f'<path d="M{x:.2f} {y:.2f}A{radius:g} {radius:g} 0 0 {sweep} {tip_x:.2f} {tip_y:.2f}'
        f'M{left_x:.2f} {left_y:.2f}L{tip_x:.2f} {tip_y:.2f}L{right_x:.2f} {right_y:.2f}"/>'
    )
