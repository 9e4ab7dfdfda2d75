"""`libration gravity`: g from one period, length and swing by the exact law, or of a reversible pendulum, and the normal g of a place."""

import json
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from libration.cli.files import strict
from libration.cli.help import Topic
from libration.cli.language import decimal, told
from libration.cli.measures import measured
from libration.cli.offers import units
from libration.cli.parser import Flag, Options, Refusal, Value, Values, command, refusal, shown
from libration.cli.quantities import ANGLE, LENGTH, TIME, has_unit, parts, quantity
from libration.cli.summary import print_lines

if TYPE_CHECKING:
    from libration import Estimate

Pair: TypeAlias = tuple[float, float]

DESCRIPTION = """\
g of a pendulum from its period, its length and its swing, by the exact period of large swings, with the uncertainty of
each; or of a reversible pendulum from its periods about two pivots. With a latitude the normal g of the place stands beside it."""
TOPICS = (
    Topic(
        "uncertainty",
        text="""\
Standard uncertainties, k = 1, follow the value: 2.0218±0.0010, 2.0218+-0.0010s, 1.000(2)m, 20±1deg. They combine after
the GUM, 5.1.
""",
    ),
    Topic(
        "a swing that decays",
        text="""\
With --end the swing falls, by linear friction, from --swing to that angle while periods are counted: --period is their mean.
""",
    ),
    Topic(
        "reversible pendulum",
        text="""\
Kater's, as Bessel evaluates it: --pivot twice, each with the period about it and its distance from the centre of mass, on
either side of it. A swing beside them reduces the period to that of small swings. With --between, the distance of the two
pivots, which is measured better, the second pivot has its period alone: the nearer the periods, the less the other distance
counts.
""",
    ),
    Topic(
        "normal g",
        text="""\
Somigliana's formula on the ellipsoid WGS 84, with the height to second order (NIMA TR 8350.2, equations 4-1 and 4-3).
Local masses move the true g by some 0.0005 m/s^2, seldom by more than 0.002.
""",
    ),
)
EXAMPLES = (
    "libration gravity --period 2.022±0.001 --length 1.000±0.001 --swing 20±1deg",
    "libration gravity --period 2.0218s --length 1m --swing 20deg --latitude -23.5deg",
    "libration gravity --period 2.0396s --length 1m --swing 40deg --end 20±1deg",
    "libration gravity --latitude 52.1deg",
    "libration gravity --pivot 2.0061±0.0001s,0.66m --pivot 2.0063±0.0001s,0.34m",
    "libration gravity --pivot 2.0061s,66cm --pivot 2.0063s --between 1.00010±0.00001m",
)


class GravityOptions(Options):
    """The options of `libration gravity`."""

    period: str | None
    length: str | None
    swing: str | None
    end: str | None
    pivot: tuple[str, ...]
    between: str | None
    latitude: str | None
    height: str | None
    json: bool


def run(options: GravityOptions) -> None:
    """Print g from what was measured, that of the place, or both."""
    lines: list[tuple[str, str]] = []
    answer: dict[str, Any] = {}
    if not (options.period or options.length or options.pivot or options.latitude):
        raise Refusal(
            "missing --period and --length, such as --period 2.0218±0.0010 --length 1.000±0.001, or --pivot, or --latitude"
        )
    single = {"--period": options.period, "--length": options.length, "--swing": options.swing, "--end": options.end}
    beside = [option for option, given in single.items() if given is not None]
    if options.pivot and beside:
        raise Refusal(f"--pivot and {beside[0]}: each pivot has its period, distance and swing itself")
    if options.end is not None and options.swing is None:
        raise refusal("--end", options.end, "needs --swing beside it, the turning angle at the begin")
    if options.between is not None and not options.pivot:
        raise refusal("--between", options.between, "needs --pivot twice beside it")
    if options.pivot:
        from_pivots(options, lines, answer)
    elif options.period is not None or options.length is not None:
        from_period(options, lines, answer)
    elif options.swing is not None:
        raise refusal("--swing", options.swing, "needs --period and --length beside it")
    if options.latitude is not None:
        of_place(options, lines, answer)
    elif options.height is not None:
        raise refusal("--height", options.height, "needs --latitude beside it")
    if options.json:
        print(strict(answer))
    else:
        print_lines(lines)


def from_period(options: GravityOptions, lines: list[tuple[str, str]], answer: dict[str, Any]) -> None:
    """g from the period, with its budget."""
    from libration import _core
    from libration.measurement._estimate import Estimate

    if options.period is None or options.length is None:
        missing = "--period" if options.period is None else "--length"
        raise Refusal(f"missing {missing}: period and length together give g")
    period = measured("--period", options.period, TIME, above=0.0)
    length = measured("--length", options.length, LENGTH, above=0.0)
    swing = (0.0, 0.0) if options.swing is None else measured("--swing", options.swing, ANGLE)
    if not abs(swing[0]) < math.pi:
        raise refusal("--swing", str(options.swing), "must be less than 180deg in size, the turning angle")
    end = None if options.end is None else measured("--end", options.end, ANGLE)
    if end is not None:
        for name, text, (angle, _) in (("--swing", options.swing, swing), ("--end", options.end, end)):
            if not 0 < angle < math.pi:
                raise refusal(name, str(text), "must be greater than 0 and less than 180deg where the swing decays")
    try:
        (g, u), budget, small = _core.gravity_of_period(period, length, swing, end)
    except ValueError as error:
        raise Refusal(str(error)) from error
    found = Estimate(g, u, calibration=u)
    lines += with_budget(found, budget)
    lines.append(("small swings", f"{small:.6g} m/s^2, by 4 pi^2 length / period^2"))
    if options.swing is None:
        lines.append(("", "Without --swing the swings are taken as small."))
    answer |= {"g": {"value": g, "u": u, "expanded": found.expanded}, "budget": dict(budget), "g_small_swings": small}


def with_budget(found: "Estimate", budget: Sequence[tuple[str, float]]) -> list[tuple[str, str]]:
    """g with its uncertainty and the parts of it."""
    if not found.u:
        return [("g", f"{found} m/s^2, from values without an uncertainty")]
    lines = [("g", f"{found} m/s^2 (standard uncertainty, k = 1; {found.expanded:.2g} at k = 2)")]
    return lines + [
        ("" if number else "u of g", f"{u:.2g} m/s^2 from the {source}") for number, (source, u) in enumerate(budget)
    ]


def from_pivots(options: GravityOptions, lines: list[tuple[str, str]], answer: dict[str, Any]) -> None:
    """g of a reversible pendulum, with its budget."""
    from libration import _core
    from libration.measurement._estimate import estimate
    from libration.measurement._gravity import pivots_of

    if len(options.pivot) != 2:
        raise Refusal("--pivot: is needed twice, PERIOD,DISTANCE about one pivot and the other")
    between = None if options.between is None else measured("--between", options.between, LENGTH, above=0.0)
    given = [pivot(text, between is not None and number == 1) for number, text in enumerate(options.pivot)]
    periods, distances, swings = zip(*given, strict=True)
    try:
        told, _ = _core.gravity_of_pivots(*pivots_of(periods, distances, between, swings), between is not None)
    except ValueError as error:
        raise Refusal(f"--pivot: {error}") from error
    made = json.loads(told)
    found = estimate(made["g"])
    assert found is not None
    lines += with_budget(found, [(row["source"], row["u"]) for row in made["budget"]])
    lines += [("warning", sentence) for sentence in made["verdicts"]]
    answer |= {"g": {"value": found.value, "u": found.u, "expanded": found.expanded}}
    answer |= {"budget": {row["source"]: row["u"] for row in made["budget"]}, "verdicts": made["verdicts"]}


def pivot(text: str, alone: bool) -> tuple[Pair, Pair, Pair]:
    """Period, distance and swing about a pivot, or a Refusal; `alone` where the distance may be missing."""
    values = text.split(",")
    if not (1 if alone else 2) <= len(values) <= 3:
        raise refusal("--pivot", text, "must be PERIOD,DISTANCE or PERIOD,DISTANCE,SWING, with decimal points")
    period = measured("--pivot", values[0], TIME, above=0.0)
    distance = measured("--pivot", values[1], LENGTH, above=0.0) if len(values) > 1 and values[1] else (1.0, 0.0)
    swing = measured("--pivot", values[2], ANGLE) if len(values) == 3 else (0.0, 0.0)
    if not abs(swing[0]) < math.pi:
        raise refusal("--pivot", text, "the swing must be less than 180deg in size, the turning angle")
    return period, distance, swing


def of_place(options: GravityOptions, lines: list[tuple[str, str]], answer: dict[str, Any]) -> None:
    """The normal g of the place, and how far the measured one is from it."""
    from libration import normal_gravity
    from libration.measurement._estimate import rounded

    assert options.latitude is not None
    if not has_unit(options.latitude) and parts(options.latitude)[0] is not None:
        reason = f"needs its unit; for degrees write {shown(options.latitude.strip())}deg"
        raise refusal("--latitude", options.latitude, reason)
    latitude = quantity("--latitude", options.latitude, ANGLE)
    if abs(latitude) > math.pi / 2:
        raise refusal("--latitude", options.latitude, "must be from -90deg to 90deg")
    height = 0.0 if options.height is None else quantity("--height", options.height, LENGTH)
    try:
        normal = normal_gravity(latitude, height)
    except ValueError as error:
        raise refusal("--height", str(options.height), str(error).partition(": ")[2]) from error
    lines.append(("normal g", f"{normal:.5f} m/s^2 at {math.degrees(latitude):.6g} deg, {height:g} m (WGS 84)"))
    answer["normal_g"] = normal
    measured_g = answer.get("g")
    if isinstance(measured_g, dict):
        difference = measured_g["value"] - normal
        apart = f", {abs(difference) / measured_g['u']:.1f} standard uncertainties" if measured_g["u"] > 0 else ""
        lines.append(("difference", f"{decimal(rounded(difference, measured_g['u']))} m/s^2{told(apart)}"))
        answer["difference"] = difference


MEASURED, PLACE, RESULTS = "what was measured", "the place", "the results"
COMMAND = command(
    "gravity",
    DESCRIPTION,
    run,
    GravityOptions,
    short="g from a period by the exact law, and the normal g of a place",
    parameters=[
        Value("--period", "PERIOD", "of one whole swing, with its uncertainty", MEASURED, offered=units(TIME)),
        Value("--length", "LENGTH", "the equivalent length, with its uncertainty", MEASURED, offered=units(LENGTH)),
        Value(
            "--swing",
            "ANGLE",
            "the turning angle, with its uncertainty (default: small)",
            MEASURED,
            offered=units(ANGLE),
        ),
        Value("--end", "ANGLE", "the turning angle at the end, where it decays", MEASURED, offered=units(ANGLE)),
        Values("--pivot", "PERIOD,DISTANCE[,SWING]", "of a reversible pendulum, for each of its two pivots", MEASURED),
        Value("--between", "DISTANCE", "of its two pivots, in place of the second from the centre of mass", MEASURED),
        Value("--latitude", "ANGLE", "latitude, south negative", PLACE, offered=units(ANGLE)),
        Value("--height", "LENGTH", "above the sea (default 0)", PLACE, offered=units(LENGTH)),
        Flag("--json", "print one JSON object", RESULTS),
    ],
    usage=["libration gravity", "[--period PERIOD --length LENGTH | --pivot PIVOT --pivot PIVOT]", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
