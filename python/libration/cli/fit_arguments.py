"""The words of `libration fit` as arguments: what is known of the pendulum and its records, and how files are read."""

from decimal import Decimal
from typing import TYPE_CHECKING, Any

from libration.cli.measures import measured
from libration.cli.parser import Refusal, nearest, refusal, shown
from libration.cli.picture import PictureOptions
from libration.cli.quantities import GRAVITY, LENGTH, ONE, TIME, Dimension, plain, quantity, whole

if TYPE_CHECKING:
    from libration.measurement._together import Apart

MODELS = ("auto", "none", "linear", "quadratic", "dry", "presliding")
CORRECTIONS = ("bob size", "wire mass", "buoyancy", "added mass")
# In place of the number of a run.
ALL = "all"
G_OVER_LENGTH = "the motion holds g/length alone, so one of them is left to the fit"
# Of runs and of resamplings.
MOST = 100_000
DENSITY = Dimension("densities", {"kg/m3": ONE, "g/cm3": Decimal(1000)}, {})
VISCOSITY = Dimension("kinematic viscosities", {"m2/s": ONE, "mm2/s": Decimal("1e-6")}, {})
MASS = Dimension("masses", {"kg": ONE, "g": Decimal("0.001"), "mg": Decimal("1e-6"), "lb": Decimal("0.45359237")}, {})
RATE = Dimension("rates", {"1/s": ONE, "Hz": ONE}, {"/s": ONE, "fps": ONE})


class FitOptions(PictureOptions):
    """The options of `libration fit`."""

    file: tuple[str, ...]
    length: tuple[str, ...]
    pivot: tuple[str, ...]
    between: str | None
    gravity: str | None
    part: tuple[str, ...]
    bob: str | None
    wire: str | None
    fluid: str | None
    without: tuple[str, ...]
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
    monte_carlo: str | None
    seed: str | None
    json: bool
    report: str | None


def arguments(options: FitOptions) -> tuple[dict[str, Any], "Apart"]:
    """What is known of all records, and of each for itself, or a Refusal."""
    known: dict[str, Any] = {"columns": stated("--column", options.column), "units": stated("--unit", options.unit)}
    lengths = [measured("--length", text, LENGTH, above=0.0) for text in options.length]
    apart = apart_of(options, lengths)
    given = {"--length": options.length, "--gravity": options.gravity, "--part": options.part, "--pivot": options.pivot}
    names = [name for name, each in given.items() if each]
    if names[:2] == ["--length", "--gravity"]:
        both = f"--length = {shown(options.length[0])} and --gravity = {shown(options.gravity)}"
        raise Refusal(f"{both}: {G_OVER_LENGTH}; give one of the two")
    if len(names) > 1:
        other = next(name for name in names if name != names[-1])
        why = "parts give the length" if names[-1] == "--part" else "two pivots give g"
        raise Refusal(f"{names[-1]} and {other}: {why}, and {G_OVER_LENGTH}")
    if len(lengths) == 1:
        known["length"] = lengths[0]
    if options.gravity is not None:
        known["gravity"] = measured("--gravity", options.gravity, GRAVITY, above=0.0)
    known["parts"] = parts_of(options.part) if options.part else []
    known |= apparatus(options)
    if options.model is not None:
        if options.model not in MODELS:
            hint = nearest(options.model, MODELS, "see libration fit --help")
            raise refusal("--model", options.model, f"must be one of {', '.join(MODELS)}; {hint}")
        known["model"] = options.model
    if options.rate is not None:
        known["rate"] = quantity("--rate", options.rate, RATE, above=0.0)
    if options.run is not None:
        known["run"] = ALL if options.run == ALL else whole("--run", options.run, 1, MOST)
    if options.window is not None:
        known["window"] = window(options.window)
    if options.scale is not None:
        known["scale_u"] = share("--scale", options.scale)
    if options.clock is not None:
        known["clock_u"] = share("--clock", options.clock)
    if options.bootstrap is not None:
        known["bootstrap"] = whole("--bootstrap", options.bootstrap, 10, MOST)
    if options.monte_carlo is not None:
        known["monte_carlo"] = whole("--monte-carlo", options.monte_carlo, 100, 10 * MOST)
    if options.seed is not None:
        known["seed"] = whole("--seed", options.seed, 0, MOST)
    return known | {"free_scale": options.free_scale}, apart


def apart_of(options: FitOptions, lengths: list[tuple[float, float]]) -> "Apart":
    """Lengths of the records, or distances of their pivots, or a Refusal."""
    from libration.measurement._together import Apart

    pivots = [measured("--pivot", text, LENGTH, above=0.0) for text in options.pivot]
    between = None if options.between is None else measured("--between", options.between, LENGTH, above=0.0)
    if between is not None and not pivots:
        raise refusal("--between", options.between, "needs --pivot beside it, the first pivot from the centre of mass")
    if pivots and len(pivots) != (2 if between is None else 1):
        wanted = "twice, once for each of two files" if between is None else "once, for the first file"
        raise Refusal(f"--pivot: is given {counted(len(pivots))}; give it {wanted}")
    return Apart(lengths if len(lengths) > 1 else None, pivots or None, between)


def counted(count: int) -> str:
    """How many times."""
    return {1: "once", 2: "twice"}.get(count, f"{count} times")


def apparatus(options: FitOptions) -> dict[str, Any]:
    """Bob, wire and fluid, or a Refusal."""
    known: dict[str, Any] = {}
    if options.bob is not None:
        radius, _, mass = options.bob.partition(",")
        known["bob"] = (
            quantity("--bob", radius, LENGTH, above=0.0),
            quantity("--bob", mass, MASS, above=0.0) if mass else None,
        )
    if options.wire is not None:
        if "bob" not in known or known["bob"][1] is None:
            raise refusal("--wire", options.wire, "needs the mass of the bob beside it, --bob RADIUS,MASS")
        known["wire"] = quantity("--wire", options.wire, MASS, above=0.0)
    if options.part and known:
        raise Refusal(f"--{next(iter(known))} and --part: parts have their size and mass themselves")
    if options.fluid is not None:
        known["fluid"] = fluid(options.fluid)
    names = {name.replace(" ", "-"): name for name in CORRECTIONS}
    for each in options.without:
        if each not in names:
            raise refusal("--without", each, f"must be one of {', '.join(names)}; {nearest(each, names, 'see --help')}")
    for option, given in (("--fluid", options.fluid is not None), ("--without", bool(options.without))):
        if given and "bob" not in known:
            raise Refusal(f"{option}: needs --bob RADIUS,MASS beside it, whose corrections it is about")
    return known | {"without": [names[each] for each in options.without]}


def fluid(text: str) -> Any:
    """The name of a fluid, or its density and viscosity."""
    if text in ("air", "water"):
        return text
    density, comma, viscosity = text.partition(",")
    if not comma:
        raise refusal("--fluid", text, "must be air, water, or DENSITY,VISCOSITY such as 1025kg/m^3,1.05e-6m^2/s")
    return quantity("--fluid", density, DENSITY, above=0.0), quantity("--fluid", viscosity, VISCOSITY, above=0.0)


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
