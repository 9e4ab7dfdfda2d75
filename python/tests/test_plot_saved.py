"""Pictures that are saved: their languages, titles and resolution, that no text is cut, and what is refused."""

import io
import math

import pytest
from matplotlib.figure import Figure
from matplotlib.legend import Legend

from libration import Duffing, Pendulum, approx, plot
from libration._languages import LANGUAGES
from libration.plot._language import Language

SWING = Pendulum(3.0, length=1.0, gravity=9.8)
SAVED = {
    "motion": lambda file, **given: plot.plot_motion(SWING, [0.0, 10.0], file, **given),
    "comparison": lambda file, **given: plot.plot_comparison(SWING, [("euler:0.1", EULER)], file, **given),
    "oscillator": lambda file, **given: plot.plot_oscillator(Duffing(1.4, p=-1.0, q=1.0), [0.0, 20.5], file, **given),
    "periods": lambda file, **given: plot.plot_periods(file, **given),
}
EULER = approx.numerical("euler:0.1").of(SWING)


@pytest.fixture
def drawn(monkeypatch):
    """The figures that are saved, kept as they are."""
    figures = []
    monkeypatch.setattr(Figure, "savefig", lambda figure, *args, **given: figures.append(figure))
    return figures


@pytest.mark.parametrize("name", SAVED)
@pytest.mark.parametrize("lang", LANGUAGES)
def test_every_picture_in_every_language(name, lang):
    file = io.BytesIO()
    SAVED[name](file, form="svg", lang=lang, title="A Título ½")
    svg = file.getvalue().decode()
    assert "A Título ½" in svg
    assert "font-family: " in svg
    assert "sans-serif" in svg
    words = {"motion": "exact", "comparison": "exact", "oscillator": "separatrix", "periods": "logarithms"}
    assert f">{Language(lang).word(words[name])}<" in svg


LONG = (
    "Uma oscilação de grande amplitude, medida na sala de aula com um pêndulo de um metro, e a solução exata ao lado. "
)
CUT = [(name, lang, None) for name in SAVED for lang in LANGUAGES]
CUT += [("comparison", "en", title) for title in (LONG, 3 * LONG, "W" * 60 + " " + "W" * 60)]


@pytest.mark.parametrize(("name", "lang", "title"), CUT)
def test_no_text_is_cut(name, lang, title, drawn):
    SAVED[name](io.BytesIO(), form="png", lang=lang, title=title)
    [figure] = drawn
    figure.draw_without_rendering()
    legends = [
        legend for each in (figure, *figure.axes) for legend in each.get_children() if isinstance(legend, Legend)
    ]
    texts = [text for axes in figure.axes for text in (*axes.texts, axes.title, axes.xaxis.label, axes.yaxis.label)]
    texts += [*figure.texts, *(text for legend in legends for text in legend.get_texts())]
    boxes = [text.get_window_extent() for text in texts if text.get_text()]
    assert len(boxes) > 5
    # With the labels of the ticks.
    boxes += [axes.get_tightbbox() for axes in figure.axes]
    for box in boxes:
        assert -1 <= box.x0 <= box.x1 <= figure.bbox.width + 1
        assert -1 <= box.y0 <= box.y1 <= figure.bbox.height + 1


@pytest.mark.parametrize("name", SAVED)
def test_dots_per_inch(name):
    sizes = []
    for dpi in (50, 100):
        file = io.BytesIO()
        SAVED[name](file, form="png", dpi=dpi)
        sizes.append(int.from_bytes(file.getvalue()[16:20]))
    assert sizes[1] == 2 * sizes[0]


@pytest.mark.parametrize("name", SAVED)
@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"lang": "fr"}, "lang = 'fr': must be en, pt-BR or es"),
        ({"dpi": 0}, "dpi = 0: must be from 20 to 1200"),
        ({"dpi": math.nan}, "dpi = nan: must be from 20 to 1200"),
    ],
)
def test_refusals_of_saved_pictures(name, given, said):
    file = io.BytesIO()
    with pytest.raises(ValueError) as caught:
        SAVED[name](file, form="png", **given)
    assert str(caught.value) == said
    assert file.getvalue() == b""


@pytest.mark.parametrize(
    ("draw", "said"),
    [
        (lambda path: SAVED["motion"](path / "a.jpg"), "must end in .png or .svg, or form="),
        (lambda path: SAVED["periods"](str(path / "a")), "must end in .png or .svg, or form="),
        (lambda path: SAVED["periods"](None), "path = None: must end in .png or .svg"),
        (lambda path: SAVED["motion"](path / "a.png", form="pdf"), "form = 'pdf': must be png or svg"),
        (lambda path: SAVED["motion"](path / "a.png", dpi="x"), "dpi = 'x': must be one real number"),
        (lambda path: SAVED["motion"](path / "a.png", title=5), "title = 5: must be text that can be printed"),
        (lambda path: plot.plot_motion(5, [0.0], path / "a.png"), "pendulum = 5: must be a Pendulum"),
        (lambda path: plot.plot_oscillator(SWING, [0.0], path / "a.png"), "must be a Duffing or a CubicQuintic"),
        (lambda path: plot.plot_comparison(SWING, ["linear"], path / "a.png"), "must be pairs of name and solution"),
    ],
)
def test_what_cannot_be_saved(draw, said, tmp_path):
    with pytest.raises(ValueError, match=r"^\w+ = ") as caught:
        draw(tmp_path)
    assert said in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_a_title_of_the_user_replaces_ours_and_an_empty_one_leaves_it_out():
    files = {title: io.BytesIO() for title in (None, "Mine", "")}
    for title, file in files.items():
        plot.plot_motion(SWING, [0.0, 1.0], file, form="svg", title=title)
    ours, mine, none = (file.getvalue().decode() for file in files.values())
    assert "libration, period" in ours
    assert ">Mine<" in mine
    assert "libration, period" not in mine
    assert "libration, period" not in none
