"""A film of a motion: the pendulum beside its angle over time, as GIF or MP4.

Frame i is the motion at first + i (last - first)/N. Over one period a film repeats without a seam: frame N would be frame 0. A GIF
shows each frame for a whole number of hundredths of a second, so that frame i begins at the hundredth next to its time; in an MP4
it begins at the ninety-thousandth of a second next to it.
"""

from __future__ import annotations

import importlib
import math
from base64 import b64encode
from collections.abc import Callable, Iterator
from fractions import Fraction
from io import BytesIO
from itertools import pairwise
from typing import Any

import numpy as np

from .._arrays import NDArray
from .._scalars import real, shown
from ._language import Language
from ._style import BLACK, EXACT, LEAST_DPI, LINEAR, MOST_DPI, angle_ticks, finite, head, house, quiet

FORMS = ("gif", "mp4")
# Below, nothing seems to move; above, files are too large for a page or a slide.
FEWEST, MOST = 12, 2000
# A GIF waits two hundredths of a second at least.
MOST_RATE = 50.0
SIZE = (6.4, 3.2)
# Of the drawing and of the curve: left, bottom, width and height, as parts of the picture.
PLACES = (0.01, 0.02, 0.44, 0.88), (0.57, 0.16, 0.40, 0.70)
# Of the drawing, whose rod is 1 long: the half of its width, and the radius of the bob.
ROOM, BOB = 1.22, 0.085
# Points of the curve of the angle.
FINE = 1200
# Ticks in a second of an MP4; of every player's clock.
TICKS = 90_000
# Colours of a GIF, and frames that they are taken from.
COLOURS, SEEN = 256, 8
NO_VIDEO = "an MP4 needs PyAV: pip install 'libration[video]'; a .gif does without"

Frame = NDArray[np.uint8]


class Animation:
    """A film of a motion; `Pendulum.animate` and `DampedPendulum.animate` make it.

    Attributes
    ----------
    times : ndarray
        The instant of the motion in each frame, in s.
    seconds : float
        How long the film lasts, in s.

    Examples
    --------
    >>> from libration import Pendulum
    >>> film = Pendulum(3.0, length=1.0).animate(fps=10)
    >>> len(film.times), f"{film.seconds:.3f}", f"{film.times[1] - film.times[0]:.6f}"
    (51, '5.159', '0.101156')
    """

    def __init__(
        self,
        pendulum: Any,
        t: Any = None,
        *,
        title: str,
        fps: float = 25.0,
        speed: float = 1.0,
        dpi: float = 100.0,
        lang: str = "en",
    ) -> None:
        self.pendulum, self.title, self.dpi, self.say = pendulum, title, real("dpi", dpi), Language(lang)
        rate, pace = real("fps", fps), real("speed", speed)
        if not 1 <= rate <= MOST_RATE:
            raise ValueError(f"fps = {fps!r}: must be from 1 to {MOST_RATE:g} frames a second")
        if not (pace > 0 and math.isfinite(pace)):
            raise ValueError(f"speed = {speed!r}: must be finite and greater than 0")
        if not LEAST_DPI <= self.dpi <= MOST_DPI:
            raise ValueError(f"dpi = {dpi!r}: must be from {LEAST_DPI} to {MOST_DPI}")
        self.first, self.last = _span(pendulum, t)
        self.seconds = (self.last - self.first) / pace
        # The rate is not exceeded; a rounding error does not take a frame away.
        count = math.floor(min(self.seconds * rate * (1 + 1e-12), 1e9))
        if not FEWEST <= count <= MOST:
            # With room for the digits that are not shown.
            meant = self.seconds * rate * pace / (1.01 * FEWEST if count < FEWEST else 0.99 * MOST)
            raise ValueError(
                f"{count} frames, {self.seconds:.6g} s at {rate:g} a second: must be {FEWEST} to {MOST}; write speed={meant:.3g}"
            )
        # One rounding an instant: the product is not formed first.
        span = Fraction(self.last) - Fraction(self.first)
        self.times = np.array([float(Fraction(self.first) + span * i / count) for i in range(count)])

    def frames(self) -> Iterator[Frame]:
        """The frames one after the other, as arrays of (height, width, 3) bytes of red, green and blue.

        Yields
        ------
        ndarray of uint8

        Examples
        --------
        >>> from libration import Pendulum
        >>> next(Pendulum(3.0, length=1.0).animate().frames()).shape
        (320, 640, 3)
        """
        return self._drawn(self.times)

    def save(self, path: Any, form: str | None = None) -> None:
        """Save the film; a GIF is repeated without an end, an MP4 as its player says.

        Parameters
        ----------
        path : str, path or binary file
            Where to save.
        form : str, optional
            `gif` or `mp4`; by default the ending of `path`. The width and the height of an MP4 are even: dpi=100 makes 640 by 320.

        Raises
        ------
        ImportError
            If matplotlib is missing, or for an MP4 PyAV (`pip install 'libration[video]'`).
        ValueError
            If `path` has another ending, or a number of the motion is too large for an axis.

        Examples
        --------
        >>> from io import BytesIO
        >>> from libration import Pendulum
        >>> picture = BytesIO()
        >>> Pendulum(3.0, length=1.0).animate(fps=5).save(picture, "gif")
        >>> picture.getvalue()[:6]
        b'GIF89a'
        """
        form = film_form(path, form)
        if form == "gif":
            self._gif(path)
        else:
            self._mp4(path)

    def _repr_html_(self) -> str:
        """What a notebook shows: the film as a GIF."""
        made = BytesIO()
        self.save(made, "gif")
        return f'<img alt="pendulum" src="data:image/gif;base64,{b64encode(made.getvalue()).decode()}">'

    def _drawn(self, times: NDArray[np.float64]) -> Iterator[Frame]:
        """The picture at each instant: what moves is drawn over what stays."""
        with house(), np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            from matplotlib.backends.backend_agg import FigureCanvasAgg
            from matplotlib.figure import Figure

            figure = Figure(figsize=SIZE, dpi=self.dpi)
            # matplotlib states no types of it.
            canvas: Any = FigureCanvasAgg(figure)
            left, right = (figure.add_axes(place) for place in PLACES)
            rod, bob = _pendulum(left)
            dot, line = self._curve(right)
            head(figure, self.title)
            canvas.draw()
            still = canvas.copy_from_bbox(figure.bbox)
            theta = np.asarray(self.pendulum.theta(times))
        for t, angle in zip(times.tolist(), theta.tolist(), strict=True):
            with house():
                x, y = math.sin(angle), -math.cos(angle)
                rod.set_data([0.0, x], [0.0, y])
                bob.set_center((x, y))
                dot.set_data([t], [angle])
                line.set_xdata([t, t])
                canvas.restore_region(still)
                for axes, artist in ((left, rod), (left, bob), (right, line), (right, dot)):
                    axes.draw_artist(artist)
                yield np.array(np.asarray(canvas.buffer_rgba())[:, :, :3])

    def _curve(self, axes: Any) -> tuple[Any, Any]:
        """The angle over time, and the dot and the line that run along it."""
        quiet(axes)
        fine = np.linspace(self.first, self.last, FINE)
        axes.plot(fine, self.pendulum.theta(fine), color=EXACT, lw=1.6)
        axes.margins(x=0)
        axes.set_xlabel("t [s]")
        axes.set_ylabel(r"$\theta$ [rad]")
        angle_ticks(axes.yaxis, *axes.get_ylim())
        self.say.ticks(axes)
        line = axes.axvline(self.first, color=LINEAR, lw=0.8, animated=True)
        dot = axes.plot([], [], "o", color=BLACK, ms=6, clip_on=False, animated=True)[0]
        return dot, line

    def _gif(self, path: Any) -> None:
        """By Pillow, which comes with matplotlib. The colours are the most frequent of frames from all over the film."""
        from PIL import Image

        count = len(self.times)
        colours = _colours(np.stack([*self._drawn(self.times[:: max(1, count // SEEN)])]))
        until = [round(100 * self.seconds * i / count) for i in range(count + 1)]
        waits = [10 * (after - before) for before, after in pairwise(until)]
        pictures = (_indexed(Image, each, colours) for each in self.frames())
        first = next(pictures)
        more: Any = {"append_images": pictures, "duration": waits, "loop": 0, "optimize": False, "disposal": 1}
        first.save(path, format="GIF", save_all=True, **more)

    def _mp4(self, path: Any) -> None:
        """By PyAV: H.264, with the index in front, so that a page plays it while it loads."""
        av = video()
        count = len(self.times)
        target = path if hasattr(path, "write") else str(path)
        with av.open(target, "w", format="mp4", options={"movflags": "faststart"}) as film:
            stream = film.add_stream("libx264", rate=max(1, round(count / self.seconds)))
            stream.pix_fmt, stream.time_base = "yuv420p", Fraction(1, TICKS)
            stream.codec_context.time_base = Fraction(1, TICKS)
            stream.options = {"crf": "16", "preset": "medium"}
            # Its colours have half as many rows and columns.
            width, height = [2 * math.floor(side * self.dpi / 2 + 1e-9) for side in SIZE]
            stream.width, stream.height = width, height
            for i, picture in enumerate(self.frames()):
                frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(picture[:height, :width]), format="rgb24")
                frame.pts, frame.time_base = round(TICKS * self.seconds * i / count), Fraction(1, TICKS)
                film.mux(stream.encode(frame))
            film.mux(stream.encode(None))


def _span(pendulum: Any, t: Any) -> tuple[float, float]:
    """From which instant to which: one period, or what is asked for."""
    if t is not None:
        instants = finite(t)
        first, last = float(instants.min()), float(instants.max())
        if first == last:
            raise ValueError(f"t = {shown(t)}: must be two instants, the first and the last of the film")
        return first, last
    period = float(getattr(pendulum, "period", math.nan))
    if getattr(pendulum, "regime", None) == "rest":
        raise ValueError(f"{pendulum!r} rests: there is nothing to see; t=(first, last) shows it all the same")
    if not math.isfinite(period):
        raise ValueError(f"{pendulum!r} has no period: give t=(first, last), the instants of the film in s")
    return 0.0, period


# A colour as a number.
CODE = np.array([1 << 16, 1 << 8, 1], dtype=np.int64)


def _colours(pictures: Frame) -> NDArray[np.int64]:
    """The most frequent colours, a row each."""
    codes, counts = np.unique(pictures.reshape(-1, 3) @ CODE, return_counts=True)
    return _parts(codes[np.argsort(-counts, kind="stable")[:COLOURS]])


def _parts(codes: NDArray[np.int64]) -> NDArray[np.int64]:
    """Red, green and blue of colours as numbers."""
    return codes[:, None] // CODE % 256


def _indexed(image: Any, picture: Frame, colours: NDArray[np.int64]) -> Any:
    """A picture of these colours: those that are among them exactly, those of soft edges that are not by the nearest."""
    codes, place = np.unique(picture.reshape(-1, 3) @ CODE, return_inverse=True)
    far = ((_parts(codes)[:, None] - colours[None]) ** 2).sum(axis=2)
    made = image.frombytes("P", picture.shape[1::-1], far.argmin(axis=1).astype(np.uint8)[place].tobytes())
    made.putpalette(colours.astype(np.uint8).tobytes())
    return made


def _pendulum(axes: Any) -> tuple[Any, Any]:
    """The pivot, the circle with a tick every 30 degrees, and the rod and the bob that move."""
    from matplotlib.patches import Circle

    axes.set_aspect("equal")
    axes.set_xlim(-ROOM, ROOM)
    axes.set_ylim(-ROOM, ROOM)
    axes.set_axis_off()
    axes.add_patch(Circle((0, 0), 1, fill=False, color=LINEAR, lw=0.6))
    for degrees in range(0, 360, 30):
        x, y = math.sin(math.radians(degrees)), -math.cos(math.radians(degrees))
        axes.plot([0.97 * x, 1.03 * x], [0.97 * y, 1.03 * y], color=LINEAR, lw=0.9)
    axes.plot([0], [0], "o", color=BLACK, ms=4)
    rod = axes.plot([], [], color=BLACK, lw=2, solid_capstyle="round", animated=True)[0]
    bob = axes.add_patch(Circle((0, -1), BOB, color=EXACT, animated=True))
    return rod, bob


def film(
    pendulum: Any,
    headline: Callable[[Any, Language], str],
    path: Any,
    form: str | None,
    title: str | None,
    lang: str,
    **options: Any,
) -> Animation:
    """The film of a pendulum under its title or the line that says its state; saved where there is a path."""
    line = headline(pendulum, Language(lang)) if title is None else title
    made = Animation(pendulum, title=line, lang=lang, **options)
    if path is not None:
        made.save(path, form)
    return made


def film_form(path: Any, form: str | None) -> str:
    """`gif` or `mp4`, or an error."""
    if form is not None and form not in FORMS:
        raise ValueError(f"form = {form!r}: must be gif or mp4")
    ending = str(path).lower().rpartition(".")[2]
    if form is None and (hasattr(path, "write") or ending not in FORMS):
        raise ValueError(f"path = {shown(path)}: must end in .gif or .mp4, or form= must be one of them")
    return form or ending


def video() -> Any:
    """PyAV, or an error that says how to install it."""
    try:
        return importlib.import_module("av")
    except ModuleNotFoundError as error:
        raise ImportError(NO_VIDEO) from error
