"""The pages of `--help`: options by groups, topics and examples, on any width of the screen.

Words are never broken, neither at hyphens nor by length, and a long example ends its lines with a backslash, so what
is read can be copied.
"""

import re
import shutil
import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import click

from libration.cli.language import told

NARROWEST, WIDEST = 40, 92
# A blank at which no line is broken.
NO_BREAK = "\u00a0"

# A command line that runs.
Example: TypeAlias = str


@dataclass(frozen=True)
class Topic:
    """A part of a page: its title, rows of a term and its meaning, and a text in paragraphs."""

    title: str
    rows: Sequence[tuple[str, str]] = ()
    text: str = ""


class Formatter(click.HelpFormatter):
    """Writes a page as wide as the screen, from 40 to 92 characters."""

    def __init__(self, indent_increment: int = 2, width: int | None = None, max_width: int | None = None) -> None:
        columns = shutil.get_terminal_size().columns
        super().__init__(indent_increment, width or max(NARROWEST, min(columns, max_width or WIDEST)))

    def filled(self, text: str, first: str, others: str) -> None:
        """One paragraph in lines that fit."""
        lines = textwrap.wrap(
            text,
            self.width,
            initial_indent=first,
            subsequent_indent=others,
            break_long_words=False,
            break_on_hyphens=False,
        )
        self.write("\n".join(lines).replace(NO_BREAK, " ") + "\n")

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        """The usage, in lines that begin below the first word after the prefix."""
        first = f"{prefix or 'usage: '}{prog}"
        self.filled(args, first, " " * len(first))

    def write_text(self, text: str) -> None:
        """Paragraphs, one below the other after a blank line."""
        indent = " " * self.current_indent
        for number, paragraph in enumerate(text.strip().split("\n\n")):
            self.write("\n" * (number > 0))
            self.filled(told(" ".join(paragraph.split())), indent, indent)

    def write_dl(self, rows: Iterable[tuple[str, str]], col_max: int = 24, col_spacing: int = 2) -> None:
        """Terms with their meanings in a second column; a long term has a line of its own."""
        rows = list(rows)
        limit = min(col_max, self.width * 2 // 5)
        column = self.current_indent + min(max(len(term) for term, _ in rows), limit) + col_spacing
        for term, meaning in rows:
            first = " " * self.current_indent + term.rstrip()
            if len(first) + col_spacing > column:
                self.write(f"{first}\n")
                first = ""
            self.filled(told(meaning), f"{first:{column}}", " " * column)

    def write_topics(self, topics: Iterable[Topic]) -> None:
        """Each topic below its title."""
        for topic in topics:
            with self.section(told(topic.title)):
                if topic.rows:
                    self.write_dl(topic.rows)
                if topic.text:
                    self.write("\n" * bool(topic.rows))
                    self.write_text(topic.text)

    def write_examples(self, examples: Iterable[Example]) -> None:
        """Commands to copy: a line that goes on ends with a backslash."""
        with self.section(told("examples")):
            for example in examples:
                words = re.sub(r"--\S+ (?!--)\S+", lambda found: together(found[0], self.width - 6), example)
                lines = textwrap.wrap(
                    words, self.width - 4, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False
                )
                self.write("  " + " \\\n  ".join(lines).replace(NO_BREAK, " ") + "\n")


def together(text: str, width: int) -> str:
    """A text that is not parted between lines, if it fits on one."""
    return text.replace(" ", NO_BREAK) if len(text) <= width else text


class Context(click.Context):
    """The state of one call, with our pages."""

    formatter_class = Formatter
