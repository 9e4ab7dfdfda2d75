"""`libration completion`: the script that lets a shell complete commands, options, names, units and files.

The shell calls `libration` with `_LIBRATION_COMPLETE` set; click finds what may follow. The scripts are ours for three
reasons: a name such as `rk4:` goes on without a blank, lists have commas in them, and bash parts words at colons.
"""

import contextlib
import os
from typing import ClassVar

import click
from click.shell_completion import (
    BashComplete,
    CompletionItem,
    FishComplete,
    ZshComplete,
    add_completion_class,
    shell_complete,
    split_arg_string,
)

from libration.cli.language import told
from libration.cli.offers import words
from libration.cli.parser import Options, Refusal, Word, command, nearest, quoted

VARIABLE = "_LIBRATION_COMPLETE"

BASH = """\
%(complete_func)s() {
    local type value response typed=${COMP_LINE:0:COMP_POINT} colon=
    response=$(env COMP_WORDS="$typed" %(complete_var)s=bash_complete "$1")
    # A colon begins a new word, so only what follows the last one is replaced.
    typed=${typed##*[ =]}
    [[ $COMP_WORDBREAKS == *:* ]] && colon=${typed%%"${typed##*:}"}
    COMPREPLY=()
    while IFS=, read -r type value; do
        case $type in
        dir) compopt -o dirnames ;;
        file) compopt -o default ;;
        plain)
            COMPREPLY+=("${value#"$colon"}")
            [[ $value == *: ]] && compopt -o nospace
            ;;
        esac
    done <<< "$response"
}
complete -o nosort -F %(complete_func)s %(prog_name)s
"""

ZSH = """\
(( $+functions[compdef] )) || { autoload -Uz compinit && compinit }
%(complete_func)s() {
    local -a response bare described open
    local type key descr
    response=("${(@f)$(env COMP_WORDS="${words[*]}" COMP_CWORD=$((CURRENT-1)) %(complete_var)s=zsh_complete %(prog_name)s)}")
    for type key descr in ${response}; do
        if [[ $type == dir ]]; then
            _path_files -/
        elif [[ $type == file ]]; then
            _path_files -f
        elif [[ $key == *: ]]; then
            open+=("$key")
        elif [[ $descr == _ ]]; then
            bare+=("$key")
        else
            described+=("$key:$descr")
        fi
    done
    [[ -n $described ]] && _describe -V unsorted described -U
    [[ -n $bare ]] && compadd -U -V unsorted -a bare
    [[ -n $open ]] && compadd -U -S '' -V unsorted -a open
}
compdef %(complete_func)s %(prog_name)s
"""

FISH = """\
function %(complete_func)s
    for line in (env %(complete_var)s=fish_complete COMP_WORDS=(commandline -cp) COMP_CWORD=(commandline -ct) %(prog_name)s)
        set -l found (string split -m 1 "," -- $line)
        switch $found[1]
            case dir
                __fish_complete_directories $found[2]
            case file
                __fish_complete_path $found[2]
            case plain
                printf "%%s\\n" $found[2]
        end
    end
end
complete --no-files --keep-order --command %(prog_name)s --arguments "(%(complete_func)s)"
"""


class Bash(BashComplete):
    """bash, with the words of the whole line: its own are parted at colons."""

    source_template: ClassVar[str] = BASH

    def words_of_line(self) -> tuple[list[str], str]:
        """The words before the one that is completed, and the beginning of that."""
        line = os.environ["COMP_WORDS"]
        given = split_arg_string(line)
        typed = given.pop() if line[-1:].strip() else ""
        return given[1:], typed

    # The name is click's.
    get_completion_args = words_of_line


class Zsh(ZshComplete):
    """zsh, which replaces the whole word, `--with=` too."""

    source_template: ClassVar[str] = ZSH

    def format_completion(self, item: "CompletionItem[str]") -> str:
        """One item, as the script reads it."""
        return super().format_completion(after_equals(self.get_completion_args()[1], item))


class Fish(FishComplete):
    """fish, which replaces the whole word, `--with=` too."""

    source_template: ClassVar[str] = FISH

    def format_completion(self, item: "CompletionItem[str]") -> str:
        """One item, as the script reads it."""
        return super().format_completion(after_equals(self.get_completion_args()[1], item))


def after_equals(typed: str, item: "CompletionItem[str]") -> "CompletionItem[str]":
    """The item with the option that stands before it in one word."""
    option, equals, _ = typed.partition("=")
    if equals and option.startswith("--") and item.type == "plain":
        return CompletionItem(option + equals + item.value, item.type, item.help)
    return item


# The line for the file that a shell reads when it starts.
START = {
    "bash": ("~/.bashrc", 'eval "$(libration completion bash)"'),
    "zsh": ("~/.zshrc", 'eval "$(libration completion zsh)"'),
    "fish": ("~/.config/fish/config.fish", "libration completion fish | source"),
}
SHELLS = {"bash": Bash, "zsh": Zsh, "fish": Fish}


class CompletionOptions(Options):
    """The word of `libration completion`."""

    shell: str | None


def run(options: CompletionOptions) -> None:
    """Print the script, and above it the line that puts it to use."""
    every = ", ".join(SHELLS)
    if options.shell is None:
        raise Refusal(f"missing shell: one of {every}")
    if options.shell not in SHELLS:
        hint = nearest(options.shell, SHELLS, "see libration completion --help")
        raise Refusal(f"unknown shell {quoted(options.shell)}: shells are {every}; {hint}")
    file, line = START[options.shell]
    context = click.get_current_context().find_root()
    made = SHELLS[options.shell](context.command, {}, "libration", VARIABLE)
    # Not by `source`, which for bash starts a bash to see how old it is.
    print(told(f"# To complete in every new {options.shell}, put this line into {file}:") + f"\n#   {line}\n")
    print(made.source_template % made.source_vars(), end="")


def offer(top: click.Command, instruction: str) -> None:
    """Print what may follow the words that a shell hands over."""
    for name, each in SHELLS.items():
        add_completion_class(each, name)
    # Of a shell that hands over no words nothing is completed.
    with contextlib.suppress(KeyError, ValueError):
        shell_complete(top, {}, "libration", VARIABLE, instruction)


COMMAND = command(
    "completion",
    """\
Prints a script by which a shell completes the words of `libration` at the tab key: commands, options, names of
approximations, units after a number, languages and files.""",
    run,
    CompletionOptions,
    short="complete commands, options and names with the tab key of bash, zsh or fish",
    parameters=[Word("shell", "SHELL", "bash, zsh or fish (required)", "the shell", offered=words(*SHELLS))],
    usage=["libration completion", "bash | zsh | fish"],
    topics=[],
    examples=[line for _, line in START.values()],
)
