"""Fits measured pendulums and prints what was asked of each, what came out, and whether it holds.

The records are those of other people and are no part of this project: `make labdata folder=PATH` says where they lie. What is asked
stands in that folder's README.md (by the number of its rows, within 5 % of the residuals that it names) and in section 8 of lab.md beside it.
"""

import math
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares

import libration

# Residuals of another fit of the same model are reached within this.
WITHIN = 1.05
DEGREE = 57.29577951308232


class Asked(NamedTuple):
    """A record, how it is given to the fit, and what its result must show: each in words, with what came out or None."""

    source: str
    file: str
    given: dict[str, Any]
    wanted: list[tuple[str, Callable[[dict[str, Any]], tuple[str, bool]]]]


def rms(model: str, most: float, unit: str = "deg", factor: float = DEGREE) -> tuple[str, Any]:
    """The residual of a rung of the ladder, or of the result where it has none."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        rungs = [rung["rms"] for rung in found["ladder"] if rung["model"] == model]
        value = factor * (rungs[0] if rungs else found["rms"])
        return f"{value:.3g} {unit}", value <= most

    return f"{model} {most:.3g} {unit}", holds


def near(omega0: float, relative: float = 0.003) -> tuple[str, Any]:
    """omega0 of another fit, within its model's spread."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        value = found["omega0"]
        close = abs(value["value"] - omega0) <= max(2 * value["u"], relative * omega0)
        return f"omega0 {value['value']:.4f} ± {value['u']:.1g}", close

    return f"omega0 {omega0:g}", holds


def says(words: str, stands: bool = False) -> tuple[str, Any]:
    """A verdict; by default one that forbids to quote the result."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        there = any(words in verdict for verdict in found["verdicts"])
        return f"says so: {'yes' if there else 'no'}", there and found["stands"] == stands

    return f"“{words}”", holds


def refused(words: str) -> tuple[str, Any]:
    """A refusal or a question of one line."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        line = found.get("refusal", "")
        return "refused" if line else "a fit", words in line and "\n" not in line

    return f"refused: {words}", holds


def scale(value: float, most: float) -> tuple[str, Any]:
    """The scale of the angle that the record asks for, with its residual."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        asked = found["diagnostics"]
        reached = DEGREE * asked["scale_rms"]
        return f"scale {asked['scale']:.3f}, {reached:.3f} deg", abs(asked["scale"] - value) < 0.03 and reached <= most

    return f"scale {value} with {most:.3g} deg", holds


def frequency(omega: float) -> tuple[str, Any]:
    """The angular frequency of the swings of a record: from that of the largest to omega0, which is that of the smallest."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        omega0 = found["omega0"]["value"]
        slowest = 2 * math.pi / libration.Pendulum(found["swing"], omega0=omega0).period
        return f"{slowest:.2f} to {omega0:.2f} rad/s", slowest <= omega <= omega0

    return f"swings at {omega:g} rad/s", holds


def rod_and_bob(off: float) -> tuple[str, Any]:
    """g from the parts, as what it says of omega0."""

    def holds(found: dict[str, Any]) -> tuple[str, bool]:
        part = (found["g"]["value"] / 9.81) ** 0.5 - 1
        return f"predicts omega0 to {100 * abs(part):.2f} %", abs(part) < off

    return f"geometry predicts omega0 to {100 * off:g} %", holds


PARTS = [("rod", 0.019, 0.2475, 0.495), ("point", 0.031, 0.495, 0.0)]
SPEED = {"unit": "rad/s", "factor": 1.0}
PATH = {"unit": "m/s^2", "factor": 1.0}
# Of a sensor with a unit of its own: swings of a degree or less, where omega0 does not depend on it.
SMALL = {"angle": "36000/rev"}

ROWS = [
    Asked("section 8", "dev/labprob2_wah.csv", {}, [rms("dry", 0.22), rms("presliding", 0.09)]),
    Asked("section 8", "dev/toronto_data32.csv", {}, [rms("dry", 0.41)]),
    Asked("section 8", "dev/pendulepi_p0.csv", {}, [rms("quadratic", 0.15)]),
    Asked("section 8", "dev/pendulepi_p2.csv", {}, [rms("quadratic", 0.08)]),
    Asked("section 8", "dev/pendulepi_p4.csv", {}, [rms("quadratic", 0.06)]),
    Asked("section 8", "dev/pendulepi_p6.csv", {}, [rms("quadratic", 0.11)]),
    Asked("section 8", "dev/bookip_cdip.csv", {}, [rms("presliding", 0.085)]),
    Asked("section 8", "dev/toronto_tracker_3.csv", {}, [rms("quadratic", 0.13)]),
    Asked("section 8", "control/jensen_02.csv", {}, [says("base moves or the friction law is wrong")]),
    Asked("section 8", "control/toronto_deg.csv", {}, [says("linear cosine")]),
    Asked("section 8", "dev/pendulepi_p2.csv", {"parts": PARTS}, [rod_and_bob(0.01)]),
    Asked("1", "raw/toronto_encoder/data32.csv", {}, [near(6.1008), rms("dry", WITHIN * 0.40)]),
    Asked("2", "dev/multiarm_small_dry.csv", {}, [near(8.005)]),
    Asked("3", "dev/pendulepi_p0.csv", {}, [near(4.6623), rms("linear", WITHIN * 0.209)]),
    Asked("3", "dev/pendulepi_p2.csv", {}, [near(4.6638), rms("linear", WITHIN * 0.079)]),
    Asked("3", "dev/pendulepi_p4.csv", {}, [near(4.6672), rms("linear", WITHIN * 0.059)]),
    Asked("3", "dev/pendulepi_p6.csv", {}, [near(4.662)]),
    Asked("3", "dev/pendulepi_p8.csv", {}, [near(4.662)]),
    Asked(
        "4",
        "raw/bookip/cdip_pend_data.mat",
        {},
        [near(5.7742), rms("presliding", WITHIN * 0.081)],
    ),
    # The other fit has 110 s, and its friction is found again: the swings after them double what is left.
    Asked(
        "4",
        "raw/bookip/cdip_pend_data.mat",
        {"window": (4.4, 114.4)},
        [near(5.7742), rms("dry", WITHIN * 0.242)],
    ),
    Asked(
        "5",
        "raw/labprob2/idf_wah.mat",
        {},
        [near(4.6873), rms("presliding", WITHIN * 0.087)],
    ),
    # The samples of the other fit, which begins after the handling.
    Asked(
        "5",
        "raw/labprob2/idf_wah.mat",
        {"window": (8.06, 178.46)},
        [near(4.6873), rms("dry", WITHIN * 0.213), rms("presliding", WITHIN * 0.087)],
    ),
    Asked("6", "raw/toronto_tracker/AAAtAmp3.txt", {}, [near(2.8794), rms("quadratic", WITHIN * 0.129)]),
    Asked("8", "raw/pisa_photogate/prima.txt", {}, [near(2.9335, 0.005)]),
    Asked("8", "raw/pisa_photogate/sesta25.txt", {}, [near(2.9335, 0.005)]),
    Asked("8", "raw/pisa_photogate/terza15.txt", {}, [near(2.9335, 0.005)]),
    Asked("9", "dev/disc_driven_a.csv", {}, [says("base moves or the friction law is wrong")]),
    Asked("9", "dev/disc_driven_a.csv", {"torque": "u_volt"}, [rms("dry", WITHIN * 0.82)]),
    Asked("11", "raw/control/pendulum_free_swing_data_02.txt", {}, [says("base moves or the friction law is wrong")]),
    Asked("12", "raw/control/pendulum_extended.txt", {}, [says("linear cosine")]),
    Asked(
        "14",
        "raw/phone_gyro/Gyroscope.csv",
        {"window": (80.0, 100.0)},
        [near(4.699), rms("linear", WITHIN * 0.0067, **SPEED)],
    ),
    Asked("14", "raw/phone_gyro/Gyroscope.csv", {}, [says("waveform is not a rigid pendulum's")]),
    Asked("15", "raw/phone_linacc/l2LongTheta60.csv", {}, [near(6.150)]),
    Asked(
        "15",
        "raw/phone_linacc/l2LongTheta60.csv",
        {"window": (4.0, 41.0)},
        [near(6.150), rms("quadratic", WITHIN * 0.175, **PATH)],
    ),
    Asked("16", "raw/tracker_rot90/Data.txt", {}, [near(3.822), rms("linear", WITHIN * 0.49)]),
    Asked("17", "raw/tracker_150mm/150_1.txt", {"length": 0.150}, [near(8.17, 0.006), rms("linear", WITHIN * 0.51)]),
    Asked("17", "raw/tracker_150mm/150_1.txt", {}, [refused("how far is the tracked point from the pivot?")]),
    Asked(
        "17",
        "raw/tracker_150mm/150_2.txt",
        {},
        [near(8.099), rms("quadratic", WITHIN * 0.26), says("two points per swing", True)],
    ),
    Asked("18", "raw/tracker_noheader/data.csv", {}, [near(3.668), rms("quadratic", WITHIN * 0.35)]),
    Asked(
        "19",
        "raw/tracker_86deg/pendulum_data_from_tracker.txt",
        {"window": (0.0, 60.0)},
        [near(5.717), rms("quadratic", WITHIN * 1.74)],
    ),
    Asked("19", "raw/tracker_86deg/pendulum_data_from_tracker.txt", {}, [rms("quadratic", WITHIN * 2.2)]),
    Asked("20", "raw/tracker_trk/pendulum_length1.trk", {}, [near(2.902), rms("linear", WITHIN * 0.49)]),
    Asked("21", "raw/excel_3digits/Aire1.csv", {"run": 1}, [near(4.1646), rms("linear", WITHIN * 0.228)]),
    Asked("21", "raw/excel_3digits/Aire1.csv", {"run": 2}, [near(4.1633), rms("linear", WITHIN * 0.319)]),
    Asked("21", "raw/excel_3digits/Aire1.csv", {"run": 3}, [near(4.1634), rms("linear", WITHIN * 0.129)]),
    Asked("22", "raw/encoder_68deg/galileo_15-25-54.csv", {}, [near(4.6333), rms("dry", WITHIN * 0.134)]),
    Asked(
        "23",
        "raw/pasco_ptbr/serie_3.csv",
        {},
        [near(5.629), rms("quadratic", WITHIN * 0.407), scale(0.974, WITHIN * 0.185)],
    ),
    Asked("24", "raw/microbit/data_697.txt", {}, [refused("which column is the angle?")]),
    Asked("24", "raw/microbit/data_697.txt", {"columns": {"acceleration": "3"}}, [frequency(6.78)]),
    Asked("25", "raw/adc_two_clocks/single_pendulum.txt", {}, [refused("the unit of Pos A is not known")]),
    Asked("25", "raw/adc_two_clocks/single_pendulum.txt", {"units": SMALL}, [near(4.4515)]),
    Asked(
        "25",
        "raw/adc_two_clocks/single_pendulum_damped.txt",
        {"units": SMALL, "window": (8.0, 51.0)},
        [near(4.440)],
    ),
    Asked("26", "raw/opencv_pixels/263.csv", {}, [near(6.222), rms("linear", WITHIN * 0.139)]),
    Asked("27", "raw/tables/period_vs_angle.txt", {}, [near(5.007), rms("none", WITHIN * 9.6, "ms", 1e3)]),
    Asked("28", "raw/tables/reversion_Aufgabe1.txt", {}, [refused("has no column")]),
    Asked("29", "raw/control/pohl_Winkelzeit.txt", {}, [says("does not depend on the swing")]),
    Asked("30", "raw/control/bifilar_gates.CSV", {}, [says("more than one mode")]),
]


def driven(path: Path, torque: str) -> dict[str, Any]:
    """The first 30 s of a disc under a motor's voltage, which acts one sample late, by SciPy over `DampedPendulum`."""
    head = path.read_text(encoding="utf-8").split("\n", 1)[0].split(",")
    t, theta, voltage = np.loadtxt(path, delimiter=",", skiprows=1, max_rows=1200).T
    assert head[2] == torque
    late = np.concatenate([[0.0], voltage[:-1]])

    def residuals(values: Any) -> Any:
        velocity0, omega0, linear, dry, gain, rest = values
        friction = libration.Friction(linear=linear, dry=abs(dry))
        moment = libration.Torque(samples=(t, gain * late), interpolation="steps")
        disc = libration.DampedPendulum(theta[0] - rest, velocity0, omega0=omega0, friction=friction, torque=moment)
        return disc.theta(t) + rest - theta

    size = [0.1, 0.1, 0.05, 0.3, 1.0, 0.02]
    found = least_squares(residuals, [0.0, 11.0, 0.5, 6.0, 28.0, 0.0], x_scale=size, diff_step=1e-5)
    left = math.sqrt(np.mean(found.fun**2))
    return {"model": "dry", "ladder": [], "rms": left, "rms_deg": math.degrees(left), "stands": True, "verdicts": []}


def answer(path: Path, given: dict[str, Any]) -> dict[str, Any]:
    """The result as a dictionary, or its refusal."""
    if "torque" in given:
        return driven(path, **given)
    try:
        return libration.fit(path, **given).to_dict()
    except ValueError as error:
        return {"refusal": str(error)}


def row(asked: Asked, folder: Path) -> tuple[list[str], bool]:
    """A line of the table."""
    begun = time.process_time()
    found = answer(folder / asked.file, asked.given)
    seconds = time.process_time() - begun
    shown, good = [], True
    for words, holds in asked.wanted:
        if "refusal" in found and not words.startswith("refused"):
            came, kept = "refused", False
        else:
            came, kept = holds(found)
        shown.append(came if kept else f"{came} (!)")
        good &= kept
    where = Path(asked.file).name
    stated = ", ".join(f"{name}={'parts' if name == 'parts' else value}" for name, value in asked.given.items())
    wanted = "; ".join(words for words, _ in asked.wanted)
    chosen = found.get("model", "")
    left = f"{found['rms_deg']:.3f}" if found.get("rms_deg") is not None else ""
    grade = "refused" if "refusal" in found else "quoted" if found["stands"] else "refuted"
    cells = [asked.source, f"{where} {stated}".strip(), wanted, "; ".join(shown), chosen, left, grade, f"{seconds:.1f}"]
    return [*cells, "holds" if good else "FALLS SHORT"], good


def main(folder: Path) -> int:
    """Prints the table; 2 without the folder, 1 where a row falls short."""
    if not (folder / "README.md").is_file():
        print(f"{folder}: no such folder of measured pendulums; write make labdata folder=PATH", file=sys.stderr)
        return 2
    head = ["row", "record", "asked", "came out", "chosen", "rms deg", "result", "CPU s", ""]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    short = 0
    for asked in ROWS:
        cells, good = row(asked, folder)
        short += not good
        print("| " + " | ".join(cells) + " |", flush=True)
    print(f"\n{len(ROWS) - short} of {len(ROWS)} rows hold.")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
