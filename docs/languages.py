"""The translations of the pages: docs/locales holds those that are read from end to end, in Portuguese and Spanish.

    python docs/languages.py TEMPLATES            which messages lack a translation, or have one too many; exit code 1
    python docs/languages.py TEMPLATES --update   writes new messages into the files, for a translator

TEMPLATES is what `sphinx-build -b gettext` has written. What is not listed here is shown in English: reference, tables and decisions.
"""

import sys
from pathlib import Path

from babel.messages.pofile import read_po, write_po

LOCALES = Path(__file__).with_name("locales")
LANGUAGES = ("pt_BR", "es")
PAGES = (
    "index tutorial guide fit damped starts approximations errata papers about design compare duffing bucket tables "
    "ensembles-examples reference/index reference/command-line how-to/notebooks how-to/index how-to/choose "
    "how-to/separatrix how-to/long-times how-to/arrays how-to/from-scipy how-to/accelerators how-to/mems "
    "how-to/teachers why/index why/integrators why/sn why/theory"
).split()


def catalog(file: Path, language: str | None = None):
    """The messages of a file; none if it is missing."""
    if not file.is_file():
        return None
    with file.open("rb") as stream:
        return read_po(stream, locale=language)


def findings(templates: Path) -> list[str]:
    """What is missing and what is left over, a line each."""
    found = []
    for language in LANGUAGES:
        for page in PAGES:
            file = LOCALES / language / "LC_MESSAGES" / f"{page}.po"
            given = {each.id: each.string for each in catalog(file, language) or () if each.id}
            asked = {each.id for each in catalog(templates / f"{page}.pot") or () if each.id}
            found += [f"{language}: {page}: no translation: {each}" for each in sorted(asked) if not given.get(each)]
            found += [
                f"{language}: {page}: no longer on the page: {each}" for each in sorted(given) if each not in asked
            ]
    return found


def update(templates: Path) -> None:
    """The files with exactly the messages of the pages; a translation stays where its message stays."""
    for language in LANGUAGES:
        for page in PAGES:
            file = LOCALES / language / "LC_MESSAGES" / f"{page}.po"
            asked, given = catalog(templates / f"{page}.pot"), catalog(file, language)
            for each in asked:
                held = given.get(each.id) if given and each.id else None
                each.string = held.string if held else each.string
            asked.locale = language
            file.parent.mkdir(parents=True, exist_ok=True)
            with file.open("wb") as stream:
                write_po(stream, asked, width=0, no_location=True, omit_header=True, ignore_obsolete=True)


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    if "--update" in sys.argv:
        update(folder)
    lines = findings(folder)
    print("\n".join(lines) or f"{len(PAGES)} pages in {len(LANGUAGES)} languages")
    sys.exit(bool(lines))
