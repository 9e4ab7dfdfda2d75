"""A pendulum as a widget of notebooks: the drawing of the lab, whose sliders write to Python.

The drawing is page/widget.js, one module with the core inside, built from lab/ by `make page`; it asks for nothing. Needs anywidget.
"""

from __future__ import annotations

import functools
import importlib
import math
from pathlib import Path
from typing import Any

MODULE = Path(__file__).parents[1] / "page" / "widget.js"
PLAIN, VIEW = "text/plain", "text/html"


def widget_of(pendulum: Any, lang: str) -> Any:
    """The widget, or an error that says in one line what is missing."""
    state = drawn(pendulum)
    try:
        kind = widget_kind()
    except ImportError:
        raise ImportError("Pendulum.widget: needs anywidget: pip install 'libration[widget]'") from None
    if not MODULE.is_file():
        raise FileNotFoundError(
            "Pendulum.widget: the drawing is not part of this installation; a wheel has it, and `make page` in a clone builds it"
        )
    made = kind(**state, lang=lang)
    made._kind = type(pendulum)
    return made


def drawn(pendulum: Any) -> dict[str, float | None]:
    """The traits of a pendulum, or an error for one that the lab does not draw."""
    omega2, length = float(pendulum.omega2), pendulum.length
    if not omega2 > 0.0 or not math.isfinite(omega2):
        raise ValueError(f"omega2 = {omega2}: must be positive for a widget, which hangs from above")
    start = {"theta0": float(pendulum.theta0), "velocity0": float(pendulum.velocity0)}
    if length is None:
        return {**start, "omega0": float(pendulum.omega0)}
    return {**start, "length": float(length), "gravity": float(pendulum.gravity)}


@functools.cache
def widget_kind() -> Any:
    """The class of the widget; made when anywidget is there."""
    kind: Any = importlib.import_module("anywidget").AnyWidget
    traits: Any = importlib.import_module("traitlets")
    number = functools.partial(traits.Float, allow_none=True)

    def drawn_now(self: Any) -> Any:
        """The pendulum that is drawn now."""
        given = {"omega0": self.omega0} if self.length is None else {"length": self.length, "gravity": self.gravity}
        return self._kind(self.theta0, self.velocity0, **given)

    members = {
        "__doc__": "The lab's drawing of a pendulum; its traits follow its sliders.",
        "__module__": __name__,
        "_esm": MODULE,
        "theta0": traits.Float(0.0).tag(sync=True),
        "velocity0": traits.Float(0.0).tag(sync=True),
        "length": number(None).tag(sync=True),
        "gravity": number(None).tag(sync=True),
        "omega0": number(None).tag(sync=True),
        "lang": traits.Unicode("").tag(sync=True),
        "pendulum": property(drawn_now),
    }
    # The base is known only where anywidget is installed, so that type checkers cannot read a class statement.
    return type("PendulumWidget", (kind,), members)


class Shown:
    """What a notebook shows where there is no widget."""

    def __init__(self, html: str) -> None:
        self._html = html

    def _repr_html_(self) -> str:
        return self._html


def shown(pendulum: Any) -> Any:
    """The widget, and where there can be none what is drawn without."""
    try:
        return widget_of(pendulum, "")
    except (ImportError, FileNotFoundError, ValueError):
        return Shown(pendulum._repr_html_())


def bundle(pendulum: Any, options: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """What a notebook is given to choose from: the widget, a drawing that stands still, and a line."""
    found = shown(pendulum)
    made = {} if isinstance(found, Shown) else found._repr_mimebundle_(**options)
    data, metadata = made if isinstance(made, tuple) else (made, {})
    return {**data, PLAIN: repr(pendulum), VIEW: pendulum._repr_html_()}, metadata
