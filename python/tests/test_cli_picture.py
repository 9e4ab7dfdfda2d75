"""The title, the resolution and the language of a picture from the command line."""

import pytest

from libration._languages import LANGUAGES
from libration.cli import main
from libration.cli.picture import language
from libration.plot import _style
from libration.plot._language import Language

COMMANDS = {
    "solve": "solve --theta0 170deg --length 1m --samples 9",
    "period": "period --theta0 20deg,60deg",
    "compare": "compare --theta0 2 --with harmonic",
    "duffing": "duffing --p 1 --q 1 --u0 1 --samples 9",
    "cubic-quintic": "cubic-quintic --p 1 --q 1 --s 1 --u0 1 --samples 9",
}


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    """Work in an empty directory."""
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", COMMANDS)
def test_title_and_language(name):
    words = [*COMMANDS[name].split(), "--plot", "a.svg"]
    assert main([*words, "--title", "Oscilação nº 1", "--lang", "pt-br"]) == 0
    with open("a.svg", encoding="utf-8") as file:
        picture = file.read()
    assert "Oscilação nº 1" in picture
    assert "exata" in picture or "separatriz" in picture


@pytest.mark.parametrize("name", COMMANDS)
def test_resolution(name):
    sizes = []
    for dpi in ("50", "100"):
        assert main([*COMMANDS[name].split(), "--plot", "a.png", "--dpi", dpi]) == 0
        with open("a.png", "rb") as file:
            sizes.append(int.from_bytes(file.read(24)[16:20]))
    assert sizes[1] == 2 * sizes[0]


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.parametrize(
    ("title", "reason"),
    [
        ("x" * 10_000, "is too long for the picture"),
        ("line\n" * 40, "is too long for the picture"),
        ("a\x01b", "must be text that can be printed"),
        ("P\udcc3", "must be text that can be printed"),
        (r"$\frac{1}$", "has a formula that is wrong: "),
    ],
)
def test_titles_that_are_refused(capsys, tmp_path, name, title, reason):
    assert main([*COMMANDS[name].split(), "--plot", "a.svg", "--title", title]) == 2
    shown = capsys.readouterr()
    assert (shown.out, shown.err.count("\n")) == ("", 1)
    assert shown.err.startswith(f"libration {name}: --title = ")
    assert reason in shown.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", COMMANDS)
def test_letters_that_the_font_lacks_are_told_in_one_line(capsys, name):
    assert main([*COMMANDS[name].split(), "--plot", "a.png", "--title", "\u65e5\u672c"]) == 0
    assert capsys.readouterr().err == (
        "libration: --plot = a.png: the font has no \u65e5 \u672c; an .svg takes the fonts of who looks at it\n"
    )
    assert main([*COMMANDS[name].split(), "--plot", "a.svg", "--title", "\u65e5\u672c"]) == 0
    assert capsys.readouterr().err == ""


def test_every_swing_of_a_table_is_marked():
    words = "period --theta0 20deg,60deg,180deg,0deg,150deg --only exact --plot a.svg --lang es"
    assert main(words.split()) == 0
    with open("a.svg", encoding="utf-8") as file:
        picture = file.read()
    assert [f">{degrees}°<" in picture for degrees in (20, 60, 150, 180, 0)] == [True, True, True, False, False]


def test_the_languages_and_bounds_are_those_of_the_pictures():
    assert all(Language(each).name == language(each) for each in LANGUAGES)
    assert [language(each) for each in ("en", "PT_br", "pt", "es", None)] == ["en", "pt-BR", "pt-BR", "es", "en"]
    assert (_style.LEAST_DPI, _style.MOST_DPI) == (20, 1200)


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.parametrize(
    ("words", "line"),
    [
        ("--title x", "--title = x: needs --plot FILE beside it"),
        ("--plot a.png --dpi 19", "--dpi = 19: must be from 20 to 1200"),
        ("--plot a.png --dpi 1e9", "--dpi = 1e9: must be from 20 to 1200"),
        ("--plot a.png --dpi x", "--dpi = x: is not a number"),
        ("--plot a.png --lang de", "--lang = de: must be en, pt-BR or es"),
        ("--plot a.png --lang en --lang es", "--lang = en and --lang = es: give it once"),
    ],
)
def test_refusals(capsys, tmp_path, name, words, line):
    assert main([*COMMANDS[name].split(), *words.split()]) == 2
    shown = capsys.readouterr()
    assert (shown.out, shown.err.count("\n")) == ("", 1)
    assert shown.err.startswith(f"libration {name}: {line}")
    assert list(tmp_path.iterdir()) == []
