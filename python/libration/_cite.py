"""How libration and what it rests on are cited: references.bib, as BibTeX or as a line of text."""

from __future__ import annotations

import re
from difflib import get_close_matches
from functools import cache
from pathlib import Path

from ._scalars import shown

__all__ = ["cite"]

FORMS = ("text", "bibtex")
ENTRY = re.compile(r"@(\w+)\{(\w+),\n(.*?)\n\}", re.DOTALL)
FIELD = re.compile(r"^  (\w+) = \{(.*)\},$", re.MULTILINE)
# In the order of a line of text; how each stands there.
SHOWN = {
    "author": "{}",
    "title": "{}",
    "version": "version {}",
    "edition": "edition {}",
    "journal": "{}",
    "volume": "volume {}",
    "number": "number {}",
    "pages": "{}",
    "institution": "{}",
    "publisher": "{}",
    "year": "{}",
    "note": "{}",
    "url": "{}",
}


@cache
def entries() -> dict[str, tuple[str, dict[str, str]]]:
    """The kind and the fields of every entry, by its key; the software has the version that runs."""
    from . import __version__

    text = Path(__file__).with_name("references.bib").read_text(encoding="utf-8")
    found = {key: (kind, dict(FIELD.findall(body))) for kind, key, body in ENTRY.findall(text)}
    found["libration"][1]["version"] = __version__
    return found


def cite(*names: str, form: str = "text") -> str:
    """How to cite libration, and what it rests on.

    Parameters
    ----------
    *names : str
        Keys of the references: `libration` itself (the default), `salas2019`, `lima2019`, `horsley2025`, `dlmf`, `landau1976`,
        `jorba2005`, `gum2008`, `postma2005`, `jafari2011`, `martinis1987`, `martinis2002`; `all` is all of them.
    form : str, default "text"
        `text`, a line each, or `bibtex`.

    Returns
    -------
    str
        The references in the order of the names, without a newline at the end.

    Raises
    ------
    ValueError
        For another name or form.

    Examples
    --------
    >>> import libration
    >>> print(libration.cite("lima2019"))  # doctest: +ELLIPSIS
    Lima, Fábio M. S., Simple but accurate periodic solutions for the nonlinear pendulum equation, Revista Brasileira ..., 2019.
    >>> print(libration.cite(form="bibtex").splitlines()[0])
    @software{libration,
    """
    if not isinstance(form, str) or form not in FORMS:
        raise ValueError(f"form = {shown(form)}: must be {' or '.join(FORMS)}")
    known = entries()
    asked = list(
        dict.fromkeys(each for name in names or ("libration",) for each in (known if name == "all" else (name,)))
    )
    for name in asked:
        if name not in known:
            near = get_close_matches(str(name).lower(), known, n=1, cutoff=0.4)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise ValueError(f"name = {shown(name)}: must be all or one of {', '.join(known)}{hint}")
    write = bibtex if form == "bibtex" else line
    return ("\n\n" if form == "bibtex" else "\n").join(write(name) for name in asked)


def bibtex(name: str) -> str:
    """An entry of BibTeX."""
    kind, fields = entries()[name]
    rows = "".join(f"  {field} = {{{value}}},\n" for field, value in fields.items())
    return f"@{kind}{{{name},\n{rows}}}"


def line(name: str) -> str:
    """A line of text: braces and dashes of BibTeX are none there."""
    _, fields = entries()[name]
    parts = [how.format(fields[field]) for field, how in SHOWN.items() if field in fields]
    return ", ".join(parts).replace("{", "").replace("}", "").replace("--", "–") + "."
