"""What `libration.fit` takes beside text files: MATLAB, Parquet, workbooks, data frames, arrays; and what it says of damaged ones."""

import datetime
import importlib

import h5py
import numpy as np
import openpyxl
import pandas
import polars
import pytest
import scipy.io

from libration import DampedPendulum, Friction, fit, fit_together
from libration.measurement._columns import in_python

T = np.linspace(0.0, 12.0, 300)
THETA = DampedPendulum(0.9, length=0.8, gravity=9.81, friction=Friction(linear=0.02)).theta(T) + np.random.default_rng(
    3
).normal(0.0, 0.005, T.size)
OPTIONS = {"length": (0.8, 0.001), "model": "linear"}
NAMED = {"columns": {"time": "run.t", "angle": "run.theta"}, "units": {"angle": "rad"}}


@pytest.fixture(scope="module")
def expected():
    return fit(T, THETA, **OPTIONS).g


def same(found, expected):
    assert found.g.value == pytest.approx(expected.value, rel=1e-9)
    assert found.g.u == pytest.approx(expected.u, rel=1e-6)


def test_matlab(tmp_path, expected):
    path = tmp_path / "swing.mat"
    scipy.io.savemat(path, {"run": {"t": T, "theta": THETA, "note": "words"}, "mass": 0.2})
    same(fit(path, **OPTIONS, **NAMED), expected)
    scipy.io.savemat(path, {"time": T, "theta": THETA})
    same(fit(path, **OPTIONS, units={"angle": "rad"}), expected)
    scipy.io.savemat(path, {"mass": 0.2})
    with pytest.raises(ValueError, match="without a series"):
        fit(path)


def test_matlab_of_version_7_3(tmp_path, expected):
    path = tmp_path / "swing.mat"
    # The mark of MATLAB stands in the 512 bytes before the HDF5 part.
    with h5py.File(path, "w", userblock_size=512) as file:
        file["run/t"], file["run/theta"], file["mass"] = T[None, :], THETA[None, :], 0.2
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(512))
    same(fit(path, **OPTIONS, **NAMED), expected)


def test_parquet(tmp_path, expected):
    path = tmp_path / "swing.parquet"
    pandas.DataFrame({"t [s]": T, "theta [rad]": THETA}).to_parquet(path)
    same(fit(path, **OPTIONS), expected)
    polars.DataFrame({"t [s]": T, "theta [rad]": THETA}).write_parquet(path)
    same(fit(path, **OPTIONS), expected)
    pandas.DataFrame({"time": pandas.to_timedelta(T, unit="s"), "theta [rad]": THETA}).to_parquet(path)
    assert fit(path, **OPTIONS).g.value == pytest.approx(expected.value, rel=1e-6)


def test_workbooks(tmp_path, expected):
    path = tmp_path / "swing.xlsx"
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append(["t [s]", "theta [rad]"])
    for row in zip(T.tolist(), THETA.tolist(), strict=True):
        sheet.append(row)
    book.save(path)
    same(fit(path, **OPTIONS), expected)


@pytest.mark.parametrize("make", [pandas.DataFrame, polars.DataFrame])
def test_frames(make, expected):
    same(fit(make({"t [s]": T, "theta [rad]": THETA}), **OPTIONS), expected)
    moments = [datetime.timedelta(seconds=float(t)) for t in T]
    lasting = make({"time": moments, "theta [rad]": THETA})
    assert fit(lasting, **OPTIONS).g.value == pytest.approx(expected.value, rel=1e-5)


def test_an_index_of_pandas_is_the_time(expected):
    frame = pandas.DataFrame({"theta [rad]": THETA}, index=pandas.Index(T, name="t [s]"))
    same(fit(frame, **OPTIONS), expected)
    same(fit(frame["theta [rad]"], **OPTIONS), expected)
    same(fit(frame.rename_axis(None), **OPTIONS), expected)
    # Rows that were chosen keep their numbers, which are no times.
    whole = pandas.DataFrame({"t [s]": T, "theta [rad]": THETA})
    some = fit(whole[whole["t [s]"] < 10.0], **OPTIONS)
    assert some.window[1] < 10.0


def test_an_array_of_two_columns(expected):
    same(fit(np.column_stack([T, THETA]), **OPTIONS), expected)
    half = len(T) // 2
    both = fit_together([np.column_stack([T, THETA])[:half], (T[half:], THETA[half:])], **OPTIONS)
    assert abs(both.g.value - expected.value) < expected.u


DAMAGED = [
    (b"PAR1 and more", "a Parquet file that cannot be read"),
    (b"MATLAB 5.0 MAT-file" + bytes(200), "a MATLAB file"),
    (b"MATLAB 7.3 MAT-file" + bytes(600), "a MATLAB file of version 7.3 that cannot be read"),
]


@pytest.mark.parametrize(("content", "message"), DAMAGED)
def test_damaged_files(content, message, tmp_path):
    path = tmp_path / "bad.bin"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=message) as refusal:
        fit(path)
    assert "\n" not in str(refusal.value) and "bad.bin" in str(refusal.value)


MESSAGES = [
    ({"columns": {"angle": 4}}, 'columns={"angle": "4"}: is no column; the file has t, theta, phi'),
    ({"columns": {"angle": "c or d"}}, 'columns={"angle": "c or d"}: is no column'),
    ({"columns": {"angle": "theta"}, "units": {"angle": "mile"}}, 'units={"angle": "mile"}: must be rad'),
    ({}, 'which column is the angle? theta, phi; write columns={"angle": "NAME"}'),
]


@pytest.mark.parametrize(("stated", "message"), MESSAGES)
def test_messages_name_the_arguments_of_python(stated, message, tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("t,theta,phi\n0,10,1\n0.1,9,2\n0.2,7,4\n")
    with pytest.raises(ValueError) as refusal:
        fit(path, **stated)
    assert message in str(refusal.value) and "--" not in str(refusal.value)


def test_several_options_in_one_message():
    asked = "what? x; write --column velocity=NAME or --column acceleration=NAME, or both --column x=NAME and --column y=NAME"
    told = 'what? x; write columns={"velocity": "NAME"} or columns={"acceleration": "NAME"}, or both columns={"x": "NAME"} and columns={"y": "NAME"}'
    assert in_python(asked) == told
    assert in_python("write --rate HZ, or --column time=NAME") == 'write rate=HZ, or columns={"time": "NAME"}'


@pytest.mark.parametrize(
    ("content", "package"), [(b"PAR1", "pyarrow"), (b"MATLAB 5.0", "scipy"), (b"MATLAB 7.3", "h5py")]
)
def test_missing_packages_are_named(content, package, tmp_path, monkeypatch):
    path = tmp_path / "swing.bin"
    path.write_bytes(content)
    load = importlib.import_module

    def without(name, *more):
        if name.startswith(package):
            raise ModuleNotFoundError(name=name)
        return load(name, *more)

    monkeypatch.setattr(importlib, "import_module", without)
    with pytest.raises(ValueError, match=rf"needs {package}: pip install 'libration\[files\]'"):
        fit(path)


STATED = [
    ({"length": "0.65 m"}, "length = '0.65 m': must be a number or (value, standard uncertainty)"),
    ({"length": (0.65, 0.002, 1.0)}, "length = (0.65, 0.002, 1.0): must be a number or (value, standard uncertainty)"),
    ({"units": {"angle": "deg"}}, "arrays are in s and rad: np.radians(values)"),
]


@pytest.mark.parametrize(("stated", "message"), STATED)
def test_what_is_stated_of_arrays(stated, message):
    with pytest.raises(ValueError) as refusal:
        fit(np.arange(9.0), np.cos(np.arange(9.0)), **stated)
    assert message in str(refusal.value)
    with pytest.raises(TypeError, match=r"values = 10+[.]+: must be real numbers"):
        fit([0.0, 1.0, 2.0], 10**400)
