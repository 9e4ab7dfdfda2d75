"""The languages of the pictures, however their names are written."""

LANGUAGES = ("en", "pt-BR", "es")


def known_language(text: object) -> str | None:
    """The name of a language: `pt`, `pt_br` and `PT-BR` are `pt-BR`; None for one that is not known."""
    code = text.lower().replace("_", "-") if isinstance(text, str) else ""
    return next((each for each in LANGUAGES if code in (each.lower(), each.partition("-")[0])), None)
