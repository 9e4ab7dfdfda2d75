"""Numbers and tables as the pages print them."""


def number(value: float) -> str:
    """Three digits, in plain notation with commas between thousands."""
    if value >= 1e6 or 0 < value < 1e-3:
        return f"{value:.2g}".replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def error(value: float | str) -> str:
    """A worst error as the page prints it."""
    value = float(value)
    return f"{value:.0e}".replace("e+0", "e").replace("e-0", "e-").replace("e+", "e") if value < float("inf") else "inf"


def table(head: list[str], body: list[list[str]], words: tuple[int, ...] = (0,)) -> str:
    """A table of a page; columns of `words` to the left, numbers to the right."""
    rule = ["---" if place in words else "---:" for place in range(len(head))]
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, rule, *body])
