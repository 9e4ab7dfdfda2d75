"""The film that `libration solve` makes: its file, its frames and its pace."""

import contextlib
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, BinaryIO, Protocol

import click

from libration.cli.files import staged
from libration.cli.offers import files
from libration.cli.parser import Options, Value, refusal
from libration.cli.picture import Look, check_package, drawing
from libration.cli.quantities import plain

if TYPE_CHECKING:
    from libration._arrays import Floats

FILMS = (".gif", ".mp4")


class AnimationOptions(Options):
    """The options of a film, as typed."""

    animate: str | None
    fps: str | None
    speed: str | None


class FilmOptions(Protocol):
    """The options that a film asks for, beside its own those of the instants."""

    animate: str | None
    fps: str | None
    speed: str | None
    until: str | None
    times: str | None


def animation_options() -> list[click.Option]:
    """The options of a film."""
    group = "the film"
    shows = "draw the moving pendulum to a .gif or .mp4 file: one period without a seam, or the time of --until"
    return [
        Value("--animate", "FILE", shows, group, offered=files),
        Value("--fps", "N", "frames in a second of the film, at most; 1 to 50 (default 25)", group),
        Value("--speed", "N", "seconds of the motion in a second of the film (default 1)", group),
    ]


@contextlib.contextmanager
def film(options: AnimationOptions) -> Iterator[BinaryIO | None]:
    """The staged film, None if none is asked for; it is renamed at the end. What it needs is refused before anything is computed."""
    for option, given in (("--fps", options.fps), ("--speed", options.speed)):
        if given is not None and options.animate is None:
            raise refusal(option, given, "needs --animate FILE beside it")
    if options.animate is None:
        yield None
        return
    with staged("--animate", options.animate, FILMS) as file:
        modules = ("matplotlib.backends.backend_agg", "matplotlib.figure", "PIL.Image")
        check_package("matplotlib", modules, "--animate", options.animate, "plot")
        if ending(options.animate) == "mp4":
            check_package("PyAV", ("av",), "--animate", options.animate, "video")
        yield file


def animate(motion: Any, times: "Floats", file: BinaryIO, options: "FilmOptions", look: Look) -> None:
    """Draw the film into the staged file: of one period; of the instants if they are given, or if there is no period."""
    path = str(options.animate)
    fps = 25.0 if options.fps is None else plain("--fps", options.fps)
    speed = 1.0 if options.speed is None else plain("--speed", options.speed)
    asked = options.until is not None or options.times is not None
    t = (times[0], times[-1]) if asked or not repeats(motion) else None
    try:
        made = motion.animate(t=t, fps=fps, speed=speed, **look)
    except ValueError as error:
        raise refusal("--animate", path, str(error).replace("speed=", "--speed ")) from error
    with drawing("--animate", path):
        made.save(file, ending(path))


def repeats(motion: Any) -> bool:
    """Whether there is a period; with friction there is none, and at rest nothing moves."""
    return math.isfinite(getattr(motion, "period", math.inf)) and motion.regime != "rest"


def ending(path: str) -> str:
    """The format of a film by the ending of its name."""
    return path.rpartition(".")[2].lower()
