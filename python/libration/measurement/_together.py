"""What `libration.fit_together` hands out: the records, what they share, verdicts, a text, a picture and a page."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ._estimate import Estimate, estimate
from ._known import Pair
from ._result import Fit

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Apart(NamedTuple):
    """What is known of each record for itself: lengths, or distances of the pivots from the centre of mass."""

    lengths: list[Pair] | None = None
    pivots: list[Pair] | None = None
    between: Pair | None = None


class Together:
    """The result of `libration.fit_together`, which prints itself.

    It is made by `libration.fit_together`, not by hand.

    Parameters
    ----------
    fits : sequence of Fit
        The records, each for itself.
    found : dict
        What they share.
    grades : sequence of str
        Of the verdicts.
    apart : object
        What is known of each record for itself.

    Notes
    -----
    Uncertainties are standard ones, k = 1, after JCGM 100:2008.

    Examples
    --------
    >>> import libration
    >>> first = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
    >>> second = [0.3, 0.7, 1.1, 1.5], [2.0181, 2.0683, 2.1684, 2.3321]
    >>> print(libration.fit_together([first, second], quantity="swings", length=(1.0, 0.001)).g)
    9.809 ± 0.010
    """

    __slots__ = ("_apart", "_fits", "_found", "_grades")

    def __init__(self, fits: Sequence[Fit], found: Mapping[str, Any], grades: Sequence[str], apart: Apart) -> None:
        self._fits = tuple(fits)
        self._found = dict(found)
        self._grades = tuple(grades)
        self._apart = apart

    @property
    def kind(self) -> str:
        """What the records share, without error: "runs" of one pendulum, "lengths", or "reversible"."""
        return "lengths" if self._apart.lengths else "reversible" if self._apart.pivots else "runs"

    @property
    def fits(self) -> tuple[Fit, ...]:
        """The records, each for itself."""
        return self._fits

    @property
    def omega0(self) -> Estimate | None:
        """Angular frequency of small swings in rad/s, where all records are of one pendulum."""
        return estimate(self._found.get("omega0"))

    @property
    def g(self) -> Estimate | None:
        """g in m/s**2; None where nothing gave it."""
        return estimate(self._found.get("g"))

    @property
    def length(self) -> Estimate | None:
        """The equivalent length in m, where all records are of one pendulum and g was given."""
        return estimate(self._found.get("length"))

    @property
    def length_offset(self) -> Estimate | None:
        """What must be added to every stated length, in m, where three lengths or more were given."""
        return estimate(self._found.get("length_offset"))

    @property
    def chi_squared(self) -> tuple[float, int] | None:
        """Sum of squares of the deviations over their uncertainties, with its degrees of freedom, without error."""
        found = self._found.get("chi_squared")
        return None if found is None else (float(found[0]), int(found[1]))

    @property
    def verdicts(self) -> list[str]:
        """What speaks against the result: of the records together, and of those whose own result does not stand."""
        return [sentence for _, sentence in self._told()]

    @property
    def stands(self) -> bool:
        """Whether no verdict, of all of them or of one record, forbids to quote the result."""
        return "refuted" not in self._grades and all(each.stands for each in self._fits)

    def _told(self) -> list[tuple[str, str]]:
        """Grades and sentences, the gravest first."""
        fallen = [("refuted", f"{each._given.name}: {each.verdicts[0]}") for each in self._fits if not each.stands]
        return fallen + list(zip(self._grades, map(str, self._found["verdicts"]), strict=True))

    def to_dict(self) -> dict[str, Any]:
        """All of it as plain numbers, texts and lists, which JSON takes.

        Returns
        -------
        dict
            `kind`, `omega0`, `g`, `length`, `length_offset`, `lengths`, `pivots`, `between`, `chi_squared`, `budget`,
            `corrections`, `monte_carlo`, `verdicts`, `grades`, `stands`, and `records`, each as `Fit.to_dict`.

        Examples
        --------
        >>> import libration
        >>> first = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
        >>> second = [0.3, 0.7, 1.1, 1.5], [2.0181, 2.0683, 2.1684, 2.3321]
        >>> libration.fit_together([first, second], quantity="swings").to_dict()["kind"]
        'runs'
        """
        names = ("omega0", "g", "length", "length_offset", "chi_squared", "budget", "corrections", "monte_carlo")
        shared = {name: self._found.get(name) for name in names}
        apart = {
            name: each and [list(pair) for pair in each]
            for name, each in self._apart._asdict().items()
            if name != "between"
        }
        between = self._apart.between and list(self._apart.between)
        told = {"verdicts": self.verdicts, "grades": [grade for grade, _ in self._told()], "stands": self.stands}
        records = [each.to_dict() for each in self._fits]
        return {"kind": self.kind} | shared | apart | {"between": between} | told | {"records": records}

    def plot(
        self,
        path: Any = None,
        *,
        ax: Any = None,
        form: str | None = None,
        title: str | None = None,
        dpi: float = 100,
        lang: str = "en",
    ) -> "Axes | None":
        """What the records share: omega0 of each with its uncertainty, or 1/omega0**2 against the length with the fitted line.

        Parameters
        ----------
        path : path or binary file, optional
            Where the picture is saved, as PNG or SVG; without it axes are drawn.
        ax : matplotlib Axes, optional
            Where it is drawn; by default a new figure.
        form : {"png", "svg"}, optional
            By default the ending of the path.
        title : str, optional
            The line above, instead of the result; '' for none.
        dpi : scalar, default 100
            Dots per inch of a PNG, 20 to 1200.
        lang : {"en", "pt-BR", "es"}
            Language and decimal sign.

        Returns
        -------
        matplotlib Axes or None
            The axes that were drawn into; None where a file was saved.

        Raises
        ------
        ImportError
            Without matplotlib.
        ValueError
            In one line: the argument, its value and what is allowed.

        Examples
        --------
        >>> from io import BytesIO
        >>> import libration
        >>> first = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
        >>> second = [0.3, 0.7, 1.1, 1.5], [2.0181, 2.0683, 2.1684, 2.3321]
        >>> picture = BytesIO()
        >>> libration.fit_together([first, second], quantity="swings").plot(picture, form="png")
        """
        from ..plot._together import plot_together, together_axes

        if path is None:
            return together_axes(self, ax, lang)
        plot_together(self, path, form=form, title=title, dpi=dpi, lang=lang)
        return None

    def report(self, lang: str = "en") -> str:
        """One HTML page that needs no other file: what the records share, its budget, the sentence to quote, and each record.

        Parameters
        ----------
        lang : {"en", "pt-BR", "es"}
            Language and decimal sign.

        Returns
        -------
        str

        Raises
        ------
        ImportError
            Without matplotlib.

        Examples
        --------
        >>> import libration
        >>> first = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
        >>> second = [0.3, 0.7, 1.1, 1.5], [2.0181, 2.0683, 2.1684, 2.3321]
        >>> libration.fit_together([first, second], quantity="swings").report()[:15]
        '<!doctype html>'
        """
        from ._report import page_together

        return page_together(self, lang)

    def sentence(self) -> str:
        """The result as a report quotes it, with its uncertainty and how it was found; why not, where it does not stand.

        Returns
        -------
        str

        Examples
        --------
        >>> import libration
        >>> first = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
        >>> second = [0.3, 0.7, 1.1, 1.5], [2.0181, 2.0683, 2.1684, 2.3321]
        >>> libration.fit_together([first, second], quantity="swings").sentence()[:7]
        'omega0 '
        """
        from ._together_text import sentence

        return sentence(self)

    def __str__(self) -> str:
        from ._together_text import text

        return text(self)

    def __repr__(self) -> str:
        return f"<Together of {len(self._fits)} records: {self.kind}>"

    def __dir__(self) -> list[str]:
        return [name for name in object.__dir__(self) if not name.startswith("_")]
