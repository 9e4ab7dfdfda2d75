"""The help on a narrow screen: texts that are laid out by hand are wrapped anew when they do not fit."""

import argparse
import re
import textwrap


class Formatter(argparse.RawDescriptionHelpFormatter):
    """Keeps texts as they are laid out where the screen has the room, and wraps them where it has not."""

    def add_usage(self, usage, actions, groups, prefix=None):
        """The usage, in lines that fit behind `usage: `."""
        if usage is not None and len(usage) + len("usage: ") > self._width:
            usage = "\n".join(wrapped(usage, max(self._width - len("usage: "), 20), "  "))
        super().add_usage(usage, actions, groups, prefix)

    def _fill_text(self, text, width, indent):
        if all(len(line) <= width for line in text.splitlines()):
            return super()._fill_text(text, width, indent)
        return "\n".join(indent + line for line in refilled(text, width))


def refilled(text, width):
    """The lines of a text, no longer than `width`: paragraphs filled anew, tables and commands line by line."""
    lines = []
    for paragraph in paragraphs(text):
        start = paragraph[: len(paragraph) - len(paragraph.lstrip())]
        if is_command(paragraph):
            # Behind a backslash the shell goes on, so the command can still be copied.
            first, *others = wrapped(paragraph, width - 2, start + "  ")
            lines += [" \\\n".join([first, *others])]
        else:
            lines += wrapped(paragraph, width, start + " " * second_column(paragraph[len(start) :])) or [""]
    return "\n".join(lines).splitlines()


def paragraphs(text):
    """The lines of a text, joined where one goes on in the next: same indent, and neither a table nor a command."""
    out = []
    for line in text.splitlines():
        goes_on = out and flows(out[-1]) and flows(line) and not out[-1].endswith(":")
        if goes_on and indent_of(out[-1]) == indent_of(line):
            out[-1] += f" {line.strip()}"
        else:
            out.append(line)
    return out


def second_column(line):
    """Where the text of a table's line begins, behind its first gap; 0 for a paragraph."""
    gap = re.search(r"\S( {2,})\S", line)
    return gap.end(1) if gap else 0


def flows(line):
    """Whether a line is part of a paragraph."""
    return bool(line.strip()) and "  " not in line.strip() and not is_command(line)


def is_command(line):
    """Whether a line is an example to be copied."""
    return line.lstrip().startswith("libration ")


def indent_of(line):
    """How far a line is set in."""
    return len(line) - len(line.lstrip())


def wrapped(text, width, indent):
    """One text in lines no longer than `width`, words whole; the lines after the first set in by `indent`."""
    return textwrap.wrap(
        text, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False, expand_tabs=False
    )
