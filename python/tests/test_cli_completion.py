"""`libration completion`: the script of each shell, and what the shell is offered at the tab key. No shell is needed."""

import os
import subprocess
import sys

import pytest

from libration import approx
from libration.cli import main
from libration.cli.top import COMMANDS

SHELLS = ("bash", "zsh", "fish")


def offered(shell, line):
    """The values that a shell is offered after a line, as it asks for them."""
    *before, typed = line.split(" ")
    asked = {
        "bash": {"COMP_WORDS": line},
        "zsh": {"COMP_WORDS": line, "COMP_CWORD": str(len(before))},
        "fish": {"COMP_WORDS": line, "COMP_CWORD": typed},
    }[shell]
    environment = os.environ | asked | {"_LIBRATION_COMPLETE": f"{shell}_complete"}
    done = subprocess.run([sys.executable, "-m", "libration"], env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.removesuffix("\n").split("\n") if done.stdout.strip() else []
    if shell == "zsh":
        # Three lines an item: type, value, help. Before a help, colons of the value have a backslash.
        return [
            (kind, value if text == "_" else value.replace(r"\:", ":"))
            for kind, value, text in zip(lines[::3], lines[1::3], lines[2::3], strict=True)
        ]
    return [tuple(line.partition("\t")[0].split(",", 1)) for line in lines]


@pytest.mark.parametrize("shell", SHELLS)
@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("libration so", ["solve"]),
        ("libration solve --thet", ["--theta0"]),
        ("libration solve --theta0 1 --thet", []),
        ("libration solve --theta0 -3 --len", ["--length"]),
        ("libration solve --theta0 150", ["150rad", "150deg", "150turn"]),
        ("libration solve --length 25c", ["25cm"]),
        ("libration compare --with har", ["harmonic"]),
        ("libration compare --with linear,tay", ["linear,taylor:"]),
        ("libration compare --with fourier:4,linear,ha", ["fourier:4,linear,harmonic"]),
        ("libration papers li", ["lima"]),
        ("libration completion f", ["fish"]),
        ("libration nothing --x", []),
    ],
)
def test_what_is_offered(shell, line, expected):
    assert offered(shell, line) == [("plain", value) for value in expected]


@pytest.mark.parametrize("shell", SHELLS)
def test_files_are_left_to_the_shell(shell):
    assert offered(shell, "libration solve --out mo") == [("file", "mo")]
    assert offered(shell, "libration papers --out o") == [("dir", "o")]


@pytest.mark.parametrize("shell", ["zsh", "fish"])
def test_a_value_behind_an_equals_sign(shell):
    assert offered(shell, "libration compare --with=harm") == [("plain", "--with=harmonic")]


@pytest.mark.parametrize("shell", SHELLS)
def test_every_command_option_and_name(shell):
    assert sorted(offered(shell, "libration ")) == sorted(("plain", name) for name in COMMANDS)
    names = {value for _, value in offered(shell, "libration compare --with ")}
    assert names == {
        f"{name.partition(':')[0]}:" if ":" in name else name for name in (*approx.angle.names, *approx.numerical.names)
    }
    options = {value for _, value in offered(shell, "libration solve ")}
    assert options == {option for each in COMMANDS["solve"].params for option in each.opts} | {"--help"}


@pytest.mark.parametrize("shell", SHELLS)
def test_the_script_says_where_it_goes(capsys, shell):
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert f"put this line into ~/.{'config/fish/config.fish' if shell == 'fish' else f'{shell}rc'}:" in script
    assert f"_LIBRATION_COMPLETE={shell}_complete" in script
    assert "%(" not in script


@pytest.mark.parametrize(
    ("words", "line"),
    [
        ([], "missing shell: one of bash, zsh, fish"),
        (["bsh"], "unknown shell 'bsh': shells are bash, zsh, fish; did you mean bash?"),
        (["tcsh", "x"], "unknown word 'x'; see libration completion --help"),
    ],
)
def test_refusals(capsys, words, line):
    assert main(["completion", *words]) == 2
    assert capsys.readouterr().err == f"libration completion: {line}\n"


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_shell_that_hands_over_no_words_is_offered_nothing(shell):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("COMP_")}
    environment["_LIBRATION_COMPLETE"] = f"{shell}_complete"
    done = subprocess.run([sys.executable, "-m", "libration"], env=environment, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("", "")


def test_an_unknown_request_prints_nothing():
    environment = os.environ | {"_LIBRATION_COMPLETE": "tcsh_complete"}
    done = subprocess.run([sys.executable, "-m", "libration"], env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
