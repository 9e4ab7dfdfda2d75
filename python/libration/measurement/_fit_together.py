"""`libration.fit_together`: several records of one pendulum, of one g at several lengths, or of a reversible pendulum."""

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

from .. import _core
from .._scalars import real
from ._columns import ARRAYS, FRAME, Given, measure, of_each, stated_of
from ._known import Known, Pair, known_of
from ._progress import told_steps
from ._result import Fit
from ._together import Apart, Together


def fit_together(
    sources: Any,
    *,
    length: Any = None,
    lengths: Sequence[Any] | None = None,
    pivots: Sequence[Any] | None = None,
    between: Any = None,
    gravity: Any = None,
    parts: Sequence[tuple[Any, ...]] = (),
    bob: Any = None,
    wire: float | None = None,
    fluid: Any = "air",
    without: str | Sequence[str] = (),
    model: str = "auto",
    quantity: str = "angle",
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    rate: float | None = None,
    run: int | str | None = None,
    window: tuple[float, float] | None = None,
    scale_u: float = 0.0,
    clock_u: float = 0.0,
    free_scale: bool = False,
    bootstrap: int = 0,
    monte_carlo: int = 0,
    seed: int = 1,
    progress: bool = False,
) -> Together:
    """Fit several records together: runs of one pendulum, one g at several lengths, or a reversible pendulum.

    Runs share omega0, by the mean of their results weighted by their uncertainties. Lengths share g: 1/omega0**2 = (length + c)/g, c
    free where there are three or more. A reversible pendulum's two records share g by Bessel's formula.

    Parameters
    ----------
    sources : sequence
        Each as `fit` takes it: a path, a data frame, an array of shape (n, 2), or (t, values). Or one file whose every run is taken.
    length : scalar or (value, u), optional
        The equivalent length in m, of all; gives g.
    lengths : sequence of scalar or (value, u), optional
        That of each record in their order, in m; they differ.
    pivots : (first, second), optional
        Of a reversible pendulum: the distance of each record's pivot from the centre of mass in m, with its uncertainty.
    between : scalar or (value, u), optional
        The distance between the two pivots in m, in place of the second of `pivots`: it is measured better.
    gravity : scalar or (value, u), optional
        The local g in m/s**2; gives the length.
    parts : sequence of (shape, mass, distance, size), optional
        A rigid pendulum in place of `length`, as in `fit`.
    bob, wire, fluid, without, model, quantity, columns, units, rate : optional
        As in `fit`, for all records.
    run : int or "all", optional
        Which of several runs in each file, from 1; "all" takes every one.
    window, scale_u, clock_u, free_scale, bootstrap, monte_carlo, seed : optional
        As in `fit`, for all records; draws are for records of one pendulum.
    progress : bool, default False
        Whether a bar is shown on the standard error of a terminal while the fits take long.

    Returns
    -------
    Together

    Raises
    ------
    ValueError
        In one line: what, which value or line, and what is allowed.
    OSError
        If a file cannot be read.

    Notes
    -----
    Accuracy: each record as in `fit`; what they share to the last digits. Where they scatter beyond their uncertainties, that of the
    result is widened by Birge's ratio. Errors that all records have in common (one ruler, one clock) do not shrink with their number:
    for runs the calibration is taken so. Source: F. W. Bessel (1828) for the reversible pendulum.

    Examples
    --------
    >>> import libration
    >>> swings = [0.2, 0.6, 1.0, 1.4]
    >>> tables = [(swings, [libration.Pendulum(each, length=l).period for each in swings]) for l in (0.5, 0.8, 1.1)]
    >>> found = libration.fit_together(tables, lengths=[(0.5, 0.001), (0.8, 0.001), (1.1, 0.001)], quantity="swings")
    >>> print(found.g)
    9.807 ± 0.023
    """
    if isinstance(sources, str | bytes) or not hasattr(sources, "__iter__") or hasattr(sources, "columns"):
        sources = [sources]
    stated = stated_of(
        columns,
        units,
        None if rate is None else real("rate", rate),
        run,
        None if length is None else measure("length", length),
    )
    apart = apart_of(lengths, pivots, between)
    sources = list(sources)
    # A track on a short arc needs its own length to be read.
    own = [each[0] for each in apart.lengths or ()] if len(apart.lengths or ()) == len(sources) else []
    reader = [{**stated, "length": each} for each in own] or [stated] * len(sources)
    pairs = zip(sources, reader, strict=True)
    givens = numbered([given for source, each in pairs for given in of_each(source, None, quantity, each)])
    known = known_of(
        length=length,
        gravity=gravity,
        parts=parts,
        bob=bob,
        wire=wire,
        fluid=fluid,
        without=without,
        model=model,
        window=window,
        scale_u=scale_u,
        clock_u=clock_u,
        free_scale=free_scale,
        bootstrap=bootstrap,
        monte_carlo=monte_carlo,
        seed=seed,
    )
    return together_given(givens, known, apart, progress)


def numbered(givens: Sequence[Given]) -> list[Given]:
    """Records that have no file's name, by their number."""
    return [
        given._replace(name=f"record {number}") if given.name in (ARRAYS, FRAME) else given
        for number, given in enumerate(givens, start=1)
    ]


def apart_of(lengths: Any, pivots: Any, between: Any) -> Apart:
    """What is known of each record, as pairs."""
    if lengths is not None and pivots is not None:
        raise ValueError("lengths and pivots: give one of the two")
    if between is not None and pivots is None:
        raise ValueError("between: needs pivots beside it, the distance of the first pivot from the centre of mass")
    each = None if lengths is None else [measure("lengths", given) for given in lengths]
    distances = None if pivots is None else [measure("pivots", given) for given in pivots]
    return Apart(each, distances, None if between is None else measure("between", between))


def together_given(givens: Sequence[Given], known: Known, apart: Apart, progress: bool = False) -> Together:
    """The fit of the columns of several records, with what is known."""
    check(givens, known, apart)
    columns = [(given.kind, given.columns) for given in givens]
    try:
        with told_steps([given.name for given in givens], progress) as told:
            alone = known | {"length": None, "gravity": None, "parts": []} if apart.pivots else known
            found, grades, each = _core.fit_records(columns, apart.lengths, alone, told)
    except ValueError as error:
        raise ValueError(named(str(error), givens)) from None
    fits = [Fit(given, *one) for given, one in zip(givens, each, strict=True)]
    shared = json.loads(found) | {"length_given": bool(known["length"] or known["parts"])}
    if apart.pivots:
        shared, grades = reversible(fits, apart)
    return Together(fits, shared, grades, apart)


def distinct(givens: Sequence[Given]) -> None:
    """Refuse a record that is given twice: its noise would count as that of two."""
    first: dict[tuple[bytes, ...], int] = {}
    for place, given in enumerate(givens):
        before = first.setdefault(tuple(column.tobytes() for column in given.columns), place)
        if before < place:
            raise ValueError(f"{given.name}: holds the record of {givens[before].name} again; give each record once")


def check(givens: Sequence[Given], known: Known, apart: Apart) -> None:
    """Refuse what does not belong together."""
    distinct(givens)
    count = len(givens)
    if count < 2:
        hint = "; run='all' takes every run of a file" if count and givens[0].runs > 1 else ""
        raise ValueError(f"{count} {'record' if count == 1 else 'records'}: together are at least two{hint}")
    others = [name for name in ("length", "gravity", "parts") if known[name]]
    name = "lengths" if apart.lengths is not None else "pivots" if apart.pivots is not None else ""
    if name and others:
        raise ValueError(f"{name} and {others[0]}: give one of the two")
    if apart.lengths is not None and len(apart.lengths) != count:
        raise ValueError(f"lengths: are {len(apart.lengths)} for {count} records; give one for each")
    if apart.lengths is not None and known["monte_carlo"]:
        raise ValueError("monte_carlo: is for records of one pendulum, not for several lengths")
    if apart.pivots is not None:
        wanted = 1 if apart.between is not None else 2
        if count != 2 or len(apart.pivots) not in (wanted, 2):
            raise ValueError(f"pivots: {len(apart.pivots)} with {count} records; a reversible pendulum has two of each")


def named(message: str, givens: Sequence[Given]) -> str:
    """A message of the core with the name of its record."""
    head, colon, rest = message.partition(": ")
    number = head.removeprefix("record ")
    if not colon or not number.isdigit() or not 0 < int(number) <= len(givens):
        return message
    return f"{givens[int(number) - 1].name}: {rest}"


def reversible(fits: Sequence[Fit], apart: Apart) -> tuple[dict[str, Any], list[str]]:
    """What the two records of a reversible pendulum share."""
    assert apart.pivots is not None
    periods = [small_period(each) for each in fits]
    second = apart.between if apart.between is not None else apart.pivots[1]
    found, grades = _core.gravity_of_pivots(periods, [apart.pivots[0], second], apart.between is not None)
    return json.loads(found), grades


def small_period(found: Fit) -> Pair:
    """The period of small swings with its uncertainty."""
    value, u = found.omega0.value, found.omega0.u
    return 2 * math.pi / value, 2 * math.pi / value * u / value
