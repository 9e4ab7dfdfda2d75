"""The lab's texts in Python, with SciPy, mpmath and libration: each start of each kind agrees with the core to 1e-10."""

import sys
from typing import Any

import pytest
from snippets import NAMES, SNIPPETS, difference, printed, run, wanted


@pytest.mark.parametrize("snippet", SNIPPETS, ids=NAMES)
@pytest.mark.parametrize("code", ["scipy", "mpmath", "libration"])
def test_a_text_in_python_agrees_with_the_core(code: str, snippet: dict[str, Any]) -> None:
    assert difference(printed(snippet, code, [sys.executable], ".py"), snippet) < 1e-10


def test_starts_of_all_kinds_are_there() -> None:
    assert len(SNIPPETS) >= 12
    assert {one["kind"] for one in SNIPPETS} == {"libration", "rotation", "separatrix", "rest"}


@pytest.mark.parametrize(
    ("code", "right", "wrong"),
    [("scipy", "(mc)", "(1 - np.sqrt(m))"), ("mpmath", "ellipk(m)", "ellipk(mp.sqrt(m))")],
)
def test_the_modulus_for_the_parameter_does_not(code: str, right: str, wrong: str) -> None:
    snippet = SNIPPETS[1]
    text = "\n".join(snippet["texts"][code])
    assert right in text
    spoiled = run(text.replace(right, wrong, 1), [sys.executable], ".py")
    period, _ = wanted(snippet)
    assert period is not None
    # Of a swing of 20 degrees, 4.03 %.
    assert float(spoiled.split()[1]) / period - 1 == pytest.approx(0.0403, abs=5e-5)
    assert difference(spoiled, snippet) > 1e-3


def test_a_row_too_few_or_a_missing_number_is_infinitely_far() -> None:
    snippet = SNIPPETS[0]
    output = printed(snippet, "libration", [sys.executable], ".py")
    assert difference(output, snippet) < 1e-10
    assert difference("\n".join(output.split("\n")[:-2]), snippet) == float("inf")
    assert difference(output.replace("period", "0 0"), snippet) == float("inf")
    assert difference(output.replace("0.5 ", "nan ", 1), snippet) == float("inf")
