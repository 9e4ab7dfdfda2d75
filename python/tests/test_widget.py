"""The widget of a pendulum: its traits, and what a notebook shows where there is none. In a real notebook: `make test-widget`."""

import sys
import types

import pytest

from libration import Pendulum
from libration.pendulum import _widget


@pytest.fixture
def without(monkeypatch):
    """A Python without anywidget."""
    _widget.widget_kind.cache_clear()
    monkeypatch.setitem(sys.modules, "anywidget", None)
    yield
    _widget.widget_kind.cache_clear()


@pytest.fixture
def stand_in(monkeypatch, tmp_path):
    """What anywidget and traitlets give, as far as it is used, and a drawing."""

    class Trait:
        def __init__(self, default=None, allow_none=False):
            self.default = default

        def tag(self, sync):
            assert sync
            return self.default

    class AnyWidget:
        def __init__(self, **traits):
            for name, value in traits.items():
                assert hasattr(type(self), name)
                setattr(self, name, value)

        def _repr_mimebundle_(self, **options):
            return {"text/plain": "a widget", "application/vnd.jupyter.widget-view+json": {}}, {"of": "anywidget"}

    drawing = tmp_path / "widget.js"
    drawing.write_text("export default {}")
    monkeypatch.setattr(_widget, "MODULE", drawing)
    monkeypatch.setitem(sys.modules, "anywidget", types.SimpleNamespace(AnyWidget=AnyWidget))
    monkeypatch.setitem(sys.modules, "traitlets", types.SimpleNamespace(Float=Trait, Unicode=Trait))
    _widget.widget_kind.cache_clear()
    yield
    _widget.widget_kind.cache_clear()


def test_without_anywidget_a_notebook_shows_what_stands_still(without):
    pendulum = Pendulum(2.0, length=1.0)
    data, metadata = pendulum._repr_mimebundle_()
    assert data == {"text/plain": repr(pendulum), "text/html": pendulum._repr_html_()}
    assert metadata == {}
    assert pendulum._display_()._repr_html_() == pendulum._repr_html_()
    with pytest.raises(ImportError, match=r"needs anywidget: pip install 'libration\[widget\]'"):
        pendulum.widget()


def test_sliders_are_traits(stand_in):
    widget = Pendulum(2.0, 1.0, length=1.5, gravity=9.8).widget(lang="es")
    assert (widget.theta0, widget.velocity0, widget.length, widget.gravity) == (2.0, 1.0, 1.5, 9.8)
    assert widget.omega0 is None and widget.lang == "es"
    widget.theta0 = 0.25
    assert widget.pendulum == Pendulum(0.25, 1.0, length=1.5, gravity=9.8)
    by_frequency = Pendulum(2.0, omega0=3.0).widget()
    assert by_frequency.length is None and by_frequency.pendulum == Pendulum(2.0, omega0=3.0)


def test_a_notebook_may_choose(stand_in):
    pendulum = Pendulum(2.0, length=1.0)
    data, metadata = pendulum._repr_mimebundle_(include=None)
    assert set(data) == {"text/plain", "text/html", "application/vnd.jupyter.widget-view+json"}
    assert data["text/plain"] == repr(pendulum) and metadata == {"of": "anywidget"}
    assert "theta0" in vars(pendulum._display_())


def test_what_the_lab_does_not_draw_is_refused(stand_in, monkeypatch):
    for given in ({"omega2": -1.0}, {"omega0": 0.0}):
        pendulum = Pendulum(1.0, **given)
        with pytest.raises(ValueError, match="must be positive for a widget"):
            pendulum.widget()
        assert "text/html" in pendulum._repr_mimebundle_()[0]
    monkeypatch.setattr(_widget, "MODULE", _widget.MODULE.with_name("none.js"))
    with pytest.raises(FileNotFoundError, match="make page"):
        Pendulum(1.0).widget()
