"""The directive `commands`: a section for every command of `libration`, with what its `--help` prints."""

import os
import subprocess
import sys

from docutils import nodes
from docutils.parsers.rst import Directive
from sphinx.application import Sphinx


def help_of(*words: str) -> str:
    """What `libration WORDS --help` prints, in lines that fit on a page."""
    command = [sys.executable, "-m", "libration", *words, "--help"]
    run = subprocess.run(
        command, env={**os.environ, "COLUMNS": "88", "LC_ALL": "C.UTF-8"}, capture_output=True, text=True, check=True
    )
    return run.stdout.rstrip()


class Commands(Directive):
    """The commands in the order of `libration --help`."""

    def run(self) -> list[nodes.Node]:
        from libration.cli.top import COMMANDS

        shown = [nodes.literal_block("", help_of(), language="none")]
        for name in COMMANDS:
            section = nodes.section("", nodes.title("", f"libration {name}"), ids=[f"libration-{name}"])
            section += nodes.literal_block("", help_of(name), language="none")
            shown.append(section)
        return shown


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("commands", Commands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
