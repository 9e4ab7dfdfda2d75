"""Results for people, in aligned lines of fifteen digits if none were chosen."""

import math
import shutil
from collections.abc import Sequence
from typing import TYPE_CHECKING

from libration.cli.language import Told, told
from libration.cli.style import PLAIN, NumberStyle

if TYPE_CHECKING:
    from libration import Pendulum


def print_lines(pairs: Sequence[tuple[str, str]]) -> None:
    """Print labels and texts in two columns."""
    lines = [(told(label), told(text)) for label, text in pairs]
    width = max((len(label) for label, _ in lines), default=0)
    for label, text in lines:
        print(f"{label:{width}}  {text}")


def print_table(heads: Sequence[str], rows: Sequence[Sequence[str]], left: Sequence[int] = ()) -> None:
    """Print columns below their heads, right-aligned but for those at `left`.

    What does not fit on the screen stands in blocks below, each with the first column.
    """
    table = [[in_words(head) for head in heads], *map(list, rows)]
    widths = [max(len(row[column]) for row in table) for column in range(len(heads))]
    width = shutil.get_terminal_size((100, 24)).columns
    block = [0]
    blocks = [block]
    for column in range(1, len(heads)):
        if len(block) > 1 and sum(widths[each] + 2 for each in [*block, column]) - 2 > width and not left:
            block = [0]
            blocks.append(block)
        block.append(column)
    for number, block in enumerate(blocks):
        print("\n" * (number > 0), end="")
        for row in table:
            cells = (row[each].ljust(widths[each]) if each in left else row[each].rjust(widths[each]) for each in block)
            print("  ".join(cells).rstrip())


def in_words(head: str) -> str:
    """The head of a column in the language, with its unit."""
    if isinstance(head, Told):
        return head
    name, bracket, unit = head.partition(" [")
    return f"{told(name)}{bracket}{unit}"


def digits(value: float, style: NumberStyle = PLAIN) -> str:
    """Fifteen significant digits, if none were chosen: every decimal number of fifteen digits has its own double."""
    return style.shown(value, 15)


def period_text(motion: "Pendulum", style: NumberStyle) -> str:
    """The period in words."""
    if math.isinf(motion.period):
        return told("infinite")
    meaning = {"rest": " (of small swings)", "rotation": " (one turn)"}.get(str(motion.regime), "")
    return f"{digits(motion.period, style)} s{told(meaning)}"


def angle_text(motion: "Pendulum", style: NumberStyle) -> str:
    """The turning angle in radians and degrees."""
    if math.isnan(motion.theta_max):
        return told("none, it turns over the top")
    reached = " (approached, never reached)" if motion.regime == "separatrix" else ""
    # Below 0 all other angles are counted from the top.
    bottom = " from the bottom" if motion.omega2 < 0 else ""
    shown = style.shown(math.degrees(motion.theta_max), 8)
    return f"{digits(motion.theta_max, style)} rad = {shown} deg{told(bottom)}{told(reached)}"
