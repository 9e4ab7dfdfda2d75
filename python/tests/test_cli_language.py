"""The command line in Portuguese and Spanish: no English is left, refusals stay one line, and data do not change."""

import re
import shlex
from pathlib import Path

import pytest

from libration.cli import language, main
from libration.cli.top import COMMANDS

ROOT = Path(__file__).resolve().parents[2]
RECORD = str(ROOT / "lab/tests/record-70deg.csv")
OTHERS = ["pt-BR", "es"]
# Words that neither Portuguese nor Spanish has.
ENGLISH = re.compile(
    r"\b(the|of|and|is|are|must|with|from|than|by|give|needs?|not|missing|unknown|see|which|its|written|sampled|"
    r"default|required|such|where|each|without|turning|swings?|small|largest|never|infinite|undefined|instants)\b"
)
# What is typed, and what a file or a formula is called.
NAMES = re.compile(r"--?[\w-]+( [A-Z]+\b)?|`[^`]*`|\"[^\"]*\"|\S*[/.]\S*|\b(of|with) [A-Z]\w+|small-m\S*|from, to")
# They open a page, need a scheduler or take minutes.
APART = {"lab", "ensemble", "papers", "completion", "fit", "cite"}
EXAMPLES = [each for name, command in COMMANDS.items() if name not in APART for each in command.examples]
MORE = [
    "libration period --theta0 0 --velocity0 3 --omega0 1",
    "libration period --theta0 180deg",
    "libration period --theta0 0",
    "libration at 1e30s --theta0 1 --omega0 1",
    "libration at 3s,1e30s --theta0 1 --velocity0 4 --omega0 1",
    "libration solve --theta0 0 --velocity0 10 --omega0 1 --linear 0.2 --dry 0.1",
    "libration solve --theta0 1 --omega0 1 --until 1e20s",
    "libration solve --theta0 0 --velocity0 3 --omega0 1",
    "libration duffing --p -1 --q 1 --u0 0",
    "libration compare --theta0 170deg --with fourier:3,euler:0.1,harmonic --periods 3",
    "libration gravity --latitude 45deg --period 2.0±0.01s --length 1m",
]
REFUSED = [
    "",
    "solv",
    "-x",
    "help",
    "period",
    "period 150",
    "period --theta 1",
    "period --theta0",
    "period --theta0 1 --theta0 2",
    "period --theta0 1 --json=1",
    "period --theta0 1 --only lineal",
    "period --theta0 1,5",
    "period --theta0 abc",
    "period --theta0 1parsec",
    "period --theta0 1e400",
    "solve --theta0 3 --length -1m",
    "solve --theta0 3 --length 1m --samples 0",
    "solve --theta0 3 --length 1m --until -1s",
    "solve --theta0 3 --length 1m --out a.xyz",
    "solve --theta0 3 --length 1m --out missing/there/a.csv",
    "solve --theta0 3 --length 1m --times nothing.csv",
    "solve --theta0 3 --length 1m --dpi 100",
    "solve --theta0 3 --length 1m --plot a.png --dpi 1",
    "solve --theta0 3 --length 1m --linear x",
    "solve --theta0 3 --length 1m --out - --json",
    "solve --theta0 3 --omega0 1 --energy 1 --velocity0 2",
    "at 1s --theta0 1",
    "compare --theta0 1 --with nothing",
    "duffing --u0 1",
    "duffing --u0 1 --mass 0kg --stiffness 1N/m",
    "cubic-quintic --u0 1 --mass 1kg --stiffness 1N/m --quintic 1N/m3",
    "gravity",
    "gravity --latitude 45",
    "fit",
    "fit nothing.csv",
    "ensemble",
    "ensemble nothing.toml",
    "lab --port x",
    "papers nobody",
]


def english(text):
    """The lines of a text that hold English words."""
    return [line for line in text.splitlines() if ENGLISH.search(NAMES.sub("", line))]


@pytest.fixture(autouse=True)
def empty(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")


@pytest.mark.parametrize("name", OTHERS)
@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_a_help_page_has_no_english(command, name, capsys):
    assert main([*shlex.split(command), "--help", "--lang", name]) == 0
    told = capsys.readouterr().out
    assert told.startswith("uso: libration")
    assert english(re.split(r"\n(exemplos|ejemplos):\n", told)[0].replace("numpy.load", "")) == []


@pytest.mark.parametrize("name", OTHERS)
@pytest.mark.parametrize("line", [*EXAMPLES, *MORE])
def test_a_result_has_no_english(line, name, capsys):
    Path("instants.csv").write_text("t\n0\n1\n")
    Path("data.csv").write_text("t,theta\n0,1.0471975511965976\n0.5,-0.3\n1,-0.9\n")
    assert main([*shlex.split(line)[1:], "--lang", name]) == 0
    told = capsys.readouterr().out
    if "--json" not in line:
        assert english(told) == []
        assert not re.search(r"[0-9]\.[0-9]", NAMES.sub("", told))


@pytest.mark.parametrize("name", OTHERS)
@pytest.mark.parametrize("line", REFUSED)
def test_a_refusal_is_one_line_without_english(line, name, capsys):
    assert main([*shlex.split(line), "--lang", name]) == 2
    shown = capsys.readouterr()
    assert shown.out == "" and len(shown.err.splitlines()) == 1
    assert english(shown.err) == []


@pytest.mark.parametrize("name", OTHERS)
def test_a_fit_is_told_in_the_language(name, capsys):
    assert main(["fit", RECORD, "--length", "1.000±0.001", "--lang", name]) in (0, 1)
    told = capsys.readouterr().out
    assert english(told) == []
    assert "±" in told and not re.search(r"[0-9]\.[0-9]+ (±|rad|m/s)", told)


def test_data_are_the_same_in_every_language(capsys):
    words = ["solve", "--theta0", "150deg", "--length", "1m"]
    tables, objects = set(), set()
    for name in ("en", *OTHERS):
        assert main([*words, "--out", "a.csv", "--lang", name]) == 0
        tables.add(Path("a.csv").read_bytes())
        capsys.readouterr()
        assert main([*words, "--json", "--lang", name]) == 0
        objects.add(capsys.readouterr().out)
    assert len(tables) == 1 and len(objects) == 1


def test_the_system_chooses_where_no_option_does(monkeypatch, capsys):
    for variable, value, word in (
        ("LANG", "pt_BR.UTF-8", "período"),
        ("LANG", "es_MX.UTF-8", "periodo"),
        ("LANG", "C", "period"),
        ("LANG", "fr_FR.UTF-8", "period"),
        ("LC_ALL", "pt_PT", "período"),
    ):
        for each in (language.LIST, *language.LOCALES):
            monkeypatch.delenv(each, raising=False)
        monkeypatch.setenv(variable, value)
        assert main(["period", "--theta0", "1", "--length", "1m"]) == 0
        assert f"\n{word} T " in capsys.readouterr().out
    monkeypatch.setenv(language.LIST, "fr:es:en")
    assert language.of_the_system() == "es"


def test_a_decimal_point_is_kept_where_it_is_asked_for(capsys):
    assert main(["period", "--theta0", "1", "--decimal", "point", "--lang", "es"]) == 0
    assert "1.06633" in capsys.readouterr().out


def test_another_language_is_refused(capsys):
    assert main(["period", "--theta0", "1", "--lang", "fr"]) == 2
    assert "--lang = fr: must be en, pt-BR or es" in capsys.readouterr().err


def test_a_spoiled_translation_is_seen():
    assert english("el periodo is infinito") == ["el periodo is infinito"]
    assert english("o movimento --with FILE em 1 s") == []
