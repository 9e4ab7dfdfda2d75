"""Motions as tables: of the library that is asked for, that t is of, or that is there; the digits are those of the methods."""

import subprocess
import sys

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
from bits import same

from libration import CubicQuintic, DampedPendulum, Duffing, Friction, Pendulum

T = np.array([0.0, 0.7, -3.0, 1e9, np.nan])
MOTIONS = [
    (Pendulum(3.0, length=1.0), {"t": "s", "theta": "rad", "velocity": "rad/s"}),
    (
        DampedPendulum(2.0, friction=Friction(linear=0.1)),
        {"t": "s", "theta": "rad", "velocity": "rad/s", "energy": "rad**2/s**2"},
    ),
    (Duffing(1.0, p=1.0, q=1.0), {"t": "s", "u": None, "velocity": None}),
    (CubicQuintic(1.0, p=1.0, q=0.5, s=0.1), {"t": "s", "u": None, "velocity": None}),
]
IDS = [type(motion).__name__ for motion, _ in MOTIONS]


@pytest.mark.parametrize(("motion", "units"), MOTIONS, ids=IDS)
@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_columns_are_the_methods(motion, units, library):
    times = T[:3] if isinstance(motion, DampedPendulum) else T
    frame = motion.to_dataframe(times, library)
    assert type(frame).__module__.partition(".")[0] in (library, "pyarrow")
    names = list(frame.column_names if library == "pyarrow" else frame.columns)
    assert names == list(units)
    for name in names:
        column = np.asarray(frame[name])
        assert same(column, times if name == "t" else np.asarray(getattr(motion, name)(times))), name
    told = {name: unit for name, unit in units.items() if unit}
    if library == "pandas":
        assert frame.attrs["units"] == told
    if library == "pyarrow":
        metadata = {field.name: field.metadata[b"units"].decode() for field in frame.schema if field.metadata}
        assert metadata == told


def test_the_library_of_t_is_taken():
    pendulum = Pendulum(1.0)
    index = pd.Index(["a", "b"], name="shot")
    frame = pendulum.to_dataframe(pd.Series([1.0, 2.0], index=index))
    assert isinstance(frame, pd.DataFrame) and frame.index.equals(index)
    assert isinstance(pendulum.to_dataframe(pl.Series([1.0, 2.0])), pl.DataFrame)
    assert isinstance(pendulum.to_dataframe(pa.array([1.0, 2.0])), pa.Table)
    assert same(frame["theta"].to_numpy(), pendulum.theta(np.array([1.0, 2.0])))


@pytest.mark.parametrize(
    ("hidden", "imported", "kind"),
    [
        ((), "", "pandas"),
        ((), "polars", "polars"),
        (("pandas",), "", "polars"),
        (("pandas", "polars"), "", "pyarrow"),
    ],
)
def test_whichever_is_there(hidden, imported, kind):
    code = f"""if True:
        import sys

        class Hidden:
            def find_spec(self, name, *_):
                if name in {hidden!r}:
                    raise ModuleNotFoundError(name, name=name)

        sys.meta_path.insert(0, Hidden())
        {f"import {imported}" if imported else ""}
        from libration import Pendulum
        print(type(Pendulum(1.0).to_dataframe([0.0, 1.0])).__module__.partition(".")[0])
    """
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.strip() == kind, done.stderr


def test_none_there_is_one_line(monkeypatch):
    for name in ("pandas", "polars", "pyarrow"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ImportError, match=r"^a table needs pandas, polars or pyarrow: pip install pandas$"):
        Pendulum(1.0).to_dataframe([0.0])
    with pytest.raises(ImportError, match=r"^a table of polars needs it: pip install polars$"):
        Pendulum(1.0).to_dataframe([0.0], "polars")


@pytest.mark.parametrize(
    ("t", "words", "kind", "said"),
    [
        (1.0, {}, ValueError, "t of 0 dimensions: must have one, a row an instant; write np.ravel(t)"),
        (np.zeros((2, 2)), {}, ValueError, "t of 2 dimensions: must have one"),
        (["a"], {}, TypeError, "t = ['a']: must be real numbers"),
        (
            np.array(["2026-01-01"], dtype="M8[s]"),
            {},
            TypeError,
            "t = an array of shape (1,): must be real numbers; write (t - t[0])",
        ),
        ([1.0], {"library": "excel"}, ValueError, "library = 'excel': must be pandas, polars or pyarrow"),
    ],
)
def test_refusals(t, words, kind, said):
    with pytest.raises(kind) as refused:
        Pendulum(1.0).to_dataframe(t, **words)
    assert str(refused.value).startswith(said)
