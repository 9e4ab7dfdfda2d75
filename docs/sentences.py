"""Every sentence of the command line has its translations, none is left over, and the compiled catalogues are those of the texts.

    python docs/sentences.py            what is missing or too many; exit code 1
    python docs/sentences.py --update   writes new sentences into locales/ for a translator, and compiles

A sentence is a string with a blank and a word of three letters; what an f-string puts in is {}. Single words and what the
core says stand in locales/ too: that all are there is seen by python/tests/test_cli_language.py, which runs the commands.
"""

import ast
import errno
import io
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from babel.messages.mofile import read_mo, write_mo
from babel.messages.pofile import read_po, write_po

PACKAGE = "python/libration"
BESIDE = "ensemble/_specification ensemble/_store ensemble/_workers papers/_works papers/_claim".split()
LANGUAGES = ("pt_BR", "es")
# Parts of code whose strings are no sentences, and strings that are the same in every language.
NAMES = {"EXAMPLES", "CASES", "EXPRESSIONS"}
PARTS = {"usage", "examples"}
KEPT = re.compile(
    r"eval |FILE --|libration |--run all|a\.csv|# decimal comma|\{\"|NaN or|Singular|theta0 cos|T \* |solve_ivp, |cubic, |dry, torque"
)
# Beside the command line only what is refused is for its reader.
REFUSES = re.compile(r"\b(must|is|was|has|with|cannot|killed|ended|answers)\b|not reproducible|no workers")


def apart(node: ast.AST) -> Iterator[ast.AST]:
    """The parts of a node that hold no sentences."""
    if (
        isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Module)
        and ast.get_docstring(node, clean=False) is not None
    ):
        yield node.body[0]
    if isinstance(node, ast.FunctionDef):
        yield from filter(None, [node.returns, *(each.annotation for each in [*node.args.args, *node.args.kwonlyargs])])
    if isinstance(node, ast.AnnAssign):
        yield from [node.annotation] + [node.value] * (
            "TypeAlias" in ast.dump(node.annotation) and node.value is not None
        )
    if isinstance(node, ast.keyword) and node.arg in PARTS:
        yield node.value
    if isinstance(node, ast.Assign) and any(isinstance(each, ast.Name) and each.id in NAMES for each in node.targets):
        yield node.value
    if isinstance(node, ast.Call) and getattr(node.func, "attr", "") in ("compile", "startswith", "sub", "match"):
        yield from node.args
    if isinstance(node, ast.JoinedStr):
        yield from (each for each in node.values if isinstance(each, ast.Constant))


def sentences(text: str) -> list[str]:
    """The sentences of a file, with single blanks."""
    nodes = list(ast.walk(ast.parse(text)))
    skipped = {id(each) for node in nodes for part in apart(node) for each in ast.walk(part)}
    found = []
    for node in nodes:
        if id(node) in skipped or not isinstance(node, ast.JoinedStr | ast.Constant):
            continue
        parts = node.values if isinstance(node, ast.JoinedStr) else [node]
        whole = "".join(str(each.value) if isinstance(each, ast.Constant) else "{}" for each in parts)
        if isinstance(node, ast.JoinedStr) or isinstance(node.value, str):
            found += [" ".join(each.split()) for each in whole.strip().split("\n\n")]
    plain = [re.sub(r"--[\w-]+|\{\}|\b(rad|deg|min|MiB)\b", "", each) for each in found]
    kept = zip(found, plain, strict=True)
    worded = [each for each, rest in kept if " " in each and re.search(r"[A-Za-z]{3}", rest) and "%(" not in each]
    return [each for each in worded if not KEPT.match(each)]


def asked(root: Path) -> set[str]:
    """The sentences of the command line."""
    found = {
        each for path in files(root, f"{PACKAGE}/cli", ".py") for each in sentences(path.read_text(encoding="utf-8"))
    }
    for name in BESIDE:
        beside = sentences((root / PACKAGE / f"{name}.py").read_text(encoding="utf-8"))
        found |= {each for each in beside if REFUSES.search(each)}
    return found


def written(root: Path) -> str:
    """Everything that the command line or the core may say, with {} for what changes."""
    places = [
        (f"{PACKAGE}/cli", ".py"),
        ("core/src", ".rs"),
        ("fit/src", ".rs"),
        ("python/src", ".rs"),
        (f"{PACKAGE}/measurement", ".py"),
    ]
    text = "".join(path.read_text(encoding="utf-8") for place in places for path in files(root, *place))
    return re.sub(r"\{[^{}]*\}", "{}", text) + "\n".join(map(os.strerror, errno.errorcode))


def findings(root: Path, update: bool = False) -> list[str]:
    found, wanted, everything = [], asked(root), written(root)
    for language in LANGUAGES:
        place = root / PACKAGE / "locales" / language / "LC_MESSAGES"
        text, compiled = place / "libration.po", place / "libration.mo"
        catalog = read_po(io.BytesIO(text.read_bytes()), locale=language)
        given = {str(each.id): str(each.string) for each in catalog if each.id}
        spare = [each for each in given if each not in wanted and each.replace("usage:", "usage: ") not in everything]
        if update:
            for each in spare:
                catalog.delete(each)
            for each in wanted - set(given):
                catalog.add(each)
            text.write_bytes(bytes_of(write_po, catalog, width=0, no_location=True, omit_header=True, sort_output=True))
        if update or not compiled.is_file():
            compiled.write_bytes(bytes_of(write_mo, catalog))
        found += [f"{language}: no translation: {each}" for each in sorted(wanted) if not given.get(each)]
        found += [f"{language}: no longer said: {each}" for each in spare]
        found += [f"{language}: other places: {a}: {b}" for a, b in given.items() if b and places(b) != places(a)]
        with compiled.open("rb") as stream:
            held = {str(each.id): str(each.string) for each in read_mo(stream) if each.id}
        if held != {each: said for each, said in given.items() if said}:
            found.append(f"{compiled.relative_to(root)}: is not that of the text; python docs/sentences.py --update")
    return found


def places(text: str) -> set[int]:
    """The numbers of the places of a text, which may be left to count themselves."""
    return set(range(text.count("{}"))) | {int(each) for each in re.findall(r"\{(\d+)", text)}


def bytes_of(write, catalog, **options) -> bytes:
    """What a writer of Babel writes."""
    stream = io.BytesIO()
    write(stream, catalog, **options)
    return stream.getvalue()


def files(root: Path, folder: str, suffix: str) -> list[Path]:
    """The files under a folder."""
    return sorted((root / folder).rglob(f"*{suffix}"))


if __name__ == "__main__":
    ROOT = Path(__file__).resolve().parents[1]
    if "--update" in sys.argv:
        findings(ROOT, update=True)
    lines = findings(ROOT)
    print("\n".join(lines) or f"every sentence in {len(LANGUAGES)} languages")
    sys.exit(bool(lines))
