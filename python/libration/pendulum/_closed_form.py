"""The solution of one pendulum as a line of text with its numbers, in the form of its regime.

Numbers have six digits; of a modulus or a parameter next to 1 its distance from 1 has them, since the period depends on
that. Source: Landau & Lifshitz, Mechanics, section 11; DLMF 22.19(i), 4.23.42 (Gudermann's function).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .._number_text import number_text
from ..elliptic import incomplete_f

if TYPE_CHECKING:
    from ._constants import Constants

DIGITS = 6
# A complement below this is written as such, `1 − 2×10⁻¹²`.
NEXT_TO_ONE = 1e-9


def closed_form(pendulum: Constants) -> str | None:
    """theta(t) in one line, t in s and the angle in rad; None where a number is beyond the doubles."""
    numbers = (pendulum.theta0, pendulum.velocity0, pendulum.omega0)
    if pendulum.omega0 == 0:
        return f"θ(t) = {linear(pendulum.velocity0, pendulum.theta0)}"
    if not all(math.isfinite(each) for each in (*numbers, pendulum.energy_ratio, pendulum.velocity0 / pendulum.omega0)):
        return None
    regime = str(pendulum.regime)
    if regime == "rest" or (regime == "separatrix" and pendulum.velocity0 == 0):
        return f"θ(t) = {number_text(pendulum.theta0)}"
    half_turns, angle = bottom(pendulum)
    sign, form = {"libration": libration, "rotation": rotation, "separatrix": separatrix}[regime](pendulum, angle)
    if half_turns:
        return form and f"θ(t) = {multiple_of_pi(half_turns)} {sign} {form}"
    return form and f"θ(t) = {sign if sign == '−' else ''}{form}"


def libration(pendulum: Constants, angle: float) -> tuple[str, str | None]:
    """2 arcsin(k sn(omega0 t + u0 | m)); the phase at the start is even in time, so it gives u0."""
    m, mc = pendulum.energy_ratio, pendulum.energy_ratio_c
    k = math.sqrt(m)
    # A quarter of the period holds K of the argument, and pi/2 of the phase.
    u0 = pendulum._orbit.phase(0.0) * pendulum.period * pendulum.omega0 / math.tau
    if not math.isfinite(u0) or k == 0:
        return "+", None
    modulus, parameter = next_to_one(k, mc / (1 + k)), next_to_one(m, mc)
    factor = f"({modulus})" if "−" in modulus.partition("×")[0] else modulus
    return "+", f"2 arcsin({factor} sn({linear(pendulum.omega0, u0)} | {parameter}))"


def rotation(pendulum: Constants, angle: float) -> tuple[str, str | None]:
    """Plus or minus 2 am(kappa omega0 t + u0 | 1/kappa**2)."""
    ratio = pendulum.energy_ratio
    sign, rate = math.copysign(1.0, pendulum.velocity0), math.sqrt(ratio) * pendulum.omega0
    m, mc = 1 / ratio, -pendulum.energy_ratio_c / ratio
    u0 = float(incomplete_f(sign * angle / 2, mc=mc) if mc < 0.5 else incomplete_f(sign * angle / 2, m=m))
    if not math.isfinite(rate) or not math.isfinite(u0):
        return "+", None
    return "+" if sign > 0 else "−", f"2 am({linear(rate, u0)} | {next_to_one(m, mc)})"


def separatrix(pendulum: Constants, angle: float) -> tuple[str, str | None]:
    """Plus or minus 2 gd(omega0 t + u0), the gudermannian written as arctan(sinh)."""
    sign = math.copysign(1.0, pendulum.velocity0)
    u0 = math.asinh(math.tan(sign * angle / 2))
    return "+" if sign > 0 else "−", f"2 arctan(sinh({linear(pendulum.omega0, u0)}))"


def bottom(pendulum: Constants) -> tuple[int, float]:
    """The lowest point next to the start, in half turns, and the angle at the start from there."""
    if pendulum.regime == "libration":
        half_turns = round(sum(pendulum.extremes) / 2 / math.pi)
        return half_turns, pendulum.theta0 - half_turns * math.pi
    turns, angle = pendulum._orbit.turns(0.0)
    if pendulum.omega2 > 0:
        return 2 * int(turns), float(angle)
    return 2 * int(turns) + (1 if angle >= 0 else -1), float(angle - math.copysign(math.pi, angle))


def multiple_of_pi(half_turns: int) -> str:
    """`2π`, `−π`."""
    front = {1: "", -1: "−"}.get(half_turns, f"{half_turns}".replace("-", "−"))
    return f"{front}π"


def linear(rate: float, start: float) -> str:
    """`3.1305 t + 0.5`, without what is 0."""
    if rate == 0:
        return number_text(start)
    front = {"1": "", "−1": "−"}.get(number_text(rate), f"{number_text(rate)} ")
    if start == 0:
        return f"{front}t"
    return f"{front}t {'−' if start < 0 else '+'} {number_text(abs(start))}"


def next_to_one(value: float, complement: float) -> str:
    """A number of at most 1, with the digits of its distance from 1."""
    if complement > 0.1:
        return number_text(value)
    if complement < NEXT_TO_ONE:
        return f"1 − {number_text(complement)}"
    return f"{1 - complement:.{DIGITS - 1 - math.floor(math.log10(complement))}f}".rstrip("0")
