"""Films of a motion: frames at exact times, no seam, as long as the motion; seen in what a viewer decodes."""

import io
import math

import av
import numpy as np
import pytest
from PIL import Image

import libration
from libration import DampedPendulum, Friction, Pendulum
from libration.plot._animation import FEWEST

# The circle of a picture of 640 by 320: the left axes are 0.44 of the width, and 2.44 units wide.
CENTRE, RADIUS = (0.01 * 640 + 0.22 * 640, 320 - (0.02 + 0.44) * 320), 0.44 * 640 / (2 * 1.22)
BLUE = np.array([0x00, 0x72, 0xB2])


def angle_seen(picture):
    """The angle at which the bob stands: the centre of what is blue in the left part."""
    left = np.asarray(picture, dtype=float)[:, : int(0.46 * 640)]
    weight = np.clip(1 - np.abs(left - BLUE).max(axis=2) / 60, 0, 1)
    y, x = np.mgrid[: left.shape[0], : left.shape[1]]
    assert weight.sum() > 100
    down, across = ((place * weight).sum() / weight.sum() + 0.5 for place in (y, x))
    return math.atan2(across - CENTRE[0], down - CENTRE[1])


def apart(one, other):
    """How far two angles are apart, in pixels along the circle."""
    return abs(math.remainder(one - other, 2 * math.pi)) * RADIUS


def pace(pendulum, rate):
    """The speed at which a period has 14 frames: enough to see, and soon drawn."""
    return pendulum.period * rate / 14.5


def gif(film):
    """The frames that a viewer of a GIF decodes, and how long each is shown, in hundredths of a second."""
    made = io.BytesIO()
    film.save(made, "gif")
    with Image.open(made) as pictures:
        assert pictures.info["loop"] == 0
        found = []
        for i in range(pictures.n_frames):
            pictures.seek(i)
            found.append((np.asarray(pictures.convert("RGB")), pictures.info["duration"] / 10))
    return found


MOTIONS = [
    Pendulum(3.0, length=1.0),
    Pendulum(0.3, 9.0, length=1.0),
    Pendulum(-2.0, 0.5, omega2=-4.0),
    Pendulum(0.0, -3.0, omega0=0.0),
]


@pytest.mark.parametrize("pendulum", MOTIONS, ids=["libration", "rotation", "upside down", "free"])
def test_every_decoded_frame_is_the_motion_at_its_time(pendulum):
    speed = pace(pendulum, 16)
    film = pendulum.animate(fps=16, speed=speed)
    frames = gif(film)
    # A frame that is the same as the one before is not stored again, but shown for longer.
    assert FEWEST <= len(frames) <= len(film.times)
    assert sum(wait for _, wait in frames) == round(100 * film.seconds)
    begins = np.cumsum([0] + [wait for _, wait in frames[:-1]]) / 100
    for (picture, _), begin in zip(frames, begins, strict=True):
        i = int(np.argmin(np.abs(film.times / speed - begin)))
        assert abs(film.times[i] / speed - begin) <= 0.005 + 1e-9
        assert apart(angle_seen(picture), float(pendulum.theta(film.times[i]))) < 0.35
    # Colours are exact but for a few of soft edges.
    drawn = next(film.frames())
    assert (frames[0][0] == drawn).all(axis=2).mean() > 0.98 and (frames[0][0][0, -1] == 255).all()
    # A frame off by one would be seen.
    assert apart(angle_seen(frames[3][0]), float(pendulum.theta(film.times[4]))) > 0.7


@pytest.mark.parametrize("pendulum", MOTIONS, ids=["libration", "rotation", "upside down", "free"])
def test_it_repeats_without_a_seam(pendulum):
    film = pendulum.animate(fps=20, speed=pace(pendulum, 20), title="")
    frames = [*film.frames()]
    # Frame N would be frame 0: the drawing of the pendulum is the same to the pixel.
    [after] = film._drawn(np.array([film.last]))
    left = slice(None), slice(0, int(0.46 * 640))
    assert np.array_equal(after[left], frames[0][left])
    # The step over the seam is that of the motion, not a jump and not a wait.
    step = [apart(*map(angle_seen, pair)) for pair in ((frames[-1], frames[0]), (frames[-1], frames[-2]))]
    exact = apart(float(pendulum.theta(film.times[-1])), float(pendulum.theta(film.last)))
    assert abs(step[0] - exact) < 0.5
    assert step[0] < 1.5 * step[1] + 1


def test_instants_are_equal_parts_of_the_period():
    film = Pendulum(3.0, length=1.0).animate()
    n = len(film.times)
    assert n == math.floor(25 * film.seconds) and film.seconds == Pendulum(3.0, length=1.0).period
    assert all(film.times[i] == pytest.approx(i * film.seconds / n, rel=2e-16) for i in range(n))


def test_a_part_of_the_motion_and_friction():
    pendulum = DampedPendulum(2.0, length=1.0, friction=Friction(linear=0.2))
    film = pendulum.animate(t=(1.0, 4.0), fps=5, lang="es")
    assert (len(film.times), film.times[0], film.seconds) == (15, 1.0, 3.0)
    for picture, t in zip(film.frames(), film.times, strict=True):
        assert apart(angle_seen(picture), float(pendulum.theta(t))) < 0.35


def test_an_mp4_has_the_frames_at_their_times(tmp_path):
    pendulum = Pendulum(2.5, length=1.0)
    speed = pace(pendulum, 20)
    film = pendulum.animate(tmp_path / "a.mp4", fps=20, speed=speed)
    with av.open(str(tmp_path / "a.mp4")) as video:
        frames = [(each.time, each.to_ndarray(format="rgb24")) for each in video.decode(video=0)]
    assert len(frames) == len(film.times)
    for (time, picture), t in zip(frames, film.times, strict=True):
        assert abs(time - t / speed) < 1 / 90_000
        assert apart(angle_seen(picture), float(pendulum.theta(t))) < 0.7
    data = (tmp_path / "a.mp4").read_bytes()
    assert data.index(b"moov") < data.index(b"mdat")


def test_a_notebook_shows_it():
    shown = Pendulum(1.0, length=1.0).animate(fps=6)._repr_html_()
    assert shown.startswith('<img alt="pendulum" src="data:image/gif;base64,R0lGODlh')


def test_the_same_film_is_the_same_file():
    first, second = io.BytesIO(), io.BytesIO()
    Pendulum(1.0, length=1.0).animate(first, form="gif", fps=6)
    Pendulum(1.0, length=1.0).animate(second, form="gif", fps=6)
    assert first.getvalue() == second.getvalue()


@pytest.mark.parametrize(
    ("pendulum", "words", "said"),
    [
        (Pendulum(0.0), {}, "rests: there is nothing to see"),
        (Pendulum(0.0, 2.0), {}, "has no period: give t="),
        (DampedPendulum(1.0), {}, "has no period: give t="),
        (Pendulum(1.0), {"t": 3.0}, "t = 3.0: must be two instants"),
        (Pendulum(1.0), {"fps": 0.5}, "fps = 0.5: must be from 1 to 50"),
        (Pendulum(1.0), {"fps": math.nan}, "fps = nan: must be from 1 to 50"),
        (Pendulum(1.0), {"speed": 0.0}, "speed = 0.0: must be finite and greater than 0"),
        (Pendulum(1.0), {"dpi": 5}, "dpi = 5: must be from 20 to 1200"),
        (Pendulum(1.0), {"lang": "fr"}, "lang = 'fr': must be en, pt-BR or es"),
        (Pendulum(1.0, omega0=1e-6), {}, "must be 12 to 2000; write speed="),
        (
            Pendulum(1.0, omega0=100.0),
            {},
            "1 frames, 0.0669998 s at 25 a second: must be 12 to 2000; write speed=0.138",
        ),
        (Pendulum(1.0), {"path": "a.avi"}, "path = 'a.avi': must end in .gif or .mp4"),
        (Pendulum(1.0), {"path": "a.gif", "form": "png"}, "form = 'png': must be gif or mp4"),
    ],
)
def test_refusals(pendulum, words, said):
    with pytest.raises(ValueError) as refused:
        pendulum.animate(**words)
    assert said in str(refused.value) and "\n" not in str(refused.value)


@pytest.mark.parametrize(("omega0", "frames"), [(1e-6, 2000), (100.0, 12), (3e5, 12)])
def test_the_speed_that_is_named_works(omega0, frames):
    with pytest.raises(ValueError) as refused:
        Pendulum(1.0, omega0=omega0).animate()
    speed = float(str(refused.value).partition("speed=")[2])
    assert len(Pendulum(1.0, omega0=omega0).animate(speed=speed).times) == pytest.approx(frames, rel=0.02)


def test_an_mp4_without_pyav_says_what_to_install(monkeypatch, tmp_path):
    monkeypatch.setitem(__import__("sys").modules, "av", None)
    with pytest.raises(ImportError, match=r"libration\[video\]"):
        libration.Pendulum(1.0).animate(tmp_path / "a.mp4")
