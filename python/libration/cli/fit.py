"""`libration fit`: from data files to omega0, g or the length, with friction, uncertainty and verdicts.

Every file is read and fitted before anything is printed or written, so that a refusal leaves nothing half done.
"""

import contextlib
from collections.abc import Iterator
from decimal import Decimal
from typing import TYPE_CHECKING, Any, BinaryIO

from libration.cli.files import staged, strict
from libration.cli.help import Topic
from libration.cli.measures import measured
from libration.cli.offers import files, units, words
from libration.cli.parser import (
    Finding,
    Flag,
    Refusal,
    Value,
    Values,
    Words,
    command,
    nearest,
    refusal,
    shown,
)
from libration.cli.picture import (
    PICTURES,
    PictureOptions,
    check_matplotlib,
    check_plot,
    drawing,
    form,
    picture_look,
    picture_options,
)
from libration.cli.quantities import GRAVITY, LENGTH, ONE, TIME, Dimension, plain, quantity, whole

if TYPE_CHECKING:
    from libration import Fit

MODELS = ("auto", "none", "linear", "quadratic", "dry", "presliding")
REPORTS = (".html", ".htm")
# Of runs and of resamplings.
MOST = 100_000

DESCRIPTION = """\
Fits a pendulum with friction to measurements: a file of a video tracker, a phone, a photogate or an encoder. Prints what
was understood of the file and what was left out, omega0 with an honest uncertainty, g from the length or the length from
g, the friction, and what speaks against the result. Needs no start values."""

TOPICS = (
    Topic(
        "files",
        text="""\
Text tables with any separator and decimal sign, Tracker (.txt, .trk), phyphox (.csv, .xls, .zip), Vernier, PASCO, .xlsx,
photogate times, tables of periods against angles. Nothing is resampled. Where a file leaves a question open, it is asked
in one line, with the option that answers it.
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
        "uncertainty",
        text="""\
After the GUM, k = 1: noise with its correlation in time, the choice of the friction model, and length, scale and clock.
A length is given as 0.650±0.010, 0.650+-0.010, 65.0(10)cm or 65cm±1%.
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
    "libration fit a.csv b.csv --column angle=theta --model dry --json",
)
MASS = Dimension("masses", {"kg": ONE, "g": Decimal("0.001"), "lb": Decimal("0.45359237")}, {})
RATE = Dimension("rates", {"1/s": ONE, "Hz": ONE}, {"fps": ONE})


class FitOptions(PictureOptions):
    """The options of `libration fit`."""

    file: tuple[str, ...]
    length: str | None
    gravity: str | None
    part: tuple[str, ...]
    model: str | None
    column: tuple[str, ...]
    unit: tuple[str, ...]
    rate: str | None
    run: str | None
    window: str | None
    scale: str | None
    clock: str | None
    free_scale: bool
    bootstrap: str | None
    json: bool
    report: str | None


def run(options: FitOptions) -> None:
    """Fit what the words ask for, write the files, print the results."""
    if not options.file:
        raise Refusal("missing FILE: the measurements, such as swing.csv; see libration fit --help")
    known = arguments(options)
    look = picture_look(options, options.plot)
    if len(options.file) > 1 and (options.plot or options.report):
        given = "--plot" if options.plot else "--report"
        raise refusal(given, options.plot or options.report, f"shows one file, and {len(options.file)} are given")
    check_plot(options)
    if options.report is not None:
        check_matplotlib("--report", options.report, "plot")
    with targets(options) as opened:
        found = [fitted(path, known) for path in options.file]
        written = []
        if options.plot is not None:
            with drawing("--plot", options.plot):
                found[0].plot(opened["--plot"], form=form(options.plot), **look)
            written.append(options.plot)
        if options.report is not None:
            opened["--report"].write(found[0].report().encode())
            written.append(options.report)
    for number, each in enumerate(found):
        if options.json:
            print(strict(each.to_dict() | {"files": written}))
        else:
            print(("\n" if number else "") + str(each))
    if not options.json:
        for path in written:
            print(f"written   {path}")
    fallen = [(path, each) for path, each in zip(options.file, found, strict=True) if not each.stands]
    if fallen:
        path, each = fallen[0]
        more = f" (and {len(fallen) - 1} more)" if len(fallen) > 1 else ""
        raise Finding(f"{shown(path)}: {each.verdicts[0]}{more}")


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


def arguments(options: FitOptions) -> dict[str, Any]:
    """The arguments of `libration.fit`, or a Refusal."""
    known: dict[str, Any] = {"columns": stated("--column", options.column), "units": stated("--unit", options.unit)}
    if options.length is not None and options.gravity is not None:
        reason = "the motion holds g/length alone, so one of them is left to the fit; give one of the two"
        raise Refusal(f"--length = {shown(options.length)} and --gravity = {shown(options.gravity)}: {reason}")
    if options.length is not None:
        known["length"] = measured("--length", options.length, LENGTH, above=0.0)
    if options.gravity is not None:
        known["gravity"] = measured("--gravity", options.gravity, GRAVITY, above=0.0)
    if options.part:
        other = "--length" if options.length is not None else "--gravity"
        if options.length is not None or options.gravity is not None:
            raise Refusal(f"--part and {other}: parts give the length, and one of length and g is left to the fit")
        known["parts"] = parts_of(options.part)
    if options.model is not None:
        if options.model not in MODELS:
            hint = nearest(options.model, MODELS, "see libration fit --help")
            raise refusal("--model", options.model, f"must be one of {', '.join(MODELS)}; {hint}")
        known["model"] = options.model
    if options.rate is not None:
        known["rate"] = quantity("--rate", options.rate, RATE, above=0.0)
    if options.run is not None:
        known["run"] = whole("--run", options.run, 1, MOST)
    if options.window is not None:
        known["window"] = window(options.window)
    if options.scale is not None:
        known["scale_u"] = share("--scale", options.scale)
    if options.clock is not None:
        known["clock_u"] = share("--clock", options.clock)
    if options.bootstrap is not None:
        known["bootstrap"] = whole("--bootstrap", options.bootstrap, 10, MOST)
    return known | {"free_scale": options.free_scale}


def stated(option: str, given: tuple[str, ...]) -> dict[str, str]:
    """ROLE=NAME by role, or a Refusal."""
    roles = ("time", "angle", "velocity", "acceleration", "x", "y", "period")
    found: dict[str, str] = {}
    for text in given:
        role, equals, name = text.partition("=")
        if not equals or not name.strip() or role.strip() not in roles:
            word = "NAME" if option == "--column" else "UNIT"
            raise refusal(option, text, f"must be ROLE={word}, where ROLE is one of {', '.join(roles)}")
        if role.strip() in found:
            raise refusal(option, text, f"{role.strip()} is given twice")
        found[role.strip()] = name.strip()
    return found


def parts_of(texts: tuple[str, ...]) -> list[Any]:
    """Shape, mass, distance and size of each part, or a Refusal."""
    found: list[Any] = []
    for text in texts:
        shape, colon, rest = text.partition(":")
        # A comma parts values; a decimal comma would be taken for it, so numbers here have points.
        values = rest.split(",")
        counts = {"rod": (2, 3), "ball": (3,), "disc": (3,), "point": (2,)}.get(shape, ())
        if not colon or len(values) not in counts:
            allowed = "rod:LENGTH,MASS[,DISTANCE], ball:DISTANCE,MASS,RADIUS, disc:DISTANCE,MASS,RADIUS or point:DISTANCE,MASS"
            raise refusal("--part", text, f"must be {allowed}")
        first = measured("--part", values[0], LENGTH, least=0.0)
        mass = measured("--part", values[1], MASS, least=0.0)
        third = measured("--part", values[2], LENGTH) if len(values) == 3 else (0.0, 0.0)
        if shape == "rod":
            # The centre of a rod that hangs from the pivot; its uncertainty is that of the end.
            centre = third if len(values) == 3 else (first[0] / 2, first[1] / 2)
            found.append((shape, mass, centre, first))
        else:
            found.append((shape, mass, first, third))
    from libration import _core

    try:
        _core.equivalent_length(found)
    except ValueError as error:
        raise Refusal(f"--part: {error}") from error
    return found


def share(option: str, text: str) -> float:
    """A relative uncertainty, `0.5%` or `0.005`, or a Refusal."""
    percent = text.strip().endswith("%")
    value = plain(option, text.strip().removesuffix("%")) / (100 if percent else 1)
    if not 0 <= value < 1:
        raise refusal(option, text, "must be a relative uncertainty from 0 to 1, such as 0.5% or 0.005")
    return value


def window(text: str) -> tuple[float, float]:
    """Two times, `2s:40s` or `2:40`, or a Refusal."""
    first, colon, last = text.partition(":")
    if not colon or not first.strip() or not last.strip():
        raise refusal("--window", text, "must be two times with a colon between, such as 2s:40s")
    found = quantity("--window", first, TIME), quantity("--window", last, TIME)
    if not found[0] < found[1]:
        raise refusal("--window", text, "the second time must be later than the first")
    return found


def fitted(path: str, known: dict[str, Any]) -> "Fit":
    """The fit of a file, or a Refusal."""
    from libration.measurement._columns import of_bytes, stated_of
    from libration.measurement._fit import fit_given

    try:
        with open(path, "rb") as file:
            content = file.read()
    except (OSError, ValueError) as error:
        raise Refusal(f"{shown(path)}: cannot be read: {getattr(error, 'strerror', None) or error}") from error
    of_reader = ("columns", "units", "rate", "run", "length")
    reader = stated_of(**{name: known.get(name) for name in of_reader})
    others = {name: each for name, each in known.items() if name not in ("columns", "units", "rate", "run")}
    try:
        return fit_given(of_bytes(path, content, reader), **others)
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
        Words("file", "FILE...", "files of measurements, each fitted by itself (required)", FILE, offered=files),
        Value(
            "--length",
            "LENGTH",
            "equivalent length with its uncertainty, 0.650±0.010; gives g",
            KNOWN,
            offered=units(LENGTH),
        ),
        Value("--gravity", "G", "local g, 9.7803±0.0002; gives the length", KNOWN, offered=units(GRAVITY)),
        Values("--part", "PART", "of a rigid pendulum, in place of --length: see below", KNOWN),
        Value("--scale", "U", "relative uncertainty of the angle's scale, such as 0.5%", KNOWN),
        Value("--clock", "U", "relative uncertainty of the clock's rate, such as 0.01%", KNOWN),
        Values("--column", "ROLE=NAME", "which column is time, angle, velocity, acceleration, x, y or period", READ),
        Values("--unit", "ROLE=UNIT", "in which unit, such as angle=deg or angle=4096/rev", READ),
        Value("--rate", "RATE", "samples in a second, for a file without times", READ),
        Value("--run", "N", "which of several runs in a file, from 1", READ),
        Value("--model", "MODEL", f"{', '.join(MODELS)}: friction terms (default auto)", MODEL, offered=words(*MODELS)),
        Value(
            "--window", "FROM:TO", "the times that are fitted, 2s:40s (default: from the release to the stop)", MODEL
        ),
        Flag("--free-scale", "fit the scale of the angle too", MODEL),
        Value("--bootstrap", "N", "resamplings, to check the uncertainty of the noise", MODEL),
        Flag("--json", "print one JSON object for each file", RESULTS),
        Value("--report", "FILE", "write one page with all of it to an .html file", RESULTS, offered=files),
        *picture_options("the data with the curve, and the residuals"),
    ],
    usage=["libration fit", "FILE...", "[--length LENGTH | --gravity G]", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
