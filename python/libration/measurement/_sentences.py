"""Sentences of the core, verdicts, guesses and reasons, in Portuguese of Brazil and Spanish.

A sentence is known by its English pattern, in which {} stands for what changes; numbers get a decimal comma. One that is not
known stays English.
"""

import functools
import json
import re
from pathlib import Path

# sentences.json, which the lab reads too. English: Portuguese, Spanish; {} are taken in their order.
TABLE = json.loads(Path(__file__).with_name("sentences.json").read_text(encoding="utf-8"))
PATTERNS: dict[str, list[str]] = {
    english: others for group in TABLE["sentences"].values() for english, others in group.items()
}
# What fills a place of a pattern and has words of its own.
PIECES: dict[str, list[str]] = TABLE["pieces"]
NUMBER = re.compile(r"[-+−]?[0-9]+\.[0-9]+(e[-+]?[0-9]+)?")


@functools.cache
def compiled() -> list[tuple[re.Pattern[str], list[str]]]:
    """The patterns as expressions, those with more fixed letters first."""
    ordered = sorted(PATTERNS.items(), key=lambda each: -len(each[0].replace("{}", "")))
    return [
        (re.compile(re.escape(english).replace(r"\{\}", "(.*?)") + r"\Z", re.DOTALL), other)
        for english, other in ordered
    ]


def in_language(sentence: str, language: str) -> str:
    """A sentence of the core in Portuguese or Spanish; as it is where its pattern is not known."""
    for pattern, others in compiled():
        if found := pattern.match(sentence):
            return others[language == "es"].format(*(piece(part, language) for part in found.groups()))
    return sentence


def piece(part: str, language: str) -> str:
    """What fills a place: a number, a known text, a sentence of its own, or names, which stay."""
    if NUMBER.fullmatch(part):
        return part.replace(".", ",")
    told = in_language(part, language)
    if told != part:
        return told
    if part in PIECES:
        return PIECES[part][language == "es"]
    for english, others in PIECES.items():
        part = re.sub(rf"(^|; ){re.escape(english)}: ", rf"\1{others[language == 'es']}: ", part)
    return part
