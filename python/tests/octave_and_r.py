"""The lab's texts in Octave and R: each start of each kind agrees with the core to 1e-10. `make test/snippets` installs both."""

from typing import Any

import pytest
from snippets import NAMES, SNIPPETS, difference, printed, run

OCTAVE = ["octave", "--no-gui", "--quiet", "--norc"]
R = ["Rscript", "--vanilla"]


@pytest.mark.parametrize("snippet", SNIPPETS, ids=NAMES)
def test_a_text_in_octave_agrees_with_the_core(snippet: dict[str, Any]) -> None:
    assert difference(printed(snippet, "octave", OCTAVE, ".m"), snippet) < 1e-10


@pytest.mark.parametrize("snippet", SNIPPETS, ids=NAMES)
def test_a_text_in_r_agrees_with_the_core(snippet: dict[str, Any]) -> None:
    assert difference(printed(snippet, "r", R, ".R"), snippet) < 1e-10


@pytest.mark.parametrize(
    ("code", "command", "suffix", "right", "wrong"),
    [
        ("octave", OCTAVE, ".m", "ellipke(m)", "ellipke(sqrt(m))"),
        ("r", R, ".R", "elliptic_k(mc)", "elliptic_k(1 - sqrt(m))"),
    ],
)
def test_the_modulus_for_the_parameter_does_not(
    code: str, command: list[str], suffix: str, right: str, wrong: str
) -> None:
    text = "\n".join(SNIPPETS[1]["texts"][code])
    assert right in text
    assert difference(run(text.replace(right, wrong, 1), command, suffix), SNIPPETS[1]) > 1e-3
