"""`libration fit`: from one data file, or several together, to omega0, g or the length, with friction, uncertainty, verdicts.

Every file is read and fitted before anything is printed or written, so that a refusal leaves nothing half done.
"""

import contextlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, BinaryIO

from libration.cli.files import staged, strict
from libration.cli.fit_arguments import MODELS, FitOptions, arguments, counted
from libration.cli.help import Topic
from libration.cli.language import told
from libration.cli.offers import files, units, words
from libration.cli.parser import (
    Finding,
    Flag,
    Refusal,
    Value,
    Values,
    Words,
    command,
    refusal,
    shown,
)
from libration.cli.picture import (
    PICTURES,
    check_matplotlib,
    check_plot,
    drawing,
    form,
    language,
    picture_look,
    picture_options,
)
from libration.cli.quantities import GRAVITY, LENGTH

if TYPE_CHECKING:
    from libration import Fit, Together
    from libration.measurement._columns import Given
    from libration.measurement._together import Apart

REPORTS = (".html", ".htm")
DESCRIPTION = """\
Fits a pendulum with friction to measurements: a file of a video tracker, a phone, a photogate or an encoder. Prints what
was understood of the file and what was left out, omega0 with an honest uncertainty, g from the length or the length from
g, the friction, and what speaks against the result. Needs no start values. Several files are fitted together."""

TOPICS = (
    Topic(
        "files",
        text="""\
Text tables with any separator and decimal sign, Tracker (.txt, .trk), phyphox (.csv, .xls, .zip), Vernier, PASCO, .xlsx,
photogate times, tables of periods against angles; MATLAB (.mat) and Parquet with pip install 'libration[files]'. Nothing is
resampled. Where a file leaves a question open, it is asked
in one line, with the option that answers it.
""",
    ),
    Topic(
        "several files",
        (
            ("a.csv b.csv", "runs of one pendulum: one omega0, one g"),
            ("FILE --length L FILE --length L", "one g at several lengths, each in the order of the files"),
            ("FILE --pivot D FILE --pivot D", "a reversible pendulum, about one pivot and the other"),
            ("--run all", "every run of a file that has several"),
        ),
        """\
From three lengths on, an error that they have in common is fitted too, such as a thread measured to the top of the bob. With
--between the distance of the two pivots counts, and --pivot is given for the first alone.
""",
    ),
    Topic(
        "corrections",
        text="""\
A bob on a thread, with --bob and --wire, has a table of what changes its period: bob-size (the length goes to its centre),
wire-mass, buoyancy, added-mass (the fluid that moves along). All are made in g, or in the length; --without leaves one in the
table only.
""",
    ),
    Topic(
        "parts of a rigid pendulum",
        (
            ("rod:LENGTH,MASS", "hangs from the pivot; with a third value its centre is so far below"),
            ("ball:DISTANCE,MASS,RADIUS", "a ball, its centre so far below the pivot"),
            ("disc:DISTANCE,MASS,RADIUS", "a flat disc that swings in its own plane"),
            ("point:DISTANCE,MASS", "a mass that is small"),
        ),
        "Such as --part rod:0.495m,19g --part point:0.495m,31g. Each value may have an uncertainty, 0.495±0.001m.",
    ),
    Topic(
        "friction",
        text="""\
theta'' + 2 linear theta' + quadratic |theta'| theta' + dry sgn(theta') + omega0^2 sin(theta) = 0, all per unit inertia: what
libration solve --linear, --quadratic and --dry take. The poorest model that the record does not reject is chosen.
""",
    ),
    Topic(
        "uncertainty",
        text="""\
After the GUM, k = 1: noise with its correlation in time, the choice of the friction model, and length, scale and clock.
A length is given as 0.650±0.010, 0.650+-0.010, '65.0(10)cm' or 65cm±1%. With --monte-carlo the interval that holds 95 % of the draws stands beside it.
""",
    ),
    Topic(
        "exit code",
        text="""\
0 where the result stands; 1 where a verdict says that the record is no pendulum's or the fit does not describe it; 2
where a file or an option is refused.
""",
    ),
)
EXAMPLES = (
    "libration fit swing.csv --length 0.650±0.010",
    "libration fit counts.txt --unit angle=4096/rev --rate 100/s --plot fit.png",
    "libration fit a.csv b.csv c.csv --column angle=theta --model dry --json",
    "libration fit short.csv --length 0.400±0.001 long.csv --length 0.800±0.001",
    "libration fit swing.csv --length 0.650±0.001 --bob 12.5mm,66g --monte-carlo 10000",
)


def run(options: FitOptions) -> None:
    """Fit what the words ask for, write the files, print the results."""
    if not options.file:
        raise Refusal("missing FILE: the measurements, such as swing.csv; see libration fit --help")
    known, apart = arguments(options)
    lang, look = picture(options)
    check_plot(options)
    if options.report is not None:
        check_matplotlib("--report", options.report, "plot")
    with targets(options) as opened:
        # A track on a short arc needs its own length to be read.
        own = apart.lengths or []
        shared = [known.get("length")] * len(options.file)
        lengths = own if len(own) == len(options.file) else shared
        pairs = zip(options.file, lengths, strict=True)
        givens = [given for path, length in pairs for given in read(path, known | {"length": length})]
        found = fitted(givens, known, apart)
        written = []
        if options.plot is not None:
            with drawing("--plot", options.plot):
                found.plot(opened["--plot"], form=form(options.plot), **look)
            written.append(options.plot)
        if options.report is not None:
            opened["--report"].write(found.report(lang).encode())
            written.append(options.report)
    if options.json:
        print(strict(found.to_dict() | {"files": written}))
    else:
        print(text_of(found, lang))
        for path in written:
            print(f"{told('written')}   {path}")
    if not found.stands:
        alone = len(givens) == 1
        raise Finding(f"{shown(options.file[0])}: {found.verdicts[0]}" if alone else found.verdicts[0])


def text_of(found: "Fit | Together", lang: str) -> str:
    """The result in plain lines, in a language."""
    from libration.measurement import _text, _together_text
    from libration.measurement._words import Words

    one = hasattr(found, "window")
    return _text.text(found, Words(lang)) if one else _together_text.text(found, Words(lang))


def picture(options: FitOptions) -> tuple[str, dict[str, Any]]:
    """The language of picture and report, and how the picture looks."""
    if options.plot is None and options.report is not None:
        only_plot = {"--title": options.title, "--dpi": options.dpi}
        for option, given in only_plot.items():
            if given is not None:
                raise refusal(option, given, "needs --plot FILE beside it")
        return language(options.lang), {}
    return language(options.lang), dict(picture_look(options, options.plot))


@contextlib.contextmanager
def targets(options: FitOptions) -> Iterator[dict[str, BinaryIO]]:
    """The files that are written, opened before anything is computed, by option."""
    wanted = [("--plot", options.plot, PICTURES), ("--report", options.report, REPORTS)]
    with contextlib.ExitStack() as stack:
        yield {
            option: stack.enter_context(staged(option, path, suffixes, keep=options.file))
            for option, path, suffixes in wanted
            if path is not None
        }


OF_READER = ("columns", "units", "rate", "run", "length")


def read(path: str, known: dict[str, Any]) -> "list[Given]":
    """The records of a file, or a Refusal."""
    from libration.measurement._columns import content_of, runs_of_bytes, stated_of

    try:
        content = content_of(path)
    except (OSError, ValueError) as error:
        raise Refusal(f"{shown(path)}: cannot be read: {getattr(error, 'strerror', None) or error}") from error
    try:
        return runs_of_bytes(path, content, stated_of(**{name: known.get(name) for name in OF_READER}))
    except ValueError as error:
        raise Refusal(str(error)) from error


def fitted(givens: "list[Given]", known: dict[str, Any], apart: "Apart") -> "Fit | Together":
    """The fit of one record, or of several together, or a Refusal."""
    from libration.measurement._fit import fit_given
    from libration.measurement._fit_together import together_given
    from libration.measurement._known import known_of

    count = len(givens)
    if apart.lengths and len(apart.lengths) != count:
        times = counted(len(apart.lengths))
        records = "1 record" if count == 1 else f"{count} records"
        raise Refusal(
            f"--length: is given {times} for {records}; give it once for all, or once for each in their order"
        )
    if apart.pivots and count != 2:
        raise Refusal(f"--pivot: a reversible pendulum has two records, one about each pivot; {count} are given")
    if apart.lengths and known.get("monte_carlo"):
        raise Refusal("--monte-carlo: is for records of one pendulum, not for several lengths")
    others = {name: each for name, each in known.items() if name not in OF_READER or name == "length"}
    try:
        if count == 1:
            return fit_given(givens[0], known_of(**others), progress=True)
        return together_given(givens, known_of(**others), apart, progress=True)
    except ValueError as error:
        raise Refusal(str(error)) from error


FILE, KNOWN, READ, MODEL, RESULTS = (
    "the measurements",
    "what is known",
    "how the file is read",
    "the fit",
    "the results",
)
COMMAND = command(
    "fit",
    DESCRIPTION,
    run,
    FitOptions,
    short="from a data file to g: friction, uncertainty and verdicts",
    parameters=[
        Words("file", "FILE...", "files of measurements; several are fitted together (required)", FILE, offered=files),
        Values(
            "--length",
            "LENGTH",
            "equivalent length with its uncertainty, 0.650±0.010; gives g; once for each file where they differ",
            KNOWN,
            offered=units(LENGTH),
        ),
        Value("--gravity", "G", "local g, 9.7803±0.0002; gives the length", KNOWN, offered=units(GRAVITY)),
        Values("--part", "PART", "of a rigid pendulum, in place of --length: see below", KNOWN),
        Values(
            "--pivot",
            "DISTANCE",
            "of a reversible pendulum, from the centre of mass, for each of two files",
            KNOWN,
            offered=units(LENGTH),
        ),
        Value(
            "--between", "DISTANCE", "of its two pivots, in place of the second --pivot", KNOWN, offered=units(LENGTH)
        ),
        Value("--bob", "RADIUS[,MASS]", "of the ball on a thread, 12.5mm,66g, for corrections: see below", KNOWN),
        Value("--wire", "MASS", "of the thread or wire, for its correction", KNOWN),
        Value("--fluid", "FLUID", "air (default), water, or DENSITY,VISCOSITY", KNOWN, offered=words("air", "water")),
        Values(
            "--without",
            "CORRECTION",
            "that is not made: bob-size, wire-mass, buoyancy or added-mass",
            KNOWN,
            offered=words("bob-size", "wire-mass", "buoyancy", "added-mass"),
        ),
        Value("--scale", "U", "relative uncertainty of the angle's scale, such as 0.5%", KNOWN),
        Value("--clock", "U", "relative uncertainty of the clock's rate, such as 0.01%", KNOWN),
        Values("--column", "ROLE=NAME", "which column is time, angle, velocity, acceleration, x, y or period", READ),
        Values("--unit", "ROLE=UNIT", "in which unit, such as angle=deg or angle=4096/rev", READ),
        Value("--rate", "RATE", "samples in a second, for a file without times", READ),
        Value("--run", "N", "which of several runs in a file, from 1, or all of them", READ, offered=words("all")),
        Value("--model", "MODEL", f"{', '.join(MODELS)}: friction terms (default auto)", MODEL, offered=words(*MODELS)),
        Value(
            "--window", "FROM:TO", "the times that are fitted, 2s:40s (default: from the release to the stop)", MODEL
        ),
        Flag("--free-scale", "fit the scale of the angle too", MODEL),
        Value("--bootstrap", "N", "resamplings, to check the uncertainty of the noise", MODEL),
        Value("--monte-carlo", "N", "draws, to check the combined uncertainty, such as 10000", MODEL),
        Value("--seed", "N", "of the random numbers of both (default 1)", MODEL),
        Flag("--json", "print one JSON object", RESULTS),
        Value(
            "--report",
            "FILE",
            "write one page with all of it to an .html file, in the language of --lang",
            RESULTS,
            offered=files,
        ),
        *picture_options("the data with the curve, and the residuals"),
    ],
    usage=["libration fit", "FILE...", "[--length LENGTH | --gravity G | --part PART]", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
