"""The language of the command line: English, Portuguese of Brazil or Spanish, by --lang or by the settings of the system.

A sentence is written in English where it is made, and told in the language where it is printed: by gettext if it is
whole, else by its pattern, in which {} stands for what changes. A translation says which of these parts are sentences
themselves, {0:told}, or numbers, {0:number}. What is not known stays English; docs/sentences.py says what is not known.
"""

import contextlib
import functools
import gettext
import os
import re
from collections.abc import Iterator, Sequence
from contextvars import ContextVar
from pathlib import Path

from libration._languages import known_language

FOLDER = Path(__file__).parents[1] / "locales"
CURRENT: ContextVar[str] = ContextVar("language", default="en")
# The variables that gettext reads, in its order; the first is a list, and does not count in the locale C.
LIST, LOCALES = "LANGUAGE", ("LC_ALL", "LC_MESSAGES", "LANG")
# A pattern with fewer fixed letters fits too much: it is looked up as it stands, and not matched.
FEWEST_LETTERS = 6
POINT = re.compile(r"(?<=[0-9])\.(?=[0-9])")


class Told(str):
    """A text that is in the language already."""


class Part(str):
    """What stands in a place of a pattern."""

    def __format__(self, kind: str) -> str:
        return told(self) if kind == "told" else decimal(self) if kind == "number" else str(self)


class Catalogue(gettext.GNUTranslations):
    """The sentences of a language."""

    _catalog: dict[str, str]

    @functools.cached_property
    def patterns(self) -> list[tuple[re.Pattern[str], str]]:
        """Expressions of the sentences with places, those with more fixed letters first."""
        made = [(each.replace("{}", ""), each) for each in self._catalog if "{}" in each]
        kept = [(rest, each) for rest, each in made if len(re.findall("[A-Za-z]", rest)) >= FEWEST_LETTERS]
        kept.sort(key=lambda both: (-len(both[0]), both))
        return [(re.compile(re.escape(each).replace(r"\{\}", "(.*?)") + r"\Z", re.DOTALL), each) for _, each in kept]

    def found(self, text: str) -> str | None:
        """A sentence in the language, None for one that is not known."""
        if text in self._catalog:
            return self.gettext(text)
        for pattern, each in self.patterns:
            if parts := pattern.match(text):
                return self.gettext(each).format(*map(Part, parts.groups()))
        return None


@functools.cache
def catalogue(name: str) -> Catalogue:
    """The sentences of a language that is not English."""
    return gettext.translation("libration", FOLDER, [name.replace("-", "_")], class_=Catalogue)


def told(text: str) -> str:
    """A text of the command line in the language of the call; blanks at its ends stay."""
    name, inner = CURRENT.get(), text.strip()
    if name == "en" or isinstance(text, Told) or not inner:
        return text
    found = sentence(inner, name)
    return text if found is None else Told(text.replace(inner, found, 1))


def sentence(text: str, name: str) -> str | None:
    """A sentence, a sentence of a fit, or sentences after a colon or a semicolon, each told as far as it is known."""
    found = catalogue(name).found(text)
    if found is not None:
        return found
    if (fitted := of_a_fit(text, name)) != text:
        return fitted
    for mark in (": ", "; "):
        head, between, rest = text.partition(mark)
        if between:
            parts = sentence(head, name), sentence(rest, name)
            if any(part is not None for part in parts):
                return f"{parts[0] or head}{between}{parts[1] or rest}"
    return None


def of_a_fit(text: str, name: str) -> str:
    """A sentence of the core about measurements."""
    from libration.measurement._sentences import in_language

    return in_language(text, name)


def say(text: str = "") -> None:
    """Print a text in the language of the call."""
    print(told(text))


def decimal(text: str) -> str:
    """Numbers in a text with the decimal sign of the language."""
    return POINT.sub(",", text) if comma() else text


def comma() -> bool:
    """Whether the decimal sign of the language is a comma."""
    return CURRENT.get() != "en"


def of_the_system() -> str:
    """The language that the environment asks for; English for one that is not known."""
    locale = next((os.environ[name] for name in LOCALES if os.environ.get(name)), "C")
    plain = locale.partition(".")[0]
    if plain in ("C", "POSIX"):
        return "en"
    wanted = [*filter(None, os.environ.get(LIST, "").split(":")), locale]
    names = (known_language(re.split("[.@_-]", each)[0]) for each in wanted)
    return next((name for name in names if name), "en")


def asked(words: Sequence[str]) -> str | None:
    """What follows --lang among the words of a command line."""
    for place, word in enumerate(words):
        option, equals, value = word.partition("=")
        if option == "--":
            break
        if option == "--lang":
            return value if equals else next(iter(words[place + 1 :]), None)
    return None


@contextlib.contextmanager
def spoken(words: Sequence[str]) -> Iterator[None]:
    """Speak the language that the words or the system ask for; one that is not known is refused by its option."""
    token = CURRENT.set(known_language(asked(words)) or of_the_system())
    try:
        yield
    finally:
        CURRENT.reset(token)
