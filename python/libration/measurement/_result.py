"""What a fit hands out: numbers with uncertainties, verdicts in words, a text, a picture and a page."""

import json
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._columns import Given
from ._estimate import Estimate, estimate
from ._text import text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FRICTION = ("linear", "quadratic", "dry", "presliding")
# Rows of one reason that are listed.
LISTED = 100


class Fit:
    """The result of `libration.fit`, which prints itself.

    It is made by `libration.fit`, not by hand.

    Parameters
    ----------
    given : object
        What was fitted.
    found : str
        The result, as the core writes it.
    grades : sequence of str
        Of the verdicts.
    residuals : sequence of ndarray
        Times, values and residuals.

    Notes
    -----
    Uncertainties are standard ones, k = 1, after JCGM 100:2008.

    Examples
    --------
    >>> import libration
    >>> swings, periods = [0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847]
    >>> found = libration.fit(swings, periods, quantity="swings", length=(1.0, 0.001))
    >>> print(found.g)
    9.808 ± 0.010
    """

    __slots__ = ("_found", "_given", "_grades", "_residuals")

    def __init__(self, given: Given, found: str, grades: Sequence[str], residuals: Sequence[np.ndarray]) -> None:
        self._given = given
        self._found: dict[str, Any] = json.loads(found)
        self._grades = tuple(grades)
        self._residuals = tuple(residuals)

    @property
    def model(self) -> str:
        """The friction model: none, linear, quadratic, dry or presliding, without error."""
        return str(self._found["model"])

    @property
    def omega0(self) -> Estimate:
        """Angular frequency of small swings in rad/s."""
        return required(self._found["omega0"])

    @property
    def g(self) -> Estimate | None:
        """g in m/s**2; None where neither length nor gravity was given."""
        return estimate(self._found["g"])

    @property
    def length(self) -> Estimate | None:
        """The equivalent length in m; None where neither length nor gravity was given."""
        return estimate(self._found["length"])

    @property
    def offset(self) -> Estimate | None:
        """Where the record rests, in rad; None for periods."""
        return estimate(self._found["offset"])

    @property
    def scale(self) -> Estimate | None:
        """Measured angle over angle where it was fitted, for accelerations the sensor's distance from the pivot in m; else None."""
        return estimate(self._found["scale"])

    @property
    def friction(self) -> dict[str, Estimate]:
        """The friction terms of the model by name: linear in 1/s, quadratic in 1/rad, dry in rad/s**2, presliding in rad."""
        terms = {name: estimate(self._found["friction"][name]) for name in FRICTION}
        return {name: each for name, each in terms.items() if each is not None}

    @property
    def rms(self) -> float:
        """Root mean square residual in the unit of the record: rad, rad/s, m/s**2, or s for periods."""
        return float(self._found["rms"])

    @property
    def swing(self) -> float:
        """The largest turning angle that was fitted, in rad."""
        return math.nan if self._found["swing"] is None else float(self._found["swing"])

    @property
    def window(self) -> tuple[float, float]:
        """First and last time that were fitted, in s."""
        first, last = self._found["window"]
        return float(first), float(last)

    @property
    def verdicts(self) -> list[str]:
        """What a person with experience would say of record and fit, the gravest first."""
        return [str(each) for each in self._found["verdicts"]]

    @property
    def stands(self) -> bool:
        """Whether no verdict forbids to quote the result."""
        return "refuted" not in self._grades

    @property
    def understood(self) -> list[str]:
        """What the reader made of the file, a sentence for each guess."""
        return list(self._given.understood)

    @property
    def dropped(self) -> list[dict[str, Any]]:
        """What was left out: reason, how many, and the lines of the file or the rows from 0, the first hundred."""
        found = [{key: each[key] for key in ("reason", "count", "lines")} for each in self._given.dropped]
        reasons: dict[str, list[int]] = {}
        for each in self._found["dropped"]:
            reasons.setdefault(each["reason"].partition(":")[0], []).append(each["row"])
        found += [{"reason": reason, "count": len(rows), "rows": rows[:LISTED]} for reason, rows in reasons.items()]
        return found

    @property
    def t(self) -> np.ndarray:
        """Times of the samples that were fitted, in s, shape (n,); empty for a table of swings."""
        return self._residuals[0]

    @property
    def measured(self) -> np.ndarray:
        """The values that were fitted, shape (n,)."""
        return self._residuals[1]

    @property
    def residuals(self) -> np.ndarray:
        """Measured less fitted, shape (n,)."""
        return self._residuals[2]

    def motion(self) -> Any:
        """The fitted pendulum.

        Returns
        -------
        DampedPendulum
            Its time 0 is `state_time`; its angle is counted from the rest.

        Examples
        --------
        >>> import libration
        >>> found = libration.fit([0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847], quantity="swings")
        >>> round(found.motion().omega0, 3)
        3.132
        """
        from ..damped import DampedPendulum, Friction

        theta, velocity, _ = self._found["state"]
        terms = {name: each.value for name, each in self.friction.items()}
        return DampedPendulum(theta, velocity, omega0=self.omega0.value, friction=Friction(**terms))

    @property
    def state_time(self) -> float:
        """The time of the record, in s, at which `motion` begins."""
        return float(self._found["state"][2])

    def to_dict(self) -> dict[str, Any]:
        """All of it as plain numbers, texts and lists, which JSON takes.

        Returns
        -------
        dict
            `model`, `rms`, `rms_deg`, `omega0`, `g`, `length`, `offset`, `offset_deg`, `scale`, `friction`, `swing`, `verdicts`,
            `grades`, `stands`, `understood`, `dropped`, `window`, `window_reason`, `samples`, `ladder`, `correlation`, `budget`,
            `diagnostics`, `state`. An estimate has `value`, `u`, `expanded`, `statistical`, `model` and `calibration`.

        Examples
        --------
        >>> import libration
        >>> found = libration.fit([0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847], quantity="swings")
        >>> found.to_dict()["samples"]
        4
        """
        head = {"source": self._given.name, "kind": self._given.kind}
        found = {name: each for name, each in self._found.items() if name not in ("residuals", "length_given")}
        told = {"grades": list(self._grades), "stands": self.stands, "understood": self.understood}
        return head | found | told | {"dropped": self.dropped}

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
        """The data with the fitted curve, and the residuals below.

        Parameters
        ----------
        path : path or binary file, optional
            Where the picture is saved, as PNG or SVG; without it axes are drawn.
        ax : matplotlib Axes, optional
            Where the data and the curve are drawn, without residuals; by default a new figure.
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
        >>> found = libration.fit([0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847], quantity="swings")
        >>> picture = BytesIO()
        >>> found.plot(picture, form="png")
        """
        from ..plot._fit import fit_axes, plot_fit

        if path is None:
            return fit_axes(self, ax, lang)
        plot_fit(self, path, form=form, title=title, dpi=dpi, lang=lang)
        return None

    def report(self, lang: str = "en") -> str:
        """One HTML page that needs no other file: data with the curve, residuals, period against swing, budget, the sentence to quote.

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
        ValueError
            For another language.

        Examples
        --------
        >>> import libration
        >>> found = libration.fit([0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847], quantity="swings")
        >>> found.report()[:15]
        '<!doctype html>'
        """
        from ._report import page

        return page(self, lang)

    def sentence(self) -> str:
        """The result as a report quotes it, with its uncertainty and how it was found; why not, where it does not stand.

        Returns
        -------
        str

        Examples
        --------
        >>> import libration
        >>> found = libration.fit([0.2, 0.6, 1.0, 1.4], [2.0112, 2.0521, 2.1387, 2.2847], quantity="swings")
        >>> found.sentence()[:7]
        'omega0 '
        """
        from ._text import sentence

        return sentence(self)

    def __str__(self) -> str:
        return text(self)

    def __repr__(self) -> str:
        return f"<Fit of {self._given.name}: {self.model}, omega0 = {self.omega0} rad/s>"

    def __dir__(self) -> list[str]:
        return [name for name in object.__dir__(self) if not name.startswith("_")]


def required(found: Any) -> Estimate:
    """An estimate that every result has."""
    made = estimate(found)
    assert made is not None
    return made
