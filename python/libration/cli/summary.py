"""Results for people, in aligned lines of fifteen digits."""

import math


def print_lines(pairs):
    """Print labels and texts in two columns."""
    width = max(len(label) for label, _ in pairs)
    for label, text in pairs:
        print(f"{label:{width}}  {text}")


def digits(value):
    """Fifteen significant digits: what a double is sure to hold in decimal."""
    return f"{value:.15g}"


def period_text(regime, period):
    """The period in words."""
    if math.isinf(period):
        return "infinite"
    meaning = {"rest": " (of small swings)", "rotation": " (one turn)"}.get(regime, "")
    return f"{digits(period)} s{meaning}"


def angle_text(regime, theta_max):
    """The turning angle in radians and degrees."""
    if math.isnan(theta_max):
        return "none, it turns over the top"
    degrees = math.degrees(theta_max)
    reached = " (approached, never reached)" if regime == "separatrix" else ""
    return f"{digits(theta_max)} rad = {degrees:.8g} deg{reached}"
