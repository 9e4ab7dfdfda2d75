"""The pictures of a pendulum with friction and torque, into axes of matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._events import Events

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Plots(Events):
    """The part of a `DampedPendulum` that draws it; matplotlib is loaded when it is asked for a plot."""

    __slots__ = ()

    def plot(
        self,
        t: Any = None,
        *,
        ax: Axes | None = None,
        undamped: bool = True,
        envelope: bool = True,
        lang: str = "en",
        **style: Any,
    ) -> Axes:
        """Draw theta(t), with the motion without friction, the envelope in the mean, and the rests.

        Parameters
        ----------
        t : array_like, optional
            Instants in s: the curve runs from the first to the last, as far as the motion gets. Up to 60 are dots too, but for two,
            which are the ends. By default ten periods of small swings from t = 0.
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        undamped : bool, default True
            Whether to draw the same motion without friction; where there is a torque, and over more than 12 swings, it is not drawn.
        envelope : bool, default True
            Whether to draw `libration.damped.averaged_turning_angle` from the first turn on; where there is a torque, and where
            friction drives, it is not drawn.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.
        **style : keyword arguments
            How the curve looks, as `matplotlib.axes.Axes.plot` takes it: `color`, `lw`, `ls`, `label`, `alpha`.

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
        >>> from libration import DampedPendulum, Friction
        >>> ax = DampedPendulum(2.0, friction=Friction(dry=0.05)).plot(ax=Figure().subplots())
        >>> [text.get_text() for text in ax.get_legend().get_texts()][1:]
        ['without friction', 'envelope in the mean', 'held by dry friction']
        """
        from ..plot._damped import damped_angle_axes

        return damped_angle_axes(self, t, ax, undamped=undamped, envelope=envelope, lang=lang, style=style)

    def plot_phase(
        self, ax: Axes | None = None, *, t: Any = None, others: bool = True, lang: str = "en", **style: Any
    ) -> Axes:
        """Draw the phase portrait, which spirals: velocity/omega0 against the angle, on one turn around the stable equilibrium.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        t : array_like, optional
            Instants in s: the path runs from the first to the last. By default ten periods of small swings from t = 0.
        others : bool, default True
            Whether to draw the separatrix and orbits of other energies, without friction; of several motions in the same axes, once.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.
        **style : keyword arguments
            How the path looks, as `matplotlib.axes.Axes.plot` takes it: `color`, `lw`, `ls`, `label`, `alpha`.

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
        >>> from libration import DampedPendulum, Friction
        >>> ax = DampedPendulum(2.0, friction=Friction(linear=0.05)).plot_phase(Figure().subplots())
        >>> ax.get_xlabel()
        'θ wrapped to one turn [rad]'
        """
        from ..plot._damped import damped_phase_axes

        return damped_phase_axes(self, t, ax, others=others, lang=lang, style=style)

    def plot_energy(self, t: Any = None, *, ax: Axes | None = None, lang: str = "en", **style: Any) -> Axes:
        """Draw the energy per unit inertia over time, and that of the separatrix where it is in the picture.

        Parameters
        ----------
        t : array_like, optional
            Instants in s: the curve runs from the first to the last. By default ten periods of small swings from t = 0.
        ax : Axes, optional
            Where to draw; by default a new figure. Axes that are given keep their look, and no setting is changed.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.
        **style : keyword arguments
            How the curve looks, as `matplotlib.axes.Axes.plot` takes it: `color`, `lw`, `ls`, `label`, `alpha`.

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
        >>> from libration import DampedPendulum, Friction
        >>> ax = DampedPendulum(0.0, 2.5, friction=Friction(linear=0.05)).plot_energy(ax=Figure().subplots())
        >>> ax.get_ylabel()
        'energy per unit inertia [rad²/s²]'
        """
        from ..plot._damped import damped_energy_axes

        return damped_energy_axes(self, t, ax, lang=lang, style=style)
