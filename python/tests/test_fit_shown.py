"""The picture and the page of a fit."""

import math
import re
from html.parser import HTMLParser
from io import BytesIO
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import libration
from libration import DampedPendulum, Friction, fit
from libration.cli import main
from libration.measurement._sentences import PATTERNS, in_language
from libration.plot import plot_fit

T = np.linspace(0.0, 60.0, 1500)


@pytest.fixture(scope="module")
def found():
    motion = DampedPendulum(math.radians(70), length=0.8, gravity=9.81, friction=Friction(linear=0.02))
    return fit(T, motion.theta(T) + np.random.default_rng(3).normal(0.0, 0.01, T.size), length=(0.8, 0.001))


@pytest.fixture(scope="module")
def table():
    swings = np.radians([10, 30, 50, 70])
    return fit(swings, [libration.Pendulum(each, length=0.8).period for each in swings], quantity="swings")


def test_a_picture_has_data_curve_and_residuals(found):
    axes = found.plot()
    upper, lower = axes.figure.axes
    dots, curve = upper.get_lines()
    # The first twelve periods above, all residuals below.
    assert dots.get_xdata()[-1] < 25 < lower.get_lines()[-1].get_xdata()[-1]
    near = np.interp(dots.get_xdata(), *curve.get_data())
    assert np.abs(near - dots.get_ydata()).max() < 4.5 * math.degrees(0.01)
    assert len(lower.get_lines()[-1].get_ydata()) == found.t.size


@pytest.mark.parametrize("lang", ["en", "pt-BR", "es"])
@pytest.mark.parametrize("which", ["found", "table"])
def test_pictures_in_three_languages(lang, which, request):
    picture = BytesIO()
    request.getfixturevalue(which).plot(picture, form="svg", lang=lang, title="ℓ = 0.8 m")
    text = picture.getvalue().decode()
    assert ElementTree.fromstring(text).tag.endswith("svg")
    assert {"en": "measured", "pt-BR": "medido", "es": "medido"}[lang] in text


def test_own_axes(found):
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    assert found.plot(ax=axes) is axes
    assert len(axes.get_lines()) == 2


def test_bad_pictures(found):
    with pytest.raises(ValueError, match="must be a Fit"):
        plot_fit(3.0, BytesIO())
    with pytest.raises(ValueError, match="lang = 'fr'"):
        found.plot(BytesIO(), lang="fr")


class Page(HTMLParser):
    """Tags that are open, ids, and addresses of the page."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.addresses = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.ids += [given["id"]] if "id" in given else []
        self.addresses += [each for name, each in attributes if name in ("src", "href", "xlink:href")]
        if tag not in ("meta", "path", "use", "image", "rect"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if self.open and self.open[-1] == tag:
            self.open.pop()

    def handle_endtag(self, tag):
        if self.open and self.open[-1] == tag:
            self.open.pop()


@pytest.mark.parametrize("which", ["found", "table"])
def test_the_page_needs_no_other_file(which, request):
    result = request.getfixturevalue(which)
    text = result.report()
    page = Page(text)
    assert not page.open
    assert len(set(page.ids)) == len(page.ids)
    assert all(each.startswith(("#", "data:")) for each in page.addresses)
    assert {each[1:] for each in page.addresses if each.startswith("#")} <= set(page.ids)
    assert not re.search(r"<script|@import|<link", text)
    for head in ("Result", "Data with the fitted curve", "Budget of uncertainty", "What was read"):
        assert head in text
    assert ("Friction models" in text) == (which == "found")
    assert ("Period against swing" in text) == (which == "found")


@pytest.mark.parametrize("lang", ["pt-BR", "es"])
@pytest.mark.parametrize("which", ["found", "table"])
def test_the_page_in_other_languages(lang, which, request):
    result = request.getfixturevalue(which)
    text, english = result.report(lang), result.report()
    assert f'<html lang="{lang}">' in text
    # No heading, no sentence of the core and no decimal point of the numbers stays English.
    for part in re.findall(r"<(?:h2|th|li)>(.*?)</", english):
        if len(part) > 8 and not part.startswith("Monte"):
            assert part not in text
    assert not re.search(r'class="number">[^<]*[0-9]\.[0-9]', text)


def test_the_page_states_its_equation(found, table):
    assert "Equation: θ″ + 2γθ′ + ω₀² sin θ = 0; γ = linear friction<" in found.report()
    assert "Ecuación: θ″ + 2γθ′ + ω₀² sin θ = 0; γ = fricción lineal<" in found.report("es")
    assert "Equation:" not in table.report()


def test_the_page_has_two_themes(found):
    text = found.report()
    assert "prefers-color-scheme:dark" in text and 'content="light dark"' in text
    # Pictures have no colour of their own, but for what is a raster.
    drawn = re.sub(r"<style>.*?</style>", "", text[text.index("<body>") :], flags=re.DOTALL)
    assert not re.findall(r"(?:stroke|fill): ?#[0-9a-f]{6}", drawn)
    assert "var(--data)" in drawn and "var(--exact)" in drawn


def test_every_sentence_of_the_core_has_its_translations():
    root = Path(__file__).parents[2] / "fit/src"
    sources = [*(root / "fit").glob("*.rs"), *(root / "read").glob("*.rs")]
    said = []
    for path in sources:
        code = re.sub(r"(?s)#\[cfg\(test\)\].*", "", path.read_text())
        calls = r'(?s)(?:Verdict::new\(|\bsay\(|understood\s*\.?push\(|\.push\(|leave_out\().{0,60}?"((?:[^"\\]|\\.)*)"'
        wanted = path.name in ("verdicts.rs", "tables.rs", "together.rs", "reversible.rs") or path.parent.name == "read"
        found = [re.sub(r"\\\s+", "", each) for each in re.findall(calls, code)] if wanted else []
        said += [each.replace('\\"', '"') for each in found if len(each.split()) > 4]
    assert len(said) > 40
    for each in said:
        example = re.sub(r"\{[^}]*\}", "7", each)
        assert in_language(example, "es") != example, each
        assert in_language(example, "pt-BR") != example, each


REFUSED = [
    (b"", "está vazio"),
    (b"a\nb\nc\n", "não contém nenhuma linha de números"),
    (b"t [s],theta [deg]\n0,10\n0.1,9\n0.2,7\n0.3,4\n", "pelo menos 8"),
    (b"t,theta,phi\n0,10,1\n0.1,9,2\n0.2,7,4\n0.3,4,2\n", "qual coluna é o ângulo?"),
]


@pytest.mark.parametrize(("content", "told"), REFUSED)
def test_refusals_have_words_in_both_languages(content, told, tmp_path):
    path = tmp_path / "swing.csv"
    path.write_bytes(content)
    with pytest.raises(ValueError) as refusal:
        fit(path)
    reason = str(refusal.value).partition("swing.csv: ")[2]
    assert told in in_language(reason, "pt-BR")
    assert in_language(reason, "es") != reason


def test_numbers_of_sentences_have_a_decimal_comma():
    told = in_language("the record holds 1.2 periods: friction and rest are hardly determined", "es")
    assert told.startswith("el registro contiene 1,2 periodos")
    assert in_language("what nobody says", "es") == "what nobody says"
    for english, others in PATTERNS.items():
        assert all(each.count("{}") == english.count("{}") for each in others), english


def test_a_name_is_no_markup(tmp_path):
    path = tmp_path / "<b>&.csv"
    motion = DampedPendulum(1.0, length=0.8)
    rows = "".join(f"{t:.4f},{each:.6f}\n" for t, each in zip(T, motion.theta(T) + 0.001 * np.sin(40 * T), strict=True))
    path.write_text("t [s],theta [rad]\n" + rows)
    assert "<b>" not in fit(path).report()


def test_the_command_writes_both(tmp_path, capsys):
    motion = DampedPendulum(1.0, length=0.8, friction=Friction(linear=0.01))
    noise = np.random.default_rng(3).normal(0.0, 0.005, T.size)
    rows = "".join(f"{t:.4f},{each:.6f}\n" for t, each in zip(T, motion.theta(T) + noise, strict=True))
    (tmp_path / "a.csv").write_text("t [s],theta [rad]\n" + rows)
    picture, report = tmp_path / "a.png", tmp_path / "a.html"
    words = ["fit", str(tmp_path / "a.csv"), "--plot", str(picture), "--report", str(report), "--lang", "pt"]
    assert main([*words, "--title", "Pêndulo", "--dpi", "50"]) == 0
    assert picture.read_bytes()[1:4] == b"PNG"
    assert report.read_text().startswith("<!doctype html>")
    assert capsys.readouterr().out.count("escrito") == 2
