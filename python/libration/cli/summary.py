"""Results for people, in aligned lines of fifteen digits."""

import math
from collections.abc import Sequence


def print_lines(pairs: Sequence[tuple[str, str]]) -> None:
    """Print labels and texts in two columns."""
    width = max(len(label) for label, _ in pairs)
    for label, text in pairs:
        print(f"{label:{width}}  {text}")


def digits(value: float) -> str:
    """Fifteen significant digits: every decimal number of fifteen digits has its own double."""
    return f"{value:.15g}"


def period_text(regime: str, period: float) -> str:
    """The period in words."""
    if math.isinf(period):
        return "infinite"
    meaning = {"rest": " (of small swings)", "rotation": " (one turn)"}.get(regime, "")
    return f"{digits(period)} s{meaning}"


def angle_text(regime: str, theta_max: float) -> str:
    """The turning angle in radians and degrees."""
    if math.isnan(theta_max):
        return "none, it turns over the top"
    degrees = math.degrees(theta_max)
    reached = " (approached, never reached)" if regime == "separatrix" else ""
    return f"{digits(theta_max)} rad = {degrees:.8g} deg{reached}"
