"""`libration gravity`: g from one period, length and swing by the exact law, and the normal g of a place beside it."""

import math
from typing import Any

from libration.cli.files import strict
from libration.cli.help import Topic
from libration.cli.measures import measured
from libration.cli.offers import units
from libration.cli.parser import Flag, Options, Refusal, Value, command, refusal, shown
from libration.cli.quantities import ANGLE, LENGTH, TIME, has_unit, parts, quantity
from libration.cli.summary import print_lines

DESCRIPTION = """\
g of a pendulum from its period, its length and its swing, by the exact period of large swings, with the uncertainty of
each. With a latitude the normal g of the place stands beside it."""
TOPICS = (
    Topic(
        "uncertainty",
        text="""\
Standard uncertainties, k = 1, follow the value: 2.0218±0.0010, 2.0218+-0.0010s, 1.000(2)m, 20±1deg. They combine after
the GUM, 5.1.
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
    "libration gravity --latitude 52.1deg",
)


class GravityOptions(Options):
    """The options of `libration gravity`."""

    period: str | None
    length: str | None
    swing: str | None
    latitude: str | None
    height: str | None
    json: bool


def run(options: GravityOptions) -> None:
    """Print g from what was measured, that of the place, or both."""
    lines: list[tuple[str, str]] = []
    answer: dict[str, Any] = {}
    if options.period is None and options.length is None and options.latitude is None:
        raise Refusal(
            "missing --period and --length, such as --period 2.0218±0.0010 --length 1.000±0.001, or --latitude"
        )
    if options.period is not None or options.length is not None:
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
    try:
        (g, u), budget, small = _core.gravity_of_period(period, length, swing)
    except ValueError as error:
        raise Refusal(str(error)) from error
    found = Estimate(g, u, calibration=u)
    lines += [("g", f"{found} m/s^2 (standard uncertainty, k = 1; {found.expanded:.2g} at k = 2)")]
    lines += [
        ("" if number else "u of g", f"{part:.2g} m/s^2 from the {source}")
        for number, (source, part) in enumerate(budget)
    ]
    lines.append(("small swings", f"{small:.6g} m/s^2, by 4 pi^2 length / period^2"))
    if options.swing is None:
        lines.append(("", "Without --swing the swings are taken as small."))
    answer |= {"g": {"value": g, "u": u, "expanded": found.expanded}, "budget": dict(budget), "g_small_swings": small}


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
        lines.append(("difference", f"{rounded(difference, measured_g['u'])} m/s^2{apart}"))
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
        Value("--latitude", "ANGLE", "latitude, south negative", PLACE, offered=units(ANGLE)),
        Value("--height", "LENGTH", "above the sea (default 0)", PLACE, offered=units(LENGTH)),
        Flag("--json", "print one JSON object", RESULTS),
    ],
    usage=["libration gravity", "--period PERIOD", "--length LENGTH", "[options]"],
    topics=TOPICS,
    examples=EXAMPLES,
)
