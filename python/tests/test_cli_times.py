"""Instants from a text file: which column, which unit, which order."""

import csv

import numpy as np
import pytest

from libration.cli.parser import Refusal, quoted
from libration.cli.times import even_times, file_times


@pytest.fixture
def read(tmp_path):
    """Read instants from a file with this content."""

    def read(content, column=None):
        path = tmp_path / "instants.csv"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        times, name = file_times(str(path), column)
        return times.tolist(), name

    return read


@pytest.mark.parametrize(
    ("content", "column", "expected", "name"),
    [
        ("0\n1\n2", None, [0, 1, 2], "1"),
        ("2\n1\n1\n-3\n", None, [2, 1, 1, -3], "1"),
        ("# a comment\n\n  # another\nt\n0.5\n# inside\n1e-3\n", None, [0.5, 1e-3], "t"),
        ("t [ms]\n250\n1.1\n", None, [0.25, 0.0011], "t [ms]"),
        ("t_min\n1.5\n", None, [90], "t_min"),
        ("time (h)\n0.1\n", None, [360], "time (h)"),
        ("t/s,theta\n1,2\n", None, [1], "t/s"),
        ("theta [rad];t [s]\n9;1\n8;2\n", None, [1, 2], "t [s]"),
        ("x\ty\n1\t2\n", None, [1], "x"),
        ("x\ty\n1\t2\n", "y", [2], "y"),
        ("1,2\n3,4\n", "2", [2, 4], "2"),
        ("0,0\n0,1\n", "1", [0, 0], "1"),
        ("0,0\n0,1.5\n", None, [0, 0], "1"),
        ("0;0\n0;1\n", None, [0, 0], "1"),
        ("a,b\n0,0\n1,1\n", None, [0, 1], "a"),
        ("t_start [s],t_end [ms]\n1,2\n", "t_end", [0.002], "t_end [ms]"),
        ("Time,x\r\n1,2\r\n3,4\r\n", None, [1, 3], "Time"),
        (b"\xef\xbb\xbft [s]\n1\n", None, [1], "t [s]"),
        (b"winkel [\xb0],t\n1,2\n", None, [2], "t"),
        ('"t [s]","a, b"\n"1","x"\n', None, [1], "t [s]"),
        ("t,x\n1,\n2,\n", None, [1, 2], "t"),
        ("x\tt\n\t1\n\t2\n", None, [1, 2], "t"),
        ("0,5;1,5\n-1,25e-1;2\n", None, [0.5, -0.125], "1"),
        ("0,5\t1,5\n", "2", [1.5], "2"),
        ("t [ms];x\n0,5;1,25\n1;2\n", None, [0.0005, 0.001], "t [ms]"),
        ("x;t\n1.5;0,5\n2.5;,75\n", None, [0.5, 0.75], "t"),
        ("# Run 3\nt;x\n1.5;0\n2;0\n", None, [1.5, 2], "t"),
        ("t [sec];x\n1;0\n", None, [1], "t [sec]"),
        ("t (\N{GREEK SMALL LETTER MU}s)\n1\n", None, [1e-6], "t (\N{GREEK SMALL LETTER MU}s)"),
    ],
)
def test_columns(read, content, column, expected, name):
    assert read(content, column) == (expected, name)


@pytest.mark.parametrize(
    ("content", "column", "said"),
    [
        ("", None, "is empty"),
        ("# only\n#comments\n\n", None, "holds no instants: it is empty, but for comments"),
        ("t [s]\n", None, "holds no instants: no row follows the header in line 1"),
        ("# c\nt,x\n1,2\n3\n", None, "line 4 has 1 cells, and the first row has 2"),
        ("t\n1\ntwo\n", None, "line 3 'two' is not a number"),
        ("1.2.3\n", None, "line 1 '1.2.3' is not a number"),
        ("t\n1\n1_0\n", None, "line 3 '1_0' is not a number"),
        ("t,x\n1,2\n,3\n", None, "line 3 has an empty cell"),
        ("t\n1\nnan\n", None, "line 3 'nan' is not finite"),
        ("t\n1e400\n", None, "line 2 '1e400' is not finite"),
        ("t\n0,5\n", None, "line 2 has 2 cells, and the first row has 1; a decimal comma? write a point"),
        ("0,0\n0,1\n", None, "holds only whole numbers and commas: decimal commas? write points; columns? choose one"),
        ("0,5\n-1,25e-1\n", None, "decimal commas?"),
        ("0,0,1,5\n0,1,1,5\n", None, "decimal commas?"),
        ('"0,5"\n"1,5"\n', None, "line 1 '0,5' is not a number; write 0.5"),
        ("t\n\u0663\n", None, "line 2 '\u0663' is not a number"),
        ("\u0663\n1\n", None, "line 1 '\u0663' is not a number"),
        ("1\n\uff15\n", None, "line 2 '\uff15' is not a number"),
        ("\u22121\n1\n", None, "line 1 '\u22121' is not a number"),
        ("theta [rad]\n1\n", None, "column 'theta [rad]' is in 'rad'; times take s, ms, min, h"),
        ("t;x\n0,5;1\n1.5;2\n", None, "has decimal commas and decimal points in one column"),
        ("t;x\n1.234,5;1\n", None, "line 2 '1.234,5' is not a number"),
        (
            "Run 3, May\nt,x\n0,1\n",
            None,
            "lines 1 and 2 are both words: is one a title, or one of units? begin it with #",
        ),
        ("Run 3\n\nt;x\n0;1\n", None, "lines 1 and 3 are both words"),
        ("t;x\ns;cm\n0;1\n", None, "lines 1 and 2 are both words"),
        ("Run 3\nt\n0\n", None, "line 2 't' is not a number; if the line above is a title, begin it with #"),
        ("Run 3\n0,1,2\n", None, "line 2 has 3 cells, and the first row has 1; if the line above is a title"),
        ("Run 3\n0;1\n", None, "line 2 '0;1' is not a number; if the line above is a title"),
        (b"t\n1\x00\n", None, "is not text: byte 3 is 0x00"),
        (b"\x89PNG\r\n\x1a\n\x00", None, "is not text: byte 6 is 0x1a"),
        ("t,x\n1,2\n", "z", "--column = z: is no column of "),
        ("t,x\n1,2\n", "z", "it has 't', 'x'"),
        ("t,t\n1,2\n", "t", "--column = t: names several columns of "),
        ("1,2\n", "t", "has no header; its columns are '1', '2'"),
    ],
)
def test_refusals(read, content, column, said):
    with pytest.raises(Refusal) as caught:
        read(content, column)
    assert said in str(caught.value)


LONG = 500_000


@pytest.mark.parametrize(
    ("content", "column", "expected", "name"),
    [
        # A cell longer than the csv module takes; as many brackets, blanks and quotes as patterns would stumble over.
        ('t,"' + 131_073 * "x" + '"\n1,2\n', None, [1], "t"),
        ('"' + 131_073 * "x" + '",t\n1,2\n', None, [2], "t"),
        ('t,"' + LONG // 2 * '""' + '"\n1,2\n', None, [1], "t"),
        ("t,x" + LONG * "(" + "\n1,2\n", None, [1], "t"),
        ("t,x" + LONG // 2 * "[(" + "\n1,2\n", None, [1], "t"),
        ("t,x" + LONG * " " + "y\n1,2\n", None, [1], "t"),
        ("t,x" + LONG * "_" + "\n1,2\n", None, [1], "t"),
        ("t,x" + LONG // 2 * " /" + "\n1,2\n", None, [1], "t"),
        (LONG * "\n" + "t [ms]\n" + LONG * " \n" + "1\n", None, [0.001], "t [ms]"),
        (LONG * "\r\n" + "t" + LONG * "\r" + "1\r\n2", None, [1, 2], "t"),
    ],
)
def test_time_grows_with_the_length(read, content, column, expected, name):
    """What takes the square of it would take hours."""
    assert read(content, column) == (expected, name)


def test_lines_are_counted_over_blank_ones(read):
    with pytest.raises(Refusal, match=f"line {3 * LONG + 2} 'x' is not a number"):
        read("t\n" + 3 * LONG * "\n" + "x\n")
    with pytest.raises(Refusal, match="holds no instants: it is empty, but for comments"):
        read(100_000_000 * "\n")
    with pytest.raises(Refusal, match="line 2 has 1048577 characters, more than the 1048576 that are read"):
        read("t\n" + (2**20 + 1) * "1")


@pytest.mark.parametrize(
    ("cell", "unit"),
    [
        ("t", 1),
        ("t [ms]", 0.001),
        ("t[ ms ]", 0.001),
        ("t (h)", 3600),
        ("t)", 1),
        ("t / s", 1),
        ("t_start_min", 60),
        ("t_start", 1),
        ("/s", 1),
        ("", 1),
    ],
)
def test_the_unit_of_a_header(read, cell, unit):
    assert read(f"{cell},other\n1,2\n") == ([unit], cell)


def test_what_is_no_unit_of_a_header(read):
    with pytest.raises(Refusal, match=r"column 't \[a\] \[b\]' is in 'a\] \[b'; times take s, ms, min, h"):
        read("t [a] [b],other\n1,2\n")


@pytest.mark.parametrize(
    ("line", "cells"),
    [
        ('"a, b",c', ["a, b", "c"]),
        ('"say ""x""",', ['say "x"', ""]),
        ('"open, to the end', ["open, to the end"]),
        ('"a"b"c",d', ['ab"c"', "d"]),
        ('a"b,"c"', ['a"b', "c"]),
        ('"",""', ["", ""]),
        ('""""', ['"']),
    ],
)
def test_cells_in_quotes_are_those_of_the_csv_module(read, line, cells):
    assert cells == next(csv.reader([line]))
    with pytest.raises(Refusal) as caught:
        read(f"{line}\n", "none of them")
    assert str(caught.value).endswith("it has " + ", ".join(map(quoted, cells)))


COUNT = 200_007


def test_doubles_read_back_bit_equal(read):
    values = np.random.default_rng(1).standard_normal(COUNT) * 10.0 ** np.arange(-300, 300, 600 / COUNT)
    got, _ = read("\n".join(map(repr, values.tolist())))
    assert np.array_equal(np.array(got).view(np.int64), values.view(np.int64))


def test_line_number_far_down(read):
    with pytest.raises(Refusal, match=f"line {COUNT + 3} 'x' is not a number"):
        read("t\n" + "1\n" * (COUNT + 1) + "x\n")


def test_even_times_hold_both_ends():
    assert even_times("1min", "7").tolist() == [0, 10, 20, 30, 40, 50, 60]
    assert len(even_times(None, "1e3")) == 1000
