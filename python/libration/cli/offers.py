"""What a shell offers for the beginning of a value: files, units, words, and the names of approximations."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import click

from libration.cli.quantities import Dimension, parts

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


def files(_ctx: click.Context, _parameter: click.Parameter, typed: str) -> "list[CompletionItem[str]]":
    """The files and directories, as the shell itself offers them."""
    from click.shell_completion import CompletionItem

    return [CompletionItem(typed, type="file")]


def folders(_ctx: click.Context, _parameter: click.Parameter, typed: str) -> "list[CompletionItem[str]]":
    """The directories, as the shell itself offers them."""
    from click.shell_completion import CompletionItem

    return [CompletionItem(typed, type="dir")]


def words(*known: str) -> "Callable[[click.Context, click.Parameter, str], list[str]]":
    """Some of the words, by their first letters, large or small."""

    def offered(_ctx: click.Context, _parameter: click.Parameter, typed: str) -> list[str]:
        return [word for word in known if word.lower().startswith(typed.lower())]

    return offered


def units(dimension: Dimension) -> "Callable[[click.Context, click.Parameter, str], list[str]]":
    """The number typed with each unit that goes on as typed; in a list the last number."""

    def offered(_ctx: click.Context, _parameter: click.Parameter, typed: str) -> list[str]:
        number, unit = parts(typed.replace(";", ",").rpartition(",")[2])
        if number is None:
            return []
        return [typed[: len(typed) - len(unit)] + each for each in dimension.units if each and each.startswith(unit)]

    return offered


def listed(typed: str, known: Sequence[str]) -> list[str]:
    """A list of names, its last completed; a name with a number after a colon ends at the colon."""
    before, comma, last = typed.rpartition(",")
    names = [f"{name.partition(':')[0]}:" if ":" in name and not name[-1].isdigit() else name for name in known]
    given = before.split(",")
    return [before + comma + name for name in names if name.startswith(last) and name not in given]


def solutions(ctx: click.Context, parameter: click.Parameter, typed: str) -> "list[CompletionItem[str]] | list[str]":
    """What `compare` knows by name, else the files with a series."""
    from libration import approx

    return listed(typed, [*approx.angle.names, *approx.numerical.names]) or files(ctx, parameter, typed)


def formulas(_ctx: click.Context, _parameter: click.Parameter, typed: str) -> list[str]:
    """The names of the formulas of the period, and the exact value."""
    from libration import approx

    return listed(typed, ["exact", *approx.period.names])
