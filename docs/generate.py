"""Writes the generated blocks of the pages: nothing between two markers is typed by hand.

A block is between `<!-- generated: NAME -->` and `<!-- end generated -->` on any page. Its text comes from the docstrings and
functions.toml, from docs/corners.toml, from a page that a run has written, or from a run of libration now.
"""

import math
import re
import runpy
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGES = [
    "README.md",
    *(f"docs/{name}.md" for name in ("functions", "corners", "duffing", "approximations", "errata")),
]


def functions(root: Path) -> str:
    """The reference of the public functions, one section a member: its docstring, and its row of functions.toml."""
    read = runpy.run_path(str(root / "docs/surface.py"))
    surface, parts = read["surface"](root), read["sections"]
    rows = tomllib.loads((root / "functions.toml").read_text(encoding="utf-8"))
    homes = {member: name for name, row in rows.items() for member in [name, *row.get("members", [])]}
    written = [
        section(name, member, parts(member["doc"]), rows[homes[name]])
        for name, member in surface.items()
        if name in homes
    ]
    for name, row in rows.items():
        if name.startswith("libration "):
            run = f"python/libration/cli/{name.partition(' ')[2].replace('-', '_')}.py::run"
            written.append(f"## {name}\n\n`{name} --help` lists its options.\n\n- {places({'Python': run}, row)}\n")
    return "\n" + "\n".join(written) + "\n"


def section(name: str, member: dict, doc: dict[str, str], row: dict) -> str:
    """One member: call, summary, arguments, results and errors, the notes, and the places in the code."""
    lines = [f"## {name}", ""]
    if member["kind"] == "function":
        lines += [f"`{member['signature']}`", ""]
    lines += [marked(doc["Summary"]), ""]
    for title in ("Parameters", "Returns", "Raises"):
        entries = items(doc.get(title, ""))
        if entries:
            lines += [f"{title}:", "", *entries, ""]
    lines += [marked(doc["Notes"]), ""] if "Notes" in doc else []
    lines += [f"- {places({'Python': member['place']}, row)}", ""]
    return "\n".join(lines)


def items(text: str) -> list[str]:
    """The entries of a section of a docstring as a list; the lines below an entry follow it."""
    entries: list[str] = []
    for line in text.splitlines():
        if line.strip() and not line.startswith(" "):
            what, colon, kind = line.partition(" : ")
            entries.append(f"- `{what}` ({marked(kind)})" if colon else f"- {marked(what)}")
        elif line.strip():
            entries[-1] += (
                f"{' ' if entries[-1].endswith(('.', ',', ';')) or ': ' in entries[-1] else ': '}{marked(line.strip())}"
            )
    return entries


def marked(text: str) -> str:
    """Plain text of a docstring as Markdown: code in single backticks, no star or bar with another meaning."""
    pieces = re.split(r"(``.+?``|`[^`\n]+`)", text)
    return "".join(
        f"`{piece.strip('`')}`" if number % 2 else piece.replace("*", r"\*").replace("|", r"\|").replace("<", r"\<")
        for number, piece in enumerate(pieces)
    )


def places(python: dict[str, str], row: dict) -> str:
    """Links to a member, its reference values and its tests."""
    given = [
        *python.items(),
        ("Rust", row.get("rust")),
        ("reference values", row.get("vectors")),
        ("test", row["test"]),
    ]
    links = [
        f"{where} [{place.partition('::')[2] or place}](../{place.partition('::')[0]})"
        for where, found in given
        for place in ([found] if isinstance(found, str) else found or [])
    ]
    promised = [f"{name} {row[name]}" for name in row if name.startswith("error_")]
    return "; ".join([*links, *promised])


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
        "functions": functions(root),
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
