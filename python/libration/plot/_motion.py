"""The picture of a pendulum's motion: theta(t) beside another solution, and the phase portrait with the separatrix."""

from __future__ import annotations

from typing import Any

from .._scalars import shown
from ..damped import DampedPendulum
from ..pendulum import Pendulum
from ._angle import draw_angle, headline
from ._damped import damped_headline, draw_damped_angle, draw_damped_portrait
from ._language import Language
from ._portrait import draw_portrait
from ._style import finite, save


def plot_motion(
    pendulum: Pendulum | DampedPendulum,
    t: Any,
    path: Any,
    *,
    form: str | None = None,
    title: str | None = None,
    dpi: float = 100,
    lang: str = "en",
) -> None:
    """Draw theta(t) beside the phase portrait and save the picture.

    Left: the exact angle over the range of `t` with the linear solution and the turning angles, and a dot at each instant
    if they are few. Right: velocity over omega0 against the angle, wrapped to one turn, with the separatrix, the whole
    orbit (thin), the part of it that the range of `t` covers (strong), and orbits of other energies (faint). Into axes of
    your own: `Pendulum.plot` and `Pendulum.plot_phase`.

    Of a `DampedPendulum`, left: the angle, the same motion without friction, the envelope in the mean and the rests; right: the path,
    which spirals.

    Parameters
    ----------
    pendulum : Pendulum or DampedPendulum
        The motion.
    t : array_like
        Instants, s, in any order; at least one.
    path : str, path or binary file
        Where to save.
    form : str, optional
        `png` or `svg`; by default the ending of `path`. The text of an SVG is text.
    title : str, optional
        The line above the picture; by default it says the state, the regime and the period, or friction and torque. An empty one leaves it out.
    dpi : scalar, default 100
        Dots per inch of a PNG of 12 by 5 inches, from 20 to 1200.
    lang : str, default "en"
        `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    ValueError
        If there is no finite instant, or `dpi` or `lang` is none of those; it or an OverflowError if the motion is too
        large for an axis (about 1e150).

    Examples
    --------
    >>> from io import BytesIO
    >>> from libration import Pendulum
    >>> from libration.plot import plot_motion
    >>> picture = BytesIO()
    >>> plot_motion(Pendulum(3.0, length=1.0), [0.0, 10.0], picture, form="png", lang="pt-BR", title="Pêndulo")
    >>> picture.getvalue()[1:4]
    b'PNG'
    """
    if not hasattr(pendulum, "theta0"):
        raise ValueError(f"pendulum = {shown(pendulum)}: must be a Pendulum")
    t, say = finite(t), Language(lang)
    kinds: Any = (headline, draw_angle, draw_portrait)
    if isinstance(pendulum, DampedPendulum):
        kinds = (damped_headline, draw_damped_angle, draw_damped_portrait)
    line, left, right = kinds
    panels = (lambda axes: left(axes, pendulum, t, say)), (lambda axes: right(axes, pendulum, t, say))
    save(path, form, line(pendulum, say) if title is None else title, *panels, dpi=dpi)
