"""Writes the generated blocks of the pages: nothing between two markers is typed by hand.

A block is between `<!-- generated: NAME -->` and `<!-- end generated -->` on any page. Its text comes from
docs/corners.toml, from a page that a run has written, or from a run of libration now.
"""

import math
import re
import runpy
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGES = [
    "README.md",
    *(f"docs/{name}.md" for name in ("corners", "duffing", "approximations", "errata")),
]


def accuracy(root: Path) -> str:
    """The short table of docs/accuracy.md, which bench/accuracy.py has written."""
    text = (root / "docs/accuracy.md").read_text(encoding="utf-8")
    return text.partition("<!-- summary -->\n")[2].partition("<!-- end summary -->")[0]


def corners(root: Path) -> str:
    """The table of docs/corners.toml."""
    lines = ["| corner | call | gives | why |", "|---|---|---|---|"]
    for corner in tomllib.loads((root / "docs/corners.toml").read_text(encoding="utf-8"))["corner"]:
        given = corner.get("gives", [])
        shown = "<br>".join(f"`{float(value)!r}`" for value in ([given] if isinstance(given, str) else given))
        result = f"ValueError: {corner['message']}" if "message" in corner else shown
        lines.append(f"| {corner['title']} | `{corner['call']}` | {result} | {corner['why']} |")
    return "\n" + "\n".join(lines).replace("|θ₀|", "\\|θ₀\\|") + "\n\n"


def forms(root: Path) -> str:
    """Which regimes each of the twelve forms of the Duffing oscillator covers: the table that the core makes."""
    from libration import DuffingForm

    lines = ["| form | regimes |", "|---|---|"]
    lines += [
        f"| c₁ {name}(Ωt + c₂) | {', '.join(f'`{each}`' for each in found)} |"
        for name, found in DuffingForm.table().items()
    ]
    return "\n" + "\n".join(lines) + "\n\n"


def errata(root: Path) -> str:
    """The errata of the papers, one table a paper, each row with the residual of both forms as measured now."""
    from libration.papers import errata

    lines = []
    for work in dict.fromkeys(row.work for row in errata()):
        lines += [
            f"## {work}",
            "",
            "| place | printed | corrected | why | kind | what is measured | as printed | as corrected |",
        ]
        lines.append("|---|---|---|---|---|---|---:|---:|")
        for row in [row for row in errata() if row.work == work]:
            corrected = row.corrected_residual
            small = 0 < corrected <= row.tolerance < 1e-6
            measured = f"below {row.tolerance:.0e}" if small else f"{corrected:.3g}"
            failed = "no value" if math.isnan(row.printed_residual) else f"{row.printed_residual:.3g}"
            told = [row.place, row.printed, row.corrected, row.why, row.kind, row.measure, failed, measured]
            lines.append(f"| {' | '.join(each.replace('|', chr(92) + '|') for each in told)} |")
        lines.append("")
    return "\n" + "\n".join(lines) + "\n"


def limits(root: Path) -> str:
    """Where the exact solutions of the papers fail: what they give, and the exact angle."""
    from libration.papers import limits

    lines = ["| form | θ₀ | θ̇₀ | t | gives | exact | modulo 2π | why |", "|---|---:|---:|---:|---:|---:|---|---|"]
    for limit in limits():
        state = f"{limit.theta0:.10g} | {limit.velocity0:g} | {limit.t:g}"
        given = "no value" if math.isnan(limit.given) else f"{limit.given:.9f}"
        right = "right" if limit.modulo else ("" if math.isnan(limit.given) else "wrong")
        lines.append(f"| {limit.name} | {state} | {given} | {limit.truth:.9f} | {right} | {limit.why} |")
    return "\n" + "\n".join(lines) + "\n\n"


def blocks(root: Path) -> dict[str, str]:
    """Every block by its name."""
    measured = runpy.run_path(str(root / "docs/approximations.py"))
    return {
        "angle-sources": measured["sources"](),
        "angle-errors": measured["angles"](),
        "period-errors": measured["periods"](),
        "sine-errors": measured["sines"](),
        "accuracy": accuracy(root),
        "corners": corners(root),
        "forms": forms(root),
        "errata": errata(root),
        "limits": limits(root),
    }


def main() -> None:
    """Write every block into every page that holds its markers."""
    for name in PAGES:
        page = ROOT / name
        text = page.read_text(encoding="utf-8")
        for block, written in blocks(ROOT).items():
            marked = rf"(<!-- generated: {block} -->\n).*?(<!-- end generated -->)"
            text = re.sub(marked, lambda found, new=written: found[1] + new + found[2], text, flags=re.DOTALL)
        page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
