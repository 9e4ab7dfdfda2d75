"""The pictures of a pendulum: into axes of matplotlib, and as a page of a notebook shows it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._crossings import Crossings

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Plots(Crossings):
    """The part of a `Pendulum` that draws it; matplotlib is loaded when it is asked for a plot."""

    __slots__ = ()

    def plot(
        self,
        t: Any = None,
        *,
        ax: Axes | None = None,
        linear: bool = True,
        turning_angle: bool = True,
        lang: str = "en",
        **style: Any,
    ) -> Axes:
        """Draw theta(t), with the linear solution and the turning angles.

        Parameters
        ----------
        t : array_like, optional
            Instants in s: the curve runs from the first to the last. Up to 60 are dots too, but for two, which are the ends.
            By default two periods from t = 0; in rotation two turns.
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        linear : bool, default True
            Whether to draw the linear solution theta0 cos(omega0 t) + velocity0/omega0 sin(omega0 t), where omega2 > 0.
        turning_angle : bool, default True
            Whether to mark the turning angles of a libration, in degrees.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.
        **style : keyword arguments
            How the exact curve looks, as `matplotlib.axes.Axes.plot` takes it: `color`, `lw`, `ls`, `label`, `alpha`.

        Returns
        -------
        Axes
            Those drawn into.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        ValueError
            If no instant is finite, or `ax` or `lang` is none of those.

        Examples
        --------
        >>> from matplotlib.figure import Figure
        >>> from libration import Pendulum
        >>> ax = Figure().subplots()
        >>> for theta0 in (1.0, 3.0):
        ...     ax = Pendulum(theta0, length=1.0).plot([0.0, 8.0], ax=ax, linear=False)
        >>> len(ax.get_legend().get_texts())
        2
        """
        from ..plot._angle import angle_axes

        return angle_axes(self, t, ax, linear=linear, turning=turning_angle, lang=lang, style=style)

    def plot_phase(
        self, ax: Axes | None = None, *, t: Any = None, others: bool = True, lang: str = "en", **style: Any
    ) -> Axes:
        """Draw the phase portrait: velocity/omega0 against the angle, on one turn around the stable equilibrium.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        t : array_like, optional
            Instants in s: the part of the orbit from the first to the last is strong. By default all of it.
        others : bool, default True
            Whether to draw the separatrix and orbits of other energies; of several motions in the same axes, once.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.
        **style : keyword arguments
            How the orbit looks, as `matplotlib.axes.Axes.plot` takes it: `color`, `lw`, `ls`, `label`, `alpha`.

        Returns
        -------
        Axes
            Those drawn into. Without a force the velocity is in rad/s.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        ValueError
            If no instant is finite, or `ax` or `lang` is none of those.

        Examples
        --------
        >>> from matplotlib.figure import Figure
        >>> from libration import Pendulum
        >>> ax = Pendulum(2.0).plot_phase(Figure().subplots(), color="black")
        >>> ax.get_xlabel()
        'θ wrapped to one turn [rad]'
        """
        from ..plot._portrait import phase_axes

        return phase_axes(self, t, ax, others=others, lang=lang, style=style)

    def _repr_html_(self) -> str:
        """What a notebook shows: a drawing, regime and period, and the closed form with its numbers."""
        from ..plot._card import card

        return card(self)
