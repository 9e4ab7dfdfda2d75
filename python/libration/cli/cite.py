"""`libration cite`: how to cite libration and what it rests on."""

from libration.cli.offers import words
from libration.cli.parser import Flag, Options, Refusal, Words, command

DESCRIPTION = """\
Prints how to cite libration; with a NAME, or with `all`, the papers, books and standards that it rests on."""
NAMES = tuple(
    "libration salas2019 lima2019 horsley2025 dlmf landau1976 jorba2005 gum2008 postma2005 jafari2011 martinis1987 martinis2002".split()
)


class CiteOptions(Options):
    """The options of `libration cite`."""

    names: tuple[str, ...]
    bibtex: bool


def run(options: CiteOptions) -> None:
    """Print the references."""
    from libration._cite import cite

    try:
        print(cite(*options.names, form="bibtex" if options.bibtex else "text"))
    except ValueError as error:
        raise Refusal(str(error)) from error


COMMAND = command(
    "cite",
    DESCRIPTION,
    run,
    CiteOptions,
    short="how to cite libration and what it rests on, as text or BibTeX",
    parameters=[
        Words(
            "names",
            "NAME",
            f"all, or some of {', '.join(NAMES)} (default libration)",
            "the references",
            offered=words("all", *NAMES),
        ),
        Flag("--bibtex", "entries of BibTeX, in place of a line each", "the references"),
    ],
    usage=["libration cite", "[NAME ...]", "[--bibtex]"],
    topics=[],
    examples=["libration cite", "libration cite lima2019 dlmf", "libration cite all --bibtex > references.bib"],
)
