"""The help on a narrow screen: texts with fixed line breaks are wrapped again when they do not fit."""

import argparse
import re
import textwrap
from collections.abc import Iterable


class Formatter(argparse.RawDescriptionHelpFormatter):
    """Keeps the line breaks of a text if they fit on the screen, and wraps the text again if not."""

    def add_usage(
        self,
        usage: str | None,
        actions: Iterable[argparse.Action],
        groups: "Iterable[argparse._MutuallyExclusiveGroup]",
        prefix: str | None = None,
    ) -> None:
        """The usage, in lines that fit after `usage: `."""
        if usage is not None and len(usage) + len("usage: ") > self._width:
            usage = "\n".join(wrapped(usage, max(self._width - len("usage: "), 20), "  "))
        super().add_usage(usage, actions, groups, prefix)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        if all(len(line) <= width for line in text.splitlines()):
            return super()._fill_text(text, width, indent)
        return "\n".join(indent + line for line in refilled(text, width))


def refilled(text: str, width: int) -> list[str]:
    """The lines of a text, no longer than `width`: paragraphs are refilled, tables and commands wrapped line by line."""
    lines: list[str] = []
    for paragraph in paragraphs(text):
        start = paragraph[: len(paragraph) - len(paragraph.lstrip())]
        if is_command(paragraph):
            # After a backslash the command continues, so it can still be copied.
            first, *others = wrapped(paragraph, width - 2, start + "  ")
            lines += [" \\\n".join([first, *others])]
        else:
            lines += wrapped(paragraph, width, start + " " * second_column(paragraph[len(start) :])) or [""]
    return "\n".join(lines).splitlines()


def paragraphs(text: str) -> list[str]:
    """The lines of a text, joined where one continues in the next: same indent, and neither a table nor a command."""
    out: list[str] = []
    for line in text.splitlines():
        continues = out and flows(out[-1]) and flows(line) and not out[-1].endswith(":")
        if continues and indent_of(out[-1]) == indent_of(line):
            out[-1] += f" {line.strip()}"
        else:
            out.append(line)
    return out


def second_column(line: str) -> int:
    """Where the text of a table's line begins, after its first gap; 0 for a paragraph."""
    gap = re.search(r"\S( {2,})\S", line)
    return gap.end(1) if gap else 0


def flows(line: str) -> bool:
    """Whether a line is part of a paragraph."""
    return bool(line.strip()) and "  " not in line.strip() and not is_command(line)


def is_command(line: str) -> bool:
    """Whether a line is an example to be copied."""
    return line.lstrip().startswith("libration ")


def indent_of(line: str) -> int:
    """How many blanks a line begins with."""
    return len(line) - len(line.lstrip())


def wrapped(text: str, width: int, indent: str) -> list[str]:
    """One text in lines no longer than `width`, words whole; the lines after the first begin with `indent`."""
    return textwrap.wrap(
        text, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False, expand_tabs=False
    )
