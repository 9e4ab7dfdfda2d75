"""The three papers by name, and the lists of their figures, claims and errata."""

import difflib
from typing import Any

from . import horsley, lima, salas
from ._claim import Claim
from ._erratum import Erratum
from ._picture import Picture

WORKS = {"salas": salas, "lima": lima, "horsley": horsley}


def chosen(work: str | None) -> tuple[str, ...]:
    """The paper of that name, or all three for None; else a ValueError that names the nearest first."""
    if work is None:
        return tuple(WORKS)
    if work not in WORKS:
        near = difflib.get_close_matches(work.lower(), WORKS, n=3, cutoff=0.0)
        raise ValueError(f"unknown paper {work!r}: must be {near[0]}, {near[1]} or {near[2]}")
    return (work,)


def pictures(work: str | None = None) -> tuple[Picture, ...]:
    """The figures of the three papers, and two more that Horsley 2025 suggests.

    Parameters
    ----------
    work : str, optional
        `salas`, `lima` or `horsley`; by default all three.

    Returns
    -------
    tuple of Picture

    Raises
    ------
    ValueError
        For another name.

    Examples
    --------
    >>> from libration.papers import pictures
    >>> print(*(picture.name for picture in pictures("horsley")))
    horsley-1 horsley-2 horsley-3 horsley-phase-space horsley-ellipse
    """
    return tuple(picture for name in chosen(work) for picture in WORKS[name].PICTURES)


def claims(work: str | None = None) -> tuple[Claim, ...]:
    """The numerical claims of the three papers, each with its measured value.

    Parameters
    ----------
    work : str, optional
        `salas`, `lima` or `horsley`; by default all three.

    Returns
    -------
    tuple of Claim

    Raises
    ------
    ValueError
        For another name.

    Examples
    --------
    >>> from libration.papers import claims
    >>> all(row.stands for row in claims())
    True
    """
    return tuple(row for name in chosen(work) for row in WORKS[name].CLAIMS)


def errata() -> tuple[Erratum[Any], ...]:
    """The errata of the three papers, each with a check that the corrected form passes and the printed form fails.

    Returns
    -------
    tuple of Erratum

    Examples
    --------
    >>> from libration.papers import errata
    >>> all(row.holds(row.corrected_form) and not row.holds(row.printed_form) for row in errata())
    True
    """
    return tuple(row for work in WORKS.values() for row in work.ERRATA)
