"""The pictures of a pendulum: into axes of matplotlib, and as a page of a notebook shows it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._crossings import Crossings

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..plot._animation import Animation


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
        """A film of the motion: the pendulum beside theta(t), of one period that repeats without a seam.

        Frame i of N is the motion at i T/N, T being the period (of a rotation the time of one turn); frame N would be frame 0.

        Parameters
        ----------
        path : str, path or binary file, optional
            Where to save it, as .gif or .mp4; by default nowhere: a notebook shows it.
        t : array_like, optional
            The first and the last instant in s, in place of one period; such a film has a seam where it repeats.
        fps : scalar, default 25.0
            Frames in a second of the film, at most; from 1 to 50. There are 12 to 2000 in all.
        speed : scalar, default 1.0
            Seconds of the motion in a second of the film, above 0.
        form : str, optional
            `gif` or `mp4`; by default the ending of `path`.
        title : str, optional
            The line above; by default it says the state, the regime and the period. An empty one leaves it out.
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
            If there is no period and no `t`, at rest, if there would be too few or too many frames, or an argument is out of range.

        Examples
        --------
        >>> from libration import Pendulum
        >>> film = Pendulum(3.0, length=1.0).animate(speed=0.5)
        >>> len(film.times), f"{film.seconds:.3f} s"
        (257, '10.318 s')
        """
        from ..plot._angle import headline
        from ..plot._animation import film

        return film(self, headline, path, form, title, lang, t=t, fps=fps, speed=speed, dpi=dpi)

    def widget(self, lang: str = "") -> Any:
        """The pendulum as a widget of Jupyter, VS Code, Colab and marimo: the lab's drawing, whose sliders write to Python.

        A notebook shows it of itself where anywidget is installed; this gives the widget to keep.

        Parameters
        ----------
        lang : str, default ""
            `en`, `pt-BR` or `es`; by default the first of them that the browser asks for.

        Returns
        -------
        anywidget.AnyWidget
            Its traits `theta0`, `velocity0`, and `length` with `gravity` or `omega0`, follow the sliders, and the drawing follows
            them; `observe` tells of changes. `pendulum` is the Pendulum that is drawn now.

        Raises
        ------
        ImportError
            If anywidget is missing: ``pip install 'libration[widget]'``.
        FileNotFoundError
            If the drawing is not part of the installation, as in a clone before ``make page``.
        ValueError
            If omega2 is not positive.

        Examples
        --------
        >>> from libration import Pendulum
        >>> try:
        ...     widget = Pendulum(2.0, omega2=-1.0).widget()
        ... except ValueError as error:
        ...     print(error)
        omega2 = -1.0: must be positive for a widget, which hangs from above
        """
        from ._widget import widget_of

        return widget_of(self, lang)

    def _repr_mimebundle_(self, **options: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """What a notebook shows: the widget where anywidget is installed, else `_repr_html_`."""
        from ._widget import bundle

        return bundle(self, options)

    def _display_(self) -> Any:
        """What marimo shows."""
        from ._widget import shown

        return shown(self)

    def _repr_html_(self) -> str:
        """What a notebook shows: a drawing, regime and period, and the closed form with its numbers."""
        from ..plot._card import card

        return card(self)
