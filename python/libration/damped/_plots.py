"""The pictures of a pendulum with friction and torque, into axes of matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._events import Events

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..plot._animation import Animation


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

    def animate(
        self,
        path: Any = None,
        *,
        t: Any = None,
        fps: float = 25.0,
        speed: float = 1.0,
        form: str | None = None,
        title: str | None = None,
        dpi: float = 100.0,
        lang: str = "en",
    ) -> Animation:
        """A film of the motion over a time: the pendulum beside theta(t). As `Pendulum.animate`, but `t` must be given.

        Parameters
        ----------
        path : str, path or binary file, optional
            Where to save it, as .gif or .mp4; by default nowhere: a notebook shows it.
        t : array_like
            The first and the last instant in s: with friction nothing repeats.
        fps : scalar, default 25.0
            Frames in a second of the film, at most; from 1 to 50. There are 12 to 2000 in all.
        speed : scalar, default 1.0
            Seconds of the motion in a second of the film, above 0.
        form : str, optional
            `gif` or `mp4`; by default the ending of `path`.
        title : str, optional
            The line above; by default it says the state, friction and torque. An empty one leaves it out.
        dpi : scalar, default 100.0
            Dots per inch of a picture of 6.4 by 3.2 inches, from 20 to 1200.
        lang : str, default "en"
            `en`, `pt-BR` or `es`: the language of the labels, with its decimal sign.

        Returns
        -------
        Animation
            The instants of its frames in `times`, the frames by `frames()`; `save` writes it.

        Raises
        ------
        ImportError
            If matplotlib is missing, or PyAV for an MP4.
        ValueError
            If there is no `t`, if there would be too few or too many frames, or an argument is out of range.

        Examples
        --------
        >>> from libration import DampedPendulum, Friction
        >>> film = DampedPendulum(2.0, length=1.0, friction=Friction(linear=0.1)).animate(t=[0.0, 12.0])
        >>> len(film.times)
        300
        """
        from ..plot._animation import film
        from ..plot._damped import damped_headline

        return film(self, damped_headline, path, form, title, lang, t=t, fps=fps, speed=speed, dpi=dpi)
